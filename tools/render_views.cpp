#include "tools/render_views.h"

#include "libscene/stopwatch.h"
#include "tools/repeated.h"
#include "tools/run_tasks.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <mutex>

namespace masu {
namespace {

// The unit of work: a band of a view.
struct RenderTask {
  std::size_t view = 0, band = 0;
};

struct RenderedTask {
  RenderTask task;
  Frame frame;
};

// Tracing and writing of tasks, in any order and at the same time.
class ViewsRenderer {
public:
  ViewsRenderer(const Tracer& tracer, const ViewsRequest& request,
                const std::function<void(double)>& progress)
      : tracer_(tracer), request_(request), progress_(progress), outputs_(request.views.size()) {
    for (const View& view : request.views) {
      bands_.emplace_back(request.frame.window.columns > 0 ? request.frame.window
                                                           : all_rays(view.camera, request.frame.sampling),
                          request.frame.sampling);
      first_tasks_.push_back(tasks_);
      tasks_ += bands_.back().count();
    }
  }

  // Bytes of the largest frame and of what is made of it.
  std::size_t largest_task() const {
    std::size_t rays = 0;
    for (const PictureBands& bands : bands_)
      rays = std::max(rays, bands.largest_band_rays());
    return 40 * rays;
  }

  // The next task's, or nothing.
  std::shared_ptr<RenderedTask> trace(std::size_t device) {
    const std::size_t next = next_++;
    if (next >= tasks_) return {};
    const auto view =
        static_cast<std::size_t>(std::ranges::upper_bound(first_tasks_, next) - 1 - first_tasks_.begin());
    const RenderTask task{view, next - first_tasks_[view]};
    FrameRequest frame = request_.frame;
    frame.camera = request_.views[view].camera;
    frame.window = bands_[view].rays(task.band);
    frame.count_last_row = bands_[view].is_last(task.band) || frame.sampling == Sampling::centers;
    // The CPU traces tasks one by one, and that takes the time.
    frame.progress = [&](double share) {
      progress_((static_cast<double>(next) + share) / static_cast<double>(tasks_));
    };
    return std::make_shared<RenderedTask>(
        RenderedTask{task, repeated(0, request_.repeat, [&] { return tracer_.render(frame, device); })});
  }

  void write(const RenderedTask& rendered) {
    const auto& [task, frame] = rendered;
    const PictureBands& bands = bands_[task.view];
    const ViewFiles& files = request_.files[task.view];
    const Stopwatch watch;
    const std::shared_ptr<ViewOutput> output = output_of(task.view);
    output->write(task.band,
                  files.picture.empty() ? FilePart{} : bands.picture(task.band, frame, request_.image),
                  files.hits.empty() ? FilePart{} : bands.hits(task.band, frame));
    const std::lock_guard lock(mutex_);
    report_.rays += bands.rays_counted(task.band);
    report_.counts += frame.counts;
    report_.seconds += frame.seconds;
    report_.write_seconds += watch.seconds();
    ++finished_;
    if (tracer_.device() == Device::cuda)
      progress_(static_cast<double>(finished_) / static_cast<double>(tasks_));
  }

  const ViewsReport& report() const { return report_; }

private:
  // Opened by the view's first band, and let go by the last.
  std::shared_ptr<ViewOutput> output_of(std::size_t view) {
    const std::lock_guard lock(mutex_);
    Output& output = outputs_[view];
    if (output.bands == 0) {
      ImageOptions image = request_.image;
      image.texts.emplace_back("View", description(request_.views[view].camera));
      output.files = std::make_shared<ViewOutput>(request_.files[view], bands_[view], image);
    }
    return ++output.bands == bands_[view].count() ? std::move(output.files) : output.files;
  }

  // By what the picture could be made again; it must not tell how it was traced, which makes no difference.
  std::string description(const Camera& camera) const {
    const auto vector = [](const Vec3d& v) { return fmt::format("{},{},{}", v.x, v.y, v.z); };
    std::string text =
        fmt::format("--from {} --at {} --up {} --angle {} --size {}x{}", vector(camera.from),
                    vector(camera.at), vector(camera.up), camera.angle, camera.width, camera.height);
    const RayWindow& window = request_.frame.window;
    if (window.columns > 0) {
      const std::int32_t more = request_.frame.sampling == Sampling::corners ? 1 : 0;
      text += fmt::format(" --crop {},{},{},{}", window.first_column, window.first_row, window.columns - more,
                          window.rows - more);
    }
    return text;
  }

  struct Output {
    std::size_t bands = 0; // that have come
    std::shared_ptr<ViewOutput> files;
  };

  const Tracer& tracer_;
  const ViewsRequest& request_;
  const std::function<void(double)>& progress_;
  std::vector<PictureBands> bands_;      // of each view
  std::vector<std::size_t> first_tasks_; // of each view
  std::size_t tasks_ = 0;
  std::atomic<std::size_t> next_ = 0;
  std::mutex mutex_; // of what follows
  std::vector<Output> outputs_;
  ViewsReport report_;
  std::size_t finished_ = 0;
};

} // namespace

ViewsReport render_views(const Tracer& tracer, const ViewsRequest& request,
                         const std::function<void(double)>& progress) {
  const Stopwatch watch;
  ViewsRenderer renderer(tracer, request, progress);
  run_tasks(
      tracer, tasks_under_way(tracer, renderer.largest_task()),
      [&](std::size_t device) { return renderer.trace(device); },
      [&](const RenderedTask& rendered) { renderer.write(rendered); });
  ViewsReport report = renderer.report();
  report.elapsed_seconds = watch.seconds();
  return report;
}

} // namespace masu
