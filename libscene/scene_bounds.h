// The join of the boxes of a scene's primitives.
#pragma once

#include "libscene/base/parallel.h"
#include "libscene/geometry/box.h"

#include <cstddef>

namespace masu {

// Of what box_of(record) gives of all records, in parallel; empty where there are none. Where their box is
// known (MeshTriangles), it is what box_of() gives of that: it keeps the order of coordinates.
template <class Records, class BoxOf>
Boxd joined_boxes(const Records& records, const BoxOf& box_of) {
  if constexpr (requires { records.box(); }) {
    return records.size() > 0 ? box_of(records.box()) : empty_box<double>();
  } else {
    return parallel_reduce(
        records.size(), 256, empty_box<double>(),
        [&](std::size_t begin, std::size_t end) {
          Boxd box = empty_box<double>();
          for (std::size_t i = begin; i != end; ++i)
            box = join(box, box_of(records[i]));
          return box;
        },
        [](const Boxd& a, const Boxd& b) { return join(a, b); });
  }
}

// The same of all triangles, spheres and cones of a scene.
template <class Scene, class BoxOf>
requires requires(const Scene& scene) {
  scene.triangles;
}
Boxd joined_boxes(const Scene& scene, const BoxOf& box_of) {
  return join(join(joined_boxes(scene.triangles, box_of), joined_boxes(scene.spheres, box_of)),
              joined_boxes(scene.cones, box_of));
}

} // namespace masu
