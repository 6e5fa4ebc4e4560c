// A grid's cells one by one, and those that a plane cuts, against its map looked up voxel by voxel; the boxes
// of a hierarchy that a plane cuts, against all of them.
#include "libgrid/hierarchy/hierarchy_builder.h"
#include "libgrid/statistics/cells.h"
#include "libgrid/statistics/slice.h"
#include "libscene/base/error.h"
#include "tests/grid/lists.h"
#include "tests/random_grid.h"
#include "tests/random_scene.h"
#include "tests/random_test.h"
#include "tests/temporary_folder.h"
#include "tools/report/slice_json.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace masu {
namespace {

bool contains(const VoxelBox& outer, const VoxelBox& inner) {
  for (int axis = 0; axis < 3; ++axis) {
    if (inner.first[axis] < outer.first[axis] || inner.end[axis] > outer.end[axis]) return false;
  }
  return true;
}

std::vector<SliceCell> cells_of(const StructureFile& file, const SlicePlane& plane,
                                const SliceWindow& window) {
  std::vector<SliceCell> cells;
  for_each_slice_cell(file, plane, window, [&](const SliceCell& cell) { cells.push_back(cell); });
  return cells;
}

std::vector<std::uint64_t> cell_numbers(const StructureFile& file, const CellFilter& filter) {
  std::vector<std::uint64_t> numbers;
  for_each_cell(file, filter, [&](const GridCell& cell) { numbers.push_back(cell.number); });
  return numbers;
}

// Random grids as files, small enough to look up every voxel.
class GridCells : public RandomTest {
protected:
  template <class Check> // check(grid, file)
  void for_random_grids(int count, const Check& check) {
    for (int i = 0; i < count; ++i) {
      TestScene<float> scene = SceneMaker<float>(chance_, 1).scene();
      const Structure grid = random_grid<float>(chance_, scene.view(), scene.bounds());
      SCOPED_TRACE(described(grid));
      const std::string path = folder_.file("grid");
      write_structure(
          grid, {{1, 2}, scene.count(), {0, 0, 0}, SpaceRule::tight, Overlap::exact, "any", "any"}, path);
      check(chance_, grid, StructureFile(path));
      if (HasFailure()) return;
    }
  }

  // References of each voxel of a box, looked up.
  template <class Act> // act(voxel, references)
  static void for_each_looked_up(const Structure& grid, const VoxelBox& box, const Act& act) {
    with_view<double>(grid, [&](const auto& view) {
      for_each_voxel_of(box, [&](const Vec3i& voxel) { act(voxel, references_in(view, voxel)); });
    });
  }

  static constexpr std::uint64_t most_voxels = std::uint64_t{1} << 18;
  TemporaryFolder folder_;
};

TEST_F(GridCells, PartitionTheSpaceAndListWhatTheirVoxelsDo) {
  for_random_grids(60, [](Chance&, const Structure& grid, const StructureFile& file) {
    const Vec3i division = finest_layout(grid).division;
    std::uint64_t voxels = 0;
    std::int64_t last = -1;
    std::vector<std::uint32_t> references; // by voxel; 0 and `nothing` yet
    constexpr std::uint32_t nothing = ~0U;
    const bool is_small = voxel_count(division) <= most_voxels;
    if (is_small) references.assign(voxel_count(division), nothing);
    for_each_cell(file, {whole_of(division)}, [&](const GridCell& cell) {
      EXPECT_GT(static_cast<std::int64_t>(cell.number), last);
      last = static_cast<std::int64_t>(cell.number);
      EXPECT_EQ(voxel_count(cell.box.end - cell.box.first), cell.voxels);
      EXPECT_TRUE(contains(cell.expanded, cell.box));
      EXPECT_TRUE(contains(whole_of(division), cell.expanded));
      if (grid.kind != StructureKind::irregular) {
        EXPECT_TRUE(contains(cell.box, cell.expanded));
      }
      voxels += cell.voxels;
      if (!is_small) return;
      for_each_voxel_of(cell.box, [&](const Vec3i& voxel) {
        std::uint32_t& painted = references[linear_index(voxel, division)];
        EXPECT_EQ(painted, nothing) << "in two cells";
        painted = cell.references;
      });
    });
    EXPECT_EQ(voxels, voxel_count(division));
    if (!is_small) return;
    for_each_looked_up(grid, whole_of(division), [&](const Vec3i& voxel, std::uint32_t expected) {
      EXPECT_EQ(references[linear_index(voxel, division)], expected);
    });
  });
}

TEST_F(GridCells, OfAFilterAreThoseOfAllThatItLetsThrough) {
  for_random_grids(60, [](Chance& chance, const Structure& grid, const StructureFile& file) {
    const Vec3i n = finest_layout(grid).division;
    if (voxel_count(n) > most_voxels && grid.kind == StructureKind::uniform) return;
    CellFilter filter{{}, chance.one_in(2)};
    for (int axis = 0; axis < 3; ++axis) {
      const int a = chance.whole(0, n[axis]), b = chance.whole(0, n[axis]);
      filter.within.first.set(axis, std::min(a, b));
      filter.within.end.set(axis, std::max(a, b));
    }
    std::vector<std::uint64_t> expected;
    for_each_cell(file, {whole_of(n)}, [&](const GridCell& cell) {
      bool meets = true;
      for (int axis = 0; axis < 3; ++axis)
        meets = meets && filter.within.first[axis] < filter.within.end[axis] &&
                cell.box.first[axis] < filter.within.end[axis] &&
                cell.box.end[axis] > filter.within.first[axis];
      if (meets && (cell.references > 0 || !filter.occupied_only)) expected.push_back(cell.number);
    });
    EXPECT_EQ(cell_numbers(file, filter), expected);
  });
}

TEST_F(GridCells, OfASliceTileItsLayerAndListWhatItsVoxelsDo) {
  for_random_grids(60, [](Chance& chance, const Structure& grid, const StructureFile& file) {
    const GridLayout finest = finest_layout(grid);
    const int axis = chance.whole(0, 2);
    const std::array<int, 2> axes = slice_axes(axis);
    const std::int64_t columns = finest.division[axes[0]], rows = finest.division[axes[1]];
    const SlicePlane plane =
        plane_of_layer(finest, axis, chance.whole(0, finest.division[axis] - 1), "--slice");
    const std::vector<SliceCell> cells = cells_of(file, plane, window_of(finest, axis));
    std::int64_t area = 0;
    for (const SliceCell& cell : cells) {
      for (const double at : {cell.first[0], cell.first[1], cell.end[0], cell.end[1]})
        EXPECT_EQ(at, std::floor(at));
      area += std::llround((cell.end[0] - cell.first[0]) * (cell.end[1] - cell.first[1]));
      EXPECT_GE(cell.depth, 0);
      EXPECT_LE(cell.depth, grid.nested_log2);
    }
    EXPECT_EQ(area, columns * rows);
    if (static_cast<std::uint64_t>(columns * rows) > most_voxels) return;
    constexpr std::uint32_t nothing = ~0U;
    std::vector<std::uint32_t> references(static_cast<std::size_t>(columns * rows), nothing);
    for (const SliceCell& cell : cells) {
      for (std::int64_t v = std::llround(cell.first[1]); v < std::llround(cell.end[1]); ++v) {
        for (std::int64_t u = std::llround(cell.first[0]); u < std::llround(cell.end[0]); ++u) {
          std::uint32_t& painted = references[static_cast<std::size_t>(v * columns + u)];
          EXPECT_EQ(painted, nothing) << "two cells";
          painted = cell.references;
        }
      }
    }
    VoxelBox layer = whole_of(finest.division);
    layer.first.set(axis, plane.layer);
    layer.end.set(axis, plane.layer + 1);
    for_each_looked_up(grid, layer, [&](const Vec3i& voxel, std::uint32_t expected) {
      EXPECT_EQ(references[static_cast<std::size_t>(voxel[axes[1]] * columns + voxel[axes[0]])], expected);
    });
  });
}

TEST_F(GridCells, OfAWindowAreThoseOfTheSliceWithAPartInIt) {
  for_random_grids(40, [](Chance& chance, const Structure& grid, const StructureFile& file) {
    const GridLayout finest = finest_layout(grid);
    const int axis = chance.whole(0, 2);
    const std::array<int, 2> axes = slice_axes(axis);
    const SlicePlane plane =
        plane_at(finest, axis, chance.uniform(finest.space.min[axis], finest.space.max[axis]), "--slice");
    SliceWindow window = window_of(finest, axis);
    VoxelBox box{};
    for (std::size_t i = 0; i < 2; ++i) { // between the middles of two voxels
      const int n = finest.division[axes[i]];
      const int a = chance.whole(0, n - 1), b = chance.whole(0, n - 1);
      const double size = voxel_size(finest)[axes[i]], low = finest.space.min[axes[i]];
      box.first.set(axes[i], std::min(a, b));
      box.end.set(axes[i], std::max(a, b) + 1);
      window.min[i] = low + (std::min(a, b) + 0.4) * size;
      window.max[i] = low + (std::max(a, b) + 0.6) * size;
    }
    std::vector<std::uint64_t> expected, found;
    for (const SliceCell& cell : cells_of(file, plane, window_of(finest, axis))) {
      bool meets = true;
      for (std::size_t i = 0; i < 2; ++i)
        meets = meets && cell.first[i] < box.end[axes[i]] && cell.end[i] > box.first[axes[i]];
      if (meets) expected.push_back(cell.number);
    }
    for (const SliceCell& cell : cells_of(file, plane, window))
      found.push_back(cell.number);
    EXPECT_EQ(found, expected);
  });
}

TEST_F(GridCells, BoxesInTheSceneSumToTheSpace) {
  for_random_grids(20, [](Chance&, const Structure&, const StructureFile& file) {
    const GridLayout finest = finest_layout(file);
    const Vec3d w = finest.space.max - finest.space.min;
    double volume = 0;
    for_each_cell(file, {whole_of(finest.division)}, [&](const GridCell& cell) {
      const Boxd box = box_in_scene(finest, cell.box);
      const Vec3d sides = box.max - box.min;
      volume += sides.x * sides.y * sides.z;
    });
    EXPECT_NEAR(volume, w.x * w.y * w.z, 1e-6 * w.x * w.y * w.z);
    const Boxd all = box_in_scene(finest, whole_of(finest.division));
    EXPECT_TRUE(all.min == finest.space.min && all.max == finest.space.max);
  });
}

TEST_F(GridCells, PlanesAreInTheirLayersAndNoneLiesOutside) {
  for_random_grids(20, [](Chance& chance, const Structure& grid, const StructureFile&) {
    const GridLayout finest = finest_layout(grid);
    const int axis = chance.whole(0, 2);
    const double low = finest.space.min[axis], high = finest.space.max[axis];
    const std::int32_t layers = finest.division[axis];
    for (int i = 0; i < 20; ++i) {
      const SlicePlane by_layer = plane_of_layer(finest, axis, chance.whole(0, layers - 1), "--slice");
      EXPECT_EQ(plane_at(finest, axis, by_layer.position, "--slice").layer, by_layer.layer);
    }
    EXPECT_EQ(plane_at(finest, axis, low, "--slice").layer, 0);
    EXPECT_EQ(plane_at(finest, axis, high, "--slice").layer, layers - 1);
    const double beyond = (high - low) + std::abs(high) + std::abs(low);
    for (const double at : {low - beyond, high + beyond, std::nan("")})
      EXPECT_THROW(plane_at(finest, axis, at, "--slice"), Error);
    for (const std::int64_t layer : {std::int64_t{-1}, std::int64_t{layers}, std::int64_t{1} << 40})
      EXPECT_THROW(plane_of_layer(finest, axis, layer, "--slice"), Error);
  });
}

TEST_F(GridCells, OfASliceAreNoMoreThanAllowed) {
  for_random_grids(10, [](Chance&, const Structure& grid, const StructureFile& file) {
    const GridLayout finest = finest_layout(grid);
    const SlicePlane plane = plane_of_layer(finest, 2, 0, "--slice");
    const SliceWindow window = window_of(finest, 2);
    const std::size_t cells = cells_of(file, plane, window).size();
    EXPECT_EQ(slice_json(file, plane, window, {}, cells)["cells"].size(), cells);
    EXPECT_THROW(slice_json(file, plane, window, {}, cells - 1), Error);
  });
}

TEST_F(GridCells, BoxesInOneFormAreTheCells) {
  for_random_grids(20, [](Chance&, const Structure&, const StructureFile& file) {
    std::vector<std::uint64_t> found;
    std::int32_t depth = 0;
    for (; depth <= greatest_depth(file); ++depth)
      for_each_box(file, {{}, false, depth}, [&](const StructureBox& box) {
        EXPECT_EQ(box.depth, depth);
        found.push_back(box.number);
      });
    std::ranges::sort(found); // each cell has one of the depths
    EXPECT_EQ(found, cell_numbers(file, {whole_of(finest_layout(file).division)}));
    for_each_box(file, {{}, false, depth},
                 [](const StructureBox&) { ADD_FAILURE() << "deeper than the deepest"; });
  });
}

// Random hierarchies as files.
class HierarchySlices : public RandomTest {
protected:
  template <class Check> // check(chance, file)
  void for_random_hierarchies(int count, const Check& check) {
    for (int i = 0; i < count; ++i) {
      TestScene<float> scene = SceneMaker<float>(chance_, 1).scene();
      Boxd space = scene.bounds();
      if (!fits_hierarchy(space)) continue;
      for (int axis = 0; axis < 3; ++axis) { // none is flat
        space.min.set(axis, space.min[axis] - 1e-3);
        space.max.set(axis, space.max[axis] + 1e-3);
      }
      const Structure grid = build_hierarchy(scene.view(), {space, {1, 1, 1}, 1e-3}, {});
      const std::string path = folder_.file("hierarchy");
      const Vec3d origin{chance_.uniform(-9, 9), 0, 1e6};
      write_structure(grid, {{1, 2}, scene.count(), origin, SpaceRule::tight, Overlap::exact, "any", "any"},
                      path);
      check(chance_, StructureFile(path));
      if (HasFailure()) return;
    }
  }
  TemporaryFolder folder_;
};

TEST_F(HierarchySlices, AreThePartsOfAllBoxesInThePlaneAndTheWindow) {
  std::size_t found = 0, missed = 0;
  for_random_hierarchies(300, [&](Chance& chance, const StructureFile& file) {
    const GridLayout finest = finest_layout(file);
    const Boxd& space = finest.space;
    const int axis = chance.whole(0, 2);
    const std::array<int, 2> axes = slice_axes(axis);
    const SlicePlane plane =
        plane_at(finest, axis, chance.uniform(space.min[axis], space.max[axis]), "--slice");
    SliceWindow window = window_of(finest, axis);
    for (std::size_t i = 0; i < 2; ++i) {
      if (chance.one_in(2)) continue;
      const double a = chance.uniform(window.min[i], window.max[i]),
                   b = chance.uniform(window.min[i], window.max[i]);
      window.min[i] = std::min(a, b);
      window.max[i] = std::max(a, b);
    }
    if (chance.one_in(2)) window.depth = chance.whole(0, greatest_depth(file));
    const std::vector<SliceCell> cells = cells_of(file, plane, window);
    std::size_t next = 0;
    // Brute force: node by node, their depths by the nodes that lead to them.
    const auto nodes = file.nodes();
    std::vector<std::int32_t> depths(nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      std::uint32_t child = nodes[i].first_node;
      for (int slot = 0; slot < boxes_per_node; ++slot) {
        const std::uint32_t byte = slot_byte(nodes[i].slots, slot);
        if (byte == 0) continue;
        const bool is_node = (node_slots(nodes[i]) >> slot & 1) != 0;
        if (is_node) depths[child++] = depths[i] + 1;
        const Boxd relative = box_of(nodes[i], slot);
        const Boxd box{relative.min + file.origin(), relative.max + file.origin()};
        bool meets = box.min[axis] <= plane.position && plane.position <= box.max[axis];
        for (std::size_t k = 0; k < 2; ++k)
          meets = meets && box.min[axes[k]] <= window.max[k] && window.min[k] <= box.max[axes[k]];
        if (!meets || (window.depth && depths[i] != *window.depth)) {
          ++missed;
          continue;
        }
        ++found;
        ASSERT_LT(next, cells.size());
        const SliceCell& cell = cells[next++];
        EXPECT_EQ(cell.number, boxes_per_node * i + static_cast<std::size_t>(slot));
        EXPECT_EQ(cell.depth, depths[i]);
        EXPECT_EQ(cell.references, is_node ? 0 : references_in(byte));
        EXPECT_EQ(cell.voxels, is_node ? child - 1 : 0);
        const SliceWindow rectangle = in_scene(finest, axis, cell);
        for (std::size_t k = 0; k < 2; ++k) {
          const double tolerance = 1e-15 * (std::abs(space.min[axes[k]]) + std::abs(space.max[axes[k]]));
          EXPECT_NEAR(rectangle.min[k], box.min[axes[k]], tolerance);
          EXPECT_NEAR(rectangle.max[k], box.max[axes[k]], tolerance);
        }
      }
    }
    EXPECT_EQ(next, cells.size());
  });
  EXPECT_GT(found, 100U);
  EXPECT_GT(missed, 100U);
}

} // namespace
} // namespace masu
