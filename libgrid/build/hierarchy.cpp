#include "libgrid/build/hierarchy.h"

#include "libgrid/build/clipped_bounds.h"
#include "libscene/error.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cmath>
#include <utility>

namespace masu {
namespace {

// x, y, z, and a lane that boxes ignore: min and max of all four take an instruction.
using Lanes = float __attribute__((vector_size(16)));

Lanes smaller(Lanes a, Lanes b) {
  return a < b ? a : b;
}
Lanes larger(Lanes a, Lanes b) {
  return a > b ? a : b;
}

struct LaneBox {
  Lanes low = {INFINITY, INFINITY, INFINITY, INFINITY};
  Lanes high = {-INFINITY, -INFINITY, -INFINITY, -INFINITY};

  void join(const LaneBox& other) {
    low = smaller(low, other.low);
    high = larger(high, other.high);
  }
  // Half of the surface: what SAH compares.
  float area() const {
    const Lanes side = high - low;
    return side[0] * (side[1] + side[2]) + side[1] * side[2];
  }
};

// The bounds of a primitive, or of a part of it, the margin included; its index is in a lane that boxes
// ignore.
struct Fragment {
  LaneBox box;

  PrimitiveIndex primitive() const { return bits_of(box.low[3]); }
  // Twice the centre.
  Lanes centre() const { return box.low + box.high; }
};

float rounded_down(double value) {
  const auto rounded = static_cast<float>(value);
  return rounded > value ? std::nextafter(rounded, -INFINITY) : rounded;
}
float rounded_up(double value) {
  return -rounded_down(-value);
}

Fragment fragment_of(const Boxd& bounds, double margin, PrimitiveIndex primitive) {
  const Boxd box = grown(bounds, margin);
  Fragment fragment;
  fragment.box.low =
      Lanes{rounded_down(box.min.x), rounded_down(box.min.y), rounded_down(box.min.z), float_of(primitive)};
  fragment.box.high = Lanes{rounded_up(box.max.x), rounded_up(box.max.y), rounded_up(box.max.z), 0};
  return fragment;
}

// With room for more.
template <class Stored>
HostArray<Fragment> fragments_of(const SceneView<Stored>& scene, double margin, std::size_t room) {
  HostArray<Fragment> fragments(scene.primitive_count() + room);
  tbb::parallel_for(tbb::blocked_range<std::uint32_t>(0, scene.primitive_count(), 4096),
                    [&](const auto& range) {
                      for (PrimitiveIndex i = range.begin(); i != range.end(); ++i) {
                        with_primitive(scene, i, [&](const auto& primitive) {
                          fragments[i] = fragment_of(bounds(primitive), margin, i);
                        });
                      }
                    });
  return fragments;
}

// --- The binary hierarchy
// ------------------------------------------------------------------------------------

// A leaf has one fragment; of others, so many are in it.
struct BinaryNode {
  LaneBox box;
  std::uint32_t first, count; // `first`: a leaf's fragment
  std::uint32_t left;         // the right one comes after it; 0 for a leaf
};

// Fragments that are in a node, and room for more after them.
struct FragmentRange {
  std::uint32_t first, count, room;
};

constexpr int most_bins = 32;

// What a bin holds. By centre: the fragments whose centres are in it, as many begin as end. By space: the
// parts in it of fragments, of which so many begin and end there.
struct Bin {
  LaneBox box;
  std::uint32_t begin = 0, end = 0;
};
struct Bins {
  std::array<std::array<Bin, most_bins>, 3> axes{};

  Bin& at(int axis, int bin) { return axes[static_cast<unsigned>(axis)][static_cast<unsigned>(bin)]; }
  const Bin& at(int axis, int bin) const {
    return axes[static_cast<unsigned>(axis)][static_cast<unsigned>(bin)];
  }
  void join(const Bins& other) {
    for (unsigned axis = 0; axis < 3; ++axis) {
      for (unsigned i = 0; i < most_bins; ++i) {
        axes[axis][i].box.join(other.axes[axis][i].box);
        axes[axis][i].begin += other.axes[axis][i].begin;
        axes[axis][i].end += other.axes[axis][i].end;
      }
    }
  }
};

// How a box is divided into bins along each axis.
struct Binning {
  Lanes low, unit, bins_per_unit{};
  int bins;

  // scale: of what is binned to the box's coordinates.
  Binning(const LaneBox& box, int bins_)
      : low(box.low), unit((box.high - box.low) / static_cast<float>(bins_)), bins(bins_) {
    for (int axis = 0; axis < 3; ++axis) {
      const float scale = static_cast<float>(bins) * 0.99999F / (box.high[axis] - box.low[axis]);
      bins_per_unit[axis] = box.high[axis] > box.low[axis] && std::isfinite(scale) ? scale : 0;
    }
  }
  int bin(const Lanes& place, int axis) const {
    return std::clamp(static_cast<int>((place[axis] - low[axis]) * bins_per_unit[axis]), 0, bins - 1);
  }
  // That ends a bin.
  float plane(int axis, int bin_) const { return low[axis] + unit[axis] * static_cast<float>(bin_ + 1); }
};

struct Split {
  float cost = INFINITY;
  int axis = -1; // none: everything is in one place
  int bin = 0;   // the last one that goes left
  LaneBox left, right;
};

Split best_split(const Bins& bins, int count) {
  Split best;
  for (int axis = 0; axis < 3; ++axis) {
    std::array<Bin, most_bins> right{}; // of all from a bin on
    Bin so_far;
    for (int i = count - 1; i > 0; --i) {
      so_far.box.join(bins.at(axis, i).box);
      so_far.end += bins.at(axis, i).end;
      right[static_cast<unsigned>(i)] = so_far;
    }
    Bin left;
    for (int i = 0; i + 1 < count; ++i) {
      left.box.join(bins.at(axis, i).box);
      left.begin += bins.at(axis, i).begin;
      const Bin& beyond = right[static_cast<unsigned>(i) + 1];
      if (left.begin == 0 || beyond.end == 0) continue;
      const float cost = left.box.area() * static_cast<float>(left.begin) +
                         beyond.box.area() * static_cast<float>(beyond.end);
      if (cost < best.cost) best = {cost, axis, i, left.box, beyond.box};
    }
  }
  return best;
}

LaneBox common(const LaneBox& a, const LaneBox& b) {
  return {larger(a.low, b.low), smaller(a.high, b.high)};
}
bool holds_something(const LaneBox& box) {
  return box.low[0] <= box.high[0] && box.low[1] <= box.high[1] && box.low[2] <= box.high[2];
}

// Where the boxes of the best object split overlap by less than this share of the root's surface, a spatial
// one isn't tried (Stich, Friedrich & Dietrich); so much more room for fragments there is.
constexpr float overlap_worth_splitting = 1e-4F;
constexpr double spare_fragments = 0.3;

template <class Stored>
class BinaryBuilder {
public:
  BinaryBuilder(const SceneView<Stored>& scene, double margin, const std::function<void(double)>& progress)
      : scene_(scene), margin_(margin), progress_(progress),
        spare_(static_cast<std::size_t>(spare_fragments * scene.primitive_count())),
        fragments_(fragments_of(scene, margin, spare_)), nodes_(2 * fragments_.size()) {}

  void build() {
    const FragmentRange all{0, scene_.primitive_count(), static_cast<std::uint32_t>(spare_)};
    if (all.count == 0) return nodes_.clear();
    root_area_ = extent_of(all).box.area();
    split(0, all, 0);
  }
  const HostArray<Fragment>& fragments() const { return fragments_; }
  const HostArray<BinaryNode>& nodes() const { return nodes_; }

private:
  static constexpr std::uint32_t fragments_a_task = 1 << 14;

  // Adds up what add(Result&, fragment) makes of each, in parallel for many; join(a, b) in any order.
  template <class Result, class Add, class Join>
  Result summed(const FragmentRange& range, const Add& add, const Join& join) const {
    const auto added = [&](std::uint32_t begin, std::uint32_t end, Result& sum) {
      for (std::uint32_t i = begin; i != end; ++i)
        add(sum, fragments_[i]);
    };
    Result sum{};
    if (range.count <= fragments_a_task) {
      added(range.first, range.first + range.count, sum);
      return sum;
    }
    return tbb::parallel_reduce(
        tbb::blocked_range<std::uint32_t>(range.first, range.first + range.count, fragments_a_task), sum,
        [&](const auto& part, Result so_far) {
          added(part.begin(), part.end(), so_far);
          return so_far;
        },
        [&](Result a, const Result& b) {
          join(a, b);
          return a;
        });
  }

  struct Extent {
    LaneBox box, centres;
  };
  Extent extent_of(const FragmentRange& range) const {
    return summed<Extent>(
        range,
        [](Extent& extent, const Fragment& fragment) {
          extent.box.join(fragment.box);
          const Lanes centre = fragment.centre();
          extent.centres.join({centre, centre});
        },
        [](Extent& a, const Extent& b) {
          a.box.join(b.box);
          a.centres.join(b.centres);
        });
  }

  static void join_bins(Bins& a, const Bins& b) { a.join(b); }

  Bins binned_by_centre(const FragmentRange& range, const Binning& binning) const {
    return summed<Bins>(
        range,
        [&](Bins& bins, const Fragment& fragment) {
          const Lanes centre = fragment.centre();
          for (int axis = 0; axis < 3; ++axis) {
            Bin& bin = bins.at(axis, binning.bin(centre, axis));
            bin.box.join(fragment.box);
            ++bin.begin;
            ++bin.end;
          }
        },
        join_bins);
  }

  // The bounds of what of a fragment lies on either side of a plane.
  struct Sides {
    LaneBox below, above;
  };
  Sides sides_of_fragment(const Fragment& fragment, int axis, float plane) const {
    Sides sides;
    with_primitive(scene_, fragment.primitive(), [&](const auto& primitive) {
      const ClippedBounds parts = sides_of(primitive, axis, plane, plane);
      const auto part = [&](const Boxd& bounds) {
        return is_empty(bounds)
                   ? LaneBox{}
                   : common(fragment_of(bounds, margin_, fragment.primitive()).box, fragment.box);
      };
      sides = {part(parts.below), part(parts.above)};
    });
    return sides;
  }

  Bins binned_by_space(const FragmentRange& range, const Binning& binning) const {
    return summed<Bins>(
        range,
        [&](Bins& bins, const Fragment& fragment) {
          for (int axis = 0; axis < 3; ++axis) {
            const int first = binning.bin(fragment.box.low, axis),
                      last = binning.bin(fragment.box.high, axis);
            ++bins.at(axis, first).begin;
            ++bins.at(axis, last).end;
            Fragment rest = fragment;
            for (int i = first; i != last; ++i) {
              const Sides sides = sides_of_fragment(rest, axis, binning.plane(axis, i));
              if (holds_something(sides.below)) bins.at(axis, i).box.join(sides.below);
              rest.box = sides.above;
              rest.box.low[3] = fragment.box.low[3];
            }
            if (holds_something(rest.box)) bins.at(axis, last).box.join(rest.box);
          }
        },
        join_bins);
  }

  struct Halves {
    FragmentRange left, right;
  };

  // The first of them go left. Both get room in proportion.
  Halves with_room(const FragmentRange& range, std::uint32_t left_count) {
    const std::uint32_t right_count = range.count - left_count;
    const auto left_room =
        static_cast<std::uint32_t>(static_cast<double>(range.room) * left_count / range.count);
    const auto right = fragments_.begin() + range.first + left_count;
    if (left_room > 0) std::move_backward(right, right + right_count, right + right_count + left_room);
    return {{range.first, left_count, left_room},
            {range.first + left_count + left_room, right_count, range.room - left_room}};
  }

  template <class GoesLeft>
  std::uint32_t partitioned(const FragmentRange& range, const GoesLeft& goes_left) {
    const auto begin = fragments_.begin() + range.first;
    return static_cast<std::uint32_t>(std::partition(begin, begin + range.count, goes_left) - begin);
  }

  // Divides at a plane what lies on both sides of it, as long as there is room.
  Halves split_by_space(FragmentRange range, const Binning& binning, const Split& best) {
    const float plane = binning.plane(best.axis, best.bin);
    const std::uint32_t count = range.count;
    for (std::uint32_t i = range.first; i != range.first + count && range.room > 0; ++i) {
      Fragment& fragment = fragments_[i];
      if (binning.bin(fragment.box.low, best.axis) > best.bin ||
          binning.bin(fragment.box.high, best.axis) <= best.bin)
        continue;
      const Sides sides = sides_of_fragment(fragment, best.axis, plane);
      if (!holds_something(sides.below) || !holds_something(sides.above)) continue;
      Fragment above = fragment;
      const float primitive = fragment.box.low[3];
      fragment.box = sides.below;
      above.box = sides.above;
      fragment.box.low[3] = above.box.low[3] = primitive;
      fragments_[range.first + range.count++] = above;
      --range.room;
    }
    const std::uint32_t left_count = partitioned(
        range, [&](const Fragment& fragment) { return fragment.centre()[best.axis] < 2 * plane; });
    // Parts within the margin of an older plane may all come to lie on one side.
    const bool one_sided = left_count == 0 || left_count == range.count;
    return with_room(range, one_sided ? range.count / 2 : left_count);
  }

  Halves halves_of(const FragmentRange& range, const Extent& extent, int depth) {
    // Halves are taken where else the hierarchy would become too deep for the walk's stack. A spatial split
    // may leave twice as many fragments on one side.
    if (depth + std::bit_width(range.count) + 1 >= max_hierarchy_depth)
      return with_room(range, range.count / 2);
    const int bins = range.count > 64 ? most_bins : most_bins / 2;
    const Binning by_centre(extent.centres, bins);
    const Split objects = best_split(binned_by_centre(range, by_centre), bins);
    const LaneBox overlap = common(objects.left, objects.right);
    if (range.room > 0 && objects.axis >= 0 && holds_something(overlap) &&
        overlap.area() > overlap_worth_splitting * root_area_) {
      const Binning by_space(extent.box, most_bins / 2);
      const Split space = best_split(binned_by_space(range, by_space), most_bins / 2);
      if (space.cost < objects.cost) return split_by_space(range, by_space, space);
    }
    if (objects.axis < 0) return with_room(range, range.count / 2);
    return with_room(range, partitioned(range, [&](const Fragment& fragment) {
                       return by_centre.bin(fragment.centre(), objects.axis) <= objects.bin;
                     }));
  }

  void split(std::uint32_t number, const FragmentRange& range, int depth) {
    const Extent extent = extent_of(range);
    nodes_[number] = {extent.box, range.first, range.count, 0};
    if (range.count <= 1) return;
    const Halves halves = halves_of(range, extent, depth);
    const std::uint32_t left = used_.fetch_add(2);
    nodes_[number].left = left;
    nodes_[number].count = halves.left.count + halves.right.count;
    const auto split_left = [&] { split(left, halves.left, depth + 1); };
    const auto split_right = [&] { split(left + 1, halves.right, depth + 1); };
    if (range.count > 1024) {
      tbb::parallel_invoke(split_left, split_right);
      nodes_[number].count = nodes_[left].count + nodes_[left + 1].count;
    } else {
      split_left();
      split_right();
      nodes_[number].count = nodes_[left].count + nodes_[left + 1].count;
      if (range.count > 512 && progress_)
        progress_(std::min(0.8, 0.8 * static_cast<double>(done_ += range.count) / scene_.primitive_count()));
    }
  }

  const SceneView<Stored>& scene_;
  double margin_;
  const std::function<void(double)>& progress_;
  std::size_t spare_;
  HostArray<Fragment> fragments_;
  HostArray<BinaryNode> nodes_;
  float root_area_ = 0;
  std::atomic<std::uint32_t> used_ = 1;
  std::atomic<std::uint64_t> done_ = 0;
};

// --- Nodes of eight
// ------------------------------------------------------------------------------------------

// Of a visit to a node, relative to it: the test of a reference.
constexpr float test_cost = 0.3F;

// The least costs, in areas, of a binary node's contents in up to so many boxes of a wide node; and how many
// of them go to its left: 0 where fewer boxes cost no more.
struct Collapse {
  float cost[boxes_a_node]; // [i]: in up to i boxes, from 1 on
  std::uint8_t left[boxes_a_node + 1];
  bool is_leaf; // in one box: its references, not a node
};

class Collapser {
public:
  Collapser(const HostArray<Fragment>& fragments, const HostArray<BinaryNode>& nodes)
      : fragments_(fragments), nodes_(nodes), best_(nodes.size()) {}

  Hierarchy collapse() {
    Hierarchy hierarchy;
    hierarchy.nodes.resize(1);
    if (nodes_.empty()) {
      hierarchy.nodes[0] = {};
      return hierarchy;
    }
    find_best(0);
    write(hierarchy, 0, 0);
    return hierarchy;
  }

private:
  struct Boxes {
    std::array<std::uint32_t, boxes_a_node> nodes;
    int count = 0;
    void add(std::uint32_t node) { nodes[static_cast<unsigned>(count++)] = node; }
  };

  void find_best(std::uint32_t number) {
    const BinaryNode& node = nodes_[number];
    Collapse& best = best_[number];
    const float area = node.box.area();
    const float as_leaf =
        node.count <= max_references_a_box ? area * static_cast<float>(node.count) * test_cost : INFINITY;
    best = {};
    if (node.left == 0) {
      std::fill_n(best.cost, boxes_a_node, as_leaf);
      best.is_leaf = true;
      return;
    }
    const auto find_left = [&] { find_best(node.left); };
    const auto find_right = [&] { find_best(node.left + 1); };
    if (node.count > 4096) {
      tbb::parallel_invoke(find_left, find_right);
    } else {
      find_left();
      find_right();
    }
    const Collapse &left = best_[node.left], &right = best_[node.left + 1];
    float distributed[boxes_a_node + 1];
    for (int boxes = 2; boxes <= boxes_a_node; ++boxes) {
      distributed[boxes] = INFINITY; // which the costs of vast boxes may add up to, too
      best.left[boxes] = 1;
      for (int to_left = 1; to_left < boxes; ++to_left) {
        const float cost = left.cost[to_left] + right.cost[boxes - to_left];
        if (cost < distributed[boxes]) {
          distributed[boxes] = cost;
          best.left[boxes] = static_cast<std::uint8_t>(to_left);
        }
      }
    }
    const float as_node = distributed[boxes_a_node] + area;
    best.is_leaf = as_leaf <= as_node;
    best.cost[1] = std::min(as_leaf, as_node);
    for (int boxes = 2; boxes < boxes_a_node; ++boxes) {
      const bool pays = distributed[boxes] < best.cost[boxes - 1];
      best.cost[boxes] = pays ? distributed[boxes] : best.cost[boxes - 1];
      if (!pays) best.left[boxes] = 0;
    }
  }

  // The boxes that a binary node takes up to so many of, as find_best() found them.
  void gather(std::uint32_t number, int boxes, Boxes& into) const {
    const auto place = [&](std::uint32_t child, int most) {
      while (most > 1 && best_[child].left[most] == 0)
        --most;
      most == 1 ? into.add(child) : gather(child, most, into);
    };
    const BinaryNode& node = nodes_[number];
    const int to_left = best_[number].left[boxes];
    place(node.left, to_left);
    place(node.left + 1, boxes - to_left);
  }

  // The slot of each box, by the octant about the centre that it lies in most: those that gain most come
  // first.
  std::array<int, boxes_a_node> slots_of(const Boxes& boxes, const LaneBox& around) const {
    std::array<int, boxes_a_node> slots{};
    const Lanes centre = around.low + around.high;
    unsigned placed = 0, taken = 0;
    for (int round = 0; round < boxes.count; ++round) {
      int best_box = 0, best_slot = 0;
      float most = -INFINITY;
      for (int box = 0; box < boxes.count; ++box) {
        if ((placed >> box & 1) != 0) continue;
        const LaneBox& own = nodes_[boxes.nodes[static_cast<unsigned>(box)]].box;
        const Lanes off = own.low + own.high - centre;
        for (int slot = 0; slot < boxes_a_node; ++slot) {
          if ((taken >> slot & 1) != 0) continue;
          const float gain = ((slot & 1) != 0 ? off[0] : -off[0]) + ((slot & 2) != 0 ? off[1] : -off[1]) +
                             ((slot & 4) != 0 ? off[2] : -off[2]);
          if (!(gain > most)) continue;
          most = gain;
          best_box = box;
          best_slot = slot;
        }
      }
      if (most == -INFINITY) { // where nothing can be compared
        best_box = std::countr_one(placed);
        best_slot = std::countr_one(taken);
      }
      placed |= 1U << best_box;
      taken |= 1U << best_slot;
      slots[static_cast<unsigned>(best_box)] = best_slot;
    }
    return slots;
  }

  void list(Hierarchy& hierarchy, std::uint32_t number) const {
    const BinaryNode& node = nodes_[number];
    if (node.left == 0) return hierarchy.references.push_back(fragments_[node.first].primitive());
    list(hierarchy, node.left);
    list(hierarchy, node.left + 1);
  }

  // Units of the compressed boxes: powers of two, of which the node's box has 240 at most; it begins a few
  // after the origin.
  static constexpr double units = 240, units_before = 4;
  // Larger by this many units than what they hold: hierarchy_walk.h says why.
  static constexpr double slack = 1.0 / 64;

  void write(Hierarchy& hierarchy, std::size_t place, std::uint32_t number) {
    Boxes boxes;
    // A root that is a leaf is a node of one box.
    const bool leaf = best_[number].is_leaf;
    leaf ? boxes.add(number) : gather(number, boxes_a_node, boxes);
    const LaneBox& around = nodes_[number].box;
    HierarchyNode node{};
    double unit[3];
    for (int axis = 0; axis < 3; ++axis) {
      const double extent = static_cast<double>(around.high[axis]) - static_cast<double>(around.low[axis]);
      // No smaller than the origin's rounding.
      const double least =
          std::max(extent / units, std::abs(static_cast<double>(around.low[axis])) * 0x1p-22);
      const int exponent = std::clamp(std::ilogb(std::max(least, 0x1p-100)) + 1, -100, 100);
      unit[axis] = std::ldexp(1.0, exponent);
      node.origin[axis] = rounded_down(static_cast<double>(around.low[axis]) - units_before * unit[axis]);
      node.exponents |= static_cast<std::uint32_t>(exponent + 127) << (8 * axis);
    }
    const auto slots = slots_of(boxes, around);
    std::array<std::uint32_t, boxes_a_node> in_slot{};
    unsigned filled = 0;
    for (int box = 0; box < boxes.count; ++box) {
      in_slot[static_cast<unsigned>(slots[static_cast<unsigned>(box)])] =
          boxes.nodes[static_cast<unsigned>(box)];
      filled |= 1U << slots[static_cast<unsigned>(box)];
    }
    node.first_node = static_cast<std::uint32_t>(hierarchy.nodes.size());
    node.first_reference = static_cast<std::uint32_t>(hierarchy.references.size());
    Boxes inner;
    for (int slot = 0; slot < boxes_a_node; ++slot) {
      const int shift = slot % 4 * 8;
      if ((filled >> slot & 1) == 0) continue;
      const std::uint32_t child = in_slot[static_cast<unsigned>(slot)];
      const BinaryNode& held = nodes_[child];
      for (int axis = 0; axis < 3; ++axis) {
        const double origin = node.origin[axis];
        const double low = std::floor((held.box.low[axis] - origin) / unit[axis] - slack),
                     high = std::ceil((held.box.high[axis] - origin) / unit[axis] + slack);
        node.low[axis][slot / 4] |= static_cast<std::uint32_t>(low) << shift;
        node.high[axis][slot / 4] |= static_cast<std::uint32_t>(high) << shift;
      }
      if (best_[child].is_leaf) {
        const auto first = static_cast<std::uint32_t>(hierarchy.references.size()) - node.first_reference;
        node.slots[slot / 4] |= (((1U << held.count) - 1) << 5 | first) << shift;
        list(hierarchy, child);
      } else {
        node.slots[slot / 4] |= (node_slot | static_cast<std::uint32_t>(slot)) << shift;
        node.exponents |= 1U << (24 + slot);
        inner.add(child);
      }
    }
    hierarchy.nodes.resize(hierarchy.nodes.size() + static_cast<unsigned>(inner.count));
    hierarchy.nodes[place] = node;
    for (int i = 0; i < inner.count; ++i)
      write(hierarchy, node.first_node + static_cast<unsigned>(i), inner.nodes[static_cast<unsigned>(i)]);
  }

  const HostArray<Fragment>& fragments_;
  const HostArray<BinaryNode>& nodes_;
  HostArray<Collapse> best_;
};

} // namespace

template <class Stored>
Hierarchy build_hierarchy(const SceneView<Stored>& scene, double margin,
                          const std::function<void(double)>& progress) {
  check_primitives(scene.primitive_count());
  BinaryBuilder<Stored> builder(scene, margin, progress);
  builder.build();
  return Collapser(builder.fragments(), builder.nodes()).collapse();
}
template Hierarchy build_hierarchy(const SceneView<float>&, double, const std::function<void(double)>&);
template Hierarchy build_hierarchy(const SceneView<double>&, double, const std::function<void(double)>&);

template <class Stored>
Grid hierarchy_grid(const SceneView<Stored>& scene, const GridLayout& layout,
                    const std::function<void(double)>& progress) {
  if (!fits_hierarchy(layout.space))
    throw Error(ErrorCode::usage, "merge",
                "a hierarchy holds coordinates up to 1e15: build a grid of voxels");
  Hierarchy hierarchy = build_hierarchy(scene, layout.margin, progress);
  Grid grid;
  grid.layout = {layout.space, {1, 1, 1}, layout.margin};
  grid.kind = GridKind::hierarchy;
  grid.references = std::move(hierarchy.references);
  grid.nodes = std::move(hierarchy.nodes);
  return grid;
}
template Grid hierarchy_grid(const SceneView<float>&, const GridLayout&, const std::function<void(double)>&);
template Grid hierarchy_grid(const SceneView<double>&, const GridLayout&, const std::function<void(double)>&);

} // namespace masu
