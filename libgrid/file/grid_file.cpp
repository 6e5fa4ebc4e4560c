#include "libgrid/file/grid_file.h"

#include "libscene/error.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <array>
#include <atomic>
#include <bit>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

namespace masu {
namespace {

std::uint32_t number(fb::GridSection section) {
  return static_cast<std::uint32_t>(section);
}

std::span<const fb::Section> section_list(const fb::Grid& table) {
  const auto* const sections = table.sections();
  return {reinterpret_cast<const fb::Section*>(sections->Data()), sections->size()};
}

std::vector<std::uint8_t> grid_table(const Grid& grid, const GridOrigin& origin,
                                     const std::vector<fb::Section>& section_layout) {
  flatbuffers::FlatBufferBuilder builder;
  const auto sections = builder.CreateVectorOfStructs(section_layout);
  const auto rule = builder.CreateString(origin.division_rule);
  const auto merge_rule = builder.CreateString(origin.merge_rule);
  const fb::Hash geometry_hash(origin.geometry_hash.low, origin.geometry_hash.high);
  const Boxd& s = grid.layout.space;
  const fb::Box space({s.min.x, s.min.y, s.min.z}, {s.max.x, s.max.y, s.max.z});
  const Vec3<std::uint32_t> n = cast<std::uint32_t>(grid.layout.division);
  const fb::Division division(n.x, n.y, n.z);
  builder.Finish(fb::CreateGrid(
      builder, &geometry_hash, origin.primitives, &space, grid.layout.margin, &division,
      static_cast<std::uint32_t>(grid.block_log2), static_cast<std::uint32_t>(grid.nested_log2),
      origin.space_rule == SpaceRule::cube ? fb::Space::cube : fb::Space::tight,
      origin.overlap == Overlap::exact ? fb::Overlap::exact : fb::Overlap::box,
      static_cast<fb::Merge>(grid.kind), rule, merge_rule, origin.build_seconds, sections));
  return {builder.GetBufferPointer(), builder.GetBufferPointer() + builder.GetSize()};
}

// In parallel, so many at a time.
template <class Good>
bool all(std::uint64_t count, const Good& good, std::uint64_t grain = 1 << 16) {
  return tbb::parallel_reduce(
      tbb::blocked_range<std::uint64_t>(0, count, grain), true,
      [&](const tbb::blocked_range<std::uint64_t>& range, bool so_far) {
        for (std::uint64_t i = range.begin(); so_far && i != range.end(); ++i)
          so_far = good(i);
        return so_far;
      },
      std::logical_and<>());
}

Vec3d vector_of(const fb::Vec3& v) {
  return {v.x(), v.y(), v.z()};
}

// A space that can be divided: finite, and with sides whose inverses are.
bool is_divisible(const fb::Box& space) {
  const Vec3d low = vector_of(space.min()), high = vector_of(space.max());
  for (int axis = 0; axis < 3; ++axis) {
    if (!(std::isfinite(low[axis]) && std::isfinite(high[axis]) && high[axis] - low[axis] >= 1e-300 &&
          high[axis] - low[axis] <= 1e300))
      return false;
  }
  return true;
}

template <class Real>
GridView<Real> view_of(const GridLayout& layout, std::int32_t block_log2,
                       std::span<const std::uint32_t> voxel_map, std::span<const PrimitiveIndex> references) {
  const Vec3d size = voxel_size(layout);
  return {voxel_map.data(),
          references.data(),
          cast<Real>(layout.space.min),
          cast<Real>(size),
          cast<Real>(Vec3d{1 / size.x, 1 / size.y, 1 / size.z}),
          layout.division,
          blocks_of(layout.division, block_log2),
          block_log2};
}

template <class Real>
MergedGridView<Real> view_of(const GridLayout& layout, std::int32_t nested_log2,
                             std::span<const std::uint32_t> voxel_map, std::span<const MergedCell> cells,
                             std::span<const PrimitiveIndex> references) {
  const GridLayout finest = finer(layout, nested_log2);
  const Vec3d size = voxel_size(finest);
  return {voxel_map.data(),  cells.data(),
          references.data(), cast<Real>(finest.space.min),
          cast<Real>(size),  cast<Real>(Vec3d{1 / size.x, 1 / size.y, 1 / size.z}),
          finest.division,   layout.division,
          nested_log2};
}

// Whether each cell's list, list(i) or empty_list, begins where a list does, behind those of the cells
// before.
template <class List>
bool lists_are_in_order(std::uint64_t cells, const List& list, std::span<const PrimitiveIndex> references) {
  struct Run {
    std::uint64_t first = std::uint64_t{1} << 32, end = 0; // of the lists' beginnings; empty
    bool is_good = true;
  };
  const auto joined = [](const Run& a, const Run& b) {
    return Run{std::min(a.first, b.first), std::max(a.end, b.end),
               a.is_good && b.is_good && a.end <= b.first};
  };
  return tbb::parallel_reduce(
             tbb::blocked_range<std::uint64_t>(0, cells, 1 << 16), Run{},
             [&](const tbb::blocked_range<std::uint64_t>& range, Run run) {
               for (std::uint64_t i = range.begin(); run.is_good && i != range.end(); ++i) {
                 const std::uint64_t begin = list(i);
                 if (begin == empty_list) continue;
                 run.is_good = begin >= run.end && (begin == 0 || (references[begin - 1] & last_bit) != 0);
                 run.first = std::min(run.first, begin);
                 run.end = begin + 1;
               }
               return run;
             },
             joined)
      .is_good;
}

// Whether the cells' lists have no more references together than there are, as where each list belongs to one
// cell. So a ray, which meets a cell once, tests no more primitives than the file has references. If many
// cells shared a long list, a small file could take for ever to trace. All lists must end.
template <class List>
bool lists_are_short(std::uint64_t cells, const List& list, std::span<const PrimitiveIndex> references) {
  if (lists_are_in_order(cells, list, references)) return true; // the builders' are, which is soon found out
  constexpr std::uint64_t batch = 1 << 12;
  std::atomic<std::uint64_t> total = 0;
  return tbb::parallel_reduce(
      tbb::blocked_range<std::uint64_t>(0, cells, 1 << 14), true,
      [&](const tbb::blocked_range<std::uint64_t>& range, bool so_far) {
        std::uint64_t sum = 0;
        for (std::uint64_t i = range.begin(); so_far && i != range.end(); ++i) {
          std::uint64_t at = list(i);
          if (at == empty_list) continue;
          for (++sum; (references[at] & last_bit) == 0; ++at)
            ++sum;
          if (sum > batch) so_far = (total += std::exchange(sum, 0)) <= references.size();
        }
        return so_far && (total += sum) <= references.size();
      },
      std::logical_and<>());
}

// A merged grid's map, checked word by word: every voxel leads to a cell whose box it is in. No word is on
// the way to two cubes, or a small map could take for ever.
class MapCheck {
public:
  explicit MapCheck(const MergedGridView<double>& grid, std::uint64_t words, std::uint64_t cells)
      : grid_(grid), words_(words), cells_(cells) {}

  bool top_level_good() {
    return all(
        voxel_count(grid_.top),
        [&](std::uint64_t i) {
          const auto x = static_cast<std::uint32_t>(grid_.top.x), y = static_cast<std::uint32_t>(grid_.top.y);
          const Vec3<std::uint32_t> cube{static_cast<std::uint32_t>(i % x),
                                         static_cast<std::uint32_t>(i / x % y),
                                         static_cast<std::uint32_t>(i / x / y)};
          const Vec3i at = cast<std::int32_t>(cube);
          std::uint64_t nested = 0;
          const Vec3i side{grid_.nested_log2, grid_.nested_log2, grid_.nested_log2};
          return is_good(grid_.voxel_map[i], {{at.x << side.x, at.y << side.y, at.z << side.z}, side},
                         nested) &&
                 (nested == 0 || (nested_ += nested) <= words_);
        },
        256);
  }

private:
  // The box of 2^log2 voxels along each axis at `first`.
  struct Place {
    Vec3i first, log2;
  };

  // A word that ends here: the cell it names holds the box.
  bool leads_home(std::uint32_t number, const Vec3i& first, const Vec3i& end) const {
    if (number >= cells_) return false;
    const MergedCell& cell = grid_.cells[number];
    // One branch for all: whatever is too small has its sign bit set.
    return ((first.x - first_of(cell.x)) | (end_of(cell.x) - end.x) | (first.y - first_of(cell.y)) |
            (end_of(cell.y) - end.y) | (first.z - first_of(cell.z)) | (end_of(cell.z) - end.z)) >= 0;
  }

  // Each division makes the box smaller, so this ends. Adds to `nested` how many words it looks at.
  bool is_good(std::uint32_t word, const Place& place, std::uint64_t& nested) const {
    if ((word & occupied_bit) != 0) {
      const Vec3i size{1 << place.log2.x, 1 << place.log2.y, 1 << place.log2.z};
      return leads_home(word & ~occupied_bit, place.first, place.first + size);
    }
    const MapDivision division = map_division(word);
    const Vec3i rest = place.log2 - division.log2, &n = division.log2;
    const std::uint64_t count = std::uint64_t{1} << (n.x + n.y + n.z);
    nested += count;
    if (rest.x < 0 || rest.y < 0 || rest.z < 0 || count < 2 || division.offset + count > words_ ||
        nested > words_)
      return false;
    const std::uint32_t* next = grid_.voxel_map + division.offset;
    const Vec3i step{1 << rest.x, 1 << rest.y, 1 << rest.z},
        end{place.first.x + (step.x << n.x), place.first.y + (step.y << n.y),
            place.first.z + (step.z << n.z)};
    Vec3i at{};
    for (at.z = place.first.z; at.z != end.z; at.z += step.z) {
      for (at.y = place.first.y; at.y != end.y; at.y += step.y) {
        for (at.x = place.first.x; at.x != end.x; at.x += step.x) {
          const std::uint32_t part = *next++;
          const bool good = (part & occupied_bit) != 0 ? leads_home(part & ~occupied_bit, at, at + step)
                                                       : is_good(part, {at, rest}, nested);
          if (!good) return false;
        }
      }
    }
    return true;
  }

  const MergedGridView<double> grid_;
  std::uint64_t words_, cells_;
  std::atomic<std::uint64_t> nested_ = 0;
};

// Whether a slot holds nothing, or references that are there.
bool holds_references(std::uint32_t held, std::uint64_t first_reference, std::uint64_t references) {
  if (held == 0) return true;
  const std::uint32_t unary = held >> 5, end = references_begin(held) + std::bit_width(unary);
  return (unary == 1 || unary == 3 || unary == 7) && end <= max_references_a_node &&
         first_reference + end <= references;
}

// Whether the references of a node are there, its slots are what its mask of nodes says, and it names no
// place in it but its own. Any planes are good: they only say what is visited.
bool is_good_node(const HierarchyNode& node, std::uint64_t references) {
  for (const float origin : node.origin)
    if (!std::isfinite(origin)) return false;
  for (int slot = 0; slot < boxes_a_node; ++slot) {
    const std::uint32_t held = slot_byte(node.slots, slot);
    const bool is_node = (node_slots(node) >> slot & 1) != 0;
    if (is_node ? held != (node_slot | static_cast<std::uint32_t>(slot))
                : !holds_references(held, node.first_reference, references))
      return false;
  }
  return true;
}

// Whether nodes come depth first, each in one place alone, and no deeper than the walk's stack allows: so
// every walk ends.
bool is_depth_first(std::span<const HierarchyNode> nodes) {
  struct Siblings {
    std::uint64_t next, end;
  };
  std::array<Siblings, max_hierarchy_depth> path{};
  std::size_t depth = 1;
  path[0] = {0, 1};
  std::uint64_t met = 1; // nodes whose place is known
  while (depth > 0) {
    Siblings& siblings = path[depth - 1];
    if (siblings.next == siblings.end) {
      --depth;
      continue;
    }
    const HierarchyNode& node = nodes[siblings.next++];
    const auto held = static_cast<std::uint64_t>(std::popcount(node_slots(node)));
    if (held == 0) continue;
    if (node.first_node != met || held > nodes.size() - met || depth == max_hierarchy_depth) return false;
    path[depth++] = {met, met + held};
    met += held;
  }
  return met == nodes.size();
}

} // namespace

void write_grid(const Grid& grid, const GridOrigin& origin, const std::string& path) {
  const std::array sections{
      section_data(number(fb::GridSection::voxel_map), std::span(grid.voxel_map)),
      section_data(number(fb::GridSection::cells), std::span(grid.cells)),
      section_data(number(fb::GridSection::references), std::span(grid.references)),
      section_data(number(fb::GridSection::nodes), std::span(grid.nodes)),
  };
  const auto section_layout = lay_out(sections);
  write_container(path, grid_file_kind, grid_table(grid, origin, section_layout), sections, section_layout);
}

GridFile::GridFile(const std::string& path, Checks checks) : GridFile(path, checks, Stopwatch()) {}

GridFile::GridFile(const std::string& path, Checks checks, const Stopwatch& watch)
    : container_(path, grid_file_kind) {
  seconds_.map = watch.seconds();
  const auto bytes = container_.table();
  flatbuffers::Verifier verifier(bytes.data(), bytes.size());
  check(fb::VerifyGridBuffer(verifier), "its table is damaged");
  table_ = fb::GetGrid(bytes.data());
  const auto axis_good = [](std::uint32_t voxels) { return voxels >= 1 && voxels <= largest_division; };
  const fb::Division& n = *table_->division();
  check(axis_good(n.x()) && axis_good(n.y()) && axis_good(n.z()), "its division is impossible");
  check(is_divisible(*table_->space()), "its space is impossible");
  check(table_->block_log2() <= 5, "its blocks are impossible");
  check(is_aligned(section_list(*table_)), "its table is damaged");
  container_.read_sections(section_list(*table_));
  check_sizes();
  if (checks == Checks::all) {
    check_records();
    is_checked_ = true;
  }
  seconds_.validate = watch.seconds() - seconds_.map;
}

void GridFile::check(bool good, const char* what) const {
  if (!good) throw_damaged(path(), what);
}

void GridFile::check_sizes() const {
  const std::uint64_t words = voxel_map().size();
  const Vec3i n = layout().division;
  bool good = false;
  check(table_->merge() <= fb::Merge::MAX, "its cells are merged in an unknown way");
  if (is_hierarchy()) {
    check(!nodes().empty() && words == 0 && cells().empty() && voxel_count(n) == 1, "it has no hierarchy");
    return;
  }
  check(nodes().empty(), "its table is damaged");
  if (is_merged()) {
    const auto nested_log2 = table_->nested_log2();
    good = nested_log2 <= 15 && (std::max({n.x, n.y, n.z}) << nested_log2) <= largest_division &&
           words >= voxel_count(n) && words <= max_numbered + 1;
  } else {
    const auto block_log2 = static_cast<std::int32_t>(table_->block_log2());
    const std::uint64_t blocks = voxel_count(blocks_of(n, block_log2));
    good = words >= blocks && (words - blocks) % (std::uint64_t{1} << (3 * block_log2)) == 0 &&
           (block_log2 > 0 || words == blocks);
  }
  check(good, "its voxel map has the wrong size");
}

void GridFile::check_records() const {
  const std::uint64_t primitives = table_->primitives();
  const auto listed = references();
  if (is_hierarchy()) {
    check(listed.size() <= max_numbered &&
              all(listed.size(), [&](std::uint64_t i) { return listed[i] < primitives; }),
          "it lists a primitive that isn't there");
    return check_hierarchy();
  }
  check(listed.size() <= max_numbered && (listed.empty() || (listed.back() & last_bit) != 0) &&
            all(listed.size(), [&](std::uint64_t i) { return (listed[i] & ~last_bit) < primitives; }),
        "it lists a primitive that isn't there");
  is_merged() ? check_merged() : check_uniform();
}

void GridFile::check_uniform() const {
  const auto map = voxel_map();
  const auto block_log2 = static_cast<std::int32_t>(table_->block_log2());
  const std::uint64_t blocks = voxel_count(blocks_of(layout().division, block_log2));
  const std::uint64_t block_maps = (map.size() - blocks) >> (3 * block_log2), lists = references().size();
  check(all(map.size(),
            [&](std::uint64_t i) {
              const std::uint64_t limit = block_log2 > 0 && i < blocks ? block_maps : lists;
              return (map[i] & occupied_bit) != 0 ? (map[i] & ~occupied_bit) < limit : map[i] == 0;
            }),
        "its voxel map names a list that isn't there");
  const std::uint64_t first = block_log2 > 0 ? blocks : 0;
  std::vector<std::atomic<bool>> is_used(block_log2 > 0 ? block_maps : 0);
  check(all(first,
            [&](std::uint64_t i) {
              return (map[i] & occupied_bit) == 0 || !is_used[map[i] & ~occupied_bit].exchange(true);
            }),
        "its blocks share maps");
  check(lists_are_short(
            map.size() - first,
            [&](std::uint64_t i) {
              const std::uint32_t word = map[first + i];
              return (word & occupied_bit) != 0 ? word & ~occupied_bit : empty_list;
            },
            references()),
        "its voxels share lists");
}

void GridFile::check_merged() const {
  const auto boxes = cells();
  const auto finest = cast<std::uint32_t>(merged_view<double>().division);
  const std::uint64_t lists = references().size();
  check(boxes.size() <= max_numbered && all(boxes.size(),
                                            [&](std::uint64_t i) {
                                              const MergedCell& cell = boxes[i];
                                              return (cell.list == empty_list || cell.list < lists) &&
                                                     (cell.x >> 16) <= finest.x &&
                                                     (cell.y >> 16) <= finest.y && (cell.z >> 16) <= finest.z;
                                            }),
        "its cells leave the space, or name a list that isn't there");
  check(lists_are_short(
            boxes.size(), [&](std::uint64_t i) { return boxes[i].list; }, references()),
        "its cells share lists");
  check(MapCheck(merged_view<double>(), voxel_map().size(), boxes.size()).top_level_good(),
        "its voxel map leads astray");
}

void GridFile::check_hierarchy() const {
  const auto all_nodes = nodes();
  const std::uint64_t lists = references().size();
  check(all_nodes.size() <= max_numbered &&
            all(all_nodes.size(), [&](std::uint64_t i) { return is_good_node(all_nodes[i], lists); }),
        "its nodes name what isn't there");
  check(is_depth_first(all_nodes), "its nodes lead astray");
}

GridLayout GridFile::layout() const {
  const fb::Division& n = *table_->division();
  return {{vector_of(table_->space()->min()), vector_of(table_->space()->max())},
          cast<std::int32_t>(Vec3<std::uint32_t>{n.x(), n.y(), n.z()}),
          table_->margin()};
}

std::span<const std::uint32_t> GridFile::voxel_map() const {
  return container_.records<std::uint32_t>(section_list(*table_), number(fb::GridSection::voxel_map));
}
std::span<const MergedCell> GridFile::cells() const {
  return container_.records<MergedCell>(section_list(*table_), number(fb::GridSection::cells));
}
std::span<const PrimitiveIndex> GridFile::references() const {
  return container_.records<PrimitiveIndex>(section_list(*table_), number(fb::GridSection::references));
}

std::span<const HierarchyNode> GridFile::nodes() const {
  return container_.records<HierarchyNode>(section_list(*table_), number(fb::GridSection::nodes));
}

void GridFile::check_geometry(const Hash& geometry_hash, std::uint64_t primitives) const {
  const fb::Hash& built_from = *table_->geometry_hash();
  if (Hash{built_from.low(), built_from.high()} != geometry_hash || table_->primitives() != primitives)
    throw Error(ErrorCode::input, path(), "was built from another geometry: build it again with gridbuild");
}

template <class Real>
GridView<Real> GridFile::view() const {
  return view_of<Real>(layout(), static_cast<std::int32_t>(table_->block_log2()), voxel_map(), references());
}
template GridView<float> GridFile::view() const;
template GridView<double> GridFile::view() const;

template <class Real>
MergedGridView<Real> GridFile::merged_view() const {
  return view_of<Real>(layout(), static_cast<std::int32_t>(table_->nested_log2()), voxel_map(), cells(),
                       references());
}
template MergedGridView<float> GridFile::merged_view() const;
template MergedGridView<double> GridFile::merged_view() const;

template <class Real>
GridView<Real> view_of(const Grid& grid) {
  return view_of<Real>(grid.layout, grid.block_log2, grid.voxel_map, grid.references);
}
template GridView<float> view_of(const Grid&);
template GridView<double> view_of(const Grid&);

template <class Real>
MergedGridView<Real> merged_view_of(const Grid& grid) {
  return view_of<Real>(grid.layout, grid.nested_log2, grid.voxel_map, grid.cells, grid.references);
}
template MergedGridView<float> merged_view_of(const Grid&);
template MergedGridView<double> merged_view_of(const Grid&);

} // namespace masu
