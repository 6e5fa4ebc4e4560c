// Closest hits of random rays in a scene by each precision, compared with the oracle's brute force.
#include "stability/ray_sets.h"
#include "stability/run.h"
#include "tools/bench/command.h"
#include "tools/common/progress.h"

#include <algorithm>

namespace masu {
namespace {

using namespace stability;

struct Settings {
  std::string scene, grid;
  std::vector<std::string> precisions;
  std::size_t count = 100'000;
  std::uint64_t seed = 1;
  bool first_cell_hit = false;
};

std::vector<Mode> modes_for(const Settings& settings, const SceneFile& scene) {
  std::vector<Mode> modes;
  for (const Mode& mode : {fast, robust, doubled}) {
    if (!contains(settings.precisions, mode.name)) continue;
    resolved(mode.precision, scene); // throws where the scene doesn't allow it
    modes.push_back(mode);
    if (settings.first_cell_hit) modes.back().stop = StopRule::first_cell;
  }
  return modes;
}

constexpr std::size_t rays_a_batch = 1 << 17; // bounds the memory

std::vector<Tally> judge_all(const Settings& settings, const SceneFile& scene, const StructureFile& grid,
                             const std::vector<Mode>& modes) {
  const oracle::SceneOracle oracle =
      scene.with_view([](const auto& view) { return oracle::SceneOracle(view); });
  const std::vector<Ray<double>> rays = random_rays(scene, settings.count, settings.seed);
  std::vector<Tally> tallies(modes.size());
  Progress progress("comparing");
  for (std::size_t begin = 0; begin < rays.size(); begin += rays_a_batch) {
    progress(static_cast<double>(begin) / static_cast<double>(rays.size()));
    const auto batch = std::span(rays).subspan(begin, std::min(rays_a_batch, rays.size() - begin));
    // All float32 modes, which come first, are compared with the same reference hits.
    for (std::size_t i = 0; i < modes.size();) {
      const Precision precision = modes[i].precision;
      std::vector<std::vector<Found>> found;
      for (std::size_t k = i; k < modes.size() && (k == i || modes[k].precision != Precision::doubled); ++k)
        found.push_back(found_through(scene, grid, batch, modes[k]));
      for (const Tally& part :
           judged(oracle, batch, slack_for(precision, scene.bounds()), unit_roundoff_of(precision), found))
        tallies[i++] += part;
    }
  }
  return tallies;
}

void bench_oracle(const Settings& settings, Output& output) {
  const SceneFile scene(settings.scene);
  const StructureFile grid(settings.grid);
  grid.check_geometry(scene.geometry_hash(), scene.primitive_count());
  if (settings.first_cell_hit && grid.is_hierarchy())
    throw Error(ErrorCode::usage, "--first-cell-hit", "needs a grid of cells: a hierarchy has none");
  const std::vector<Mode> modes = modes_for(settings, scene);
  const std::vector<Tally> tallies = judge_all(settings, scene, grid, modes);
  output.device = device_name(false);
  output.print("{:<8} {:>10} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9}\n", "prec.", "rays", "unsure", "missed",
               "false", "wrong", "misplaced", "t error");
  for (std::size_t i = 0; i < modes.size(); ++i) {
    const Tally& t = tallies[i];
    output.print("{:<8} {:>10} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9.1e}\n", modes[i].name, t.rays, t.unsure,
                 t.missed, t.false_hit, t.wrong, t.misplaced, t.worst_t);
    output.json.push_back({{"precision", modes[i].name},
                           {"first_cell_hit", settings.first_cell_hit},
                           {"rays", t.rays},
                           {"unsure", t.unsure},
                           {"missed", t.missed},
                           {"false", t.false_hit},
                           {"wrong", t.wrong},
                           {"misplaced", t.misplaced},
                           {"worst_t_error", t.worst_t}});
  }
}

void add_options(const CommandLine& command, Settings& settings) {
  add_scene(command, settings.scene);
  add_grid(command, settings.grid);
  add_count(command, "--count", settings.count, "number of random rays", 28);
  add_seed(command, settings.seed);
  add_names(command, "--precision", settings.precisions, {"fast", "robust", "double"},
            "precisions: fast, robust, double");
  command.add_flag("--first-cell-hit", settings.first_cell_hit,
                   "terminate at the first cell in which anything is hit (see gridrender --help)");
}

} // namespace

void add_oracle(const CommandLine& command) {
  add_command(command, "oracle",
              "Closest hits of random rays, compared with brute force in 113-bit arithmetic",
              "balls.scene balls.grid --count 100000", add_options, bench_oracle);
}

} // namespace masu
