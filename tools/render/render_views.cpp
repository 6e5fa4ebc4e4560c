#include "tools/render/render_views.h"

#include "libscene/base/error.h"
#include "libscene/base/stopwatch.h"
#include "tools/common/progress.h"
#include "tools/common/repeated.h"
#include "tools/jobs/run_tasks.h"
#include "tools/render/picture_bands.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
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

// The views' bands, and which of them a rank takes at a time: one; or of several ranks a whole view, whose
// files it then writes alone and which appear as soon as they are whole. The last views of several bands are
// shared: so ranks end together.
struct Layout {
  struct Bands {
    std::size_t view = 0, first = 0, end = 0;
  };

  std::vector<PictureBands> bands; // of each view
  std::vector<Bands> taken;        // at a time
  std::size_t first_shared = 0;    // views from here on, where they have several bands
  std::vector<std::size_t> before; // bands of the views before each view
  std::size_t all_bands = 0;

  Layout(const ViewsRequest& request, const Ranks& ranks) {
    constexpr std::size_t most_shared = 32; // whose files rank 0 holds open
    const std::size_t views = request.views.size();
    first_shared = views;
    if (ranks.count() > 1)
      first_shared -= std::min({views, static_cast<std::size_t>(ranks.count()), most_shared});
    for (const View& view : request.views) {
      FrameRequest frame = request.frame;
      frame.camera = view.camera;
      const PictureBands& added = bands.emplace_back(window_of(frame), frame.sampling, request.image.format);
      const std::size_t index = bands.size() - 1, count = added.count(),
                        step = ranks.count() > 1 && index < first_shared ? count : 1;
      for (std::size_t first = 0; first < count; first += step)
        taken.push_back({index, first, first + step});
      before.push_back(all_bands);
      all_bands += count;
    }
  }

  bool is_shared(std::size_t view) const { return view >= first_shared && bands[view].count() > 1; }
  // Bytes of the largest frame and of what is made of it.
  std::size_t largest_band() const {
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
  // What writes it, when it is open: with other ranks, or this process alone.
  std::unique_ptr<SharedFile> shared{};
  std::unique_ptr<PartedFile> alone{};
};

PictureTexts texts_of(const ViewsRequest& request, std::size_t view) {
  PictureTexts all = request.image.texts;
  all.emplace_back("View", description(request.views[view].camera, request.frame));
  return all;
}

// `request` and `bands` outlive them.
std::vector<ViewFile> files_of(const ViewsRequest& request, const PictureBands& bands, std::size_t view) {
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
  if (!picture.empty())
    files.push_back({picture, bands.picture_form([&request, view] { return texts_of(request, view); }),
                     [&bands, &image = request.image](std::size_t band, const Frame& frame) {
                       return bands.picture(band, frame, image);
                     }});
  return files;
}

// --- What is kept ------------------------------------------------------------------------------------------

// Of a view: k for a file that is kept, m for one that is made.
std::string kept_files(const ViewsRequest& request, const PictureBands& bands, std::size_t view) {
  const auto& [picture, hits] = request.files[view];
  const bool all = request.resume == Resume::all, is_described = request.image.format != ImageFormat::pfm,
             keeps_picture = !picture.empty() && (all || is_described) &&
                             is_kept(picture, bands.known_by(texts_of(request, view))),
             is_other = !picture.empty() && !keeps_picture && is_kept(picture, {}),
             // Beside a picture of something else they are of that, too.
      keeps_hits = !hits.empty() && all && !is_other &&
                   is_kept(hits, HitFormat(hits, request.hit_fields, 0).known_by(bands.hit_count()));
  return {keeps_picture ? 'k' : 'm', keeps_hits ? 'k' : 'm'};
}

// Collective: without what is kept, by rank 0, which may see others' first files already.
ViewsRequest without_kept(const ViewsRequest& request, Ranks& ranks, TracingReport& report) {
  std::string kept;
  if (ranks.rank() == 0) {
    const Layout layout(request, ranks);
    for (std::size_t view = 0; view < request.views.size(); ++view)
      kept += kept_files(request, layout.bands[view], view);
  }
  ranks.broadcast(kept);
  ViewsRequest rest = request;
  rest.views.clear();
  rest.files.clear();
  for (std::size_t view = 0; view < request.views.size(); ++view) {
    ViewFiles files = request.files[view];
    std::size_t i = 2 * view;
    for (std::string* const file : {&files.picture, &files.hits}) {
      report.files += file->empty() ? 0 : 1;
      if (kept[i++] != 'k') continue;
      ++report.kept;
      file->clear();
    }
    if (files.picture.empty() && files.hits.empty()) continue;
    rest.views.push_back(request.views[view]);
    rest.files.push_back(std::move(files));
  }
  return rest;
}

// --- Tracing and writing -----------------------------------------------------------------------------------

struct RenderedBand {
  std::size_t view, band;
  Frame frame;
};

// Of bands, in any order and at the same time.
class ViewsRenderer {
public:
  // Collective.
  ViewsRenderer(const ResidentTracer& tracer, const ViewsRequest& request, const Layout& layout, Ranks& ranks,
                bool quiet)
      : tracer_(tracer), request_(request), layout_(layout), ranks_(ranks), progress_("rendering", quiet),
        outputs_(request.views.size()), precisions_(request.views.size()) {
    for (std::size_t view = layout.first_shared; view < request.views.size(); ++view) {
      if (!layout.is_shared(view)) continue;
      outputs_[view].files = files_of(request, layout.bands[view], view);
      for (ViewFile& file : outputs_[view].files)
        file.shared = std::make_unique<SharedFile>(file.path, file.form, ranks);
    }
  }

  // The next band's, or nothing.
  std::shared_ptr<RenderedBand> trace(std::size_t device) {
    const auto next = next_band();
    if (!next) return {};
    const auto [view, band] = *next;
    const PictureBands& bands = layout_.bands[view];
    FrameRequest frame = request_.frame;
    frame.camera = request_.views[view].camera;
    frame.tracing.precision = precision_of(view, frame);
    frame.rgb = request_.image.format != ImageFormat::pfm && !request_.image.srgb;
    frame.window = bands.rays(band);
    frame.count_last_row = bands.is_last(band) || frame.sampling == Sampling::centers;
    // A process on the CPU traces bands one by one, and that takes the time.
    if (ranks_.count() == 1)
      frame.progress = [this, before = static_cast<double>(layout_.before[view] + band)](double share) {
        progress_((before + share) / static_cast<double>(layout_.all_bands));
      };
    return std::make_shared<RenderedBand>(RenderedBand{view, band, repeated(0, request_.repeat, [&] {
                                                         return tracer_.render(frame, device, spare_frame());
                                                       })});
  }

  // Its frame's memory then serves another band.
  void write(RenderedBand& rendered) {
    const auto& [view, band, frame] = rendered;
    const Stopwatch watch;
    write_parts(view, band, frame);
    ranks_.add_finished(1);
    const std::lock_guard lock(mutex_);
    report_.totals += {layout_.bands[view].rays_counted(band), 0, frame.counts};
    report_.seconds += frame.seconds;
    report_.write_seconds += watch.seconds();
    if (ranks_.count() > 1 || tracer_.device() == Device::cuda) show_progress();
    spare_frames_.push_back(std::move(rendered.frame));
  }

  // Collective, when all bands are written.
  TracingReport finish() {
    const Stopwatch watch;
    for (const Output& output : outputs_) // those that are written alone are committed
      for (const ViewFile& file : output.files)
        file.shared->close();
    ranks_.wait_for_all([&] { show_progress(); });
    for (const Output& output : outputs_)
      for (const ViewFile& file : output.files)
        if (ranks_.rank() == 0) file.shared->commit();
    ranks_.wait_for_all();
    report_.write_seconds += watch.seconds();
    report_.views = request_.views.size();
    report_.overlaps_writing = layout_.all_bands > 1 || ranks_.count() > 1;
    sum_up(ranks_, report_);
    if (request_.frame.tracing.precision == Precision::automatic) report_precisions();
    return report_;
  }

private:
  // That of all bands of a view.
  Precision precision_of(std::size_t view, const FrameRequest& frame) {
    if (frame.tracing.precision != Precision::automatic) return frame.tracing.precision;
    ChosenPrecision& chosen = precisions_[view];
    // Not std::call_once: glibc needs memory to let an exception through it, and aborts without.
    const std::lock_guard lock(chosen.choosing);
    if (!chosen.view) chosen.view = view_precision(tracer_, frame);
    return chosen.view->precision;
  }

  // Its view and its number.
  std::optional<std::pair<std::size_t, std::size_t>> next_band() {
    const std::lock_guard lock(taking_);
    if (taken_.first == taken_.end) {
      const std::uint64_t next = ranks_.next();
      if (next >= layout_.taken.size()) return {};
      taken_ = layout_.taken[next];
    }
    return std::pair(taken_.view, taken_.first++);
  }

  void show_progress() {
    progress_(static_cast<double>(ranks_.add_finished(0)) /
              static_cast<double>(std::max<std::size_t>(layout_.all_bands, 1)));
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
    ranks_.sum(doubled);
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

  struct Output {
    std::vector<ViewFile> files;          // of a view
    std::atomic<std::size_t> written = 0; // bands, by this process alone
  };

  // Of a view that this process writes alone the first band that comes opens the files, and the last one
  // commits them.
  void write_parts(std::size_t view, std::size_t band, const Frame& frame) {
    Output& output = outputs_[view];
    const bool is_shared = layout_.is_shared(view);
    if (!is_shared) {
      const std::lock_guard lock(mutex_);
      if (output.files.empty()) {
        std::vector<ViewFile> files = files_of(request_, layout_.bands[view], view);
        for (ViewFile& file : files)
          file.alone = std::make_unique<PartedFile>(file.path, file.form);
        output.files = std::move(files);
      }
    }
    for (const ViewFile& file : output.files) {
      std::vector<std::uint8_t> part = file.part(band, frame);
      is_shared ? file.shared->write(band, std::move(part)) : file.alone->write(band, std::move(part));
    }
    if (is_shared || ++output.written < layout_.bands[view].count()) return;
    for (const ViewFile& file : output.files)
      file.alone->commit();
    output.files.clear();
  }

  const ResidentTracer& tracer_;
  const ViewsRequest& request_;
  const Layout& layout_;
  Ranks& ranks_;
  Progress progress_;
  std::mutex taking_; // of taken_
  Layout::Bands taken_{};
  std::mutex mutex_; // of what follows
  std::vector<Output> outputs_;
  struct ChosenPrecision {
    std::mutex choosing;
    std::optional<ViewPrecision> view;
  };

  std::vector<Frame> spare_frames_; // together with those under way as many as tasks may be
  TracingReport report_;
  std::vector<ChosenPrecision> precisions_; // of each view
};

} // namespace

TracingReport render_views(const ResidentTracer& tracer, const ViewsRequest& asked, Ranks& ranks,
                           bool quiet) {
  const Stopwatch watch;
  TracingReport kept;
  ViewsRequest rest;
  const bool resumes = asked.resume != Resume::off;
  if (resumes) rest = without_kept(asked, ranks, kept);
  const ViewsRequest& request = resumes ? rest : asked;
  const Layout layout(request, ranks);
  ViewsRenderer renderer(tracer, request, layout, ranks, quiet);
  run_tasks(
      tracer, tasks_under_way(tracer, layout.largest_band()),
      [&](std::size_t device) { return renderer.trace(device); },
      [&](RenderedBand& rendered) { renderer.write(rendered); });
  TracingReport report = renderer.finish();
  report.files = kept.files;
  report.kept = kept.kept;
  report.elapsed_seconds = watch.seconds();
  return report;
}

} // namespace masu
