// Expansion, against its definition followed voxel by voxel; and what it compares lists by.
#include "libgrid/grid/expand_passes.h"
#include "libscene/passes/host_executor.h"
#include "tests/grid/lists.h"
#include "tests/random_grid.h"
#include "tests/random_scene.h"
#include "tests/random_test.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <span>

namespace masu {
namespace {

using ComparedLists = RandomTest;
using Stretch = RandomTest;

std::array<std::array<std::int32_t, 2>, 3> ranges_of(const MergedCell& cell) {
  const auto range = [](std::uint32_t packed) {
    return std::array{static_cast<std::int32_t>(packed & 0xffff), static_cast<std::int32_t>(packed >> 16)};
  };
  return {range(cell.x), range(cell.y), range(cell.z)};
}

// A face moves as far as all its neighbours let it; one that once couldn't, never does again.
class SlowExpander {
public:
  explicit SlowExpander(Structure& grid) : grid_(grid), own_(grid.cells), blocked_(grid.cells.size()) {}
  int gave_up = 0; // faces of more than max_visits

  void pass() {
    const auto before = grid_.cells;
    for (std::size_t cell = 0; cell < before.size(); ++cell) {
      auto box = ranges_of(before[cell]);
      for (std::size_t face = 0; face < 6; ++face) {
        if (!blocked_[cell][face] && !moved(before, cell, face, box)) blocked_[cell][face] = true;
      }
      const auto packed = [](const std::array<std::int32_t, 2>& range) {
        return static_cast<std::uint32_t>(range[0]) | static_cast<std::uint32_t>(range[1]) << 16;
      };
      grid_.cells[cell] = {packed(box[0]), packed(box[1]), packed(box[2]), before[cell].list};
    }
  }

private:
  static constexpr int max_visits = 32; // of neighbours, row by row

  bool moved(std::span<const MergedCell> before, std::size_t cell, std::size_t face,
             std::array<std::array<std::int32_t, 2>, 3>& box) {
    const MergedGridView<double> view = merged_view_of<double>(grid_);
    const std::size_t axis = face / 2, u = (axis + 1) % 3, v = (axis + 2) % 3;
    std::int32_t& plane = box[axis][face % 2];
    if (plane == (face % 2 == 0 ? 0 : view.division[static_cast<int>(axis)])) return false;
    std::int32_t reach = face % 2 == 0 ? 0 : 65535;
    const Primitives all = primitives_of(grid_.references, before[cell].list);
    int visits = 0;
    Vec3i voxel{};
    voxel.set(static_cast<int>(axis), face % 2 == 0 ? plane - 1 : plane);
    for (std::int32_t j = box[v][0], next_j = 0; j < box[v][1]; j = next_j) {
      next_j = box[v][1];
      for (std::int32_t i = box[u][0]; i < box[u][1];) {
        voxel.set(static_cast<int>(u), i);
        voxel.set(static_cast<int>(v), j);
        const std::uint32_t other = cell_number(view, voxel);
        if (!includes(all, primitives_of(grid_.references, before[other].list))) return false;
        if (++visits > max_visits) {
          ++gave_up;
          return false;
        }
        const std::int32_t bound = ranges_of(before[other])[axis][face % 2];
        reach = face % 2 == 0 ? std::max(reach, bound) : std::min(reach, bound);
        i = ranges_of(own_[other])[u][1];
        next_j = std::min(next_j, ranges_of(own_[other])[v][1]);
      }
    }
    plane = reach;
    return true;
  }

  Structure& grid_;
  HostArray<MergedCell> own_;
  std::vector<std::array<bool, 6>> blocked_;
};

TEST_F(Stretch, MovesFacesAsDefined) {
  std::int64_t cells = 0, gave_up = 0;
  for (std::int64_t s = cases(150); s > 0; --s) {
    TestScene<float> scene = SceneMaker<float>(chance_, chance_.power_of_two(-10, 20)).scene();
    StructureOptions options = random_grid_options(chance_);
    options.kind = StructureKind::irregular;
    options.expand = 0;
    GridLayout layout = random_layout<float>(chance_, scene.bounds());
    layout.division = random_division(chance_, 12);
    Structure slow = build_structure(scene.view(), layout, any_overlap(chance_), options);
    const int rounds = chance_.whole(0, 5);
    Structure fast = slow;
    TbbExecutor executor;
    expand_cells(executor, merged_view_of<double>(fast), fast.cells.size(), fast.cells.data(), rounds);
    SlowExpander expander(slow);
    for (int i = 0; i < rounds; ++i)
      expander.pass();
    for (std::size_t i = 0; i < slow.cells.size(); ++i) {
      ASSERT_EQ(ranges_of(fast.cells[i]), ranges_of(slow.cells[i])) << "cell " << i;
      ASSERT_EQ(fast.cells[i].list, slow.cells[i].list);
    }
    cells += static_cast<std::int64_t>(slow.cells.size());
    gave_up += expander.gave_up;
  }
  EXPECT_GT(cells, cases(1000));
  EXPECT_GT(gave_up, 0);
}

TEST_F(ComparedLists, AreContainedAsSetsAre) {
  std::int64_t contained = 0;
  for (std::int64_t s = cases(20000); s > 0; --s) {
    std::vector<PrimitiveIndex> references;
    const auto random_list = [&]() {
      const auto begin = static_cast<std::uint32_t>(references.size());
      const PrimitiveIndex step = chance_.one_of({1U, 2U, 1000U, 1U << 24});
      for (PrimitiveIndex i = 0; i < 8; ++i) {
        if (chance_.one_in(3)) references.push_back(i * step);
      }
      if (begin == references.size()) return empty_list;
      references.back() |= last_bit;
      return begin;
    };
    const std::uint32_t whole = random_list(), part = random_list();
    const bool is_part = includes(primitives_of(references, whole), primitives_of(references, part));
    ASSERT_EQ(lists_all(references.data(), whole, part), is_part);
    const std::uint32_t part_signature = signature_of(references.data(), part);
    EXPECT_EQ(part_signature == 0, part == empty_list);
    if (is_part) {
      ASSERT_EQ(part_signature & ~signature_of(references.data(), whole), 0U);
    }
    contained += is_part;
  }
  EXPECT_GT(contained, cases(500));
}

} // namespace
} // namespace masu
