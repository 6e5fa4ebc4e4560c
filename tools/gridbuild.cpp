// gridbuild: divides a scene's space into voxels and writes which primitives each one holds.
#include "libgrid/grid_file.h"
#include "libgrid/merge.h"
#include "libgrid/statistics.h"
#include "libscene/scene_file.h"
#include "libscene/stopwatch.h"
#include "tools/cli.h"

#include <fstream>

namespace masu {
namespace {

struct Settings {
  std::string scene, output, division = "auto";
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
std::string merge_text(const MergeRule& rule) {
  switch (rule.merge) {
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

template <class Stored>
void build(const Settings& settings, const SceneFile& file) {
  const SceneView<Stored> scene = file.view<Stored>();
  const Stopwatch watch;
  DivisionRule rule = parse_division(settings.division);
  if (settings.merge.merge == Merge::irregular && rule.kind == DivisionRule::Kind::automatic)
    rule = parse_division("cleary:0.05");
  const DivisionStatistics statistics = division_statistics(scene);
  const Lattice lattice = make_lattice<Stored>(file.bounds(), settings.space, rule, statistics);
  check_memory(lattice, expected_references(statistics.all, lattice));
  const Grid grid = settings.merge.merge == Merge::none
                        ? build_uniform(scene, lattice, settings.overlap)
                        : build_merged(scene, lattice, settings.overlap, settings.merge);
  const double seconds = watch.seconds();
  write_grid(grid,
             {file.hash(), scene.primitive_count(), settings.space, settings.overlap, rule.text,
              merge_text(settings.merge), settings.record_seconds ? seconds : -1},
             settings.output);
  const Vec3i n = lattice.division;
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
        add_choice(
            app, "--merge", settings.merge.merge,
            {{"none", Merge::none},
             {"x", Merge::x},
             {"balance", Merge::balance},
             {"irregular", Merge::irregular}},
            "which voxels share a cell: none, x (empty ones in a run along x), balance (as many as list "
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
