// Seconds of whole pictures by screen division: how tiles of the picture are scheduled.
#include "tools/bench/command.h"
#include "tools/bench/screen_division/screen_division.h"
#include "tools/common/repeated.h"

#include <cstring>
#include <optional>
#include <utility>
#include <vector>

namespace masu {
namespace {

// None: the renderer's own.
const std::vector<std::pair<std::string, std::optional<ScreenDivision>>> all_schedules{
    {"hardware", {}},
    {"block", ScreenDivision::block},
    {"cyclic", ScreenDivision::cyclic},
    {"persistent", ScreenDivision::persistent}};

struct Settings {
  std::string scene, size = "1024x1024";
  std::vector<std::string> grids, schedules;
  Backend backend = Backend::automatic;
  TracingRules tracing;
  Sampling sampling = Sampling::centers;
  RenderRules rules{5, false, HitName::object};
  int workers_each = 0, warm_up = 5, repeat = 25;
};

Json measure(const Settings& settings, const ResidentTracer& tracer, const std::string& name,
             std::optional<ScreenDivision> division, HostArray<Vec3f>& picture) {
  const SceneFile& scene = tracer.scene();
  const StructureFile& grid = *tracer.structure();
  const bool cuda = tracer.device() == Device::cuda;
  const FrameRequest request{.tracing = settings.tracing,
                             .camera = resized(scene.camera(), settings.size),
                             .sampling = settings.sampling,
                             .rules = settings.rules};
  std::uint32_t workers = 0;
  Frame frame = repeated(settings.warm_up, settings.repeat, [&] {
    if (!division) return tracer.render(request);
    DividedFrame divided = cuda ? render_divided_cuda(scene, grid, request, *division, settings.workers_each)
                                : render_divided_cpu(scene, grid, request, *division, settings.workers_each);
    workers = divided.workers;
    return std::move(divided.frame);
  });
  if (picture.empty())
    picture = std::move(frame.radiance);
  else if (std::memcmp(picture.data(), frame.radiance.data(), picture.size() * sizeof(Vec3f)) != 0)
    throw Error(ErrorCode::device, name,
                "the picture differs from the previous schedule's: please report this bug");
  return {{"grid", grid.path()},
          {"schedule", name},
          {"workers", workers},
          {"rays", {frame.columns, frame.rows}},
          {"backend", cuda ? "cuda" : "cpu"},
          {"precision", name_of(resolved(settings.tracing.precision, scene))},
          {"general", settings.tracing.general},
          {"repeat", settings.repeat},
          {"median_seconds", frame.seconds.trace},
          {"kernel", {{"registers", frame.kernel.registers}, {"local_bytes", frame.kernel.local_bytes}}}};
}

void bench_frame(const Settings& settings, Output& output) {
  const bool cuda = output.on_cuda(settings.backend);
  const SceneFile scene(settings.scene);
  // The renderer's own schedule renders in every way; the others by `robust` alone, through cells.
  const bool is_robust = resolved(settings.tracing.precision, scene) == Precision::robust &&
                         settings.tracing.stop == StopRule::proven;
  const std::vector<std::string>& names = settings.schedules; // empty: all that can be
  if (!is_robust && !names.empty() && names != std::vector<std::string>{"hardware"})
    throw Error(ErrorCode::usage, "--schedule",
                "block, cyclic and persistent render by --precision robust alone: name hardware");
  output.print("{}, median of {} after {}\n\n{:<24} {:<10} {:>8} {:>10}\n", cuda ? "cuda" : "cpu",
               settings.repeat, settings.warm_up, "grid", "schedule", "workers", "ms");
  HostArray<Vec3f> picture;
  for (const std::string& path : settings.grids) {
    const StructureFile grid(path);
    const ResidentTracer tracer(scene, &grid, cuda ? Device::cuda : Device::cpu);
    for (const auto& [name, division] : all_schedules) {
      const bool can_render = !division || (is_robust && !grid.is_hierarchy());
      if (names.empty() ? !can_render : !contains(names, name)) continue;
      if (!can_render)
        throw Error(ErrorCode::usage, "--schedule",
                    "block, cyclic and persistent need a grid of cells: a hierarchy has none: name hardware");
      const Json& row = output.json.emplace_back(measure(settings, tracer, name, division, picture));
      output.print("{:<24} {:<10} {:>8} {:>10.3f}\n", printable(path), name,
                   row["workers"].get<std::uint64_t>(), row["median_seconds"].get<double>() * 1e3);
    }
  }
}

void add_options(const CommandLine& command, Settings& settings) {
  add_scene(command, settings.scene);
  add_grids(command, settings.grids);
  add_names(command, "--schedule", settings.schedules, {"hardware", "block", "cyclic", "persistent"},
            "how tiles of 8x8 rays are assigned: hardware (a thread block per tile), block (consecutive "
            "tiles to each worker), cyclic (every W-th tile to each of W workers), persistent (workers "
            "take the next tile from a counter); default: all");
  command.add_number("--workers", settings.workers_each, 0, 64,
                     "workers per multiprocessor (or per CPU thread); 0: as many as are resident at once");
  add_backend(command, settings.backend);
  add_precision(command, settings.tracing.precision);
  add_first_cell_hit(command, settings.tracing.stop);
  add_general(command, settings.tracing);
  add_picture_size(command, settings.size, "size of the picture");
  command.add_choice("--sampling", settings.sampling,
                     {{"corners", Sampling::corners}, {"centers", Sampling::centers}},
                     "rays through pixel corners or centers");
  command.add_number("--depth", settings.rules.depth, 1, largest_depth,
                     "largest depth of rays; camera rays have depth 1");
  add_warm_up(command, settings.warm_up);
  add_repeat(command, settings.repeat);
}

} // namespace

void add_frame(const CommandLine& command) {
  add_command(command, "frame", "Whole pictures, by screen division: how tiles are scheduled",
              "balls.scene balls.grid --repeat 5", add_options, bench_frame);
}

} // namespace masu
