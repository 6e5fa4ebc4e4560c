// The intersection tests of `fast` precision: textbook formulas in float32, without care for cancellation.
// They are a baseline for the robust tests of triangle.h, sphere.h and cone.h: with these, rays pass between
// triangles, far spheres get holes, and surfaces shadow themselves.
//
// Triangles after Möller & Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection", Journal of Graphics
// Tools 2(1), 1997, without its absolute epsilon, which would drop small triangles; spheres and cones by the
// quadratic formula. Results on host and device differ: the device's divisions and roots are approximate.
#pragma once

#include "libscene/geometry/cone.h"

namespace masu {

struct TextbookRay {
  using Real = float;
  Vec3f origin, direction;
};

MASU_HD inline void prepare(TextbookRay& ray, const Vec3f& origin, const Vec3f& along) {
  ray = {origin, along};
}

// 1 / v and √v to a few ulp.
MASU_HD inline float approximate_inverse(float v) {
#ifdef __CUDA_ARCH__
  return __fdividef(1.0F, v);
#else
  return 1 / v;
#endif
}
MASU_HD inline float approximate_root(float v) {
#ifdef __CUDA_ARCH__
  float root;
  asm("sqrt.approx.f32 %0, %1;" : "=f"(root) : "f"(v));
  return root;
#else
  return std::sqrt(v);
#endif
}

// Where a ray's line meets a triangle's plane; b and c: barycentric coordinates of those corners.
struct PlaneHit {
  float t, b, c;
};

template <class Stored>
MASU_HD inline PlaneHit plane_hit(const TextbookRay& ray, const Triangle<Stored>& triangle) {
  const Vec3f a = cast<float>(triangle.a);
  const Vec3f to_b = cast<float>(triangle.b) - a, to_c = cast<float>(triangle.c) - a;
  const Vec3f p = rough_cross(ray.direction, to_c);
  const float inverse =
      approximate_inverse(dot(to_b, p)); // infinite for a ray in the plane: then b and c are out of range
  const Vec3f from_a = ray.origin - a;
  const Vec3f q = rough_cross(from_a, to_b);
  return {dot(to_c, q) * inverse, dot(from_a, p) * inverse, dot(ray.direction, q) * inverse};
}

template <class Stored>
MASU_HD inline bool intersect(const TextbookRay& ray, const Triangle<Stored>& triangle, float& t) {
  const PlaneHit hit = plane_hit(ray, triangle);
  t = hit.t;
  return hit.b >= 0 && hit.c >= 0 && hit.b + hit.c <= 1;
}

template <class Stored>
MASU_HD inline bool intersect(const TextbookRay& ray, const Sphere<Stored>& sphere, float t_min, float& t) {
  const float radius = static_cast<float>(sphere.radius);
  const Vec3f from_center = ray.origin - cast<float>(sphere.center);
  const float a = dot(ray.direction, ray.direction), b = dot(from_center, ray.direction);
  const float c = dot(from_center, from_center) - radius * radius;
  const float discriminant = b * b - a * c;
  if (!(discriminant >= 0)) return false;
  const float root = approximate_root(discriminant), inverse = approximate_inverse(a);
  const float enter = (-b - root) * inverse, leave = (-b + root) * inverse;
  t = radius > 0 && enter > t_min ? enter : leave;
  return t > t_min;
}

// cone_axis(), but for the division.
template <class Stored>
MASU_HD inline ConeAxis<float> cone_heights(const Cone<Stored>& cone) {
  ConeAxis<float> c = cone_axis<float>(cone);
  c.inverse_square = approximate_inverse(dot(c.axis, c.axis));
  return c;
}

// The template argument, whether the cone may taper, is unused here.
template <bool = true, class Stored>
MASU_HD inline bool intersect(const TextbookRay& ray, const Cone<Stored>& cone, float t_min, float& t) {
  const ConeAxis<float> c = cone_heights(cone);
  const Vec3f from_base = ray.origin - c.base;
  const float height = dot(from_base, c.axis) * c.inverse_square,
              rise = dot(ray.direction, c.axis) * c.inverse_square;
  const Vec3f off = fma(c.axis, -height, from_base), across = fma(c.axis, -rise, ray.direction);
  const float radius = fma(c.growth, height, c.base_radius), widening = c.growth * rise;
  const float qa = dot(across, across) - widening * widening, qb = dot(off, across) - radius * widening,
              qc = dot(off, off) - radius * radius;
  const float discriminant = qb * qb - qa * qc;
  if (!(discriminant >= 0)) return false;
  const float root = approximate_root(discriminant), inverse = approximate_inverse(qa);
  const float root1 = (-qb - root) * inverse, root2 = (-qb + root) * inverse;
  const bool inside_only = cone.base_radius < 0 || cone.apex_radius < 0;
  const auto is_hit = [&](float at) {
    const float there = fma(rise, at, height);
    return at > t_min && there >= 0 && there <= 1 && (!inside_only || fma(qa, at, qb) > 0);
  };
  const float first = fast_min(root1, root2), second = fast_max(root1, root2);
  t = is_hit(first) ? first : second;
  return is_hit(t);
}

} // namespace masu
