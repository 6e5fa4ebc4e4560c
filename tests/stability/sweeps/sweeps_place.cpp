// Position and size of the scene, and origins of rays.
#include "stability/sweeps/sweep.h"

#include <cmath>

namespace masu::stability {
namespace {

template <class Stored, Kinds kinds = Kinds::all>
Trial<Stored> moved(Chance& chance, double parameter, std::size_t rays) {
  const Vec3d at = somewhere * parameter;
  return {random_scene<Stored>(chance, at, 1, kinds), rays_around<Stored>(chance, at, 1, rays)};
}

// The largest coordinate is about the parameter; half of it at the last step, near the largest that files
// allow.
template <class Stored, Kinds kinds = Kinds::all>
Trial<Stored> scaled(Chance& chance, double parameter, std::size_t rays) {
  const double last = std::is_same_v<Stored, float> ? 1e12 : 1e100;
  const double size = parameter >= last ? parameter / 2 : parameter * 2;
  Trial<Stored> trial{random_scene<Stored>(chance, {0, 0, 0}, size, kinds), {}};
  trial.rays = rays_around<Stored>(chance, {0, 0, 0}, size, rays);
  return trial;
}

// One sphere, and rays from that many radii away, outside the scene's bounds.
template <class Stored>
Trial<Stored> ball_from_afar(Chance& chance, double parameter, std::size_t rays) {
  Trial<Stored> trial;
  trial.scene.spheres = {sphere_of<Stored>({0.25, -0.5, 0.125}, 1)};
  for (std::size_t i = 0; i < rays; ++i) {
    const Vec3d center{0.25, -0.5, 0.125}, from = center + chance.direction() * parameter;
    const Vec3d towards = across(chance, center - from);
    trial.rays.push_back(ray_towards<Stored>(from, center + towards * chance.uniform(0, 1.3)));
  }
  return trial;
}

// The same with a floor that extends beyond the rays' origins, so that they are inside the scene's bounds.
template <class Stored>
Trial<Stored> ball_on_a_floor(Chance& chance, double parameter, std::size_t rays) {
  Trial<Stored> trial = ball_from_afar<Stored>(chance, parameter, rays);
  const double far = 1.5 * parameter;
  const Vec3d left{-far, -far, -2}, right{far, -far, -2}, top{-far, -far, 2 * far};
  trial.scene.triangles = {triangle_of<Stored>(left, right, Vec3d{0, far, -2}),
                           triangle_of<Stored>(left, top, Vec3d{0, -far, far})};
  return trial;
}

// A point on a primitive's surface, up to rounding.
template <class Stored>
Vec3d point_on(Chance& chance, const TestScene<Stored>& scene) {
  if (scene.spheres.empty() || chance.one_in(2)) {
    const Triangle<double> t = widened(scene.triangles[chance.index(scene.triangles.size())]);
    double u = chance.uniform(0, 1), v = chance.uniform(0, 1);
    if (u + v > 1) u = 1 - u, v = 1 - v;
    return t.a + (t.b - t.a) * u + (t.c - t.a) * v;
  }
  const Sphere<double> s = widened(scene.spheres[chance.index(scene.spheres.size())]);
  return s.center + chance.direction() * std::abs(s.radius);
}

// Rays that begin at the parameter's distance from a surface.
template <class Stored, Kinds kinds = Kinds::all>
Trial<Stored> started(Chance& chance, double parameter, std::size_t rays) {
  Trial<Stored> trial{random_scene<Stored>(chance, {0, 0, 0}, 1, kinds), {}};
  for (std::size_t i = 0; i < rays; ++i) {
    const Vec3d from = point_on(chance, trial.scene) + chance.direction() * parameter;
    trial.rays.push_back(parameter > 1 ? ray_towards<Stored>(from, chance.in_cube(0.8))
                                       : ray_along<Stored>(from, chance.direction()));
  }
  return trial;
}

} // namespace

std::vector<Sweep> place_sweeps() {
  const Sweep of_moved{.name = "moved",
                       .parameter = "distance of a scene of size 1 from the origin",
                       .float32_steps = powers_of_ten(0, 8),
                       .float64_steps = powers_of_ten(0, 16, 2),
                       .float32 = moved<float>,
                       .float64 = moved<double>,
                       .robust = {0, 1e3},
                       .doubled = {0, 1e7},
                       .doubled64 = {0, 1e12}};
  const Sweep of_scaled{.name = "scaled",
                        .parameter = "size of the scene",
                        .float32_steps = powers_of_ten(-10, 12, 2),
                        .float64_steps = powers_of_ten(-90, 100, 19),
                        .float32 = scaled<float>,
                        .float64 = scaled<double>};
  const Sweep of_starts{.name = "start",
                        .parameter = "distance from a surface at which rays begin, scene of size 1",
                        .float32_steps = zero_and_powers_of_ten(-8, 10, 2),
                        .float32 = started<float>,
                        .robust = {1e-4, 1e10}};
  return {
      of_moved,
      triangles_alone(of_moved, moved<float, Kinds::triangles>),
      of_scaled,
      triangles_alone(of_scaled, scaled<float, Kinds::triangles>),
      {.name = "far-ball",
       .parameter = "distance of ray origins from a single sphere, in radii",
       .float32_steps = powers_of_ten(0, 8),
       .float64_steps = powers_of_ten(0, 16, 4),
       .float32 = ball_from_afar<float>,
       .float64 = ball_from_afar<double>,
       .robust = {10, 1e8},
       .doubled64 = {1e4, 1e16}},
      {.name = "small-ball",
       .parameter = "distance of ray origins from a sphere, in radii, within a scene of that size",
       .float32_steps = powers_of_ten(0, 8),
       .float64_steps = powers_of_ten(0, 16, 4),
       .float32 = ball_on_a_floor<float>,
       .float64 = ball_on_a_floor<double>,
       .robust = {10, 1e4},
       .doubled64 = {1e4, 1e12}},
      of_starts,
      triangles_alone(of_starts, started<float, Kinds::triangles>),
  };
}

} // namespace masu::stability
