// Functions to make scenes of a few objects in tests.
#pragma once

#include "libscene/scene.h"
#include "stability/test_scene.h"

namespace masu {

inline Material matte(const Vec3f& color) {
  return {color, 1, 0, 0, 0, 1};
}
inline Material mirror() {
  return {{0, 0, 0}, 0, 1, 1, 0, 1};
}
inline Material glass(float index) {
  return {{0, 0, 0}, 0, 0, 1, 1, index};
}

inline constexpr Vec3f test_background{0.25F, 0.5F, 0.75F};

// Ambient light of 1: a matte surface has its own colour. The camera's field of view is 90° by 90° with 2×2
// pixels, so that the middle one of its 3×3 corner rays is the view direction.
inline Scene empty_scene(const Vec3d& from, const Vec3d& at) {
  Scene scene{};
  const Vec3d sight = normalized(at - from);
  const Vec3d up = std::abs(sight.y) < 0.9 ? Vec3d{0, 1, 0} : Vec3d{1, 0, 0};
  scene.camera = {from, at, up, 90, 0.01, 2, 2};
  scene.has_camera = true;
  scene.background = test_background;
  scene.ambient = 1;
  return scene;
}

inline std::uint32_t add_material(Scene& scene, const Material& material) {
  scene.materials.push_back(material);
  return static_cast<std::uint32_t>(scene.materials.size() - 1);
}
inline std::uint32_t object_count(const Scene& scene) {
  const ObjectCounts& o = scene.objects;
  return static_cast<std::uint32_t>(o.polygons + o.patches + o.spheres + o.cones);
}
inline void add_sphere(Scene& scene, const Vec3d& center, double radius, const Material& material) {
  scene.sphere_surfaces.push_back({object_count(scene), add_material(scene, material)});
  scene.spheres.push_back({center, radius});
  ++scene.objects.spheres;
}
inline void add_cone(Scene& scene, const Cone<double>& cone, const Material& material) {
  scene.cone_surfaces.push_back({object_count(scene), add_material(scene, material)});
  scene.cones.push_back(cone);
  ++scene.objects.cones;
}
inline void add_triangle(Scene& scene, const Vec3d& a, const Vec3d& b, const Vec3d& c,
                         const Material& material) {
  const std::uint32_t object = object_count(scene);
  scene.triangles.push_back({a, object, b, add_material(scene, material), c, no_normals});
  ++scene.objects.polygons;
}
// A parallelogram about `center`, of two triangles.
inline void add_quad(Scene& scene, const Vec3d& center, const Vec3d& u, const Vec3d& v,
                     const Material& material) {
  const Vec3d a = center - u - v, b = center + u - v, c = center + u + v, d = center - u + v;
  const std::uint32_t object = object_count(scene), used = add_material(scene, material);
  scene.triangles.push_back({a, object, b, used, c, no_normals});
  scene.triangles.push_back({a, object, c, used, d, no_normals});
  ++scene.objects.polygons;
}
// A triangle that contains a disc of radius `reach` about `center`, with the front towards `normal`.
inline void add_wall(Scene& scene, const Vec3d& center, const Vec3d& normal, const Material& material,
                     double reach = 100) {
  const Vec3d n = normalized(normal);
  const Vec3d u = normalized(cross(std::abs(n.x) < 0.5 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0}, n)),
              v = cross(n, u);
  add_triangle(scene, center - (u + v) * (2 * reach), center + (u * 2.0 - v) * (2 * reach),
               center + (v * 2.0 - u) * (2 * reach), material);
}
inline void add_light(Scene& scene, const Vec3d& position, const Vec3d& intensity = {1, 1, 1}) {
  scene.lights.push_back({position, intensity});
}

inline float random_share(Chance& chance) {
  return static_cast<float>(chance.uniform(0, 1));
}
inline Vec3f random_color(Chance& chance) {
  return {random_share(chance), random_share(chance), random_share(chance)};
}
// A direction whose cosine with `axis` is larger than `min_cosine`.
inline Vec3d random_towards(Chance& chance, const Vec3d& axis, double min_cosine = 0.15) {
  for (;;) {
    const Vec3d v = chance.direction();
    if (dot(v, axis) > min_cosine) return v;
  }
}

} // namespace masu
