// gridstat's pictures: a layer of voxels, coloured by how much their cells list.
#pragma once

#include "libgrid/file/grid_file.h"

#include <string>

namespace masu {

// The layer's axis, and its place along it in the grid's smallest voxels.
struct Slice {
  int axis;
  std::int32_t at;
};

// Reads AXIS=K, such as z=12, or AXIS=P%, such as z=50%. Throws Error(usage, "--slice", …).
Slice parse_slice(const std::string& text, const Vec3i& division);

// The second of the other two axes points up. Merged cells are prepare_watertight by a darker line where
// there is room for it. Throws Error(output).
void draw_slice(const GridFile& file, const Slice& slice, const std::string& path);

} // namespace masu
