// A uniform grid by passes (passes.h): the same bytes as build_uniform's.
#pragma once

#include "libgrid/build/build.h"
#include "libgrid/build/executor.h"

#include <bit>

namespace masu {

// A grid in a Executor' memory; grid_view.h says what the arrays hold.
template <class Executor>
struct PassesGrid {
  GridLayout layout{};
  Merge merge = Merge::none;
  std::int32_t block_log2 = 0, nested_log2 = 0;
  ArrayOf<Executor, std::uint32_t> voxel_map{};
  ArrayOf<Executor, MergedCell> cells{};
  ArrayOf<Executor, PrimitiveIndex> references{};
};

// Which primitives are in which voxels, by voxel in the order of their places, then by primitive.
template <class Executor>
struct VoxelPairs {
  ArrayOf<Executor, std::uint64_t> places{};
  ArrayOf<Executor, PrimitiveIndex> primitives{};
};

// Primitives are gone through in pieces of so many rows of voxels, so that a large one is shared.
inline constexpr std::uint64_t rows_a_piece = 32;

template <class Executor, class Stored>
VoxelPairs<Executor> voxel_pairs(Executor& passes, const SceneView<Stored>& scene, const GridLayout& layout,
                                 Overlap overlap, const StorageOrder& order) {
  const std::uint32_t primitives = scene.primitive_count();
  auto pieces = passes.template array<std::uint64_t>(primitives + std::uint64_t{1});
  std::uint64_t* const first_piece = pieces.data();
  passes.for_each(primitives + std::uint64_t{1}, [=] MASU_PASS(std::uint64_t i) {
    std::uint64_t rows = 0;
    if (i != primitives) {
      with_primitive(scene, static_cast<PrimitiveIndex>(i),
                     [&](const auto& primitive) { rows = overlap_rows(layout, overlap, primitive).count(); });
    }
    first_piece[i] = (rows + rows_a_piece - 1) / rows_a_piece;
  });
  passes.scan(pieces);
  const std::uint64_t piece_count = passes.value(pieces, primitives);

  auto pairs = passes.template array<std::uint64_t>(piece_count + 1);
  std::uint64_t* const first_pair = pairs.data();
  passes.for_each(piece_count + 1, [=] MASU_PASS(std::uint64_t piece) {
    std::uint64_t count = 0;
    if (piece != piece_count) {
      const std::uint64_t i = owner_of(first_piece, primitives, piece);
      const std::uint64_t first = (piece - first_piece[i]) * rows_a_piece;
      with_primitive(scene, static_cast<PrimitiveIndex>(i), [&](const auto& primitive) {
        const VoxelRows rows = overlap_rows(layout, overlap, primitive);
        for_each_overlap(layout, overlap, primitive, rows, first,
                         std::min(first + rows_a_piece, rows.count()), [&](const Vec3i&) { ++count; });
      });
    }
    first_pair[piece] = count;
  });
  passes.scan(pairs);
  const std::uint64_t pair_count = passes.value(pairs, piece_count);
  if (pair_count > most_numbered) too_fine("more than 2^31 references");

  VoxelPairs<Executor> result{passes.template array<std::uint64_t>(pair_count),
                              passes.template array<PrimitiveIndex>(pair_count)};
  std::uint64_t* const place = result.places.data();
  PrimitiveIndex* const primitive_of = result.primitives.data();
  passes.for_each(piece_count, [=] MASU_PASS(std::uint64_t piece) {
    const std::uint64_t i = owner_of(first_piece, primitives, piece);
    const std::uint64_t first = (piece - first_piece[i]) * rows_a_piece;
    std::uint64_t at = first_pair[piece];
    with_primitive(scene, static_cast<PrimitiveIndex>(i), [&](const auto& primitive) {
      const VoxelRows rows = overlap_rows(layout, overlap, primitive);
      for_each_overlap(layout, overlap, primitive, rows, first, std::min(first + rows_a_piece, rows.count()),
                       [&](const Vec3i& voxel) {
                         place[at] = order.place(voxel);
                         primitive_of[at++] = static_cast<PrimitiveIndex>(i);
                       });
    });
  });
  passes.sort(result.places, result.primitives, static_cast<int>(std::bit_width(order.places())));
  return result;
}

// Numbers what begins anew along a list: numbers[i] is how many of 0 … i - 1 begin something, for i up to
// `count`. begins(i) says whether i does.
template <class Executor, class Begins>
ArrayOf<Executor, std::uint32_t> numbered(Executor& passes, std::uint64_t count, const Begins& begins) {
  auto numbers = passes.template array<std::uint32_t>(count + 1);
  std::uint32_t* const number = numbers.data();
  passes.for_each(count + 1,
                  [=] MASU_PASS(std::uint64_t i) { number[i] = i != count && begins(i) ? 1U : 0U; });
  passes.scan(numbers);
  return numbers;
}

template <class Executor, class Stored>
PassesGrid<Executor> uniform_by_passes(Executor& passes, const SceneView<Stored>& scene,
                                       const GridLayout& layout, Overlap overlap) {
  check_primitives(scene.primitive_count());
  const StorageOrder order(layout.division, block_log2_for(layout.division));
  VoxelPairs<Executor> pairs = voxel_pairs(passes, scene, layout, overlap, order);
  const std::uint64_t count = pairs.places.size(), block_words = voxel_count(order.blocks);
  const std::uint64_t* const place = pairs.places.data();
  const std::int32_t block_bits = 3 * order.block_log2;

  PassesGrid<Executor> grid{layout, Merge::none, order.block_log2, 0};
  ArrayOf<Executor, std::uint32_t> blocks{};
  std::uint64_t block_count = 0;
  if (block_bits > 0) {
    blocks = numbered(passes, count, [=] MASU_PASS(std::uint64_t i) {
      return i == 0 || place[i] >> block_bits != place[i - 1] >> block_bits;
    });
    block_count = passes.value(blocks, count);
  }
  grid.voxel_map = passes.template zeros<std::uint32_t>(block_words + (block_count << block_bits));
  grid.references = std::move(pairs.primitives);
  std::uint32_t* const map = grid.voxel_map.data();
  PrimitiveIndex* const reference = grid.references.data();
  const std::uint32_t* const block_number = blocks.data();
  passes.for_each(count, [=] MASU_PASS(std::uint64_t i) {
    const bool begins = i == 0 || place[i] != place[i - 1];
    const bool ends = i + 1 == count || place[i] != place[i + 1];
    if (ends) reference[i] |= last_bit;
    if (!begins) return;
    std::uint64_t word = place[i];
    if (block_bits > 0) {
      const std::uint32_t block = block_number[i + 1] - 1;
      map[place[i] >> block_bits] = block | occupied_bit;
      const std::uint64_t in_block = place[i] & ((std::uint64_t{1} << block_bits) - 1);
      word = block_words + (static_cast<std::uint64_t>(block) << block_bits) + in_block;
    }
    map[word] = static_cast<std::uint32_t>(i) | occupied_bit;
  });
  return grid;
}

} // namespace masu
