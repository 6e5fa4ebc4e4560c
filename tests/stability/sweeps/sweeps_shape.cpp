// Shapes of primitives that cause cancellation.
#include "stability/sweeps/sweep.h"

#include <algorithm>
#include <cmath>

namespace masu::stability {
namespace {

// Behind the primitives, so that rays that miss them hit something.
template <class Stored>
void add_wall(TestScene<Stored>& scene) {
  scene.add(triangle_of<Stored>({-4, -4, -1}, {4, -4, -1}, {0, 6, -1}));
}

Vec3d eye(Chance& chance) {
  return {chance.uniform(-1, 1), chance.uniform(-1, 1), chance.uniform(1, 2)};
}

// Triangles of length 1 and the parameter's width. Rays pass within a few widths.
template <class Stored>
Trial<Stored> needles(Chance& chance, double parameter, std::size_t rays) {
  Trial<Stored> trial;
  add_wall(trial.scene);
  struct Needle {
    Vec3d from, along, side;
  };
  std::vector<Needle> needles;
  for (int i = 0; i < 24; ++i) {
    const Vec3d along = chance.direction();
    needles.push_back({chance.in_cube(0.6), along, across(chance, along)});
    const auto& [from, to, side] = needles.back();
    const Vec3d tip = from + to, wide = from + to * chance.uniform(0, 1) + side * parameter;
    trial.scene.add(triangle_of<Stored>(from, tip, wide));
  }
  for (std::size_t i = 0; i < rays; ++i) {
    const Needle& needle = needles[chance.index(needles.size())];
    const double off = std::max(parameter, 1e-3 * chance.power_of_two(-20, 0));
    trial.rays.push_back(ray_towards<Stored>(eye(chance), needle.from +
                                                              needle.along * chance.uniform(-0.1, 1.1) +
                                                              needle.side * (off * chance.uniform(-1, 2))));
  }
  return trial;
}

// A triangle, a sphere and a cone; rays hit them at the parameter's angle (radians), or pass them as closely.
template <class Stored, Kinds kinds = Kinds::all>
Trial<Stored> grazed(Chance& chance, double parameter, std::size_t rays) {
  Trial<Stored> trial;
  const Vec3d a{-1, -1, 0.125}, b{1, -0.75, 0}, c{0, 1, -0.0625};
  trial.scene.triangles = {triangle_of<Stored>(a, b, c)};
  const Vec3d center{3, 0.25, 0.5}, base{-3, -1, 0}, axis{0.25, 2, 0.125};
  if (kinds == Kinds::all) {
    trial.scene.spheres = {sphere_of<Stored>(center, 1)};
    trial.scene.cones = {cone_of<Stored>(base, 0.75, base + axis, 0.25)};
  }
  const Vec3d normal = normalized(cross(b - a, c - a));
  for (std::size_t i = 0; i < rays; ++i) {
    Vec3d point{}, outwards{};
    switch (kinds == Kinds::all ? chance.whole(0, 2) : 0) {
    case 0:
      point =
          (a + b + c) * (1.0 / 3) + (b - a) * chance.uniform(-0.2, 0.2) + (c - a) * chance.uniform(-0.2, 0.2);
      outwards = normal;
      break;
    case 1:
      outwards = chance.direction();
      point = center + outwards;
      break;
    default: {
      const Vec3d away = across(chance, axis);
      const double z = chance.uniform(0.1, 0.9);
      outwards = normalized(away * length(axis) + axis * (0.5 / length(axis)));
      point = base + axis * z + away * (0.75 - 0.5 * z);
      break;
    }
    }
    const Vec3d along = across(chance, outwards);
    const Vec3d direction = along * std::cos(parameter) - outwards * std::sin(parameter);
    // Half of the rays pass curved surfaces: they are moved outwards by more than the sagitta of the angle.
    const double lift = chance.one_in(2) ? 0 : 1.5 * parameter * parameter;
    trial.rays.push_back(
        ray_along<Stored>(point + outwards * lift - direction * chance.uniform(0.5, 1.5), direction));
  }
  return trial;
}

Vec3d cone_place(Chance& chance) {
  return chance.in_cube(0.5);
}

// Cones whose radii differ by the parameter, relative; 0: cylinders.
template <class Stored>
Trial<Stored> tapered(Chance& chance, double parameter, std::size_t rays) {
  Trial<Stored> trial;
  add_wall(trial.scene);
  for (int i = 0; i < 8; ++i) {
    const Vec3d base = cone_place(chance);
    const double radius = chance.uniform(0.05, 0.3);
    add_cone(trial.scene, cone_of<Stored>(base, radius, base + chance.direction() * chance.uniform(0.3, 1),
                                          radius * (1 - parameter)));
  }
  for (std::size_t i = 0; i < rays; ++i) {
    const Cone<double> cone = widened(trial.scene.cones[chance.index(trial.scene.cones.size())]);
    const Vec3d axis = cone.apex - cone.base, side = across(chance, axis);
    const Vec3d from = chance.one_in(3) ? cone.base + axis * chance.uniform(-1, 2) : eye(chance);
    trial.rays.push_back(ray_towards<Stored>(from, cone.base + axis * chance.uniform(0, 1) +
                                                       side * (cone.base_radius * chance.uniform(0, 1.2))));
  }
  return trial;
}

// Pointed cones, hit at the parameter's distance from the apex, in lengths.
template <class Stored>
Trial<Stored> tips(Chance& chance, double parameter, std::size_t rays) {
  Trial<Stored> trial;
  add_wall(trial.scene);
  for (int i = 0; i < 8; ++i) {
    const Vec3d base = cone_place(chance);
    add_cone(trial.scene, cone_of<Stored>(base, chance.uniform(0.05, 0.5), base + chance.direction(), 0));
  }
  for (std::size_t i = 0; i < rays; ++i) {
    const Cone<double> cone = widened(trial.scene.cones[chance.index(trial.scene.cones.size())]);
    const Vec3d axis = cone.apex - cone.base, side = across(chance, axis);
    const Vec3d target = cone.apex - axis * (parameter * chance.uniform(0, 1)) +
                         side * (cone.base_radius * parameter * chance.uniform(0, 1));
    trial.rays.push_back(ray_towards<Stored>(eye(chance), target));
  }
  return trial;
}

// Cones of radii 1 and 0.5 and the parameter's length.
template <class Stored>
Trial<Stored> flat_cones(Chance& chance, double parameter, std::size_t rays) {
  Trial<Stored> trial;
  add_wall(trial.scene);
  // At the origin, where short lengths are representable.
  const Vec3d axis = chance.direction() * parameter;
  add_cone(trial.scene, cone_of<Stored>({0, 0, 0}, 1, axis, 0.5));
  for (std::size_t i = 0; i < rays; ++i) {
    const Vec3d side = across(chance, axis);
    trial.rays.push_back(
        ray_towards<Stored>(eye(chance), axis * chance.uniform(-1, 2) + side * chance.uniform(0.4, 1.1)));
  }
  return trial;
}

// Copies of every primitive.
template <class Stored>
Trial<Stored> duplicated(Chance& chance, double parameter, std::size_t rays) {
  Trial<Stored> trial{random_scene<Stored>(chance, {0, 0, 0}, 1),
                      rays_around<Stored>(chance, {0, 0, 0}, 1, rays)};
  const auto multiply = [&](auto& primitives) {
    const auto once = primitives;
    for (int copies = 1; copies < static_cast<int>(parameter); ++copies)
      primitives.insert(primitives.end(), once.begin(), once.end());
    std::shuffle(primitives.begin(), primitives.end(), chance.engine());
  };
  for_each_kind(trial.scene, multiply);
  return trial;
}

} // namespace

std::vector<Sweep> shape_sweeps() {
  const std::vector<double> down = powers_of_ten(-8, 0), to_zero = zero_and_powers_of_ten(-8, 0);
  const Sweep grazing{.name = "grazing",
                      .parameter = "angle between ray and surface, radians",
                      .float32_steps = down,
                      .float64_steps = down,
                      .float32 = grazed<float>,
                      .float64 = grazed<double>,
                      .robust = {1e-2, 1},
                      .doubled64 = {1e-6, 1}};
  return {
      {.name = "needle",
       .parameter = "width of triangles of length 1",
       .float32_steps = to_zero,
       .float32 = needles<float>,
       .robust = {1e-3, 1}},
      grazing,
      triangles_alone(grazing, grazed<float, Kinds::triangles>),
      {.name = "taper",
       .parameter = "difference of a cone's radii, relative",
       .share = 0.5,
       .float32_steps = to_zero,
       .float32 = tapered<float>},
      {.name = "tip",
       .parameter = "distance from a cone's apex, in lengths",
       .share = 0.5,
       .float32_steps = to_zero,
       .float32 = tips<float>,
       .robust = {1e-3, 1}},
      {.name = "flat-cone",
       .parameter = "length of a cone of radii 1 and 0.5",
       .share = 0.5,
       .float32_steps = down,
       .float32 = flat_cones<float>,
       .robust = {1e-3, 1}},
      {.name = "duplicates",
       .parameter = "copies of every primitive",
       .share = 0.25,
       .float32_steps = {2, 4, 16, 64},
       .float32 = duplicated<float>},
  };
}

} // namespace masu::stability
