// Ray counts as JSON: the keys of gridrender --stats.
#pragma once

#include "renderer/counts.h"

#include <nlohmann/json.hpp>

namespace masu {

inline nlohmann::ordered_json counts_report(const Counts& counts) {
  return {
      {"eye_rays", counts.camera_rays},
      {"eye_hits", counts.camera_hits},
      {"reflection_rays", counts.reflection_rays},
      {"refraction_rays", counts.refraction_rays},
      {"shadow_rays", counts.shadow_rays},
      {"shadow_hits", counts.shadow_hits},
      {"secondary_hits", counts.secondary_hits},
      {"intersection_tests",
       {{"triangle", counts.triangle_tests}, {"sphere", counts.sphere_tests}, {"cone", counts.cone_tests}}},
      {"cells_visited", counts.cells_visited},
      {"empty_cells_visited", counts.empty_cells_visited},
      {"voxels_skipped", counts.voxels_skipped}};
}

} // namespace masu
