// From what a scene holds and a job asks for to the code compiled for it.
#pragma once

#include "renderer/arithmetic.h"
#include "renderer/render_pixel.h"
#include "renderer/tracer.h"

#include <algorithm>
#include <span>
#include <type_traits>

namespace masu {

// A set of kinds as a type.
template <unsigned kinds_>
struct Kinds {
  static constexpr unsigned kinds = kinds_;
};

// Calls act(Kinds) with the narrowest set compiled that holds the scene's. What it saves on an H200 over the
// code for all kinds, in a picture's time: triangles alone 9 % (teapot; `fast` 9, `double` 8), triangles and
// spheres 6 to 12 % (balls, mount; `double` 11 to 16, `fast` less than 5: it has none), cones that are all
// cylinders 5 % (rings, `robust`). Scenes of doubles are rare: they have the code for all kinds alone.
template <class TestRay, class Act>
void with_kinds(const SceneView<float>& scene, const Act& act) {
  if (scene.cone_count == 0) {
    if (scene.sphere_count == 0) return act(Kinds<with_triangles>{});
    if constexpr (!std::is_same_v<TestRay, TextbookRay>) return act(Kinds<with_triangles | with_spheres>{});
  }
  if constexpr (std::is_same_v<TestRay, WatertightRay<float>>) {
    const std::span cones(scene.cones, scene.cone_count);
    if (std::ranges::none_of(cones, tapers<float>)) return act(Kinds<with_all_kinds & ~with_tapers>{});
  }
  act(Kinds<with_all_kinds>{});
}
template <class TestRay, class Act>
void with_kinds(const SceneView<double>&, const Act& act) {
  act(Kinds<with_all_kinds>{});
}

// Calls act(GridView, MergedGridView or NoGrid, Method, Counts or NoCounts) for rays of one arithmetic: what
// a job needs, and no more. Counting, brute force and StopRule::first_cell run the code for all kinds.
template <class TestRay, class Stored, class Act>
void with_method(const SceneView<Stored>& scene, const GridFile* grid, const TracingRules& rules,
                 const Act& act) {
  using Real = typename TestRay::Real;
  using General = Method<TestRay, with_all_kinds>;
  if (grid == nullptr) return act(NoGrid{}, General{}, Counts{});
  const auto with_view = [&](const auto& view) {
    if (rules.stop == StopRule::first_cell) {
      using Study = Method<TestRay, with_all_kinds, StopRule::first_cell>;
      return rules.count ? act(view, Study{}, Counts{}) : act(view, Study{}, NoCounts{});
    }
    if (rules.count) return act(view, General{}, Counts{});
    if (rules.general) return act(view, General{}, NoCounts{});
    with_kinds<TestRay>(
        scene, [&]<unsigned kinds>(Kinds<kinds>) { act(view, Method<TestRay, kinds>{}, NoCounts{}); });
  };
  grid->is_merged() ? with_view(grid->merged_view<Real>()) : with_view(grid->view<Real>());
}

// A query as a type.
template <Query question_>
struct Asked {
  static constexpr Query query = question_;
};
// Calls act(Asked).
template <class Act>
void with_query(Query query, const Act& act) {
  query == Query::nearest_hit ? act(Asked<Query::nearest_hit>{}) : act(Asked<Query::occlusion>{});
}

// A listed ray as one arithmetic has it.
template <class Real>
struct alignas(8) TypedRay {
  Vec3<Real> origin, direction;
};
static_assert(sizeof(TypedRay<float>) == 24 && sizeof(TypedRay<double>) == 48);

template <class Real>
TypedRay<Real> typed(const ListedRay& ray) {
  return {cast<Real>(ray.origin), cast<Real>(ray.direction)};
}

// A listed ray scaled by a power of two, so that its direction's largest component is between 1 and 2 and
// nothing overflows on the way; t is scaled back by `scale`. Exact.
template <class Real>
struct ScaledRay {
  Ray<Real> ray;
  Real scale;
};

template <class Real>
MASU_HD inline ScaledRay<Real> scaled(const TypedRay<Real>& listed) {
  const Real scale = inverse_power_of_two(static_cast<float>(largest_magnitude(listed.direction)));
  return {{listed.origin, listed.direction * scale, RealTraits<Real>::largest}, scale};
}

// A listed ray scaled, as far as the query goes.
template <Query query, class Real>
MASU_HD inline ScaledRay<Real> asked(const TypedRay<Real>& listed) {
  ScaledRay<Real> ray = scaled(listed);
  if constexpr (query == Query::occlusion) ray.ray.t_max = 1 / ray.scale;
  return ray;
}

// The same from where it enters the bounds.
template <class Real>
struct ListedNear {
  ClippedRay<Real> near;
  Real scale; // of the ray
  bool meets; // the bounds; false: only near.ray.t_max and near.skipped are meant
};

template <Query query, class Real, class Stored>
MASU_HD inline ListedNear<Real> clipped(const SceneView<Stored>& scene, const TypedRay<Real>& listed) {
  const ScaledRay<Real> ray = asked<query>(listed);
  ListedNear<Real> result{{}, ray.scale, false};
  result.meets = clip(ray.ray, cast<Real>(scene.clip), result.near);
  return result;
}

MASU_HD inline HitRecord occlusion_record(bool occluded) {
  return {1, occluded ? 0 : -1};
}

// What a listed ray hits, or whether it is occluded.
template <Query query, class M, class Stored, class Grid, class C>
MASU_HD inline HitRecord trace_listed(const SceneView<Stored>& scene, const Grid& grid,
                                      const TypedRay<typename M::Real>& listed, HitName name, C& counts) {
  using Real = typename M::Real;
  const ScaledRay<Real> ray = asked<query>(listed);
  if constexpr (query == Query::occlusion) {
    const bool occluded = is_occluded<M>(scene, grid, ray.ray, counts);
    counts.shadow_ray(occluded);
    return occlusion_record(occluded);
  }
  const Hit<Real> hit = nearest_hit<M>(scene, grid, ray.ray, counts);
  counts.camera_ray(hit.primitive != no_primitive);
  return hit_record(scene, hit, ray.scale, name);
}

// The answer for a listed ray that was scaled and clipped: `nearest` is at t_max where nothing was hit.
template <Query query, class Real, class Stored>
MASU_HD inline HitRecord answer(const SceneView<Stored>& scene, const Hit<Real>& nearest, Real t_max,
                                Real skipped, Real scale, HitName name) {
  const bool met = nearest.t < t_max;
  if constexpr (query == Query::occlusion) return occlusion_record(met);
  return hit_record(scene, Hit<Real>{nearest.t + skipped, met ? nearest.primitive : no_primitive}, scale,
                    name);
}

// Whether the search may end once all up to t = exit has been tested.
template <Query query, class Real>
MASU_HD inline bool can_terminate(const Hit<Real>& nearest, Real t_max, Real exit) {
  return nearest.t <= exit || (query == Query::occlusion && nearest.t < t_max);
}

} // namespace masu
