// The camera of an NFF view that is incomplete or missing.
#pragma once

#include "libscene/nff/nff_piece.h"

namespace masu::nff {

// Replaces missing parts of `view` by defaults that show the whole scene. Throws Error(input) when its up is
// parallel to the view direction.
Camera complete_view(const View& view, const Scene& scene);

} // namespace masu::nff
