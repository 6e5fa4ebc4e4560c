// What a scene file's records must be before anything follows an index in them.
#pragma once

#include "libscene/file/record_checker.h"
#include "libscene/geometry/cone.h"
#include "libscene/scene_view.h"

namespace masu {

template <class T>
MASU_HD bool is_finite(const CornerNormals<T>& n) {
  return is_finite(n.a) && is_finite(n.b) && is_finite(n.c);
}
template <class T>
MASU_HD bool is_finite(const Cone<T>& c) {
  return is_finite(c.base) && is_finite(c.apex) && is_finite(Vec3<T>{c.base_radius, c.apex_radius, 0});
}
template <class T>
MASU_HD bool is_finite(const Light<T>& l) {
  return is_finite(l.position) && is_finite(l.intensity);
}

// What is wrong with the records where the view points to, which the checker sees; null: nothing. Every
// coordinate must lie within `bounds`, and every index must be valid.
template <class Checker, class Stored>
const char* fault_of(const Checker& checker, const SceneView<Stored>& view, const Lighting<Stored>& lighting,
                     const Boxd& bounds, const SceneCounts& counts) {
  // The bounds were computed from the stored numbers: the cast is exact.
  const Box<Stored> corners = cast<Stored>(bounds);
  const bool coordinates_good = checker.all(view.triangle_count, [=] MASU_PASS(std::uint64_t i) {
    const Triangle<Stored>& t = *view.triangle(static_cast<PrimitiveIndex>(i));
    return contains(corners, t.a) && contains(corners, t.b) && contains(corners, t.c);
  }) && checker.all(counts.normals, [=] MASU_PASS(std::uint64_t i) {
    return is_finite(view.normals[i]);
  }) && checker.all(view.sphere_count, [=] MASU_PASS(std::uint64_t i) {
    const Boxd box = cast<double>(masu::bounds(view.spheres[i]));
    return contains(bounds, box.min) && contains(bounds, box.max);
  }) && checker.all(view.cone_count, [=] MASU_PASS(std::uint64_t i) {
    const Boxd box = masu::bounds(view.cones[i]);
    return is_finite(view.cones[i]) && contains(bounds, box.min) && contains(bounds, box.max);
  }) && checker.all(lighting.light_count, [=] MASU_PASS(std::uint64_t i) {
    return is_finite(lighting.lights[i]);
  });
  if (!coordinates_good) return "a coordinate isn't within the scene's bounds";
  const bool indices_good = checker.all(view.triangle_count, [=] MASU_PASS(std::uint64_t i) {
    const Triangle<Stored>& t = *view.triangle(static_cast<PrimitiveIndex>(i));
    return t.material < counts.materials &&
           (view.places != nullptr ? view.places[i].object : t.object) < counts.objects &&
           (t.normals == no_normals || t.normals < counts.normals);
  }) && checker.all(view.sphere_count, [=] MASU_PASS(std::uint64_t i) {
    const Surface& s = view.sphere_surfaces[i];
    return s.material < counts.materials && s.object < counts.objects;
  }) && checker.all(view.cone_count, [=] MASU_PASS(std::uint64_t i) {
    const Surface& s = view.cone_surfaces[i];
    return s.material < counts.materials && s.object < counts.objects;
  });
  if (!indices_good) return "a primitive's material, object or normals don't exist";
  const bool faces_good =
      view.faces == nullptr || checker.all(view.triangle_count, [=] MASU_PASS(std::uint64_t i) {
        return view.faces[i] < max_primitives;
      });
  return faces_good ? nullptr : "the number of a triangle's face is too large";
}

} // namespace masu
