// Ray and the side of a truncated cone or a cylinder; its bounds.
//
// With z from 0 (base) to 1 (apex) along the axis, the side is where the distance ρ from the axis equals the
// radius R(z). Distances from the axis are lengths of cross products with it, whose components are accurate
// (Kahan's differences of products) even for a ray nearly parallel to it. The quadratic ρ² = R² is set up
// about the point between the ends where ρ² + R² is smallest: there all terms are of the size of the
// solution, so that nothing cancels, however far away the origin, however slight the taper, however near a
// pointed end. Radii are multiplied by a height, which saves a division.
#pragma once

#include "libscene/geometry/ray.h"

#include <algorithm>

namespace masu {

// A cone by its axis. The radius grows from |base_radius| by `growth`.
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

// Whether only the inside is visible.
template <class Stored>
MASU_HD inline bool is_inside_out(const Cone<Stored>& cone) {
  return cone.base_radius < 0 || cone.apex_radius < 0;
}

// Calls act(t, front) where the ray meets the side at a t > 0, in order along the ray, until that returns
// true; `front`: it meets the side's front. may_taper = false is for cylinders alone, with the same results
// in less time.
template <bool may_taper = true, class Real, class Stored, class Act>
MASU_HD inline void each_hit(const PreparedRay<Real>& ray, const Cone<Stored>& cone, const Act& act) {
  const Vec3<Real> whole = cast<Real>(cone.apex) - cast<Real>(cone.base);
  const Vec3<Real> origin = ray.origin - cast<Real>(cone.base);
  const Real base = std::abs(static_cast<Real>(cone.base_radius)),
             apex = std::abs(static_cast<Real>(cone.apex_radius));
  // The axis, and later all lengths, are scaled by powers of two so that no product overflows or underflows.
  const Real longest = largest_magnitude(whole), shrink = inverse_power_of_two(longest);
  const Vec3<Real> axis = whole * shrink;

  // The distance between the lines of ray and axis: most tests end here.
  const Vec3<Real> turn = cross(ray.direction, axis);
  const Real turn_square = dot(turn, turn), separation = dot(origin, turn), widest = fast_max(base, apex);
  if (separation * separation > widest * widest * turn_square) return;
  // Most others end with one of two more tests. `leaves`: the ray is outside and moves away from the axis, as
  // when it leaves this very surface; one that counts as outside only by rounding is within the margin of the
  // surface. `passes`: its line misses the bounding sphere, enlarged for rounding, as when it passes an end.
  const Real square = dot(axis, axis);
  const Vec3<Real> moment = rough_cross(origin, axis);
  const Real outward = dot(moment, turn);
  const bool leaves = (outward >= 0) & (dot(moment, moment) > widest * widest * square);
  constexpr Real roundings = 64 * RealTraits<Real>::unit_roundoff;
  const Vec3<Real> from_middle = fma(whole, Real(-0.5), origin);
  const Vec3<Real> past =
      fma(ray.direction, -(dot(from_middle, ray.direction) * ray.inverse_square), from_middle);
  const Real bounding_square = fma(widest, widest, dot(whole, whole) / 4);
  const bool passes = dot(past, past) > fma(roundings * roundings, dot(from_middle, from_middle),
                                            bounding_square + bounding_square / 256);
  if (leaves | passes) return;

  // At t the height along the axis is z + t dz, from 0 (base) to `top` (apex); the distance ρ from the axis
  // is |from_base × axis + t turn| / |axis|, and the cone's radius R is (r + t dr) / rise. The growth of R
  // and the height over which it grows are scaled together. For a cylinder the growth is 0 and `rise` is 1:
  // so may_taper doesn't change the bits of its hits.
  const Real unit = inverse_power_of_two(fast_max(longest, widest));
  const Vec3<Real> from_base = origin * unit;
  const Real base_radius = base * unit, top = dot(whole, axis) * unit;
  const Real z = dot(from_base, axis), dz = dot(ray.direction, axis);
  Real rise_square = 1, base_rise = base_radius, turn_rise = turn_square;
  Real widening = 0, dr = 0, dr_square = 0;
  Real bend = turn_square, pull = outward * unit;
  if constexpr (may_taper) {
    const Real growth = apex * unit - base_radius;
    const Real size = inverse_power_of_two(fast_max(top, std::abs(growth)));
    const Real rise = growth != 0 ? top * size : 1;
    rise_square = rise * rise;
    base_rise = base_radius * rise;
    turn_rise = turn_square * rise_square;
    widening = growth * size;
    dr = widening * dz;
    dr_square = square * dr;
    bend = fma(dr_square, dr, turn_rise);
    pull = fma(dr_square, fma(widening, z, base_rise), rise_square * pull);
  }

  // Where ρ² + R² is smallest between the ends, up to the rounding of heights: at its minimum,
  // t = -pull / bend, or at the nearer end if that is beyond the ends.
  const Real distance = sum_of_magnitudes(from_base);
  const Real middle = top / 2, within = fma(roundings, distance + top, middle);
  const Real above_middle = fma(z - middle, bend, -(pull * dz)); // times bend
  const bool beyond = std::abs(above_middle) > within * bend;
  const Real start =
      fast_divide(beyond ? middle + std::copysign(within, above_middle) - z : -pull, beyond ? dz : bend);
  // A ray nearly perpendicular to the axis may come between the ends' planes only far away, where rounding
  // errors are larger than the cone. But neither a hit nor `start` is farther away than the cone (its length
  // is less than twice its longest component) and √2 times its radius.
  const Real reach = Real(1.5) * fma(2 * longest + widest, unit, distance);
  const Real speed = largest_magnitude(ray.direction);

  // With t = start + s: a s² + 2 b s + c = 0.
  const Vec3<Real> there = fma(ray.direction, start, from_base);
  const Vec3<Real> off = rough_cross(there, axis);
  const Real height = dot(there, axis);
  Real radius = base_radius, a = turn_square, b = dot(off, turn), c = dot(off, off);
  if constexpr (may_taper) {
    radius = fma(widening, height, base_rise);
    a = fma(-dr_square, dr, turn_rise);
    b = fma(-radius, dr_square, rise_square * b);
    c = rise_square * c;
  }
  c = fma(-square * radius, radius, c);
  const Real discriminant = fma(b, b, -(a * c));
  if (!((discriminant >= 0) & (std::abs(start) * speed <= reach))) return;
  const Real magnitude = std::sqrt(discriminant);
  const Real root = b < 0 ? -magnitude : magnitude; // the same for b = 0 and -0
  const Real q = -(b + root);

  // For a flat cone (|growth| > height) the rounding error of a height can exceed the cone's height: whether
  // a hit is between the ends is decided by ρ.
  const bool flat = may_taper && widening * widening * square > rise_square;
  const auto is_hit = [&](Real step) {
    const Real at = start + step, up = fma(step, dz, height);
    bool between = (up >= 0) & (up <= top);
    if (flat) {
      const Vec3<Real> out = fma(turn, step, off);
      const Real rho_square = dot(out, out); // times |axis|²
      const Real narrow = fast_min(base, apex) * unit, wide = widest * unit;
      between = std::abs(up - middle) <= within && fma(step, dr, radius) >= 0 &&
                rho_square >= narrow * narrow * square && rho_square <= wide * wide * square;
    }
    return (at > 0) & (at * speed <= reach) & between;
  };
  // The roots are q / a and c / q, tried in their order along the ray. The ray leaves the solid where
  // a s + b > 0; this is -root for the first and root for the second.
  bool by_a = std::signbit(root) == (a < 0);
  int tries = 2;
  const bool inside_out = is_inside_out(cone);
  if (inside_out) {
    by_a = std::signbit(root);
    tries = 1;
  }
  for (; tries > 0; --tries, by_a = !by_a) {
    const Real step = fast_divide(by_a ? q : c, by_a ? a : q);
    if (!is_hit(step)) continue;
    const Real t = (start + step) * inverse_power_of_two(unit);
    const bool exits = by_a == std::signbit(root);
    if (act(t, exits == inside_out)) return;
  }
}

// Whether the ray meets the side at a t > t_min; then `t` is the nearest.
template <bool may_taper = true, class Real, class Stored>
MASU_HD inline bool intersect(const PreparedRay<Real>& ray, const Cone<Stored>& cone, Real t_min, Real& t) {
  bool met = false;
  each_hit<may_taper>(ray, cone, [&](Real nearest, bool) {
    t = nearest;
    return met = nearest > t_min; // 0, where it underflows, isn't
  });
  return met;
}

// How far a disc across an axis reaches, in its radii.
MASU_HD inline Vec3d disc_reach(const Vec3d& axis) {
  const double square = dot(axis, axis);
  Vec3d reach{};
  for (int i = 0; i < 3; ++i) {
    const double along1 = axis[(i + 1) % 3], along2 = axis[(i + 2) % 3];
    reach.set(i, std::sqrt((along1 * along1 + along2 * along2) / square));
  }
  return reach;
}

// The bounds of a disc, rounded outwards.
MASU_HD inline Boxd disc_bounds(const Vec3d& center, double radius, const Vec3d& reach) {
  const Vec3d side = reach * radius * (1 + 1e-14);
  return {center - side, center + side};
}

// Of both end discs.
template <class Stored>
MASU_HD inline Boxd bounds(const Cone<Stored>& cone) {
  const Vec3d base = cast<double>(cone.base), apex = cast<double>(cone.apex), reach = disc_reach(apex - base);
  return join(disc_bounds(base, std::abs(static_cast<double>(cone.base_radius)), reach),
              disc_bounds(apex, std::abs(static_cast<double>(cone.apex_radius)), reach));
}

} // namespace masu
