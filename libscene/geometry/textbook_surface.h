// The surface at a hit of `fast` precision: the point on the ray, and a fixed epsilon for secondary rays,
// which is too large for a small scene and too small for a large one (surface.h has the robust version).
#pragma once

#include "libscene/geometry/surface_point.h"
#include "libscene/geometry/textbook.h"
#include "libscene/scene_view.h"

namespace masu {

inline constexpr float textbook_epsilon = 1e-4F;

MASU_HD inline SurfacePoint<float> textbook_point(const TextbookRay& ray, float t, const Vec3f& normal) {
  return {fma(ray.direction, t, ray.origin), normal, normal, textbook_epsilon, 0, false};
}

template <class Stored>
MASU_HD inline SurfacePoint<float> surface_at(const SceneView<Stored>& scene, const TextbookRay& ray, float,
                                              const Triangle<Stored>& triangle) {
  const PlaneHit hit = plane_hit(ray, triangle);
  const Vec3f a = cast<float>(triangle.a);
  SurfacePoint<float> point = textbook_point(
      ray, hit.t, normalized(rough_cross(cast<float>(triangle.b) - a, cast<float>(triangle.c) - a)));
  if (triangle.normals != no_normals) {
    const CornerNormals<Stored>& n = scene.normals[triangle.normals];
    const Vec3f at_a = normalized(cast<float>(n.a)) * (1 - hit.b - hit.c);
    point.shading =
        normalized(fma(normalized(cast<float>(n.b)), hit.b, fma(normalized(cast<float>(n.c)), hit.c, at_a)));
  }
  point.material = static_cast<std::uint32_t>(triangle.material);
  return point;
}

template <class Stored>
MASU_HD inline SurfacePoint<float> surface_at(const TextbookRay& ray, float t, const Sphere<Stored>& sphere) {
  const Vec3f outwards = fma(ray.direction, t, ray.origin) - cast<float>(sphere.center);
  return textbook_point(ray, t, normalized(sphere.radius < 0 ? -outwards : outwards));
}

template <class Stored>
MASU_HD inline SurfacePoint<float> surface_at(const TextbookRay& ray, float t, const Cone<Stored>& cone) {
  const ConeAxis<float> c = cone_heights(cone);
  const Vec3f from_base = fma(ray.direction, t, ray.origin) - c.base;
  const Vec3f off = fma(c.axis, -dot(from_base, c.axis) * c.inverse_square, from_base);
  const Vec3f outwards = fma(c.axis, -c.growth * c.inverse_square, normalized(off));
  return textbook_point(ray, t, normalized(is_inside_out(cone) ? -outwards : outwards));
}

} // namespace masu
