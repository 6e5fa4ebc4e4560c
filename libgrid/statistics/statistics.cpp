#include "libgrid/statistics/statistics.h"

#include "libgrid/file/structure_file.h"
#include "libgrid/structure/builder.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace masu {
namespace {

void describe(GridStatistics& statistics) {
  const std::vector<std::uint64_t>& histogram = statistics.histogram;
  const auto cells = static_cast<double>(statistics.occupied_cells);
  if (statistics.occupied_cells == 0) return;
  statistics.mean = static_cast<double>(statistics.references) / cells;
  double squares = 0;
  for (std::size_t n = 0; n < histogram.size(); ++n) {
    const double off = static_cast<double>(n) - statistics.mean;
    squares += off * off * static_cast<double>(histogram[n]);
  }
  statistics.stddev = std::sqrt(squares / cells);
  // The rank-th smallest, from 0.
  const auto at_rank = [&](std::uint64_t rank) {
    std::uint64_t seen = 0;
    std::size_t n = 0;
    while (n + 1 < histogram.size() && (seen += histogram[n]) <= rank)
      ++n;
    return static_cast<std::uint64_t>(n);
  };
  const std::uint64_t last = statistics.occupied_cells - 1;
  statistics.median = static_cast<double>(at_rank(last / 2) + at_rank((last + 1) / 2)) / 2;
  statistics.p99 = at_rank(static_cast<std::uint64_t>(std::ceil(0.99 * cells)) - 1);
  statistics.min = at_rank(0);
  statistics.max = histogram.size() - 1;
}

void count(std::vector<std::uint64_t>& counts, std::size_t number) {
  if (number >= counts.size()) counts.resize(number + 1, 0);
  ++counts[number];
}

// act(word, first voxel of its box, the box's sides as powers of two, level) for a word of a merged grid's
// map and all that it leads to.
template <class Act>
void for_each_word_from(const MergedGridView<double>& grid, std::uint32_t word, const Vec3i& first,
                        const Vec3i& sides_log2, std::size_t level, const Act& act) {
  act(word, first, sides_log2, level);
  if ((word & occupied_bit) != 0) return;
  const MapDivision division = map_division(word);
  const Vec3i n = division.log2, rest = sides_log2 - n;
  for_each_voxel({{0, 0, 0}, {(1 << n.x) - 1, (1 << n.y) - 1, (1 << n.z) - 1}}, [&](const Vec3i& part) {
    for_each_word_from(
        grid, grid.voxel_map[division.offset + index_in_division(part, n)],
        {first.x + (part.x << rest.x), first.y + (part.y << rest.y), first.z + (part.z << rest.z)}, rest,
        level + 1, act);
  });
}
template <class Act>
void for_each_word(const MergedGridView<double>& grid, const Act& act) {
  const std::int32_t log2 = grid.nested_log2;
  for_each_voxel({{0, 0, 0}, grid.top - Vec3i{1, 1, 1}}, [&](const Vec3i& at) {
    for_each_word_from(grid, grid.voxel_map[linear_index(at, grid.top)],
                       {at.x << log2, at.y << log2, at.z << log2}, {log2, log2, log2}, 0, act);
  });
}

std::uint64_t voxels_of(const Vec3i& sides_log2) {
  return std::uint64_t{1} << (sides_log2.x + sides_log2.y + sides_log2.z);
}

// Half the surface of the box around those in slots first … end - 1 of a node.
double area_of(const HierarchyNode& node, int first, int end) {
  Vec3d side{};
  for (int axis = 0; axis < 3; ++axis) {
    std::uint32_t low = 255, high = 0;
    for (int slot = first; slot < end; ++slot) {
      if (slot_byte(node.slots, slot) == 0) continue;
      low = std::min(low, slot_byte(node.low[axis], slot));
      high = std::max(high, slot_byte(node.high[axis], slot));
    }
    const double unit = std::ldexp(1.0, static_cast<int>(node.exponents >> (8 * axis) & 0xff) - 127);
    side.set(axis, unit * (static_cast<double>(high) - low));
  }
  return side.x * (side.y + side.z) + side.y * side.z;
}

} // namespace

GridStatistics grid_statistics(std::uint64_t cells, std::span<const PrimitiveIndex> references) {
  GridStatistics statistics{.cells = cells, .references = references.size()};
  for (std::size_t first = 0, i = 0; i < references.size(); ++i) {
    if ((references[i] & last_bit) == 0) continue;
    count(statistics.histogram, i + 1 - first);
    ++statistics.occupied_cells;
    first = i + 1;
  }
  describe(statistics);
  return statistics;
}

std::vector<OwnVoxels> own_voxels(const MergedGridView<double>& grid, std::span<const MergedCell> cells) {
  std::vector<OwnVoxels> all(cells.size());
  for_each_word(grid, [&](std::uint32_t word, const Vec3i& first, const Vec3i& sides_log2, std::size_t) {
    if ((word & occupied_bit) == 0) return;
    OwnVoxels& own = all[word & ~occupied_bit];
    own.voxels += voxels_of(sides_log2);
    for (int axis = 0; axis < 3; ++axis) {
      own.box.first.set(axis, std::min(own.box.first[axis], first[axis]));
      own.box.end.set(axis, std::max(own.box.end[axis], first[axis] + (1 << sides_log2[axis])));
    }
  });
  return all;
}

MapStatistics map_statistics(const MergedGridView<double>& grid, std::span<const MergedCell> cells) {
  MapStatistics statistics;
  statistics.voxels = voxel_count(grid.division);

  double loads = 0;
  for_each_word(grid, [&](std::uint32_t, const Vec3i&, const Vec3i& sides_log2, std::size_t level) {
    count(statistics.words, level);
    loads += static_cast<double>(voxels_of(sides_log2)); // a sum of integers: exact
  });
  statistics.loads = loads / static_cast<double>(statistics.voxels);

  const std::vector<OwnVoxels> own = own_voxels(grid, cells);
  double log_expansion = 0, visited = 0, tested = 0;
  std::uint64_t reached = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (own[i].voxels == 0) continue;
    ++reached;
    if (cells[i].list != empty_list) statistics.occupied_voxels += own[i].voxels;
    count(statistics.cells_by_size, static_cast<std::size_t>(std::bit_width(own[i].voxels)) - 1);
    const VoxelBox box = box_of(cells[i]);
    const double factor =
        static_cast<double>(voxel_count(box.end - box.first)) / static_cast<double>(own[i].voxels);
    log_expansion += std::log(factor);
    if (factor > 1) ++statistics.expanded_cells;
    const double area = half_area(cast<double>(own[i].box.end - own[i].box.first) * grid.voxel_size);
    visited += area;
    tested += area * references_of(grid.references, cells[i].list);
  }
  statistics.mean_expansion =
      std::exp(log_expansion / static_cast<double>(std::max<std::uint64_t>(reached, 1)));
  const Vec3d space = cast<double>(grid.division) * grid.voxel_size;
  const double cells_met = visited / half_area(space);
  statistics.ray = {cells_met, tested / half_area(space), expected_voxels(grid.division, space) - cells_met};
  return statistics;
}

MapStatistics map_statistics(const GridView<double>& grid, std::span<const PrimitiveIndex> references) {
  MapStatistics statistics;
  statistics.voxels = voxel_count(grid.division);
  statistics.occupied_voxels = static_cast<std::uint64_t>(
      std::count_if(references.begin(), references.end(), [](auto r) { return (r & last_bit) != 0; }));
  statistics.words = {voxel_count(grid.blocks)};
  const Vec3d space = cast<double>(grid.division) * grid.voxel_size;

  std::uint64_t in_block_maps = 0;
  double skipped = 0;
  const int log2 = grid.block_log2;
  if (log2 > 0) {
    statistics.words.resize(2, 0);
    for_each_voxel({{0, 0, 0}, grid.blocks - Vec3i{1, 1, 1}}, [&](const Vec3i& block) {
      Vec3i n{};
      for (int axis = 0; axis < 3; ++axis)
        n.set(axis, std::min(1 << log2, grid.division[axis] - (block[axis] << log2)));
      if ((grid.voxel_map[linear_index(block, grid.blocks)] & occupied_bit) != 0) {
        statistics.words[1] += std::uint64_t{1} << (3 * log2);
        in_block_maps += voxel_count(n);
      } else {
        const Vec3d sides = cast<double>(n) * grid.voxel_size;
        skipped += (expected_voxels(n, sides) - 1) * half_area(sides) / half_area(space);
      }
    });
  }
  statistics.loads = 1 + static_cast<double>(in_block_maps) / static_cast<double>(statistics.voxels);
  statistics.ray = {expected_voxels(grid.division, space) - skipped,
                    static_cast<double>(references.size()) * half_area(grid.voxel_size) / half_area(space),
                    skipped};
  return statistics;
}

template <class Stored>
std::uint64_t occupied_voxels(const SceneView<Stored>& scene, const GridLayout& layout, Overlap overlap) {
  const Structure grid = build_structure(scene, layout, overlap);
  return grid_statistics(voxel_count(layout.division), grid.references).occupied_cells;
}
template std::uint64_t occupied_voxels(const SceneView<float>&, const GridLayout&, Overlap);
template std::uint64_t occupied_voxels(const SceneView<double>&, const GridLayout&, Overlap);

template <class Stored>
std::uint64_t occupied_half_open(const SceneView<Stored>& scene, const GridLayout& layout) {
  const Vec3d size = voxel_size(layout);
  std::vector<bool> occupied(voxel_count(layout.division), false);
  const auto voxel_at = [&](const Vec3d& at) {
    Vec3i voxel{};
    for (int axis = 0; axis < 3; ++axis) {
      const double number = std::floor((at[axis] - layout.space.min[axis]) / size[axis]);
      voxel.set(axis, static_cast<std::int32_t>(std::clamp(number, 0.0, layout.division[axis] - 1.0)));
    }
    return voxel;
  };
  for (PrimitiveIndex i = 0; i < scene.primitive_count(); ++i)
    with_primitive(scene, i, [&](const auto& primitive) {
      const Boxd box = box_for_overlap(primitive);
      for_each_voxel({voxel_at(box.min), voxel_at(box.max)},
                     [&](const Vec3i& voxel) { occupied[linear_index(voxel, layout.division)] = true; });
    });
  return static_cast<std::uint64_t>(std::count(occupied.begin(), occupied.end(), true));
}
template std::uint64_t occupied_half_open(const SceneView<float>&, const GridLayout&);
template std::uint64_t occupied_half_open(const SceneView<double>&, const GridLayout&);

void for_each_box(std::span<const HierarchyNode> nodes, const std::function<void(const HierarchyBox&)>& act) {
  std::vector<std::uint8_t> depths(nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) { // a node's nodes come after it
    const HierarchyNode& node = nodes[i];
    auto next = static_cast<std::uint32_t>(node.first_node);
    for (int slot = 0; slot < boxes_per_node; ++slot) {
      const std::uint32_t byte = slot_byte(node.slots, slot);
      if (byte == 0) continue;
      const bool is_node = (node_slots(node) >> slot & 1) != 0;
      if (is_node) depths[next] = static_cast<std::uint8_t>(depths[i] + 1);
      act({static_cast<std::uint32_t>(i), slot, depths[i], is_node ? 0 : references_in(byte),
           is_node ? next++ : 0});
    }
  }
}

HierarchyStatistics hierarchy_statistics(std::span<const HierarchyNode> nodes) {
  HierarchyStatistics found;
  found.nodes = nodes.size();
  double visited = 0, tested = 0;
  const double root = area_of(nodes[0], 0, boxes_per_node);
  for_each_box(nodes, [&](const HierarchyBox& box) {
    const double area = area_of(nodes[box.node], box.slot, box.slot + 1);
    found.depth = std::max(found.depth, box.depth + 1);
    if (box.references == 0) {
      ++found.node_boxes;
      visited += area;
      return;
    }
    ++found.reference_boxes;
    found.references += box.references;
    tested += area * box.references;
    count(found.boxes_by_references, box.references);
    count(found.boxes_by_depth, static_cast<std::size_t>(box.depth));
  });
  const std::uint64_t boxes = found.node_boxes + found.reference_boxes;
  found.boxes_per_node = static_cast<double>(boxes) / static_cast<double>(nodes.size());
  if (boxes > 0 && root > 0) {
    found.nodes_per_ray = 1 + visited / root;
    found.tests_per_ray = tested / root;
  }
  return found;
}

} // namespace masu
