#include "libgrid/hierarchy/binary/top_down_host.h"

#include "libgrid/hierarchy/binary/parallel_partition.h"
#include "libgrid/hierarchy/binary/split_lanes.h"
#include "libscene/base/parallel.h"

#include <algorithm>
#include <functional>
#include <vector>

namespace masu {

namespace {

LeafSplit cheapest_of_few(const BinaryNode* leaves, std::uint32_t count) {
  CountedBox boxes[few_leaves];
  Lanes4 centres[few_leaves];
  for (std::uint32_t i = 0; i < count; ++i) {
    const LaneBox box = box_of(leaves[i]);
    boxes[i] = CountedBox(box);
    centres[i] = box.twice_the_centre();
  }
  const SortedFew sorted(boxes, centres, count);
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

// Leaves of a node: from `first` on of all, wherever they are at the time.
struct PlacedLeaves {
  BinaryNode* leaves;
  std::uint32_t first, count;
};

// A pair of nodes that is split before leaf s is nodes 2 s and 2 s + 1. So a range of leaves has all of the
// nodes below its own to itself: until they are made, their second half holds its leaves, too.
class TopDownBuilder {
public:
  TopDownBuilder(HostArray<BinaryNode> leaves, const ProgressMonitor* progress)
      : leaves_(std::move(leaves)), nodes_(2 * leaves_.size()), choices_(nodes_.size()), progress_(progress) {
  }

  BinaryHierarchy<TbbExecutor> build(const Boxd& space) {
    const auto count = static_cast<std::uint32_t>(leaves_.size());
    if (count == 0) return {};
    build({leaves_.data(), 0, count}, twice(cast<float>(space)), 0, 0);
    return {std::move(nodes_), std::move(choices_)};
  }

private:
  static constexpr std::uint32_t leaves_per_task = 1024, leaves_of_all_cores = 1 << 15;

  CollapseCosts build(PlacedLeaves range, const Boxf& space, std::size_t depth, std::uint32_t number) {
    BinaryNode& node = nodes_[number];
    if (range.count == 1) {
      node = *range.leaves;
      return with_choice(number, collapse_costs_of_leaf(node));
    }
    LeafSplit split;
    if (range.count > 2 && range.count <= most_leaves_split(depth))
      split = range.count <= few_leaves ? cheapest_of_few(range.leaves, range.count)
                                        : cheapest_of_many(range.leaves, range.count, space);
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
      give_back(among_leaves(range.first), range.count);
    } else {
      build_left();
      build_right();
    }
    const BinaryNode &first = nodes_[pair], &last = nodes_[pair + 1];
    node = node_of(join(first.box(), last.box()), pair, first, last);
    return with_choice(number, collapse_costs(node, left_costs, right_costs));
  }

  CollapseCosts with_choice(std::uint32_t number, const CollapseCosts& costs) {
    choices_[number] = costs.choice;
    return costs;
  }

  // Where a range's leaves may be.
  BinaryNode* among_leaves(std::uint32_t first) { return leaves_.data() + first; }
  BinaryNode* among_nodes(std::uint32_t first, std::uint32_t count) {
    return nodes_.data() + 2 * std::size_t{first} + count;
  }

  // Both in their order, the left ones first. Where a split is of all or nothing it becomes none.
  void partition(PlacedLeaves range, LeafSplit& split, PlacedLeaves& left, PlacedLeaves& right) {
    BinaryNode* const leaves = among_leaves(range.first);
    if (range.leaves != leaves) std::copy_n(range.leaves, range.count, leaves);
    BinaryNode* const rest = among_nodes(range.first, range.count);
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
    halve_if_one_sided(range, split, left_count);
    left = {leaves, range.first, left_count};
    right = {leaves + left_count, range.first + left_count, range.count - left_count};
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
    std::uint32_t left_count = left_before[chunks];
    halve_if_one_sided(range, split, left_count);
    const bool to_nodes = range.leaves == among_leaves(range.first);
    const auto place = [&](std::uint32_t first, std::uint32_t count) -> PlacedLeaves {
      return {to_nodes ? among_nodes(first, count) : among_leaves(first), first, count};
    };
    left = place(range.first, left_count);
    right = place(range.first + left_count, range.count - left_count);
    for_each_chunk(range.count, progress_, [&](std::uint32_t c, std::uint32_t begin, std::uint32_t end) {
      if (split.axis < 0) {
        for (std::uint32_t i = begin; i != end; ++i)
          put(box_of(range.leaves[i]), i < left_count ? left.leaves[i] : right.leaves[i - left_count]);
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

  static void halve_if_one_sided(const PlacedLeaves& range, LeafSplit& split, std::uint32_t& left_count) {
    if (left_count != 0 && left_count != range.count) return;
    split.axis = -1;
    left_count = range.count / 2;
  }

  HostArray<BinaryNode> leaves_, nodes_;
  HostArray<CollapseChoice> choices_;
  const ProgressMonitor* progress_;
};

} // namespace

BinaryHierarchy<TbbExecutor> top_down_hierarchy(HostArray<BinaryNode> leaves, const Boxd& space,
                                                const ProgressMonitor* progress) {
  return TopDownBuilder(std::move(leaves), progress).build(space);
}

} // namespace masu
