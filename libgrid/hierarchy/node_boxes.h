// Boxes of a hierarchy while it is built or refitted: in float32, and as a node holds them
// (hierarchy.h).
#pragma once

#include "libgrid/bits.h"
#include "libgrid/hierarchy/hierarchy.h"
#include "libscene/geometry/cone.h"
#include "libscene/scene_view.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace masu {

// Contains the margin around what is in `bounds`.
MASU_HD inline Boxf box_around(const Boxd& bounds, double margin) {
  const Boxd box = grown(bounds, margin);
  return {{rounded_down(box.min.x), rounded_down(box.min.y), rounded_down(box.min.z)},
          {rounded_up(box.max.x), rounded_up(box.max.y), rounded_up(box.max.z)}};
}

// The same of a primitive.
template <class Stored>
MASU_HD Boxf box_of_primitive(const SceneView<Stored>& scene, PrimitiveIndex index, double margin) {
  Boxf box = empty_box<float>();
  with_primitive(scene, index, [&](const auto& primitive) { box = box_around(bounds(primitive), margin); });
  return box;
}

// Half of the surface: what SAH compares.
template <class Real>
MASU_HD Real half_area(const Box<Real>& box) {
  const Vec3<Real> side = box.max - box.min;
  return side.x * (side.y + side.z) + side.y * side.z;
}

// Units of a node's boxes: powers of two, of which what is around them has 240 at most; it begins a few after
// the origin.
class NodeUnits {
public:
  // Writes the node's origin and exponents.
  MASU_HD NodeUnits(const Boxf& around, HierarchyNode& node) {
    std::uint32_t exponents = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double low = around.min[axis], extent = static_cast<double>(around.max[axis]) - low;
      // No smaller than the origin's rounding.
      const double least = std::max(extent / units, std::abs(low) * 0x1p-22);
      const int exponent = std::clamp(exponent_of(std::max(least, 0x1p-100)) + 1, -100, 100);
      const auto power = [](int of_two) {
        return static_cast<double>(float_of(static_cast<std::uint32_t>(of_two + 127) << 23));
      };
      per_unit_[axis] = power(-exponent);
      node.origin[axis] = rounded_down(low - units_before * power(exponent));
      exponents |= static_cast<std::uint32_t>(exponent + 127) << (8 * axis);
    }
    node.exponents = (node.exponents & ~0xffffffU) | exponents;
  }
  // Adds a slot's planes to the node's.
  MASU_HD void add_planes(int slot, const Boxf& box, HierarchyNode& node) const {
    const int shift = slot % 4 * 8;
    for (int axis = 0; axis < 3; ++axis) {
      const double origin = node.origin[axis];
      const double low = std::floor((box.min[axis] - origin) * per_unit_[axis] - slack),
                   high = std::ceil((box.max[axis] - origin) * per_unit_[axis] + slack);
      node.low[axis][slot / 4] |= static_cast<std::uint32_t>(low) << shift;
      node.high[axis][slot / 4] |= static_cast<std::uint32_t>(high) << shift;
    }
  }

private:
  // std::ilogb() of what is normal, in far less time on a device.
  MASU_HD static int exponent_of(double positive) {
    return static_cast<int>(std::bit_cast<std::uint64_t>(positive) >> 52) - 1023;
  }
  static constexpr double units = 240, units_before = 4;
  // Larger by this many units than what they hold: walk/boxes.h says why.
  static constexpr double slack = 1.0 / 64;

  double per_unit_[3]; // one through it, of a power of two exactly
};

} // namespace masu
