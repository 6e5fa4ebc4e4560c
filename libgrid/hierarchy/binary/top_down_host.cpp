#include "libgrid/hierarchy/binary/binary_hierarchy.h"

#include "libgrid/hierarchy/binary/binned_fragments.h"
#include "libgrid/hierarchy/binary/parallel_partition.h"
#include "libscene/base/parallel.h"

#include <algorithm>
#include <functional>
#include <vector>

namespace masu {

namespace {

LeafSplit cheapest_of_few(const BinaryNode* leaves, std::uint32_t count) {
  const SortedFew<Lanes4> sorted(leaves, count, [](Lanes4 centre) { return centre; });
  const AxisSplit split = sorted.cheapest_split();
  if (split.axis < 0) return {};
  return {split.cost, split.axis, sorted.key(split)};
}

LeafSplit cheapest_of_many(const BinaryNode* leaves, std::uint32_t count, const Boxf& space) {
  const LeafSample sample(count);
  LaneBox around;
  sample.for_each(0, 1, [&](std::uint32_t i, std::uint32_t) {
    const Lanes4 centre = box_of(leaves[i]).twice_the_centre();
    around.join({centre, centre});
  });
  const Boxf centres = boxf(around);
  const LeafBins along[] = {
      {sample, centres, space, 0}, {sample, centres, space, 1}, {sample, centres, space, 2}};
  const BinLanes bins_of(along);
  // Two sets take turns where leaves are many: those in a row are often in one bin, and each waits for what
  // the one before has written.
  AxisBins<max_bins> bins(along[0].count), odd_bins(count > 64 ? bins.count : 0);
  AxisBins<max_bins>* const sets[] = {&bins, count > 64 ? &odd_bins : &bins};
  sample.for_each(0, 1, [&](std::uint32_t i, std::uint32_t stands_for) {
    const LaneBox box = box_of(leaves[i]);
    const WholeLanes4 in = bins_of(box.twice_the_centre()),
                      number = WholeLanes4{} + static_cast<std::int32_t>(stands_for);
    const CountedBox counted(box, number, number);
    for (int axis = 0; axis < 3; ++axis)
      sets[i % 2]->at(in, axis).join(counted);
  });
  if (odd_bins.count > 0) bins.join(odd_bins);
  const AxisSplit split = cheapest_split(bins);
  if (split.axis < 0) return {};
  return {split.cost, split.axis, along[split.axis].end(split.number)};
}

// By planes that divide what is large.
LeafSplit cheapest_by_planes(const BinaryNode* leaves, std::uint32_t count, const LargeLeaves& large) {
  const LeafSample sample(count);
  LaneBox around;
  sample.for_each(0, 1, [&](std::uint32_t i, std::uint32_t) { around.join(box_of(leaves[i])); });
  const Binning binning(around, bins_in_space);
  BinsInSpace whole(binning.count()), from(whole.count), to(whole.count);
  sample.for_each(0, 1, [&](std::uint32_t i, std::uint32_t stands_for) {
    const LaneBox box = box_of(leaves[i]);
    const WholeLanes4 number = WholeLanes4{} + static_cast<std::int32_t>(stands_for);
    const auto add = [&](BinsInSpace& bins, Lanes4 at, const CountedBox& counted) {
      const WholeLanes4 in = binning.bins_of(at);
      for (int axis = 0; axis < 3; ++axis)
        bins.at(in, axis).join(counted);
    };
    if (large.has(leaves[i])) {
      add(from, box.low, CountedBox(box, number));
      add(to, box.high, CountedBox(box, WholeLanes4{}, number));
    } else {
      Lanes4 centre = box.twice_the_centre();
      centre[3] = 0; // else a leaf's index, as a float so small that products of it are slow
      add(whole, 0.5F * centre, CountedBox(box, number, number));
    }
  });
  // Parts reach up to a plane.
  const auto side = [&](CountedLanes parts, const CountedLanes& others, std::int32_t bin, int below) {
    const Lanes4 plane = binning.planes(WholeLanes4{} + bin);
    for (int axis = 0; axis < 3; ++axis) {
      const int lane = axis + 4 * below;
      parts.planes[axis][lane] = std::max(parts.planes[axis][lane], below != 0 ? -plane[axis] : plane[axis]);
    }
    parts.join(others);
    return parts;
  };
  CountedLanes right[bins_in_space], above, others; // right: from a bin on
  for (std::int32_t i = whole.count - 1; i > 0; --i) {
    above.join(to.lanes(i));
    others.join(whole.lanes(i));
    right[i] = side(above, others, i - 1, 0);
  }
  CheapestSplit cheapest;
  CountedLanes below;
  others = {};
  for (std::int32_t i = 0; i + 1 < whole.count; ++i) {
    below.join(from.lanes(i));
    others.join(whole.lanes(i));
    const CountedLanes left = side(below, others, i, 1);
    cheapest.add(split_cost(left.areas(), __builtin_convertvector(left.begin(), Lanes4), right[i + 1].areas(),
                            __builtin_convertvector(right[i + 1].end(), Lanes4)),
                 i);
  }
  const AxisSplit split = cheapest.along_any_axis();
  if (split.axis < 0) return {};
  return {split.cost, split.axis, 2 * binning.along[split.axis].plane(split.number)};
}

// Leaves of a node: from `first` on of all, wherever they are at the time, and places after them for so many
// more.
struct PlacedLeaves {
  BinaryNode* leaves;
  std::uint32_t first, count, room;

  std::uint32_t places() const { return count + room; }
};

// A pair of nodes that is split before leaf s is nodes 2 s and 2 s + 1. So a range of leaves has all of the
// nodes below its own to itself: until they are made, their second half holds its leaves, too.
class TopDownBuilder {
public:
  TopDownBuilder(HierarchyLeaves<TbbExecutor> made, const TriangleOf& triangle,
                 const ProgressMonitor* progress)
      : count_(static_cast<std::uint32_t>(made.leaves.size())), large_(made.large), triangle_(triangle),
        leaves_(std::move(made.leaves)), progress_(progress) {
    leaves_.resize(std::size_t{count_} + large_.room);
    nodes_.resize(2 * leaves_.size());
    choices_.resize(nodes_.size());
  }

  HostHierarchy build(const Boxd& space) {
    if (count_ == 0) return {};
    build({leaves_.data(), 0, count_, large_.room}, twice(cast<float>(space)), 0, 0);
    return {std::move(nodes_), std::move(choices_)};
  }

private:
  static constexpr std::uint32_t leaves_per_task = 1024, leaves_of_all_cores = 1 << 15;

  CollapseCosts build(PlacedLeaves range, const Boxf& space, std::size_t depth, std::uint32_t number) {
    BinaryNode& node = nodes_[number];
    if (range.count == 1) {
      node = *range.leaves;
      return with_choice(choices_, number, collapse_costs_of_leaf(node));
    }
    LeafSplit split;
    if (range.count > 2 && range.count <= most_leaves_split(depth)) {
      split = range.count <= few_leaves ? cheapest_of_few(range.leaves, range.count)
                                        : cheapest_of_many(range.leaves, range.count, space);
      if (range.room > 0 && range.count > most_undivided) divide_if_cheaper(range, split);
    }
    PlacedLeaves left{}, right{};
    if (range.count > leaves_of_all_cores)
      partition_by_all_cores(range, split, left, right);
    else
      partition(range, split, left, right);
    const SplitSpaces spaces(space, split);
    const std::uint32_t pair = 2 * right.first;
    CollapseCosts left_costs{}, right_costs{};
    const auto build_left = [&] { left_costs = build(left, spaces.left, depth + 1, pair); };
    const auto build_right = [&] { right_costs = build(right, spaces.right, depth + 1, pair + 1); };
    if (range.count > leaves_per_task) {
      check_progress(progress_);
      parallel_invoke(std::cref(build_left), std::cref(build_right));
      give_back(among_leaves(range.first), range.places());
    } else {
      build_left();
      build_right();
    }
    const BinaryNode &first = nodes_[pair], &last = nodes_[pair + 1];
    node = node_of(join(first.box(), last.box()), pair, first, last);
    return with_choice(choices_, number, collapse_costs(node, left_costs, right_costs));
  }

  // Where a range's leaves may be.
  BinaryNode* among_leaves(std::uint32_t first) { return leaves_.data() + first; }
  BinaryNode* among_nodes(std::uint32_t first, std::uint32_t places) {
    return nodes_.data() + 2 * std::size_t{first} + places;
  }

  // What is large by a plane: what lies below stays in its place, what lies above comes after the others.
  void divide_if_cheaper(PlacedLeaves& range, LeafSplit& split) {
    const LeafSplit at_plane = cheapest_by_planes(range.leaves, range.count, large_);
    if (!(at_plane.cost < most_of_cost * split.cost)) return;
    split = at_plane;
    const auto divided = divided_by(range.count, progress_, [&](std::uint32_t leaf, Sides& parts) {
      return large_.divides(split, range.leaves[leaf], triangle_, parts);
    });
    for (const auto& [leaf, parts] : divided) {
      if (range.room == 0) break;
      put_parts(parts, 1, range.leaves[leaf], range.leaves[range.count++]);
      --range.room;
    }
  }

  // But for where they are. Where a split is of all or nothing it becomes none. Both get room in proportion.
  static void halve(const PlacedLeaves& range, LeafSplit& split, std::uint32_t left_count, PlacedLeaves& left,
                    PlacedLeaves& right) {
    if (left_count == 0 || left_count == range.count) {
      split.axis = -1;
      left_count = range.count / 2;
    }
    left = {nullptr, range.first, left_count, room_of_left(range.room, left_count, range.count)};
    right = {nullptr, range.first + left.places(), range.count - left_count, range.room - left.room};
  }

  // Both in their order, the left ones first.
  void partition(PlacedLeaves range, LeafSplit& split, PlacedLeaves& left, PlacedLeaves& right) {
    BinaryNode* const leaves = among_leaves(range.first);
    if (range.leaves != leaves) std::copy_n(range.leaves, range.count, leaves);
    BinaryNode* const rest = among_nodes(range.first, range.places());
    std::uint32_t left_count = 0;
    with_axis(split.axis, [&](auto axis) {
      for (std::uint32_t i = 0; i < range.count; ++i) {
        const LaneBox leaf = box_of(leaves[i]);
        const bool is_left = split.is_left(leaves[i], axis);
        put(leaf, leaves[left_count]);
        put(leaf, rest[i - left_count]);
        left_count += is_left;
      }
      for (std::uint32_t i = left_count; i < range.count; ++i)
        put(box_of(rest[i - left_count]), leaves[i]);
    });
    halve(range, split, left_count, left, right);
    left.leaves = leaves;
    right.leaves = among_leaves(right.first);
    if (left.room > 0)
      std::move_backward(leaves + left.count, leaves + range.count, right.leaves + right.count);
  }

  // The same from among leaves to among nodes, or back.
  void partition_by_all_cores(const PlacedLeaves& range, LeafSplit& split, PlacedLeaves& left,
                              PlacedLeaves& right) {
    const std::uint32_t chunks = chunks_of(range.count);
    std::vector<std::uint32_t> left_before(chunks + 1);
    for_each_chunk(range.count, progress_, [&](std::uint32_t c, std::uint32_t begin, std::uint32_t end) {
      with_axis(split.axis, [&](auto axis) {
        std::uint32_t left_here = 0;
        for (std::uint32_t i = begin; i != end; ++i)
          left_here += split.is_left(range.leaves[i], axis);
        left_before[c + 1] = left_here;
      });
    });
    for (std::uint32_t c = 0; c < chunks; ++c)
      left_before[c + 1] += left_before[c];
    halve(range, split, left_before[chunks], left, right);
    const bool to_nodes = range.leaves == among_leaves(range.first);
    for (PlacedLeaves* const half : {&left, &right})
      half->leaves = to_nodes ? among_nodes(half->first, half->places()) : among_leaves(half->first);
    for_each_chunk(range.count, progress_, [&](std::uint32_t c, std::uint32_t begin, std::uint32_t end) {
      if (split.axis < 0) {
        for (std::uint32_t i = begin; i != end; ++i)
          put(box_of(range.leaves[i]), i < left.count ? left.leaves[i] : right.leaves[i - left.count]);
      }
      with_axis(split.axis, [&](auto axis) {
        std::uint32_t to_left = left_before[c];
        for (std::uint32_t i = begin; i != end; ++i) {
          const LaneBox leaf = box_of(range.leaves[i]);
          const bool is_left = split.is_left(range.leaves[i], axis);
          put(leaf, is_left ? left.leaves[to_left] : right.leaves[i - to_left]);
          to_left += is_left;
        }
      });
    });
  }

  std::uint32_t count_;
  LargeLeaves large_;
  const TriangleOf& triangle_;
  HostArray<BinaryNode> leaves_, nodes_;
  HostArray<CollapseChoice> choices_;
  const ProgressMonitor* progress_;
};

} // namespace

HostHierarchy top_down_hierarchy(HierarchyLeaves<TbbExecutor> leaves, const TriangleOf& triangle,
                                 const Boxd& space, const ProgressMonitor* progress) {
  return TopDownBuilder(std::move(leaves), triangle, progress).build(space);
}

} // namespace masu
