// The surface at a hit: position, normals, and a bound on the position's error.
//
// The point isn't computed from the ray, whose t is rounded, but projected onto the primitive, after Wächter
// & Binder, "A Fast and Robust Method for Avoiding Self-Intersection", Ray Tracing Gems, chapter 6, 2019. The
// remaining error is the rounding of the coordinates and of the next ray's test of the same primitive;
// secondary rays start that far from the surface, at any scale.
#pragma once

#include "libscene/geometry/clip.h"
#include "libscene/geometry/intersect.h"
#include "libscene/geometry/surface_point.h"
#include "libscene/geometry/textbook_surface.h"

namespace masu {

// For a primitive whose coordinates are at most `extent`: subtracting the ray's origin from a vertex and
// projecting it moves it by less than 60 u extent (see margin.h); the point's own error is 4 u extent.
template <class Real>
MASU_HD inline Real surface_error(Real extent) {
  return 64 * RealTraits<Real>::unit_roundoff * extent;
}

template <class Real>
MASU_HD inline Vec3<Real> interpolate(const EdgeFunctions<Real>& barycentric, const Vec3<Real>& a,
                                      const Vec3<Real>& b, const Vec3<Real>& c) {
  return fma(a, barycentric.a, fma(b, barycentric.b, c * barycentric.c));
}

// The barycentric coordinates of a ray's hit on a triangle: the weights of its corners, of sum 1.
template <class Real, class Stored>
MASU_HD inline EdgeFunctions<Real> barycentric(const WatertightRay<Real>& ray,
                                               const Triangle<Stored>& triangle) {
  const Vec3<Real> a = cast<Real>(triangle.a), b = cast<Real>(triangle.b), c = cast<Real>(triangle.c);
  const EdgeFunctions<Real> weights = edge_functions(ray, a - ray.origin, b - ray.origin, c - ray.origin);
  // If all weights underflow, any point of the triangle is within the error bound: its centroid.
  const Real sum = weights.a + weights.b + weights.c;
  const Real third = Real(1) / 3;
  const Real inverse = 1 / sum;
  return std::abs(inverse) <= RealTraits<Real>::largest
             ? EdgeFunctions<Real>{weights.a * inverse, weights.b * inverse, weights.c * inverse}
             : EdgeFunctions<Real>{third, third, third};
}

template <class Real, class Stored>
MASU_HD inline SurfacePoint<Real> surface_at(const SceneView<Stored>& scene, const WatertightRay<Real>& ray,
                                             Real, const Triangle<Stored>& triangle) {
  const Vec3<Real> a = cast<Real>(triangle.a), b = cast<Real>(triangle.b), c = cast<Real>(triangle.c);
  const EdgeFunctions<Real> weights = barycentric(ray, triangle);
  SurfacePoint<Real> point{};
  point.position = interpolate(weights, a, b, c);
  // The rounded edges of a very thin triangle may be parallel: its normal then points against the ray.
  const Vec3<Real> across = cross(b - a, c - a);
  point.normal = normalized(largest_magnitude(across) > 0 ? across : -ray.direction);
  point.shading = point.normal;
  if (triangle.normals != no_normals) {
    const CornerNormals<Stored>& n = scene.normals[triangle.normals];
    const Vec3<Real> between = interpolate(weights, normalized(cast<Real>(n.a)), normalized(cast<Real>(n.b)),
                                           normalized(cast<Real>(n.c)));
    // Opposite normals may sum to zero.
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
  // For a sphere smaller than an ulp of its centre's coordinates: against the ray.
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
  const Real height = dot(from_base, c.axis) * c.inverse_square; // not clamped
  Vec3<Real> off_axis = fma(c.axis, -height, from_base);
  Real distance = length(off_axis);
  const Real error = 16 * RealTraits<Real>::unit_roundoff *
                     (length(from_base) + largest_magnitude(c.base) + largest_magnitude(c.base + c.axis));
  // Near a pointed end the direction is lost to rounding: take the side that faces the ray.
  if (distance <= error) {
    const Vec3<Real> against = -ray.direction;
    off_axis = fma(c.axis, -dot(against, c.axis) * c.inverse_square, against);
    if (!(dot(off_axis, off_axis) > Real(1e-6) * dot(against, against)))
      off_axis = std::abs(c.axis.x) < std::abs(c.axis.y) ? Vec3<Real>{0, c.axis.z, -c.axis.y}
                                                         : Vec3<Real>{-c.axis.z, 0, c.axis.x};
    distance = 0;
  }
  const Vec3<Real> rough = normalized(off_axis);
  // Projected once more, to remove what rounding left along the axis.
  const Vec3<Real> away = normalized(fma(c.axis, -dot(rough, c.axis) * c.inverse_square, rough));
  // The nearest point of the side, a segment in the plane of axis and `away`: for a flat cone the rounding of
  // t may move the point along the axis by more than the cone's length.
  const Real square = dot(c.axis, c.axis);
  const Real nearest =
      ((distance - c.base_radius) * c.growth + height * square) / fma(c.growth, c.growth, square);
  const Real z = max(min(nearest, Real(1)), Real(0));
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

// At a ray's hit; near.hit.primitive isn't no_primitive.
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

// A hit whose t is relative to the ray's own origin. That may be far away, and t then too inaccurate: the
// intersection test is run again from where the ray enters the scene.
template <class Real, class Stored>
MASU_HD inline NearHit<WatertightRay<Real>> hit_again(const SceneView<Stored>& scene, const Ray<Real>& ray,
                                                      const Hit<Real>& hit) {
  ClippedRay<Real> clipped{};
  clip(ray, cast<Real>(scene.clip), clipped);
  NearHit<WatertightRay<Real>> near{{}, {hit.t - clipped.skipped, hit.primitive}, clipped.skipped};
  prepare(near.ray, clipped.ray.origin, clipped.ray.direction);
  NoTestCounts counts;
  Real t;
  if (intersect<with_all_kinds>(scene, near.ray, hit.primitive, clipped.ray.t_min, t, counts)) near.hit.t = t;
  return near;
}

} // namespace masu
