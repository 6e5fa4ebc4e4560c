// Ray and the side of a cut-off cone or a cylinder; its bounds.
//
// With z from 0 (base) to 1 (apex) along the axis, the side is where the distance ρ from the axis equals the
// radius R(z). Distances from the axis are lengths of cross products with it, whose components keep their
// digits (Kahan's differences of products) however nearly parallel the ray runs. The quadratic ρ² = R² is set
// up about the place between the ends where ρ² + R² is least: there every term is of the size of what is
// solved for, so that nothing cancels however far the origin is, however slight the taper, however near a
// pointed end.
#pragma once

#include "libscene/ray.h"

#include <algorithm>

namespace masu {

// The cone as its surface needs it. Radii are magnitudes.
template <class Real>
struct ConeAxis {
  Vec3<Real> base, axis; // axis: from base to apex
  Real inverse_square;   // 1 / |axis|²
  Real base_radius, growth;
};

template <class Real, class Stored>
MASU_HD inline ConeAxis<Real> cone_axis(const Cone<Stored>& cone) {
  const Vec3<Real> base = cast<Real>(cone.base), axis = cast<Real>(cone.apex) - base;
  const Real base_radius = std::abs(static_cast<Real>(cone.base_radius));
  return {base, axis, 1 / dot(axis, axis), base_radius,
          std::abs(static_cast<Real>(cone.apex_radius)) - base_radius};
}

// Only the inside shows.
template <class Stored>
MASU_HD inline bool is_inside_out(const Cone<Stored>& cone) {
  return cone.base_radius < 0 || cone.apex_radius < 0;
}

// Whether the ray meets the side at a t > 0; then `t` is the first such place.
template <class Real, class Stored>
MASU_HD inline bool intersect(const RayFrame<Real>& ray, const Cone<Stored>& cone, Real& t) {
  const Vec3<Real> whole = cast<Real>(cone.apex) - cast<Real>(cone.base);
  const Vec3<Real> origin = ray.origin - cast<Real>(cone.base);
  const Real base = std::abs(static_cast<Real>(cone.base_radius)),
             apex = std::abs(static_cast<Real>(cone.apex_radius));
  // Scaled by powers of two, so that no product leaves the range: the axis, and later all lengths.
  const Vec3<Real> axis = whole * inverse_power_of_two(largest_magnitude(whole));

  // How far apart the ray's line and the axis' are: most tests end here.
  const Vec3<Real> turn = cross(ray.direction, axis);
  const Real turn_square = dot(turn, turn), apart = dot(origin, turn), widest = larger(base, apex);
  if (apart * apart > widest * widest * turn_square) return false;
  // Of the rest, most end with one more look. The ray is outside and moves away from the axis, as where it
  // leaves this very surface: whoever is taken for outside by a rounding alone is within the margin of it. Or
  // its line passes by the ball around the cone, with room for rounding, as where it passes one end.
  const Real square = dot(axis, axis);
  const Vec3<Real> beside = rough_cross(origin, axis);
  if (dot(beside, turn) >= 0 && dot(beside, beside) > widest * widest * square) return false;
  constexpr Real roundings = 64 * RealTraits<Real>::unit_roundoff;
  const Vec3<Real> from_middle = fused(whole, Real(-0.5), origin);
  const Vec3<Real> past =
      fused(ray.direction, -(dot(from_middle, ray.direction) * ray.inverse_square), from_middle);
  const Real ball = fused(widest, widest, dot(whole, whole) / 4);
  if (dot(past, past) > fused(roundings * roundings, dot(from_middle, from_middle), ball + ball / 256))
    return false;

  const Real unit =
      inverse_power_of_two(larger(largest_magnitude(origin), larger(largest_magnitude(whole), widest)));
  const Vec3<Real> from_base = origin * unit;
  const Real base_radius = base * unit, growth = apex * unit - base_radius;

  // At t the height along the axis is z + t dz, from 0 (base) to `top` (apex); the distance ρ from the axis
  // is |from_base × axis + t turn| / |axis|, and the cone's radius R is r + t dr.
  const Real top = dot(whole, axis) * unit, slope = growth / top;
  const Real z = dot(from_base, axis), dz = dot(ray.direction, axis);
  const Real r = fused(slope, z, base_radius), dr = slope * dz, dr_square = square * dr;

  // Where ρ² + R² is least between the ends, give or take a rounding of heights: where it is least anywhere
  // (Lagrange's identity gives the product of the cross products), or else at the nearer end.
  const Real distance = sum_of_magnitudes(from_base);
  const Real doubt = 64 * RealTraits<Real>::unit_roundoff * (distance + top), lowest = -doubt,
             highest = top + doubt;
  const Real bend = fused(dr_square, dr, turn_square);
  const Real pull = fused(dr_square, r, fused(dot(from_base, ray.direction), square, -(z * dz)));
  const Real z_bend = fused(z, bend, -(pull * dz));
  const bool below = z_bend<lowest * bend, above = z_bend> highest * bend;
  const Real start = (below ? lowest - z : above ? highest - z : -pull) / (below || above ? dz : bend);
  // A ray all but across the axis comes between the ends' planes only far away, where every digit is lost;
  // but neither a hit nor that place is farther off than the cone and √2 times its radius.
  const Real reach = Real(1.5) * fused(sum_of_magnitudes(whole) + widest, unit, distance);
  const Real speed = largest_magnitude(ray.direction);
  if (!(std::abs(start) * speed <= reach)) return false;

  // From there, a s² + 2 b s + c = 0.
  const Vec3<Real> there = fused(ray.direction, start, from_base);
  const Vec3<Real> off = rough_cross(there, axis);
  const Real height = dot(there, axis), radius = fused(slope, height, base_radius);
  const Real a = fused(-dr_square, dr, turn_square), b = fused(-radius, dr_square, dot(off, turn)),
             c = fused(-square * radius, radius, dot(off, off));
  const Real discriminant = fused(b, b, -(a * c));
  if (!(discriminant >= 0)) return false;
  const Real root = std::copysign(std::sqrt(discriminant), b);
  const Real q = -(b + root);
  const Real step1 = q / a, step2 = c / q;

  // A flat cone's ends are told apart by their radii, of which the quadratic knows the squares: rounding may
  // leave more of a height than it is high.
  const bool flat = growth * growth * square > top * top;
  const auto shows = [&](Real step, bool leaves) {
    const Real at = start + step, up = fused(step, dz, height);
    bool between = up >= (flat ? lowest : 0) && up <= (flat ? highest : top);
    if (flat) {
      const Real rho = length(fused(turn, step, off)) / std::sqrt(square);
      const Real share = (std::copysign(rho, fused(step, dr, radius)) - base_radius) / growth;
      between = between && share >= 0 && share <= 1;
    }
    return at > 0 && at * speed <= reach && between && (leaves || !is_inside_out(cone));
  };
  // The ray leaves the solid where a s + b > 0, which is -root after one step and root after the other.
  const bool shows1 = shows(step1, std::signbit(root)), shows2 = shows(step2, !std::signbit(root));
  t = (start + (shows1 && (!shows2 || step1 < step2) ? step1 : step2)) * inverse_power_of_two(unit);
  return (shows1 || shows2) && t > 0;
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
