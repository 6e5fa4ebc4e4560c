#include "libgrid/build/build.h"

#include "libscene/error.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <limits>
#include <numeric>

namespace masu {
namespace {

constexpr std::uint32_t primitives_a_piece = 4096;
constexpr std::uint64_t most_buckets = 1024;

// A voxel's place in its bucket, and a primitive listed there.
struct Pair {
  std::uint32_t voxel;
  PrimitiveIndex primitive;
};

// The order in which the map stores voxels, cut into buckets of equal size.
struct BucketOrder : StorageOrder {
  std::uint32_t bucket_log2 = 12; // voxels a bucket; whole blocks
  std::uint64_t buckets;

  explicit BucketOrder(const Vec3i& voxels) : StorageOrder(voxels, block_log2_for(voxels)) {
    while ((places() >> bucket_log2) >= most_buckets)
      ++bucket_log2;
    buckets = (places() >> bucket_log2) + 1;
  }
};

// The pairs of some consecutive primitives; bucket b's are pairs[begin[b]] … pairs[begin[b + 1] - 1], in the
// primitives' order.
struct Piece {
  std::vector<Pair> pairs;
  std::vector<std::uint32_t> begin;
};

struct PlacedPair {
  std::uint64_t place;
  PrimitiveIndex primitive;
};

Piece sorted_by_bucket(const std::vector<PlacedPair>& placed, const BucketOrder& order) {
  Piece piece;
  piece.begin.assign(order.buckets + 1, 0);
  for (const PlacedPair& pair : placed)
    ++piece.begin[(pair.place >> order.bucket_log2) + 1];
  std::partial_sum(piece.begin.begin(), piece.begin.end(), piece.begin.begin());
  piece.pairs.resize(placed.size());
  std::vector<std::uint32_t> next(piece.begin.begin(), piece.begin.end() - 1);
  const std::uint64_t mask = (std::uint64_t{1} << order.bucket_log2) - 1;
  for (const PlacedPair& pair : placed) {
    piece.pairs[next[pair.place >> order.bucket_log2]++] = {static_cast<std::uint32_t>(pair.place & mask),
                                                            pair.primitive};
  }
  return piece;
}

template <class Stored>
std::vector<Piece> emit(const SceneView<Stored>& scene, const GridLayout& layout, Overlap overlap,
                        const BucketOrder& order) {
  const std::uint32_t count = scene.primitive_count();
  std::vector<Piece> pieces((count + std::uint64_t{primitives_a_piece} - 1) / primitives_a_piece);
  std::atomic<std::uint64_t> references = 0;
  tbb::parallel_for(std::size_t{0}, pieces.size(), [&](std::size_t number) {
    std::vector<PlacedPair> placed;
    const auto first = static_cast<std::uint32_t>(number * primitives_a_piece);
    const std::uint32_t last = std::min(count - first, primitives_a_piece) + first;
    for (std::uint32_t i = first; i != last; ++i) {
      const auto add = [&](const Vec3i& voxel) { placed.push_back({order.place(voxel), i}); };
      with_primitive(scene, i,
                     [&](const auto& primitive) { for_each_overlap(layout, overlap, primitive, add); });
      if (placed.size() > most_numbered) too_fine("more than 2^31 references");
    }
    if ((references += placed.size()) > most_numbered) too_fine("more than 2^31 references");
    pieces[number] = sorted_by_bucket(placed, order);
  });
  return pieces;
}

// A bucket's voxels that hold something: which, and where their references begin.
struct BucketCell {
  std::uint32_t voxel;
  std::uint32_t begin;
};

// Where each bucket's references and blocks begin in the whole; one entry more than there are buckets.
struct Offsets {
  std::vector<std::uint64_t> values;
  explicit Offsets(std::uint64_t buckets) : values(buckets + 1, 0) {}
  void accumulate() { std::partial_sum(values.begin(), values.end(), values.begin()); }
};

// Few pairs in many voxels: sorted by comparison. Else counted, voxel by voxel. Both keep the primitives'
// order.
std::vector<BucketCell> sort_bucket(const std::vector<Piece>& pieces, std::uint64_t bucket,
                                    std::uint32_t voxels_log2, std::uint64_t first_reference,
                                    std::uint64_t count, PrimitiveIndex* references) {
  const auto for_each_pair = [&](const auto& act) {
    for (const Piece& piece : pieces) {
      for (std::uint32_t i = piece.begin[bucket]; i != piece.begin[bucket + 1]; ++i)
        act(piece.pairs[i]);
    }
  };
  std::vector<BucketCell> cells;
  const auto add = [&](std::uint32_t voxel, std::uint64_t begin) {
    if (begin > 0) references[begin - 1] |= last_bit;
    cells.push_back({voxel, static_cast<std::uint32_t>(first_reference + begin)});
  };
  if (count < (std::uint64_t{1} << voxels_log2) / 16) {
    std::vector<std::uint64_t> keys;
    keys.reserve(count);
    for_each_pair(
        [&](const Pair& pair) { keys.push_back(std::uint64_t{pair.voxel} << 32 | pair.primitive); });
    std::sort(keys.begin(), keys.end());
    for (std::size_t i = 0; i != keys.size(); ++i) {
      const auto voxel = static_cast<std::uint32_t>(keys[i] >> 32);
      references[i] = static_cast<PrimitiveIndex>(keys[i]);
      if (cells.empty() || cells.back().voxel != voxel) add(voxel, i);
    }
  } else {
    std::vector<std::uint32_t> next((std::size_t{1} << voxels_log2) + 1, 0);
    for_each_pair([&](const Pair& pair) { ++next[pair.voxel + 1]; });
    std::partial_sum(next.begin(), next.end(), next.begin());
    const std::vector<std::uint32_t> begin(next);
    for_each_pair([&](const Pair& pair) { references[next[pair.voxel]++] = pair.primitive; });
    for (std::uint32_t voxel = 0; voxel + 1 < begin.size(); ++voxel) {
      if (begin[voxel + 1] != begin[voxel]) add(voxel, begin[voxel]);
    }
  }
  references[count - 1] |= last_bit;
  return cells;
}

// The bucket's words of the map.
void write_map(const BucketOrder& order, std::uint64_t bucket, const std::vector<BucketCell>& bucket_cells,
               std::uint64_t first_block, Grid& grid) {
  const std::uint64_t first_place = bucket << order.bucket_log2;
  const std::int32_t block_bits = 3 * order.block_log2;
  const std::uint64_t block_words = voxel_count(order.blocks);
  std::uint64_t block = first_block;
  std::uint64_t last_block_place = std::numeric_limits<std::uint64_t>::max();
  for (const BucketCell& bucket_cell : bucket_cells) {
    const std::uint64_t place = first_place + bucket_cell.voxel;
    std::uint64_t word = place;
    if (block_bits > 0) {
      const std::uint64_t block_place = place >> block_bits;
      if (block_place != last_block_place) {
        last_block_place = block_place;
        grid.voxel_map[block_place] = static_cast<std::uint32_t>(block++) | occupied_bit;
      }
      word = block_words + ((block - 1) << block_bits) + (place & ((std::uint64_t{1} << block_bits) - 1));
    }
    grid.voxel_map[word] = bucket_cell.begin | occupied_bit;
  }
}

std::uint64_t blocks_in(const std::vector<BucketCell>& cells, std::int32_t block_bits) {
  std::uint64_t blocks = 0, last = std::numeric_limits<std::uint64_t>::max();
  for (const BucketCell& cell : cells) {
    const std::uint64_t block = cell.voxel >> block_bits;
    blocks += block != last;
    last = block;
  }
  return blocks;
}

} // namespace

void too_fine(const char* makes) {
  throw Error(ErrorCode::usage, "--division", fmt::format("makes {}: choose a coarser one", makes));
}

void check_primitives(std::uint64_t count) {
  if (count > most_numbered)
    throw Error(ErrorCode::input, "scene", "holds more than 2^31 primitives: grids can't number so many");
}

double expected_build_bytes(const GridLayout& layout, double references) {
  // Pairs and references; every reference in a cell of its own at worst; a block's map for each few cells.
  const std::int32_t block_log2 = block_log2_for(layout.division);
  const double words = static_cast<double>(voxel_count(blocks_of(layout.division, block_log2)));
  const double block_maps = block_log2 == 0 ? 0 : references / 16 * 512 * 4;
  return 4 * words + block_maps + references * (sizeof(Pair) + sizeof(PrimitiveIndex) + sizeof(BucketCell));
}

template <class Stored>
Grid build_uniform(const SceneView<Stored>& scene, const GridLayout& layout, Overlap overlap) {
  check_primitives(scene.primitive_count());
  const BucketOrder order(layout.division);
  std::vector<Piece> pieces = emit(scene, layout, overlap, order);

  Grid grid{layout, Merge::none, order.block_log2, 0, {}, {}, {}};
  Offsets reference_offsets(order.buckets), block_offsets(order.buckets);
  for (const Piece& piece : pieces) {
    for (std::uint64_t bucket = 0; bucket < order.buckets; ++bucket) {
      reference_offsets.values[bucket + 1] += piece.begin[bucket + 1] - piece.begin[bucket];
    }
  }
  reference_offsets.accumulate();
  grid.references.resize(reference_offsets.values.back());

  std::vector<std::vector<BucketCell>> cells(order.buckets);
  tbb::parallel_for(std::uint64_t{0}, order.buckets, [&](std::uint64_t bucket) {
    const std::uint64_t first = reference_offsets.values[bucket],
                        count = reference_offsets.values[bucket + 1] - first;
    if (count == 0) return;
    cells[bucket] =
        sort_bucket(pieces, bucket, order.bucket_log2, first, count, grid.references.data() + first);
    block_offsets.values[bucket + 1] =
        order.block_log2 == 0 ? 0 : blocks_in(cells[bucket], 3 * order.block_log2);
  });
  pieces.clear();
  pieces.shrink_to_fit();

  block_offsets.accumulate();
  grid.voxel_map.assign(voxel_count(order.blocks) + (block_offsets.values.back() << (3 * order.block_log2)),
                        0);
  tbb::parallel_for(std::uint64_t{0}, order.buckets, [&](std::uint64_t bucket) {
    write_map(order, bucket, cells[bucket], block_offsets.values[bucket], grid);
  });
  return grid;
}
template Grid build_uniform(const SceneView<float>&, const GridLayout&, Overlap);
template Grid build_uniform(const SceneView<double>&, const GridLayout&, Overlap);

} // namespace masu
