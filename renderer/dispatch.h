// From what a scene holds to the code compiled for it.
#pragma once

#include "renderer/backend.h"
#include "renderer/render_pixel.h"

namespace masu {

// The code that can trace anything.
template <class Stored>
using GeneralModel = Model<Stored, Stored, with_all_kinds, Secondary::refraction>;

inline Secondary secondary_of(const fb::Scene& table) {
  if (table.transmitting_materials() > 0) return Secondary::refraction;
  return table.reflective_materials() > 0 ? Secondary::reflection : Secondary::none;
}

template <unsigned kinds, class Act>
void with_secondary(Secondary secondary, const Act& act) {
  switch (secondary) {
  case Secondary::none:
    return act(Model<float, float, kinds, Secondary::none>{});
  case Secondary::reflection:
    return act(Model<float, float, kinds, Secondary::reflection>{});
  case Secondary::refraction:
    return act(Model<float, float, kinds, Secondary::refraction>{});
  }
}

// A set of kinds as a type.
template <unsigned kinds_>
struct Kinds {
  static constexpr unsigned kinds = kinds_;
};

// Calls act(Kinds) with the narrowest set compiled that holds the scene's. Scenes with cones mostly have the
// rest too.
template <class Act>
void with_kinds(const SceneView<float>& scene, const Act& act) {
  if (scene.cone_count > 0) return act(Kinds<with_all_kinds>{});
  if (scene.sphere_count == 0) return act(Kinds<with_triangles>{});
  if (scene.triangle_count == 0) return act(Kinds<with_spheres>{});
  return act(Kinds<with_triangles | with_spheres>{});
}

// Calls act(Model) with the narrowest model compiled: for pictures, and for rays that only want their hit.
struct ForPictures {
  Secondary secondary;
  template <class Act>
  void operator()(const SceneView<float>& scene, const Act& act) const {
    with_kinds(scene, [&]<unsigned kinds>(Kinds<kinds>) { with_secondary<kinds>(secondary, act); });
  }
  template <class Act>
  void operator()(const SceneView<double>&, const Act& act) const {
    act(GeneralModel<double>{});
  }
};
struct ForHits {
  template <class Act>
  void operator()(const SceneView<float>& scene, const Act& act) const {
    with_kinds(scene,
               [&]<unsigned kinds>(Kinds<kinds>) { act(Model<float, float, kinds, Secondary::none>{}); });
  }
  template <class Act>
  void operator()(const SceneView<double>&, const Act& act) const {
    act(GeneralModel<double>{});
  }
};

// Calls act(GridView, MergedGridView or NoGrid, Model, Counts or NoCounts): what a job needs, and no more.
// Counting and brute force run the general code: the bits are the same.
template <class Stored, class WithModel, class Act>
void with_everything(const SceneView<Stored>& scene, const GridFile* grid, const WithModel& with_model,
                     bool count, const Act& act) {
  if (grid == nullptr) return act(NoGrid{}, GeneralModel<Stored>{}, Counts{});
  const auto with_view = [&](const auto& view) {
    if (count) return act(view, GeneralModel<Stored>{}, Counts{});
    with_model(scene, [&](auto model) { act(view, model, NoCounts{}); });
  };
  grid->is_merged() ? with_view(grid->merged_view<Stored>()) : with_view(grid->view<Stored>());
}

// A question as a type.
template <Question question_>
struct Asked {
  static constexpr Question question = question_;
};
// Calls act(Asked).
template <class Act>
void with_question(Question question, const Act& act) {
  question == Question::nearest ? act(Asked<Question::nearest>{}) : act(Asked<Question::blocked>{});
}

// A listed ray scaled by a power of two, so that its direction's largest component is between 1 and 2 and
// nothing overflows on the way; t is scaled back by `scale`. Exact.
template <class Real>
struct ScaledRay {
  Ray<Real> ray;
  Real scale;
};

template <class Real>
MASU_HD inline ScaledRay<Real> scaled(const ListedRay& listed) {
  const float scale = inverse_power_of_two(largest_magnitude(listed.direction));
  return {{cast<Real>(listed.origin), cast<Real>(listed.direction * scale), RealTraits<Real>::largest},
          static_cast<Real>(scale)};
}

MASU_HD inline EyeHit blocked_hit(bool blocked) {
  return {1, blocked ? 0 : -1};
}

// What a listed ray hits, or whether it is blocked.
template <Question question, class M, class Grid, class C>
MASU_HD inline EyeHit trace_listed(const SceneView<typename M::Stored>& scene, const Grid& grid,
                                   const ListedRay& listed, HitName name, C& counts) {
  using Real = typename M::Real;
  ScaledRay<Real> ray = scaled<Real>(listed);
  if constexpr (question == Question::blocked) {
    ray.ray.t_max = 1 / ray.scale;
    const bool blocked = is_blocked<M::kinds>(scene, grid, ray.ray, counts);
    counts.shadow_ray(blocked);
    return blocked_hit(blocked);
  }
  const Hit<Real> hit = nearest_hit<M::kinds>(scene, grid, ray.ray, counts);
  counts.eye_ray(hit.primitive != no_primitive);
  return eye_hit(scene, hit, ray.scale, name);
}

// What looks for the answer to a question.
template <Question question, class M, class C>
using VisitorFor = std::conditional_t<question == Question::nearest,
                                      NearestHit<M::kinds, typename M::Real, typename M::Stored, C>,
                                      AnyHit<M::kinds, typename M::Real, typename M::Stored, C>>;

template <unsigned kinds, class Real, class Stored, class C>
MASU_HD inline void reset(NearestHit<kinds, Real, Stored, C>& visitor, Real t_max) {
  visitor.hit = {t_max, 0};
}
template <unsigned kinds, class Real, class Stored, class C>
MASU_HD inline void reset(AnyHit<kinds, Real, Stored, C>& visitor, Real t_max) {
  visitor.t_max = t_max;
  visitor.found = false;
}

// What a visitor found on a listed ray that was scaled and clipped.
template <unsigned kinds, class Real, class Stored, class C>
MASU_HD inline EyeHit found_by(const NearestHit<kinds, Real, Stored, C>& visitor, Real t_max, Real skipped,
                               Real scale, HitName name) {
  const bool met = visitor.hit.t < t_max;
  return eye_hit(visitor.scene,
                 Hit<Real>{visitor.hit.t + skipped, met ? visitor.hit.primitive : no_primitive}, scale, name);
}
template <unsigned kinds, class Real, class Stored, class C>
MASU_HD inline EyeHit found_by(const AnyHit<kinds, Real, Stored, C>& visitor, Real, Real, Real, HitName) {
  return blocked_hit(visitor.found);
}

} // namespace masu
