// gridstat's pictures of slices: the cells of a grid or the nested boxes of a hierarchy that a plane cuts,
// coloured by what they hold, with axes in scene units, a legend, and the outline of the geometry.
#pragma once

#include "libgrid/statistics/slice.h"
#include "libscene/plane_cut.h"

#include <cstdint>
#include <span>
#include <string>

namespace masu {

// What a cell's colour shows: its references; its volume; or its depth (libgrid/statistics/cells.h).
enum class SliceColor { references, volume, depth };

struct SliceStyle {
  SliceColor color = SliceColor::references;
  bool lines = false;      // of cells; boxes without a colour have them always
  std::string title{};     // empty: the grid's name and the plane
  std::int32_t size = 640; // pixels of the plot's longer side
  // The references or the depth that the darkest colour stands for, from 1 or 0 on, so that slices can be
  // compared; 0: of the cells shown.
  std::uint32_t high = 0;
};
inline constexpr std::int32_t least_slice_size = 64, most_slice_size = 4096;

// Written as PNG, SVG or JSON by the path's ending. `outline`: may be empty. Throws Error(usage) for an SVG
// of more than 2^18 or a JSON of more than 2^22 cells and for volumes of a
// hierarchy, Error(output).
void write_slice(const StructureFile& file, const SlicePlane& plane, const SliceWindow& window,
                 std::span<const CutSegment> outline, const SliceStyle& style, const std::string& path);

} // namespace masu
