// Sets of rays to measure tracing by: of the eye, bounced off what it sees, and through the whole scene.
// Their coordinates are numbers that the scene's store holds, so that every arithmetic is given the same
// rays.
#pragma once

#include "renderer/tracer.h"

#include <vector>

namespace masu {

// How the eye's rays follow each other: row by row, or in tiles of 8 × 4, one a warp.
enum class RayOrder { rows, tiles };

// A ray through every pixel's centre.
std::vector<ListedRay> primary_rays(const SceneFile& scene, const Camera& camera, RayOrder order);

// From where each of `rays` hits, one ray each into a direction drawn by the cosine about the surface's
// normal; a ray that hits nothing is replaced by one between random points of the scene's bounding sphere.
// The same seed gives the same rays.
std::vector<ListedRay> diffuse_rays(const SceneFile& scene, const GridFile& grid,
                                    std::span<const ListedRay> rays, std::uint64_t seed);

// Between random points of the bounding sphere of the scene's bounds: t = 1 is the second point.
std::vector<ListedRay> random_rays(const SceneFile& scene, std::size_t count, std::uint64_t seed);

// From where each of `rays` hits to the light, one after the other in turn; t = 1 is the light. Rays that hit
// nothing give none.
std::vector<ListedRay> shadow_rays(const SceneFile& scene, const GridFile& grid,
                                   std::span<const ListedRay> rays);

} // namespace masu
