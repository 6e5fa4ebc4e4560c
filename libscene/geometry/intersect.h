// Intersects a ray with a primitive given by its index. Compiled for the kinds of primitive in the scene: a
// scene without cones runs no code for cones.
#pragma once

#include "libscene/base/fetch.h"
#include "libscene/geometry/cone.h"
#include "libscene/geometry/sphere.h"
#include "libscene/geometry/textbook.h"
#include "libscene/geometry/triangle.h"
#include "libscene/scene_view.h"

namespace masu {

// A set of primitive kinds, as flags. Cylinders are cones; with_tapers: some cones aren't cylinders.
inline constexpr unsigned with_triangles = 1, with_spheres = 2, with_cones = 4, with_tapers = 8,
                          with_all_kinds = 15;

// Counts nothing.
struct NoTestCounts {
  MASU_HD void triangle_test() {}
  MASU_HD void sphere_test() {}
  MASU_HD void cone_test() {}
};

// Where a test takes a primitive's record from: the scene's arrays, where triangles are in their own order.
template <class Stored>
struct SceneRecord {
  const SceneView<Stored>& scene;
  PrimitiveIndex primitive;

  MASU_HD Triangle<Stored> triangle() const { return fetched(scene.triangles + primitive); }
  MASU_HD Sphere<Stored> sphere() const {
    return fetched(scene.spheres + (primitive - scene.triangle_count));
  }
  MASU_HD Cone<Stored> cone() const {
    return fetched(scene.cones + (primitive - scene.triangle_count - scene.sphere_count));
  }
};

// A copy of any primitive, in whatever order, in the record of a triangle, with its index as its object.
template <class Stored>
struct Leaf {
  Triangle<Stored> record;

  MASU_HD PrimitiveIndex primitive() const { return static_cast<PrimitiveIndex>(record.object); }
  MASU_HD const Triangle<Stored>& triangle() const { return record; }
  MASU_HD Sphere<Stored> sphere() const { return {record.a, record.b.x}; }
  MASU_HD Cone<Stored> cone() const { return {record.a, record.c.x, record.b, record.c.y}; }
};
template <class Stored>
MASU_HD inline Leaf<Stored> leaf_of(const SceneView<Stored>& scene, PrimitiveIndex primitive) {
  const SceneRecord<Stored> from{scene, primitive};
  Triangle<Stored> record{};
  if (primitive < scene.triangle_count) {
    record = fetched(scene.triangle(primitive));
  } else if (primitive - scene.triangle_count < scene.sphere_count) {
    const Sphere<Stored> sphere = from.sphere();
    record.a = sphere.center;
    record.b.x = sphere.radius;
  } else {
    const Cone<Stored> cone = from.cone();
    record.a = cone.base;
    record.b = cone.apex;
    record.c = {cone.base_radius, cone.apex_radius, 0};
  }
  record.object = primitive;
  return {record};
}

// Whether the ray meets the primitive at a t > t_min, which isn't negative; then `t` is the nearest. `from`
// has its record: SceneRecord or Leaf. Calls the member of `counts` for the test that was run. The type of
// ray selects the formulas: PreparedRay and WatertightRay the robust ones, TextbookRay those of textbook.h.
template <unsigned kinds, class TestRay, class Stored, class From, class Counts>
MASU_HD inline bool intersect(const SceneView<Stored>& scene, const TestRay& ray, PrimitiveIndex primitive,
                              const From& from, const typename TestRay::Real& t_min,
                              typename TestRay::Real& t, Counts& counts) {
  if constexpr ((kinds & with_triangles) != 0) {
    if (kinds == with_triangles || primitive < scene.triangle_count) {
      counts.triangle_test();
      return intersect(ray, from.triangle(), t) && t > t_min;
    }
  }
  if constexpr ((kinds & with_spheres) != 0) {
    if ((kinds & with_cones) == 0 || primitive - scene.triangle_count < scene.sphere_count) {
      counts.sphere_test();
      return intersect(ray, from.sphere(), t_min, t);
    }
  }
  if constexpr ((kinds & with_cones) != 0) {
    counts.cone_test();
    return intersect<(kinds & with_tapers) != 0>(ray, from.cone(), t_min, t);
  }
  return false;
}

template <class Stored>
MASU_HD inline Surface surface_of(const SceneView<Stored>& scene, PrimitiveIndex primitive) {
  if (primitive < scene.triangle_count) {
    const Triangle<Stored>& t = *scene.triangle(primitive);
    const auto material = static_cast<std::uint32_t>(t.material);
    return {scene.places != nullptr ? scene.places[primitive].object : static_cast<std::uint32_t>(t.object),
            material};
  }
  const std::uint32_t sphere = primitive - scene.triangle_count;
  return sphere < scene.sphere_count ? scene.sphere_surfaces[sphere]
                                     : scene.cone_surfaces[sphere - scene.sphere_count];
}

// The number of the face of a mesh that the primitive is of; its own where it is of none.
template <class Stored>
MASU_HD inline std::uint32_t face_of(const SceneView<Stored>& scene, PrimitiveIndex primitive) {
  return scene.faces != nullptr && primitive < scene.triangle_count ? scene.faces[primitive] : primitive;
}

} // namespace masu
