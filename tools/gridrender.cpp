// gridrender: maps a scene and its grid, traces rays through them, writes the picture.
#include "libscene/file/output_file.h"
#include "libscene/stopwatch.h"
#include "renderer/image.h"
#include "tools/backend_choice.h"
#include "tools/repeated.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstring>
#include <optional>

namespace masu {
namespace {

struct Settings {
  std::string scene, grid, output, size, stats, times, rays, hits;
  Backend backend = Backend::automatic;
  TracingRules tracing;
  Sampling sampling = Sampling::corners;
  HitName hit_name = HitName::object;
  Store ray_store = Store::float32;
  int depth = 5, repeat = 1;
  bool spd_rules = false, hither = false, srgb = false, brute_force = false;
  Threads threads;
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

Json counts_json(const Counts& counts) {
  return {
      {"eye_rays", counts.camera_rays},
      {"eye_hits", counts.camera_hits},
      {"reflection_rays", counts.reflection_rays},
      {"refraction_rays", counts.refraction_rays},
      {"shadow_rays", counts.shadow_rays},
      {"shadow_hits", counts.shadow_hits},
      {"secondary_hits", counts.secondary_hits},
      {"intersection_tests",
       {{"triangle", counts.triangle_tests}, {"sphere", counts.sphere_tests}, {"cone", counts.cone_tests}}},
      {"cells_visited", counts.cells_visited},
      {"empty_cells_visited", counts.empty_cells_visited},
      {"voxels_skipped", counts.voxels_skipped}};
}

void write_json(const Json& json, const std::string& path) {
  const std::string text = json.dump(2) + "\n";
  OutputFile file(path);
  file.write(text.data(), text.size());
  file.commit();
}

void write_hits(const std::vector<HitRecord>& hits, const std::string& path) {
  OutputFile file(path);
  file.write(hits.data(), hits.size() * sizeof(HitRecord));
  file.commit();
}

// Refuses rays that aren't finite, have no direction, or are so far away that t would overflow. Number: float
// or double, as in the file.
template <class Number>
std::vector<ListedRay> read_rays(const std::string& path) {
  struct Stored {
    Vec3<Number> origin, direction;
  };
  const MappedFile file(path);
  const std::size_t count = file.bytes().size() / sizeof(Stored);
  if (file.bytes().size() != count * sizeof(Stored)) {
    throw Error(ErrorCode::input, path,
                fmt::format("holds {} bytes, not a whole number of rays: a ray is six {}-bit floats",
                            file.bytes().size(), 8 * sizeof(Number)));
  }
  std::vector<ListedRay> rays(count);
  constexpr double reach = 1e15;
  const auto is_within_reach = [&](const Vec3d& v) {
    return std::abs(v.x) <= reach && std::abs(v.y) <= reach && std::abs(v.z) <= reach;
  };
  for (std::size_t i = 0; i < count; ++i) {
    Stored stored{};
    std::memcpy(&stored, file.bytes().data() + i * sizeof(Stored), sizeof(Stored));
    rays[i] = {cast<double>(stored.origin), cast<double>(stored.direction)};
    const char* const wrong =
        !is_within_reach(rays[i].origin)                   ? "an origin that isn't within 1e15 of zero"
        : !is_within_reach(rays[i].direction)              ? "a direction that isn't finite, or beyond 1e15"
        : !(largest_magnitude(rays[i].direction) >= 1e-15) ? "a direction of no length (below 1e-15)"
                                                           : nullptr;
    if (wrong != nullptr) throw Error(ErrorCode::input, path, fmt::format("ray {} has {}", i, wrong));
  }
  return rays;
}

void check(const Settings& settings) {
  const auto fail = [](const char* option, const char* why) { throw Error(ErrorCode::usage, option, why); };
  if (settings.rays.empty() && settings.output.empty() && settings.hits.empty() && settings.stats.empty() &&
      settings.times.empty())
    fail("-o", "is missing: nothing would be written");
  if (!settings.rays.empty() && !settings.output.empty()) fail("--rays", "makes no picture: leave out -o");
  if (!settings.rays.empty() && settings.hits.empty() && settings.stats.empty() && settings.times.empty())
    fail("--rays", "needs --hits, --stats or --times, or nothing would be written");
  if (settings.grid.empty() && !settings.brute_force)
    fail("GRID", "is missing: name the grid file, or give --brute-force");
  if (!settings.output.empty()) static_cast<void>(image_format(settings.output));
  check_files({settings.scene, settings.grid, settings.rays},
              {settings.output, settings.hits, settings.stats, settings.times});
}

void render(const Settings& settings) {
  check(settings);
  const bool cuda = use_cuda(settings.backend);
  Seconds seconds;
  const Checks checks = cuda ? Checks::table : Checks::all; // the tracer checks records during the upload
  const SceneFile scene(settings.scene, checks);
  seconds.map += scene.load_seconds().map;
  seconds.validate += scene.load_seconds().validate;
  std::optional<GridFile> grid;
  if (!settings.brute_force) {
    grid.emplace(settings.grid, checks);
    seconds.map += grid->load_seconds().map;
    seconds.validate += grid->load_seconds().validate;
  }
  const Tracer tracer(scene, grid ? &*grid : nullptr, cuda ? Device::cuda : Device::cpu);
  TracingRules tracing = settings.tracing;
  tracing.count = !settings.stats.empty();
  Counts counts;
  const auto finish = [&](const auto& result, const auto& write) {
    counts = result.counts;
    seconds.trace = result.seconds;
    seconds.trace.upload += tracer.upload_seconds();
    const Stopwatch watch;
    write();
    if (!settings.hits.empty()) write_hits(result.hits, settings.hits);
    seconds.write = watch.seconds();
  };
  if (settings.rays.empty()) {
    const FrameRequest request{tracing,
                               resized(scene.camera(), settings.size),
                               settings.sampling,
                               settings.hither,
                               {settings.depth, settings.spd_rules, settings.hit_name},
                               !settings.hits.empty()};
    const Frame frame = repeated(0, settings.repeat, [&] { return tracer.render(request); });
    finish(frame, [&] {
      if (!settings.output.empty())
        write_image(frame, settings.output,
                    {image_format(settings.output), settings.sampling, settings.srgb});
    });
  } else {
    const std::vector<ListedRay> rays = settings.ray_store == Store::float64
                                            ? read_rays<double>(settings.rays)
                                            : read_rays<float>(settings.rays);
    const ResidentRays resident = tracer.upload(rays, tracing.precision);
    const RaysRequest request{tracing, settings.hit_name};
    RayHits hits = repeated(0, settings.repeat, [&] { return tracer.trace(resident, request); });
    hits.seconds.upload = resident.upload_seconds;
    finish(hits, [] {});
  }
  const Json head{{"backend", cuda ? "cuda" : "cpu"}}, times{{"seconds", seconds_json(seconds)}};
  const auto joined = [](Json json, const std::initializer_list<Json>& more) {
    for (const Json& part : more)
      json.update(part);
    return json;
  };
  if (!settings.stats.empty()) write_json(joined(head, {counts_json(counts), times}), settings.stats);
  if (!settings.times.empty()) write_json(joined(head, {times}), settings.times);
}

} // namespace
} // namespace masu

int main(int argc, char** argv) {
  using namespace masu;
  return run_tool(
      "gridrender", "Renders a scene through its grid, or traces a list of rays.", argc, argv,
      [](CLI::App& app, const auto& parse) {
        Settings settings;
        app.add_option("SCENE", settings.scene, "scene file, from nff2bin")->required();
        app.add_option("GRID", settings.grid, "grid file, from gridbuild");
        app.add_option("-o,--output", settings.output, "picture: .png, or .pfm for linear floats");
        add_backend(app, settings.backend);
        add_precision(app, settings.tracing.precision);
        add_first_cell_hit(app, settings.tracing.stop);
        app.add_option("--size", settings.size, "WxH pixels instead of the view's resolution");
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
        app.add_option("--rays", settings.rays,
                       "trace the rays of a file (6 floats each: origin, direction) instead of camera rays");
        add_choice(app, "--ray-store", settings.ray_store,
                   {{"float32", Store::float32}, {"float64", Store::float64}},
                   "number type in the file of --rays");
        app.add_option(
            "--hits", settings.hits,
            "write a record for each ray: float t (infinity for a miss), int32 object (-1 for a miss)");
        add_choice(
            app, "--hit-name", settings.hit_name,
            {{"object", HitName::object}, {"primitive", HitName::primitive}},
            "what --hits identifies: object (index in the NFF text) or primitive (index in the scene file)");
        settings.threads.add_to(app);
        parse();
        const auto limit = settings.threads.limit();
        render(settings);
      });
}
