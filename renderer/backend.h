// What a tracer's devices do: one implementation for the CPU, one for CUDA, and one that refuses where the
// program was built without CUDA.
#pragma once

#include "libgrid/file/structure_file.h"
#include "libscene/cuda/cuda_device.h"
#include "libscene/file/scene_file.h"
#include "libscene/mesh/vertices.h"
#include "renderer/frame.h"
#include "renderer/rays/interpolation.h"
#include "renderer/rays/ray_list.h"

#include <algorithm>
#include <atomic>
#include <memory>
#include <span>

namespace masu {

struct DeviceFiles; // a scene and its structure in a GPU's memory

// Arrays of objects and normals as those of a list's results.
inline RayResults attribute_results(std::int32_t* objects, Vec3f* normals) {
  static_assert(sizeof(Vec3f) == sizeof(float[3]));
  RayResults results;
  results.object = reinterpret_cast<std::uint32_t*>(objects);
  results.normal = reinterpret_cast<float(*)[3]>(normals);
  return results;
}

// The grid is null for brute force. Files are checked, and the precision is resolved.
// Pictures: into a frame of sized_frame(), of which every array is written whole.
void render_cpu(const SceneFile& scene, const StructureFile* structure, const FrameRequest& request,
                Frame& frame);
QueryReport trace_rays_cpu(const SceneFile& scene, const StructureFile* structure, const RayList& rays,
                           const RayResults& results, const RaysRequest& request);

// Sets a device up, so that it isn't timed with what comes next. Throws Error(device) where there is none.
void set_up_cuda(int device);

// Copies the files. What the host hasn't checked, because it stays in the files, is checked on the device
// before any index in it is followed. Throws Error(device), Error(input) for a damaged or changed file.
std::shared_ptr<const DeviceFiles> upload_files_cuda(const SceneFile& scene, const StructureFile* structure,
                                                     int device);
// Copies the scene, and builds a hierarchy of quality fast of it there. Throws likewise.
std::shared_ptr<const DeviceFiles> built_files_cuda(const SceneFile& scene, int device,
                                                    const ProgressMonitor* progress);
// A copy of the hierarchy that was built there.
Structure built_hierarchy_cuda(const DeviceFiles& files);
// ResidentTracer::moved() on a device, of a scene of that origin: null where it returns none.
std::shared_ptr<const DeviceFiles> moved_files_cuda(const DeviceFiles& files, const Vec3d& origin,
                                                    const Vertices& vertices);

// The kinds of primitives in them (with_triangles, …).
unsigned kinds_on(const DeviceFiles& files);

// Copies bytes to the device.
std::shared_ptr<std::uint8_t> uploaded_cuda(std::span<const std::uint8_t> bytes, int device);

void render_cuda(const DeviceFiles& files, const FrameRequest& request, Frame& frame);

// Rays on a device at a time, for each of the stages: one piece is uploaded while another is traced and the
// results of a third come back.
inline std::size_t rays_per_piece(const RaysRequest& request) {
  return std::max((std::size_t{1} << 20) / hit_rules(request).row(), std::size_t{1});
}
// The share of a list of which devices have taken so many pieces.
inline double share_of_pieces(std::size_t pieces, const RayList& rays, const RaysRequest& request) {
  return std::min(static_cast<double>(pieces * rays_per_piece(request)) / static_cast<double>(rays.count),
                  1.0);
}
// Of rays in host memory: the pieces of a list that it takes from a counter, which devices share.
QueryReport trace_rays_cuda(const DeviceFiles& files, const RayList& rays, const RayResults& results,
                            const RaysRequest& request, std::atomic<std::size_t>& next_piece);
// The same by all of these devices.
QueryReport trace_by_gpus(std::span<const std::shared_ptr<const DeviceFiles>> files, const RayList& rays,
                          const RayResults& results, const RaysRequest& request);
// Of rays in device memory: puts the query on a stream; or times it.
QueryReport launch_rays_cuda(const DeviceFiles& files, const RayList& rays, const RayResults& results,
                             const RaysRequest& request, void* stream);
QueryReport time_rays_cuda(const DeviceFiles& files, const ResidentRays& rays, const RaysRequest& request);

// Puts it on a stream of a device, where all arrays lie.
void interpolate_cuda(const CornerValues& values, const InterpolatedHits& hits, std::size_t count, int device,
                      void* stream);

} // namespace masu
