// What voxels and cells list: as a grid tells it, and as each primitive says of each voxel.
#pragma once

#include "libgrid/grid/grid.h"
#include "libgrid/grid/overlap/overlap.h"
#include "stability/test_scene.h"

#include <algorithm>
#include <span>
#include <unordered_map>
#include <vector>

namespace masu {

using Primitives = std::vector<PrimitiveIndex>;

inline Primitives primitives_of(std::span<const PrimitiveIndex> references, std::uint32_t list) {
  Primitives primitives;
  if (list == empty_list) return primitives;
  for (bool last = false; !last && list < references.size(); ++list) {
    last = (references[list] & last_bit) != 0;
    primitives.push_back(references[list] & ~last_bit);
  }
  return primitives;
}

// Both in rising order.
inline bool includes(const Primitives& all, const Primitives& some) {
  return std::ranges::includes(all, some);
}

// Those of voxels that list any, by the voxel's number.
using Lists = std::unordered_map<std::uint64_t, Primitives>;

inline const Primitives& listed(const Lists& lists, std::uint64_t voxel) {
  static const Primitives none;
  const auto found = lists.find(voxel);
  return found == lists.end() ? none : found->second;
}

// Calls emit(voxel) once for each voxel that the primitive is listed in.
template <class Primitive, class Emit>
void for_each_overlap(const GridLayout& layout, Overlap overlap, const Primitive& primitive,
                      const Emit& emit) {
  const VoxelRows rows = overlap_rows(layout, overlap, primitive);
  for_each_overlap(layout, overlap, primitive, rows, 0, rows.count(), emit);
}

// In rising order, as for_each_overlap says. layout_for: of each primitive, by its margin alone.
template <class Stored, class LayoutFor>
Lists lists_by(TestScene<Stored>& scene, const Vec3i& division, Overlap overlap,
               const LayoutFor& layout_for) {
  Lists lists;
  const SceneView<Stored> view = scene.view();
  for (PrimitiveIndex i = 0; i < scene.count(); ++i)
    with_primitive(view, i, [&](const auto& primitive) {
      for_each_overlap(layout_for(primitive), overlap, primitive,
                       [&](const Vec3i& voxel) { lists[linear_index(voxel, division)].push_back(i); });
    });
  return lists;
}
template <class Stored>
Lists lists_of(TestScene<Stored>& scene, const GridLayout& layout, Overlap overlap) {
  return lists_by(scene, layout.division, overlap, [&](const auto&) { return layout; });
}

template <class Act>
void for_each_voxel_of(const VoxelBox& box, const Act& act) {
  for_each_voxel({box.first, box.end - Vec3i{1, 1, 1}}, act);
}

} // namespace masu
