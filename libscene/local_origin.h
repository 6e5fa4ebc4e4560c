// A scene's local origin: the point in the world that its stored coordinates are relative to.
//
// Every error bound is a multiple of the largest stored coordinate (margin.h). Relative to a point amid the
// primitives, that is half the scene's extent, wherever in the world the scene stands.
#pragma once

#include "libscene/scene.h"

#include <optional>

namespace masu {

// Farthest that an origin may be from the world's zero, along an axis.
inline constexpr double max_origin = 1e100;

// The centre of the primitives' bounds where that is farther from zero than half their diagonal; else zero,
// as of the standard scenes, and of a scene without primitives.
//
// The same for a scene moved by any vector that keeps its coordinates exact, plus that vector: all is
// computed relative to a corner of the box of vertices, centres and ends, and only then moved there; and the
// centre is rounded to the 512th part of the extent, so that the sum is exact wherever the scene's
// coordinates have so many steps.
template <class Triangles>
Vec3d automatic_origin(const SceneOf<Triangles>& scene);
// The same of what is in a box.
Vec3d automatic_origin(const Boxd& box);

// Automatic where `wanted` isn't given. Throws Error(usage, place, …) for one that isn't finite or lies
// beyond max_origin.
template <class Triangles>
Vec3d origin_for(const SceneOf<Triangles>& scene, const std::optional<Vec3d>& wanted,
                 const char* place = "origin");

// A point relative to an origin: each coordinate rounded once. Never -0, which a moved scene wouldn't have.
MASU_HD inline Vec3d relative_to(const Vec3d& origin, const Vec3d& point) {
  return point - origin + Vec3d{0, 0, 0};
}
// The same of records. Normals and intensities stay.
inline SceneTriangle relative_to(const Vec3d& origin, const SceneTriangle& t) {
  return {relative_to(origin, t.a), t.object, relative_to(origin, t.b), t.material,
          relative_to(origin, t.c), t.normals};
}
inline Sphere<double> relative_to(const Vec3d& origin, const Sphere<double>& s) {
  return {relative_to(origin, s.center), s.radius};
}
inline Cone<double> relative_to(const Vec3d& origin, const Cone<double>& c) {
  return {relative_to(origin, c.base), c.base_radius, relative_to(origin, c.apex), c.apex_radius};
}
inline Light<double> relative_to(const Vec3d& origin, const Light<double>& l) {
  return {relative_to(origin, l.position), l.intensity};
}
inline Camera relative_to(const Vec3d& origin, const Camera& camera) {
  Camera moved = camera;
  moved.from = relative_to(origin, camera.from);
  moved.at = relative_to(origin, camera.at);
  return moved;
}
inline Boxd relative_to(const Vec3d& origin, const Boxd& box) {
  return {relative_to(origin, box.min), relative_to(origin, box.max)};
}

// The other way: of what is relative to an origin, the place in the world. What is empty stays so.
inline Boxd in_world(const Vec3d& origin, const Boxd& box) {
  return is_empty(box) ? box : Boxd{box.min + origin, box.max + origin};
}

} // namespace masu
