// From build options to a grid and its description: what tools call.
#pragma once

#include "libgrid/build/builder.h"
#include "libgrid/file/grid_file.h"
#include "libscene/file/scene_file.h"

namespace masu {

struct DescribedGrid {
  Grid grid;
  GridProvenance provenance; // for its file
};

// A grid of the builder's scene, whose geometry is given.
//
// Kind automatic: where options.division isn't automatic, that division, uniform. Else a uniform and an
// irregular grid are built, and the one is taken that a random ray is expected to cross at less cost
// (map_statistics.h), a step costing options.grid.step_cost tests; or the smaller one where that makes less
// than a tenth's difference. A scene whose irregular grid would be too large even with least
// detail (merge.h) gets the uniform one.
//
// Kind fastest: an irregular grid and a hierarchy are built, and the one is taken that rays are expected to
// cross in less time (sampled_costs.h); where the geometry allows only one of them, that one.
//
// Throws Error(usage, "division", …) for a division that is too fine, or needs more memory than there is, and
// as the builder does.
template <class Stored>
DescribedGrid build_grid(GridBuilder<Stored>& builder, const SceneGeometry& geometry,
                         const BuildOptions& options);

} // namespace masu
