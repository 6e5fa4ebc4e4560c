// Grids of the C interface: built from a scene, or read.
#include "boundary.h"
#include "libgrid/hierarchy/hierarchy_builder.h"
#include "libgrid/structure/chosen_structure.h"
#include "libscene/base/processor.h"
#include "objects.h"

namespace {

using namespace masu;

BuildOptions build_options(const masu_build_options& from) {
  require_range(from.target, 1, 1 << 20, "target");
  require_range(from.alpha, 0, 1, "alpha");
  require_range(from.step_cost, 0, 1000, "step_cost");
  require_range(from.detail, 0.1, 100, "detail");
  require_range(from.nested, 0, 15, "nested");
  require_range(from.expand, 0, 64, "expand");
  require_range(from.device, MASU_CPU, 1 << 20, "device");
  BuildOptions options;
  constexpr StructureKind merges[] = {StructureKind::automatic, StructureKind::uniform, StructureKind::x,
                                      StructureKind::balance, StructureKind::irregular};
  const auto quality = choice<HierarchyQuality>(from.quality, 2, "quality");
  options.division = parse_division(from.division != nullptr ? from.division : "auto");
  const StructureKind kind = kind_of(choice<StructureChoice>(from.structure, 4, "structure"),
                                     merges[choice<int>(from.merge, 5, "merge")], options.division, quality);
  options.structure = {kind, from.target, from.alpha, from.step_cost, from.detail, from.nested, from.expand};
  options.structure.quality = quality;
  options.space = from.cube_space != 0 ? SpaceRule::cube : SpaceRule::tight;
  options.overlap = from.box_overlap != 0 ? Overlap::box : Overlap::exact;
  options.processor = from.for_cpu != 0 ? Processor::cpu : Processor::gpu;
  return options;
}

masu_build_options default_options() {
  const StructureOptions defaults;
  masu_build_options options{};
  options.size = sizeof options;
  options.structure = MASU_STRUCTURE_AUTO;
  options.division = "auto";
  options.target = defaults.target;
  options.alpha = defaults.alpha;
  options.step_cost = defaults.step_cost;
  options.detail = defaults.detail;
  options.nested = defaults.nested_log2;
  options.expand = defaults.expand;
  options.device = MASU_CPU;
  return options;
}

StructureFile built_grid(const SceneFile& scene, const BuildOptions& options, int device,
                         const std::function<void(double)>& progress) {
  return built_in_memory(scene, options, progress,
                         device == MASU_CPU ? std::nullopt : std::optional<int>(device));
}

std::unique_ptr<masu_grid> held(StructureFile file) {
  return std::make_unique<masu_grid>(masu_grid{std::make_shared<const StructureFile>(std::move(file))});
}

} // namespace

namespace masu {

StructureFile refitted_grid(const StructureFile& from, const SceneFile& scene) {
  const fb::Structure& table = from.table();
  const StructureProvenance provenance{scene.geometry_hash(),
                                       scene.primitive_count(),
                                       scene.origin(),
                                       static_cast<SpaceRule>(table.space_rule()),
                                       static_cast<Overlap>(table.overlap()),
                                       table.division_rule()->str(),
                                       {},
                                       from.quality()};
  return scene.with_view([&]<class Stored>(const SceneView<Stored>& view) {
    const auto layout = layout_in<Stored>(scene.bounds(), {1, 1, 1}, provenance.space_rule);
    Structure grid;
    grid.kind = StructureKind::hierarchy;
    grid.nodes.assign(from.nodes().begin(), from.nodes().end());
    grid.references.assign(from.references().begin(), from.references().end());
    if (!refit_hierarchy(view, layout, grid)) grid = build_hierarchy(view, layout, provenance.quality);
    return structure_in_memory(grid, provenance);
  });
}

void require_hierarchy(const StructureFile* grid) {
  if (grid == nullptr || !grid->is_hierarchy())
    fail("grid", "isn't a hierarchy, which alone can be refitted: build one with MASU_STRUCTURE_BVH");
}

StructureFile usual_grid(const SceneFile& scene, int device, const std::function<void(double)>& progress) {
  masu_build_options options = default_options();
  options.structure = MASU_STRUCTURE_GRID;
  options.for_cpu = device == MASU_CPU ? 1 : 0;
  return built_grid(scene, build_options(options), device, progress);
}

} // namespace masu

extern "C" {

masu_status masu_default_build_options(masu_build_options* options) {
  return guarded([&] { give(default_options(), options, "masu_build_options"); });
}

masu_status masu_grid_build(const masu_scene* scene, const masu_build_options* options, masu_grid** grid) {
  return make(grid, "grid", [&] {
    require(scene, "scene");
    check_processor();
    const masu_build_options wanted =
        options != nullptr ? taken(options, "masu_build_options") : default_options();
    const BuildOptions build_as = build_options(wanted);
    GoOn go_on(wanted.go_on, wanted.user);
    return on_threads_up_to(wanted.threads, [&] {
      return held(built_grid(scene->as_file(), build_as, wanted.device, go_on.progress()));
    });
  });
}

masu_status masu_grid_refit(const masu_grid* grid, const masu_scene* scene, masu_grid** fitted) {
  return make(fitted, "refitted", [&] {
    require(grid, "grid");
    require(scene, "scene");
    const StructureFile& from = *grid->file;
    require_hierarchy(&from);
    const SceneFile& file = scene->as_file();
    if (from.table().primitives() != file.primitive_count())
      fail("scene", fmt::format("has {} primitives, the grid was built from {}: build it anew",
                                file.primitive_count(), from.table().primitives()));
    return held(refitted_grid(from, file));
  });
}

masu_status masu_grid_read(const char* path, masu_grid** grid) {
  return make(grid, "grid", [&] {
    check_processor();
    require(path, "path");
    return held(StructureFile(path));
  });
}

masu_status masu_grid_write(const masu_grid* grid, const char* path) {
  return guarded([&] {
    require(grid, "grid");
    require(path, "path");
    grid->file->write(path);
  });
}

void masu_grid_free(masu_grid* grid) {
  delete grid;
}

masu_status masu_grid_describe(const masu_grid* grid, masu_grid_description* description) {
  return guarded([&] {
    require(grid, "grid");
    const StructureRecords records = grid->file->records();
    masu_grid_description described{};
    described.structure = records.is_hierarchy ? MASU_STRUCTURE_BVH : MASU_STRUCTURE_GRID;
    // As schemas/structure.fbs numbers them.
    constexpr masu_merge merges[] = {MASU_MERGE_NONE, MASU_MERGE_X, MASU_MERGE_BALANCE, MASU_MERGE_IRREGULAR};
    described.merge = merges[static_cast<int>(grid->file->table().merge())];
    for (int axis = 0; axis < 3; ++axis)
      described.division[axis] = static_cast<std::uint32_t>(records.layout.division[axis]);
    described.cells = records.cell_count;
    described.nodes = records.node_count;
    described.references = records.reference_count;
    described.bytes = grid->file->bytes();
    give(described, description, "masu_grid_description");
  });
}
}
