// From build options to a grid or hierarchy and its description: what tools call.
#pragma once

#include "libgrid/file/structure_file.h"
#include "libgrid/structure/builder.h"
#include "libgrid/structure/sampled_costs.h"
#include "libscene/file/scene_file.h"

#include <functional>
#include <optional>

namespace masu {

// What is wanted: a grid, a hierarchy, whichever of both a sample of rays is expected to take the least time
// through, or, automatic, a hierarchy. The masu_structure of masu.h.
enum class StructureChoice { grid, hierarchy, fastest, automatic };

// The kind that is built. `merge` is of a grid, automatic where none was given. fastest and automatic are a
// grid if a merge rule or a division was given. Throws Error(usage) for options that contradict each other.
StructureKind kind_of(StructureChoice structure, StructureKind merge, const DivisionRule& division,
                      HierarchyQuality quality);

// What rays take through a structure that was built, in order to choose (sampled_costs.h).
struct Considered {
  StructureKind kind = StructureKind::uniform;
  Vec3i division{};
  SampledCosts costs;
  double expected_time = 0;
};

struct DescribedStructure {
  Structure grid;
  StructureProvenance provenance;     // for its file
  std::vector<Considered> considered; // empty where nothing was to be chosen
};

// A grid of the builder's scene, whose geometry is given.
//
// Where options.division is automatic, or options.structure.kind fastest, several structures are candidates:
//   uniform    the division of the cost model (division.h), a coarser and a finer one
//   irregular  the usual top division (division.h), and one with a quarter of the voxels along each axis
//   automatic  the model's uniform one and those of irregular
//   fastest    a hierarchy, and those of automatic where some rays through it say that a grid may be faster
// In this order, but for a hierarchy, which is the last, one takes the place of those before it if rays are
// expected to take 5 % less time through it on options.processor (sampled_costs.h). Left out is what the
// geometry doesn't allow: a grid that would take much more than eight times a hierarchy's time or memory to
// build or to sample, in counts of references, fragments, words, steps and tests; a hierarchy of too many
// primitives, or too far away. Where no grid is left of those asked for, a coarser one is built. The choice
// depends on the geometry and the options alone. Kind automatic with a given division is uniform.
//
// The builder's progress gets shares of all of that. Throws Error(usage, "division", …) for a given division
// that is too fine, or where there is less memory than is needed, and as the builder does.
template <class Stored>
DescribedStructure build_chosen(StructureBuilder<Stored>& builder, const SceneGeometry& geometry,
                                const BuildOptions& options);

// For the file of a structure that was built with these options of a scene of so many primitives.
StructureProvenance provenance_of(const SceneGeometry& geometry, std::uint64_t primitives,
                                  const BuildOptions& options, const Structure& structure);
// What is built soonest.
BuildOptions fast_hierarchy_options();

// The same in memory, built on a CUDA device or, for none, on the CPU.
StructureFile built_in_memory(const SceneFile& scene, const BuildOptions& options,
                              const std::function<void(double)>& progress = {},
                              std::optional<int> cuda_device = {});

} // namespace masu
