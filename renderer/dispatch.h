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

// Calls act(Model) with the narrowest model that the scene fits. Scenes with cones mostly have the rest too.
template <class Act>
void with_model(const SceneView<float>& scene, Secondary secondary, const Act& act) {
  if (scene.cone_count > 0) return with_secondary<with_all_kinds>(secondary, act);
  if (scene.sphere_count == 0) return with_secondary<with_triangles>(secondary, act);
  if (scene.triangle_count == 0) return with_secondary<with_spheres>(secondary, act);
  return with_secondary<with_triangles | with_spheres>(secondary, act);
}
template <class Act>
void with_model(const SceneView<double>&, Secondary, const Act& act) {
  act(GeneralModel<double>{});
}

// Calls act(SceneView, GridView or NoGrid, Model, Counts or NoCounts): what a job needs, and no more.
// Counting and brute force run the general code: the bits are the same.
template <class Stored, class Act>
void with_everything(const SceneView<Stored>& scene, const GridFile* grid, Secondary secondary, bool count,
                     const Act& act) {
  if (grid == nullptr) return act(NoGrid{}, GeneralModel<Stored>{}, Counts{});
  const GridView<Stored> view = grid->view<Stored>();
  if (count) return act(view, GeneralModel<Stored>{}, Counts{});
  with_model(scene, secondary, [&](auto model) { act(view, model, NoCounts{}); });
}

// A listed ray scaled by a power of two, so that its direction's largest component is about 1 and nothing
// overflows on the way; t is scaled back by `scale`. Exact.
template <class Real>
struct ScaledRay {
  Ray<Real> ray;
  Real scale;
};

template <class Real>
MASU_HD inline ScaledRay<Real> scaled(const ListedRay& listed) {
  const Vec3<Real> direction = cast<Real>(listed.direction);
  int exponent = 0;
  std::frexp(largest_magnitude(direction), &exponent);
  const auto by = [&](Real component) { return std::ldexp(component, -exponent); };
  return {{cast<Real>(listed.origin),
           {by(direction.x), by(direction.y), by(direction.z)},
           RealTraits<Real>::largest},
          std::ldexp(Real(1), -exponent)};
}

// What a listed ray hits; t is infinite where nothing is.
template <class M, class Grid, class C>
MASU_HD inline EyeHit trace_listed(const SceneView<typename M::Stored>& scene, const Grid& grid,
                                   const ListedRay& listed, C& counts) {
  using Real = typename M::Real;
  const ScaledRay<Real> ray = scaled<Real>(listed);
  const Hit<Real> hit = nearest_hit<M::kinds>(scene, grid, ray.ray, counts);
  const bool met = hit.primitive != no_primitive;
  counts.eye_ray(met);
  if (!met) return {static_cast<float>(INFINITY), -1};
  return {static_cast<float>(hit.t * ray.scale),
          static_cast<std::int32_t>(surface_of(scene, hit.primitive).object)};
}

} // namespace masu
