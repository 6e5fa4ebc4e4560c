// gridbuild: divides a scene's space into voxels and writes which primitives each one holds.
#include "libgrid/choose.h"
#include "libgrid/grid_file.h"
#include "libgrid/statistics.h"
#include "libscene/scene_file.h"
#include "libscene/stopwatch.h"
#include "tools/cli.h"

#include <fstream>

namespace masu {
namespace {

enum class MergeChoice { automatic, none, x, balance, irregular };

struct Settings {
  std::string scene, output, division = "auto";
  MergeChoice merge_choice = MergeChoice::automatic;
  MergeRule merge;
  SpaceRule space = SpaceRule::tight;
  Overlap overlap = Overlap::exact;
  bool record_seconds = false, json = false;
  Threads threads;
};

// What the machine can still give, in bytes; infinity where it doesn't tell.
double available_memory() {
  std::ifstream file("/proc/meminfo");
  for (std::string key, rest; file >> key && std::getline(file, rest);) {
    if (key == "MemAvailable:") return std::stod(rest) * 1024;
  }
  return HUGE_VAL;
}

void check_memory(const Lattice& lattice, double references) {
  const double needed = expected_build_bytes(lattice, references), available = available_memory();
  if (needed <= available) return;
  const Vec3i n = lattice.division;
  throw Error(
      ErrorCode::usage, "--division",
      fmt::format("{}x{}x{} voxels need about {:.1f} GB to build, {:.1f} GB are free: choose a coarser one",
                  n.x, n.y, n.z, needed / 1e9, available / 1e9));
}

// As the file tells it.
std::string merge_text(Merge merge, const MergeRule& rule) {
  switch (merge) {
  case Merge::none:
    return "";
  case Merge::x:
    return "x";
  case Merge::balance:
    return fmt::format("balance target {}", rule.target);
  case Merge::irregular:
    return fmt::format("irregular nested {} detail {} step {} alpha {} stretch {}", rule.nested_log2,
                       rule.detail, rule.step_over_test, rule.alpha, rule.stretches);
  }
  return "";
}

// A division that is to be divided further starts out coarser, where it is ours to choose.
DivisionRule nested_rule(DivisionRule rule) {
  if (rule.kind == DivisionRule::Kind::automatic) rule.kind = DivisionRule::Kind::nested;
  return rule;
}

template <class Stored>
Grid build_as_asked(const Settings& settings, const SceneView<Stored>& scene, const Boxd& bounds,
                    const DivisionRule& rule) {
  const DivisionStatistics statistics = division_statistics(scene);
  const auto lattice_by = [&](const DivisionRule& by) {
    const Lattice lattice = make_lattice<Stored>(bounds, settings.space, by, statistics);
    check_memory(lattice, expected_references(statistics.all, lattice));
    return lattice;
  };
  MergeRule merge = settings.merge;
  switch (settings.merge_choice) {
  case MergeChoice::automatic:
    // Who says how many voxels there are to be means those, not ones to divide further.
    if (rule.kind != DivisionRule::Kind::automatic)
      return build_uniform(scene, lattice_by(rule), settings.overlap);
    return build_chosen(scene, lattice_by(rule), lattice_by(nested_rule(rule)), settings.overlap, merge);
  case MergeChoice::none:
    return build_uniform(scene, lattice_by(rule), settings.overlap);
  case MergeChoice::x:
    merge.merge = Merge::x;
    return build_merged(scene, lattice_by(rule), settings.overlap, merge);
  case MergeChoice::balance:
    merge.merge = Merge::balance;
    return build_merged(scene, lattice_by(rule), settings.overlap, merge);
  case MergeChoice::irregular:
    merge.merge = Merge::irregular;
    return build_merged(scene, lattice_by(nested_rule(rule)), settings.overlap, merge);
  }
  return {};
}

template <class Stored>
void build(const Settings& settings, const SceneFile& file) {
  const SceneView<Stored> scene = file.view<Stored>();
  const Stopwatch watch;
  const DivisionRule rule = parse_division(settings.division);
  const Grid grid = build_as_asked(settings, scene, file.bounds(), rule);
  const double seconds = watch.seconds();
  write_grid(grid,
             {file.hash(), scene.primitive_count(), settings.space, settings.overlap, rule.text,
              merge_text(grid.merge, settings.merge), settings.record_seconds ? seconds : -1},
             settings.output);
  const Vec3i n = grid.lattice.division;
  const GridStatistics counted = grid.merge == Merge::none
                                     ? grid_statistics(view_of<double>(grid), grid.references)
                                     : grid_statistics(merged_view_of<double>(grid), grid.cells);
  const std::uint64_t cells = counted.occupied_cells;
  if (settings.json) {
    fmt::print("{{\"division\": [{}, {}, {}], \"occupied_cells\": {}, \"references\": {}, \"build_seconds\": "
               "{:.6f}, \"total_seconds\": {:.6f}}}\n",
               n.x, n.y, n.z, cells, grid.references.size(), seconds, watch.seconds());
  } else {
    const std::string merged = grid.merge == Merge::none ? "" : fmt::format("{} cells, ", counted.cells);
    fmt::print("{}x{}x{} voxels, {}{} occupied, {} references; built in {:.3f} s, written in {:.3f} s\n", n.x,
               n.y, n.z, merged, cells, grid.references.size(), seconds, watch.seconds() - seconds);
  }
}

} // namespace
} // namespace masu

int main(int argc, char** argv) {
  using namespace masu;
  return run_tool(
      "gridbuild",
      "Builds the voxel grid of a scene.\n\nDivision rules, for N primitives in a space of sides w "
      "and volume V:\n"
      "  N              N voxels an axis\n"
      "  NXxNYxNZ       so many along x, y, z\n"
      "  cube-root:D    D * cbrt(N) an axis\n"
      "  woo:D          D * cbrt(N) along the longest axis, the others in proportion\n"
      "  heterogeneous:D  D * w * cbrt(N / V) an axis\n"
      "  cleary:L       L * N voxels of equal sides\n"
      "  auto           the coarsest that a cost model puts within a few percent of the best",
      argc, argv, [](CLI::App& app, const auto& parse) {
        Settings settings;
        app.add_option("SCENE", settings.scene, "scene file, from nff2bin")->required();
        app.add_option("-o,--output", settings.output, "grid file")->required();
        app.add_option("--division", settings.division, "how many voxels: see above")->capture_default_str();
        add_choice(app, "--space", settings.space, {{"tight", SpaceRule::tight}, {"cube", SpaceRule::cube}},
                   "what is divided: tight (the objects' bounds) or cube (the smallest about the origin)");
        add_choice(
            app, "--overlap", settings.overlap, {{"box", Overlap::box}, {"exact", Overlap::exact}},
            "when a voxel lists a primitive: box (bounding boxes meet) or exact (the surface meets it)");
        add_choice(app, "--merge", settings.merge_choice,
                   {{"auto", MergeChoice::automatic},
                    {"none", MergeChoice::none},
                    {"x", MergeChoice::x},
                    {"balance", MergeChoice::balance},
                    {"irregular", MergeChoice::irregular}},
                   "which voxels share a cell: auto (none where a division is given; else none or irregular, "
                   "as a cost model says), none, x (empty ones in a run along x), balance (as many as list "
                   "--target primitives), irregular (voxels are divided further, by expected cost)");
        app.add_option("--target", settings.merge.target, "balance: the most references of a cell")
            ->check(CLI::Range(1U, 1U << 20))
            ->capture_default_str();
        app.add_option("--nested", settings.merge.nested_log2,
                       "irregular: each voxel is divided into at most 2^N an axis")
            ->check(CLI::Range(0, 15))
            ->capture_default_str();
        app.add_option("--step-cost", settings.merge.step_over_test,
                       "irregular: what a step to a cell costs, in intersection tests")
            ->check(CLI::Range(0.0, 1000.0))
            ->capture_default_str();
        app.add_option("--detail", settings.merge.detail,
                       "irregular: planes no closer than a primitive's typical extent divided by this")
            ->check(CLI::Range(0.1, 100.0))
            ->capture_default_str();
        app.add_option(
               "--alpha", settings.merge.alpha,
               "irregular: divide while that makes the expected cost less than alpha times what it is")
            ->check(CLI::Range(0.0, 1.0))
            ->capture_default_str();
        app.add_option("--stretch", settings.merge.stretches,
                       "irregular: passes that stretch cells over neighbours that list nothing else")
            ->check(CLI::Range(0, 64))
            ->capture_default_str();
        app.add_flag("--record-seconds", settings.record_seconds,
                     "write the build's seconds into the file (equal builds then differ)");
        app.add_flag("--json", settings.json, "report as JSON");
        settings.threads.add_to(app);
        parse();
        const auto limit = settings.threads.limit();
        parse_division(settings.division); // a bad rule is told before anything is read
        const SceneFile scene(settings.scene);
        scene.is_float64() ? build<double>(settings, scene) : build<float>(settings, scene);
      });
}
