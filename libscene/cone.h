// Ray and the side of a cut-off cone or a cylinder; its bounds.
//
// With z from 0 (base) to 1 (apex) along the axis, the side is where the distance ρ from the axis equals the
// radius R(z). The quadratic ρ² = R² is set up about the place on the ray where ρ² + R² is least of those
// that can matter: there every term is of the size of what is solved for, so nothing cancels however far the
// origin is, however slight the taper, however near a pointed end. It is solved in double: nearly parallel
// sides square their small differences.
#pragma once

#include "libscene/ray.h"

#include <algorithm>

namespace masu {

// The cone as the quadratic needs it. Radii are magnitudes.
template <class Wide>
struct ConeAxis {
  Vec3<Wide> base, axis; // axis: from base to apex
  Wide inverse_square;   // 1 / |axis|²
  Wide base_radius, growth;
};

template <class Stored>
MASU_HD inline ConeAxis<double> cone_axis(const Cone<Stored>& cone) {
  const Vec3d base = cast<double>(cone.base);
  const Vec3d axis = cast<double>(cone.apex) - base;
  const double base_radius = std::abs(static_cast<double>(cone.base_radius));
  const double apex_radius = std::abs(static_cast<double>(cone.apex_radius));
  return {base, axis, 1.0 / dot(axis, axis), base_radius, apex_radius - base_radius};
}

// Only the inside shows.
template <class Stored>
MASU_HD inline bool is_inside_out(const Cone<Stored>& cone) {
  return cone.base_radius < 0 || cone.apex_radius < 0;
}

// Whether a line stays farther from the axis' line than `radius`, by more than rounding: most tests end here.
// Nearly parallel lines are never said to.
MASU_HD inline bool passes_by(const Vec3d& from_base, const Vec3d& direction, const Vec3d& axis,
                              double radius) {
  const Vec3d n{direction.y * axis.z - direction.z * axis.y, direction.z * axis.x - direction.x * axis.z,
                direction.x * axis.y - direction.y * axis.x};
  const double square = dot(n, n), sizes = dot(direction, direction) * dot(axis, axis);
  const double apart = std::abs(dot(from_base, n)) - 1e-13 * std::sqrt(dot(from_base, from_base) * sizes);
  return square > 1e-12 * sizes && apart > 0 && apart * apart > radius * radius * square * (1 + 1e-9);
}

// Whether the ray meets the side at a t > 0; then `t` is the first such place.
template <class Real, class Stored>
MASU_HD inline bool intersect(const RayFrame<Real>& ray, const Cone<Stored>& cone, Real& t) {
  const ConeAxis<double> c = cone_axis(cone);
  const Vec3d direction = cast<double>(ray.direction);
  const Vec3d from_base = cast<double>(ray.origin) - c.base;
  const double widest = larger(c.base_radius, c.base_radius + c.growth);
  if (passes_by(from_base, direction, c.axis, widest)) return false;
  // The direction, split: dz along the axis, `across` perpendicular to it.
  const double dz = dot(direction, c.axis) * c.inverse_square;
  const Vec3d across = fused(c.axis, -dz, direction);
  const double across_square = dot(across, across);
  const double z_origin = dot(from_base, c.axis) * c.inverse_square;

  // Where a hit can be: between the ends, and no farther off than they are. A ray all but across the axis
  // comes between the ends' planes only far away, where every digit would be lost.
  const double reach = 2 * (length(from_base) + length(c.axis) + widest) / length(direction);
  double low = -reach, high = reach;
  if (dz != 0) {
    const double to_base = -z_origin / dz, to_apex = (1 - z_origin) / dz;
    low = larger(low, smaller(to_base, to_apex));
    high = smaller(high, larger(to_base, to_apex));
  }
  if (!(low <= high)) return false;

  // a s² + 2 b s + c = 0 for the step s from the place where its terms are least, which may lie beyond the
  // ends.
  const double radius_slope = c.growth * dz;
  const double qa = fused(-radius_slope, radius_slope, across_square);
  double start = 0, z = 0, radius = 0, qb = 0, least = RealTraits<double>::largest;
  Vec3d off_axis{};
  const auto look_from = [&](double at) {
    const Vec3d there = fused(direction, at, from_base);
    const double z_there = dot(there, c.axis) * c.inverse_square;
    const Vec3d off = fused(c.axis, -z_there, there);
    const double radius_there = fused(c.growth, z_there, c.base_radius);
    const double size = fused(radius_there, radius_there, dot(off, off));
    if (!(size < least)) return;
    least = size;
    start = at;
    z = z_there;
    off_axis = off;
    radius = radius_there;
    qb = fused(-radius_slope, radius, dot(off_axis, across));
  };
  look_from(low);
  look_from(high);
  const double nearest = across_square > 0 ? -dot(from_base, across) / across_square : 0;
  if (std::abs(nearest) <= reach) look_from(nearest);
  const double middle = start - qb / qa; // between the two roots; near a pointed end, both lie by it
  if (std::abs(middle) <= reach) look_from(middle);
  const double qc = fused(-radius, radius, dot(off_axis, off_axis));
  const double discriminant = difference_of_products(qb, qb, qa, qc);
  if (!(discriminant >= 0)) return false;
  const double q = -(qb + std::copysign(std::sqrt(discriminant), qb));
  const double root1 = q / qa, root2 = qc / q;
  const bool inside_only = is_inside_out(cone);
  bool met = false;
  double first = RealTraits<double>::largest;
  for (int root = 0; root < 2; ++root) {
    const double s = root == 0 ? root1 : root2;
    const double along = start + s;
    const double height = fused(s, dz, z);
    // Positive where the ray leaves the solid.
    const bool leaving = fused(qa, s, qb) > 0;
    if (!(along > 0) || !(along < first) || !(height >= 0 && height <= 1) || (inside_only && !leaving))
      continue;
    first = along;
    met = true;
  }
  t = static_cast<Real>(first);
  return met && t > 0;
}

// Both end discs', exactly but for rounding, which is made good outwards.
template <class Stored>
inline Boxd bounds(const Cone<Stored>& cone) {
  const Vec3d base = cast<double>(cone.base), apex = cast<double>(cone.apex);
  const Vec3d axis = apex - base;
  const double square = dot(axis, axis);
  Boxd box = empty_box<double>();
  for (int end = 0; end < 2; ++end) {
    const Vec3d center = end == 0 ? base : apex;
    const double radius = std::abs(static_cast<double>(end == 0 ? cone.base_radius : cone.apex_radius));
    Vec3d reach{};
    for (int axis_number = 0; axis_number < 3; ++axis_number) {
      const double along1 = axis[(axis_number + 1) % 3], along2 = axis[(axis_number + 2) % 3];
      reach.set(axis_number, radius * std::sqrt((along1 * along1 + along2 * along2) / square) * (1 + 1e-14));
    }
    box = join(box, Boxd{center - reach, center + reach});
  }
  return box;
}

} // namespace masu
