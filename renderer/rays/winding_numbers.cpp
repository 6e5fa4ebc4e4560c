#include "renderer/rays/winding_numbers.h"

#include "libscene/base/error.h"
#include "libscene/base/parallel.h"
#include "renderer/rays/closest_points.h"
#include "renderer/rays/list_progress.h"

namespace masu {

WindingClusters winding_clusters(const SceneFile& scene, const StructureFile* hierarchy) {
  return scene.with_view([&]<class Stored>(const SceneView<Stored>& view) {
    if (view.primitive_count() != view.triangle_count)
      throw Error(ErrorCode::usage, "scene", "has spheres or cones: winding numbers are of triangles alone");
    if (hierarchy == nullptr) return WindingClusters{};
    const StructureRecords& records = hierarchy->records();
    return winding_clusters(view, hierarchy_view_of<Stored>(records), records.node_count,
                            records.reference_count);
  });
}

void winding_numbers(const SceneFile& scene, const StructureFile* hierarchy, const WindingClusters& clusters,
                     const RayList& places, double bound, double* numbers, std::uint8_t* inside,
                     const std::function<void(double)>& progress) {
  ListProgress list_progress(progress, places.count, 16, scene.primitive_count());
  scene.with_view([&]<class Stored>(const SceneView<Stored>& view) {
    const auto nodes =
        hierarchy != nullptr ? hierarchy_view_of<Stored>(hierarchy->records()) : HierarchyView<Stored>{};
    parallel_ranges(places.count, 64, [&](std::size_t begin, std::size_t end) {
      std::vector<UndividedCluster> room;
      for (std::size_t i = begin; i != end; ++i) {
        const Vec3d place = place_at(places.rays, places.format, i);
        const bool is_valid = largest_magnitude(place) <= max_closest && is_finite(place);
        const double number =
            is_valid ? winding_number(view, nodes, clusters, place, bound, numbers == nullptr, room) : NAN;
        if (numbers != nullptr) numbers[i] = number;
        if (inside != nullptr) inside[i] = number >= 0.5 ? 1 : 0;
        list_progress.done(i);
      }
    });
  });
}

} // namespace masu
