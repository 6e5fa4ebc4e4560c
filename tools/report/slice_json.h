// A slice as JSON.
#pragma once

#include "libgrid/statistics/slice.h"
#include "libscene/file/scene_file.h"
#include "libscene/plane_cut.h"

#include <nlohmann/json.hpp>

#include <span>
#include <vector>

namespace masu {

// Where the plane cuts the scene's surfaces, within the window, with lines for curves that are off by no more
// than that share of the window's longer side.
std::vector<CutSegment> outline_of(const SceneFile& scene, const SlicePlane& plane, const SliceWindow& window,
                                   double deviation);

// [[first u, first v, end u, end v, references, depth, voxels, number] as SliceCell has them, …]: the first
// `most` cells, all or those that list something.
struct SliceCellsJson {
  nlohmann::ordered_json cells = nlohmann::ordered_json::array();
  bool is_truncated = false;
};
SliceCellsJson slice_cells_json(const StructureFile& file, const SlicePlane& plane, const SliceWindow& window,
                                std::size_t most, bool without_empty = false);

// {"structure": "grid" or "bvh", "axis", "axes", "layer", "position", "space", "voxels", "nested_log2",
// "window", "cells": slice_cells_json(), "outline": [[from u, from v, to u, to v, primitive], …]}: cells
// in the smallest voxels, else scene units. The space of a hierarchy is one voxel. Throws Error(usage,
// "--slice") for more than `most` cells.
nlohmann::ordered_json slice_json(const StructureFile& file, const SlicePlane& plane,
                                  const SliceWindow& window, std::span<const CutSegment> outline,
                                  std::size_t most = std::size_t{1} << 22);

} // namespace masu
