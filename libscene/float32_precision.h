// Where float32 holds a scene's numbers, but not its answers.
#pragma once

#include "libscene/scene.h"

namespace masu {

// margin: how far off float32 arithmetic may see a surface (margin.h). across: the scene's longest side.
// lost: objects hardly larger than the margin; of triangles whole objects count, since a surface's triangles
// have no gaps between them. flattened: cones that lose their length.
struct Float32Precision {
  double margin = 0, across = 0;
  std::uint64_t lost = 0, flattened = 0;

  // So far from the origin for its size that most rays' answers are in doubt (docs/stability.md).
  bool is_far() const { return across < 256 * margin; }
  bool any() const { return is_far() || lost > 0 || flattened > 0; }
};

Float32Precision float32_precision(const Scene& scene);

} // namespace masu
