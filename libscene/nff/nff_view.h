// The camera of an NFF view that leaves something out, or isn't there.
#pragma once

#include "libscene/nff/nff_piece.h"

namespace masu::nff {

// Fills in what `view` lacks so that everything in `scene` is seen. Throws Error(input) when its up runs
// along the line of sight.
Camera complete_view(const View& view, const Scene& scene, const Text& text);

} // namespace masu::nff
