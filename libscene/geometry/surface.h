// The surface at a hit: position, normals, and a bound on the position's error.
//
// The point isn't computed from the ray, whose t is rounded, but projected onto the primitive, after Wächter
// & Binder, "A Fast and Robust Method for Avoiding Self-Intersection", Ray Tracing Gems, chapter 6, 2019. The
// remaining error is the rounding of the coordinates and of the next ray's test of the same primitive;
// secondary rays start that far from the surface, at any scale.
#pragma once

#include "libscene/geometry/clip.h"
#include "libscene/geometry/closest_point.h"
#include "libscene/geometry/intersect.h"
#include "libscene/geometry/surface_point.h"
#include "libscene/geometry/textbook_surface.h"

namespace masu {

// How far off a surface its secondary rays start. `extent`: of the primitive's coordinates the largest,
// `size`: its own; so the errors of a small primitive far from zero are little more than those of its
// coordinates. In units of u, with lengths of vectors by their largest component or √3 of that:
//  - Triangle: the point is off by the weights' sum and three roundings, 6 √3 extent at most, its offset by
//    two more, 2 √3 extent. In the next test of it, corners within `size` of the origin are moved across the
//    ray by 4 (subtracting them and a dot product) and along it by 4, 3 (weighting) and 6 (weights) of their
//    distance √3 size. Off the plane that makes √(4² + 13²) √3 size at most, since across and along the ray
//    count by sine and cosine of one angle. What a dot product's own vector is off by turns the ray a little
//    about its origin, which stays on its side of the plane. A common factor of t leaves it its sign.
//  - Sphere: the point and its offset are rounded once each, 2 √3 extent; the radius, its direction and the
//    next test, all of vectors as long as the radius, make less than 16 of it.
//  - Cone: the same of the point; 60 of what is rounded in the test (margin.h), which is the cone's size, or
//    its extent where that is less.
template <class Real>
MASU_HD inline Real surface_error(Real of_extent, Real extent, Real of_size, Real size) {
  return RealTraits<Real>::unit_roundoff * fma(of_extent, extent, of_size * size);
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

// What is reported of a hit on a triangle, in double whatever arithmetic found it: a sliver's normal and
// weights are lost to float32.
struct TriangleHit {
  Vec3d normal; // of unit length, on the front; against the ray where the corners are on a line
  double u, v;  // weights of b and c, from 0 to 1
};
template <class Real, class Stored>
MASU_HD inline TriangleHit triangle_hit(const PreparedRay<Real>& ray, Real t,
                                        const Triangle<Stored>& stored) {
  const Triangle<double> triangle = widened(stored);
  WatertightRay<double> line{};
  prepare(line, cast<double>(ray.origin), cast<double>(ray.direction));
  const Vec3d across = cross(triangle.b - triangle.a, triangle.c - triangle.a);
  const Vec3d normal = normalized(largest_magnitude(across) > 0 ? across : -line.direction);
  const EdgeFunctions<double> weights = barycentric(line, triangle);
  if (min(weights.a, min(weights.b, weights.c)) >= 0) return {normal, weights.b, weights.c};
  // Met within the error bound: at what is closest.
  const ClosestPoint closest =
      closest_point(triangle, fma(line.direction, static_cast<double>(t), line.origin));
  return {normal, closest.weight_b, closest.weight_c};
}

// Interpolated between a triangle's corner normals; the geometric one where it has none, or where opposite
// ones sum to zero.
template <class Real, class Stored>
MASU_HD inline Vec3<Real> shading_normal(const SceneView<Stored>& scene, const Triangle<Stored>& triangle,
                                         const EdgeFunctions<Real>& weights, const Vec3<Real>& geometric) {
  if (triangle.normals == no_normals) return geometric;
  const CornerNormals<Stored>& n = scene.normals[triangle.normals];
  const Vec3<Real> between = interpolate(weights, normalized(cast<Real>(n.a)), normalized(cast<Real>(n.b)),
                                         normalized(cast<Real>(n.c)));
  return largest_magnitude(between) > 0 ? normalized(between) : geometric;
}

template <class TestRay, class Stored, class Real = typename TestRay::Real>
MASU_HD inline SurfacePoint<Real> surface_at(const SceneView<Stored>& scene, const TestRay& line, Real,
                                             const Triangle<Stored>& triangle) {
  const auto& ray = prepare_watertight(line);
  const Vec3<Real> a = cast<Real>(triangle.a), b = cast<Real>(triangle.b), c = cast<Real>(triangle.c);
  const EdgeFunctions<Real> weights = barycentric(ray, triangle);
  SurfacePoint<Real> point{};
  point.position = interpolate(weights, a, b, c);
  // The rounded edges of a very thin triangle may be parallel: its normal then points against the ray.
  const Vec3<Real> across = cross(b - a, c - a);
  point.normal = normalized(largest_magnitude(across) > 0 ? across : -ray.direction);
  point.shading = shading_normal(scene, triangle, weights, point.normal);
  const Real extent = max(largest_magnitude(a), max(largest_magnitude(b), largest_magnitude(c)));
  const Real size = max(largest_magnitude(b - a), max(largest_magnitude(c - a), largest_magnitude(c - b)));
  point.error = surface_error(Real(16), extent, Real(24), size);
  point.is_flat = true;
  point.material = static_cast<std::uint32_t>(triangle.material);
  return point;
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
  point.error = surface_error(Real(4), largest_magnitude(center) + radius, Real(16), radius);
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
  const Real widest = max(c.base_radius, c.base_radius + c.growth);
  const Real extent = max(largest_magnitude(c.base), largest_magnitude(cast<Real>(cone.apex))) + widest;
  point.error = surface_error(Real(4), extent, Real(60), min(length(c.axis) + widest, extent));
  return point;
}

// At a ray's hit; near.hit.primitive isn't no_primitive.
template <unsigned kinds, class TestRay, class Stored>
MASU_HD inline SurfacePoint<typename TestRay::Real> surface_at(const SceneView<Stored>& scene,
                                                               const NearHit<TestRay>& near) {
  const PrimitiveIndex primitive = near.hit.primitive;
  if constexpr ((kinds & with_triangles) != 0) {
    if (kinds == with_triangles || primitive < scene.triangle_count)
      return surface_at(scene, near.ray, near.hit.t, *scene.triangle(primitive));
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
// intersection test is run again from where the ray enters the scene. record(): the primitive's.
template <class Real, class Stored, class Record>
MASU_HD inline NearHit<WatertightRay<Real>> hit_again(const SceneView<Stored>& scene, const Ray<Real>& ray,
                                                      const Hit<Real>& hit, const Record& record) {
  ClippedRay<Real> clipped{};
  clip(ray, cast<Real>(scene.clip), clipped);
  NearHit<WatertightRay<Real>> near{{}, {hit.t - clipped.skipped, hit.primitive}, clipped.skipped};
  prepare(near.ray, clipped.ray.origin, clipped.ray.direction);
  NoTestCounts counts;
  Real t;
  const Leaf<Stored> from = record();
  if (intersect<with_all_kinds>(scene, near.ray, hit.primitive, from, clipped.ray.t_min, t, counts))
    near.hit.t = t;
  return near;
}

} // namespace masu
