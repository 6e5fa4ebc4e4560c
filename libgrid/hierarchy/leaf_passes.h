// A hierarchy's leaves: primitives along a Morton curve, and triangles divided whose boxes are mostly empty
// (after Karras & Aila, "Fast Parallel Construction of High-Quality Bounding Volume Hierarchies", HPG 2013),
// on whatever executor (executor.h):
//
//   1. divider  how many parts a triangle's empty space is worth, by the size of all boxes
//   2. emit     leaves of parts, cut at planes that halve the space again and again: neighbours are cut by
//               the same
//
// No byte of the result depends on the executor or its number of threads.
#pragma once

#include "libgrid/grid/overlap/clipped_bounds.h"
#include "libgrid/hierarchy/binary/large_leaves.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace masu {

// The bits of a number below 2^14, each followed by two zeros.
MASU_HD inline std::uint64_t spread_bits(std::uint32_t number) {
  std::uint64_t bits = number;
  bits = (bits | bits << 16) & 0x0000ff0000ffULL;
  bits = (bits | bits << 8) & 0x00f00f00f00fULL;
  bits = (bits | bits << 4) & 0x0c30c30c30c3ULL;
  return (bits | bits << 2) & 0x249249249249ULL;
}

// A plane across an axis.
struct CutPlane {
  int axis;
  double place;
};

struct MortonCurve {
  static constexpr int bits_per_axis = 14;
  static constexpr double places = 1 << bits_per_axis;

  Vec3d origin;
  double step; // from place to place

  MASU_HD explicit MortonCurve(const Boxd& space) : origin(space.min) {
    const Vec3d extent = space.max - space.min;
    step = max(max(extent.x, extent.y), extent.z) / places;
  }
  MASU_HD std::uint32_t place(double at, int axis) const {
    const double steps = (at - origin[axis]) / step;
    return steps > 0 ? static_cast<std::uint32_t>(std::min(steps, places - 1)) : 0;
  }
  // Of a box's middle: so many bits, the highest ones.
  MASU_HD std::uint64_t code(const Boxf& box, int bits) const {
    std::uint64_t code = 0;
    for (int axis = 0; axis < 3; ++axis)
      code |= spread_bits(place(0.5 * (static_cast<double>(box.min[axis]) + box.max[axis]), axis)) << axis;
    return code >> (3 * bits_per_axis - bits);
  }
  // Across the middle half of a box's longest side: the first of the planes that halve the space, its halves,
  // and so on.
  MASU_HD CutPlane plane_across(const Boxf& box) const {
    const Vec3f side = box.max - box.min;
    const int axis = side.x >= side.y && side.x >= side.z ? 0 : side.y >= side.z ? 1 : 2;
    const double low = box.min[axis] + 0.25 * side[axis], high = box.min[axis] + 0.75 * side[axis];
    const std::uint32_t last = place(high, axis), differing = place(low, axis) ^ last;
    std::uint32_t bit = 0;
    while (differing >> bit > 1)
      ++bit;
    return {axis, differing == 0 ? (low + high) / 2 : origin[axis] + (last >> bit << bit) * step};
  }
};

// Leaves so many times as wide as all boxes are in the mean come first, wherever they are: where not all are
// looked at, those are (top_down_passes.h).
inline constexpr double largest_width = 16;

// Of a leaf's place along the curve. The order matters where few of many leaves are looked at (leaf_split.h):
// so far apart these are told from each other. More bits are sorted in more passes.
inline constexpr int order_bits = 31;

// Cuts of a primitive whose empty space is as wide as all boxes are in the mean.
inline constexpr double cuts_per_width = 0.7;
inline constexpr std::uint32_t max_cuts_log2 = 6, max_cuts = (1U << max_cuts_log2) - 1;

// Emits pairs of a part's place in the order, and its leaf.
template <class Scene>
struct Divider { // NOLINT(cppcoreguidelines-pro-type-member-init): an aggregate
  Scene scene;
  double margin;
  MortonCurve curve;
  double mean_width; // of all boxes

  template <class Add>
  MASU_HD void operator()(std::uint64_t i, std::uint64_t, std::uint64_t, const Add& add) const {
    const auto index = static_cast<PrimitiveIndex>(i);
    with_primitive(scene, index, [&](const auto& primitive) {
      if (!has_surface(primitive)) return;
      for_each_part(primitive, [&](const Boxf& box) {
        const std::uint64_t is_small = std::sqrt(half_area(cast<double>(box))) < largest_width * mean_width;
        add(is_small << order_bits | curve.code(box, order_bits), BinaryNode{box.min, index, box.max, 1});
      });
    });
  }

private:
  // How wide what is empty of a primitive's box is where dividing it would help: nothing for triangles whose
  // projections along the axes fill a third of their box's sides, as those of compact ones do and of all
  // along two axes, however they are cut; nor for others.
  MASU_HD double empty_width(const Triangle<double>& triangle) const {
    constexpr double most_filled = 0.3;
    const Vec3d normal = cross(triangle.b - triangle.a, triangle.c - triangle.a);
    const double whole = half_area(bounds(triangle)),
                 filled = (std::abs(normal.x) + std::abs(normal.y) + std::abs(normal.z)) / 2;
    return filled > 0 && filled < most_filled * whole ? std::sqrt(whole - filled) : 0;
  }
  template <class Primitive>
  MASU_HD double empty_width(const Primitive&) const {
    return 0;
  }
  // Calls act(box) for each part of a primitive.
  template <class Primitive, class Act>
  MASU_HD void for_each_part(const Primitive& primitive, const Act& act) const {
    struct Part {
      Boxf box;
      std::uint32_t cuts;
    } stack[max_cuts_log2 + 1];
    const Boxf whole = box_around(bounds(primitive), margin);
    const double own = empty_width(primitive),
                 cuts = own > 0 ? std::min(cuts_per_width * own / mean_width, double{max_cuts}) : 0;
    if (cuts < 1) return act(whole); // most are: without the stack, from which they would be read at once
    stack[0] = {whole, static_cast<std::uint32_t>(cuts)};
    for (int height = 1; height > 0;) {
      const Part part = stack[--height];
      Sides sides{};
      if (part.cuts > 0) {
        const CutPlane plane = curve.plane_across(part.box);
        sides = parts_of(primitive, plane.axis, plane.place, margin, part.box);
      }
      if (part.cuts == 0 || !sides.are_two()) {
        act(part.box);
        continue;
      }
      const float low = largest_magnitude(sides.below.max - sides.below.min),
                  high = largest_magnitude(sides.above.max - sides.above.min);
      const float share = low > 0 ? low / (low + high) : 0;
      const std::uint32_t cuts_below =
          std::min(static_cast<std::uint32_t>(static_cast<float>(part.cuts) * share), part.cuts - 1);
      const Part below{sides.below, cuts_below}, above{sides.above, part.cuts - 1 - cuts_below};
      // The one of more cuts waits: so each that waits has at most half of the cuts of the one before.
      stack[height++] = below.cuts > above.cuts ? below : above;
      stack[height++] = below.cuts > above.cuts ? above : below;
    }
  }
};

// Of boxes of primitives that have a surface.
struct WidthSum {
  double width = 0, area = 0;
  std::uint64_t count = 0;
};
MASU_HD inline WidthSum join(const WidthSum& a, const WidthSum& b) {
  return {a.width + b.width, a.area + b.area, a.count + b.count};
}

template <class Executor, class Scene>
HierarchyLeaves<Executor> hierarchy_leaves(Executor& executor, const Scene& scene, const GridLayout& layout) {
  const std::uint64_t primitives = scene.primitive_count();
  const auto sum = joined_in_order<WidthSum>(executor, primitives, [=] MASU_PASS(std::uint64_t i) {
    WidthSum width;
    with_primitive(scene, static_cast<PrimitiveIndex>(i), [&](const auto& primitive) {
      const double area = half_area(bounds(primitive));
      if (has_surface(primitive)) width = {std::sqrt(area), area, 1};
    });
    return width;
  });
  const double mean_width = static_cast<float>(sum.width / static_cast<double>(sum.count));
  const Divider<Scene> divider{scene, layout.margin, MortonCurve(layout.space), mean_width};
  auto sorted = executor.template emit_sorted<BinaryNode>(primitives, order_bits + 1, max_numbered, divider);
  HierarchyLeaves<Executor> made{std::move(sorted->values)};
  if (sum.area > least_spread * mean_width * sum.width) {
    const double width = large_width * mean_width;
    made.large = {layout.margin, static_cast<float>(width * width), scene.triangle_count,
                  static_cast<std::uint32_t>(spare_parts * static_cast<double>(made.leaves.size()))};
  }
  return made;
}

} // namespace masu
