// The surface where a ray hit it: where exactly, facing which way, and how uncertain that is.
//
// The point isn't taken from the ray (whose t is rounded) but put back onto the primitive, after Wächter &
// Binder, "A Fast and Robust Method for Avoiding Self-Intersection", Ray Tracing Gems, chapter 6, 2019. What
// then remains is the rounding of coordinates and of the next ray's test of the same primitive: rays that
// leave start that far off, whatever the scale.
#pragma once

#include "libscene/geometry/clip.h"
#include "libscene/geometry/intersect.h"
#include "libscene/geometry/surface_point.h"
#include "libscene/geometry/textbook_surface.h"

namespace masu {

// Of a primitive that reaches `extent` from the origin: subtracting the ray's origin from a vertex and
// projecting it moves it by less than 60 u extent (see margin.h), the point itself is off by 4 u extent.
template <class Real>
MASU_HD inline Real surface_error(Real extent) {
  return 64 * RealTraits<Real>::unit_roundoff * extent;
}

template <class Real>
MASU_HD inline Vec3<Real> mean(const EdgeFunctions<Real>& shares, const Vec3<Real>& a, const Vec3<Real>& b,
                               const Vec3<Real>& c) {
  return fma(a, shares.a, fma(b, shares.b, c * shares.c));
}

template <class Real, class Stored>
MASU_HD inline SurfacePoint<Real> surface_at(const SceneView<Stored>& scene, const WatertightRay<Real>& ray,
                                             Real, const Triangle<Stored>& triangle) {
  const Vec3<Real> a = cast<Real>(triangle.a), b = cast<Real>(triangle.b), c = cast<Real>(triangle.c);
  const EdgeFunctions<Real> weights = edge_functions(ray, a - ray.origin, b - ray.origin, c - ray.origin);
  // Where the weights all underflow the middle is as good as any place.
  const Real sum = weights.a + weights.b + weights.c;
  const Real third = Real(1) / 3;
  const Real inverse = 1 / sum;
  const EdgeFunctions<Real> shares =
      std::abs(inverse) <= RealTraits<Real>::largest
          ? EdgeFunctions<Real>{weights.a * inverse, weights.b * inverse, weights.c * inverse}
          : EdgeFunctions<Real>{third, third, third};
  SurfacePoint<Real> point{};
  point.position = mean(shares, a, b, c);
  // A needle so thin that its edges, rounded, are parallel faces the ray.
  const Vec3<Real> across = cross(b - a, c - a);
  point.normal = normalized(largest_magnitude(across) > 0 ? across : -ray.direction);
  point.shading = point.normal;
  if (triangle.normals != no_normals) {
    const CornerNormals<Stored>& n = scene.normals[triangle.normals];
    const Vec3<Real> between =
        mean(shares, normalized(cast<Real>(n.a)), normalized(cast<Real>(n.b)), normalized(cast<Real>(n.c)));
    // Opposite corners can cancel out.
    if (largest_magnitude(between) > 0) point.shading = normalized(between);
  }
  point.error = surface_error(max(largest_magnitude(a), max(largest_magnitude(b), largest_magnitude(c))));
  point.material = static_cast<std::uint32_t>(triangle.material);
  return point;
}

template <class Real, class Stored>
MASU_HD inline SurfacePoint<Real> surface_at(const SceneView<Stored>& scene, const PreparedRay<Real>& ray,
                                             Real t, const Triangle<Stored>& triangle) {
  return surface_at(scene, prepare_watertight(ray), t, triangle);
}

template <class Real, class Stored>
MASU_HD inline SurfacePoint<Real> surface_at(const PreparedRay<Real>& ray, Real t,
                                             const Sphere<Stored>& sphere) {
  const Vec3<Real> center = cast<Real>(sphere.center);
  const Real radius = std::abs(static_cast<Real>(sphere.radius));
  const Vec3<Real> from_center = fma(ray.direction, t, ray.origin) - center;
  // A sphere smaller than an ulp of its place has no better direction than back.
  const Vec3<Real> outwards = normalized(largest_magnitude(from_center) > 0 ? from_center : -ray.direction);
  SurfacePoint<Real> point{};
  point.position = fma(outwards, radius, center);
  point.normal = sphere.radius < 0 ? -outwards : outwards;
  point.shading = point.normal;
  point.error = surface_error(largest_magnitude(center) + radius);
  return point;
}

template <class Real, class Stored>
MASU_HD inline SurfacePoint<Real> surface_at(const PreparedRay<Real>& ray, Real t, const Cone<Stored>& cone) {
  const ConeAxis<Real> c = cone_axis<Real>(cone);
  const Vec3<Real> from_base = fma(ray.direction, t, ray.origin - c.base);
  const Real anywhere = dot(from_base, c.axis) * c.inverse_square;
  Vec3<Real> off_axis = fma(c.axis, -anywhere, from_base);
  Real distance = length(off_axis);
  const Real doubt = 16 * RealTraits<Real>::unit_roundoff *
                     (length(from_base) + largest_magnitude(c.base) + largest_magnitude(c.base + c.axis));
  // By a pointed end rounding leaves no direction: the side that the ray comes to is as good as any.
  if (distance <= doubt) {
    const Vec3<Real> against = -ray.direction;
    off_axis = fma(c.axis, -dot(against, c.axis) * c.inverse_square, against);
    if (!(dot(off_axis, off_axis) > Real(1e-6) * dot(against, against)))
      off_axis = std::abs(c.axis.x) < std::abs(c.axis.y) ? Vec3<Real>{0, c.axis.z, -c.axis.y}
                                                         : Vec3<Real>{-c.axis.z, 0, c.axis.x};
    distance = 0;
  }
  const Vec3<Real> aside = normalized(off_axis);
  // Once more, for what rounding left along the axis.
  const Vec3<Real> away = normalized(fma(c.axis, -dot(aside, c.axis) * c.inverse_square, aside));
  // The nearest place of the side, a segment as seen over the axis: t is rounded, and what that moves a flat
  // cone's point along the axis may be more than its length.
  const Real square = dot(c.axis, c.axis);
  const Real place =
      ((distance - c.base_radius) * c.growth + anywhere * square) / fma(c.growth, c.growth, square);
  const Real z = max(min(place, Real(1)), Real(0));
  const Real radius = fma(c.growth, z, c.base_radius);
  const Vec3<Real> outwards = normalized(fma(c.axis, -c.growth * c.inverse_square, away));
  SurfacePoint<Real> point{};
  point.position = c.base + fma(away, radius, c.axis * z);
  point.normal = is_inside_out(cone) ? -outwards : outwards;
  point.shading = point.normal;
  point.error =
      surface_error(max(largest_magnitude(cast<Real>(cone.base)), largest_magnitude(cast<Real>(cone.apex))) +
                    max(c.base_radius, c.base_radius + c.growth));
  return point;
}

// Tells nothing to anybody.
struct Unasked {
  MASU_HD void triangle_test() {}
  MASU_HD void sphere_test() {}
  MASU_HD void cone_test() {}
};

// Of what a ray met.
template <unsigned kinds, class TestRay, class Stored>
MASU_HD inline SurfacePoint<typename TestRay::Real> surface_at(const SceneView<Stored>& scene,
                                                               const NearHit<TestRay>& near) {
  const PrimitiveIndex primitive = near.hit.primitive;
  if constexpr ((kinds & with_triangles) != 0) {
    if (kinds == with_triangles || primitive < scene.triangle_count)
      return surface_at(scene, near.ray, near.hit.t, scene.triangles[primitive]);
  }
  const std::uint32_t sphere = primitive - scene.triangle_count;
  SurfacePoint<typename TestRay::Real> point{};
  if constexpr ((kinds & with_spheres) != 0) {
    if ((kinds & with_cones) == 0 || sphere < scene.sphere_count) {
      point = surface_at(near.ray, near.hit.t, scene.spheres[sphere]);
      point.material = scene.sphere_surfaces[sphere].material;
      return point;
    }
  }
  if constexpr ((kinds & with_cones) != 0) {
    const std::uint32_t cone = sphere - scene.sphere_count;
    point = surface_at(near.ray, near.hit.t, scene.cones[cone]);
    point.material = scene.cone_surfaces[cone].material;
  }
  return point;
}

// Of a hit whose t counts from the ray's own origin, which may be far off and t so too coarse: the test is
// run again from where the ray enters the scene.
template <unsigned kinds, class Real, class Stored>
MASU_HD inline SurfacePoint<Real> surface_at(const SceneView<Stored>& scene, const Ray<Real>& ray,
                                             const Hit<Real>& hit) {
  ClippedRay<Real> clipped{};
  clip(ray, cast<Real>(scene.clip), clipped);
  NearHit<WatertightRay<Real>> near{{}, {hit.t - clipped.skipped, hit.primitive}, clipped.skipped};
  prepare(near.ray, clipped.ray.origin, clipped.ray.direction);
  Unasked unasked;
  intersect<kinds>(scene, near.ray, hit.primitive, near.hit.t, unasked);
  return surface_at<kinds>(scene, near);
}

} // namespace masu
