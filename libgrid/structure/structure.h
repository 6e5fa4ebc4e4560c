// What a built grid is.
#pragma once

#include "libgrid/structure/structure_options.h"
#include "libgrid/structure/structure_records.h"
#include "libscene/base/error.h"
#include "libscene/base/host_array.h"
#include "libscene/base/progress_monitor.h"
#include "libscene/scene_view.h"

namespace masu {

// In arrays of that memory; see grid.h and hierarchy.h for what they hold.
template <class Memory>
struct StructureIn {
  template <class T>
  using Array = typename Memory::template Array<T>;

  GridLayout layout{}; // a merged grid's smallest voxels are 2^nested_log2 times smaller
  StructureKind kind = StructureKind::uniform;
  std::int32_t block_log2 = 0;  // of uniform grids
  std::int32_t nested_log2 = 0; // of merged ones
  Array<std::uint32_t> voxel_map{};
  Array<MergedCell> cells{}; // of merged ones
  Array<PrimitiveIndex> references{};
  Array<HierarchyNode> nodes{}; // of a hierarchy, which has no map and no cells
  double detail = 0; // of an irregular one: as StructureOptions, or less where its map demands that
  const char* exceeded = nullptr; // what the layout makes too many of, where there is no grid: "more than …"

  // Of no scene.
  operator StructureRecords() const {
    return {voxel_map.data(),
            cells.data(),
            references.data(),
            nodes.data(),
            voxel_map.size(),
            cells.size(),
            references.size(),
            nodes.size(),
            0,
            kind == StructureKind::hierarchy,
            kind != StructureKind::uniform && kind != StructureKind::hierarchy,
            layout,
            block_log2,
            nested_log2};
  }
};

using Structure = StructureIn<HostMemory>;
template <class Executor>
using ExecutorStructure = StructureIn<typename Executor::Memory>;

inline constexpr const char* too_many_references = "more references than are possible";
inline constexpr const char* too_many_words = "more words for its map than are possible";

// Throws Error(input) for more primitives than grids can number.
inline void check_primitives(std::uint64_t count) {
  if (count > max_numbered)
    throw Error(ErrorCode::input, "scene", "holds more than 2^31 primitives: grids can't number so many");
}

} // namespace masu
