// What the cells of merged grids hold, against what each primitive says of each voxel.
#include "libgrid/grid/merge_passes.h"
#include "libgrid/structure/builder.h"
#include "libscene/base/error.h"
#include "tests/grid/device_like_executor.h"
#include "tests/grid/lists.h"
#include "tests/random_grid.h"
#include "tests/random_scene.h"
#include "tests/random_test.h"
#include "tests/refused.h"
#include "tests/same_grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace masu {
namespace {

using MergedOutOfRange = RandomTest;

std::int64_t volume(const VoxelBox& box) {
  const Vec3i w = box.end - box.first;
  return std::int64_t{w.x} * w.y * w.z;
}

// A merged grid taken apart: the voxels that lead to each cell, and what it lists.
struct Cells {
  const Structure& grid;
  Vec3i division; // in the smallest voxels
  std::vector<VoxelBox> own, boxes;
  std::vector<Primitives> lists;
  std::vector<std::uint32_t> of_voxel;

  // Fails where voxels lead astray, cells aren't boxes of voxels, or lists aren't in order.
  explicit Cells(const Structure& g)
      : grid(g), division(finest_layout(g).division), own(g.cells.size(), VoxelBox{division, {0, 0, 0}}),
        of_voxel(voxel_count(division)) {
    const MergedGridView<double> view = merged_view_of<double>(grid);
    std::vector<std::int64_t> counts(grid.cells.size(), 0);
    for_each_voxel_of({{0, 0, 0}, division}, [&](const Vec3i& voxel) {
      const std::uint32_t cell = cell_number(view, voxel);
      ASSERT_LT(cell, grid.cells.size());
      of_voxel[linear_index(voxel, division)] = cell;
      ++counts[cell];
      for (int axis = 0; axis < 3; ++axis) {
        own[cell].first.set(axis, std::min(own[cell].first[axis], voxel[axis]));
        own[cell].end.set(axis, std::max(own[cell].end[axis], voxel[axis] + 1));
      }
    });
    std::size_t references = 0;
    for (std::size_t i = 0; i < grid.cells.size(); ++i) {
      boxes.push_back(box_of(grid.cells[i]));
      EXPECT_GT(counts[i], 0) << "no voxel leads to cell " << i;
      EXPECT_EQ(counts[i], volume(own[i])) << "not a box of voxels: cell " << i;
      lists.push_back(primitives_of(grid.references, grid.cells[i].list));
      EXPECT_EQ(std::ranges::adjacent_find(lists[i], std::greater_equal<>()), lists[i].end())
          << "not in rising order: cell " << i;
      references += lists[i].size();
    }
    EXPECT_EQ(references, grid.references.size());
  }
};

template <class Stored>
class Merged : public RandomTest {
protected:
  // Of random scenes, some of nothing: calls change(scene, case), and check(scene, case, grid, its cells).
  // The layout follows what was changed.
  template <class Change, class Check>
  void for_random_grids(std::int64_t count, const Change& change, const Check& check) {
    for (; count > 0; --count) {
      auto scene = SceneMaker<Stored>(chance_, chance_.power_of_two(-10, 20)).scene();
      if (chance_.one_in(20)) scene = {};
      RandomCase by{{}, any_overlap(chance_), random_grid_options(chance_)};
      by.options.nested_log2 = std::min(by.options.nested_log2, 3);
      change(scene, by);
      by.layout = random_layout<Stored>(chance_, scene.bounds());
      // Few enough voxels to look at each of them.
      by.layout.division = random_division(chance_, by.options.kind == StructureKind::irregular ? 4 : 24);
      const Structure grid = build_structure(scene.view(), by.layout, by.overlap, by.options);
      check(scene, by, grid, Cells(grid));
      ASSERT_FALSE(HasFailure()) << described(grid) << '\n' << described(scene);
    }
  }
};
TYPED_TEST_SUITE(Merged, Reals);

// What lies nearer than this to a voxel must be listed in its cell; what lies farther than that must not.
// Between them is what rounding may decide either way.
GridLayout with_margin(GridLayout layout, double share) {
  layout.margin *= share;
  return layout;
}
constexpr double surely = 0.875, perhaps = 1.5;

// What a merged grid must list. A flat cone's test takes for touching what is several margins off, and does
// so for a voxel rather than for the larger box that a cell was found for: its margin is less by what its
// side's slope makes of it.
template <class Stored>
Lists needed_lists(TestScene<Stored>& scene, const GridLayout& layout, Overlap overlap) {
  return lists_by(scene, layout.division, overlap, [&]<class Primitive>(const Primitive& p) {
    double share = surely;
    if constexpr (std::is_same_v<Primitive, Cone<double>>)
      share /= 1.5 * std::hypot(1.0, (p.apex_radius - p.base_radius) / length(p.apex - p.base));
    return with_margin(layout, share);
  });
}

// needed: by voxel.
void expect_listed(const Cells& cells, const Lists& needed) {
  for_each_voxel_of({{0, 0, 0}, cells.division}, [&](const Vec3i& voxel) {
    const std::uint64_t place = linear_index(voxel, cells.division);
    const std::uint32_t cell = cells.of_voxel[place];
    // The whole of its own voxels, and maybe more.
    const VoxelBox& box = cells.boxes[cell];
    for (int axis = 0; axis < 3; ++axis)
      ASSERT_TRUE(box.first[axis] >= 0 && box.first[axis] <= voxel[axis] && voxel[axis] < box.end[axis] &&
                  box.end[axis] <= cells.division[axis]);
    ASSERT_TRUE(includes(cells.lists[cell], listed(needed, place)))
        << "voxel " << voxel.x << ' ' << voxel.y << ' ' << voxel.z;
  });
}

TYPED_TEST(Merged, EveryVoxelLeadsToACellAroundItThatListsWhatItHolds) {
  this->for_random_grids(
      cases(400), [](auto&, RandomCase&) {},
      [](auto& scene, const RandomCase& by, const Structure& grid, const Cells& cells) {
        expect_listed(cells, needed_lists(scene, finest_layout(grid), by.overlap));
      });
}

TYPED_TEST(Merged, MapsThatWouldBeTooLargeHaveLessDetail) {
  Chance& chance = this->chance_;
  for (std::int64_t s = cases(20); s > 0; --s) {
    TestScene<TypeParam> scene;
    add_triangles(scene, chance, 500, 0.1);
    StructureOptions options{StructureKind::irregular};
    options.nested_log2 = 3;
    GridLayout layout = random_layout<TypeParam>(chance, scene.bounds());
    layout.division = {2, 2, 2};
    const Structure whole = build_structure(scene.view(), layout, Overlap::exact, options);
    EXPECT_EQ(whole.detail, options.detail);
    options.max_map_words = whole.voxel_map.size() / 2;
    const Structure grid = build_structure(scene.view(), layout, Overlap::exact, options);
    EXPECT_LT(grid.detail, options.detail);
    EXPECT_LE(grid.voxel_map.size(), options.max_map_words);
    expect_listed(Cells(grid), needed_lists(scene, finest_layout(grid), Overlap::exact));
    DeviceLikeExecutor executor;
    expect_same(grid, merged_grid(executor, scene.view(), layout, Overlap::exact, options));
    options.max_map_words = voxel_count(layout.division);
    EXPECT_THROW(cpu_builder(scene.view())->build(layout, Overlap::exact, options), Error);
    ASSERT_FALSE(this->HasFailure()) << described(grid) << '\n' << described(scene);
  }
}

// Whoever builds it, and in whatever order its parts are built.
TYPED_TEST(Merged, ListsThatHardlyGetShorterAreDividedUpToALimit) {
  Chance& chance = this->chance_;
  std::int64_t exceeded = 0;
  // Few cases may all be within the limit: then more, of which some aren't.
  for (std::int64_t s = cases(60); s > 0 || (exceeded == 0 && s > -500); --s) {
    TestScene<TypeParam> scene; // long and thin, through each other
    for (int i = 0; i < 200; ++i) {
      const Vec3d at = chance.in_cube(0.2), along = chance.direction();
      const auto near = [&](const Vec3d& point) { return cast<TypeParam>(point + chance.in_cube(0.01)); };
      scene.triangles.push_back(triangle_of(near(at - along), near(at + along), near(at + along)));
    }
    StructureOptions options = random_grid_options(chance);
    GridLayout layout = random_layout<TypeParam>(chance, scene.bounds());
    if (options.kind == StructureKind::irregular) layout.division = random_division(chance, 9);
    options.nested_log2 = std::min(options.nested_log2, 3);
    options.max_fragments = static_cast<std::uint64_t>(chance.power_of_two(8, 20));
    const auto builder = cpu_builder(scene.view());
    const Structure grid = builder->try_build(layout, Overlap::exact, options);
    DeviceLikeExecutor executor;
    const Structure other = merged_grid(executor, scene.view(), layout, Overlap::exact, options);
    ASSERT_EQ(grid.exceeded == nullptr, other.exceeded == nullptr) << described(grid);
    exceeded += grid.exceeded != nullptr;
    if (grid.exceeded != nullptr) {
      EXPECT_TRUE(is_refused_with(ErrorCode::usage, "division",
                                  [&] { builder->build(layout, Overlap::exact, options); }));
      continue;
    }
    expect_same(grid, other);
    EXPECT_TRUE(options.kind == StructureKind::x || grid.references.size() <= options.max_fragments);
    ASSERT_FALSE(this->HasFailure()) << described(grid) << '\n' << described(scene);
  }
  EXPECT_GT(exceeded, 0);
}

// nff2bin writes no such scene, but a file may hold one: areas and volumes are then infinite, or nothing.
TEST_F(MergedOutOfRange, EveryVoxelStillLeadsToACellThatListsWhatItHolds) {
  StructureOptions options{StructureKind::irregular};
  options.nested_log2 = 3;
  for (const double scale : {0x1p520, 0x1p-520}) {
    for (std::int64_t s = cases(20); s > 0; --s) {
      TestScene<double> scene;
      const auto corner = [&] { return chance_.in_cube(1) * scale; };
      for (int i = 0; i < 30; ++i) {
        const Vec3d a = corner(), b = corner(), c = corner();
        scene.triangles.push_back(triangle_of(a, b, c));
      }
      GridLayout layout = random_layout<double>(chance_, scene.bounds());
      layout.division = {2, 3, 4};
      const Structure grid = build_structure(scene.view(), layout, Overlap::box, options);
      expect_listed(Cells(grid), needed_lists(scene, finest_layout(grid), Overlap::box));
      build_structure(scene.view(), layout, Overlap::exact, options);
      ASSERT_FALSE(testing::Test::HasFailure()) << described(grid) << '\n' << described(scene);
    }
  }
}

TYPED_TEST(Merged, CellsListNothingThatIsNotInThem) {
  this->for_random_grids(
      cases(400),
      [](auto& scene, const RandomCase& by) {
        // The exact test of cones says more of small boxes than of large ones.
        if (by.overlap == Overlap::exact) scene.cones.clear();
      },
      [](auto& scene, const RandomCase& by, const Structure& grid, const Cells& cells) {
        const Lists possible = lists_of(scene, with_margin(finest_layout(grid), perhaps), by.overlap);
        std::vector<std::set<PrimitiveIndex>> in_cells(grid.cells.size());
        for (const auto& [voxel, list] : possible)
          in_cells[cells.of_voxel[voxel]].insert(list.begin(), list.end());
        for (std::size_t cell = 0; cell < grid.cells.size(); ++cell)
          ASSERT_TRUE(std::ranges::includes(in_cells[cell], cells.lists[cell])) << "cell " << cell;
      });
}

// A ray that crosses a cell's box misses nothing by it.
TYPED_TEST(Merged, NothingIsInAStretchedCellsBoxThatItDoesNotList) {
  std::int64_t expanded = 0, over_others = 0;
  this->for_random_grids(
      cases(200),
      [&](auto&, RandomCase& by) {
        by.options.kind = StructureKind::irregular;
        by.options.expand = this->chance_.one_of({1, 2, 6, 40});
      },
      [&](auto& scene, const RandomCase& by, const Structure& grid, const Cells& cells) {
        const Lists needed = needed_lists(scene, finest_layout(grid), by.overlap);
        for (std::size_t cell = 0; cell < grid.cells.size(); ++cell) {
          expanded += volume(cells.boxes[cell]) > volume(cells.own[cell]);
          for_each_voxel_of(cells.boxes[cell], [&](const Vec3i& voxel) {
            const std::uint64_t place = linear_index(voxel, cells.division);
            const Primitives& others = cells.lists[cells.of_voxel[place]];
            over_others += cells.of_voxel[place] != cell && !others.empty();
            ASSERT_TRUE(includes(cells.lists[cell], others) &&
                        includes(cells.lists[cell], listed(needed, place)))
                << "cell " << cell << " voxel " << voxel.x << ' ' << voxel.y << ' ' << voxel.z;
          });
        }
      });
  EXPECT_GT(expanded, cases(100));
  EXPECT_GT(over_others, cases(10));
}

TYPED_TEST(Merged, WithoutStretchingCellsAreTheirOwnVoxels) {
  this->for_random_grids(
      cases(200), [](auto&, RandomCase& by) { by.options.expand = 0; },
      [](auto&, const RandomCase&, const Structure& grid, const Cells& cells) {
        for (std::size_t cell = 0; cell < grid.cells.size(); ++cell)
          ASSERT_TRUE(cells.boxes[cell].first == cells.own[cell].first &&
                      cells.boxes[cell].end == cells.own[cell].end)
              << "cell " << cell;
      });
}

// --- x ---------------------------------------------------------------------------------------------------

TYPED_TEST(Merged, ByXEveryRunOfEmptyVoxelsIsOneCell) {
  this->for_random_grids(
      cases(200), [](auto&, RandomCase& by) { by.options = {StructureKind::x}; },
      [](auto& scene, const RandomCase& by, const Structure&, const Cells& cells) {
        const Vec3i& division = by.layout.division;
        const Lists lists = lists_of(scene, by.layout, by.overlap);
        for_each_voxel_of({{0, 0, 0}, division}, [&](const Vec3i& voxel) {
          const auto is_empty = [&](std::int32_t x) {
            return listed(lists, linear_index({x, voxel.y, voxel.z}, division)).empty();
          };
          const std::uint32_t cell = cells.of_voxel[linear_index(voxel, division)];
          ASSERT_EQ(cells.lists[cell], listed(lists, linear_index(voxel, division)));
          VoxelBox run{voxel, voxel + Vec3i{1, 1, 1}};
          if (is_empty(voxel.x)) {
            while (run.first.x > 0 && is_empty(run.first.x - 1))
              --run.first.x;
            while (run.end.x < division.x && is_empty(run.end.x))
              ++run.end.x;
          }
          ASSERT_TRUE(cells.boxes[cell].first == run.first && cells.boxes[cell].end == run.end);
        });
      });
}

// --- balance ---------------------------------------------------------------------------------------------

// Whether a plane divides the cell so that both halves list fewer.
bool could_be_divided(const Lists& lists, const VoxelBox& box, const Vec3i& division) {
  const auto listed_in = [&](const VoxelBox& part) {
    std::set<PrimitiveIndex> all;
    for_each_voxel_of(part, [&](const Vec3i& voxel) {
      const Primitives& list = listed(lists, linear_index(voxel, division));
      all.insert(list.begin(), list.end());
    });
    return all.size();
  };
  const std::size_t whole = listed_in(box);
  for (int axis = 0; axis < 3; ++axis) {
    for (std::int32_t at = box.first[axis] + 1; at < box.end[axis]; ++at) {
      VoxelBox below = box, above = box;
      below.end.set(axis, at);
      above.first.set(axis, at);
      if (listed_in(below) < whole && listed_in(above) < whole) return true;
    }
  }
  return false;
}

TYPED_TEST(Merged, ByBalanceNoCellListsMoreThanTheTargetThatCouldBeDivided) {
  std::int64_t within = 0, above = 0;
  this->for_random_grids(
      cases(300),
      [&](auto&, RandomCase& by) {
        by.overlap = Overlap::box;
        by.options = {StructureKind::balance, this->chance_.one_of({1U, 2U, 5U, 20U})};
      },
      [&](auto& scene, const RandomCase& by, const Structure&, const Cells& cells) {
        const Lists lists = lists_of(scene, by.layout, by.overlap);
        for (std::size_t cell = 0; cell < cells.lists.size(); ++cell) {
          if (cells.lists[cell].size() <= by.options.target) {
            ++within;
            continue;
          }
          above += volume(cells.own[cell]) > 1;
          ASSERT_FALSE(could_be_divided(lists, cells.own[cell], by.layout.division))
              << "cell " << cell << " lists " << cells.lists[cell].size() << ", not " << by.options.target;
        }
      });
  EXPECT_GT(within, cases(1000));
  EXPECT_GT(above, 0);
}

} // namespace
} // namespace masu
