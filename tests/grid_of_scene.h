// A grid built for a scene file and written, as gridbuild does it.
#pragma once

#include "libgrid/file/structure_file.h"
#include "libgrid/grid/division.h"
#include "libgrid/structure/builder.h"
#include "libscene/file/scene_file.h"

namespace masu {

// Throws Error when the space can't be divided.
inline void write_grid_of(const SceneFile& scene, const std::string& division,
                          const StructureOptions& options, const std::string& path,
                          Overlap overlap = Overlap::exact) {
  scene.with_view([&]<class Stored>(const SceneView<Stored>& view) {
    const GridLayout layout = make_grid_layout<Stored>(scene.bounds(), SpaceRule::tight,
                                                       parse_division(division), division_statistics(view));
    write_structure(build_structure(view, layout, overlap, options),
                    {scene.geometry_hash(), scene.primitive_count(), scene.origin(), SpaceRule::tight,
                     overlap, division, ""},
                    path);
  });
}

} // namespace masu
