#include "tools/render/render_views.h"

#include "libscene/base/error.h"
#include "libscene/base/stopwatch.h"
#include "tools/common/repeated.h"
#include "tools/jobs/run_tasks.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>

namespace masu {
namespace {

// By what a picture could be made again; it must not tell how it was traced, which makes no difference.
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
      bands.emplace_back(window_of(frame), frame.sampling);
      first_tasks.push_back(tasks);
      tasks += bands.back().count();
    }
  }

  std::size_t view_of(std::size_t task) const {
    return static_cast<std::size_t>(std::ranges::upper_bound(first_tasks, task) - 1 - first_tasks.begin());
  }
  // Bytes of the largest frame and of what is made of it.
  std::size_t largest_task() const {
    std::size_t rays = 0;
    for (const PictureBands& picture : bands)
      rays = std::max(rays, picture.largest_band_rays());
    return 40 * rays;
  }
};

// Where the views' bands go, by several processes or runs: into partial files, or whole files of one band.
class SharedFiles {
public:
  SharedFiles(const ViewsRequest& request, const Layout& layout) : request_(request), layout_(layout) {
    for (std::size_t view = 0; view < request.views.size(); ++view) {
      const auto name = [&](const std::string& file) {
        if (file.empty()) return file;
        const std::string partial = partial_name(file); // can it have one?
        return is_in_parts(view) ? partial : file;
      };
      names_.push_back({name(request.files[view].picture), name(request.files[view].hits)});
    }
  }

  bool is_in_parts(std::size_t view) const { return layout_.bands[view].count() > 1; }

  std::vector<FileRange> written_by(std::uint64_t task) const {
    const std::size_t view = layout_.view_of(task), band = task - layout_.first_tasks[view];
    const PictureBands& bands = layout_.bands[view];
    const auto& [picture, hits] = names_[view];
    std::vector<FileRange> ranges;
    if (!is_in_parts(view)) {
      for (const std::string& file : {picture, hits})
        if (!file.empty()) ranges.push_back({file});
      return ranges;
    }
    const ImageFormat format = request_.image.format;
    if (!picture.empty())
      ranges.push_back(
          {picture, bands.picture_offset(band, format), format == ImageFormat::pfm ? bands.pfm_bytes() : 0});
    if (!hits.empty())
      ranges.push_back(format_of_hits(view).range(hits, band, bands.first_hit(band), bands.hit_count()));
    return ranges;
  }

  std::vector<FileRange> write(std::size_t view, std::size_t band, const Frame& frame) const {
    const PictureBands& bands = layout_.bands[view];
    const auto& [picture, hits] = names_[view];
    std::vector<FileRange> ranges;
    if (!picture.empty()) {
      FilePart part = bands.picture(band, frame, request_.image);
      const bool has_slot = request_.image.format == ImageFormat::png;
      ranges.push_back(write_part(picture, has_slot ? in_slot(std::move(part)) : std::move(part)));
    }
    if (!hits.empty())
      ranges.push_back(
          write_part(hits, format_of_hits(view).part(band, bands.first_hit(band), bands.hits(band, frame),
                                                     bands.hit_count())));
    return ranges;
  }

  // When all bands of a view in parts are there: its files.
  void finish(std::size_t view, const PngTexts& texts) const {
    const PictureBands& bands = layout_.bands[view];
    const auto& [picture, hits] = request_.files[view];
    if (!hits.empty()) {
      std::vector<std::uint64_t> firsts;
      for (std::size_t band = 0; band < bands.count(); ++band)
        firsts.push_back(bands.first_hit(band));
      format_of_hits(view).finish(firsts, bands.hit_count());
    }
    if (picture.empty()) return;
    if (request_.image.format == ImageFormat::pfm) return finish_partial(picture, bands.pfm_bytes());
    // A PNG file's bands follow each other now that their sizes are known.
    OutputFile file(picture);
    PngWriter png(file, bands.width(), bands.height(), texts);
    for (std::size_t band = 0; band < bands.count(); ++band)
      png.write(png_rows(read_slot(names_[view].picture, bands.picture_offset(band, ImageFormat::png),
                                   bands.picture_offset(band + 1, ImageFormat::png))));
    file.commit();
  }

  // When all views are there: what is left of the partial files.
  void remove_partial_files() const {
    for (std::size_t view = 0; view < names_.size(); ++view) {
      for (const std::string& file : {names_[view].picture, names_[view].hits})
        if (is_in_parts(view) && !file.empty()) std::filesystem::remove(file);
    }
  }

private:
  HitFormat format_of_hits(std::size_t view) const {
    return {request_.files[view].hits, request_.hit_fields};
  }

  const ViewsRequest& request_;
  const Layout& layout_;
  std::vector<ViewFiles> names_;
};

TaskListOf task_list_of(const ViewsRequest& request, const Layout& layout,
                        const std::optional<SharedFiles>& files) {
  TaskListOf tasks{request.description, {}, layout.tasks};
  if (!files) return tasks;
  tasks.writes = [&files](std::uint64_t task) { return files->written_by(task); };
  for (std::size_t i = 0; i < request.views.size(); ++i) {
    const auto& [picture, hits] = request.files[i];
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
  ViewsRenderer(const Tracer& tracer, const ViewsRequest& request, const Layout& layout,
                const Sharing& sharing, const std::function<void(double)>& progress)
      : tracer_(tracer), request_(request), layout_(layout), sharing_(sharing), progress_(progress),
        shared_(sharing.in_parts() ? std::make_optional<SharedFiles>(request, layout) : std::nullopt),
        tasks_(sharing, task_list_of(request, layout, shared_)), outputs_(request.views.size()),
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
    const PictureBands& bands = layout_.bands[view];
    const ViewFiles& files = request_.files[view];
    const Stopwatch watch;
    std::vector<FileRange> written;
    if (shared_ && shared_->is_in_parts(view)) {
      written = shared_->write(view, band, frame);
    } else {
      FilePart picture;
      std::vector<std::uint8_t> hits;
      if (!files.picture.empty()) picture = bands.picture(band, frame, request_.image);
      if (!files.hits.empty()) hits = bands.hits(band, frame);
      output_of(view)->write(band, std::move(picture), std::move(hits));
      if (tasks_.keeps_journal()) {
        for (const std::string& file : {files.picture, files.hits})
          if (!file.empty()) written.push_back(whole_file(file));
      }
    }
    const double share = tasks_.finish(task, written, {bands.rays_counted(band), 0, frame.counts});
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
    for (std::size_t view = 0; view < layout_.bands.size(); ++view) {
      if (shared_->is_in_parts(view) &&
          static_cast<int>(view % static_cast<std::size_t>(ranks.count())) == ranks.rank())
        shared_->finish(view, image_of(view).texts);
    }
    ranks.wait_for_all();
    if (ranks.rank() == 0) {
      shared_->remove_partial_files();
      tasks_.remove_journals();
    }
    report_.write_seconds += watch.seconds();
  }

  // Collective.
  TracingReport report() {
    report_.tasks = layout_.tasks;
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

  ImageOptions image_of(std::size_t view) const {
    ImageOptions image = request_.image;
    image.texts.emplace_back("View", description(request_.views[view].camera, request_.frame));
    return image;
  }

  // A frame that was written, or an empty one.
  Frame spare_frame() {
    const std::lock_guard lock(mutex_);
    if (spare_frames_.empty()) return {};
    Frame frame = std::move(spare_frames_.back());
    spare_frames_.pop_back();
    return frame;
  }

  // Opened by the view's first band, and let go by the last.
  std::shared_ptr<ViewOutput> output_of(std::size_t view) {
    const std::lock_guard lock(mutex_);
    Output& output = outputs_[view];
    if (output.bands == 0)
      output.files = std::make_shared<ViewOutput>(request_.files[view], layout_.bands[view], image_of(view),
                                                  request_.hit_fields);
    return ++output.bands == layout_.bands[view].count() ? std::move(output.files) : output.files;
  }

  struct Output {
    std::size_t bands = 0; // that have come
    std::shared_ptr<ViewOutput> files;
  };

  const Tracer& tracer_;
  const ViewsRequest& request_;
  const Layout& layout_;
  const Sharing& sharing_;
  const std::function<void(double)>& progress_;
  std::optional<SharedFiles> shared_;
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

TracingReport render_views(const Tracer& tracer, const ViewsRequest& request, const Sharing& sharing,
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
