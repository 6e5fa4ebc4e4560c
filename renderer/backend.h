// Tracing a whole picture, or a list of rays, on the CPU or on a CUDA device.
#pragma once

#include "libgrid/file/grid_file.h"
#include "libscene/cuda/cuda_device.h"
#include "libscene/file/scene_file.h"
#include "renderer/camera.h"
#include "renderer/counts.h"
#include "renderer/precision.h"
#include "renderer/render_pixel.h"
#include "renderer/schedule.h"

#include <algorithm>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace masu {

// How rays are to be traced.
struct TracingRules {
  Precision precision = Precision::automatic;
  StopRule stop = StopRule::proven;
  bool count = false;   // fill in counts
  bool general = false; // by the code for every kind of primitive, whatever the scene holds
};

// Done before any record of the files is read but to be copied; by a GPU while they are. Files that were
// opened with Checks::table are checked here. Its seconds count as uploading.
using BeforeTracing = std::function<void()>;

// What Checks::table leaves out, of both files.
inline void check_records(const SceneFile& scene, const GridFile* grid) {
  scene.check_records();
  if (grid != nullptr) grid->check_records();
}

// What is asked for.
struct FrameRequest {
  TracingRules tracing{};
  Camera camera{};
  Sampling sampling = Sampling::corners;
  bool hither = false; // the eye sees nothing nearer than the camera's hither
  RenderRules rules{5, false, HitName::object};
  bool hits = false; // report what each eye ray met
  int repeat = 1;    // trace so many times, and report the median's seconds; counts need 1
  int warm_up = 0;   // untimed runs before
  Schedule schedule = Schedule::hardware;
  int workers_each = 0; // a multiprocessor or thread has so many; 0: as many as it holds at once
  BeforeTracing before_tracing = [] {};
};

// Wall-clock seconds; the CPU backend reads the mapping in place: nothing is uploaded or downloaded.
struct TraceSeconds {
  double upload = 0, trace = 0, download = 0;
};

// What the CUDA kernel takes of the machine, a thread: registers, and bytes of local memory.
struct KernelSize {
  std::int32_t registers = 0, local_bytes = 0;
};

// The lattice of eye rays, row by row from the top.
struct Frame {
  std::int32_t columns = 0, rows = 0;
  std::vector<Vec3f> radiance;
  std::vector<HitRecord> hits; // when asked for
  Counts counts;
  TraceSeconds seconds;
  std::uint32_t workers = 0; // that shared the picture; of the CPU's own scheduler, threads
  KernelSize kernel{};
};

// Of the right size, still black.
Frame empty_frame(const FrameRequest& request);

// The middle of some measurements.
inline double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2),
                   values.end());
  return values[values.size() / 2];
}

// A ray of a list: origin, then direction of any length but zero. t counts in the direction's length. Float32
// arithmetic rounds it.
struct ListedRay {
  Vec3d origin, direction;
};

// What is asked of a ray: its nearest hit; or whether anything blocks it between 0 < t < 1 (the hit's name is
// then 0 or -1, its t the end of what was looked at).
enum class Query { nearest_hit, occlusion };

// How a GPU goes about its rays: a thread takes one ray through, cell by cell, and its warp's threads wait
// for each other at every cell; or a warp's threads share out what its rays have to test; or, besides, those
// that are done take the next ray (renderer/warp_tracing_cuda.h), and of rays that mostly miss the scene
// those that do are answered first (renderer/culling_cuda.h). The last rays of the latter two are dealt out
// to all warps (renderer/straggler_queue_cuda.h). The hits are the same.
enum class RayLoop { thread_per_ray, warp, warp_refill };

// Which loop is fastest, as a rule; coherent: neighbours in the list go the same way. What is mostly in a
// GPU's nearest caches is there soon, and then sharing costs more than waiting: measured on an H200, up to
// about 10 MB of scene and irregular grid. Through other grids most steps meet nothing to share: there
// `cells` was the faster at 10 to 17 MB too.
inline RayLoop automatic_loop(bool coherent, const SceneFile& scene, const GridFile& grid) {
  if (!coherent) return RayLoop::warp_refill;
  const std::uint64_t near = grid.table().merge() == fb::Merge::irregular ? 10 : 32;
  return scene.bytes() + grid.bytes() <= near << 20 ? RayLoop::thread_per_ray : RayLoop::warp;
}

struct RaysRequest {
  std::span<const ListedRay> rays;
  TracingRules tracing{};
  HitName hit_name = HitName::object;
  int repeat = 1;
  int warm_up = 0; // untimed runs before
  Query query = Query::nearest_hit;
  // Always cells where rays are counted, stop with the first cell's hit, or are 2^32 or more.
  RayLoop loop = RayLoop::warp_refill;
  BeforeTracing before_tracing = [] {};
};

struct RayHits {
  std::vector<HitRecord> hits;
  Counts counts;
  TraceSeconds seconds;
  KernelSize kernel{};
};

// What is traced: the grid is null for brute force, which tries every primitive for every ray. Throw
// Error(usage) for a precision that doesn't hold the scene (precision.h).
Frame render_cpu(const SceneFile& scene, const GridFile* grid, const FrameRequest& request);
RayHits trace_rays_cpu(const SceneFile& scene, const GridFile* grid, const RaysRequest& request);

// The same on the first CUDA device. Throw Error(device).
Frame render_cuda(const SceneFile& scene, const GridFile* grid, const FrameRequest& request);
RayHits trace_rays_cuda(const SceneFile& scene, const GridFile* grid, const RaysRequest& request);

// Seconds of uploading what they upload, which is then thrown away, and of meanwhile(). Throws Error(device),
// and what meanwhile() throws.
double upload_cuda(const SceneFile& scene, const GridFile* grid, const std::function<void()>& meanwhile);

} // namespace masu
