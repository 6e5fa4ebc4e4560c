#include "renderer/tracer.h"

#include "libscene/error.h"
#include "libscene/stopwatch.h"
#include "renderer/backend.h"
#include "renderer/dispatch.h"

#include <fmt/format.h>

namespace masu {
namespace {

// Rounded to the arithmetic's numbers, in memory of the device.
template <class Real>
ResidentRays resident_rays(std::span<const Ray<double>> rays, Device device) {
  std::vector<Ray<Real>> rounded(rays.size());
  for (std::size_t i = 0; i < rays.size(); ++i)
    rounded[i] = loaded<Real>(rays.data(), own_format<double>, i);
  if (device == Device::cuda) return upload_rays_cuda(RayList(rounded));
  struct Memory {
    std::vector<Ray<Real>> rays;
    std::vector<float> t;
    std::vector<std::uint32_t> primitive;
    std::vector<std::uint8_t> occluded;
  };
  const auto memory = std::make_shared<Memory>();
  memory->rays = std::move(rounded);
  memory->t.resize(rays.size());
  memory->primitive.resize(rays.size());
  memory->occluded.resize(rays.size());
  ResidentRays resident{RayList(memory->rays), {}, memory};
  resident.results.t = memory->t.data();
  resident.results.primitive = memory->primitive.data();
  resident.results.occluded = memory->occluded.data();
  return resident;
}

// Whether `count` from `first` on lie below `end`, and are at least one.
bool is_within(std::int32_t first, std::int32_t count, std::int32_t end) {
  return first >= 0 && count > 0 && first < end && count <= end - first;
}

void check_window(const RayWindow& window, const RayWindow& all) {
  if (!is_within(window.first_column, window.columns, all.columns) ||
      !is_within(window.first_row, window.rows, all.rows))
    throw Error(ErrorCode::usage, "window",
                fmt::format("{} x {} rays from column {}, row {} aren't within the picture's {} x {}",
                            window.columns, window.rows, window.first_column, window.first_row, all.columns,
                            all.rows));
}

} // namespace

void check_depth(std::int32_t depth) {
  if (depth < 1 || depth > largest_depth)
    throw Error(ErrorCode::usage, "depth", fmt::format("{} isn't from 1 to {}", depth, largest_depth));
}

void check_request(const FrameRequest& request) {
  check_depth(request.rules.depth);
  if (request.window.columns > 0) check_window(request.window, all_rays(request.camera, request.sampling));
}

RayWindow window_of(const FrameRequest& request) {
  return request.window.columns > 0 ? request.window : all_rays(request.camera, request.sampling);
}

Frame empty_frame(const FrameRequest& request) {
  Frame frame;
  const RayWindow window = window_of(request);
  frame.columns = window.columns;
  frame.rows = window.rows;
  const std::size_t rays = static_cast<std::size_t>(frame.columns) * static_cast<std::size_t>(frame.rows);
  frame.radiance.resize(rays);
  if (request.hits) frame.hits.resize(rays);
  if (request.costs) {
    frame.cells.resize(rays);
    frame.tests.resize(rays);
  }
  return frame;
}

Tracer::Tracer(const SceneFile& scene, const GridFile* grid, Device device, int gpu)
    : scene_(scene), grid_(grid), device_(device) {
  if (grid != nullptr) grid->check_geometry(scene.geometry_hash(), scene.primitive_count());
  const auto check = [&] {
    if (!scene.is_checked()) scene.check_records();
    if (grid != nullptr && !grid->is_checked()) grid->check_records();
  };
  if (device == Device::cuda) set_up_cuda(gpu);
  const Stopwatch watch;
  if (device == Device::cuda)
    files_ = upload_files_cuda(scene, grid, gpu, check);
  else
    check();
  upload_seconds_ = watch.seconds();
  kinds_ = scene.is_float64() ? kinds_in(scene.view<double>()) : kinds_in(scene.view<float>());
}

TracingRules Tracer::resolved(TracingRules rules) const {
  rules.precision = masu::resolved(rules.precision, scene_);
  rules.kinds = kinds_;
  return rules;
}

Frame Tracer::render(const FrameRequest& request) const {
  check_request(request);
  FrameRequest resolved_request = request;
  resolved_request.tracing = resolved(request.tracing);
  if (request.costs) resolved_request.tracing.count = true;
  return device_ == Device::cuda ? render_cuda(*files_, scene_, grid_, resolved_request)
                                 : render_cpu(scene_, grid_, resolved_request);
}

namespace {

void check_results(const RayList& rays, const RayResults& results, Query query) {
  const auto fail = [](const char* what) { throw Error(ErrorCode::usage, "rays", what); };
  if (rays.count == 0) return;
  if (rays.rays == nullptr) fail("are missing: the pointer is null");
  const std::size_t number = rays.format.is_float64 ? sizeof(double) : sizeof(float);
  if (reinterpret_cast<std::uintptr_t>(rays.rays) % number != 0)
    fail("aren't aligned as their numbers must be");
  if (rays.format.numbers != 6 && rays.format.numbers != 8) fail("have 6 or 8 numbers each");
  if (query == Query::occlusion && results.occluded == nullptr)
    fail("have no array for whether they are occluded");
}

} // namespace

QueryReport Tracer::trace(const RayList& rays, const RayResults& results, const RaysRequest& request) const {
  check_results(rays, results, request.query);
  RaysRequest resolved_request = request;
  resolved_request.tracing = resolved(request.tracing);
  if (results.costs.wanted()) resolved_request.tracing.count = true;
  return device_ == Device::cuda ? trace_rays_cuda(*files_, scene_, grid_, rays, results, resolved_request)
                                 : trace_rays_cpu(scene_, grid_, rays, results, resolved_request);
}

QueryReport Tracer::trace_on_device(const RayList& rays, const RayResults& results,
                                    const RaysRequest& request, void* stream) const {
  if (device_ == Device::cpu) return trace(rays, results, request);
  check_results(rays, results, request.query);
  if (request.tracing.count || results.costs.wanted())
    throw Error(ErrorCode::usage, "rays", "in device memory can't be counted");
  RaysRequest resolved_request = request;
  resolved_request.tracing = resolved(request.tracing);
  return queue_rays_cuda(*files_, scene_, grid_, rays, results, resolved_request, stream);
}

RayHits Tracer::hits(const RayList& rays, const RaysRequest& request, HitName name) const {
  std::vector<float> t(rays.count);
  std::vector<std::uint32_t> names(rays.count);
  std::vector<std::uint8_t> occluded(request.query == Query::occlusion ? rays.count : 0);
  RayResults results;
  results.t = t.data();
  (name == HitName::object ? results.object : results.primitive) = names.data();
  results.occluded = occluded.data();
  RayHits found{std::vector<HitRecord>(rays.count), trace(rays, results, request)};
  for (std::size_t i = 0; i < rays.count; ++i)
    found.hits[i] = request.query == Query::occlusion ? HitRecord{1, occluded[i] != 0 ? 0 : -1}
                                                      : HitRecord{t[i], static_cast<std::int32_t>(names[i])};
  return found;
}

ResidentRays Tracer::upload(std::span<const Ray<double>> rays, Precision precision) const {
  precision = masu::resolved(precision, scene_);
  return precision == Precision::doubled ? resident_rays<double>(rays, device_)
                                         : resident_rays<float>(rays, device_);
}

QueryReport Tracer::trace(const ResidentRays& rays, const RaysRequest& request) const {
  if (device_ == Device::cpu) return trace(rays.list, rays.results, request);
  RaysRequest resolved_request = request;
  resolved_request.tracing = resolved(request.tracing);
  return time_rays_cuda(*files_, scene_, grid_, rays, resolved_request);
}

} // namespace masu
