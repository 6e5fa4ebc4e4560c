// The top of a binary hierarchy, from the root down to clusters (cluster_passes.h), on whatever executor
// (executor.h): level by level by the surface area heuristic over bins (Wald, "On Fast Construction of
// SAH-based Bounding Volume Hierarchies", RT 2007).
//
//   1. split    of each node's clusters by where their centres are
//   2. sort     clusters by the node of the next level that they are in, else in their order; 1 and 2 until
//               each is alone
//   3. combine  boxes and costs, from the lowest level up
//
// No byte of the result depends on the executor or its number of threads.
#pragma once

#include "libgrid/build/passes/collapse_passes.h"
#include "libgrid/build/passes/thread_group.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace masu {

// An executor's clusters: roots of binary hierarchies, and what collapsing them costs.
template <class Executor>
struct Clusters {
  ArrayOf<Executor, BinaryNode> nodes;
  ArrayOf<Executor, CollapseCosts> costs;

  Clusters(const Executor& executor, std::uint64_t count)
      : nodes(executor.template array<BinaryNode>(count)),
        costs(executor.template array<CollapseCosts>(count)) {}
};

// A node's clusters: so many side by side.
struct ClusterRange {
  std::uint32_t first, count;
};

inline constexpr int cluster_bins = 16; // along each axis

// Which of a range's clusters go left: those whose centres are in bins up to the last; by none of the axes,
// the first ones.
struct ClusterSplit {
  float cost = INFINITY;
  std::int32_t axis = -1, last_bin = 0;
  std::uint32_t left = 0; // how many
  float low = 0, bins_per_unit = 0;

  // In a bin of this axis. `centre`: twice it.
  MASU_HD std::int32_t bin(float centre) const {
    return std::clamp(static_cast<std::int32_t>((centre - low) * bins_per_unit), 0, cluster_bins - 1);
  }
};
MASU_HD inline bool comes_before(const ClusterSplit& a, const ClusterSplit& b) {
  if (a.cost != b.cost) return a.cost < b.cost;
  return a.axis != b.axis ? a.axis < b.axis : a.last_bin < b.last_bin;
}

MASU_HD inline float twice_the_centre(const BinaryNode& node, int axis) {
  return node.min[axis] + node.max[axis];
}

// Whole numbers in the order of floats, which threads can make less or greater all at once.
MASU_HD inline std::uint32_t ordered(float value) {
  const std::uint32_t bits = bits_of(value), sign = 0x80000000U;
  return (bits & sign) != 0 ? ~bits : bits | sign;
}
MASU_HD inline float unordered(std::uint32_t number) {
  const std::uint32_t sign = 0x80000000U;
  return float_of((number & sign) != 0 ? number & ~sign : ~number);
}

// A box that a group of threads joins things to.
struct SharedBox {
  std::uint32_t min[3], max[3];

  MASU_HD void clear() {
    for (int axis = 0; axis < 3; ++axis) {
      min[axis] = ordered(INFINITY);
      max[axis] = ordered(-INFINITY);
    }
  }
  template <class ThreadGroup>
  MASU_HD void join(const ThreadGroup& group, int axis, float low, float high) {
    group.lower(min[axis], ordered(low));
    group.raise(max[axis], ordered(high));
  }
  MASU_HD Boxf box() const {
    return {{unordered(min[0]), unordered(min[1]), unordered(min[2])},
            {unordered(max[0]), unordered(max[1]), unordered(max[2])}};
  }
};

struct SplitRanges {
  struct Scratch {
    SharedBox centres;
    struct {
      SharedBox box;
      std::uint32_t count;
    } bins[3][cluster_bins];
  };
  const BinaryNode* clusters;
  const std::uint32_t* order; // of clusters
  const ClusterRange* ranges;
  ClusterSplit* splits;
  std::uint32_t most; // a range of more is halved, lest the hierarchy become too deep

  MASU_HD std::uint32_t size(std::uint64_t i) const { return ranges[i].count; }
  template <class ThreadGroup>
  MASU_HD void operator()(const ThreadGroup& group, Scratch& scratch, std::uint64_t i) const {
    const ClusterRange range = ranges[i];
    ClusterSplit best;
    if (range.count > 1 && range.count <= most) best = cheapest(group, scratch, range);
    if (group.thread_rank() != 0) return;
    if (best.axis < 0) best.left = range.count / 2;
    splits[i] = best;
  }

private:
  // For the first thread.
  template <class ThreadGroup>
  MASU_HD ClusterSplit cheapest(const ThreadGroup& group, Scratch& scratch, const ClusterRange& range) const {
    const auto for_each_cluster = [&](const auto& act) {
      for (std::uint32_t i = group.thread_rank(); i < range.count; i += group.size())
        act(clusters[order[range.first + i]]);
    };
    if (group.thread_rank() == 0) scratch.centres.clear();
    for (std::uint32_t i = group.thread_rank(); i < 3 * cluster_bins; i += group.size()) {
      auto& bin = scratch.bins[i / cluster_bins][i % cluster_bins];
      bin.box.clear();
      bin.count = 0;
    }
    group.sync();
    Boxf own = empty_box<float>();
    for_each_cluster([&](const BinaryNode& cluster) { own = join(own, cluster.min + cluster.max); });
    for (int axis = 0; axis < 3; ++axis)
      scratch.centres.join(group, axis, own.min[axis], own.max[axis]);
    group.sync();
    const Boxf centres = scratch.centres.box();
    ClusterSplit along[3];
    for (int axis = 0; axis < 3; ++axis) {
      const float scale = cluster_bins * 0.99999F / (centres.max[axis] - centres.min[axis]);
      along[axis].axis = axis;
      along[axis].low = centres.min[axis];
      along[axis].bins_per_unit = scale < INFINITY ? scale : 0; // all in one place, or nearly
    }
    for_each_cluster([&](const BinaryNode& cluster) {
      for (int axis = 0; axis < 3; ++axis) {
        auto& bin = scratch.bins[axis][along[axis].bin(twice_the_centre(cluster, axis))];
        for (int side = 0; side < 3; ++side)
          bin.box.join(group, side, cluster.min[side], cluster.max[side]);
        group.count(bin.count);
      }
    });
    group.sync();
    ClusterSplit best;
    for (auto axis = static_cast<int>(group.thread_rank()); axis < 3;
         axis += static_cast<int>(group.size())) {
      const ClusterSplit split = cheapest_along(along[axis], scratch, range.count);
      if (comes_before(split, best)) best = split;
    }
    return group.first_of_all(best);
  }

  MASU_HD static ClusterSplit cheapest_along(ClusterSplit split, const Scratch& scratch,
                                             std::uint32_t count) {
    const auto& bins = scratch.bins[split.axis];
    float right_area[cluster_bins]; // of all from a bin on
    Boxf box = empty_box<float>();
    for (int bin = cluster_bins; --bin > 0;) {
      box = join(box, bins[bin].box.box());
      right_area[bin] = half_area(box);
    }
    ClusterSplit best;
    box = empty_box<float>();
    for (int bin = 0; bin + 1 < cluster_bins; ++bin) {
      box = join(box, bins[bin].box.box());
      split.left += bins[bin].count;
      if (split.left == 0) continue;
      if (split.left == count) break;
      split.cost = half_area(box) * static_cast<float>(split.left) +
                   right_area[bin + 1] * static_cast<float>(count - split.left);
      split.last_bin = bin;
      if (comes_before(split, best)) best = split;
    }
    return best;
  }
};

// Nodes of one depth. The children of the first are the first two of the next level, and so on.
template <class Executor>
struct TopLevel {
  ArrayOf<Executor, ClusterRange> ranges{};
  ArrayOf<Executor, std::uint32_t> first_child{};
  std::uint32_t first_node = 0; // its nodes' numbers in the hierarchy follow one another
};

// Clusters sorted by their ranges in a level; no_range where they are alone in one of a higher level.
inline constexpr std::uint32_t no_range = 0xffffffffU;
template <class Executor>
struct ClusterOrder {
  ArrayOf<Executor, std::uint32_t> clusters{}, ranges{};

  ClusterOrder(const Executor& executor, std::uint64_t count)
      : clusters(executor.template array<std::uint32_t>(count)),
        ranges(executor.template array<std::uint32_t>(count)) {}
};

// Splits a level's ranges; returns the next level's.
template <class Executor>
ArrayOf<Executor, ClusterRange>
split_level(Executor& executor, const Clusters<Executor>& clusters, std::uint32_t count, std::uint32_t most,
            TopLevel<Executor>& level, ClusterOrder<Executor>& order, ClusterOrder<Executor>& next) {
  const std::uint64_t range_count = level.ranges.size();
  auto all_splits = executor.template array<ClusterSplit>(range_count);
  const BinaryNode* const node = clusters.nodes.data();
  const std::uint32_t *const cluster = order.clusters.data(), *const range_of = order.ranges.data();
  const ClusterRange* const ranges = level.ranges.data();
  const ClusterSplit* const splits = all_splits.data();
  executor.for_each_by_group(range_count, SplitRanges{node, cluster, ranges, all_splits.data(), most});
  level.first_child = sums_before(executor, range_count,
                                  [=] MASU_PASS(std::uint64_t i) { return ranges[i].count > 1 ? 2U : 0U; });
  const auto left_sums = sums_before(executor, count, [=] MASU_PASS(std::uint64_t i) {
    const std::uint32_t range = range_of[i];
    if (range == no_range) return false;
    const ClusterSplit& split = splits[range];
    return split.axis < 0 ? i - ranges[range].first < split.left
                          : split.bin(twice_the_centre(node[cluster[i]], split.axis)) <= split.last_bin;
  });
  const std::uint32_t *const first_child = level.first_child.data(), *const left_before = left_sums.data();
  std::uint32_t *const next_cluster = next.clusters.data(), *const next_range_of = next.ranges.data();
  executor.for_each(count, [=] MASU_PASS(std::uint64_t i) {
    const std::uint32_t range = range_of[i];
    std::uint64_t to = i;
    std::uint32_t child = no_range;
    if (range != no_range && ranges[range].count > 1) {
      const std::uint32_t first = ranges[range].first, left = left_before[i] - left_before[first];
      const bool goes_left = left_before[i + 1] != left_before[i];
      to = goes_left ? first + left : i - left + splits[range].left;
      child = first_child[range] + (goes_left ? 0 : 1);
    }
    next_cluster[to] = cluster[i];
    next_range_of[to] = child;
  });
  std::swap(order, next);
  auto children = executor.template array<ClusterRange>(executor.value(level.first_child, range_count));
  ClusterRange* const child = children.data();
  executor.for_each(range_count, [=] MASU_PASS(std::uint64_t i) {
    if (ranges[i].count == 1) return;
    const std::uint32_t left = splits[i].left;
    child[first_child[i]] = {ranges[i].first, left};
    child[first_child[i] + 1] = {ranges[i].first + left, ranges[i].count - left};
  });
  return children;
}

// Writes the root and all nodes between it and the first `count` clusters: in pairs from `first_pair` on.
// `height`: of the highest cluster, or more.
template <class Executor>
void split_clusters(Executor& executor, const Clusters<Executor>& clusters, std::uint32_t count, int height,
                    std::uint32_t first_pair, BinaryHierarchy<Executor>& hierarchy) {
  ClusterOrder<Executor> order(executor, count), other(executor, count);
  auto ranges = executor.template array<ClusterRange>(1);
  std::uint32_t *const cluster = order.clusters.data(), *const range_of = order.ranges.data();
  ClusterRange* const all = ranges.data();
  executor.for_each(count, [=] MASU_PASS(std::uint64_t i) {
    cluster[i] = static_cast<std::uint32_t>(i);
    range_of[i] = 0;
    if (i == 0) *all = {0, count};
  });
  std::vector<TopLevel<Executor>> levels;
  for (std::uint32_t first_node = 0; ranges.size() > 0;) {
    // What is split off may leave one cluster fewer, which must still fit below when halved again and again.
    const int levels_below = max_hierarchy_depth - 2 - height - static_cast<int>(levels.size());
    levels.push_back({std::move(ranges), {}, first_node});
    ranges = split_level(executor, clusters, count, 1U << std::clamp(levels_below, 0, 31), levels.back(),
                         order, other);
    first_node = 2 * first_pair;
    first_pair += static_cast<std::uint32_t>(ranges.size() / 2);
  }
  const BinaryNode* const cluster_node = clusters.nodes.data();
  const CollapseCosts* const cluster_costs = clusters.costs.data();
  const std::uint32_t* const sorted = order.clusters.data();
  BinaryNode* const nodes = hierarchy.nodes.data();
  CollapseChoice* const choices = hierarchy.choices.data();
  std::uint32_t first_below = 0;
  auto costs_below = executor.template array<CollapseCosts>(0);
  for (; !levels.empty(); levels.pop_back()) {
    const TopLevel<Executor>& level = levels.back();
    auto level_costs = executor.template array<CollapseCosts>(level.ranges.size());
    CollapseCosts* const costs = level_costs.data();
    const CollapseCosts* const below = costs_below.data();
    const ClusterRange* const range = level.ranges.data();
    const std::uint32_t* const first_child = level.first_child.data();
    const std::uint32_t first_node = level.first_node;
    executor.for_each(level.ranges.size(), [=] MASU_PASS(std::uint64_t i) {
      BinaryNode& node = nodes[first_node + i];
      if (range[i].count == 1) {
        node = cluster_node[sorted[range[i].first]];
        costs[i] = cluster_costs[sorted[range[i].first]];
      } else {
        const std::uint32_t child = first_child[i], left = first_below + child;
        const Boxf box = join(nodes[left].box(), nodes[left + 1].box());
        node = {box.min, left, box.max, nodes[left].count + nodes[left + 1].count};
        costs[i] = collapse_costs(node, below[child], below[child + 1]);
      }
      choices[first_node + i] = costs[i].choice;
    });
    first_below = first_node;
    costs_below = std::move(level_costs);
  }
}

} // namespace masu
