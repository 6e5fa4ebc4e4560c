// What one camera ray sees: the one definition for both backends.
//
// After Whitted, "An Improved Illumination Model for Shaded Display", CACM 23(6), 1980, with the SPD's rules.
// At a hit, with N turned to the viewer, L to the light, R its mirror about N, V to the viewer:
//   I = Ia Kd C + Σ visible lights Il (Kd C (N·L) + Ks max(0, R·V)^n) + Ks I_reflected + T I_refracted
// Recursion is unrolled into a list of rays still to trace, each with the weight of what it will see.
#pragma once

#include "libgrid/trace/trace.h"
#include "libscene/geometry/surface.h"
#include "renderer/camera.h"

namespace masu {

inline constexpr int largest_depth = 32;

// How a hit is named in what is reported: by the NFF's object, by the scene file's primitive, or by the face
// of a mesh (face_of, intersect.h).
enum class HitName { object, primitive, face };

struct RenderRules {
  std::int32_t depth =
      0; // of the last ray that is traced; the camera's is 1; at most largest_depth; 0: unshaded
  bool spd_rules = false; // a surface with Ks > 0 or T > 0 reflects even where that can't be seen
  HitName hit_name = HitName::object;
  float offset = 1; // of secondary rays, in error bounds of the points that they leave
};

// What a camera ray hit: t, and the name of the object or primitive; infinity and -1 for nothing.
struct alignas(8) HitRecord {
  float t;
  std::int32_t name;
};

template <class Real, class Stored>
MASU_HD inline HitRecord hit_record(const SceneView<Stored>& scene, const Hit<Real>& hit, HitName name) {
  if (hit.primitive == no_primitive) return {static_cast<float>(INFINITY), -1};
  const std::uint32_t number = name == HitName::object      ? surface_of(scene, hit.primitive).object
                               : name == HitName::primitive ? hit.primitive
                                                            : face_of(scene, hit.primitive);
  return {static_cast<float>(hit.t), static_cast<std::int32_t>(number)};
}

template <class Real>
struct PendingRay {
  Vec3<Real> origin, direction; // of unit length
  float weight;
  std::int32_t depth;
};

// Room for the rays that wait while one is followed: at each depth, one sibling.
template <class Real>
struct RayStack {
  PendingRay<Real> rays[largest_depth];
  int size = 0;

  // Depths are checked before anything is traced (ResidentTracer): there is room. Should a caller have let a
  // larger one pass, the ray is dropped.
  MASU_HD void push(const PendingRay<Real>& ray) {
    if (size < largest_depth) rays[size++] = ray;
  }
  MASU_HD PendingRay<Real> pop() { return rays[--size]; }
};

// A camera ray and what it spawns, on their way one after the other.
template <class Real>
struct RayTree {
  PendingRay<Real> ray; // the one to be traced next
  RayStack<Real> pending;
  Vec3f light{0, 0, 0}; // that has come back so far

  MASU_HD explicit RayTree(const Ray<Real>& camera_ray)
      : ray{camera_ray.origin, camera_ray.direction, 1, 1} {}
};

// Where a ray hits, as shading needs it.
template <class Real>
struct Arrival {
  SurfacePoint<Real> point;
  Facing<Real> side;
  Material material;
};
template <class M, class Stored>
MASU_HD inline Arrival<typename M::Real> arrival(const SceneView<Stored>& scene, const RenderRules& rules,
                                                 const NearHit<typename M::TestRay>& hit,
                                                 const Vec3<typename M::Real>& direction) {
  SurfacePoint<typename M::Real> point = surface_at<M::kinds>(scene, hit);
  point.error *= static_cast<typename M::Real>(rules.offset);
  return {point, facing(point, direction), scene.materials[point.material]};
}

// The light that comes from there along a ray, of which `direction` is that. occluded(ray): whether a shadow
// ray is.
template <class Real, class Stored, class Occluded, class Counts>
MASU_HD inline Vec3f direct_light(const SceneView<Stored>& scene, const Lighting<Stored>& lighting,
                                  const Arrival<Real>& at, const Vec3<Real>& direction,
                                  const Occluded& occluded, Counts& counts) {
  const auto& [point, side, material] = at;
  const Vec3f diffuse = material.color * material.diffuse;
  // A light may lie on a surface, which doesn't hide it: shadow rays end short of it by the error bound of a
  // hit (margin.h), and by more than storing moves the two (√3 u M each; what more it is along a ray that
  // isn't perpendicular).
  constexpr Real roundings = margin_roundings * RealTraits<Real>::unit_roundoff +
                             16 * static_cast<Real>(RealTraits<Stored>::unit_roundoff);
  const Real short_of_light = roundings * largest_magnitude(cast<Real>(scene.clip));
  Vec3f light = diffuse * lighting.ambient;
  for (std::uint32_t i = 0; i < lighting.light_count; ++i) {
    const Vec3<Real> position = cast<Real>(lighting.lights[i].position);
    const Vec3<Real> to_light = position - point.position;
    if (!(dot(side.shading, to_light) > 0)) continue;
    const Vec3<Real> origin = leaving(point, to_light);
    const Vec3<Real> path = position - origin;
    const Real distance = length(path);
    if (!(distance > 0)) continue;
    const Vec3<Real> l = path * (1 / distance);
    const bool is_dark = occluded(Ray<Real>{origin, 0, l, distance - short_of_light});
    counts.shadow_ray(is_dark);
    if (is_dark) continue;
    const Real cosine = max(dot(side.shading, l), Real(0));
    Vec3f reflected = diffuse * static_cast<float>(cosine);
    if (material.specular > 0) {
      const Vec3<Real> mirrored = fma(side.shading, 2 * cosine, -l);
      const float highlight = static_cast<float>(max(-dot(mirrored, direction), Real(0)));
      // The one function that host and device may round differently, by a few ulp: it colours, but steers no
      // ray.
      const float strength = material.specular * std::pow(highlight, material.shine);
      reflected = reflected + Vec3f{strength, strength, strength};
    }
    light = light + cast<float>(lighting.lights[i].intensity) * reflected;
  }
  return light;
}

template <class Real>
MASU_HD inline Vec3<Real> mirrored(const Vec3<Real>& direction, const Vec3<Real>& normal) {
  return normalized(fma(normal, -2 * dot(direction, normal), direction));
}

// Snell's law; false under total internal reflection.
template <class Real>
MASU_HD inline bool refracted(const Vec3<Real>& direction, const Vec3<Real>& normal, Real index_ratio,
                              Vec3<Real>& into) {
  const Real cosine = -dot(direction, normal);
  const Real rest = 1 - index_ratio * index_ratio * (1 - cosine * cosine);
  if (!(rest >= 0)) return false;
  into = normalized(fma(normal, index_ratio * cosine - std::sqrt(rest), direction * index_ratio));
  return true;
}

// Adds the rays that the surface spawns.
template <class Real, class Counts>
MASU_HD inline void spawn(const RenderRules& rules, const Arrival<Real>& at, const PendingRay<Real>& ray,
                          RayStack<Real>& pending, Counts& counts) {
  const auto& [point, side, material] = at;
  if (ray.depth >= rules.depth) return;
  const float reflected_weight = ray.weight * material.specular,
              refracted_weight = ray.weight * material.transmittance;
  Vec3<Real> into{};
  const Real index = static_cast<Real>(material.refraction_index);
  if (transmits(material) && (refracted_weight > 0 || rules.spd_rules) &&
      refracted(ray.direction, side.shading, side.front ? 1 / index : index, into)) {
    counts.refraction_ray();
    pending.push({leaving(point, into), into, refracted_weight, ray.depth + 1});
  }
  if (rules.spd_rules ? reflects(material) || transmits(material) : reflected_weight > 0) {
    const Vec3<Real> off = mirrored(ray.direction, side.shading);
    counts.reflection_ray();
    pending.push({leaving(point, off), off, reflected_weight, ray.depth + 1});
  }
}

// Takes what the tree's ray hit, which arrive() says more of where it is asked: the light that comes from
// there, and what is spawned. Nothing is shaded for a depth of 0. Sets `first_hit` where it is the camera's
// ray. False at the end of the tree.
template <class TestRay, class Stored, class Arrive, class Occluded, class Counts>
MASU_HD inline bool follow(const SceneView<Stored>& scene, const Lighting<Stored>& lighting,
                           const RenderRules& rules, const NearHit<TestRay>& hit,
                           RayTree<typename TestRay::Real>& tree, HitRecord& first_hit, const Arrive& arrive,
                           const Occluded& occluded, Counts& counts) {
  using Real = typename TestRay::Real;
  const PendingRay<Real>& ray = tree.ray;
  const bool met = hit.hit.primitive != no_primitive;
  if (ray.depth == 1) {
    counts.camera_ray(met);
    first_hit = hit_record(scene, relative_to_origin(hit), rules.hit_name);
    if (rules.depth == 0) return false;
  } else {
    counts.secondary_ray(met);
  }
  if (met) {
    const Arrival<Real>& at = arrive();
    tree.light = tree.light + direct_light(scene, lighting, at, ray.direction, occluded, counts) * ray.weight;
    spawn(rules, at, ray, tree.pending, counts);
  } else {
    tree.light = tree.light + lighting.background * ray.weight;
  }
  if (tree.pending.size == 0) return false;
  tree.ray = tree.pending.pop();
  return true;
}

// The light that comes back along a camera ray, and what it hit. M: a Method.
template <class M, class Stored, class Structure, class Counts>
MASU_HD inline Vec3f radiance(const SceneView<Stored>& scene, const Lighting<Stored>& lighting,
                              const Structure& structure, const RenderRules& rules,
                              const Ray<typename M::Real>& first, HitRecord& first_hit, Counts& counts) {
  using Real = typename M::Real;
  RayTree<Real> tree(first);
  for (;;) {
    const auto hit =
        nearest_hit_near<M>(scene, structure, unbounded_ray(tree.ray.origin, tree.ray.direction), counts);
    const auto occluded = [&](const Ray<Real>& ray) { return is_occluded<M>(scene, structure, ray, counts); };
    const auto arrive = [&] { return arrival<M>(scene, rules, hit, tree.ray.direction); };
    if (!follow(scene, lighting, rules, hit, tree, first_hit, arrive, occluded, counts)) return tree.light;
  }
}

} // namespace masu
