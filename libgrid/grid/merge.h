// Grids whose cells are boxes of several voxels: their cells, their limits, and building them on the host.
#pragma once

#include "libgrid/grid/splitter.h"
#include "libgrid/structure/structure.h"
#include "libscene/base/progress_monitor.h"

#include <algorithm>

namespace masu {

inline constexpr std::int32_t max_plane = 65535; // a cell's box has 16 bits for it

MASU_HD inline MergedCell packed(const VoxelBox& box, std::uint32_t list) {
  const auto range = [&](int axis) {
    return static_cast<std::uint32_t>(box.first[axis]) | static_cast<std::uint32_t>(box.end[axis]) << 16;
  };
  return {range(0), range(1), range(2), list};
}

// How an irregular grid's voxels are divided further: as often as planes can be numbered.
inline std::int32_t nested_log2_for(std::int32_t longest_division, const StructureOptions& options) {
  std::int32_t nested_log2 = 0;
  while (nested_log2 < options.nested_log2 && (longest_division << (nested_log2 + 1)) <= max_plane)
    ++nested_log2;
  return nested_log2;
}

inline constexpr const char* too_many_cells = "more than 2^31 cells or references";
inline constexpr const char* too_many_fragments = "lists that hardly get shorter where they are divided";

// What has become too large, the map being of `words` words, the first top_words of them its top level; or
// nullptr.
inline const char* exceeded_by_sizes(std::uint64_t cells, std::uint64_t references, std::uint64_t top_words,
                                     std::uint64_t words, std::uint64_t max_words = max_nested_words) {
  if (std::max(cells, references) > max_numbered) return too_many_cells;
  return words > max_words && words > top_words ? too_many_words : nullptr;
}

// Of kind x, balance or irregular. Independent of the number of threads. Throws Error(input) for more
// primitives than grids can number. `progress` gets shares of the work.
template <class Stored>
Structure merged_grid(const SceneView<Stored>& scene, const GridLayout& layout, Overlap overlap,
                      const StructureOptions& options, ProgressMonitor* progress = nullptr);

} // namespace masu
