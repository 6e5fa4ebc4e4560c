// How a range of fragments of a hierarchy of high quality is split: by the surface area heuristic over bins
// of their centres, or of space, where what crosses a plane is divided (Stich, Friedrich & Dietrich, "Spatial
// Splits in Bounding Volume Hierarchies", HPG 2009). Who computes it (binary_hierarchy.cpp,
// spatial_split_passes.h on a device) comes to the same.
#pragma once

#include "libgrid/grid/overlap/clipped_bounds.h"
#include "libgrid/hierarchy/binary/leaf_split.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace masu {

inline constexpr std::int32_t most_bins = 32, bins_in_space = 16;
MASU_HD inline std::int32_t bins_by_centre(std::uint32_t fragments) {
  return fragments > 64 ? most_bins : most_bins / 2;
}

// Whether a spatial split is tried where the boxes of the best object split overlap: not by less than a share
// of the root's surface.
MASU_HD inline bool is_worth_splitting(const Boxf& overlap, float root_area) {
  return !is_empty(overlap) && half_area(overlap) > 1e-4F * root_area;
}

// Of so many fragments or more at this depth halves are taken, lest the hierarchy become too deep for the
// walk's stack. A spatial split may leave twice as many fragments on one side.
inline std::uint64_t fewest_halved(int depth) {
  return std::uint64_t{1} << std::max(max_hierarchy_depth - 2 - depth, 0);
}

// Of the fragments that a range may still add, what its left ones may.
MASU_HD inline std::uint32_t room_of_left(std::uint32_t room, std::uint32_t left, std::uint32_t fragments) {
  return static_cast<std::uint32_t>(static_cast<double>(room) * left / fragments);
}

// The bins that a box is divided into along an axis.
struct FragmentBins {
  float low = 0, unit = 0, per_unit = 0; // per_unit is 0 where all are in one place, or nearly
  std::int32_t count = 0;

  FragmentBins() = default;
  MASU_HD FragmentBins(float low_, float high, std::int32_t count_)
      : low(low_), unit((high - low_) / static_cast<float>(count_)), count(count_) {
    const float scale = static_cast<float>(count) * 0.99999F / (high - low);
    per_unit = high > low && scale < INFINITY ? scale : 0;
  }
  MASU_HD FragmentBins(const Boxf& box, int axis, std::int32_t count_)
      : FragmentBins(box.min[axis], box.max[axis], count_) {}
  MASU_HD std::int32_t operator()(float place) const {
    return std::clamp(static_cast<std::int32_t>((place - low) * per_unit), 0, count - 1);
  }
  // That ends a bin.
  MASU_HD float plane(std::int32_t bin) const { return low + unit * static_cast<float>(bin + 1); }
};

MASU_HD inline Boxf common(const Boxf& a, const Boxf& b) {
  return {{max(a.min.x, b.min.x), max(a.min.y, b.min.y), max(a.min.z, b.min.z)},
          {min(a.max.x, b.max.x), min(a.max.y, b.max.y), min(a.max.z, b.max.z)}};
}

// The bounds of what of a primitive lies on either side of a plane, with the margin; empty for nothing.
struct Sides {
  Boxf below, above;

  MASU_HD bool are_two() const { return !is_empty(below) && !is_empty(above); }
};
// Those of what has a box, one where it was.
MASU_HD inline void put_parts(const Sides& parts, std::uint32_t count, BinaryNode& below, BinaryNode& above) {
  above = {parts.above.min, below.index, parts.above.max, count};
  below = {parts.below.min, below.index, parts.below.max, count};
}
template <class Primitive>
MASU_HD Sides sides_with_margin(const Primitive& primitive, int axis, double plane, double margin) {
  const ClippedBounds sides = sides_of(primitive, axis, plane, plane);
  const auto part = [&](const Boxd& bounds) {
    return is_empty(bounds) ? empty_box<float>() : box_around(bounds, margin);
  };
  return {part(sides.below), part(sides.above)};
}
// Of a part that is in a box.
template <class Primitive>
MASU_HD Sides parts_of(const Primitive& primitive, int axis, double plane, double margin, const Boxf& box) {
  const Sides sides = sides_with_margin(primitive, axis, plane, margin);
  return {common(sides.below, box), common(sides.above, box)};
}

enum class SplitKind : std::uint32_t { halves, by_centre, by_space };

// How a range is split.
struct RangeSplit {
  SplitKind kind = SplitKind::halves;
  AxisSplit at{}; // numbered by the last bin that goes left
  FragmentBins along{};
  bool overlaps = false; // by so much that planes are tried

  MASU_HD bool is_left(const BinaryNode& fragment) const {
    return kind != SplitKind::halves && is_left(fragment, at.axis);
  }
  // Where its axis is known, as a constant perhaps.
  MASU_HD bool is_left(const BinaryNode& fragment, int axis) const {
    const float centre = twice_the_centre(fragment, axis);
    return kind == SplitKind::by_space ? centre < 2 * along.plane(at.number) : along(centre) <= at.number;
  }
  // By the plane; then its parts, unless one is empty.
  template <class Scene>
  MASU_HD bool divides(const Scene& scene, double margin, const BinaryNode& fragment, Sides& parts) const {
    if (kind != SplitKind::by_space || along(fragment.min[at.axis]) > at.number ||
        along(fragment.max[at.axis]) <= at.number)
      return false;
    with_primitive(scene, fragment.index, [&](const auto& primitive) {
      parts = parts_of(primitive, at.axis, along.plane(at.number), margin, fragment.box());
    });
    return parts.are_two();
  }
};

} // namespace masu
