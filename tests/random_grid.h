// Random grids of every kind, and hierarchies.
#pragma once

#include "libgrid/file/structure_file.h"
#include "libgrid/grid/division.h"
#include "libgrid/hierarchy/hierarchy_builder.h"
#include "libgrid/statistics/statistics.h"
#include "libgrid/structure/builder.h"
#include "stability/test_scene.h"

namespace masu {

inline Overlap any_overlap(Chance& chance) {
  return chance.one_in(2) ? Overlap::exact : Overlap::box;
}
// Up to so many voxels an axis.
inline Vec3i random_division(Chance& chance, int most) {
  return {chance.whole(1, most), chance.whole(1, most), chance.whole(1, most)};
}

template <class Stored>
GridLayout random_layout(Chance& chance, const Boxd& bounds) {
  const auto voxels = [&] {
    if (chance.one_in(3)) return std::int32_t{1} << chance.whole(0, 5);
    return chance.whole(1, 64);
  };
  return layout_in<Stored>(bounds, {voxels(), voxels(), voxels()},
                           chance.one_in(2) ? SpaceRule::tight : SpaceRule::cube);
}

// The same uniform grid with a map of two levels, which the builder uses only for large divisions.
inline Structure in_blocks(const Structure& grid, std::int32_t block_log2) {
  Structure blocks_grid{grid.layout, StructureKind::uniform, block_log2, 0, {}, {}, grid.references};
  const Vec3i blocks = blocks_of(grid.layout.division, block_log2);
  const std::size_t words = std::size_t{1} << (3 * block_log2);
  blocks_grid.voxel_map.assign(voxel_count(blocks), 0);
  std::uint32_t count = 0;
  for_each_voxel({{0, 0, 0}, grid.layout.division - Vec3i{1, 1, 1}}, [&](const Vec3i& voxel) {
    const std::uint32_t word = grid.voxel_map[linear_index(voxel, grid.layout.division)];
    if ((word & occupied_bit) == 0) return;
    std::uint32_t& block = blocks_grid.voxel_map[linear_index(
        {voxel.x >> block_log2, voxel.y >> block_log2, voxel.z >> block_log2}, blocks)];
    if (block == 0) block = occupied_bit | count++;
    const std::size_t begin = voxel_count(blocks) + (block & ~occupied_bit) * words;
    if (blocks_grid.voxel_map.size() < begin + words) blocks_grid.voxel_map.resize(begin + words, 0);
    blocks_grid.voxel_map[begin + index_in_block(voxel, block_log2)] = word;
  });
  return blocks_grid;
}

template <class Stored>
Structure random_uniform_grid(Chance& chance, const SceneView<Stored>& scene, const Boxd& bounds) {
  const Structure grid = build_structure(scene, random_layout<Stored>(chance, bounds), any_overlap(chance));
  return grid.block_log2 == 0 && chance.one_in(2) ? in_blocks(grid, chance.whole(1, 5)) : grid;
}

inline StructureOptions random_grid_options(Chance& chance) {
  return {chance.one_of({StructureKind::x, StructureKind::balance, StructureKind::irregular}),
          chance.one_of({1U, 2U, 8U, 64U}),
          chance.one_of({1.0, 0.8}),
          chance.one_of({0.0, 0.5, 3.0, 20.0}),
          chance.one_of({0.3, 1.0, 3.0, 30.0}),
          chance.one_of({0, 1, 3, 8, 15}),
          chance.one_of({0, 1, 6})};
}

struct RandomCase {
  GridLayout layout;
  Overlap overlap;
  StructureOptions options;
};
// Input for an irregular grid with few top-level voxels.
template <class Stored>
RandomCase random_irregular_case(Chance& chance, const Boxd& bounds) {
  RandomCase by{random_layout<Stored>(chance, bounds), any_overlap(chance), random_grid_options(chance)};
  by.layout.division = random_division(chance, 9);
  by.options.kind = StructureKind::irregular;
  return by;
}

template <class Stored>
Structure random_merged_grid(Chance& chance, const SceneView<Stored>& scene, const Boxd& bounds) {
  const StructureOptions options = random_grid_options(chance);
  GridLayout layout = random_layout<Stored>(chance, bounds);
  if (options.kind == StructureKind::irregular && chance.one_in(2))
    layout.division = random_division(chance, 6);
  return build_structure(scene, layout, any_overlap(chance), options);
}

template <class Stored>
Structure random_grid(Chance& chance, const SceneView<Stored>& scene, const Boxd& bounds) {
  return chance.one_in(3) ? random_uniform_grid(chance, scene, bounds)
                          : random_merged_grid(chance, scene, bounds);
}

template <class Stored>
GridLayout hierarchy_layout(TestScene<Stored>& scene) {
  return layout_in<Stored>(scene.bounds(), {1, 1, 1});
}
template <class Stored>
Structure hierarchy_of(TestScene<Stored>& scene, HierarchyQuality quality = HierarchyQuality::high) {
  return build_hierarchy(scene.view(), hierarchy_layout(scene), quality);
}
inline HierarchyQuality any_quality(Chance& chance) {
  return chance.one_of({HierarchyQuality::high, HierarchyQuality::fast});
}

template <class Stored>
Structure random_structure(Chance& chance, TestScene<Stored>& scene) {
  return chance.one_in(2) ? random_grid(chance, scene.view(), scene.bounds())
                          : hierarchy_of(scene, any_quality(chance));
}

// Calls act(the grid's view); not of a hierarchy.
template <class Real, class Act>
void with_view(const Structure& grid, const Act& act) {
  grid.kind == StructureKind::uniform ? act(view_of<Real>(grid)) : act(merged_view_of<Real>(grid));
}

// References of the voxel's cell; 0 when it is empty.
template <class View>
std::uint32_t references_in(const View& grid, const Vec3i& voxel) {
  return references_of(grid.references, cell_at(grid, voxel, {0, 0, 0}).list);
}

// The layout of the grid's smallest voxels.
inline GridLayout finest_layout(const Structure& grid) {
  return finer(grid.layout, grid.nested_log2);
}

inline std::string described(const Structure& grid) {
  const Boxd& s = grid.layout.space;
  const Vec3i n = grid.layout.division;
  return "space " + described(s.min) + described(s.max) + " division " + std::to_string(n.x) + 'x' +
         std::to_string(n.y) + 'x' + std::to_string(n.z) + " kind " +
         std::to_string(static_cast<int>(grid.kind)) + " blocks of 2^" + std::to_string(grid.block_log2) +
         " nested 2^" + std::to_string(grid.nested_log2);
}

} // namespace masu
