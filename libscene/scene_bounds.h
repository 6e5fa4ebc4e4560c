// The join of the boxes of a scene's primitives.
#pragma once

#include "libscene/geometry/box.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

namespace masu {

// Of what box_of(record) gives of all triangles, spheres and cones, in parallel; empty where there are none.
// Primitives: Scene, or SceneSpans.
template <class Primitives, class BoxOf>
Boxd joined_boxes(const Primitives& scene, const BoxOf& box_of) {
  const auto of = [&](const auto& records) {
    return tbb::parallel_reduce(
        tbb::blocked_range<std::size_t>(0, records.size()), empty_box<double>(),
        [&](const tbb::blocked_range<std::size_t>& range, Boxd box) {
          for (std::size_t i = range.begin(); i != range.end(); ++i)
            box = join(box, box_of(records[i]));
          return box;
        },
        [](const Boxd& a, const Boxd& b) { return join(a, b); });
  };
  return join(join(of(scene.triangles), of(scene.spheres)), of(scene.cones));
}

} // namespace masu
