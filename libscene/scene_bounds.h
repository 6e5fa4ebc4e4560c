// The join of the boxes of a scene's primitives.
#pragma once

#include "libscene/geometry/box.h"

#include <cstddef>
#include <functional>

namespace masu {

// The join of box_of(begin, end) for the ranges that 0 … count - 1 is cut into, in parallel.
Boxd join_of_ranges(std::size_t count, const std::function<Boxd(std::size_t, std::size_t)>& box_of);

// Of what box_of(record) gives of all triangles, spheres and cones, in parallel; empty where there are none.
// Primitives: Scene, or SceneSpans.
template <class Primitives, class BoxOf>
Boxd joined_boxes(const Primitives& scene, const BoxOf& box_of) {
  const auto of = [&](const auto& records) {
    return join_of_ranges(records.size(), [&](std::size_t begin, std::size_t end) {
      Boxd box = empty_box<double>();
      for (std::size_t i = begin; i != end; ++i)
        box = join(box, box_of(records[i]));
      return box;
    });
  };
  return join(join(of(scene.triangles), of(scene.spheres)), of(scene.cones));
}

} // namespace masu
