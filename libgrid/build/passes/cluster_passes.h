// A binary hierarchy from the leaves up, on whatever executor (executor.h), by locally-ordered clustering
// (Meister & Bittner, "Parallel Locally-Ordered Clustering for Bounding Volume Hierarchy Construction", TVCG
// 24(3) 2018):
//
//   1. sort     primitives, or parts of them (part_passes.h), along a Morton curve: each is a cluster
//   2. search   of a cluster the neighbour, no more than so many places away, whose box together with its own
//               has the smallest surface
//   3. merge    clusters that are each other's; 2 and 3 until few are left
//   4. split    these from the root down (top_down_passes.h)
//
// A tie goes to the neighbour whose place differs in lower bits: a measure that two clusters share, so that
// some pair is always each other's, and equal boxes pair up at once. No byte of the result depends on the
// executor or its number of threads.
#pragma once

#include "libgrid/build/passes/part_passes.h"
#include "libgrid/build/passes/top_down_passes.h"

#include <algorithm>
#include <utility>

namespace masu {

// Places to either side in which neighbours are searched.
inline constexpr std::uint32_t search_radius = 8;

// Clusters of a primitive or a part of one, along the curve.
template <class Executor, class Stored>
Clusters<Executor> primitive_clusters(Executor& executor, const SceneView<Stored>& scene,
                                      const GridLayout& layout) {
  const Divider<Stored> divider = primitive_divider(executor, scene, layout);
  const auto sorted = executor.template emit_sorted<PrimitivePart>(
      scene.primitive_count(), 3 * MortonCurve::bits_per_axis, max_numbered, EmitParts<Stored>{divider});
  const std::uint64_t count = sorted->values.size();
  Clusters<Executor> clusters(executor, count);
  const PrimitivePart* const part = sorted->values.data();
  BinaryNode* const node = clusters.nodes.data();
  CollapseCosts* const costs = clusters.costs.data();
  executor.for_each(count, [=] MASU_PASS(std::uint64_t i) {
    const Boxf box = divider.box(part[i]);
    node[i] = {box.min, part[i].primitive, box.max, 1};
    costs[i] = collapse_costs_of_leaf(node[i]);
  });
  return clusters;
}

// Of cluster i, the neighbour that it would best be merged with; there are two clusters or more.
MASU_HD inline std::uint32_t best_neighbour(const BinaryNode* clusters, std::uint32_t count,
                                            std::uint32_t i) {
  const Boxf own = clusters[i].box();
  float least = INFINITY;
  std::uint32_t best = i;
  const std::uint32_t first = i < search_radius ? 0 : i - search_radius,
                      last = count - 1 - i < search_radius ? count - 1 : i + search_radius;
  for (std::uint32_t j = first; j <= last; ++j) {
    if (j == i) continue;
    const float area = half_area(join(own, clusters[j].box()));
    if (area < least || (area == least && (i ^ j) < (i ^ best))) {
      least = area;
      best = j;
    }
  }
  return best;
}

// Replaces `clusters` by fewer. Writes their nodes from `first_pair` on, and returns how many pairs they are.
template <class Executor>
std::uint32_t merge_round(Executor& executor, Clusters<Executor>& clusters, std::uint32_t count,
                          Clusters<Executor>& merged, ArrayOf<Executor, std::uint32_t>& partners,
                          std::uint32_t first_pair, BinaryHierarchy<Executor>& hierarchy) {
  const BinaryNode* const node = clusters.nodes.data();
  const CollapseCosts* const costs = clusters.costs.data();
  std::uint32_t* const partner = partners.data();
  executor.for_each(count, [=] MASU_PASS(std::uint64_t i) {
    partner[i] = best_neighbour(node, count, static_cast<std::uint32_t>(i));
  });
  // The second of a pair goes.
  auto pairs_before = sums_before(
      executor, count, [=] MASU_PASS(std::uint64_t i) { return partner[i] < i && partner[partner[i]] == i; });
  const std::uint32_t* const before = pairs_before.data();
  BinaryNode* const merged_node = merged.nodes.data();
  CollapseCosts* const merged_costs = merged.costs.data();
  BinaryNode* const nodes = hierarchy.nodes.data();
  CollapseChoice* const choices = hierarchy.choices.data();
  executor.for_each(count, [=] MASU_PASS(std::uint64_t i) {
    if (before[i] != before[i + 1]) return;
    const std::uint64_t to = i - before[i];
    const std::uint32_t other = partner[i];
    if (other <= i || partner[other] != i) {
      merged_node[to] = node[i];
      merged_costs[to] = costs[i];
      return;
    }
    const std::uint32_t left = 2 * (first_pair + before[other]);
    nodes[left] = node[i];
    nodes[left + 1] = node[other];
    choices[left] = costs[i].choice;
    choices[left + 1] = costs[other].choice;
    const Boxf box = join(node[i].box(), node[other].box());
    const BinaryNode both{box.min, left, box.max, node[i].count + node[other].count};
    merged_node[to] = both;
    merged_costs[to] = collapse_costs(both, costs[i], costs[other]);
  });
  std::swap(clusters, merged);
  return executor.value(pairs_before, count);
}

// Clusters are merged until they hold so many primitives on average, or few of them are each other's: what is
// above is better split from the root down. So many rounds at most, since each adds a level.
inline constexpr std::uint32_t primitives_per_cluster = 8, clusters_per_pair = 32;
inline constexpr int max_rounds = 16;

template <class Executor, class Stored>
BinaryHierarchy<Executor> clustered_hierarchy(Executor& executor, const SceneView<Stored>& scene,
                                              const GridLayout& layout) {
  Clusters<Executor> clusters = primitive_clusters(executor, scene, layout);
  auto count = static_cast<std::uint32_t>(clusters.nodes.size());
  BinaryHierarchy<Executor> hierarchy;
  if (count == 0) return hierarchy;
  // The root, one that isn't there, and the others in pairs.
  hierarchy.nodes = executor.template array<BinaryNode>(2 * std::uint64_t{count});
  hierarchy.choices = executor.template array<CollapseChoice>(2 * std::uint64_t{count});
  Clusters<Executor> merged(executor, count);
  auto partners = executor.template array<std::uint32_t>(count);
  const std::uint32_t few = count / primitives_per_cluster;
  std::uint32_t first_pair = 1;
  int rounds = 0;
  for (bool pays = true; pays && count > few && count > 1 && rounds < max_rounds; ++rounds) {
    const std::uint32_t pairs =
        merge_round(executor, clusters, count, merged, partners, first_pair, hierarchy);
    pays = pairs >= count / clusters_per_pair;
    first_pair += pairs;
    count -= pairs;
  }
  split_clusters(executor, clusters, count, rounds, first_pair, hierarchy);
  return hierarchy;
}

} // namespace masu
