// What a grid file's records must be before anything follows an index in them: every walk stays within them,
// and ends.
#pragma once

#include "libgrid/structure/structure_records.h"
#include "libscene/file/record_checker.h"

#include <algorithm>

namespace masu {

namespace checks {

// Whether each of a grid's lists, list(i) or empty_list for cell i, begins where one does, and belongs to one
// cell alone. So a ray, which meets a cell once, tests no more primitives than there are references; if many
// cells shared a long list, a small file could take for ever to trace.
template <class Checker, class List>
bool lists_are_separate(const Checker& checker, const StructureRecords& grid, std::uint64_t cells,
                        const List& list) {
  auto listed = checker.zeros(set_words(grid.reference_count));
  return checker.all(cells, [=, begun = listed.data()] MASU_PASS(std::uint64_t i) {
    const std::uint32_t begin = list(i);
    return begin == empty_list ||
           (begin < grid.reference_count && (begin == 0 || (grid.references[begin - 1] & last_bit) != 0) &&
            inserted(begun, begin));
  });
}

template <class Checker>
const char* fault_of_uniform(const Checker& checker, const StructureRecords& grid) {
  const std::uint64_t blocks = voxel_count(blocks_of(grid.layout.division, grid.block_log2)),
                      block_maps = (grid.words - blocks) >> (3 * grid.block_log2),
                      first = grid.block_log2 > 0 ? blocks : 0;
  if (!checker.all(grid.words, [=] MASU_PASS(std::uint64_t i) {
        const std::uint32_t word = grid.voxel_map[i];
        const std::uint64_t limit = i < first ? block_maps : grid.reference_count;
        return (word & occupied_bit) != 0 ? (word & ~occupied_bit) < limit : word == 0;
      }))
    return "its voxel map names a list that isn't there";
  auto map_set = checker.zeros(set_words(block_maps));
  if (!checker.all(first, [=, used = map_set.data()] MASU_PASS(std::uint64_t i) {
        const std::uint32_t word = read_once(grid.voxel_map[i]), map = word & ~occupied_bit;
        return (word & occupied_bit) == 0 || (map < block_maps && inserted(used, map));
      }))
    return "its blocks share maps";
  const bool separate = lists_are_separate(checker, grid, grid.words - first, [=] MASU_PASS(std::uint64_t i) {
    const std::uint32_t word = read_once(grid.voxel_map[first + i]);
    return (word & occupied_bit) != 0 ? word & ~occupied_bit : empty_list;
  });
  return separate ? nullptr : "its voxels share lists";
}

// A merged grid's map from one word of its top level on: every voxel leads to a cell whose box it is in.
class MapCheck {
public:
  // The box of 2^log2 voxels along each axis at `first`.
  struct Part {
    Vec3i first, log2;
  };

  MASU_HD explicit MapCheck(const StructureRecords& grid) : grid_(grid) {}

  // Whether all that the word says of the part is so, as far as it is this share's: of the division that the
  // word leads to, every `shares`-th part. Looks at no more words than there are.
  MASU_HD bool is_good(std::uint32_t word, const Part& part, std::uint32_t share, std::uint32_t shares) {
    if (!enters(word, part)) return false;
    if (share > 0) words_ = 0; // those are counted by the first
    stack_[0].index = share;
    while (depth_ > 0) {
      Division& division = stack_[depth_ - 1];
      if (division.index >= division.count) {
        --depth_;
        continue;
      }
      const auto i = static_cast<std::int32_t>(division.index);
      division.index += depth_ == 1 ? shares : 1;
      const Vec3i &n = division.log2, &rest = division.parts.log2, &first = division.parts.first;
      const Vec3i at{first.x + ((i & ((1 << n.x) - 1)) << rest.x),
                     first.y + ((i >> n.x & ((1 << n.y) - 1)) << rest.y),
                     first.z + ((i >> (n.x + n.y)) << rest.z)};
      if (!enters(read_once(grid_.voxel_map[division.offset + static_cast<std::uint32_t>(i)]), {at, rest}))
        return false;
    }
    return true;
  }
  // The words that it has looked at.
  MASU_HD std::uint64_t words() const { return words_; }

private:
  struct Division {
    std::uint32_t offset, index, count;
    Vec3i log2;
    Part parts; // the first of them
  };
  // Each division halves a box's side at least once.
  static constexpr int max_depth = 3 * 15;

  // A word that names a cell: whether the cell holds the box.
  MASU_HD bool is_cell_of(std::uint32_t number, const Part& part) const {
    if (number >= grid_.cell_count) return false;
    const MergedCell cell = grid_.cells[number];
    const Vec3i &first = part.first,
                end{first.x + (1 << part.log2.x), first.y + (1 << part.log2.y), first.z + (1 << part.log2.z)};
    // One branch for all: whatever is too small has its sign bit set.
    return ((first.x - first_of(cell.x)) | (end_of(cell.x) - end.x) | (first.y - first_of(cell.y)) |
            (end_of(cell.y) - end.y) | (first.z - first_of(cell.z)) | (end_of(cell.z) - end.z)) >= 0;
  }

  MASU_HD bool enters(std::uint32_t word, const Part& part) {
    if ((word & occupied_bit) != 0) return is_cell_of(word & ~occupied_bit, part);
    const MapDivision division = map_division(word);
    const Vec3i &n = division.log2, rest = part.log2 - n;
    const std::uint32_t count = 1U << (n.x + n.y + n.z);
    words_ += count;
    if (rest.x < 0 || rest.y < 0 || rest.z < 0 || count < 2 ||
        std::uint64_t{division.offset} + count > grid_.words || words_ > grid_.words || depth_ == max_depth)
      return false;
    stack_[depth_++] = {division.offset, 0, count, n, {part.first, rest}};
    return true;
  }

  const StructureRecords& grid_;
  std::uint64_t words_ = 0;
  int depth_ = 0;
  Division stack_[max_depth];
};

template <class Checker>
const char* fault_of_merged(const Checker& checker, const StructureRecords& grid) {
  const Vec3i finest{grid.layout.division.x << grid.nested_log2, grid.layout.division.y << grid.nested_log2,
                     grid.layout.division.z << grid.nested_log2};
  if (!(grid.cell_count <= max_numbered && checker.all(grid.cell_count, [=] MASU_PASS(std::uint64_t i) {
        const MergedCell cell = grid.cells[i];
        return (cell.list == empty_list || cell.list < grid.reference_count) && end_of(cell.x) <= finest.x &&
               end_of(cell.y) <= finest.y && end_of(cell.z) <= finest.z;
      })))
    return "its cells leave the space, or name a list that isn't there";
  if (!lists_are_separate(checker, grid, grid.cell_count,
                          [=] MASU_PASS(std::uint64_t i) { return read_once(grid.cells[i].list); }))
    return "its cells share lists";
  // No word belongs to two voxels of the top level, or a small map could take for ever.
  auto total = checker.zeros(1);
  std::uint32_t* const looked_at = total.data();
  // Enough threads for a GPU, also where few voxels are divided far.
  constexpr std::uint64_t threads_wanted = 1 << 18, most_shares = 4096;
  const std::uint64_t voxels = voxel_count(grid.layout.division);
  const auto shares =
      static_cast<std::uint32_t>(std::min(std::max<std::uint64_t>(threads_wanted / voxels, 1), most_shares));
  const bool leads_to_cells = checker.all(voxels * shares, [=] MASU_PASS(std::uint64_t thread) {
    const std::uint64_t i = thread / shares;
    const auto x = static_cast<std::uint64_t>(grid.layout.division.x),
               y = static_cast<std::uint64_t>(grid.layout.division.y);
    const std::int32_t side = grid.nested_log2;
    const Vec3i first{static_cast<std::int32_t>(i % x) << side, static_cast<std::int32_t>(i / x % y) << side,
                      static_cast<std::int32_t>(i / x / y) << side};
    MapCheck map(grid);
    if (!map.is_good(read_once(grid.voxel_map[i]), {first, {side, side, side}},
                     static_cast<std::uint32_t>(thread % shares), shares))
      return false;
    const auto words = static_cast<std::uint32_t>(map.words());
    return words == 0 || std::uint64_t{added(*looked_at, words)} + words <= grid.words;
  });
  return leads_to_cells ? nullptr : "its voxel map doesn't lead to its cells";
}

// Whether a slot of a node holds nothing, or references that are there.
MASU_HD inline bool holds_references(std::uint32_t held, std::uint64_t first_reference,
                                     std::uint64_t references) {
  if (held == 0) return true;
  const std::uint32_t unary = held >> 5, end = references_begin(held) + references_in(held);
  return (unary == 1 || unary == 3 || unary == 7) && end <= max_references_per_node &&
         first_reference + end <= references;
}

// Whether the references of a node are there, its slots are what its mask of nodes says, and each names its
// own node. Any planes are good: they only say what is visited.
MASU_HD inline bool is_good_node(const HierarchyNode& node, std::uint64_t references) {
  for (const float origin : node.origin)
    if (!(origin - origin == 0)) return false; // not finite
  for (int slot = 0; slot < boxes_per_node; ++slot) {
    const std::uint32_t held = slot_byte(node.slots, slot);
    const bool is_node = (node_slots(node) >> slot & 1) != 0;
    if (is_node ? held != (node_slot | static_cast<std::uint32_t>(slot))
                : !holds_references(held, node.first_reference, references))
      return false;
  }
  return true;
}

// Whether each node but the first has one parent, which comes before it, and none lies deeper than a walk's
// stack allows: so every walk ends.
template <class Checker>
bool is_tree(const Checker& checker, const StructureRecords& grid) {
  auto parent_array = checker.zeros(grid.node_count); // plus one
  std::uint32_t* const parents = parent_array.data();
  return checker.all(grid.node_count, [=] MASU_PASS(std::uint64_t i) {
    const std::uint32_t first = read_once(grid.nodes[i].first_node);
    std::uint32_t slots = read_once(grid.nodes[i].exponents) >> 24;
    for (std::uint64_t child = first; slots != 0; slots &= slots - 1, ++child)
      if (child <= i || child >= grid.node_count ||
          exchanged(parents[child], static_cast<std::uint32_t>(i + 1)) != 0)
        return false;
    return true;
  }) && checker.all(grid.node_count, [=] MASU_PASS(std::uint64_t i) {
    int depth = 1;
    for (std::uint64_t node = i; node != 0; node = parents[node] - 1)
      if (parents[node] == 0 || ++depth > max_hierarchy_depth) return false;
    return true;
  });
}

} // namespace checks

// What is wrong with the records, whose sizes fit the table; null: nothing.
template <class Checker>
const char* fault_of(const Checker& checker, const StructureRecords& grid) {
  // A hierarchy's references don't end lists.
  const std::uint32_t ignored = grid.is_hierarchy ? 0 : last_bit;
  if (!(grid.reference_count <= max_numbered &&
        checker.all(grid.reference_count, [=] MASU_PASS(std::uint64_t i) {
          const std::uint32_t reference = grid.references[i];
          return (reference & ~ignored) < grid.primitives &&
                 (i + 1 < grid.reference_count || (reference & ignored) == ignored);
        })))
    return "it lists a primitive that isn't there";
  if (!grid.is_hierarchy)
    return grid.is_merged ? checks::fault_of_merged(checker, grid) : checks::fault_of_uniform(checker, grid);
  if (!(grid.node_count <= max_numbered && checker.all(grid.node_count, [=] MASU_PASS(std::uint64_t i) {
        return checks::is_good_node(grid.nodes[i], grid.reference_count);
      })))
    return "its nodes name what isn't there";
  return checks::is_tree(checker, grid) ? nullptr : "its nodes aren't a tree, or too deep a one";
}

} // namespace masu
