// A ray's way through a grid, cell by cell, or through a hierarchy, node by node, as data: what it visited,
// what it tested there, what it hit and why it ended. Recorded by the normal code (libgrid/trace/trace.h), on
// the CPU, whatever device the tracer has.
#pragma once

#include "libgrid/grid/grid_layout.h"
#include "libgrid/trace/trace.h"
#include "renderer/tracer/tracer.h"

#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace masu {

// Places are in the world. t is relative to the ray's own origin, in lengths of its direction.

struct WalkTest {
  PrimitiveIndex primitive;
  double t;  // of the primitive's nearest hit, whether or not within the ray's range; infinity for a miss
  bool kept; // the ray's hit from here on: nearer than all before it, or for a shadow ray any one in range
};

// A hierarchy's node visited, and what became of its boxes: those met are visited or tested, now or, if
// nothing nearer is hit before, later.
struct WalkNode {
  std::uint32_t index = 0;
  int depth = 0; // of the root: 0
  int met = 0;
  int missed = 0; // by the ray
  int beyond = 0; // entered beyond the nearest hit, or the ray's end
};

// A cell or a node visited; without a grid the only step, through all of the scene.
struct WalkStep {
  VoxelBox voxels{}; // of the cell, in the grid's smallest voxels; of an expanded cell, of its larger box
  WalkNode node{};
  Boxd box{};       // in the scene's units; of a node, around all its boxes
  double enter = 0; // t; the first step's is where the ray enters the scene's bounds
  double exit = 0;  // t; infinity where the ray never leaves, and without a grid
  // That the cell lists, or that are in the boxes met. A shadow ray ends before the last of them.
  std::uint32_t references = 0;
  std::vector<WalkTest> tests{}; // in order
};

// camera: the first ray, from the camera or given.
enum class RayKind { camera, reflection, refraction, shadow };

enum class WalkEnd {
  missed, // the ray doesn't meet the scene's bounds: no cell was visited
  hit,    // nothing that is still to come is nearer than the nearest hit; of a shadow ray: something is hit
  t_max,  // the last cell's exit is beyond the ray's end
  left_grid,
  visited_all, // nodes whose boxes it meets, and nothing is hit
  tested_all   // without a grid
};

struct WalkRay {
  RayKind kind = RayKind::camera;
  std::int32_t parent = -1; // the ray that spawned it: its index in WalkReport::rays
  Vec3d origin{}, direction{};
  double t_min = 0, t_max = 0;   // t_max may be infinity
  std::vector<WalkStep> steps{}; // the first of `cells`; all, unless the limits leave no room
  WalkEnd end = WalkEnd::missed;
  // What is hit, the bits that a query reports; infinity and no_primitive for nothing. Of a shadow ray the
  // hit by which it is occluded.
  float t = static_cast<float>(INFINITY);
  PrimitiveIndex primitive = no_primitive;
  std::uint32_t object = no_primitive;
  std::uint64_t cells = 0, tests = 0; // as Counts has them; cells: of a hierarchy, nodes
};

struct WalkReport {
  StructureForm form = StructureForm::none;
  Vec3i division{};            // of a grid, in its smallest voxels
  Boxd space{};                // that is divided; without a grid the scene's bounds
  std::vector<WalkRay> rays{}; // in the order in which they were traced, the camera's first
  Vec3f radiance{};            // that comes back along the first ray, where all rays are traced
  // Rays that were traced but aren't in `rays`, for which WalkLimits leave no room.
  std::uint64_t more_rays = 0;
  bool ended_early = false; // there are still more, which weren't traced
};

// With all rays, a walk may double with each depth (nested glass). What the limits leave no room for is
// traced and counted, but not recorded.
struct WalkLimits {
  std::size_t rays = std::numeric_limits<std::size_t>::max();
  std::size_t bytes =
      std::numeric_limits<std::size_t>::max(); // of rays, of steps through a grid and their tests
  // Rays, cells and tests that are only counted. Beyond, the next ray isn't traced any more.
  std::uint64_t counted = std::numeric_limits<std::uint64_t>::max();
};

struct WalkRequest {
  TracingRules tracing{};
  Ray<double> ray{};
  // Also the shadow rays and the rays that are spawned, as a picture has them. The ray's direction is then
  // brought to length 1, unless it has that but for rounding; its t_min and t_max are ignored.
  bool all_rays = false;
  RenderRules rules{5, false, HitName::primitive};
  WalkLimits limits{};
  std::function<void()> progress{}; // called now and then; what it throws ends the walk
  bool is_relative = false;         // the ray's origin is relative to the scene's
};

// Throws Error(usage) as ResidentTracer::render() does, and for a ray that isn't valid (ray_query.h).
WalkReport trace_walk(const ResidentTracer& tracer, const WalkRequest& request);

// Of a picture's camera ray, of a column and a row of all_rays(), as the picture traces it.
// Throws Error(usage, "walk", …) for one that the picture doesn't have.
WalkRequest camera_walk(const ResidentTracer& tracer, const FrameRequest& request, std::int32_t column,
                        std::int32_t row);

const char* name_of(RayKind kind);
const char* name_of(WalkEnd end);
// Why its walk ended, in words.
std::string description_of(const WalkRay& ray);

} // namespace masu
