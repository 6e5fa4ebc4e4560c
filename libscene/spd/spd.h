// The Standard Procedural Databases (SPD) as NFF text: standard scenes for comparing ray tracers.
// Source: E. Haines, "A Proposal for Standard Graphics Environments", IEEE CG&A 7(11), 1987.
// Scenes are streamed: memory depends on the recursion's depth, not on the number of objects.
#pragma once

#include <cstdint>
#include <cstdio>
#include <functional>
#include <span>
#include <string>
#include <string_view>

namespace masu {

// The scenes, with their number of objects at size n (background included).
enum class SpdScene {
  balls,  // sphereflake: 1 + 9 + ... + 9^n spheres on a floor
  gears,  // n^3 interlocked gears of 146 polygons over a mirror
  mount,  // fractal mountain of 2*4^n triangles under four glass spheres
  nurbs,  // spline surface of 60n^2 triangles with normals
  rings,  // n layers, layer d of d^2 objects: six pentagons of 5 cylinders and 5 spheres each; a wall
  teapot, // 64n^2 - 8n triangles with normals, on a checkerboard of n^2 squares
  tetra,  // Sierpinski tetrahedron of 4^n triangles
  tree,   // 2^(n+1) - 1 cones and as many spheres, on the ground
};

struct SpdInfo {
  SpdScene scene;
  std::string_view name;
  int standard;           // the size used in published results
  int min_size, max_size; // supported sizes
};

struct SpdOptions {
  SpdScene scene = SpdScene::balls;
  int size = 4;
  // false omits the surroundings: the floors, walls and grounds of balls, gears, rings and tree, and the
  // mountain's four spheres. The teapot keeps its checkerboard.
  bool background = true;
};

// All scenes, in the order of SpdScene.
std::span<const SpdInfo> spd_scenes();

// By name. Throws Error(usage) for an unknown one.
const SpdInfo& spd_info(std::string_view name);

// Throws Error(usage) unless min_size <= size <= max_size. Beyond, the number of objects would overflow
// int32, or six significant digits couldn't distinguish the scene's smallest parts.
void check_spd_size(SpdScene scene, int size);

// Number of objects (NFF entities) of a scene of that size, surroundings included.
std::uint64_t spd_objects(SpdScene scene, int size);

// Writes the scene to `out` as NFF text of six significant digits, and flushes it. Coordinates have no unit;
// without grounds and floors they are at most 4, those of rings at most 2.62n + 1.
// The same options give the same bytes. `place` names `out` in errors.
// `progress` gets the share of objects written.
// Throws Error(usage) for a size out of range, Error(output) when `out` can't be written.
void write_spd(const SpdOptions& options, std::FILE* out, const std::string& place,
               const std::function<void(double)>& progress = {});

} // namespace masu
