#include "libgrid/hierarchy/hierarchy_builder.h"

#include "libgrid/hierarchy/binary/binary_hierarchy.h"
#include "libgrid/hierarchy/leaf_passes.h"
#include "libgrid/hierarchy/refit_passes.h"
#include "libscene/base/available_memory.h"
#include "libscene/base/error.h"

#include <fmt/format.h>

#include <utility>

namespace masu {

static_assert(cuts_per_width <= spare_leaves && 2 * (1 + spare_parts) <= 1 + spare_fragments);

void check_hierarchy(std::uint64_t primitives, double available) {
  const auto fail = [](const std::string& what) {
    throw Error(ErrorCode::usage, "structure", what + ": build a grid of voxels");
  };
  if (primitives > max_hierarchy_primitives)
    fail(fmt::format("{} primitives are more than the {} that a hierarchy's nodes can be numbered for",
                     primitives, max_hierarchy_primitives));
  const double needed = hierarchy_bytes_per_primitive * static_cast<double>(primitives);
  if (needed > available)
    fail(fmt::format("a hierarchy of {} primitives needs about {:.1f} GB to build, {:.1f} GB are free",
                     primitives, needed / 1e9, available / 1e9));
}

void check_hierarchy(const Boxd& space) {
  if (!fits_hierarchy(space))
    throw Error(ErrorCode::usage, "structure",
                "a hierarchy holds coordinates up to 1e15: build a grid of voxels");
}

void check_hierarchy(std::uint64_t primitives, const Boxd& space) {
  check_hierarchy(space);
  check_hierarchy(primitives,
                  available_memory_for(hierarchy_bytes_per_primitive * static_cast<double>(primitives)));
}

template <class Scene>
Structure build_hierarchy(const Scene& scene, const GridLayout& layout, HierarchyQuality quality,
                          ProgressMonitor* progress) {
  check_hierarchy(scene.primitive_count(), layout.space);
  TbbExecutor executor{progress};
  auto made = hierarchy_leaves(executor, scene, layout);
  const auto triangle = [&](PrimitiveIndex index) {
    Triangle<double> found{};
    with_primitive(scene, index, [&]<class Primitive>(const Primitive& primitive) {
      if constexpr (std::is_same_v<Primitive, Triangle<double>>) found = primitive;
    });
    return found;
  };
  return collapsed_hierarchy(executor, layout,
                             quality == HierarchyQuality::fast
                                 ? top_down_hierarchy(std::move(made), triangle, layout.space, progress)
                                 : binary_hierarchy(scene, layout.margin, std::move(made.leaves), progress));
}
template Structure build_hierarchy(const SceneView<float>&, const GridLayout&, HierarchyQuality,
                                   ProgressMonitor*);
template Structure build_hierarchy(const SceneView<double>&, const GridLayout&, HierarchyQuality,
                                   ProgressMonitor*);
template Structure build_hierarchy(const MeshesView<float, float>&, const GridLayout&, HierarchyQuality,
                                   ProgressMonitor*);
template Structure build_hierarchy(const MeshesView<float, double>&, const GridLayout&, HierarchyQuality,
                                   ProgressMonitor*);
template Structure build_hierarchy(const MeshesView<double, float>&, const GridLayout&, HierarchyQuality,
                                   ProgressMonitor*);
template Structure build_hierarchy(const MeshesView<double, double>&, const GridLayout&, HierarchyQuality,
                                   ProgressMonitor*);

template <class Stored>
bool refit_hierarchy(const SceneView<Stored>& scene, const GridLayout& layout, Structure& hierarchy) {
  check_hierarchy(layout.space);
  TbbExecutor executor;
  if (!holds_all(executor, scene, hierarchy.references)) return false;
  refit(executor, scene, layout.margin, hierarchy.nodes, hierarchy.references.data(),
        hierarchy.references.size());
  hierarchy.layout = {layout.space, {1, 1, 1}, layout.margin};
  return true;
}
template bool refit_hierarchy(const SceneView<float>&, const GridLayout&, Structure&);
template bool refit_hierarchy(const SceneView<double>&, const GridLayout&, Structure&);

} // namespace masu
