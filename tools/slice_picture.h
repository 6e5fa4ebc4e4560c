// gridstat's pictures of slices: the cells that a plane cuts, coloured by what they hold, with axes in scene
// units, a legend, and the outline of the geometry.
#pragma once

#include "libgrid/slice.h"
#include "libscene/section.h"

#include <nlohmann/json.hpp>

#include <span>
#include <string>

namespace masu {

// What a cell's colour shows: its references; its volume; or how often a voxel is halved down to it.
enum class SliceColor { references, volume, depth };

struct SliceStyle {
  SliceColor color = SliceColor::references;
  bool lines = false;      // of cells
  std::string title{};     // empty: the grid's name and the plane
  std::int32_t size = 640; // pixels of the plot's longer side
};
inline constexpr std::int32_t least_slice_size = 64, most_slice_size = 4096;

// Reads AXIS=K (a layer of the smallest voxels), AXIS=P% (of the space), AXIS@X (scene units), such as z=12,
// z=50%, z@0.75. Throws Error(usage, "--slice", …).
SlicePlane parse_slice(const std::string& text, const GridLayout& finest);

// Reads LEFT,BOTTOM,RIGHT,TOP in scene units, along the picture's axes, and cuts it to the space; empty: the
// whole layer. Throws Error(usage, "--window", …).
SliceWindow parse_window(const std::string& text, const GridLayout& finest, int axis);

// Written as PNG, SVG or JSON by the path's ending. `outline`: may be empty. Throws Error(usage) for an SVG
// of more than 2^18 or a JSON of more than 2^22 cells, Error(output).
void write_slice(const GridFile& file, const SlicePlane& plane, const SliceWindow& window,
                 std::span<const SectionSegment> outline, const SliceStyle& style, const std::string& path);

// {"axis", "axes", "layer", "position", "space", "voxels", "window", "cells": [[first u, first v, end u,
// end v, references, depth, voxels, number], …], "outline": [[from u, from v, to u, to v, primitive], …]}:
// cells in the smallest voxels, else scene units.
nlohmann::ordered_json slice_json(const Slice& slice, const SliceWindow& window,
                                  std::span<const SectionSegment> outline);

} // namespace masu
