// Checks of what follows a hit: rays that leave surfaces, glass, and Snell's law.
#pragma once

#include "libgrid/file/structure_file.h"
#include "libscene/base/parallel.h"
#include "libscene/geometry/surface.h"
#include "renderer/counts.h"
#include "renderer/dispatch.h"
#include "stability/same_bits.h"
#include "stability/sweeps/sweep.h"
#include "stability/tally.h"

#include <tbb/combinable.h>

namespace masu::stability {

// Calls act(ray's index, tally) for every ray, in parallel. Returns the sum of the tallies.
template <class Act>
Tally tallied(std::size_t rays, const Act& act) {
  tbb::combinable<Tally> parts;
  parallel_for(rays, [&](std::size_t i) {
    Tally& tally = parts.local();
    ++tally.rays;
    act(i, tally);
  });
  Tally total;
  parts.combine_each([&](const Tally& part) { total += part; });
  return total;
}

// A ray of unit length, as the renderer traces it.
template <class Real>
Ray<Real> unit_ray(const Ray<double>& listed) {
  return unbounded_ray(cast<Real>(listed.origin), normalized(cast<Real>(listed.direction)));
}

// --- Leaving --------------------------------------------------------------------------------------------

// The convex body that a primitive belongs to: all triangles form one.
template <class Stored>
PrimitiveIndex body_of(const SceneView<Stored>& scene, PrimitiveIndex primitive) {
  return primitive < scene.triangle_count ? 0 : primitive;
}

// The outward normal at a point of the body's surface; of unit length.
inline Vec3d outwards_at(const Triangle<double>& t, const Vec3d&, const Vec3d& middle) {
  const Vec3d normal = normalized(cross(t.b - t.a, t.c - t.a));
  return dot(normal, t.a - middle) < 0 ? -normal : normal;
}
inline Vec3d outwards_at(const Sphere<double>& s, const Vec3d& at, const Vec3d&) {
  return normalized(at - s.center);
}
inline Vec3d outwards_at(const Cone<double>& c, const Vec3d& at, const Vec3d&) {
  const Vec3d axis = c.apex - c.base, from_base = at - c.base;
  const double square = dot(axis, axis);
  const Vec3d away = normalized(fma(axis, -dot(from_base, axis) / square, from_base));
  return normalized(fma(axis, -(c.apex_radius - c.base_radius) / square, away));
}

// The mean of all triangles' corners: a point inside the body that they form.
template <class Stored>
Vec3d middle_of_triangles(const SceneView<Stored>& scene) {
  Vec3d sum{0, 0, 0};
  for (std::uint32_t i = 0; i < scene.triangle_count; ++i) {
    const Triangle<double> t = widened(scene.triangles[i]);
    sum = sum + (t.a + t.b + t.c) * (1.0 / 3);
  }
  return sum * (1.0 / std::max(1U, scene.triangle_count));
}

template <class TestRay, class Stored>
Tally judged_leaving(const SceneView<Stored>& scene, const std::vector<Structure>& grids,
                     const Trial<Stored>& trial, double slack) {
  using Real = typename TestRay::Real;
  using M = Method<TestRay, with_all_kinds>;
  const oracle::SceneOracle oracle(scene);
  const Vec3d middle = middle_of_triangles(scene);
  const auto same_by_grids = [&](const Ray<Real>& ray, const Hit<Real>& hit) {
    bool same = true;
    NoCounts counts;
    const auto compare = [&](const auto& view) {
      const Hit<Real> other = nearest_hit<M>(scene, view, ray, counts);
      same = same && other.primitive == hit.primitive && same_bits(other.t, hit.t);
    };
    for (const Structure& grid : grids)
      with_structure_view<Real>(grid, compare);
    return same;
  };
  return tallied(trial.rays.size(), [&](std::size_t i, Tally& tally) {
    NoCounts counts;
    const auto near = nearest_hit_near<M>(scene, NoStructure{}, unit_ray<Real>(trial.rays[i]), counts);
    if (near.hit.primitive == no_primitive) return;
    // Near an edge the offset of the ray's origin may lead through the adjacent face.
    if (!oracle.closest(trial.rays[i], 2 * slack).sure) {
      ++tally.unsure;
      return;
    }
    const SurfacePoint<Real> point = surface_at<with_all_kinds>(scene, near);
    const PrimitiveIndex primitive = near.hit.primitive, body = body_of(scene, primitive);
    Vec3d outwards{};
    with_primitive(scene, primitive,
                   [&](const auto& p) { outwards = outwards_at(p, cast<double>(point.position), middle); });
    constexpr double off_tangent = 1.02; // above 1: not tangential to the surface
    for (const double side : {1.0, -1.0}) {
      const Vec3d& aim = trial.aims[i];
      const Vec3<Real> direction =
          cast<Real>(trial.sines.empty() ? normalized(aim + outwards * (side * off_tangent))
                                         : normalized(normalized(aim - outwards * dot(aim, outwards)) +
                                                      outwards * (side * trial.sines[i])));
      const Ray<Real> ray = unbounded_ray(leaving(point, direction), direction);
      const Hit<Real> hit = nearest_hit<M>(scene, NoStructure{}, ray, counts);
      tally.by_grid += same_by_grids(ray, hit) ? 0 : 1;
      const bool is_closed = primitive < scene.triangle_count + scene.sphere_count;
      if (side > 0 && hit.primitive != no_primitive && body_of(scene, hit.primitive) == body)
        ++tally.false_hit;
      if (side < 0 && is_closed && hit.primitive == no_primitive) ++tally.missed;
    }
  });
}

// --- Glass ----------------------------------------------------------------------------------------------

template <class TestRay, class Stored>
Tally judged_glass(const SceneView<Stored>& scene, const std::vector<Structure>& grids,
                   const Trial<Stored>& trial) {
  using Real = typename TestRay::Real;
  using M = Method<TestRay, with_all_kinds>;
  const Lighting<Stored> lighting{nullptr, 0, {1, 1, 1}, 0};
  const RenderRules rules{trial.depth, false, HitName::primitive};
  return tallied(trial.rays.size(), [&](std::size_t i, Tally& tally) {
    const Ray<Real> ray = unit_ray<Real>(trial.rays[i]);
    NoCounts counts;
    HitRecord first{};
    const Vec3f light = radiance<M>(scene, lighting, NoStructure{}, rules, ray, first, counts);
    bool good = true, same = true;
    for (const float channel : {light.x, light.y, light.z})
      good = good && channel >= 0 && channel <= 1 + 1e-5F; // nor NaN
    const auto compare = [&](const auto& view) {
      const Vec3f other = radiance<M>(scene, lighting, view, rules, ray, first, counts);
      same = same && same_bits(other, light);
    };
    for (const Structure& grid : grids)
      with_structure_view<Real>(grid, compare);
    tally.wrong += good ? 0 : 1;
    tally.by_grid += same ? 0 : 1;
  });
}

// --- Snell's law ----------------------------------------------------------------------------------------

template <class TestRay, class Stored>
Tally judged_refraction(const SceneView<Stored>& scene, const Trial<Stored>& trial) {
  using Real = typename TestRay::Real;
  using M = Method<TestRay, with_all_kinds>;
  using oracle::Wide;
  constexpr double u = static_cast<double>(RealTraits<Real>::unit_roundoff);
  const Triangle<double> surface = widened(scene.triangles[0]);
  const oracle::Point a = oracle::point(surface.a);
  const oracle::Point across = oracle::outer(oracle::point(surface.b) - a, oracle::point(surface.c) - a);
  const oracle::Point exact_normal = across * (1 / oracle::norm(across));
  return tallied(trial.rays.size(), [&](std::size_t i, Tally& tally) {
    NoCounts counts;
    const Ray<Real> ray = unit_ray<Real>(trial.rays[i]);
    const auto near = nearest_hit_near<M>(scene, NoStructure{}, ray, counts);
    if (near.hit.primitive == no_primitive) return void(++tally.unsure); // missed the surface, seen edge-on
    const SurfacePoint<Real> point = surface_at<with_all_kinds>(scene, near);
    const Facing<Real> side = facing(point, ray.direction);
    const Real index = static_cast<Real>(scene.materials[point.material].refraction_index);
    const Real ratio = side.front ? 1 / index : index;
    Vec3<Real> into{};
    const bool passes = refracted(ray.direction, side.shading, ratio, into);
    // The exact result for the same input: deviations from unit length are part of the error.
    const oracle::Point along = oracle::point(ray.direction);
    const oracle::Point d = along * (1 / oracle::norm(along));
    const Wide facing_by = oracle::inner(d, exact_normal);
    const oracle::Point n = exact_normal * (facing_by < 0 ? Wide(1) : Wide(-1));
    const Wide cosine = oracle::magnitude(facing_by), r = side.front ? 1 / Wide(index) : Wide(index);
    const Wide rest = 1 - r * r * (1 - cosine * cosine);
    const double allowed = 32 * u * (1 + static_cast<double>(r * r));
    // Near the critical angle, or nearly parallel to the surface, where either side may be the front.
    if (oracle::magnitude(rest) <= allowed || cosine <= 16 * u) return void(++tally.unsure);
    if (passes != (rest > 0)) return void(++(passes ? tally.false_hit : tally.missed));
    if (!passes) return;
    const Wide lift = r * cosine - oracle::root(rest);
    const double error = static_cast<double>(oracle::norm(oracle::point(into) - (d * r + n * lift)));
    tally.worst_t = std::max(tally.worst_t, error);
    // The square root amplifies the error of a small argument.
    tally.misplaced += error <= allowed * (1 + 1 / std::sqrt(static_cast<double>(rest))) ? 0 : 1;
  });
}

} // namespace masu::stability
