// As ResidentTracer (tracer.h), of placed meshes.
#pragma once

#include "libgrid/placed/placed_scene.h"
#include "renderer/rays/ray_list.h"

#include <atomic>
#include <functional>
#include <memory>
#include <vector>

namespace masu {

struct DeviceFiles;

// Queries change nothing in it, and threads may query at the same time.
class PlacedTracer {
public:
  // Throws Error(usage, "placements", …) as placed() does (place_passes.h), Error(device).
  PlacedTracer(std::shared_ptr<const PlacedScene> scene, HierarchyQuality quality, bool is_brute_force,
               std::vector<int> gpus, const std::function<void(double)>& progress);

  // Empty on the CPU.
  const std::vector<int>& gpus() const { return gpus_; }

  // The faster one of rays in a GPU's memory, if neighbours are coherent or not.
  RayLoop usual_loop(bool coherent) const;

  // The same meshes placed elsewhere, where all that is wrong is an error.
  PlacedTracer moved(const PlacementMoves& moves) const;

  // As ResidentTracer's; nothing is counted, and `fast` isn't there.
  QueryReport trace(const RayList& rays, const RayResults& results, const RaysRequest& request) const;
  QueryReport trace_on_device(const RayList& rays, const RayResults& results, const RaysRequest& request,
                              void* stream, int gpu) const;

private:
  RaysRequest resolved(const RayList& rays, const RayResults& results, const RaysRequest& request) const;

  std::shared_ptr<const PlacedScene> scene_;
  std::vector<int> gpus_;
  std::vector<std::shared_ptr<const DeviceFiles>> files_; // of each GPU
  std::shared_ptr<std::atomic<std::size_t>> turn_;        // of small queries among several GPUs
  std::shared_ptr<const AnyPlacedOnHost> host_;           // where it began, if it is on GPUs
};

// As backend.h has devices. On the CPU, of a list that is checked; the request's precision is resolved.
QueryReport trace_placed_cpu(const AnyPlacedOnHost& host, const RayList& rays, const RayResults& results,
                             const RaysRequest& request);
// On a GPU: at first, and moved.
std::shared_ptr<const DeviceFiles> upload_placed_cuda(const AnyPlacedOnHost& host, int device);
std::shared_ptr<const DeviceFiles> placed_files_cuda(const DeviceFiles& files, const PlacementMoves& moves);

} // namespace masu
