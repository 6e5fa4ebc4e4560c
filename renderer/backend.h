// What a tracer's devices do: one implementation for the CPU, one for CUDA, and one that refuses where the
// program was built without CUDA.
#pragma once

#include "renderer/tracer.h"

namespace masu {

// The grid is null for brute force. Files are checked, and the precision is resolved.
Frame render_cpu(const SceneFile& scene, const GridFile* grid, const FrameRequest& request);
RayHits trace_rays_cpu(const SceneFile& scene, const GridFile* grid, std::span<const ListedRay> rays,
                       const RaysRequest& request);

// Sets a device up, so that what comes next isn't charged for it. Throws Error(device) where there is none.
void set_up_cuda();

// Copies the files, and follows no index in them until meanwhile(), which checks them, has returned. Throws
// Error(device), and what meanwhile() throws.
std::shared_ptr<const DeviceFiles> upload_files_cuda(const SceneFile& scene, const GridFile* grid,
                                                     const std::function<void()>& meanwhile);
std::shared_ptr<const DeviceRays> upload_rays_cuda(std::span<const ListedRay> rays, bool as_double);

Frame render_cuda(const DeviceFiles& files, const SceneFile& scene, const GridFile* grid,
                  const FrameRequest& request);
RayHits trace_rays_cuda(const DeviceFiles& files, const SceneFile& scene, const GridFile* grid,
                        const ResidentRays& rays, const RaysRequest& request);

} // namespace masu
