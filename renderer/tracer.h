// The one way to trace: a scene and a grid, checked and resident on a device, that answer queries.
#pragma once

#include "libgrid/file/structure_file.h"
#include "libgrid/trace/trace.h"
#include "libscene/base/host_array.h"
#include "libscene/cuda/cuda_device.h"
#include "libscene/file/scene_file.h"
#include "renderer/camera.h"
#include "renderer/counts.h"
#include "renderer/precision.h"
#include "renderer/rays/hit_list.h"
#include "renderer/rays/ray_query.h"
#include "renderer/render_pixel.h"

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace masu {

enum class Device { cpu, cuda };

inline constexpr int queries_per_gpu = 3; // to keep it busy: one computes, one comes back, one is prepared

// How rays are traced.
struct TracingRules {
  Precision precision = Precision::automatic;
  StopRule stop = StopRule::proven;
  bool count = false;              // fill in counts
  bool general = false;            // by the code for every kind of primitive, whatever the scene holds
  unsigned kinds = with_all_kinds; // that the scene holds: a tracer fills it in
};

// Seconds of wall-clock time; of kernels, on the device's own clock. The CPU traces files in the
// memory that they were read into and rays where the caller has them: nothing is uploaded or downloaded.
struct TraceSeconds {
  double upload = 0, trace = 0, download = 0;

  TraceSeconds& operator+=(const TraceSeconds& other) {
    upload += other.upload;
    trace += other.trace;
    download += other.download;
    return *this;
  }
};

// What a CUDA kernel takes per thread: registers, and bytes of local memory. 0 on the CPU.
struct KernelSize {
  std::int32_t registers = 0, local_bytes = 0;
};

// --- Pictures ---------------------------------------------------------------------------------------------

struct FrameRequest {
  TracingRules tracing{};
  Camera camera{}; // in the world
  Sampling sampling = Sampling::corners;
  bool hither = false; // camera rays start at the camera's hither distance
  RenderRules rules{5, false, HitName::object};
  bool shaded = true;                     // false: hits and costs of camera rays alone, no radiance
  bool rgb = false;                       // a GPU may report Frame::rgb instead of radiance
  bool hits = false;                      // report the hit of each camera ray
  bool attributes = false;                // and its object and normal; hits are named by primitive
  RayWindow window{};                     // the camera rays to trace; all, where it has no columns
  bool count_last_row = true;             // false: of a band whose last row of rays the next band counts
  std::function<void(double)> progress{}; // gets the share of rays traced, from any thread; on the CPU only
  bool costs = false; // report what each camera ray and all that it spawns took; it is then counted
};

// What was requested of each camera ray, row by row from the top: of the window.
struct Frame {
  std::int32_t columns = 0, rows = 0;
  HostArray<Vec3f> radiance;
  HostArray<std::uint8_t> rgb; // of the picture's pixels, by byte_of(); radiance is then left out
  HostArray<HitRecord> hits;
  HostArray<std::int32_t> objects;       // as RayResults has them
  HostArray<Vec3f> normals;              // likewise
  HostArray<std::uint32_t> cells, tests; // as RayCosts has them
  Counts counts;
  TraceSeconds seconds;
  KernelSize kernel{};
};

// Calls act(a's array, b's array) for each kind of array.
template <class A, class B, class Act>
void for_each_array(A& a, B& b, const Act& act) {
  act(a.radiance, b.radiance);
  act(a.rgb, b.rgb);
  act(a.hits, b.hits);
  act(a.objects, b.objects);
  act(a.normals, b.normals);
  act(a.cells, b.cells);
  act(a.tests, b.tests);
}

// Throws Error(usage) for one that isn't from 1 to largest_depth.
void check_depth(std::int32_t depth);

// Also for a window that isn't within the picture.
void check_request(const FrameRequest& request);

// The camera rays that are traced.
RayWindow window_of(const FrameRequest& request);

// Of the right size, for a backend that writes every ray's values: what they are before isn't defined. Takes
// the memory of a frame that isn't needed any more.
Frame sized_frame(const FrameRequest& request, Frame memory = {});

// --- Lists of rays ----------------------------------------------------------------------------------------

// Rays in memory, stored as ray_query.h says.
struct RayList {
  const void* rays = nullptr;
  std::size_t count = 0;
  RayFormat format{};
  RayFilters filters{};

  RayList() = default;
  RayList(const void* rays_, std::size_t count_, const RayFormat& format_)
      : rays(rays_), count(count_), format(format_) {}
  template <class Real>
  RayList(std::span<const Ray<Real>> list) : RayList(list.data(), list.size(), own_format<Real>) {}
  template <class Real>
  RayList(const std::vector<Ray<Real>>& list) : RayList(std::span(list)) {}
};

// Throws Error(usage) where they aren't for a scene of so many objects.
void check_filters(const RayFilters& filters, std::uint64_t objects);

// The same rays, whose origins are relative to the scene's.
inline RayList relative(RayList rays) {
  rays.format.is_relative = true;
  return rays;
}

// How a GPU schedules rays. thread_per_ray: a thread traces one ray to its end, and a warp's threads wait for
// each other at every cell. warp: its threads share the primitive tests of its rays. warp_refill: besides,
// idle threads fetch the next ray (renderer/cuda/warp_tracing.h), and where most rays miss the scene's bounds
// those are sorted out first (renderer/cuda/culling.h). Hits are the same.
enum class RayLoop { thread_per_ray, warp, warp_refill };

inline constexpr std::uint32_t max_hits_per_ray = 0x7fffffff;

struct RaysRequest {
  TracingRules tracing{};
  Query query = Query::nearest_hit;
  // Always thread_per_ray where rays are counted, stop with the first cell's hit, or are 2^31 or more; and
  // for occlusion by `fast` and `double`.
  RayLoop loop = RayLoop::warp_refill;
  Faces faces = Faces::both; // that count as hits
  std::uint32_t limit = 1;   // hits per ray, of all_hits
  // Of a list in host memory: gets the share of rays traced, now and then, from any thread; what it throws
  // ends the query.
  std::function<void(double)> progress{};
};

// Whether hits are found in their order (hit_list.h), by `robust` or `double`, and aren't counted.
inline bool needs_hits_in_order(const RayList& rays, const RayResults& results, const RaysRequest& request) {
  return request.query == Query::all_hits || request.query == Query::count_hits ||
         request.faces != Faces::both || rays.filters.any() || results.t64 != nullptr ||
         results.front != nullptr;
}
inline HitRules hit_rules(const RaysRequest& request) {
  return {request.query, request.faces, request.limit};
}

// What a query took. Seconds of a list in host memory overlap on a GPU.
struct QueryReport {
  Counts counts;
  TraceSeconds seconds;
  KernelSize kernel{};
};

// The results of a list of rays as records.
struct RayHits {
  std::vector<HitRecord> hits; // one per ray, in the list's order; for occlusion t is 1, name 0 or -1
  QueryReport report;
};

// Rays with room for their results where a tracer traces them, to be traced many times; relative to the
// scene's origin.
struct ResidentRays {
  RayList list;
  RayResults results;
  std::shared_ptr<void> memory{}; // what they point to
};

// --- The tracer -------------------------------------------------------------------------------------------

// Positions in the world, in host memory or a GPU's, of the vertices of a scene's triangles.
struct Vertices {
  const float* floats = nullptr; // three per vertex; or
  const double* doubles = nullptr;
  std::size_t count = 0;
  std::span<const std::uint32_t> indices{}; // three per triangle, below `count`; empty: one after the other

  const void* numbers() const { return floats != nullptr ? static_cast<const void*>(floats) : doubles; }
};

struct DeviceFiles; // a scene and its grid in a GPU's memory

// Queries change nothing in it, and threads may query at the same time: on a GPU each on a stream of its own.
class Tracer {
public:
  // `grid` is null for brute force, which tries every primitive for every ray. The files must live as long as
  // the tracer. A CPU traces them where they are, in memory or mapped; what is mapped must not change while a
  // query is under way, and a query that ends after such a change throws Error(input). A GPU gets a copy: of
  // records that stay in the file as they are there now, and checked on the device. Throws Error(input) for a
  // damaged file or a grid of another geometry, Error(usage) where a CPU is to trace what stays in the file,
  // Error(device) where there is no usable GPU.
  //
  // gpus: numbers of GPUs, at least one, for Device::cuda. Each gets the files at the same time; one that is
  // named twice gets them twice. What comes out is independent of how many they are.
  Tracer(const SceneFile& scene, const StructureFile* grid, Device device, std::vector<int> gpus = {0});

  Device device() const { return device_; }
  // 1 on the CPU.
  std::size_t device_count() const { return device_ == Device::cuda ? gpus_.size() : 1; }
  // Empty on the CPU.
  const std::vector<int>& gpus() const { return gpus_; }
  const SceneFile& scene() const { return scene_; }
  const StructureFile* grid() const { return grid_; }
  // Of putting the files on the device, and of checking them.
  double upload_seconds() const { return upload_seconds_; }

  // Precision::automatic is that of the view (view_precision.h), and of a list of rays that of the store.
  //
  // Throw Error(usage) for a precision that doesn't hold the scene (precision.h), for a depth that isn't from
  // 1 to largest_depth or a window that isn't within the picture, for results that a query needs and doesn't
  // have, and for hits in order that aren't to be had: by `fast`, with StopRule::first_cell, counted, or more
  // than max_hits_per_ray; Error(device).
  //
  // Several GPUs share a picture of more than a million rays, in bands of rows. Or `index` names the device
  // that renders it all, from 0 to below device_count(), into the memory of a frame that isn't needed any
  // more: fresh memory for a large one may take longer than tracing.
  Frame render(const FrameRequest& request) const;
  Frame render(const FrameRequest& request, std::size_t index, Frame memory = {}) const;

  // Rays and results in host memory, counted where costs are wanted; on a GPU they are copied there in pieces
  // of a million while others are traced. No more than about 300 MB of device memory is used, however long
  // the list is. Several GPUs share the pieces, or `index` names the device that traces all.
  QueryReport trace(const RayList& rays, const RayResults& results, const RaysRequest& request) const;
  QueryReport trace(const RayList& rays, const RayResults& results, const RaysRequest& request,
                    std::size_t index) const;
  // On a GPU, rays and results in its memory, any alignment of a number; on the CPU as trace(). The query is
  // put on the stream, a cudaStream_t, and nobody waits for it: the report has the kernel alone, and neither
  // counting nor costs are possible. `gpu`: the number of the GPU in whose memory they lie, one of gpus().
  QueryReport trace_on_device(const RayList& rays, const RayResults& results, const RaysRequest& request,
                              void* stream, int gpu) const;

  // Where vectors are what is wanted.
  RayHits hits(const RayList& rays, const RaysRequest& request, HitName name) const;
  // For measurements, on the first device. The rays are relative to the scene's origin.
  ResidentRays upload(std::span<const Ray<double>> rays, Precision precision) const;
  // The report's seconds.trace is the device's time for it.
  QueryReport trace(const ResidentRays& rays, const RaysRequest& request) const;

  // On GPUs, a tracer of the same scene whose triangles lie between other vertices, and its hierarchy,
  // refitted there. It shares with this one what doesn't move. scene() and grid() still have the files of
  // before: only what doesn't move is used of them. None where a triangle has an area that had none, which
  // the hierarchy doesn't refer to. What writes vertices in device memory must be done. For one thread at a
  // time. Throws Error(usage) for coordinates that aren't finite, or that the scene's store doesn't hold,
  // Error(device).
  std::optional<Tracer> moved(const Vertices& vertices) const;

private:
  const SceneFile& scene_;
  const StructureFile* grid_;
  Device device_;
  std::vector<int> gpus_;
  std::vector<std::shared_ptr<const DeviceFiles>> files_; // of each GPU
  std::shared_ptr<std::atomic<std::size_t>> turn_;        // of small queries among several GPUs
  double upload_seconds_ = 0;
  unsigned kinds_ = with_all_kinds;

  void check_unchanged() const;
  TracingRules resolved(TracingRules rules) const;
  // Of a list: checked, its rules resolved, and counted where costs are wanted.
  RaysRequest resolved(const RaysRequest& request, const RayList& rays, const RayResults& results) const;
  // With what is to be subtracted from their origins.
  RayList to_local(RayList rays) const;
  std::size_t next_device() const;
};

} // namespace masu
