// Building a uniform grid, on whatever executor (executor.h):
//
//   1. emit and sort  the pairs of a voxel and a primitive that it lists, by voxel in the map's storage order
//   2. map            where a voxel's pairs begin, its word is written; blocks are numbered before
//
// No byte of the result depends on the executor or its number of threads. No array has an element for each
// voxel but the map itself, and large maps have none for the empty blocks.
#pragma once

#include "libgrid/grid/overlap/overlap.h"
#include "libgrid/structure/structure.h"
#include "libscene/passes/passes.h"
#include "libscene/scene_view.h"

#include <bit>
#include <optional>

namespace masu {

// Pairs of a voxel's index in the storage order and a primitive that it lists, row by row of the voxels that
// the primitive's bounds meet.
template <class Stored>
struct EmitOverlaps { // NOLINT(cppcoreguidelines-pro-type-member-init): an aggregate
  SceneView<Stored> scene;
  GridLayout layout;
  Overlap overlap;
  StorageOrder order;

  MASU_HD std::uint64_t size(std::uint64_t i) const {
    std::uint64_t rows = 0;
    with_primitive(scene, static_cast<PrimitiveIndex>(i),
                   [&](const auto& primitive) { rows = overlap_rows(layout, overlap, primitive).count(); });
    return rows;
  }
  template <class Add>
  MASU_HD void operator()(std::uint64_t i, std::uint64_t first_row, std::uint64_t end_row,
                          const Add& add) const {
    with_primitive(scene, static_cast<PrimitiveIndex>(i), [&](const auto& primitive) {
      const VoxelRows rows = overlap_rows(layout, overlap, primitive);
      for_each_overlap(layout, overlap, primitive, rows, first_row, std::min(end_row, rows.count()),
                       [&](const Vec3i& voxel) { add(order.index(voxel), static_cast<PrimitiveIndex>(i)); });
    });
  }
};

// Which primitives are in which voxels, by voxel in the storage order, then by primitive. None for more than
// `most`.
template <class Executor, class Stored>
std::optional<Sorted<Executor, PrimitiveIndex>>
voxel_pairs(Executor& executor, const SceneView<Stored>& scene, const GridLayout& layout, Overlap overlap,
            const StorageOrder& order, std::uint64_t most) {
  const EmitOverlaps<Stored> emit{scene, layout, overlap, order};
  return executor.template emit_sorted<PrimitiveIndex>(
      scene.primitive_count(), static_cast<int>(std::bit_width(order.size())), most, emit);
}

template <class Executor, class Stored>
ExecutorStructure<Executor>
uniform_grid(Executor& executor, const SceneView<Stored>& scene, const GridLayout& layout, Overlap overlap,
             std::uint64_t max_references = max_numbered, std::uint64_t max_words = ~std::uint64_t{0}) {
  check_primitives(scene.primitive_count());
  const StorageOrder order(layout.division, block_log2_for(layout.division));
  auto pairs = voxel_pairs(executor, scene, layout, overlap, order, max_references);
  ExecutorStructure<Executor> grid{layout, StructureKind::uniform, order.block_log2, 0};
  if (!pairs) {
    grid.exceeded = too_many_references;
    return grid;
  }
  const std::uint64_t count = pairs->keys.size(), block_words = voxel_count(order.blocks);
  const std::uint64_t* const index = pairs->keys.data();
  const std::int32_t block_bits = 3 * order.block_log2;

  ArrayOf<Executor, std::uint32_t> blocks{};
  std::uint64_t block_count = 0;
  if (block_bits > 0) {
    blocks = sums_before(executor, count, [=] MASU_PASS(std::uint64_t i) {
      return i == 0 || index[i] >> block_bits != index[i - 1] >> block_bits;
    });
    block_count = executor.value(blocks, count);
  }
  const std::uint64_t words = block_words + (block_count << block_bits);
  if (words > max_words) {
    grid.exceeded = too_many_words;
    return grid;
  }
  grid.voxel_map = executor.template zeros<std::uint32_t>(words);
  grid.references = std::move(pairs->values);
  std::uint32_t* const map = grid.voxel_map.data();
  PrimitiveIndex* const reference = grid.references.data();
  const std::uint32_t* const block_number = blocks.data();
  executor.for_each(count, [=] MASU_PASS(std::uint64_t i) {
    const bool begins = i == 0 || index[i] != index[i - 1];
    const bool ends = i + 1 == count || index[i] != index[i + 1];
    if (ends) reference[i] |= last_bit;
    if (!begins) return;
    std::uint64_t word = index[i];
    if (block_bits > 0) {
      const std::uint32_t block = block_number[i + 1] - 1;
      if (block == block_number[i]) map[index[i] >> block_bits] = block | occupied_bit; // its first pair
      const std::uint64_t in_block = index[i] & ((std::uint64_t{1} << block_bits) - 1);
      word = block_words + (static_cast<std::uint64_t>(block) << block_bits) + in_block;
    }
    map[word] = static_cast<std::uint32_t>(i) | occupied_bit;
  });
  return grid;
}

} // namespace masu
