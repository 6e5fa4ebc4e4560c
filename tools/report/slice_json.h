// A grid's slice as JSON.
#pragma once

#include "libgrid/statistics/slice.h"
#include "libscene/section.h"

#include <nlohmann/json.hpp>

#include <span>

namespace masu {

// {"axis", "axes", "layer", "position", "space", "voxels", "nested_log2", "window", "cells": [[first u, first
// v, end u, end v, references, depth, voxels, number], …], "outline": [[from u, from v, to u, to v,
// primitive], …]}: cells in the smallest voxels, else scene units.
nlohmann::ordered_json slice_json(const Slice& slice, const SliceWindow& window,
                                  std::span<const SectionSegment> outline);

} // namespace masu
