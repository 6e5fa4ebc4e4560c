// Expansion, against its definition followed voxel by voxel; and what it compares lists by.
#include "libgrid/grid/expand_passes.h"
#include "libgrid/grid/merge.h"
#include "libscene/passes/host_executor.h"
#include "tests/grid/lists.h"
#include "tests/random_grid.h"
#include "tests/random_scene.h"
#include "tests/random_test.h"
#include "tests/same_values.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <span>

namespace masu {
namespace {

using ComparedLists = RandomTest;
using Stretch = RandomTest;

// A face moves as far as all its neighbours let it; one that once couldn't, never does again.
class SlowExpander {
public:
  explicit SlowExpander(Structure& grid) : grid_(grid), own_(grid.cells), blocked_(grid.cells.size()) {}
  int gave_up = 0; // faces of more than max_visits

  void pass() {
    const auto before = grid_.cells;
    for (std::size_t cell = 0; cell < before.size(); ++cell) {
      VoxelBox box = box_of(before[cell]);
      for (int face = 0; face < 6; ++face) {
        bool& blocked = blocked_[cell][static_cast<std::size_t>(face)];
        blocked = blocked || !moved(before, cell, face, box);
      }
      grid_.cells[cell] = packed(box, before[cell].list);
    }
  }

private:
  static constexpr int max_visits = 32; // of neighbours, row by row

  bool moved(std::span<const MergedCell> before, std::size_t cell, int face, VoxelBox& box) {
    const MergedGridView<double> view = merged_view_of<double>(grid_);
    const bool is_low = face % 2 == 0;
    const int axis = face / 2, u = (axis + 1) % 3, v = (axis + 2) % 3;
    Vec3i& corner = is_low ? box.first : box.end;
    if (corner[axis] == (is_low ? 0 : view.division[axis])) return false;
    std::int32_t reach = is_low ? 0 : 65535;
    const Primitives all = primitives_of(grid_.references, before[cell].list);
    int visits = 0;
    Vec3i voxel{};
    voxel.set(axis, is_low ? corner[axis] - 1 : corner[axis]);
    for (std::int32_t j = box.first[v], next_j = 0; j < box.end[v]; j = next_j) {
      next_j = box.end[v];
      for (std::int32_t i = box.first[u]; i < box.end[u];) {
        voxel.set(u, i);
        voxel.set(v, j);
        const std::uint32_t other = cell_number(view, voxel);
        if (!includes(all, primitives_of(grid_.references, before[other].list))) return false;
        if (++visits > max_visits) {
          ++gave_up;
          return false;
        }
        const VoxelBox neighbor = box_of(before[other]), own = box_of(own_[other]);
        reach = is_low ? std::max(reach, neighbor.first[axis]) : std::min(reach, neighbor.end[axis]);
        i = own.end[u];
        next_j = std::min(next_j, own.end[v]);
      }
    }
    corner.set(axis, reach);
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
    ASSERT_TRUE(same_values(fast.cells, slow.cells));
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
