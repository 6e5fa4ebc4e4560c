// The one way to trace: a scene and a grid, checked and resident on a device, that answer queries.
#pragma once

#include "libgrid/file/grid_file.h"
#include "libgrid/trace/trace.h"
#include "libscene/cuda/cuda_device.h"
#include "libscene/file/scene_file.h"
#include "renderer/camera.h"
#include "renderer/counts.h"
#include "renderer/precision.h"
#include "renderer/render_pixel.h"

#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace masu {

enum class Device { cpu, cuda };

// How rays are traced.
struct TracingRules {
  Precision precision = Precision::automatic;
  StopRule stop = StopRule::proven;
  bool count = false;   // fill in counts
  bool general = false; // by the code for every kind of primitive, whatever the scene holds
};

// Seconds of wall-clock time; of kernels, on the device's own clock. The CPU reads files where they are
// mapped and rays where the caller has them: nothing is uploaded or downloaded.
struct TraceSeconds {
  double upload = 0, trace = 0, download = 0;
};

// What a CUDA kernel takes a thread: registers, and bytes of local memory. 0 on the CPU.
struct KernelSize {
  std::int32_t registers = 0, local_bytes = 0;
};

// --- Pictures
// -----------------------------------------------------------------------------------------------

struct FrameRequest {
  TracingRules tracing{};
  Camera camera{};
  Sampling sampling = Sampling::corners;
  bool hither = false; // camera rays start at the camera's hither distance
  RenderRules rules{5, false, HitName::object};
  bool hits = false; // report the hit of each camera ray
};

// The camera rays' radiance and hits, row by row from the top.
struct Frame {
  std::int32_t columns = 0, rows = 0;
  std::vector<Vec3f> radiance;
  std::vector<HitRecord> hits; // when requested
  Counts counts;
  TraceSeconds seconds;
  KernelSize kernel{};
};

// Of the right size, black.
Frame empty_frame(const FrameRequest& request);

// --- Lists of rays
// --------------------------------------------------------------------------------------------

// origin + t direction; the direction has any length but zero, and t counts in it. float32 arithmetic rounds
// the coordinates.
struct ListedRay {
  Vec3d origin, direction;
};

// nearest_hit: the hit of smallest t > 0. occlusion: whether anything is hit at 0 < t < 1; a record's name is
// then 0 (occluded) or -1, its t 1.
enum class Query { nearest_hit, occlusion };

// How a GPU schedules rays. thread_per_ray: a thread traces one ray to its end, and a warp's threads wait for
// each other at every cell. warp: its threads share the primitive tests of its rays. warp_refill: besides,
// idle threads fetch the next ray (renderer/warp_tracing_cuda.h), and where most rays miss the scene's bounds
// those are sorted out first (renderer/culling_cuda.h). Hits are the same.
enum class RayLoop { thread_per_ray, warp, warp_refill };

// The loop that is mostly the fastest. coherent: neighbours in the list have similar origins and directions.
// What fits a GPU's nearest caches is traced faster without sharing: measured on an H200, up to about 10 MB
// of scene and irregular grid, or 32 MB of other grids, most of whose steps find nothing to share.
inline RayLoop automatic_loop(bool coherent, const SceneFile& scene, const GridFile& grid) {
  if (!coherent) return RayLoop::warp_refill;
  const std::uint64_t near = grid.table().merge() == fb::Merge::irregular ? 10 : 32;
  return scene.bytes() + grid.bytes() <= near << 20 ? RayLoop::thread_per_ray : RayLoop::warp;
}

struct RaysRequest {
  TracingRules tracing{};
  HitName hit_name = HitName::object;
  Query query = Query::nearest_hit;
  // Always thread_per_ray where rays are counted, stop with the first cell's hit, or are 2^31 or more; and
  // for occlusion by `fast` and `double`.
  RayLoop loop = RayLoop::warp_refill;
};

struct RayHits {
  std::vector<HitRecord> hits; // one a ray, in the list's order
  Counts counts;
  TraceSeconds seconds;
  KernelSize kernel{};
};

// Rays where a tracer traces them, to be traced many times: on the CPU where the caller has them, which must
// stay; on a GPU in its memory, as numbers of one arithmetic.
struct DeviceRays;
struct ResidentRays {
  std::span<const ListedRay> host;
  Precision precision = Precision::automatic;
  std::shared_ptr<const DeviceRays> device{}; // null on the CPU
  double upload_seconds = 0;
};

// --- The tracer -------------------------------------------------------------------------------------------

struct DeviceFiles; // a scene and its grid in a GPU's memory

// Queries change nothing in it. On a GPU they run on the default stream, one after the other.
class Tracer {
public:
  // `grid` is null for brute force, which tries every primitive for every ray. The files must live as long as
  // the tracer. Whatever of them isn't checked yet is checked here, on a GPU while they are copied; nothing
  // is traced before. Throws Error(input) for a damaged file or a grid of another geometry, Error(device)
  // where there is no usable GPU.
  Tracer(const SceneFile& scene, const GridFile* grid, Device device);

  Device device() const { return device_; }
  const SceneFile& scene() const { return scene_; }
  const GridFile* grid() const { return grid_; }
  // Of putting the files on the device, and of checking them.
  double upload_seconds() const { return upload_seconds_; }

  // Throw Error(usage) for a precision that doesn't hold the scene (precision.h), and for a depth that isn't
  // from 1 to largest_depth; Error(device).
  Frame render(const FrameRequest& request) const;
  RayHits trace(std::span<const ListedRay> rays, const RaysRequest& request) const;
  // request.tracing.precision must be the rays'.
  RayHits trace(const ResidentRays& rays, const RaysRequest& request) const;
  ResidentRays upload(std::span<const ListedRay> rays, Precision precision) const;

private:
  const SceneFile& scene_;
  const GridFile* grid_;
  Device device_;
  std::shared_ptr<const DeviceFiles> files_; // null on the CPU
  double upload_seconds_ = 0;
};

} // namespace masu
