// Which leaves are divided while a fast hierarchy is split (top_down_passes.h): triangles larger than most,
// as walls are, where a plane through them splits a range cheaper than any by centres does (after Stich,
// Friedrich & Dietrich, "Spatial Splits in Bounding Volume Hierarchies", HPG 2009). Else all that stands in a
// room is in boxes with all of its walls. Of parts that end up side by side one is made again (node_of()).
#pragma once

#include "libgrid/hierarchy/binary/fragment_split.h"

#include <cstdint>

namespace masu {

// Where triangles are of about one size nothing is gained: the least mean area of boxes, in squares of their
// mean width. Rooms and cities have 3 to 20, gears 1.6, scans and the teapot up to 1.5.
inline constexpr double least_spread = 1.6;
inline constexpr double large_width = 2;             // in mean widths
inline constexpr std::uint32_t most_undivided = 512; // leaves of a range
inline constexpr double spare_parts = 0.3;           // a leaf

// Planes are chosen by the boxes that they leave of a leaf's. Those of its triangle's parts are smaller: so a
// plane may seem to cost so much more than a split by centres.
inline constexpr float most_of_cost = 1.2F;

struct LargeLeaves {
  double margin = 0;
  float least_area = INFINITY; // half of the surface of a large box
  std::uint32_t triangles = 0; // so many primitives are triangles, the first ones
  std::uint32_t room = 0;      // how many more leaves there may be

  MASU_HD bool has(const BinaryNode& leaf) const {
    return leaf.index < triangles && half_area(leaf.box()) > least_area;
  }
  // By the place that a range is split at; then its parts. `triangle`: of an index.
  template <class TriangleOf>
  MASU_HD bool divides(const LeafSplit& split, const BinaryNode& leaf, const TriangleOf& triangle,
                       Sides& parts) const {
    const float place = split.place / 2;
    if (!(leaf.min[split.axis] < place && place < leaf.max[split.axis]) || !has(leaf)) return false;
    parts = parts_of(triangle(leaf.index), split.axis, place, margin, leaf.box());
    return parts.are_two();
  }
};

// All leaves, with which of them are large.
template <class Executor>
struct HierarchyLeaves {
  ArrayOf<Executor, BinaryNode> leaves;
  LargeLeaves large{};
};

} // namespace masu
