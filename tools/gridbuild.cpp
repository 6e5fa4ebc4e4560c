// gridbuild: divides a scene's space into voxels and writes which primitives each one holds; or builds a
// bounding volume hierarchy instead.
#include "libgrid/statistics/statistics.h"
#include "libgrid/structure/chosen_structure.h"
#include "libscene/base/stopwatch.h"
#include "libscene/cuda/cuda_device.h"
#include "libscene/file/output_file.h"
#include "libscene/file/scene_file.h"
#include "tools/common/cli.h"
#include "tools/common/json.h"
#include "tools/common/print.h"
#include "tools/common/progress.h"

#include <optional>
#include <utility>

namespace masu {
namespace {

enum class Device { cpu, cuda };

struct Settings {
  std::string scene, output, division = "auto";
  StructureChoice structure = StructureChoice::fastest;
  BuildOptions options;
  Device device = Device::cpu;
  bool record_seconds = false, json = false, quiet = false;
  Threads threads;
};

// On standard error where the grid is written to standard output.
template <class... Values>
void print_report(const Settings& settings, fmt::format_string<Values...> format, Values&&... values) {
  if (is_standard_output(settings.output)) return print_note(format, std::forward<Values>(values)...);
  fmt::print(format, std::forward<Values>(values)...);
}

// What was built in order to choose, with cells or nodes, and tests, per ray of each sample.
Json considered_json(const std::vector<Considered>& considered) {
  Json all = Json::array();
  const auto cost = [](const RayCost& ray) { return Json{ray.steps, ray.tests}; };
  for (const Considered& one : considered)
    all.push_back({{"structure", one.kind == StructureKind::hierarchy   ? "bvh"
                                 : one.kind == StructureKind::irregular ? "irregular"
                                                                        : "uniform"},
                   {"division", {one.division.x, one.division.y, one.division.z}},
                   {"expected_time", one.expected_time},
                   {"across", cost(one.costs.across)},
                   {"aimed", cost(one.costs.aimed)},
                   {"scattered", cost(one.costs.scattered)}});
  return all;
}

template <class Stored>
void build(const Settings& settings, const SceneFile& file) {
  const SceneView<Stored> scene = file.view<Stored>();
  std::optional<Progress> progress(std::in_place, "building", settings.quiet);
  const bool with_gpu = settings.device == Device::cuda;
  if (with_gpu) see_first_gpu_alone();
  const auto builder = with_gpu ? cuda_builder(scene) : cpu_builder(scene, std::ref(*progress));
  const Stopwatch watch;
  auto [grid, made, considered] = build_chosen(*builder, file.geometry(), settings.options);
  progress.reset();
  const double seconds = watch.seconds();
  if (settings.record_seconds) made.build_seconds = seconds;
  write_structure(grid, made, settings.output);
  const double total_seconds = watch.seconds();
  if (settings.quiet && !settings.json) return;
  const bool is_hierarchy = grid.kind == StructureKind::hierarchy,
             is_irregular = grid.kind == StructureKind::irregular;
  const DeviceSeconds on_device = builder->device_seconds();
  Json json;
  std::string text; // what was built, for people
  if (is_hierarchy) {
    const HierarchyStatistics counted = hierarchy_statistics(grid.nodes);
    json = {{"nodes", counted.nodes}, {"depth", counted.depth}, {"references", counted.references}};
    text = fmt::format("{} nodes, {} references", grouped(counted.nodes), grouped(counted.references));
  } else {
    const Vec3i n = grid.layout.division;
    const bool is_uniform = grid.kind == StructureKind::uniform;
    const GridStatistics counted =
        grid_statistics(is_uniform ? voxel_count(n) : grid.cells.size(), grid.references);
    json = {{"division", {n.x, n.y, n.z}},
            {"occupied_cells", counted.occupied_cells},
            {"references", grid.references.size()}};
    text = fmt::format("{}x{}x{} voxels, {}{} occupied, {} references", n.x, n.y, n.z,
                       is_uniform ? "" : fmt::format("{} cells, ", grouped(counted.cells)),
                       grouped(counted.occupied_cells), grouped(grid.references.size()));
  }
  if (settings.json) {
    if (is_irregular) json["detail"] = grid.detail;
    if (with_gpu)
      json["device_seconds"] = {{"set_up", on_device.set_up},
                                {"upload", on_device.upload},
                                {"build", on_device.build},
                                {"download", on_device.download}};
    json.update({{"build_seconds", seconds},
                 {"total_seconds", total_seconds},
                 {"device", with_gpu ? cuda_device_name() : "cpu"},
                 {"scene_hash", to_hex(file.hash())}});
    if (!considered.empty()) json["considered"] = considered_json(considered);
    json.update(provenance());
    return print_report(settings, "{}\n", json_text(json, -1));
  }
  print_report(settings, "{}\nbuilt in {:.3f} s, written in {:.3f} s\n", text, seconds,
               total_seconds - seconds);
  if (is_irregular && grid.detail < settings.options.structure.detail)
    print_report(settings, "built with --detail {}: with more it would be too large\n", grid.detail);
  if (with_gpu)
    print_report(settings,
                 "on the GPU: set-up {:.3f} s, upload {:.3f} s, build {:.3f} s, download {:.3f} s\n",
                 on_device.set_up, on_device.upload, on_device.build, on_device.download);
}

// The library's errors in the command line's words.
Error translated(const Error& error) {
  for (const char* const option : {"division", "merge", "quality", "structure"})
    if (error.place() == option) return {error.code(), fmt::format("--{}", option), error.message()};
  if (error.place() == "cuda") return {error.code(), "cuda", error.message() + " (--device cpu)"};
  return error;
}

void add_options(const CommandLine& command, Settings& settings) {
  command.footer("Example:\n  gridbuild balls.scene -o balls.grid --merge irregular");
  command.add_option("SCENE", settings.scene, "scene file, from nff2bin or mesh2bin").required();
  command.group("Output");
  command.add_file("-o,--output", settings.output, "grid file").required();
  command.add_flag("--record-seconds", settings.record_seconds,
                   "write the build's seconds into the file (equal builds then differ)");
  command.add_flag("--json", settings.json, "report as JSON");
  command.group("Voxels");
  command.add_option("--division", settings.division, "voxels per axis, by a division rule", "RULE")
      .shows_default();
  command.add_choice(
      "--space", settings.options.space, {{"tight", SpaceRule::tight}, {"cube", SpaceRule::cube}},
      "what is divided: tight (the objects' bounds) or cube (the smallest about the local origin)");
  command.add_choice(
      "--overlap", settings.options.overlap, {{"box", Overlap::box}, {"exact", Overlap::exact}},
      "when a voxel lists a primitive: box (bounding boxes meet) or exact (the surface meets it)");
  command.group("Cells");
  command.add_choice("--structure", settings.structure,
                     {{"grid", StructureChoice::grid},
                      {"bvh", StructureChoice::hierarchy},
                      {"fastest", StructureChoice::fastest}},
                     "what is built: grid, bvh (a bounding volume hierarchy of eight boxes per node), "
                     "fastest (whichever of both a sample of rays is expected to take the least time "
                     "through; a grid if --merge or --division is given)");
  command.add_choice("--quality", settings.options.structure.quality,
                     {{"high", HierarchyQuality::high}, {"fast", HierarchyQuality::fast}},
                     "of a hierarchy: high (primitives are divided where boxes would overlap) or fast (in a "
                     "third of the time)");
  command.add_choice("--for", settings.options.processor, {{"gpu", Processor::gpu}, {"cpu", Processor::cpu}},
                     "the processor that will trace: what the automatic choices (--structure fastest, "
                     "--merge auto, --division auto) count a step and a test by");
  command.add_choice(
      "--merge", settings.options.structure.kind,
      {{"auto", StructureKind::automatic},
       {"none", StructureKind::uniform},
       {"x", StructureKind::x},
       {"balance", StructureKind::balance},
       {"irregular", StructureKind::irregular}},
      "which voxels share a cell: auto (none where a division is given; else none or irregular, whichever a "
      "sample of rays is expected to take less time through), none, x (empty ones in a run along x), balance "
      "(as many as list --target primitives), irregular (voxels are divided further, by expected cost)");
  command.add_number("--target", settings.options.structure.target, 1U, 1U << 20,
                     "balance: the most references of a cell");
  command.add_number("--nested", settings.options.structure.nested_log2, 0, 15,
                     "irregular: each voxel is divided into at most 2^N per axis");
  command.add_number("--step-cost", settings.options.structure.step_cost, 0.0, 1000.0,
                     "irregular: what a step to a cell costs, in intersection tests");
  command.add_number("--detail", settings.options.structure.detail, 0.1, 100.0,
                     "irregular: planes no closer than a primitive's typical extent divided by this");
  command.add_number("--alpha", settings.options.structure.alpha, 0.0, 1.0,
                     "irregular: divide while that makes the expected cost less than alpha times what it is");
  command.add_number("--expand", settings.options.structure.expand, 0, 64,
                     "irregular: rounds of expanding cells over neighbours that list nothing else");
  command.group("General");
  command.add_choice("--device", settings.device, {{"cpu", Device::cpu}, {"cuda", Device::cuda}},
                     "where to build; the file is the same");
  command.add_quiet(settings.quiet, "no progress on standard error, and no report without --json");
  settings.threads.add_to(command);
}

// That none of the grids that may be built has.
void refuse_useless(const CommandLine& command, const BuildOptions& options) {
  const StructureKind kind = options.structure.kind;
  const bool is_hierarchy = kind == StructureKind::hierarchy,
             has_division = options.division.kind != DivisionRule::Kind::automatic,
             is_chosen =
                 (kind == StructureKind::automatic || kind == StructureKind::fastest) && !has_division,
             is_irregular = kind == StructureKind::irregular || is_chosen;
  const char *const of_grids = "is of grids of voxels: a hierarchy has none",
                    *const of_irregular = "is of irregular grids: give --merge irregular";
  command.refuse({{"--division", is_hierarchy && has_division, of_grids},
                  {"--overlap", is_hierarchy, of_grids},
                  {"--target", kind != StructureKind::balance, "is of balanced grids: give --merge balance"},
                  {"--nested", !is_irregular, of_irregular},
                  {"--step-cost", !is_irregular, of_irregular},
                  {"--detail", !is_irregular, of_irregular},
                  {"--alpha", !is_irregular, of_irregular},
                  {"--expand", !is_irregular, of_irregular}});
}

void run(Settings& settings, const CommandLine& command) {
  const auto limit = settings.threads.limit();
  try {
    BuildOptions& options = settings.options; // are checked before anything is read
    options.division = parse_division(settings.division);
    options.structure.kind =
        kind_of(settings.structure, options.structure.kind, options.division, options.structure.quality);
    refuse_useless(command, options);
    check_scene_input(settings.scene);
    check_files({settings.scene}, {settings.output});
    const SceneFile scene(settings.scene);
    scene.is_float64() ? build<double>(settings, scene) : build<float>(settings, scene);
  } catch (const Error& error) {
    throw translated(error);
  }
}

} // namespace
} // namespace masu

int main(int argc, char** argv) {
  using namespace masu;
  return run_tool("gridbuild",
                  "Builds the voxel grid of a scene, or a bounding volume hierarchy.\n\nDivision rules, for "
                  "N primitives in a space of sides w and volume V:\n"
                  "  N              N voxels per axis\n"
                  "  NXxNYxNZ       so many along x, y, z\n"
                  "  cube-root:D    D * cbrt(N) per axis\n"
                  "  woo:D          D * cbrt(N) along the longest axis, the others in proportion\n"
                  "  heterogeneous:D  D * w * cbrt(N / V) per axis\n"
                  "  cleary:L       L * N voxels of equal sides\n"
                  "  auto           by a cost model, and a sample of rays through some divisions",
                  argc, argv, add_options, run);
}
