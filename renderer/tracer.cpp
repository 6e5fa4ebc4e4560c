#include "renderer/tracer.h"

#include "libscene/error.h"
#include "libscene/stopwatch.h"
#include "renderer/backend.h"

#include <fmt/format.h>

namespace masu {
namespace {

void check_depth(std::int32_t depth) {
  if (depth < 1 || depth > largest_depth)
    throw Error(ErrorCode::usage, "depth", fmt::format("{} isn't from 1 to {}", depth, largest_depth));
}

} // namespace

Frame empty_frame(const FrameRequest& request) {
  Frame frame;
  const std::int32_t more = request.sampling == Sampling::corners ? 1 : 0;
  frame.columns = request.camera.width + more;
  frame.rows = request.camera.height + more;
  const std::size_t rays = static_cast<std::size_t>(frame.columns) * static_cast<std::size_t>(frame.rows);
  frame.radiance.resize(rays);
  if (request.hits) frame.hits.resize(rays);
  return frame;
}

Tracer::Tracer(const SceneFile& scene, const GridFile* grid, Device device)
    : scene_(scene), grid_(grid), device_(device) {
  if (grid != nullptr) grid->check_geometry(scene.geometry_hash(), scene.primitive_count());
  const auto check = [&] {
    if (!scene.is_checked()) scene.check_records();
    if (grid != nullptr && !grid->is_checked()) grid->check_records();
  };
  if (device == Device::cuda) set_up_cuda();
  const Stopwatch watch;
  if (device == Device::cuda)
    files_ = upload_files_cuda(scene, grid, check);
  else
    check();
  upload_seconds_ = watch.seconds();
}

Frame Tracer::render(const FrameRequest& request) const {
  check_depth(request.rules.depth);
  FrameRequest resolved_request = request;
  resolved_request.tracing.precision = resolved(request.tracing.precision, scene_);
  return device_ == Device::cuda ? render_cuda(*files_, scene_, grid_, resolved_request)
                                 : render_cpu(scene_, grid_, resolved_request);
}

ResidentRays Tracer::upload(std::span<const ListedRay> rays, Precision precision) const {
  precision = resolved(precision, scene_);
  if (device_ == Device::cpu) return {rays, precision};
  const Stopwatch watch;
  auto device = upload_rays_cuda(rays, precision == Precision::doubled);
  return {rays, precision, std::move(device), watch.seconds()};
}

RayHits Tracer::trace(const ResidentRays& rays, const RaysRequest& request) const {
  RaysRequest resolved_request = request;
  resolved_request.tracing.precision = resolved(request.tracing.precision, scene_);
  if (device_ == Device::cpu) return trace_rays_cpu(scene_, grid_, rays.host, resolved_request);
  if (rays.device == nullptr || rays.precision != resolved_request.tracing.precision)
    throw Error(ErrorCode::usage, "rays",
                "were uploaded for another precision or device: upload them for this");
  return trace_rays_cuda(*files_, scene_, grid_, rays, resolved_request);
}

RayHits Tracer::trace(std::span<const ListedRay> rays, const RaysRequest& request) const {
  const ResidentRays resident = upload(rays, request.tracing.precision);
  RayHits hits = trace(resident, request);
  hits.seconds.upload += resident.upload_seconds;
  return hits;
}

} // namespace masu
