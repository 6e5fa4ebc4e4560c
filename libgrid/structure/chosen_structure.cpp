#include "libgrid/structure/chosen_structure.h"

#include "libgrid/hierarchy/hierarchy_builder.h"
#include "libgrid/structure/sampled_costs.h"
#include "libscene/base/available_memory.h"
#include "libscene/base/error.h"
#include "libscene/base/parallel.h"
#include "libscene/mesh/indexed_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace masu {
namespace {

// Throws Error(usage, "division", …) where there is less memory than building takes at its peak, for so many
// references.
void check_memory(const GridLayout& layout, double references, bool is_automatic) {
  // Pairs as they are emitted, and sorted; a block's map for each few cells.
  constexpr double pair_bytes = 8 + sizeof(std::uint64_t) + sizeof(PrimitiveIndex);
  const std::int32_t block_log2 = block_log2_for(layout.division);
  const double words = static_cast<double>(voxel_count(blocks_of(layout.division, block_log2)));
  const double block_maps = block_log2 == 0 ? 0 : references / 16 * 512 * 4;
  const double needed = 4 * words + block_maps + references * pair_bytes,
               available = available_memory_for(needed);
  if (needed <= available) return;
  const Vec3i n = layout.division;
  throw Error(
      ErrorCode::usage, "division",
      fmt::format("{}{}x{}x{} voxels need about {:.1f} GB to build, {:.1f} GB are free: choose a coarser one",
                  is_automatic ? "auto is too fine for this machine: " : "", n.x, n.y, n.z, needed / 1e9,
                  available / 1e9));
}

// As files have it.
std::string merge_text(const Structure& grid, const StructureOptions& options) {
  if (grid.kind == StructureKind::x) return "x";
  if (grid.kind == StructureKind::balance) return fmt::format("balance target {}", options.target);
  if (grid.kind != StructureKind::irregular) return "";
  return fmt::format("irregular nested {} detail {} step {} alpha {} expand {}", options.nested_log2,
                     grid.detail, options.step_cost, options.alpha, options.expand);
}

struct Candidate {
  GridLayout layout;
  StructureOptions options;
  std::uint64_t primitives;
};

// What is built on this layout, within limits that keep its time and memory to about eight times a
// hierarchy's where nobody gave the division. They depend on the geometry alone.
Candidate candidate(StructureKind kind, const GridLayout& layout, const BuildOptions& options,
                    const DivisionStatistics& statistics) {
  const std::uint64_t primitives = statistics.all.primitives;
  Candidate made{layout, options.structure, primitives};
  made.options.kind = kind;
  const bool automatic_division = options.division.kind == DivisionRule::Kind::automatic;
  const auto limit = [](double count) {
    return static_cast<std::uint64_t>(std::min(count, static_cast<double>(max_numbered)));
  };
  // Expected references are those of the exact overlap test.
  if (automatic_division) made.options.max_references = limit(4 * most_references(primitives));
  if (kind == StructureKind::uniform) {
    const double words =
        0x1p23 + 8 * hierarchy_bytes_per_primitive / sizeof(std::uint32_t) * static_cast<double>(primitives);
    made.options.max_map_words = automatic_division ? limit(words) : ~std::uint64_t{0};
  }
  // SPD scenes make up to 72 fragments per primitive on all levels. Boxes meet more voxels than expected.
  constexpr double always = 0x1p16;
  const double fragments_per_reference = options.overlap == Overlap::box ? 1024 : 128;
  const double listed = automatic_division && kind == StructureKind::irregular
                            ? static_cast<double>(primitives)
                            : expected_references(statistics.all, layout);
  made.options.max_fragments = static_cast<std::uint64_t>(always + fragments_per_reference * listed);
  return made;
}

// A layout's division times a factor along each axis.
GridLayout scaled(GridLayout layout, double factor) {
  for (int axis = 0; axis < 3; ++axis) {
    const double voxels = std::clamp<double>(std::round(layout.division[axis] * factor), 1, largest_division);
    layout.division.set(axis, static_cast<std::int32_t>(voxels));
  }
  return layout;
}

// Grids: at least one, more than one where the choice is automatic.
template <class Stored>
std::vector<Candidate> candidates_for(const SceneView<Stored>& scene, const Boxd& bounds,
                                      const BuildOptions& options) {
  const DivisionStatistics statistics = division_statistics(scene);
  const bool automatic_division = options.division.kind == DivisionRule::Kind::automatic;
  const StructureKind kind = options.structure.kind;
  std::vector<Candidate> candidates;
  const auto layout_by = [&](const DivisionRule& rule) {
    return make_grid_layout<Stored>(bounds, options.space, rule, statistics);
  };
  const auto add = [&](StructureKind of, const GridLayout& layout) {
    for (const Candidate& known : candidates)
      if (known.options.kind == of && known.layout.division == layout.division) return;
    check_memory(layout, expected_references(statistics.all, layout), automatic_division);
    candidates.push_back(candidate(of, layout, options, statistics));
  };
  const auto add_uniform = [&](std::initializer_list<double> factors) {
    const GridLayout usual = layout_by(options.division);
    for (const double factor : factors) {
      const GridLayout layout = scaled(usual, factor);
      if (factor <= 1 ||
          expected_references(statistics.all, layout) <= most_references(statistics.all.primitives))
        add(StructureKind::uniform, layout);
    }
  };
  const bool is_chosen =
      kind == StructureKind::fastest || (kind == StructureKind::automatic && automatic_division);
  if (is_chosen) add_uniform({1});
  if (is_chosen || kind == StructureKind::irregular) {
    DivisionRule rule = options.division; // voxels start out coarser, unless their division was given
    if (automatic_division) rule.kind = DivisionRule::Kind::nested;
    const GridLayout usual = layout_by(rule);
    add(StructureKind::irregular, usual);
    if (automatic_division) add(StructureKind::irregular, scaled(usual, 0.25));
  } else if (kind == StructureKind::uniform && automatic_division) {
    add_uniform({1, 0.625, 1.6});
  } else {
    GridLayout layout = layout_by(options.division);
    // A merged grid's map has a word for each voxel.
    const double most_voxels = 0x1p25 + 64 * static_cast<double>(statistics.all.primitives);
    while (automatic_division && static_cast<double>(voxel_count(layout.division)) > most_voxels)
      layout = scaled(layout, 0.8);
    // Whoever gives a division means those voxels, not ones to divide further.
    add(kind == StructureKind::automatic ? StructureKind::uniform : kind, layout);
  }
  return candidates;
}

// Where nothing is to be chosen, or nothing could be built within the limits of a choice: the candidate, or,
// where nobody gave the division, the first one without nested voxels, twice as large each time, that can be.
template <class Stored>
Structure usual_one(Candidate candidate, StructureBuilder<Stored>& builder, const BuildOptions& options) {
  if (options.division.kind == DivisionRule::Kind::automatic) {
    while (candidate.layout.division != Vec3i{1, 1, 1}) {
      Structure built = builder.try_build(candidate.layout, options.overlap, candidate.options);
      if (built.exceeded == nullptr) return built;
      candidate.layout = scaled(candidate.layout, 0.5);
      candidate.options.nested_log2 = 0;
    }
  }
  return builder.build(candidate.layout, options.overlap, candidate.options);
}

// The first structure is traced as long as a hierarchy takes to build, or some grid; the others by as many
// rays, and no longer than could pay.
SampleLimits limits_for(StructureKind first, std::uint64_t primitives) {
  const auto n = static_cast<double>(primitives);
  const double work = first == StructureKind::hierarchy ? 0x1p19 + 16 * n : 0x1p20 + 64 * n;
  return {SampleLimits{}.rays, static_cast<std::uint64_t>(work)};
}
SampleLimits limits_after(const SampledCosts& first) {
  return {first.rays, (std::uint64_t{1} << 21) + 4 * first.work};
}

struct Built {
  Structure structure;
  SampledCosts costs;
};

Considered considered_of(const Built& built, const BuildOptions& options) {
  const StructureKind kind = built.structure.kind;
  return {kind, built.structure.layout.division, built.costs,
          expected_time(built.costs, kind, options.processor)};
}

template <class Stored>
Structure hierarchy_of(StructureBuilder<Stored>& builder, const Boxd& bounds, const BuildOptions& options) {
  StructureOptions wanted = options.structure;
  wanted.kind = StructureKind::hierarchy;
  return builder.build(layout_in<Stored>(bounds, {1, 1, 1}, options.space), options.overlap, wanted);
}

// The grid through which rays are expected to take the least time, or the hierarchy, where there is one.
template <class Stored>
Structure fastest_of(const std::vector<Candidate>& candidates, StructureBuilder<Stored>& builder,
                     const BuildOptions& options, std::optional<Built> hierarchy,
                     std::vector<Considered>& considered) {
  if (!hierarchy && (candidates.size() == 1 || builder.scene().primitive_count() == 0))
    return usual_one(candidates.front(), builder, options);
  std::optional<SampleLimits> limits;
  if (hierarchy) limits = limits_after(hierarchy->costs);
  std::size_t tried = hierarchy ? 1 : 0;
  const std::size_t all = tried + candidates.size();
  // What comes first is the usual one. Pictures take up to 7 % longer through a coarser top division that
  // lists take as long through: their threads share no tests.
  constexpr double clearly = 0.95;
  Structure fastest;
  double least = std::numeric_limits<double>::infinity();
  const auto consider = [&](Built one) {
    considered.push_back(considered_of(one, options));
    const double time = considered.back().expected_time;
    if (!(time < clearly * least)) return;
    least = time;
    fastest = std::move(one.structure);
  };
  for (const Candidate& candidate : candidates) {
    builder.progress().begin_part(tried++, all);
    Built one{builder.try_build(candidate.layout, options.overlap, candidate.options), {}};
    if (one.structure.exceeded != nullptr) continue;
    one.costs = sampled_costs(builder.scene(), one.structure,
                              limits ? *limits : limits_for(candidate.options.kind, candidate.primitives),
                              &builder.progress());
    if (limits && one.costs.rays < limits->rays) continue;
    if (!limits) limits = limits_after(one.costs);
    consider(std::move(one));
  }
  if (hierarchy) consider(*std::move(hierarchy));
  return considered.empty() ? usual_one(candidates.front(), builder, options) : std::move(fastest);
}

// A hierarchy first: grids are built only where one may be faster.
template <class Stored>
Structure chosen(StructureBuilder<Stored>& builder, const Boxd& bounds, const BuildOptions& options,
                 std::vector<Considered>& considered) {
  const SceneView<Stored>& scene = builder.scene();
  const StructureKind kind = options.structure.kind;
  if (kind == StructureKind::hierarchy) return hierarchy_of(builder, bounds, options);
  std::optional<Built> hierarchy;
  // By the geometry alone, not by the memory that is free: the same scene gives the same bytes.
  if (kind == StructureKind::fastest && scene.primitive_count() > 0 &&
      scene.primitive_count() <= max_hierarchy_primitives &&
      fits_hierarchy(layout_in<Stored>(bounds, {1, 1, 1}, options.space).space)) {
    hierarchy = Built{hierarchy_of(builder, bounds, options), {}};
    const SampleLimits limits = limits_for(StructureKind::hierarchy, scene.primitive_count());
    const auto sample = [&](std::size_t rays) {
      return sampled_costs(scene, hierarchy->structure, {rays, limits.work}, &builder.progress());
    };
    hierarchy->costs = sample(rays_that_tell);
    if (!grid_may_win(hierarchy->costs)) {
      considered.push_back(considered_of(*hierarchy, options));
      return std::move(hierarchy->structure);
    }
    hierarchy->costs = sample(limits.rays);
  }
  return fastest_of(candidates_for(scene, bounds, options), builder, options, std::move(hierarchy),
                    considered);
}

} // namespace

StructureKind kind_of(StructureChoice structure, StructureKind merge, const DivisionRule& division,
                      HierarchyQuality quality) {
  const bool is_merge_given = merge != StructureKind::automatic,
             is_grid_given = is_merge_given || division.kind != DivisionRule::Kind::automatic;
  if (structure == StructureChoice::hierarchy && is_merge_given)
    throw Error(ErrorCode::usage, "merge", "is of grids alone");
  if (structure == StructureChoice::hierarchy || (structure == StructureChoice::automatic && !is_grid_given))
    return StructureKind::hierarchy;
  if (structure == StructureChoice::fastest && !is_grid_given) return StructureKind::fastest;
  if (quality != HierarchyQuality::high) throw Error(ErrorCode::usage, "quality", "is of hierarchies alone");
  return merge;
}

StructureProvenance provenance_of(const SceneGeometry& geometry, std::uint64_t primitives,
                                  const BuildOptions& options, const Structure& structure) {
  return {geometry.hash,
          primitives,
          geometry.origin,
          options.space,
          options.overlap,
          options.division.text,
          merge_text(structure, options.structure),
          options.structure.quality};
}

template <class Stored>
DescribedStructure build_chosen(StructureBuilder<Stored>& builder, const SceneGeometry& geometry,
                                const BuildOptions& options) {
  DescribedStructure result;
  result.grid = chosen(builder, geometry.bounds, options, result.considered);
  result.provenance = provenance_of(geometry, builder.scene().primitive_count(), options, result.grid);
  return result;
}
template DescribedStructure build_chosen(StructureBuilder<float>&, const SceneGeometry&, const BuildOptions&);
template DescribedStructure build_chosen(StructureBuilder<double>&, const SceneGeometry&,
                                         const BuildOptions&);

BuildOptions fast_hierarchy_options() {
  BuildOptions options;
  options.structure.kind = StructureKind::hierarchy;
  options.structure.quality = HierarchyQuality::fast;
  return options;
}

namespace {

// Before a scene's triangles are made of meshes: they aren't in memory beside what building takes.
Structure hierarchy_of(const SceneFile& scene, const MeshTriangles& meshes, const BuildOptions& options,
                       const std::function<void(double)>& progress) {
  return scene.with_view_but_triangles([&]<class Stored>(const SceneView<Stored>& others) {
    return meshes.as_stored<Stored>(
        scene.origin(), [&]<class Number>(const StoredTriangles<Stored, Number>& triangles) {
          ProgressMonitor monitor(progress);
          return build_hierarchy(MeshesView<Stored, Number>{others, triangles},
                                 layout_in<Stored>(scene.bounds(), {1, 1, 1}, options.space),
                                 options.structure.quality, &monitor);
        });
  });
}

// The same on a device, while the host makes the triangles, for their hash.
Structure hierarchy_of(const SceneFile& scene, const MeshTriangles& meshes, const BuildOptions& options,
                       const std::function<void(double)>& progress, int cuda_device) {
  Structure hierarchy;
  const UnmadeTriangles unmade{&meshes, scene.origin()};
  const auto build = [&] {
    hierarchy = scene.with_view_but_triangles([&](const auto& others) {
      return hierarchy_of(*cuda_builder(others, cuda_device, progress, false, &unmade), scene.bounds(),
                          options);
    });
  };
  parallel_invoke([&] { scene.make_whole(); }, build); // by the caller's thread, which CUDA knows
  return hierarchy;
}

} // namespace

StructureFile built_in_memory(const SceneFile& scene, const BuildOptions& options,
                              const std::function<void(double)>& progress, std::optional<int> cuda_device) {
  if (options.structure.kind == StructureKind::hierarchy) {
    if (auto meshes = scene.unmade_triangles()) {
      const Structure hierarchy = cuda_device ? hierarchy_of(scene, *meshes, options, progress, *cuda_device)
                                              : hierarchy_of(scene, *meshes, options, progress);
      meshes.reset(); // they go when the triangles are made, for the hash
      return structure_in_memory(
          hierarchy, provenance_of(scene.geometry(), scene.primitive_count(), options, hierarchy));
    }
  }
  return scene.with_view([&](const auto& view) {
    const auto builder =
        cuda_device ? cuda_builder(view, *cuda_device, progress, false) : cpu_builder(view, progress);
    const DescribedStructure built = build_chosen(*builder, scene.geometry(), options);
    return structure_in_memory(built.grid, built.provenance);
  });
}

} // namespace masu
