// Closed surfaces: leaks, rays that leave surfaces, and glass.
#include "stability/sweeps/mesh_rays.h"

#include <cmath>

namespace masu::stability {
namespace {

// --- Closed meshes --------------------------------------------------------------------------------------

template <class Stored>
Trial<Stored> rays_at_edges(Chance& chance, Mesh<double> mesh, const Vec3d& at, double size,
                            std::size_t rays) {
  for (Vec3d& corner : mesh.corners)
    corner = kept<Stored>(at + corner * size);
  Trial<Stored> trial;
  add_mesh(trial.scene, mesh);
  trial.rays = edge_rays<Stored>(chance, mesh, at, size, rays);
  return trial;
}

template <class Stored>
Trial<Stored> in_a_cube(Chance& chance, double parameter, std::size_t rays) {
  return rays_at_edges<Stored>(chance, cube(), somewhere * parameter, 1, rays);
}
template <class Stored>
Trial<Stored> in_a_ball(Chance& chance, double parameter, std::size_t rays) {
  return rays_at_edges<Stored>(chance, octahedron(chance, 2, 0.2), somewhere * parameter, 1, rays);
}
template <class Stored>
Trial<Stored> in_a_fan(Chance& chance, double parameter, std::size_t rays) {
  return rays_at_edges<Stored>(chance, double_fan(chance, 60), somewhere * parameter, 1, rays);
}
// A random kind of mesh, of the parameter's size.
template <class Stored>
Trial<Stored> in_a_scaled_mesh(Chance& chance, double parameter, std::size_t rays) {
  return rays_at_edges<Stored>(chance, random_mesh(chance), {0, 0, 0}, parameter / 2, rays);
}

// --- Rays that leave surfaces ---------------------------------------------------------------------------

// A box, spheres and cones, all convex and disjoint.
template <class Stored>
Trial<Stored> bodies(Chance& chance, const Vec3d& at, double size, std::size_t rays) {
  Trial<Stored> trial;
  const auto place = [&](const Vec3d& v) { return at + v * size; };
  Mesh<double> box = cube();
  for (Vec3d& corner : box.corners)
    corner = place(corner * 0.3);
  add_mesh(trial.scene, box);
  for (const double x : {-0.7, 0.7}) {
    trial.scene.add(sphere_of<Stored>(place({x, 0, chance.uniform(-0.1, 0.1)}), 0.25 * size));
    add_cone(trial.scene,
             cone_of<Stored>(place({x / 2, 0.5, -0.2}), 0.15 * size,
                             place({x / 2, 0.8, chance.uniform(0.1, 0.3)}), (x < 0 ? 0.05 : 0.15) * size));
  }
  for (std::size_t i = 0; i < rays; ++i) {
    trial.rays.push_back(ray_towards<Stored>(place(chance.direction() * 3.0), place(chance.in_cube(0.8))));
    trial.aims.push_back(chance.direction());
  }
  return trial;
}
template <class Stored>
Trial<Stored> left_scaled(Chance& chance, double parameter, std::size_t rays) {
  return bodies<Stored>(chance, {0, 0, 0}, parameter, rays);
}
template <class Stored>
Trial<Stored> left_moved(Chance& chance, double parameter, std::size_t rays) {
  return bodies<Stored>(chance, somewhere * parameter, 1, rays);
}

// A slab of some width and a tenth as thick, turned anyhow, and three balls of size 1 above it or sunk into
// it; all its six sides are drawn as 4 x 4 squares, whose corners are rounded: so neighbours are nearly
// coplanar. Rays hit it near the balls, and leave it at all angles.
template <class Stored>
Trial<Stored> on_a_slab(Chance& chance, double width, double sine, std::size_t rays) {
  Trial<Stored> trial;
  const Vec3d up = chance.direction(), u = across(chance, up), v = cross(up, u);
  constexpr int squares = 4;
  const Vec3d half[3] = {u * (width / 2), v * (width / 2), up * (width / 20)};
  const Vec3d middle = up * (-width / 20) + u * (width * chance.uniform(-0.1, 0.1));
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      const Vec3d center = middle + half[axis] * side, a = half[(axis + 1) % 3], b = half[(axis + 2) % 3];
      const auto corner = [&](int i, int k) {
        return center + a * (2.0 * i / squares - 1) + b * (2.0 * k / squares - 1);
      };
      for (int i = 0; i < squares; ++i) {
        for (int k = 0; k < squares; ++k) {
          trial.scene.add(triangle_of<Stored>(corner(i, k), corner(i + 1, k), corner(i + 1, k + 1)));
          trial.scene.add(triangle_of<Stored>(corner(i, k), corner(i + 1, k + 1), corner(i, k + 1)));
        }
      }
    }
  }
  for (const double height : {0.55, 0.5, 0.3})
    trial.scene.add(
        sphere_of<Stored>(u * chance.uniform(-2, 2) + v * chance.uniform(-2, 2) + up * height, 0.5));
  for (std::size_t i = 0; i < rays; ++i) {
    const double reach = chance.one_in(2) ? 3 : width / 2;
    const Vec3d at = u * chance.uniform(-reach, reach) + v * chance.uniform(-reach, reach);
    trial.rays.push_back(ray_towards<Stored>(at + (up * 1.5 + chance.in_cube(1)) * 4.0, at));
    trial.aims.push_back(chance.direction());
    trial.sines.push_back(sine > 0 ? sine : std::pow(10.0, chance.uniform(-4, 0)));
  }
  return trial;
}
template <class Stored>
Trial<Stored> left_by_contrast(Chance& chance, double parameter, std::size_t rays) {
  return on_a_slab<Stored>(chance, parameter, 0, rays);
}
template <class Stored>
Trial<Stored> left_grazing(Chance& chance, double parameter, std::size_t rays) {
  return on_a_slab<Stored>(chance, 100, parameter, rays);
}

// --- Glass ----------------------------------------------------------------------------------------------

// Spheres within spheres and in a box, all of glass.
template <class Stored>
Trial<Stored> glass(Chance& chance, std::size_t rays) {
  Trial<Stored> trial = bodies<Stored>(chance, {0, 0, 0}, 1, 0);
  for (const double radius : {0.28, 0.2, 0.15, 0.1, 0.05})
    trial.scene.add(sphere_of<Stored>({0, 0, 0}, radius));
  for (const double radius : {0.2, 0.1})
    trial.scene.add(sphere_of<Stored>({0.7, 0, 0}, radius));
  for (std::size_t i = 0; i < rays; ++i)
    trial.rays.push_back(ray_towards<Stored>(chance.direction() * 3.0, chance.in_cube(0.5)));
  return trial;
}
template <class Stored>
Trial<Stored> glass_of_index(Chance& chance, double parameter, std::size_t rays) {
  Trial<Stored> trial = glass<Stored>(chance, rays);
  trial.scene.material = {{0, 0, 0}, 0, 0.25F, 1, 0.75F, static_cast<float>(parameter)};
  trial.depth = 8;
  return trial;
}
template <class Stored>
Trial<Stored> deep_glass(Chance& chance, double parameter, std::size_t rays) {
  Trial<Stored> trial = glass<Stored>(chance, rays);
  trial.scene.material = {{0, 0, 0}, 0, 0, 1, 1, 1.5F};
  trial.depth = static_cast<std::int32_t>(parameter);
  return trial;
}

// --- Snell's law ----------------------------------------------------------------------------------------

// Rays that reach a surface from behind; the sine of their angle differs from the critical angle's by the
// relative amount `from_critical`, in either direction.
template <class Stored>
Trial<Stored> refracted_by(Chance& chance, double index, double from_critical, std::size_t rays) {
  Trial<Stored> trial;
  trial.scene.material = {{0, 0, 0}, 0, 0, 1, 1, static_cast<float>(index)};
  const Vec3d up = chance.direction(), u = across(chance, up), v = cross(up, u);
  const auto corner = [&](double x, double y) { return u * x + v * y; };
  trial.scene.triangles = {triangle_of<Stored>(corner(-8, -8), corner(8, -8), corner(0, 8))};
  for (std::size_t i = 0; i < rays; ++i) {
    const double sine = std::min(0.9999, (1 + chance.sign() * from_critical) /
                                             static_cast<double>(trial.scene.material.refraction_index));
    const double turn = chance.uniform(0, 6.283185307179586);
    const Vec3d along = u * std::cos(turn) + v * std::sin(turn);
    const Vec3d direction = along * sine + up * std::sqrt(1 - sine * sine);
    trial.rays.push_back(ray_along<Stored>(u * chance.uniform(-1, 1) - direction, direction));
  }
  return trial;
}
template <class Stored>
Trial<Stored> near_critical(Chance& chance, double parameter, std::size_t rays) {
  return refracted_by<Stored>(chance, 1.5, parameter, rays);
}
template <class Stored>
Trial<Stored> nearly_no_glass(Chance& chance, double parameter, std::size_t rays) {
  return refracted_by<Stored>(chance, 1 + parameter, chance.one_of({0.5, 0.1, 1e-3}), rays);
}

} // namespace

std::vector<Sweep> body_sweeps() {
  const auto closed = [](const char* name, double share, decltype(Sweep::float32) float32,
                         decltype(Sweep::float64) float64) {
    return Sweep{.name = name,
                 .parameter = "distance from the origin; rays at edges and corners from inside",
                 .judge = Judge::enclosed,
                 .share = share,
                 .float32_steps = powers_of_ten(0, 6),
                 .float64_steps = powers_of_ten(0, 15, 3),
                 .float32 = float32,
                 .float64 = float64};
  };
  return {
      closed("closed-cube", 10, in_a_cube<float>, in_a_cube<double>),
      closed("closed-ball", 4, in_a_ball<float>, in_a_ball<double>),
      closed("closed-fan", 4, in_a_fan<float>, in_a_fan<double>),
      {.name = "closed-scaled",
       .parameter = "size of a closed mesh; rays at edges and corners from inside",
       .judge = Judge::enclosed,
       .share = 4,
       .float32_steps = powers_of_ten(-9, 12, 3),
       .float64_steps = powers_of_ten(-89, 100, 21),
       .float32 = in_a_scaled_mesh<float>,
       .float64 = in_a_scaled_mesh<double>},
      {.name = "leaving-scaled",
       .parameter = "size of the scene whose surfaces rays leave",
       .judge = Judge::leaving,
       .float32_steps = powers_of_ten(-8, 12, 2),
       .float64_steps = powers_of_ten(-80, 80, 20),
       .float32 = left_scaled<float>,
       .float64 = left_scaled<double>},
      {.name = "leaving-moved",
       .parameter = "distance from the origin of a scene of size 1",
       .judge = Judge::leaving,
       .float32_steps = powers_of_ten(0, 6),
       .float64_steps = powers_of_ten(0, 14, 2),
       .float32 = left_moved<float>,
       .float64 = left_moved<double>,
       .robust = {0, 1e3},
       .doubled64 = {0, 1e12}},
      {.name = "leaving-contrast",
       .parameter = "width of a slab over the size of what stands on it",
       .judge = Judge::leaving,
       .float32_steps = powers_of_ten(0, 9),
       .float64_steps = powers_of_ten(0, 9, 3),
       .float32 = left_by_contrast<float>,
       .float64 = left_by_contrast<double>,
       .robust = {10, 1e4}},
      {.name = "leaving-grazing",
       .parameter = "sine of the angle at which rays leave a slab",
       .judge = Judge::leaving,
       .float32_steps = powers_of_ten(-4, 0),
       .float64_steps = powers_of_ten(-12, 0, 4),
       .float32 = left_grazing<float>,
       .float64 = left_grazing<double>},
      {.name = "glass",
       .parameter = "index of refraction, depth 8",
       .judge = Judge::glass,
       .share = 0.05,
       .float32_steps = {0.01, 0.5, 1, 1 + 1e-6, 1.001, 1.5, 2.4, 100},
       .float64_steps = {1, 1.5},
       .float32 = glass_of_index<float>,
       .float64 = glass_of_index<double>},
      {.name = "deep-glass",
       .parameter = "depth of the last ray",
       .judge = Judge::glass,
       .share = 0.25,
       .float32_steps = {1, 2, 4, 8, 16, 32},
       .float64_steps = {32},
       .float32 = deep_glass<float>,
       .float64 = deep_glass<double>},
      {.name = "critical-angle",
       .parameter = "distance of the sine from the critical angle's, relative",
       .judge = Judge::refraction,
       .share = 2,
       .float32_steps = powers_of_ten(-8, -1),
       .float64_steps = powers_of_ten(-16, -1, 3),
       .float32 = near_critical<float>,
       .float64 = near_critical<double>,
       .robust = {1e-5, 1},
       .doubled64 = {1e-13, 1}},
      {.name = "nearly-air",
       .parameter = "index of refraction less 1",
       .judge = Judge::refraction,
       .share = 2,
       .float32_steps = powers_of_ten(-7, 0),
       .float32 = nearly_no_glass<float>,
       .robust = {1e-5, 1}},
  };
}

} // namespace masu::stability
