// Which part of a grid a slice shows, as options say it.
#pragma once

#include "libgrid/statistics/slice.h"

#include <string>

namespace masu {

// Reads AXIS=K (a layer of the smallest voxels), AXIS=P% (of the space), AXIS@X (scene units), such as z=12,
// z=50%, z@0.75. Throws Error(usage, "--slice", …).
SlicePlane parse_slice(const std::string& text, const GridLayout& finest);

// Reads LEFT,BOTTOM,RIGHT,TOP in scene units, along the picture's axes, and cuts it to the space; empty: the
// whole layer. Throws Error(usage, "--window", …).
SliceWindow parse_window(const std::string& text, const GridLayout& finest, int axis);

} // namespace masu
