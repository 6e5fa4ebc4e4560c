// A slice as JSON.
#pragma once

#include "libgrid/statistics/slice.h"
#include "libscene/section.h"

#include <nlohmann/json.hpp>

#include <span>

namespace masu {

// [first u, first v, end u, end v, references, depth, voxels, number] as SliceCell has them.
nlohmann::ordered_json slice_cell_json(const SliceCell& cell);

// {"structure": "grid" or "bvh", "axis", "axes", "layer", "position", "space", "voxels", "nested_log2",
// "window", "cells": [slice_cell_json(), …], "outline": [[from u, from v, to u, to v, primitive], …]}: cells
// in the smallest voxels, else scene units. The space of a hierarchy is one voxel.
nlohmann::ordered_json slice_json(const Slice& slice, const SliceWindow& window,
                                  std::span<const SectionSegment> outline);

} // namespace masu
