// How views, one large view and a list of rays speed up with more GPUs, or with more threads of the CPU; and
// what bounds them.
#include "libscene/base/on_threads.h"
#include "libscene/base/stopwatch.h"
#include "libscene/file/output_file.h"
#include "scale_script.h"
#include "tools/bench/bench.h"
#include "tools/bench/command.h"
#include "tools/bench/gnuplot.h"
#include "tools/bench/host_list.h"
#include "tools/jobs/device_choice.h"
#include "tools/jobs/run_tasks.h"
#include "tools/render/picture_bands.h"
#include "tools/render/render_views.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace masu {
namespace {

using Json = nlohmann::ordered_json;

struct Settings {
  std::string scene, grid, size = "1024x1024", folder, charts;
  DeviceChoice devices;
  int views = 400, large = 16384, repeat = 3;
  std::size_t rays = 100'000'000;
  std::uint64_t seed = 1;
};

// So many GPUs, or threads of the CPU.
struct Workers {
  std::vector<int> gpus; // none: the CPU
  std::size_t count = 0;
};

// A measurement: what it took by the clock, and, summed over all workers, what its stages took.
struct Run {
  double rays = 0, seconds = 0;
  double trace = 0, copies = 0, encode = 0; // encode: of all threads
  // By the clock, of nothing else: copying the same bytes up and down, encoding as many bands by all threads.
  double plain_copy = 0, plain_encode = 0;
};

// The stage that is busy for the largest share of the time: where that is near 1, only a faster stage or more
// of what it runs on would make the work faster.
struct Bound {
  const char* name;
  double share;
};
Bound bound_of(const Run& run, const Workers& workers) {
  // The CPU's threads trace each task together, by the clock. A GPU's queries copy at the same time.
  const auto devices = static_cast<double>(std::max<std::size_t>(workers.gpus.size(), 1));
  const Bound bounds[] = {
      {"tracing", run.trace / devices / run.seconds},
      {"copies", std::max(run.copies / devices / queries_per_gpu, run.plain_copy) / run.seconds},
      {"encoding", run.plain_encode / run.seconds}};
  const Bound most = *std::ranges::max_element(bounds, {}, &Bound::share);
  return {most.name, std::min(most.share, 1.0)}; // measured apart, a stage may take longer
}

// A folder that is removed with its contents.
class Scratch {
public:
  explicit Scratch(const std::string& parent) {
    std::string name = (std::filesystem::path(parent) / "masu-scale-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr)
      throw Error(ErrorCode::output, parent, "no folder can be made in it");
    path_ = name;
  }
  ~Scratch() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  std::string file(const std::string& name) const { return path_ + "/" + name; }

private:
  std::string path_;
};

template <class Measure>
Run median_run(int repeat, const Measure& measure) {
  std::vector<Run> runs;
  for (int i = 0; i <= repeat; ++i) {
    const Run run = measure();
    if (i > 0) runs.push_back(run); // the first one warms up
  }
  std::ranges::sort(runs, {}, &Run::seconds);
  return runs[runs.size() / 2];
}

// Seconds in which all threads encode as many bands as the views have: one from the middle of them, again and
// again.
double encoded(const ResidentTracer& tracer, const ViewsRequest& request) {
  FrameRequest middle = request.frame;
  middle.camera = request.views[request.views.size() / 2].camera;
  const PictureBands bands(window_of(middle), middle.sampling, ImageFormat::png);
  const std::size_t band = bands.count() / 2, all = bands.count() * request.views.size();
  middle.window = bands.rays(band);
  const Frame frame = tracer.render(middle);
  std::atomic<std::size_t> begun = 0;
  const Stopwatch watch;
  on_threads(allowed_threads(), [&](std::size_t) {
    while (begun.fetch_add(1) < all)
      static_cast<void>(bands.picture(band, frame, request.image));
  });
  return watch.seconds();
}

// Views, written as PNG.
Run rendered(const Settings& settings, const ResidentTracer& tracer, const Camera& camera, int views) {
  return median_run(settings.repeat, [&] {
    int argc = 0;
    char** argv = nullptr;
    Ranks ranks(&argc, &argv); // which count a run's tasks
    const Scratch scratch(settings.folder);
    ViewsRequest request;
    request.views = views > 1 ? turntable(camera, views) : std::vector<View>{{"0", camera}};
    for (const View& view : request.views)
      request.files.push_back({scratch.file(view.name + ".png"), ""});
    const TracingReport report = render_views(tracer, request, {ranks}, [](double) {});
    Run run;
    run.rays = static_cast<double>(report.totals.rays);
    run.seconds = report.elapsed_seconds;
    run.trace = report.seconds.trace;
    run.copies = report.seconds.upload + report.seconds.download;
    run.encode = report.write_seconds;
    run.plain_encode = encoded(tracer, request);
    return run;
  });
}

// All GPUs at the same time, each a part.
double copied(const HostList& list, const Workers& workers, std::size_t count) {
  const std::size_t part = count / workers.count;
  std::vector<double> seconds(workers.count);
  on_threads(workers.count,
             [&](std::size_t i) { seconds[i] = list.plain_copy_seconds(i * part, part, workers.gpus[i]); });
  return *std::ranges::max_element(seconds);
}

// The first rays of a list.
Run traced(const Settings& settings, const ResidentTracer& tracer, const HostList& list,
           const Workers& workers, std::size_t count) {
  return median_run(settings.repeat, [&] {
    Run run;
    run.rays = static_cast<double>(count);
    const Stopwatch watch;
    const QueryReport report = tracer.trace(list.rays(count), list.results(), {});
    run.seconds = watch.seconds();
    run.trace = report.seconds.trace;
    run.plain_copy = workers.gpus.empty() ? 0 : copied(list, workers, count);
    return run;
  });
}

Json row_of(const char* work, const char* scaling, const Workers& workers, const Run& run, double one_rate) {
  const double rate = run.rays / run.seconds, speedup = rate / one_rate;
  const Bound bound = bound_of(run, workers);
  return {{"work", work},
          {"scaling", scaling},
          {"workers", workers.count},
          {"rays", run.rays},
          {"seconds", run.seconds},
          {"mrays_per_second", rate * 1e-6},
          {"speedup", speedup},
          {"efficiency", speedup / static_cast<double>(workers.count)},
          {"bound", bound.name},
          {"bound_share", bound.share},
          {"trace_seconds", run.trace},
          {"copy_seconds", run.copies},
          {"encode_seconds", run.encode},
          {"plain_copy_seconds", run.plain_copy},
          {"plain_encode_seconds", run.plain_encode}};
}

void print_row(const Output& output, const Json& row) {
  output.print("{:<10} {:<7} {:>7} {:>9.4f} {:>9.1f} {:>8.2f} {:>6.0f} %  {} {:.0f} %\n",
               row["work"].get<std::string>(), row["scaling"].get<std::string>(),
               row["workers"].get<std::size_t>(), row["seconds"].get<double>(),
               row["mrays_per_second"].get<double>(), row["speedup"].get<double>(),
               100 * row["efficiency"].get<double>(), row["bound"].get<std::string>(),
               100 * row["bound_share"].get<double>());
}

void draw(const Settings& settings, const Json& rows) {
  std::string csv = "work,scaling,workers,seconds,mrays_per_second,speedup\n";
  for (const Json& row : rows)
    csv +=
        fmt::format("{},{},{},{},{},{}\n", row["work"].get<std::string>(), row["scaling"].get<std::string>(),
                    row["workers"].get<std::size_t>(), row["seconds"].get<double>(),
                    row["mrays_per_second"].get<double>(), row["speedup"].get<double>());
  std::filesystem::create_directories(settings.charts);
  write_text_file(settings.charts + "/scale.csv", csv);
  if (!draw_charts(scale_script, settings.charts, "scale.csv", {"scale.svg", "scale.png"}))
    print_note("gridbench: gnuplot isn't installed: scale.csv was written, but no chart\n");
}

// 1, 2, 4, … and all of them.
std::vector<Workers> steps(const std::vector<int>& gpus) {
  const std::size_t all = gpus.empty() ? allowed_threads() : gpus.size();
  std::vector<Workers> found;
  for (std::size_t count = 1; count < all; count *= 2)
    found.push_back({{}, count});
  found.push_back({{}, all});
  for (Workers& workers : found)
    workers.gpus.assign(
        gpus.begin(), gpus.empty() ? gpus.end() : gpus.begin() + static_cast<std::ptrdiff_t>(workers.count));
  return found;
}

int rounded(double value) {
  return static_cast<int>(std::lround(value));
}

void bench_scale(const Settings& settings, Output& output) {
  int argc = 0;
  char** argv = nullptr;
  Ranks ranks(&argc, &argv);
  const std::vector<int> gpus = settings.devices.gpus(ranks);
  const bool cuda = !gpus.empty();
  const SceneFile scene(settings.scene);
  const StructureFile grid(settings.grid);
  const Camera view = resized(scene.camera(), settings.size);
  const std::vector<Workers> all = steps(gpus);
  std::optional<HostList> list;
  if (settings.rays > 0) list.emplace(scene, settings.rays, settings.seed, cuda);
  output.device = devices_name(gpus);
  if (settings.devices.devices.empty()) output.why_no_gpu = why_no_gpu(settings.devices.backend);
  output.print(
      "{} views of {}, one of {}x{}, {} random rays;\nmedian of {} on {}\n\n{:<10} {:<7} {:>7} {:>9} {:>9} "
      "{:>8} {:>8}  {}\n",
      settings.views, settings.size, settings.large, settings.large, settings.rays, settings.repeat,
      output.device, "work", "scaling", cuda ? "GPUs" : "threads", "s", "Mray/s", "speed-up", "of ideal",
      "bound by");
  std::map<std::pair<std::string, std::string>, double> one; // the rate of one worker
  // Strong: the same work for any number of workers. Weak: a share for each; all workers' is the same work
  // again. measure(share of the whole work).
  const auto add = [&](const char* work, const Workers& workers, const auto& measure) {
    const double part = static_cast<double>(workers.count) / static_cast<double>(all.back().count);
    for (const auto& [scaling, share] : {std::pair("strong", 1.0), std::pair("weak", part)}) {
      const Run run = measure(share);
      const double one_rate = one.try_emplace({work, scaling}, run.rays / run.seconds).first->second;
      print_row(output, output.json.emplace_back(row_of(work, scaling, workers, run, one_rate)));
    }
  };
  for (const Workers& workers : all) {
    // On the CPU a worker is a thread.
    ThreadLimit fewer;
    if (!cuda) fewer = limit_threads(workers.count);
    const ResidentTracer tracer(scene, &grid, cuda ? Device::cuda : Device::cpu, workers.gpus);
    if (settings.views > 0)
      add("views", workers, [&](double share) {
        return rendered(settings, tracer, view, std::max(1, rounded(settings.views * share)));
      });
    if (settings.large > 0)
      add("large view", workers, [&](double share) {
        const int side = std::max(1, rounded(settings.large * std::sqrt(share)));
        return rendered(settings, tracer, resized(scene.camera(), fmt::format("{0}x{0}", side)), 1);
      });
    if (list)
      add("list", workers, [&](double share) {
        const auto count = static_cast<std::size_t>(std::llround(static_cast<double>(list->size()) * share));
        return traced(settings, tracer, *list, workers, std::max<std::size_t>(count, 1));
      });
  }
  if (!settings.charts.empty()) draw(settings, output.json);
}

void add_options(const CommandLine& command, Settings& settings) {
  settings.folder = std::filesystem::temp_directory_path().string();
  add_scene(command, settings.scene);
  add_grid(command, settings.grid);
  settings.devices.add_to(command);
  command.add_number("--views", settings.views, 0, 1000000, "number of views; 0: none");
  add_picture_size(command, settings.size, "pixels of a view");
  add_count(command, "--large", settings.large, "pixels of the large view's sides; 0: none", 16, 0);
  add_count(command, "--rays", settings.rays, "rays of the list, 40 bytes of memory each; 0: none", 32,
            std::size_t{0});
  command.add_option("--folder", settings.folder, "where pictures are written, and removed again")
      .type_name("FOLDER")
      .shows_default();
  command.add_option("--charts", settings.charts, "a folder that gets scale.csv, scale.svg and scale.png")
      .type_name("FOLDER");
  add_seed(command, settings.seed);
  add_repeat(command, settings.repeat);
}

} // namespace

void add_scale(const CommandLine& command) {
  add_command(command, "scale",
              "How views, one large view and a list of rays speed up with more GPUs, or threads of the CPU",
              "balls.scene balls.grid", add_options, bench_scale);
}

} // namespace masu
