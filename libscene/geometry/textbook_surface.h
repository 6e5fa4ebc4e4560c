// The surface where a ray of `fast` arithmetic hit it: the ray's own point, and one fixed distance to start
// the next ray at. Too large for a small scene, too small for a large one: surface.h has what holds.
#pragma once

#include "libscene/geometry/surface_point.h"
#include "libscene/geometry/textbook.h"
#include "libscene/scene_view.h"

namespace masu {

inline constexpr float textbook_epsilon = 1e-4F;

MASU_HD inline SurfacePoint<float> textbook_point(const TextbookRay& ray, float t, const Vec3f& normal) {
  return {fma(ray.direction, t, ray.origin), normal, normal, textbook_epsilon, 0};
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
    const Vec3f at_a = normalized(cast<float>(n.a)) * (1 - hit.b_share - hit.c_share);
    point.shading = normalized(
        fma(normalized(cast<float>(n.b)), hit.b_share, fma(normalized(cast<float>(n.c)), hit.c_share, at_a)));
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
  const ConeHeights c = cone_heights(cone);
  const Vec3f from_base = fma(ray.direction, t, ray.origin) - c.base;
  const Vec3f off = fma(c.axis, -dot(from_base, c.axis) * c.inverse_square, from_base);
  const Vec3f outwards = fma(c.axis, -c.growth * c.inverse_square, normalized(off));
  return textbook_point(ray, t,
                        normalized(cone.base_radius < 0 || cone.apex_radius < 0 ? -outwards : outwards));
}

} // namespace masu
