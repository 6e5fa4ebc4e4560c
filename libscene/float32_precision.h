// Whether float32 arithmetic is precise enough for a scene whose numbers float32 can represent.
#pragma once

#include "libscene/scene.h"

namespace masu {

// margin: the error bound of float32 arithmetic (margin.h). across: the longest side of the scene's bounds.
// too_small: objects smaller than twice the margin, which rays may miss; triangles count by object, since
// there are no gaps between a surface's triangles. flattened: cones whose ends coincide in float32.
struct Float32Precision {
  double margin = 0, across = 0;
  std::uint64_t too_small = 0, flattened = 0;

  // So far from the origin for its size that most hits are unreliable.
  bool is_far() const { return across < 256 * margin; }
  bool any() const { return is_far() || too_small > 0 || flattened > 0; }
};

Float32Precision float32_precision(const Scene& scene);

} // namespace masu
