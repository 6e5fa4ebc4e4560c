// What each camera ray of a picture meets and takes: maps of depth, normals, objects, primitives, and of the
// cells visited, the primitives tested and the lanes that idle.
#pragma once

#include "libscene/base/host_array.h"
#include "renderer/picture_warps.h"
#include "renderer/tracer/tracer.h"

#include <vector>

namespace masu {

enum class Channel { depth, normal, object, primitive, cells, tests, idle };

inline constexpr Channel all_channels[] = {Channel::depth,     Channel::normal, Channel::object,
                                           Channel::primitive, Channel::cells,  Channel::tests,
                                           Channel::idle};
const char* name_of(Channel channel);

struct ChannelsRequest {
  std::vector<Channel> channels{};
  // Of the rays: all but `hits` and `costs`. `rules` matters only for all_rays.
  FrameRequest frame{};
  // cells and tests are sums over a camera ray and all rays that it spawns, shadow rays too; else of the
  // camera ray alone. idle is of the same cells: of sums a lower
  // bound, for lanes wait for each other at each ray.
  bool all_rays = false;
};

// One value per camera ray, row by row from the top, of the window; empty where it wasn't requested.
struct Channels {
  std::int32_t columns = 0, rows = 0;
  HostArray<float> depth;         // t, which is a distance since directions have length 1; infinity: a miss
  HostArray<Vec3f> normal;        // geometric, of length 1, on the primitive's front; zeros for a miss
  HostArray<std::int32_t> object; // index in the NFF text; -1 for a miss
  HostArray<std::int32_t> primitive; // index in the scene file; -1 for a miss
  HostArray<std::uint32_t> cells, tests;
  HostArray<float> idle; // lanes of the ray's warp (picture_warps.h); warps begin at the window's corner
  WarpTurns warps;       // where idle was requested
  Counts counts;         // where cells, tests or idle were requested: of the rays that they count
};

// The values are the same bits on the CPU and on a GPU in `robust` and `double` precision. Throws as
// ResidentTracer::render() does.
Channels trace_channels(const ResidentTracer& tracer, const ChannelsRequest& request);

} // namespace masu
