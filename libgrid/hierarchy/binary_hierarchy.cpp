#include "libgrid/hierarchy/binary_hierarchy.h"

#include "libgrid/grid/overlap/clipped_bounds.h"
#include "libgrid/hierarchy/hierarchy_builder.h"
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <utility>

namespace masu {

namespace {

HierarchyFragment fragment_of(const Boxf& box, PrimitiveIndex primitive) {
  HierarchyFragment fragment;
  fragment.box.low = Lanes{box.min.x, box.min.y, box.min.z, float_of(primitive)};
  fragment.box.high = Lanes{box.max.x, box.max.y, box.max.z, 0};
  return fragment;
}

bool holds_something(const LaneBox& box) {
  return box.low[0] <= box.high[0] && box.low[1] <= box.high[1] && box.low[2] <= box.high[2];
}

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

// Where the boxes of the best object split overlap by less than this share of the root's surface, a spatial
// one isn't tried.
constexpr float overlap_worth_splitting = 1e-4F;

template <class Stored>
class BinaryBuilder {
public:
  BinaryBuilder(const SceneView<Stored>& scene, double margin, const HostArray<BinaryNode>& leaves,
                ProgressMonitor* progress)
      : scene_(scene), margin_(margin), progress_(progress),
        count_(static_cast<std::uint32_t>(leaves.size())),
        fragments_(static_cast<std::size_t>((1 + spare_fragments) * count_)), nodes_(2 * fragments_.size()),
        choices_(nodes_.size()), costs_(nodes_.size()) {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, leaves.size(), 4096), [&](const auto& range) {
      for (std::size_t i = range.begin(); i != range.end(); ++i)
        fragments_[i] = fragment_of(leaves[i].box(), leaves[i].index);
    });
  }

  BinaryHierarchy<TbbExecutor> build() {
    const FragmentRange all{0, count_, static_cast<std::uint32_t>(fragments_.size()) - count_};
    if (all.count == 0) return {};
    root_area_ = extent_of(all).box.area();
    split(0, all, 0);
    return {std::move(nodes_), std::move(choices_)};
  }

private:
  static constexpr std::uint32_t fragments_per_task = 1 << 14, fragments_per_check = 1 << 12;

  // Adds up what add(Result&, fragment) makes of each, in parallel for many; join(a, b) in any order.
  template <class Result, class Add, class Join>
  Result summed(const FragmentRange& range, const Add& add, const Join& join) const {
    const auto added = [&](std::uint32_t begin, std::uint32_t end, Result& sum) {
      for (std::uint32_t i = begin; i != end; ++i) {
        if (i % fragments_per_check == 0) check_progress(progress_);
        add(sum, fragments_[i]);
      }
    };
    Result sum{};
    if (range.count <= fragments_per_task) {
      added(range.first, range.first + range.count, sum);
      return sum;
    }
    return tbb::parallel_reduce(
        tbb::blocked_range<std::uint32_t>(range.first, range.first + range.count, fragments_per_task), sum,
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
        [](Extent& extent, const HierarchyFragment& fragment) {
          extent.box.join(fragment.box);
          const Lanes centre = fragment.centre();
          extent.centres.join({centre, centre});
        },
        [](Extent& a, const Extent& b) {
          a.box.join(b.box);
          a.centres.join(b.centres);
        });
  }

  Bins binned_by_centre(const FragmentRange& range, const Binning& binning) const {
    return summed<Bins>(
        range,
        [&](Bins& bins, const HierarchyFragment& fragment) {
          const Lanes centre = fragment.centre();
          for (int axis = 0; axis < 3; ++axis) {
            Bin& bin = bins.at(axis, binning.bin(centre, axis));
            bin.box.join(fragment.box);
            ++bin.begin;
            ++bin.end;
          }
        },
        [](Bins& a, const Bins& b) { a.join(b); });
  }

  // The bounds of what of a fragment lies on either side of a plane.
  struct Sides {
    LaneBox below, above;
  };
  Sides sides_of_fragment(const HierarchyFragment& fragment, int axis, float plane) const {
    Sides sides;
    with_primitive(scene_, fragment.primitive(), [&](const auto& primitive) {
      const ClippedBounds parts = sides_of(primitive, axis, plane, plane);
      const auto part = [&](const Boxd& bounds) {
        return is_empty(bounds)
                   ? LaneBox{}
                   : common(fragment_of(box_around(bounds, margin_), fragment.primitive()).box, fragment.box);
      };
      sides = {part(parts.below), part(parts.above)};
    });
    return sides;
  }

  Bins binned_by_space(const FragmentRange& range, const Binning& binning) const {
    return summed<Bins>(
        range,
        [&](Bins& bins, const HierarchyFragment& fragment) {
          for (int axis = 0; axis < 3; ++axis) {
            const int first = binning.bin(fragment.box.low, axis),
                      last = binning.bin(fragment.box.high, axis);
            ++bins.at(axis, first).begin;
            ++bins.at(axis, last).end;
            HierarchyFragment rest = fragment;
            for (int i = first; i != last; ++i) {
              const Sides sides = sides_of_fragment(rest, axis, binning.plane(axis, i));
              if (holds_something(sides.below)) bins.at(axis, i).box.join(sides.below);
              rest.box = sides.above;
              rest.box.low[3] = fragment.box.low[3];
            }
            if (holds_something(rest.box)) bins.at(axis, last).box.join(rest.box);
          }
        },
        [](Bins& a, const Bins& b) { a.join(b); });
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
      if (i % fragments_per_check == 0) check_progress(progress_);
      HierarchyFragment& fragment = fragments_[i];
      if (binning.bin(fragment.box.low, best.axis) > best.bin ||
          binning.bin(fragment.box.high, best.axis) <= best.bin)
        continue;
      const Sides sides = sides_of_fragment(fragment, best.axis, plane);
      if (!holds_something(sides.below) || !holds_something(sides.above)) continue;
      HierarchyFragment above = fragment;
      const float primitive = fragment.box.low[3];
      fragment.box = sides.below;
      above.box = sides.above;
      fragment.box.low[3] = above.box.low[3] = primitive;
      fragments_[range.first + range.count++] = above;
      --range.room;
    }
    const std::uint32_t left_count = partitioned(
        range, [&](const HierarchyFragment& fragment) { return fragment.centre()[best.axis] < 2 * plane; });
    // Parts within the margin of an older plane may all come to lie on one side.
    const bool one_sided = left_count == 0 || left_count == range.count;
    return with_room(range, one_sided ? range.count / 2 : left_count);
  }

  Halves halves_of(const FragmentRange& range, const Extent& extent, int depth) {
    // Halves are taken where else the hierarchy would become too deep for the walk's stack. A spatial split
    // may leave twice as many fragments on one side.
    if (depth + static_cast<int>(std::bit_width(range.count)) + 1 >= max_hierarchy_depth)
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
    return with_room(range, partitioned(range, [&](const HierarchyFragment& fragment) {
                       return by_centre.bin(fragment.centre(), objects.axis) <= objects.bin;
                     }));
  }

  void split(std::uint32_t number, const FragmentRange& range, int depth) {
    const Extent extent = extent_of(range);
    const Lanes &low = extent.box.low, &high = extent.box.high;
    BinaryNode& node = nodes_[number];
    node = {{low[0], low[1], low[2]}, 0, {high[0], high[1], high[2]}, range.count};
    if (range.count <= 1) {
      node.index = fragments_[range.first].primitive();
      return set_costs(number, collapse_costs_of_leaf(node));
    }
    const Halves halves = halves_of(range, extent, depth);
    const std::uint32_t left = used_.fetch_add(2);
    node.index = left;
    const auto split_left = [&] { split(left, halves.left, depth + 1); };
    const auto split_right = [&] { split(left + 1, halves.right, depth + 1); };
    if (range.count > 1024) {
      tbb::parallel_invoke(split_left, split_right);
    } else {
      split_left();
      split_right();
      if (range.count > 512 && progress_ != nullptr)
        (*progress_)(
            std::min(0.8, 0.8 * static_cast<double>(done_ += range.count) / scene_.primitive_count()));
    }
    node.count = nodes_[left].count + nodes_[left + 1].count; // with what was divided below
    set_costs(number, collapse_costs(node, costs_[left], costs_[left + 1]));
  }

  void set_costs(std::uint32_t number, const CollapseCosts& costs) {
    costs_[number] = costs;
    choices_[number] = costs.choice;
  }

  const SceneView<Stored>& scene_;
  double margin_;
  ProgressMonitor* progress_;
  std::uint32_t count_; // of leaves
  HostArray<HierarchyFragment> fragments_;
  HostArray<BinaryNode> nodes_;
  HostArray<CollapseChoice> choices_;
  HostArray<CollapseCosts> costs_;
  float root_area_ = 0;
  std::atomic<std::uint32_t> used_ = 1;
  std::atomic<std::uint64_t> done_ = 0;
};

} // namespace

template <class Stored>
BinaryHierarchy<TbbExecutor> binary_hierarchy(const SceneView<Stored>& scene, double margin,
                                              const HostArray<BinaryNode>& leaves,
                                              ProgressMonitor* progress) {
  return BinaryBuilder<Stored>(scene, margin, leaves, progress).build();
}
template BinaryHierarchy<TbbExecutor> binary_hierarchy(const SceneView<float>&, double,
                                                       const HostArray<BinaryNode>&, ProgressMonitor*);
template BinaryHierarchy<TbbExecutor> binary_hierarchy(const SceneView<double>&, double,
                                                       const HostArray<BinaryNode>&, ProgressMonitor*);

} // namespace masu
