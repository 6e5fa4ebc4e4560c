// Lists of places, and the points of a scene's surfaces that are closest to them: on the CPU.
#pragma once

#include "renderer/tracer/tracer.h"

namespace masu {

// Writes the distance of each place of a list (place_list.h), whose `format.origin` is the scene's, as t and
// t64, and what RayResults has besides of the closest point, but for `front`. Where there is none it is as of
// a miss. Of primitives that are as far the lowest index is taken. All is computed in double, whatever the
// scene is stored in.
//
// `hierarchy`: of the scene; null: every primitive is tried. `progress`: as RaysRequest has it. Throws
// Error(usage) for filters of another scene, and for a scene with coordinates beyond max_closest
// (libgrid/trace/closest.h).
void closest_points(const SceneFile& scene, const StructureFile* hierarchy, const RayList& places,
                    const RayResults& results, const std::function<void(double)>& progress = {});

} // namespace masu
