// gridrender: reads a scene and its grid, traces rays through them, writes the picture.
#include "libscene/base/stopwatch.h"
#include "libscene/file/output_file.h"
#include "renderer/image/image.h"
#include "tools/common/device_choice.h"
#include "tools/common/printable.h"
#include "tools/common/progress.h"
#include "tools/common/provenance.h"
#include "tools/common/repeated.h"
#include "tools/jobs/ranks.h"
#include "tools/lists/ray_list.h"
#include "tools/render/inspection.h"
#include "tools/render/render_views.h"
#include "tools/render/views.h"
#include "tools/report/counts_report.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <set>
#include <unordered_set>

namespace masu {
namespace {

enum class Format { automatic, png, pfm };

struct Settings {
  std::string scene, grid, output, size, stats, times, rays, hits, write, from, at, up, views, crop;
  std::optional<double> angle;
  int turntable = 0; // views; 0: none
  Format format = Format::automatic;
  DeviceChoice devices;
  TracingRules tracing;
  Sampling sampling = Sampling::corners;
  HitName hit_name = HitName::object;
  Store ray_store = Store::automatic;
  bool relative = false; // rays, to the scene's origin
  int depth = 5, repeat = 1, ray_numbers = 6;
  bool any_hit = false, spd_rules = false, hither = false, srgb = false, brute_force = false, quiet = false;
  Inspection inspection;
  Threads threads;
  bool resume = false;
};

struct Seconds {
  double map = 0, validate = 0, write = 0;
  TraceSeconds trace;
};

using Json = nlohmann::ordered_json;

Json seconds_json(const Seconds& seconds) {
  return {
      {"map", seconds.map},           {"validate", seconds.validate},       {"upload", seconds.trace.upload},
      {"trace", seconds.trace.trace}, {"download", seconds.trace.download}, {"write", seconds.write}};
}

void write_json(const Json& json, const std::string& path) {
  const std::string text = json_text(json) + "\n";
  OutputFile file(path);
  file.write(text.data(), text.size());
  file.commit();
}

// Of the picture, by --format or else by the name's end; PNG on standard output. Throws Error(usage).
ImageFormat format_of(const Settings& settings) {
  if (settings.format == Format::pfm) return ImageFormat::pfm;
  if (settings.format == Format::png || is_standard_output(settings.output)) return ImageFormat::png;
  return image_format(settings.output);
}

bool changes_camera(const Settings& settings) {
  return !settings.from.empty() || !settings.at.empty() || !settings.up.empty() || settings.angle;
}

// What --hits gets without --write.
std::string usual_fields(const Settings& settings) {
  if (settings.any_hit) return "occluded";
  return settings.hit_name == HitName::primitive ? "t,primitive"
         : settings.hit_name == HitName::face    ? "t,face"
                                                 : "t,object";
}

// Of the file of --rays, where that is numbers alone.
RayFormat ray_format(const Settings& settings) {
  const bool is_float64 = settings.ray_store == Store::automatic ? settings.rays.ends_with(".f64")
                                                                 : settings.ray_store == Store::float64;
  return {is_float64, settings.ray_numbers, settings.relative};
}

// The files beside outputs while several processes or runs make them; the first one names the journals.
// Throws Error(usage) for an output that can't have any.
std::vector<std::string> files_beside(const std::vector<std::string>& outputs, const Sharing& sharing) {
  std::vector<std::string> files;
  for (const std::string& output : outputs) {
    if (output.empty() || !sharing.in_parts()) continue;
    if (files.empty()) files.push_back(journal_name(output, sharing.ranks.rank()));
    files.push_back(partial_name(output));
  }
  return files;
}

std::vector<std::string> joined(std::vector<std::string> first, const std::vector<std::string>& more) {
  first.insert(first.end(), more.begin(), more.end());
  return first;
}

void check(const Settings& settings, const Sharing& sharing) {
  const auto fail = [](const char* option, const char* why) { throw Error(ErrorCode::usage, option, why); };
  settings.inspection.check(settings.output);
  if (settings.scene.empty()) fail("command line", "SCENE is required: see gridrender --help");
  if (settings.rays.empty() && settings.output.empty() && settings.hits.empty() && settings.stats.empty() &&
      settings.times.empty() && !settings.inspection.has_walk())
    fail("-o", "is missing: nothing would be written");
  if (!settings.rays.empty() && !settings.output.empty()) fail("--rays", "makes no picture: leave out -o");
  if (!settings.rays.empty() && (changes_camera(settings) || !settings.size.empty() ||
                                 !settings.crop.empty() || !settings.views.empty() || settings.turntable > 0))
    fail("--rays", "traces no camera rays: leave out the options of views");
  if (!settings.rays.empty() && settings.hits.empty() && settings.stats.empty() && settings.times.empty())
    fail("--rays", "needs --hits, --stats or --times, or nothing would be written");
  if (!settings.rays.empty() && settings.inspection.has_walk())
    fail("--rays", "has many rays: give one to --walk-ray");
  if (settings.inspection.has_walk() && (!settings.views.empty() || settings.turntable > 0))
    fail("--walk", "is of one view: leave out --views and --turntable");
  if (settings.rays.empty() && (!settings.write.empty() || settings.any_hit))
    fail(settings.write.empty() ? "--any-hit" : "--write", "is for a list of rays: give --rays");
  if (settings.any_hit && !settings.write.empty() && settings.write != "occluded")
    fail("--write", "can only be occluded with --any-hit");
  if (!settings.any_hit && settings.write == "occluded") fail("--write", "occluded needs --any-hit");
  if (settings.grid.empty() && !settings.brute_force)
    fail("GRID", "is missing: name the grid file, or give --brute-force");
  if (settings.resume && (settings.output.empty() || settings.inspection.no_picture) && settings.hits.empty())
    fail("--resume", "needs a picture or --hits: nothing else is kept");
  if (settings.hits.ends_with(".f64"))
    fail("--hits", "has no numbers of 64 bits: let the name end in .npy or .csv, or give it no ending");
  if (!settings.output.empty()) static_cast<void>(format_of(settings));
  if (sharing.in_parts() && settings.rays == "-") fail("--rays", "must name a file, for ranks and --resume");
  if (sharing.ranks.count() > 1 && settings.views == "-")
    fail("--views", "must name a file, for several ranks");
  const std::vector<std::string> beside =
      settings.rays.empty() ? std::vector<std::string>() : files_beside({settings.hits}, sharing);
  check_files(
      {settings.scene, settings.grid, settings.rays, settings.views},
      joined({settings.output, settings.hits, settings.stats, settings.times, settings.inspection.json},
             beside));
}

// --- Views ------------------------------------------------------------------------------------------------

// Throws Error(usage, option, …) for a camera that can't see, Error(input) for a list with such a one.
std::vector<View> views_of(const Settings& settings, const SceneFile& scene) {
  const Boxd places = camera_places(scene);
  const auto vector = [](const char* option, const std::string& text) {
    return text.empty() ? std::optional<Vec3d>() : parse_vector(option, text);
  };
  const Camera camera = changed(resized(scene.camera(), settings.size), {vector("--from", settings.from),
                                                                         vector("--at", settings.at),
                                                                         vector("--up", settings.up),
                                                                         settings.angle,
                                                                         {}});
  // The lines of a list may give what is missing yet.
  if (!settings.views.empty()) return read_views(settings.views, camera, places);
  if (changes_camera(settings)) {
    if (const auto fault = fault_of(camera, places))
      throw Error(ErrorCode::usage, std::string("--") + fault->part, fault->what);
  }
  return settings.turntable > 0 ? turntable(camera, settings.turntable) : std::vector<View>{{"0", camera}};
}

std::vector<ViewFiles> files_of(const Settings& settings, const std::vector<View>& views,
                                const Sharing& sharing) {
  const auto pictures = file_names(settings.output, views), hits = file_names(settings.hits, views);
  settings.inspection.check_channel_files(
      pictures, {settings.scene, settings.grid, settings.views},
      {settings.hits, settings.stats, settings.times, settings.inspection.json});
  std::vector<ViewFiles> files;
  std::unordered_set<std::string> names; // of all views, with those beside them
  for (std::size_t i = 0; i < views.size(); ++i) {
    files.push_back({settings.inspection.no_picture ? "" : pictures[i], hits[i]});
    const std::vector<std::string> beside = files_beside({files[i].picture, files[i].hits}, sharing);
    check_files({settings.scene, settings.grid, settings.views},
                joined({pictures[i], hits[i], settings.stats, settings.times}, beside));
    if (beside.empty()) continue;
    for (const std::string& name : joined({files[i].picture, files[i].hits}, beside)) {
      if (!name.empty() && !names.insert(name).second)
        throw Error(ErrorCode::usage, name, "would be written for two views: give them other names");
    }
  }
  return files;
}

// What a picture's bytes depend on besides its view. Neither the grid nor the device is among it.
PngTexts picture_texts(const Settings& settings, const SceneFile& scene) {
  std::string options =
      fmt::format("--precision {} --sampling {} --depth {}", name_of(settings.tracing.precision),
                  settings.sampling == Sampling::corners ? "corners" : "centers", settings.depth);
  if (settings.tracing.stop == StopRule::first_cell) options += " --first-cell-hit";
  if (settings.spd_rules) options += " --spd-rules";
  if (settings.hither) options += " --hither";
  if (settings.srgb) options += " --srgb";
  return {{"Software", program_name()}, {"Source", "scene " + to_hex(scene.hash())}, {"Options", options}};
}

ViewsRequest views_request(const Settings& settings, const TracingRules& tracing, const SceneFile& scene,
                           const Sharing& sharing) {
  ViewsRequest request;
  request.frame.tracing = tracing;
  request.frame.sampling = settings.sampling;
  request.frame.hither = settings.hither;
  request.frame.rules = {settings.depth, settings.spd_rules, settings.hit_name};
  request.frame.hits = !settings.hits.empty();
  request.views = views_of(settings, scene);
  request.files = files_of(settings, request.views, sharing);
  request.hit_fields = record_fields(hit_fields(usual_fields(settings)));
  if (!settings.crop.empty()) {
    const Crop crop = parse_crop("--crop", settings.crop);
    for (const View& view : request.views)
      request.frame.window = window_of(crop, view.camera, settings.sampling, "--crop");
  }
  if (!settings.output.empty())
    request.image = {format_of(settings), settings.sampling, settings.srgb, picture_texts(settings, scene)};
  request.repeat = settings.repeat;
  return request;
}

// --- The tool's run ---------------------------------------------------------------------------------------

// What files depend on besides cameras and rays.
std::string run_description(const Tracer& tracer, const Settings& settings, const TracingRules& tracing) {
  std::string text = program_name();
  for (const auto& [keyword, value] : picture_texts(settings, tracer.scene()))
    text += "\n" + value;
  return text +
         fmt::format("\n{} counts {} names {} format {} write {} any hit {} rays {} {}",
                     tracer.device() == Device::cuda ? "cuda" : "cpu", tracing.count,
                     static_cast<int>(settings.hit_name), static_cast<int>(settings.format), settings.write,
                     settings.any_hit, settings.ray_numbers, static_cast<int>(settings.ray_store)) +
         (settings.relative ? " relative" : "");
}

struct Outcome {
  std::uint64_t views = 0;
  TracingReport report;
  double rays_seconds = 0;  // in which the rays were traced,
  const char* besides = ""; // and what else was done in them
};

Outcome render_pictures(const Tracer& tracer, const ViewsRequest& request, const Sharing& sharing,
                        bool quiet) {
  Progress progress("rendering", quiet);
  const TracingReport report = render_views(tracer, request, sharing, progress.callback());
  const bool overlap = report.tasks > 1 || sharing.in_parts();
  return {request.views.size(), report, overlap ? report.elapsed_seconds : report.seconds.trace,
          overlap ? " with writing" : ""};
}

Outcome trace_list(const Tracer& tracer, const TracingRules& tracing, const Settings& settings,
                   const Sharing& sharing, bool quiet) {
  RayListJob job{settings.rays, settings.hits, ray_format(settings)};
  job.fields = hit_fields(settings.write.empty() ? usual_fields(settings) : settings.write);
  job.request.tracing = tracing;
  job.request.query = settings.any_hit ? Query::occlusion : Query::nearest_hit;
  job.repeat = settings.repeat;
  job.description = run_description(tracer, settings, tracing);
  Progress progress("tracing", quiet);
  const TracingReport report = trace_ray_list(tracer, job, sharing, progress.callback());
  const TaskTotals& totals = report.totals;
  if (totals.invalid > 0 && sharing.ranks.rank() == 0)
    print_note("gridrender: {}: {} of {} rays aren't valid and hit nothing: NaN, infinite or beyond 1e15, or "
               "a direction below 1e-15\n",
               printable(settings.rays), totals.invalid, totals.rays);
  return {0, report, report.elapsed_seconds, " with reading and writing"};
}

// The channels' rays, besides those of a picture.
Outcome render_channels(const Tracer& tracer, const Settings& settings, const ViewsRequest& views) {
  Progress progress("tracing channels", settings.quiet);
  const ChannelsSummary summary =
      write_channels(tracer,
                     {settings.inspection.channels_request(views.frame), views.views,
                      file_names(settings.output, views.views), settings.inspection.channel_format,
                      picture_texts(settings, tracer.scene())},
                     progress.callback());
  Outcome outcome;
  outcome.views = views.views.size();
  outcome.report.totals.rays = summary.rays;
  outcome.rays_seconds = summary.seconds;
  outcome.besides = " with writing";
  return outcome;
}

// Whether anything but channels and a walk is to be traced.
bool wants_picture(const Settings& settings) {
  return (!settings.output.empty() && !settings.inspection.no_picture) || !settings.hits.empty() ||
         !settings.stats.empty() || !settings.times.empty();
}

// What Precision::automatic came to.
std::string precision_text(const Outcome& outcome) {
  const std::optional<ViewPrecision>& chosen = outcome.report.precision;
  if (!chosen) return "";
  const std::uint64_t doubled = outcome.report.double_views;
  return doubled == 0 || doubled == outcome.views
             ? ", " + description_of(*chosen)
             : fmt::format(", {} of the views in {}", doubled, description_of(*chosen));
}

void print_summary(const Outcome& outcome, const std::string& device) {
  const double seconds = outcome.rays_seconds;
  const std::uint64_t rays = outcome.report.totals.rays;
  print_note("gridrender: traced {}{} rays in {:.3g} s{}, {:.3g} million a second, on {}{}\n",
             outcome.views > 1 ? fmt::format("{} views, ", outcome.views) : "", rays, seconds,
             outcome.besides, seconds > 0 ? static_cast<double>(rays) / seconds * 1e-6 : 0, device,
             precision_text(outcome));
}

Json precision_json(const Outcome& outcome, Precision wanted) {
  const std::optional<ViewPrecision>& chosen = outcome.report.precision;
  if (!chosen) return {{"precision", name_of(wanted)}};
  const std::uint64_t doubled = outcome.report.double_views;
  return {{"precision", doubled == 0               ? "robust"
                        : doubled == outcome.views ? "double"
                                                   : "robust and double"},
          {"double_views", doubled},
          {"precision_reason", description_of(*chosen)}};
}

void render(const Settings& settings, Ranks& ranks) {
  const Sharing sharing{ranks, settings.resume};
  if (!settings.inspection.difference.empty()) {
    if (ranks.rank() == 0) print_difference(settings.inspection, settings.output);
    return;
  }
  check(settings, sharing);
  const bool quiet = settings.quiet || ranks.rank() > 0;
  const bool only_walk = !wants_picture(settings) && settings.inspection.channels.empty(); // on the CPU
  const std::vector<int> gpus =
      only_walk ? std::vector<int>() : settings.devices.gpus("gridrender", ranks, quiet);
  const bool cuda = !gpus.empty();
  Seconds seconds;
  // A walk is on the CPU, besides what a GPU traces.
  const Residence residence = !cuda                            ? Residence::mapping
                              : settings.inspection.has_walk() ? Residence::memory
                                                               : Residence::file;
  const MappingFaults faults("gridrender");
  const SceneFile scene(settings.scene, residence);
  seconds.map += scene.load_seconds().map;
  seconds.validate += scene.load_seconds().validate;
  TracingRules tracing = settings.tracing;
  tracing.count = !settings.stats.empty();
  ViewsRequest views =
      settings.rays.empty() ? views_request(settings, tracing, scene, sharing) : ViewsRequest{};
  std::optional<GridFile> grid;
  if (!settings.brute_force) {
    grid.emplace(settings.grid, residence);
    seconds.map += grid->load_seconds().map;
    seconds.validate += grid->load_seconds().validate;
  }
  const Tracer tracer(scene, grid ? &*grid : nullptr, cuda ? Device::cuda : Device::cpu, gpus);
  if (settings.rays.empty()) views.description = run_description(tracer, settings, tracing);
  if (settings.inspection.has_walk() && ranks.rank() == 0) {
    FrameRequest frame = views.frame;
    frame.camera = views.views.front().camera;
    print_walk(settings.inspection, tracer, frame);
  }
  if (only_walk) return;
  Outcome outcome;
  if (!settings.rays.empty())
    outcome = trace_list(tracer, tracing, settings, sharing, quiet);
  else if (wants_picture(settings))
    outcome = render_pictures(tracer, views, sharing, quiet);
  if (ranks.rank() > 0) return;
  if (!settings.inspection.channels.empty()) {
    const Outcome channels = render_channels(tracer, settings, views);
    if (!wants_picture(settings)) outcome = channels;
  }
  seconds.trace = outcome.report.seconds;
  seconds.trace.upload += tracer.upload_seconds();
  seconds.write = outcome.report.write_seconds;
  const std::string device =
      devices_name(gpus) + (ranks.count() > 1 ? fmt::format(", {} ranks", ranks.count()) : "");
  Json head = provenance();
  head.update({{"backend", cuda ? "cuda" : "cpu"},
               {"device", device},
               {"scene_hash", to_hex(scene.hash())},
               {"grid_hash", grid ? Json(to_hex(grid->hash())) : Json()},
               {"views", outcome.views}});
  head.update(precision_json(outcome, resolved(tracing.precision, scene)));
  const Json times{{"seconds", seconds_json(seconds)}};
  const auto merged = [](Json json, const std::initializer_list<Json>& more) {
    for (const Json& part : more)
      json.update(part);
    return json;
  };
  if (!settings.stats.empty())
    write_json(merged(head, {counts_report(outcome.report.totals.counts), times}), settings.stats);
  if (!settings.times.empty()) write_json(merged(head, {times}), settings.times);
  if (!quiet) print_summary(outcome, device);
}

} // namespace
} // namespace masu

int main(int argc, char** argv) {
  using namespace masu;
  prepare_process();
  std::optional<Ranks> started; // when the command line is whole: --help and --version need no MPI
  const auto ranks = [&]() -> Ranks& { return started ? *started : started.emplace(&argc, &argv); };
  const int code = run_tool(
      "gridrender", "Renders a scene through its grid, or traces a list of rays.", argc, argv,
      [&](CLI::App& app, const auto& parse) {
        Settings settings;
        app.add_option("SCENE", settings.scene, "scene file, from nff2bin; left out with --difference");
        app.add_option("GRID", settings.grid, "grid file, from gridbuild");
        app.add_option(
            "-o,--output", settings.output,
            "picture: .png, or .pfm for linear floats; - is standard output; of several views with "
            "{index} or {name} in it");
        add_choice(app, "--format", settings.format,
                   {{"auto", Format::automatic}, {"png", Format::png}, {"pfm", Format::pfm}},
                   "the picture's format; auto: by the name's end, PNG on standard output");
        settings.devices.add_to(app);
        add_precision(app, settings.tracing.precision);
        add_first_cell_hit(app, settings.tracing.stop);
        app.add_option("--size", settings.size, "WxH pixels instead of the view's resolution");
        app.add_option("--from", settings.from, "X,Y,Z: where the camera is, instead of the scene's");
        app.add_option("--at", settings.at, "X,Y,Z: the point in the middle of the picture");
        app.add_option("--up", settings.up, "X,Y,Z: the direction that is up in the picture");
        app.add_option("--angle", settings.angle, "degrees that the picture's height spans");
        auto* const views = app.add_option(
            "--views", settings.views,
            "render the views of a list, a JSON object a line: name, from, at, up, angle, size; "
            "- is standard input");
        app.add_option("--turntable", settings.turntable, "render N views around the point looked at")
            ->check(CLI::Range(1, 1000000))
            ->excludes(views);
        app.add_option("--crop", settings.crop, "X,Y,W,H: render only these pixels of the picture");
        app.add_option("--depth", settings.depth, "largest depth of rays; camera rays have depth 1")
            ->check(CLI::Range(1, largest_depth))
            ->capture_default_str();
        add_choice(app, "--sampling", settings.sampling,
                   {{"corners", Sampling::corners}, {"centers", Sampling::centers}},
                   "rays through pixel corners, four averaged (corners), or through pixel centers");
        app.add_flag("--spd-rules", settings.spd_rules,
                     "spawn the secondary rays that the SPD counts, even those of weight zero");
        app.add_flag("--hither", settings.hither, "ignore hits in front of the view's hither plane");
        app.add_flag("--srgb", settings.srgb,
                     "encode PNG values as sRGB; without it they are stored as they are");
        app.add_flag("--brute-force", settings.brute_force,
                     "test every ray against every primitive, without a grid");
        auto* const stats = app.add_option(
            "--stats", settings.stats, "write ray counts and seconds as JSON; counting slows tracing down");
        app.add_option("--times", settings.times, "write seconds as JSON, without counting")->excludes(stats);
        app.add_option("--repeat", settings.repeat, "trace N times and report the median's seconds")
            ->check(CLI::Range(1, 10000))
            ->excludes(stats);
        app.add_option(
            "--rays", settings.rays,
            "trace the rays of a file instead of camera rays: numbers; .npy, a NumPy array of shape "
            "(N, 6) or (N, 8); .csv, text whose first line is ox,oy,oz,dx,dy,dz, with tmin and tmax "
            "among them or not; - is standard input");
        app.add_option("--ray-numbers", settings.ray_numbers,
                       "numbers a ray in the file of --rays: 6 (origin, direction) or 8 (origin, tmin, "
                       "direction, tmax)")
            ->check(CLI::IsMember(std::set<int>{6, 8}))
            ->capture_default_str();
        app.add_flag("--relative", settings.relative,
                     "the rays of --rays are relative to the scene's local origin, and not in the world");
        add_choice(app, "--ray-store", settings.ray_store,
                   {{"auto", Store::automatic}, {"float32", Store::float32}, {"float64", Store::float64}},
                   "type of the numbers in the file of --rays; auto: float64 where its name ends in .f64");
        app.add_flag("--any-hit", settings.any_hit,
                     "find out for each ray of --rays whether anything is hit at tmin < t < tmax");
        app.add_option("--write", settings.write,
                       "what --hits gets for each ray of --rays: a list of t, object, primitive, face, uv, "
                       "normal (default t,object), or occluded, with --any-hit");
        app.add_option("--hits", settings.hits,
                       "write a record for each ray: float t (infinity for a miss), int32 object (-1 for a "
                       "miss), or what --write says; .npy: a NumPy array; .csv: text; - is standard output");
        add_choice(
            app, "--hit-name", settings.hit_name,
            {{"object", HitName::object}, {"primitive", HitName::primitive}, {"face", HitName::face}},
            "what --hits identifies: object (index in the NFF text, or of mesh2bin's objects), primitive "
            "(index in the scene file) or face (number in the mesh's file)");
        settings.inspection.add_to(app);
        app.add_flag("-q,--quiet", settings.quiet, "no progress and no summary on standard error");
        settings.threads.add_to(app);
        app.add_flag("--resume", settings.resume,
                     "go on where a run with --resume was interrupted: what it finished isn't done again");
        parse();
        const auto limit = settings.threads.limit(cores_of(ranks()));
        render(settings, ranks());
      },
      {[] { return Ranks::launched_as().value_or(0) == 0; },
       [&] { return (!started && !Ranks::launched_as()) || ranks().is_first_to_fail(); }});
  return started ? started->ended(code) : code;
}
