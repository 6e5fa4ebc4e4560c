#include "libscene/geometry/margin.h"
#include "renderer/rays/automatic_loop.h"
#include "stability/ray_sets.h"
#include "tools/bench/tradeoff/tradeoff.h"
#include "tools/common/cli.h"
#include "tools/common/repeated.h"

#include <algorithm>
#include <cmath>
#include <ctime>

namespace masu {
namespace {

// A run that takes this long is measured once: noise is small in comparison.
constexpr double long_seconds = 0.1;

// The result of trace(), called once to warm up and then, unless that took long, `repeat` times. On a CPU its
// seconds are processor time over the number of threads, which other programs hardly change.
template <class Trace>
auto traced(const TradeoffSetup& setup, std::uint64_t repeat, const Trace& trace) {
  const auto timed = [&] {
    const std::clock_t start = std::clock();
    auto result = trace();
    const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    if (setup.threads > 0) result.seconds.trace = seconds / static_cast<double>(setup.threads);
    return result;
  };
  auto once = timed();
  if (repeat <= 1 || once.seconds.trace >= long_seconds) return once;
  return repeated(0, static_cast<int>(repeat), timed);
}

ResidentTracer tracer_of(const TradeoffTask& task, const StructureFile* grid) {
  return {task.scene, grid, task.setup.backend == "cuda" ? Device::cuda : Device::cpu};
}

RayHits trace(const TradeoffTask& task, const ResidentTracer& tracer, const TracingRules& rules,
              const std::vector<Ray<double>>& rays, RayLoop loop, std::uint64_t repeat) {
  const RaysRequest request{rules, Query::nearest_hit, loop};
  RayHits found = tracer.hits(rays, request, HitName::primitive);
  const ResidentRays resident = tracer.upload(rays, rules.precision);
  found.report = traced(task.setup, repeat, [&] { return tracer.trace(resident, request); });
  return found;
}

Frame render(const TradeoffTask& task, const ResidentTracer& tracer, const TracingRules& rules,
             std::uint64_t repeat) {
  const FrameRequest request{.tracing = rules, .camera = task.picture, .sampling = Sampling::centers};
  return traced(task.setup, repeat, [&] { return tracer.render(request); });
}

// Appends `wanted` elements of `all`, evenly spaced, or all of them, to `some`.
template <class T>
void add_some(const std::vector<T>& all, std::uint64_t wanted, std::vector<T>& some) {
  const std::uint64_t count = std::min<std::uint64_t>(all.size(), wanted);
  for (std::uint64_t i = 0; i < count; ++i)
    some.push_back(all[i * all.size() / count]);
}

void compare_hits(const TradeoffTask& task, const std::vector<HitRecord>& hits, Accuracy& accuracy) {
  const TradeoffTask::Reference& reference = task.reference;
  // Whether two hits of a ray are equal to within the error of float32 arithmetic: the bound on a hit's
  // distance from the surface (libscene/geometry/margin.h), and t's rounding.
  const double margin = rounding_margin<float>(task.scene.bounds());
  const auto same = [&](const Ray<double>& ray, double t, double other) {
    return std::abs(t - other) <= margin / length(ray.direction) + 0x1p-23 * other;
  };
  std::vector<double> errors; // of t, relative
  accuracy.rays = hits.size();
  for (std::size_t i = 0; i < hits.size(); ++i) {
    const HitRecord &is = hits[i], &should = reference.hits[i];
    if (is.name < 0 && should.name < 0) continue;
    const bool other = is.name != should.name;
    if (is.name < 0) {
      ++accuracy.missed;
    } else if (should.name < 0) {
      ++accuracy.false_hits;
    } else if (!std::isfinite(is.t) || (other && !same(reference.rays[i], is.t, should.t))) {
      ++accuracy.wrong_primitives;
    } else {
      accuracy.ties += other ? 1 : 0;
      errors.push_back(std::abs(static_cast<double>(is.t) - should.t) / should.t);
    }
  }
  if (errors.empty()) return;
  accuracy.worst_t = *std::max_element(errors.begin(), errors.end());
  accuracy.median_t = median(std::move(errors));
}

void compare_pictures(const HostArray<Vec3f>& should, const HostArray<Vec3f>& is, Accuracy& accuracy) {
  double squares = 0;
  for (std::size_t i = 0; i < should.size(); ++i) {
    for (int channel = 0; channel < 3; ++channel) {
      const double difference = std::abs(static_cast<double>(is[i][channel]) - should[i][channel]);
      const double error = std::isfinite(difference) ? difference : 1; // NaN counts as the largest error
      squares += error * error;
      accuracy.largest = std::max(accuracy.largest, error);
    }
  }
  accuracy.rmse = std::sqrt(squares / (3 * static_cast<double>(should.size())));
}

double mrays(std::size_t rays, double seconds) {
  return static_cast<double>(rays) / std::max(seconds, 1e-9) * 1e-6;
}

} // namespace

TradeoffTask::TradeoffTask(const SceneFile& scene_, const TradeoffSetup& setup_)
    : scene(scene_), setup(setup_),
      primary(primary_rays(scene, resized(scene.camera(), setup.size), RayOrder::tiles)),
      random(random_rays(scene, setup.random, setup.seed)), picture(resized(scene.camera(), setup.picture)) {
  add_some(primary, setup.compared, reference.rays);
  add_some(random, setup.compared, reference.rays);
  const TracingRules rules{Precision::doubled};
  const ResidentTracer tracer = tracer_of(*this, nullptr);
  reference.hits = trace(*this, tracer, rules, reference.rays, RayLoop::thread_per_ray, 1).hits;
  reference.radiance = render(*this, tracer, rules, 1).radiance;
}

Measurement measure(const TradeoffTask& task, const StructureFile& grid, const Configuration& configuration) {
  const TracingRules rules{configuration.precision, configuration.stop};
  const std::uint64_t repeat = task.setup.repeat;
  const ResidentTracer tracer = tracer_of(task, &grid);
  // On a GPU each set by its automatic loop.
  const auto loop = [&](const std::vector<Ray<double>>& rays) {
    return automatic_loop(tracer, rays, Query::nearest_hit, configuration.precision);
  };
  const RayHits primary = trace(task, tracer, rules, task.primary, loop(task.primary), repeat);
  const RayHits random = trace(task, tracer, rules, task.random, loop(task.random), repeat);
  const Frame frame = render(task, tracer, rules, repeat);

  Measurement measured;
  measured.voxels = voxel_count(grid.layout().division);
  measured.grid_bytes = grid.bytes();
  measured.scene_bytes = task.scene.bytes();
  measured.primary_mrays = mrays(task.primary.size(), primary.report.seconds.trace);
  measured.random_mrays = mrays(task.random.size(), random.report.seconds.trace);
  measured.mrays = mrays(task.primary.size() + task.random.size(),
                         primary.report.seconds.trace + random.report.seconds.trace);
  measured.picture_ms = frame.seconds.trace * 1e3;
  std::vector<HitRecord> hits;
  add_some(primary.hits, task.setup.compared, hits);
  add_some(random.hits, task.setup.compared, hits);
  compare_hits(task, hits, measured.accuracy);
  compare_pictures(task.reference.radiance, frame.radiance, measured.accuracy);
  return measured;
}

} // namespace masu
