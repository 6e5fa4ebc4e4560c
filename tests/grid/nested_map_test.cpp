// However a cube is divided into cells, its map leads every voxel to its own; and the map's bit operations,
// compared with strings of binary digits.
#include "libgrid/bits.h"
#include "libgrid/grid/merge_passes.h"
#include "libscene/passes/host_executor.h"
#include "tests/random_test.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace masu {
namespace {

using NestedMap = RandomTest;

bool holds(const VoxelBox& box, const Vec3i& voxel) {
  return voxel.x >= box.first.x && voxel.x < box.end.x && voxel.y >= box.first.y && voxel.y < box.end.y &&
         voxel.z >= box.first.z && voxel.z < box.end.z;
}

// Cuts the box at random planes, now and then.
void divide(Chance& chance, const VoxelBox& box, int max_cuts, std::vector<VoxelBox>& cells) {
  const int axis = chance.whole(0, 2);
  const std::int32_t side = box.end[axis] - box.first[axis];
  if (max_cuts == 0 || side < 2 || chance.one_in(8)) {
    cells.push_back(box);
    return;
  }
  // Anywhere, or at its first or last voxel.
  const std::int32_t at =
      box.first[axis] + chance.one_of({chance.whole(1, side - 1), std::int32_t{1}, side - 1});
  VoxelBox below = box, above = box;
  below.end.set(axis, at);
  above.first.set(axis, at);
  divide(chance, below, max_cuts - 1, cells);
  divide(chance, above, max_cuts - 1, cells);
}

// Follows the map as grid.h says, and counts each word that it comes by.
class Follower {
public:
  Follower(const HostArray<std::uint32_t>& words, std::size_t own) : words_(words), met_(words.size(), 0) {
    std::fill_n(met_.begin(), own, 1);
  }

  void follow(std::uint32_t word, const VoxelBox& cube, const std::vector<VoxelBox>& cells) {
    if ((word & occupied_bit) != 0) {
      ASSERT_LT(word & ~occupied_bit, cells.size());
      const VoxelBox& box = cells[word & ~occupied_bit];
      ASSERT_TRUE(holds(box, cube.first) && holds(box, cube.end - Vec3i{1, 1, 1}));
      return;
    }
    const MapDivision division = map_division(word);
    const Vec3i n = division.log2, w = cube.end - cube.first;
    const Vec3i side{w.x >> n.x, w.y >> n.y, w.z >> n.z};
    ASSERT_GT(n.x + n.y + n.z, 0);
    ASSERT_TRUE(side.x >= 1 && side.y >= 1 && side.z >= 1);
    std::size_t place = division.offset;
    for_each_voxel({{0, 0, 0}, {(1 << n.x) - 1, (1 << n.y) - 1, (1 << n.z) - 1}}, [&](const Vec3i& part) {
      ASSERT_LT(place, words_.size());
      ++met_[place];
      const Vec3i first = cube.first + part * side;
      follow(words_[place++], {first, first + side}, cells);
    });
  }
  // Words that fill up a unit are not come by.
  bool met_none_twice() const {
    return std::all_of(met_.begin(), met_.end(), [](int times) { return times <= 1; });
  }

private:
  const HostArray<std::uint32_t>& words_;
  std::vector<int> met_;
};

// The map of a division of 4³ cubes, of which only this one holds something: those cells.
HostArray<std::uint32_t> map_of(const std::vector<VoxelBox>& cells, const Vec3i& cube, std::int32_t log2) {
  SerialExecutor executor;
  ExecutorStructure<SerialExecutor> grid{{}, StructureKind::irregular, 0, log2};
  for (const VoxelBox& cell : cells)
    grid.cells.push_back(packed(cell, empty_list));
  const LeafCounts starts{0, 0}, leaves{static_cast<std::uint32_t>(cells.size()), 0};
  const HostArray<std::uint32_t> indices{static_cast<std::uint32_t>(linear_index(cube, {4, 4, 4}))};
  write_nested_maps(executor, {4, 4, 4}, {0, 64, nullptr, nullptr, 0}, indices, &starts, &leaves,
                    StructureOptions{}.max_map_words, grid);
  EXPECT_EQ(grid.exceeded, nullptr);
  return std::move(grid.voxel_map);
}

TEST_F(NestedMap, LeadsEveryVoxelOfARandomPartitionToItsCell) {
  for (std::int64_t i = cases(1000); i > 0; --i) {
    const std::int32_t log2 = chance_.whole(0, 5), side = 1 << log2;
    const Vec3i cube{chance_.whole(0, 3), chance_.whole(0, 3), chance_.whole(0, 3)};
    const Vec3i first{cube.x << log2, cube.y << log2, cube.z << log2};
    const VoxelBox whole{first, first + Vec3i{side, side, side}};
    std::vector<VoxelBox> cells;
    divide(chance_, whole, chance_.whole(0, 9), cells);
    std::shuffle(cells.begin(), cells.end(), chance_.engine());

    const HostArray<std::uint32_t> words = map_of(cells, cube, log2);
    Follower follower(words, 64);
    follower.follow(words[linear_index(cube, {4, 4, 4})], whole, cells);
    if (testing::Test::HasFatalFailure()) return;
    ASSERT_TRUE(follower.met_none_twice());

    const Vec3i division{4 * side, 4 * side, 4 * side};
    const MergedGridView<float> view{words.data(), nullptr,  nullptr,   {0, 0, 0}, {1, 1, 1},
                                     {1, 1, 1},    division, {4, 4, 4}, log2};
    for_each_voxel({whole.first, whole.end - Vec3i{1, 1, 1}}, [&](const Vec3i& voxel) {
      const std::uint32_t cell = cell_number(view, voxel);
      ASSERT_TRUE(cell < cells.size() && holds(cells[cell], voxel))
          << voxel.x << ' ' << voxel.y << ' ' << voxel.z;
    });
    if (testing::Test::HasFatalFailure()) return;
  }
}

// One cell takes no words, and a cell for each voxel about one a voxel.
TEST_F(NestedMap, TakesFewWords) {
  EXPECT_EQ(map_of({{{0, 0, 0}, {16, 16, 16}}}, {0, 0, 0}, 4).size(), 64U);
  std::vector<VoxelBox> voxels;
  for_each_voxel({{0, 0, 0}, {15, 15, 15}}, [&](const Vec3i& voxel) {
    voxels.push_back({voxel, voxel + Vec3i{1, 1, 1}});
  });
  EXPECT_LE(map_of(voxels, {0, 0, 0}, 4).size(), 64 + 16U * 16 * 16 * 8 / 7 + 1);
}

using Bits = RandomTest;

std::string binary(std::uint32_t word) {
  std::string all;
  for (int bit = 31; bit >= 0; --bit)
    all += (word >> bit & 1) != 0 ? '1' : '0';
  return all;
}

TEST_F(Bits, AppendedTakesTheTopBitsAndMovedToTopTheLowest) {
  auto engine = seed_.engine();
  for (int i = 0; i < 10'000; ++i) {
    const auto bits = static_cast<std::uint32_t>(engine()), from = static_cast<std::uint32_t>(engine());
    const std::size_t n = engine() % 32;
    const auto count = static_cast<std::int32_t>(n);
    ASSERT_EQ(binary(appended(bits, from, count)), binary(bits).substr(n) + binary(from).substr(0, n));
    ASSERT_EQ(binary(moved_to_top(static_cast<std::int32_t>(from), count)),
              binary(from).substr(32 - n) + std::string(32 - n, '0'));
  }
}

TEST_F(Bits, HalfSelectsSixteenBits) {
  EXPECT_EQ(half(0x12345678, -1), 0x5678);
  EXPECT_EQ(half(0x12345678, 0), 0x1234);
  EXPECT_EQ(half(0xfedcba98, -1), 0xba98);
  EXPECT_EQ(half(0xfedcba98, 0), 0xfedc);
}

} // namespace
} // namespace masu
