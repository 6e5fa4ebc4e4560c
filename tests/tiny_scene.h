// A scene with primitives of every kind, and grids for it, small enough for golden bytes.
#pragma once

#include "libgrid/file/structure_file.h"
#include "libscene/file/scene_file.h"

namespace masu {

// Two lights (one with its own colour), four materials, a triangle, a smooth triangle, a sphere, a cone.
// Every coordinate is exact in float32.
inline Scene tiny_scene() {
  Scene scene{};
  scene.camera = {{1, 2, 6}, {0, 0, 0.5}, {0, 1, 0}, 45, 0.5, 8, 6};
  scene.has_camera = true;
  scene.background = {0.25F, 0.5F, 0.75F};
  scene.ambient = 0.353553385F;
  scene.lights = {{{4, 5, 6}, {0.353553385, 0.353553385, 0.353553385}}, {{-4, 1, 8}, {1, 0.5, 0.25}}};
  scene.materials = {{{1, 0, 0}, 0.75F, 0, 0, 0, 1},
                     {{0, 1, 0}, 0.5F, 0.5F, 8, 0, 1},
                     {{0, 0, 1}, 0.25F, 0.25F, 2, 0.5F, 1.5F},
                     {{1, 1, 0}, 1, 0, 0, 0, 1}};
  scene.triangles = {{{-2, -2, -1}, 0, {2, -2, -1}, 0, {0, 2, -1}, no_normals},
                     {{-1, 0, 0}, 1, {0, 0, 0}, 1, {-1, 1, 0}, 0}};
  scene.normals = {{{0, 0, 1}, {0.5, 0, 1}, {0, 0.5, 2}}};
  scene.spheres = {{{0.5, 0.5, 0.5}, 0.25}};
  scene.sphere_surfaces = {{2, 2}};
  scene.cones = {{{0.5, -1, 0}, 0.5, {0.5, 0, 0}, 0.25}};
  scene.cone_surfaces = {{3, 3}};
  scene.objects = {1, 1, 1, 1};
  return scene;
}
inline constexpr std::uint64_t tiny_scene_primitives = 4;

// 2×2×1 voxels, three occupied.
inline Structure tiny_grid() {
  return {{{{-2, -2, -1}, {2, 2, 1}}, {2, 2, 1}, 0.0625},
          StructureKind::uniform,
          0,
          0,
          {occupied_bit | 0, occupied_bit | 1, 0, occupied_bit | 3},
          {},
          {0 | last_bit, 0, 3 | last_bit, 1, 2 | last_bit}};
}

// A map of two levels: 5×1×1 voxels in three blocks, the middle one empty.
inline Structure tiny_grid_of_blocks() {
  constexpr std::uint32_t block0 = occupied_bit | 0, block1 = occupied_bit | 1;
  constexpr std::uint32_t list0 = occupied_bit | 0, list1 = occupied_bit | 1, list2 = occupied_bit | 3;
  return {{{{-2, -2, -1}, {2, 2, 1}}, {5, 1, 1}, 0.0625},
          StructureKind::uniform,
          1,
          0,
          {block0, 0, block1, list0, list1, 0, 0, 0, 0, 0, 0, list2, 0, 0, 0, 0, 0, 0, 0},
          {},
          {0 | last_bit, 0, 3 | last_bit, 1, 2 | last_bit}};
}

// A word of a merged grid's map that divides its box by 2^log2 along each axis; `index`: of the first nested
// word.
inline std::uint32_t divided(std::uint32_t index, std::int32_t log2) {
  return map_word({index, {log2, log2, log2}});
}

// A merged grid of 2×1×1 voxels: the first is divided into five cells, its first eighth once more than the
// others. The third cell is expanded over the second voxel, which is empty.
inline Structure tiny_merged_grid() {
  constexpr std::uint32_t cell0 = occupied_bit | 0, cell1 = occupied_bit | 1, cell2 = occupied_bit | 2,
                          cell3 = occupied_bit | 3, cell4 = occupied_bit | 4, cell5 = occupied_bit | 5;
  const std::uint32_t nested0 = divided(8, 1), nested1 = divided(16, 1);
  const auto range = [](std::uint32_t first, std::uint32_t end) { return first | end << 16; };
  return {{{{-2, -2, -1}, {2, 2, 1}}, {2, 1, 1}, 0.0625},
          StructureKind::irregular,
          0,
          2,
          {nested0, cell5, 0,     0,     0,     0,     0,     0,     //
           nested1, cell2, cell3, cell3, cell4, cell2, cell3, cell3, //
           cell0,   cell1, cell0, cell1, cell0, cell1, cell0, cell1},
          {{range(0, 1), range(0, 2), range(0, 2), 0},
           {range(1, 2), range(0, 2), range(0, 2), 3},
           {range(2, 8), range(0, 2), range(0, 4), 1},
           {range(0, 4), range(2, 4), range(0, 4), empty_list},
           {range(0, 2), range(0, 2), range(2, 4), empty_list},
           {range(4, 8), range(0, 4), range(0, 4), empty_list}},
          {0 | last_bit, 0, 3 | last_bit, 1, 2 | last_bit}};
}

// A hierarchy of two nodes: the root holds the triangles, in its slot 1, and a node of the sphere and the
// cone, in its slot 6. Planes are in sixteenths.
inline Structure tiny_hierarchy() {
  constexpr std::uint32_t sixteenths = 123 | 123 << 8 | 123 << 16;
  const auto in_slots = [](std::uint32_t(&words)[2], int slot, std::uint32_t byte) {
    words[slot / 4] |= byte << (slot % 4 * 8);
  };
  const auto add = [&](HierarchyNode& node, int slot, std::uint32_t held, const Vec3i& low,
                       const Vec3i& high) {
    in_slots(node.slots, slot, held);
    for (int axis = 0; axis < 3; ++axis) {
      in_slots(node.low[axis], slot, static_cast<std::uint32_t>(low[axis]));
      in_slots(node.high[axis], slot, static_cast<std::uint32_t>(high[axis]));
    }
  };
  HierarchyNode root{{-2.25F, -2.25F, -1.25F}, sixteenths | 1U << (24 + 6), 1, 0, {}, {}, {}};
  add(root, 1, 3 << 5 | 0, {3, 3, 3}, {69, 69, 21});
  add(root, 6, node_slot | 6, {35, 11, 11}, {53, 49, 33});
  HierarchyNode inner{{-2.25F, -2.25F, -1.25F}, sixteenths, 2, 2, {}, {}, {}};
  add(inner, 0, 1 << 5 | 0, {39, 39, 23}, {49, 49, 33});
  add(inner, 5, 1 << 5 | 1, {35, 11, 11}, {53, 37, 29});
  return {{{{-2, -2, -1}, {2, 2, 1}}, {1, 1, 1}, 0.0625},
          StructureKind::hierarchy,
          0,
          0,
          {},
          {},
          {0, 1, 2, 3},
          {root, inner}};
}

inline StructureProvenance tiny_grid_provenance(const Hash& geometry_hash,
                                                const std::string& merge_rule = "") {
  return {geometry_hash, tiny_scene_primitives, {0, 0, 0}, SpaceRule::tight, Overlap::exact, "2x2x1",
          merge_rule};
}

} // namespace masu
