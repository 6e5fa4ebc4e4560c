#include "tools/render_views.h"

#include "libscene/file/output_file.h"
#include "libscene/stopwatch.h"
#include "tools/repeated.h"

#include <fmt/format.h>
#include <tbb/global_control.h>
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <memory>
#include <mutex>
#include <semaphore>

namespace masu {
namespace {

// The unit of work: a part of a view's camera rays.
struct RenderTask {
  std::size_t view = 0;
  RayWindow window{};
};

struct RenderedTask {
  RenderTask task;
  std::shared_ptr<const Frame> frame;
};

constexpr std::ptrdiff_t queries_at_once = 3; // of a GPU: one computes, one comes back, one is prepared
constexpr std::size_t frames_bytes = std::size_t{4} << 30;

// How many views are under way at most: enough for all threads to encode, as far as memory allows.
std::size_t views_under_way(const ViewsRequest& request) {
  std::size_t largest = 1; // bytes of a frame and of what is made of it
  for (const View& view : request.views) {
    const RayWindow rays = request.frame.window.columns > 0 ? request.frame.window
                                                            : all_rays(view.camera, request.frame.sampling);
    largest =
        std::max(largest, 28 * static_cast<std::size_t>(rays.columns) * static_cast<std::size_t>(rays.rows));
  }
  const std::size_t threads = tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
  return std::clamp<std::size_t>(frames_bytes / largest, 2, threads + 1);
}

void write_hits(const std::vector<HitRecord>& hits, const std::string& path) {
  OutputFile file(path);
  file.write(hits.data(), hits.size() * sizeof(HitRecord));
  file.commit();
}

// Tracing and writing of tasks, in any order and at the same time.
class ViewsRenderer {
public:
  ViewsRenderer(const Tracer& tracer, const ViewsRequest& request,
                const std::function<void(double)>& progress)
      : tracer_(tracer), request_(request), progress_(progress) {}

  RenderedTask trace(const RenderTask& task) {
    FrameRequest frame = request_.frame;
    frame.camera = request_.views[task.view].camera;
    frame.window = task.window;
    // The CPU traces views in order, and that takes the time.
    const auto views = static_cast<double>(request_.views.size());
    frame.progress = [&](double share) { progress_((static_cast<double>(task.view) + share) / views); };
    queries_.acquire();
    const std::shared_ptr<void> released(nullptr, [&](void*) { queries_.release(); });
    // A thread that waits for the view's last rays doesn't begin another task meanwhile.
    return tbb::this_task_arena::isolate([&] {
      return RenderedTask{task, std::make_shared<const Frame>(
                                    repeated(0, request_.repeat, [&] { return tracer_.render(frame); }))};
    });
  }

  void write(const RenderedTask& rendered) {
    const Frame& frame = *rendered.frame;
    const std::size_t view = rendered.task.view;
    const ViewFiles& files = request_.files[view];
    const Stopwatch watch;
    if (!files.picture.empty()) {
      ImageOptions image = request_.image;
      image.texts.emplace_back("View", description(request_.views[view].camera, rendered.task.window));
      write_image(frame, files.picture, image);
    }
    if (!files.hits.empty()) write_hits(frame.hits, files.hits);
    const std::lock_guard lock(mutex_);
    report_.rays += frame.radiance.size();
    report_.counts += frame.counts;
    report_.seconds.trace += frame.seconds.trace;
    report_.seconds.upload += frame.seconds.upload;
    report_.seconds.download += frame.seconds.download;
    report_.write_seconds += watch.seconds();
    ++finished_;
    if (tracer_.device() == Device::cuda)
      progress_(static_cast<double>(finished_) / static_cast<double>(request_.views.size()));
  }

  const ViewsReport& report() const { return report_; }

private:
  // By what the picture could be made again; it must not tell how it was traced, which makes no difference.
  std::string description(const Camera& camera, const RayWindow& window) const {
    const auto vector = [](const Vec3d& v) { return fmt::format("{},{},{}", v.x, v.y, v.z); };
    std::string text =
        fmt::format("--from {} --at {} --up {} --angle {} --size {}x{}", vector(camera.from),
                    vector(camera.at), vector(camera.up), camera.angle, camera.width, camera.height);
    if (window.columns > 0) {
      const std::int32_t more = request_.frame.sampling == Sampling::corners ? 1 : 0;
      text += fmt::format(" --crop {},{},{},{}", window.first_column, window.first_row, window.columns - more,
                          window.rows - more);
    }
    return text;
  }

  const Tracer& tracer_;
  const ViewsRequest& request_;
  const std::function<void(double)>& progress_;
  std::counting_semaphore<> queries_{queries_at_once};
  std::mutex mutex_; // of what follows
  ViewsReport report_;
  std::size_t finished_ = 0;
};

} // namespace

ViewsReport render_views(const Tracer& tracer, const ViewsRequest& request,
                         const std::function<void(double)>& progress) {
  const Stopwatch watch;
  ViewsRenderer renderer(tracer, request, progress);
  // The CPU's threads share each view's rays; a GPU's tasks wait for each other only on the device.
  const auto tracing =
      tracer.device() == Device::cuda ? tbb::filter_mode::parallel : tbb::filter_mode::serial_in_order;
  std::size_t next = 0;
  tbb::parallel_pipeline(
      views_under_way(request),
      tbb::make_filter<void, RenderTask>(tbb::filter_mode::serial_in_order,
                                         [&](tbb::flow_control& control) -> RenderTask {
                                           if (next < request.views.size())
                                             return {next++, request.frame.window};
                                           control.stop();
                                           return {};
                                         }) &
          tbb::make_filter<RenderTask, RenderedTask>(
              tracing, [&](const RenderTask& task) { return renderer.trace(task); }) &
          tbb::make_filter<RenderedTask, void>(
              tbb::filter_mode::parallel, [&](const RenderedTask& rendered) { renderer.write(rendered); }));
  ViewsReport report = renderer.report();
  report.elapsed_seconds = watch.seconds();
  return report;
}

} // namespace masu
