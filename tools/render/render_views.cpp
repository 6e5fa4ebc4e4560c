#include "tools/render/render_views.h"

#include "libscene/base/error.h"
#include "libscene/base/stopwatch.h"
#include "tools/common/repeated.h"
#include "tools/jobs/run_tasks.h"
#include "tools/render/picture_bands.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>

namespace masu {
namespace {

// By what a picture could be made again. How it was traced makes no difference, and isn't mentioned.
std::string description(const Camera& camera, const FrameRequest& frame) {
  const auto vector = [](const Vec3d& v) { return fmt::format("{},{},{}", v.x, v.y, v.z); };
  std::string text =
      fmt::format("--from {} --at {} --up {} --angle {} --size {}x{}", vector(camera.from), vector(camera.at),
                  vector(camera.up), camera.angle, camera.width, camera.height);
  const RayWindow& window = frame.window;
  if (window.columns > 0) {
    const std::int32_t more = frame.sampling == Sampling::corners ? 1 : 0;
    text += fmt::format(" --crop {},{},{},{}", window.first_column, window.first_row, window.columns - more,
                        window.rows - more);
  }
  return text;
}

// The views' bands: these are the tasks.
struct Layout {
  std::vector<PictureBands> bands;      // of each view
  std::vector<std::size_t> first_tasks; // of each view
  std::size_t tasks = 0;

  explicit Layout(const ViewsRequest& request) {
    for (const View& view : request.views) {
      FrameRequest frame = request.frame;
      frame.camera = view.camera;
      bands.emplace_back(window_of(frame), frame.sampling, request.image.format);
      first_tasks.push_back(tasks);
      tasks += bands.back().count();
    }
  }

  std::size_t view_of(std::size_t task) const {
    return static_cast<std::size_t>(std::ranges::upper_bound(first_tasks, task) - 1 - first_tasks.begin());
  }
  bool has_parts(std::size_t view) const { return bands[view].count() > 1; }
  // Bytes of the largest frame and of what is made of it.
  std::size_t largest_task() const {
    std::size_t rays = 0;
    for (const PictureBands& picture : bands)
      rays = std::max(rays, picture.largest_band_rays());
    return 40 * rays;
  }
};

// A file of a view, of which each band is a part.
struct ViewFile {
  std::string path;
  PartedForm form;
  std::function<std::vector<std::uint8_t>(std::size_t band, const Frame& frame)> part;
  std::unique_ptr<PartedFile> opened{}; // where this process writes it alone
};

// `request` and `layout` outlive them.
std::vector<ViewFile> files_of(const ViewsRequest& request, const Layout& layout, std::size_t view) {
  const PictureBands& bands = layout.bands[view];
  const auto& [picture, hits] = request.files[view];
  std::vector<ViewFile> files;
  if (!hits.empty()) {
    const HitFormat format(hits, request.hit_fields, 0);
    files.push_back({hits,
                     format.parts(
                         bands.count(), [&bands](std::uint64_t band) { return bands.first_hit(band); },
                         bands.hit_count()),
                     [&bands, format](std::size_t band, const Frame& frame) {
                       return format.part(bands.hits(band, frame), bands.first_hit(band), bands.hit_count());
                     }});
  }
  if (!picture.empty()) {
    const auto texts = [&request, view] {
      PictureTexts all = request.image.texts;
      all.emplace_back("View", description(request.views[view].camera, request.frame));
      return all;
    };
    files.push_back({picture, bands.picture_form(texts),
                     [&bands, &image = request.image](std::size_t band, const Frame& frame) {
                       return bands.picture(band, frame, image);
                     }});
  }
  return files;
}

// By several processes or runs: a file of one band is written whole, and known as a whole.
std::vector<FileRange> ranges_of(const ViewsRequest& request, const Layout& layout, std::uint64_t task) {
  const std::size_t view = layout.view_of(task), band = task - layout.first_tasks[view];
  std::vector<FileRange> ranges;
  for (const ViewFile& file : files_of(request, layout, view))
    ranges.push_back(layout.has_parts(view) ? range_of(file.path, file.form, band) : FileRange{file.path});
  return ranges;
}

TaskListOf task_list_of(const ViewsRequest& request, const Layout& layout, const Sharing& sharing) {
  TaskListOf tasks{request.description, {}, layout.tasks};
  if (!sharing.in_parts()) return tasks;
  tasks.writes = [&](std::uint64_t task) { return ranges_of(request, layout, task); };
  for (std::size_t i = 0; i < request.views.size(); ++i) {
    const auto& [picture, hits] = request.files[i];
    for (const std::string& file : {picture, hits})
      if (!file.empty()) static_cast<void>(partial_name(file)); // can it have one?
    tasks.description +=
        fmt::format("\n{}\n{}\n{}", description(request.views[i].camera, request.frame), picture, hits);
  }
  const auto& [picture, hits] = request.files.front();
  tasks.output = picture.empty() ? hits : picture;
  return tasks;
}

struct RenderedTask {
  std::size_t task, view, band;
  Frame frame;
};

// Tracing and writing of tasks, in any order and at the same time.
class ViewsRenderer {
public:
  ViewsRenderer(const ResidentTracer& tracer, const ViewsRequest& request, const Layout& layout,
                const Sharing& sharing, const std::function<void(double)>& progress)
      : tracer_(tracer), request_(request), layout_(layout), sharing_(sharing), progress_(progress),
        tasks_(sharing, task_list_of(request, layout, sharing)), outputs_(request.views.size()),
        precisions_(request.views.size()) {}

  // The next task's, or nothing.
  std::shared_ptr<RenderedTask> trace(std::size_t device) {
    const auto task = tasks_.next();
    if (!task) return {};
    const std::size_t view = layout_.view_of(*task), band = *task - layout_.first_tasks[view];
    const PictureBands& bands = layout_.bands[view];
    FrameRequest frame = request_.frame;
    frame.camera = request_.views[view].camera;
    frame.tracing.precision = precision_of(view, frame);
    frame.rgb = request_.image.format != ImageFormat::pfm && !request_.image.srgb;
    frame.window = bands.rays(band);
    frame.count_last_row = bands.is_last(band) || frame.sampling == Sampling::centers;
    // A process on the CPU traces tasks one by one, and that takes the time.
    if (!sharing_.in_parts())
      frame.progress = [&](double share) {
        progress_((static_cast<double>(*task) + share) / static_cast<double>(layout_.tasks));
      };
    return std::make_shared<RenderedTask>(RenderedTask{*task, view, band, repeated(0, request_.repeat, [&] {
                                                         return tracer_.render(frame, device, spare_frame());
                                                       })});
  }

  // Its frame's memory then serves another task.
  void write(RenderedTask& rendered) {
    const auto& [task, view, band, frame] = rendered;
    const Stopwatch watch;
    std::vector<FileRange> written;
    if (sharing_.in_parts() && layout_.has_parts(view)) {
      for (const ViewFile& file : files_of(request_, layout_, view))
        written.push_back(write_part(file.path, file.form, band, file.part(band, frame)));
    } else {
      write_alone(view, band, frame);
      if (tasks_.keeps_journal()) {
        for (const ViewFile& file : files_of(request_, layout_, view))
          written.push_back(whole_file(file.path));
      }
    }
    const std::uint64_t rays = layout_.bands[view].rays_counted(band);
    const double share = tasks_.finish(task, written, {rays, 0, frame.counts});
    const std::lock_guard lock(mutex_);
    report_.seconds += frame.seconds;
    report_.write_seconds += watch.seconds();
    if (sharing_.in_parts() || tracer_.device() == Device::cuda) progress_(share);
    spare_frames_.push_back(std::move(rendered.frame));
  }

  // Collective: when all tasks are done, makes files of what was written in parts.
  void finish() {
    Ranks& ranks = sharing_.ranks;
    const Stopwatch watch;
    ranks.wait_for_all([&] { progress_(tasks_.share()); });
    const auto for_each_file_in_parts = [&](const auto& act) {
      for (std::size_t view = 0; view < layout_.bands.size(); ++view)
        if (layout_.has_parts(view))
          for (const ViewFile& file : files_of(request_, layout_, view))
            act(view, file);
    };
    for_each_file_in_parts([&](std::size_t view, const ViewFile& file) {
      if (static_cast<int>(view % static_cast<std::size_t>(ranks.count())) == ranks.rank())
        finish_parts(file.path, file.form);
    });
    ranks.wait_for_all();
    if (ranks.rank() == 0) {
      for_each_file_in_parts([](std::size_t, const ViewFile& file) {
        std::filesystem::remove(partial_name(file.path)); // of parts that were copied
      });
      tasks_.remove_journals();
    }
    report_.write_seconds += watch.seconds();
  }

  // Collective.
  TracingReport report() {
    report_.views = request_.views.size();
    report_.overlaps_writing = layout_.tasks > 1 || sharing_.in_parts();
    report_.totals = tasks_.totals();
    sum_up(sharing_.ranks, report_);
    if (request_.frame.tracing.precision == Precision::automatic) report_precisions();
    return report_;
  }

private:
  // That of all bands of a view.
  Precision precision_of(std::size_t view, const FrameRequest& frame) {
    if (frame.tracing.precision != Precision::automatic) return frame.tracing.precision;
    ChosenPrecision& chosen = precisions_[view];
    std::call_once(chosen.once, [&] { chosen.view = view_precision(tracer_, frame); });
    return chosen.view->precision;
  }

  // Collective. Of several ranks some may have chosen for the same view.
  void report_precisions() {
    std::vector<std::uint64_t> doubled(precisions_.size());
    for (std::size_t view = 0; view < precisions_.size(); ++view) {
      const std::optional<ViewPrecision>& chosen = precisions_[view].view;
      if (!chosen) continue;
      doubled[view] = chosen->precision == Precision::doubled ? 1 : 0;
      if (!report_.precision || (report_.precision->precision == Precision::robust && doubled[view] == 1))
        report_.precision = chosen;
    }
    sharing_.ranks.sum(doubled);
    report_.double_views = static_cast<std::uint64_t>(
        std::ranges::count_if(doubled, [](std::uint64_t ranks) { return ranks > 0; }));
  }

  // A frame that was written, or an empty one.
  Frame spare_frame() {
    const std::lock_guard lock(mutex_);
    if (spare_frames_.empty()) return {};
    Frame frame = std::move(spare_frames_.back());
    spare_frames_.pop_back();
    return frame;
  }

  // A view while this process writes its files alone.
  struct Output {
    bool is_open = false;
    std::vector<ViewFile> files;
    std::atomic<std::size_t> written = 0; // bands
  };

  // The first band that comes opens the view's files, and the last one commits them.
  void write_alone(std::size_t view, std::size_t band, const Frame& frame) {
    Output& output = outputs_[view];
    {
      const std::lock_guard lock(mutex_);
      if (!output.is_open) {
        std::vector<ViewFile> files = files_of(request_, layout_, view);
        for (ViewFile& file : files)
          file.opened = std::make_unique<PartedFile>(file.path, file.form);
        output.files = std::move(files);
        output.is_open = true;
      }
    }
    for (const ViewFile& file : output.files)
      file.opened->write(band, file.part(band, frame));
    if (++output.written < layout_.bands[view].count()) return;
    for (const ViewFile& file : output.files)
      file.opened->commit();
    output.files.clear();
  }

  const ResidentTracer& tracer_;
  const ViewsRequest& request_;
  const Layout& layout_;
  const Sharing& sharing_;
  const std::function<void(double)>& progress_;
  TaskList tasks_;
  std::mutex mutex_; // of what follows
  std::vector<Output> outputs_;
  struct ChosenPrecision {
    std::once_flag once;
    std::optional<ViewPrecision> view;
  };

  std::vector<Frame> spare_frames_; // together with those under way as many as tasks may be
  TracingReport report_;
  std::vector<ChosenPrecision> precisions_; // of each view
};

} // namespace

TracingReport render_views(const ResidentTracer& tracer, const ViewsRequest& request, const Sharing& sharing,
                           const std::function<void(double)>& progress) {
  const Stopwatch watch;
  const Layout layout(request);
  ViewsRenderer renderer(tracer, request, layout, sharing, progress);
  run_tasks(
      tracer, tasks_under_way(tracer, layout.largest_task()),
      [&](std::size_t device) { return renderer.trace(device); },
      [&](RenderedTask& rendered) { renderer.write(rendered); });
  if (sharing.in_parts()) renderer.finish();
  TracingReport report = renderer.report();
  report.elapsed_seconds = watch.seconds();
  return report;
}

} // namespace masu
