#include "renderer/tracer.h"

#include "libscene/base/error.h"
#include "libscene/base/on_threads.h"
#include "libscene/base/stopwatch.h"
#include "renderer/backend.h"
#include "renderer/dispatch.h"
#include "renderer/view_precision.h"

#include <fmt/format.h>

#include <algorithm>
#include <mutex>

namespace masu {
namespace {

// Rounded to the arithmetic's numbers, in memory of the device.
template <class Real>
ResidentRays resident_rays(std::span<const Ray<double>> rays, const std::vector<int>& gpus) {
  std::vector<Ray<Real>> rounded(rays.size());
  for (std::size_t i = 0; i < rays.size(); ++i)
    rounded[i] = loaded<Real>(rays.data(), own_format<double>, i);
  if (!gpus.empty()) return upload_rays_cuda(relative(RayList(rounded)), gpus.front());
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
  ResidentRays resident{relative(RayList(memory->rays)), {}, memory};
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

Frame sized_frame(const FrameRequest& request, Frame memory) {
  Frame frame;
  frame.radiance = std::move(memory.radiance);
  frame.hits = std::move(memory.hits);
  frame.cells = std::move(memory.cells);
  frame.tests = std::move(memory.tests);
  const RayWindow window = window_of(request);
  frame.columns = window.columns;
  frame.rows = window.rows;
  const std::size_t rays = static_cast<std::size_t>(frame.columns) * static_cast<std::size_t>(frame.rows);
  frame.radiance.resize(rays);
  frame.hits.resize(request.hits ? rays : 0);
  frame.cells.resize(request.costs ? rays : 0);
  frame.tests.resize(request.costs ? rays : 0);
  return frame;
}

Tracer::Tracer(const SceneFile& scene, const GridFile* grid, Device device, std::vector<int> gpus)
    : scene_(scene), grid_(grid), device_(device),
      gpus_(device == Device::cuda ? std::move(gpus) : std::vector<int>()),
      turn_(std::make_shared<std::atomic<std::size_t>>(0)) {
  if (device == Device::cuda && gpus_.empty()) throw Error(ErrorCode::usage, "gpus", "none is named");
  const auto stays_in_file = [](const auto& file) { return file.residence() == Residence::file; };
  if (device == Device::cpu && (stays_in_file(scene) || (grid != nullptr && stays_in_file(*grid))))
    throw Error(ErrorCode::usage, scene.path(), "isn't in memory: open it for a CPU");
  if (grid != nullptr) grid->check_geometry(scene.geometry_hash(), scene.primitive_count());
  on_threads(gpus_.size(), [&](std::size_t i) { set_up_cuda(gpus_[i]); });
  const Stopwatch watch;
  files_.resize(gpus_.size());
  on_threads(gpus_.size(), [&](std::size_t i) { files_[i] = upload_files_cuda(scene, grid, gpus_[i]); });
  upload_seconds_ = watch.seconds();
  if (device == Device::cuda)
    kinds_ = kinds_on(*files_.front());
  else
    kinds_ = scene.is_float64() ? kinds_in(scene.view<double>()) : kinds_in(scene.view<float>());
}

void Tracer::check_unchanged() const {
  scene_.check_unchanged();
  if (grid_ != nullptr) grid_->check_unchanged();
}

TracingRules Tracer::resolved(TracingRules rules) const {
  rules.precision = masu::resolved(rules.precision, scene_);
  rules.kinds = kinds_;
  if (rules.stop == StopRule::first_cell && grid_ != nullptr && grid_->is_hierarchy())
    throw Error(ErrorCode::usage, "--first-cell-hit", "needs a grid of cells: a hierarchy has none");
  return rules;
}

Frame Tracer::render(const FrameRequest& request, std::size_t index, Frame memory) const {
  check_request(request);
  FrameRequest resolved_request = request;
  resolved_request.tracing.precision = picture_precision(*this, request);
  resolved_request.tracing = resolved(resolved_request.tracing);
  resolved_request.camera = relative_to(scene_.origin(), request.camera);
  if (request.costs) resolved_request.tracing.count = true;
  Frame frame = sized_frame(request, std::move(memory));
  device_ == Device::cuda ? render_cuda(*files_.at(index), scene_, grid_, resolved_request, frame)
                          : render_cpu(scene_, grid_, resolved_request, frame);
  check_unchanged();
  return frame;
}

Frame Tracer::render(const FrameRequest& request) const {
  constexpr std::int64_t rays_per_band = std::int64_t{1} << 20;
  const RayWindow window = window_of(request);
  const auto band_rows =
      static_cast<std::int32_t>(std::max<std::int64_t>(rays_per_band / std::max(window.columns, 1), 8));
  if (device_count() == 1 || window.rows <= band_rows) return render(request, next_device());
  check_window(window, all_rays(request.camera, request.sampling)); // before there is room for it
  const Precision precision = picture_precision(*this, request);
  Frame whole = sized_frame(request);
  std::mutex mutex;
  std::atomic<std::int32_t> next_row = 0;
  on_threads(device_count() * queries_per_gpu, [&](std::size_t worker) {
    Frame band;
    for (std::int32_t row; (row = next_row.fetch_add(band_rows)) < window.rows;) {
      FrameRequest part = request;
      part.tracing.precision = precision;
      part.window = {window.first_column, window.first_row + row, window.columns,
                     std::min(band_rows, window.rows - row)};
      part.count_last_row = request.count_last_row || row + part.window.rows < window.rows;
      band = render(part, worker % device_count(), std::move(band));
      const auto first = static_cast<std::ptrdiff_t>(row) * window.columns;
      std::ranges::copy(band.radiance, whole.radiance.begin() + first);
      std::ranges::copy(band.hits, whole.hits.begin() + (request.hits ? first : 0));
      std::ranges::copy(band.cells, whole.cells.begin() + (request.costs ? first : 0));
      std::ranges::copy(band.tests, whole.tests.begin() + (request.costs ? first : 0));
      const std::lock_guard lock(mutex);
      whole.counts += band.counts;
      whole.seconds += band.seconds;
      whole.kernel = band.kernel;
    }
  });
  return whole;
}

// Small queries take turns.
std::size_t Tracer::next_device() const {
  return device_count() > 1 ? turn_->fetch_add(1, std::memory_order_relaxed) % device_count() : 0;
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

void check_hits_in_order(const RaysRequest& request, const RayResults& results) {
  const auto fail = [](const char* place, const std::string& what) {
    throw Error(ErrorCode::usage, place, what);
  };
  if (request.query == Query::all_hits && (request.limit < 1 || request.limit > max_hits_per_ray))
    fail("limit", fmt::format("{} hits per ray aren't from 1 to {}", request.limit, max_hits_per_ray));
  if (request.tracing.precision == Precision::fast)
    fail("--precision", "fast finds nearest hits and occlusion alone, of both faces: take robust or double");
  if (request.tracing.stop == StopRule::first_cell)
    fail("--first-cell-hit", "is for nearest hits and occlusion alone, of both faces");
  if (request.tracing.count || results.costs.wanted())
    fail("rays", "can't be counted where their hits are found in order");
}

} // namespace

RaysRequest Tracer::resolved(const RaysRequest& request, const RayList& rays,
                             const RayResults& results) const {
  check_results(rays, results, request.query);
  RaysRequest resolved_request = request;
  resolved_request.tracing = resolved(request.tracing);
  if (needs_hits_in_order(rays, results, request)) check_hits_in_order(resolved_request, results);
  if (results.costs.wanted()) resolved_request.tracing.count = true;
  return resolved_request;
}

RayList Tracer::to_local(RayList rays) const {
  rays.format.origin = rays.format.is_relative ? Vec3d{0, 0, 0} : scene_.origin();
  return rays;
}

QueryReport Tracer::trace(const RayList& rays, const RayResults& results, const RaysRequest& request,
                          std::size_t index) const {
  const RaysRequest resolved_request = resolved(request, rays, results);
  if (device_ == Device::cpu) {
    const QueryReport report = trace_rays_cpu(scene_, grid_, to_local(rays), results, resolved_request);
    check_unchanged();
    return report;
  }
  std::atomic<std::size_t> next_piece = 0;
  return trace_rays_cuda(*files_.at(index), scene_, grid_, to_local(rays), results, resolved_request,
                         next_piece);
}

QueryReport Tracer::trace(const RayList& rays, const RayResults& results, const RaysRequest& request) const {
  if (device_count() == 1 || rays.count <= rays_per_piece(request))
    return trace(rays, results, request, next_device());
  const RaysRequest resolved_request = resolved(request, rays, results);
  std::atomic<std::size_t> next_piece = 0;
  std::mutex mutex;
  QueryReport all;
  on_threads(device_count(), [&](std::size_t index) {
    const QueryReport report =
        trace_rays_cuda(*files_[index], scene_, grid_, to_local(rays), results, resolved_request, next_piece);
    const std::lock_guard lock(mutex);
    all.counts += report.counts;
    all.seconds += report.seconds;
    all.kernel = report.kernel;
  });
  return all;
}

QueryReport Tracer::trace_on_device(const RayList& rays, const RayResults& results,
                                    const RaysRequest& request, void* stream, int gpu) const {
  if (device_ == Device::cpu) return trace(rays, results, request);
  const auto index = static_cast<std::size_t>(std::ranges::find(gpus_, gpu) - gpus_.begin());
  if (index == gpus_.size()) throw Error(ErrorCode::usage, "rays", "aren't in memory of the tracer's GPUs");
  const RaysRequest resolved_request = resolved(request, rays, results);
  if (resolved_request.tracing.count)
    throw Error(ErrorCode::usage, "rays", "in device memory can't be counted");
  return queue_rays_cuda(*files_[index], scene_, grid_, to_local(rays), results, resolved_request, stream);
}

RayHits Tracer::hits(const RayList& rays, const RaysRequest& request, HitName name) const {
  std::vector<float> t(rays.count);
  std::vector<std::uint32_t> names(rays.count);
  std::vector<std::uint8_t> occluded(request.query == Query::occlusion ? rays.count : 0);
  RayResults results;
  results.t = t.data();
  (name == HitName::object      ? results.object
   : name == HitName::primitive ? results.primitive
                                : results.face) = names.data();
  results.occluded = occluded.data();
  RayHits found{std::vector<HitRecord>(rays.count), trace(rays, results, request)};
  for (std::size_t i = 0; i < rays.count; ++i)
    found.hits[i] = request.query == Query::occlusion ? HitRecord{1, occluded[i] != 0 ? 0 : -1}
                                                      : HitRecord{t[i], static_cast<std::int32_t>(names[i])};
  return found;
}

ResidentRays Tracer::upload(std::span<const Ray<double>> rays, Precision precision) const {
  precision = masu::resolved(precision, scene_);
  return precision == Precision::doubled ? resident_rays<double>(rays, gpus_)
                                         : resident_rays<float>(rays, gpus_);
}

QueryReport Tracer::trace(const ResidentRays& rays, const RaysRequest& request) const {
  if (device_ == Device::cpu) return trace(rays.list, rays.results, request);
  return time_rays_cuda(*files_.front(), scene_, grid_, rays, resolved(request, rays.list, rays.results));
}

} // namespace masu
