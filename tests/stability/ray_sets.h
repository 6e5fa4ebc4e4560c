// Sets of rays for measurements: primary, diffuse, random, shadow and ambient rays. Their coordinates are
// numbers that the scene's store holds, so that every precision traces the same rays.
#pragma once

#include "renderer/tracer/tracer.h"

#include <vector>

namespace masu {

// Order of primary rays: row by row, or in tiles of 8 × 4 (a warp each).
enum class RayOrder { rows, tiles };

// One ray through the centre of each pixel.
std::vector<Ray<double>> primary_rays(const SceneFile& scene, const Camera& camera, RayOrder order);

// One ray from each hit of `rays`, in a direction with cosine distribution about the surface's normal; for a
// miss, a ray of random_rays. The same seed gives the same rays.
std::vector<Ray<double>> diffuse_rays(const SceneFile& scene, const StructureFile& grid,
                                      std::span<const Ray<double>> rays, std::uint64_t seed);

// Rays between two random points of the sphere around the scene's bounds; t = 1 is the second point.
std::vector<Ray<double>> random_rays(const SceneFile& scene, std::size_t count, std::uint64_t seed);

// Rays from random points of the scene's bounds, along x: places.
std::vector<Ray<double>> random_places(const SceneFile& scene, std::size_t count, std::uint64_t seed);

// One ray from each hit of `rays` to a light, ray i to light i modulo their number; t = 1 is the light. None
// for a miss.
std::vector<Ray<double>> shadow_rays(const SceneFile& scene, const StructureFile& grid,
                                     std::span<const Ray<double>> rays);

// One ray from each hit of `rays` as far as a tenth of the diagonal of the scene's bounds, in a direction as
// diffuse_rays have it: of ambient occlusion. None for a miss.
std::vector<Ray<double>> ambient_rays(const SceneFile& scene, const StructureFile& grid,
                                      std::span<const Ray<double>> rays, std::uint64_t seed);

} // namespace masu
