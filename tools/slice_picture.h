// gridstat's pictures: a layer of voxels, coloured by the number of references of their cells.
#pragma once

#include "libgrid/file/grid_file.h"

#include <string>

namespace masu {

// The layer's axis, and its index along it in the grid's smallest voxels.
struct Slice {
  int axis;
  std::int32_t at;
};

// Reads AXIS=K, such as z=12, or AXIS=P%, such as z=50%. Throws Error(usage, "--slice", …).
Slice parse_slice(const std::string& text, const Vec3i& division);

// Writes a PNG. Of the other two axes the first points right, the second up. Merged cells have a darker
// outline where there is room for it. Throws Error(output).
void draw_slice(const GridFile& file, const Slice& slice, const std::string& path);

} // namespace masu
