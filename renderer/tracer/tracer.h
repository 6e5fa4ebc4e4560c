// The one way to trace: a scene and a structure, checked and resident on a device, that answer queries.
#pragma once

#include "libgrid/file/structure_file.h"
#include "libscene/cuda/cuda_device.h"
#include "libscene/file/scene_file.h"
#include "libscene/mesh/vertices.h"
#include "renderer/frame.h"
#include "renderer/rays/ray_list.h"

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace masu {

struct DeviceFiles; // a scene and its structure in a GPU's memory

// Queries change nothing in it, and threads may query at the same time: on a GPU each on a stream of its own.
class ResidentTracer {
public:
  // `structure` is null for brute force, which tries every primitive for every ray. The files must live as
  // long as the tracer. A CPU traces them where they are, in memory or mapped; what is mapped must not change
  // while a query is under way, and a query that ends after such a change throws Error(input). A GPU gets a
  // copy: of records that stay in the file as they are there now, and checked on the device. Throws
  // Error(input) for a damaged file or a structure of another geometry, Error(usage) where a CPU is to trace
  // what stays in the file, Error(device) where there is no usable GPU.
  //
  // gpus: numbers of GPUs, at least one, for Device::cuda. Each gets the files at the same time; one that is
  // named twice gets them twice. What comes out is independent of how many they are.
  ResidentTracer(const SceneFile& scene, const StructureFile* structure, Device device,
                 std::vector<int> gpus = {0});

  // On GPUs, each of which builds a hierarchy of quality fast of the scene, for itself and at once: it lies
  // there alone. Throws likewise, and as build_hierarchy() does (hierarchy_builder.h). What `progress` throws
  // ends it.
  static ResidentTracer by_fast_hierarchy(const SceneFile& scene, std::vector<int> gpus,
                                          const std::function<void(double)>& progress);

  Device device() const { return device_; }
  // 1 on the CPU.
  std::size_t device_count() const { return device_ == Device::cuda ? gpus_.size() : 1; }
  // Empty on the CPU.
  const std::vector<int>& gpus() const { return gpus_; }
  const SceneFile& scene() const { return scene_; }
  // Null for brute force, and what was built here.
  const StructureFile* structure() const { return structure_; }
  bool is_hierarchy() const { return is_hierarchy_; }
  // A copy of what was built here, for a tracer that wasn't moved.
  StructureFile built_hierarchy() const;
  // Of putting the files on the device, and of checking them.
  double upload_seconds() const { return upload_seconds_; }

  // Precision::automatic is that of the view (view_precision.h), and of a list of rays that of the store.
  //
  // Throw Error(usage) for a precision that doesn't hold the scene (resolved()), for a depth that isn't from
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
  // Query::closest_point is of places, through a hierarchy or none: Error(usage) for a grid, and for a scene
  // with coordinates beyond max_closest.
  //
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
  // refitted there. It shares with this one what doesn't move. scene() and structure() still have the files
  // of before: only what doesn't move is used of them. None where a triangle has an area that had none, which
  // the hierarchy doesn't refer to. What writes vertices in device memory must be done. For one thread at a
  // time. Throws Error(usage) for coordinates that aren't finite, or that the scene's store doesn't hold,
  // Error(device).
  std::optional<ResidentTracer> moved(const Vertices& vertices) const;

private:
  using Upload = std::function<std::shared_ptr<const DeviceFiles>(int gpu)>;
  ResidentTracer(const SceneFile& scene, const StructureFile* structure, Device device, std::vector<int> gpus,
                 const Upload& upload, const std::function<void()>& meanwhile = {});

  const SceneFile& scene_;
  const StructureFile* structure_;
  bool is_hierarchy_;
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
  std::size_t next_device() const;
};

} // namespace masu
