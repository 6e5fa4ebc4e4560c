// Winding numbers about a list of places: on the CPU.
#pragma once

#include "libgrid/file/structure_file.h"
#include "libgrid/trace/winding.h"
#include "renderer/rays/ray_list.h"

namespace masu {

// Of a scene's hierarchy; none where that is null. Throws Error(usage) for a scene of other primitives than
// triangles.
WindingClusters winding_clusters(const SceneFile& scene, const StructureFile* hierarchy);

// Writes each place's number, off by at most `bound`, and whether it is at least 1/2, which is exact unless
// 1/2 is nearer than that; either may be null. Of a place with a coordinate that is NaN or beyond max_closest
// the number is NaN. Without a hierarchy all triangles are summed. `format.origin` is the scene's.
void winding_numbers(const SceneFile& scene, const StructureFile* hierarchy, const WindingClusters& clusters,
                     const RayList& places, double bound, double* numbers, std::uint8_t* inside,
                     const std::function<void(double)>& progress = {});

} // namespace masu
