// Rays and surfaces relative to voxels.
#include "libgrid/grid/division.h"
#include "stability/sweeps/sweep.h"

#include <algorithm>
#include <cmath>

namespace masu::stability {
namespace {

// Rays along an axis, with other components of the parameter's size and either sign, signed zeros included.
template <class Stored, Kinds kinds = Kinds::all>
Trial<Stored> along_axes(Chance& chance, double parameter, std::size_t rays) {
  Trial<Stored> trial{random_scene<Stored>(chance, {0, 0, 0}, 1, kinds), {}};
  for (std::size_t i = 0; i < rays; ++i) {
    const int axis = chance.whole(0, 2);
    Vec3d direction{parameter * chance.sign(), parameter * chance.sign(), parameter * chance.sign()};
    direction.set(axis, chance.sign());
    Vec3d from = chance.in_cube(0.8);
    if (chance.one_in(2)) from.set(axis, -direction[axis] * chance.uniform(1, 4));
    trial.rays.push_back(ray_along<Stored>(from, direction));
  }
  return trial;
}

// Surfaces in voxels' faces and in the bounds of the space, N voxels per axis; rays in faces, along edges,
// and from corner to corner.
template <class Stored>
Trial<Stored> on_faces(Chance& chance, double parameter, std::size_t rays) {
  const int voxels = static_cast<int>(parameter);
  Trial<Stored> trial;
  TestScene<Stored>& scene = trial.scene;
  // These determine the bounds, and so the space; some of them lie in its faces.
  scene.triangles = {triangle_of<Stored>({-1, -1, -1}, {1, -1, -1}, {-1, 1, -1}),
                     triangle_of<Stored>({1, 1, 1}, {1, -1, 1}, {1, 1, -1})};
  const Boxd space = space_of<Stored>(scene.bounds(), SpaceRule::tight);
  const auto plane = [&](int number) {
    return kept<Stored>(space.min.x + (space.max.x - space.min.x) * number / voxels);
  };
  const auto inner_plane = [&] {
    return voxels > 2 ? plane(chance.whole(1, voxels - 1)) : plane(voxels / 2) / 2;
  };
  const auto corner = [&] { return Vec3d{inner_plane(), inner_plane(), inner_plane()}; };
  const auto clamp = [](const Vec3d& v) {
    return Vec3d{std::clamp(v.x, -1.0, 1.0), std::clamp(v.y, -1.0, 1.0), std::clamp(v.z, -1.0, 1.0)};
  };
  for (int i = 0; i < 10; ++i) {
    const int axis = chance.whole(0, 2);
    Vec3d a = corner(), b = corner(), c = corner();
    b.set(axis, a[axis]);
    c.set(axis, a[axis]);
    scene.add(triangle_of<Stored>(clamp(a), clamp(b), clamp(c)));
  }
  for (int i = 0; i < 4; ++i) {
    const Vec3d center = clamp(corner() * 0.5);
    scene.add(sphere_of<Stored>(center, std::min(0.4, 2.0 / voxels)));
    Vec3d apex = center;
    const int axis = chance.whole(0, 2);
    apex.set(axis, clamp(corner())[axis]);
    add_cone(scene, cone_of<Stored>(center, 0.25, apex, chance.one_of({0.25, 0.0, 0.125})));
  }
  // Origins in planes, off all planes, or outside.
  const auto coordinate = [&](bool on_plane) {
    return on_plane ? plane(chance.whole(0, voxels)) : chance.uniform(-1, 1);
  };
  for (std::size_t i = 0; i < rays; ++i) {
    const int axis = chance.whole(0, 2), faces = chance.whole(1, 3);
    Vec3d from{}, to{};
    for (int k = 0; k < 3; ++k) {
      const int other = (axis + k) % 3;
      from.set(other, coordinate(k < faces));
      // In the face or along the edge; from corner to corner where it begins at a corner.
      to.set(other, k < faces && faces < 3 ? from[other] : coordinate(faces == 3));
    }
    const Ray<double> ray = ray_towards<Stored>(from, to);
    trial.rays.push_back(ray);
    if (chance.one_in(3)) trial.rays.back().origin = kept<Stored>(ray.origin - ray.direction * 4.0);
  }
  trial.grids = {
      {{voxels, voxels, voxels}, StructureKind::uniform},
      {{voxels, voxels, voxels}, StructureKind::x},
      {{std::min(voxels, 64), std::min(voxels, 64), std::min(voxels, 64)}, StructureKind::irregular},
      {{1, 1, 1}, StructureKind::hierarchy}};
  return trial;
}

// Grids with the parameter's number of voxels along one or two axes.
template <class Stored>
Trial<Stored> divided_by(Chance& chance, double parameter, std::size_t rays) {
  const auto voxels = static_cast<std::int32_t>(parameter);
  Trial<Stored> trial{random_scene<Stored>(chance, {0, 0, 0}, 1),
                      rays_around<Stored>(chance, {0, 0, 0}, 1, rays)};
  const std::int32_t few = std::min(voxels, 128), many = std::min(voxels, 512);
  trial.grids = {{{voxels, 5, 3}, StructureKind::uniform},
                 {{2, voxels, 7}, StructureKind::x},
                 {{few, few, few}, StructureKind::uniform},
                 {{many, 4, many}, StructureKind::uniform},
                 {{few / 2 + 1, few / 4 + 1, few / 8 + 1}, StructureKind::irregular}};
  return trial;
}

// A space of width 1, depth of the parameter, and height of its square root.
template <class Stored, Kinds kinds = Kinds::all>
Trial<Stored> flattened(Chance& chance, double parameter, std::size_t rays) {
  const Vec3d sides{1, std::sqrt(parameter), parameter};
  Trial<Stored> trial;
  for (int i = 0; i < 30; ++i) {
    const Vec3d around = chance.in_cube(0.7);
    const auto corner = [&] { return (around + chance.in_cube(0.3)) * sides; };
    const Vec3d a = corner(), b = corner(), c = corner();
    trial.scene.add(triangle_of<Stored>(a, b, c));
  }
  for (int i = 0; kinds == Kinds::all && i < 10; ++i)
    trial.scene.add(sphere_of<Stored>(chance.in_cube(0.8) * sides, parameter * 0.2));
  for (std::size_t i = 0; i < rays; ++i) {
    const Vec3d from = chance.in_cube(2) * sides;
    trial.rays.push_back(
        ray_towards<Stored>(chance.one_in(3) ? chance.direction() * 3.0 : from, chance.in_cube(0.8) * sides));
  }
  return trial;
}

} // namespace

std::vector<Sweep> grid_sweeps() {
  std::vector<double> powers_of_two;
  for (int n = 1; n <= 4096; n *= 2)
    powers_of_two.push_back(n);
  const Sweep axis_rays{.name = "axis-ray",
                        .parameter = "components of the direction across an axis (1 along it)",
                        .float32_steps = {0, 1.5e-45, 1e-38, 1e-30, 1e-20, 1e-12, 1e-8, 1e-6, 1e-4},
                        .float64_steps = {0, 5e-324, 1e-308, 1e-200, 1e-100, 1e-30, 1e-20, 1e-10},
                        .float32 = along_axes<float>,
                        .float64 = along_axes<double>};
  const Sweep proportions{.name = "proportions",
                          .parameter = "depth of a scene over its width",
                          .float32_steps = powers_of_ten(-8, 0),
                          .float32 = flattened<float>,
                          .robust = {1e-4, 1}};
  return {
      axis_rays,
      triangles_alone(axis_rays, along_axes<float, Kinds::triangles>),
      {.name = "voxel-face",
       .parameter = "voxels per axis; rays and surfaces in their faces",
       .float32_steps = {1, 2, 3, 4, 8, 16, 32, 64, 100, 128},
       .float64_steps = {4, 16, 64},
       .float32 = on_faces<float>,
       .float64 = on_faces<double>},
      {.name = "division",
       .parameter = "voxels along an axis",
       .float32_steps = powers_of_two,
       .float32 = divided_by<float>},
      proportions,
      triangles_alone(proportions, flattened<float, Kinds::triangles>),
  };
}

} // namespace masu::stability
