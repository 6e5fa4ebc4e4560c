#include "stability/ray_sets.h"

#include "libscene/base/parallel.h"
#include "libscene/geometry/random_rays.h"

namespace masu {
namespace {

// Calls act(ray's index, surface point hit, ray's direction) for each ray, in parallel; the point is null for
// a miss.
template <class Stored, class Act>
void for_each_hit(const SceneFile& file, const SceneView<Stored>& scene, const StructureFile& grid,
                  std::span<const Ray<double>> rays, const Act& act) {
  const RayHits hits =
      ResidentTracer(file, &grid, Device::cpu).hits(relative(RayList(rays)), {}, HitName::primitive);
  parallel_for(rays.size(), [&](std::size_t i) {
    const HitRecord& hit = hits.hits[i];
    if (hit.name < 0) return act(i, static_cast<const SurfacePoint<Stored>*>(nullptr), Vec3<Stored>{});
    const Ray<Stored> ray = unbounded_ray(cast<Stored>(rays[i].origin), cast<Stored>(rays[i].direction));
    const Hit<Stored> found{static_cast<Stored>(hit.t), static_cast<PrimitiveIndex>(hit.name)};
    const SurfacePoint<Stored> point = surface_at<with_all_kinds>(
        scene, hit_again(scene, ray, found, [&] { return leaf_of(scene, found.primitive); }));
    act(i, &point, ray.direction);
  });
}

// Scattered diffusely from a hit of a ray that comes in.
template <class Stored>
Ray<double> scattered(const SurfacePoint<Stored>& point, const Vec3<Stored>& incoming,
                      RandomSequence& random) {
  const Vec3d normal = cast<double>(facing(point, incoming).normal);
  const Vec3<Stored> direction = cast<Stored>(random_diffuse_direction(normal, random));
  return unbounded_ray(cast<double>(leaving(point, direction)), cast<double>(direction));
}

// Rays made of hits by make(ray's index, point, ray's direction), in the rays' order.
template <class Stored, class Make>
std::vector<Ray<double>> from_hits(const SceneFile& file, const SceneView<Stored>& scene,
                                   const StructureFile& grid, std::span<const Ray<double>> rays,
                                   const Make& make) {
  std::vector<Ray<double>> all(rays.size());
  std::vector<std::uint8_t> present(rays.size(), 0);
  for_each_hit(file, scene, grid, rays, [&](std::size_t i, const auto* point, const auto& incoming) {
    if (point == nullptr) return;
    all[i] = make(i, *point, incoming);
    present[i] = 1;
  });
  std::vector<Ray<double>> kept;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (present[i] != 0) kept.push_back(all[i]);
  }
  return kept;
}

template <class Stored>
std::vector<Ray<double>> primary(const Camera& camera, RayOrder order) {
  constexpr std::int32_t tile_columns = 8, tile_rows = 4;
  const CameraRays<Stored> view = camera_rays<Stored>(camera, Sampling::centers, false);
  std::vector<Ray<double>> rays;
  rays.reserve(static_cast<std::size_t>(camera.width) * static_cast<std::size_t>(camera.height));
  const auto add = [&](std::int32_t column, std::int32_t row) {
    const Ray<Stored> ray = camera_ray(view, column, row);
    rays.push_back(unbounded_ray(cast<double>(ray.origin), cast<double>(ray.direction)));
  };
  const std::int32_t columns = order == RayOrder::tiles ? tile_columns : camera.width;
  const std::int32_t rows = order == RayOrder::tiles ? tile_rows : 1;
  for (std::int32_t top = 0; top < camera.height; top += rows) {
    for (std::int32_t left = 0; left < camera.width; left += columns) {
      for (std::int32_t row = top; row < std::min(top + rows, camera.height); ++row) {
        for (std::int32_t column = left; column < std::min(left + columns, camera.width); ++column)
          add(column, row);
      }
    }
  }
  return rays;
}

} // namespace

std::vector<Ray<double>> primary_rays(const SceneFile& scene, const Camera& camera, RayOrder order) {
  const Camera local = relative_to(scene.origin(), camera);
  return scene.is_float64() ? primary<double>(local, order) : primary<float>(local, order);
}

std::vector<Ray<double>> diffuse_rays(const SceneFile& scene, const StructureFile& grid,
                                      std::span<const Ray<double>> rays, std::uint64_t seed) {
  const Sphere<double> sphere = sphere_around(scene.bounds());
  std::vector<Ray<double>> all(rays.size());
  scene.with_view([&]<class Stored>(const SceneView<Stored>& view) {
    for_each_hit(scene, view, grid, rays, [&](std::size_t i, const auto* point, const auto& incoming) {
      RandomSequence random(seed, i);
      all[i] = point == nullptr ? random_ray<Stored>(sphere, random) : scattered(*point, incoming, random);
    });
  });
  return all;
}

std::vector<Ray<double>> random_rays(const SceneFile& scene, std::size_t count, std::uint64_t seed) {
  const Sphere<double> sphere = sphere_around(scene.bounds());
  std::vector<Ray<double>> rays(count);
  parallel_for(count, [&](std::size_t i) {
    RandomSequence random(seed, i);
    rays[i] = scene.is_float64() ? random_ray<double>(sphere, random) : random_ray<float>(sphere, random);
  });
  return rays;
}

std::vector<Ray<double>> random_places(const SceneFile& scene, std::size_t count, std::uint64_t seed) {
  const Boxd box = scene.bounds();
  std::vector<Ray<double>> rays(count);
  parallel_for(count, [&](std::size_t i) {
    RandomSequence random(seed, i);
    Vec3d place = box.min;
    for (int axis = 0; axis < 3; ++axis)
      place.set(axis, fma(random.uniform(), box.max[axis] - box.min[axis], box.min[axis]));
    rays[i] = unbounded_ray(place, Vec3d{1, 0, 0});
  });
  return rays;
}

std::vector<Ray<double>> shadow_rays(const SceneFile& scene, const StructureFile& grid,
                                     std::span<const Ray<double>> rays) {
  return scene.with_view([&]<class Stored>(const SceneView<Stored>& view) {
    const Lighting<Stored> lighting = scene.lighting<Stored>();
    if (lighting.light_count == 0) return std::vector<Ray<double>>{};
    return from_hits(scene, view, grid, rays, [&](std::size_t i, const auto& point, const auto&) {
      const Vec3<Stored> light = lighting.lights[i % lighting.light_count].position;
      const Vec3<Stored> origin = leaving(point, light - point.position);
      return Ray<double>{cast<double>(origin), 0, cast<double>(light - origin), 1};
    });
  });
}

std::vector<Ray<double>> ambient_rays(const SceneFile& scene, const StructureFile& grid,
                                      std::span<const Ray<double>> rays, std::uint64_t seed) {
  const double diagonal = 2 * sphere_around(scene.bounds()).radius;
  return scene.with_view([&](const auto& view) {
    return from_hits(scene, view, grid, rays, [&](std::size_t i, const auto& point, const auto& incoming) {
      RandomSequence random(seed, i);
      Ray<double> ray = scattered(point, incoming, random);
      ray.t_max = static_cast<float>(diagonal / 10);
      return ray;
    });
  });
}

} // namespace masu
