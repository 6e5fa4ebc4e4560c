// A binary hierarchy that was split level by level, on whatever executor (executor.h): its nodes, and what
// they cost, from the lowest level up.
#pragma once

#include "libgrid/hierarchy/collapse_passes.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace masu {

// What is made of a level's nodes: at their numbers in the hierarchy, and what they cost.
struct CombinedNodes {
  BinaryNode* nodes;
  CollapseChoice* choices;
  CollapseCosts* costs;             // of the level's nodes
  const CollapseCosts* below;       // of the next one's
  std::uint64_t first, first_below; // the numbers of both levels' first, where levels follow each other

  MASU_HD void put(std::uint64_t i, std::uint64_t number, const BinaryNode& node,
                   const CollapseCosts& its_costs) const {
    nodes[number] = node;
    choices[number] = its_costs.choice;
    costs[i] = its_costs;
  }
  // `child`: its left one's place in the next level, `pair`: its number; the right one's follow.
  MASU_HD void put_parent(std::uint64_t i, std::uint64_t number, const Boxf& box, std::uint32_t child,
                          std::uint32_t pair) const {
    const BinaryNode node = node_of(box, pair, nodes[pair], nodes[pair + 1]);
    put(i, number, node, collapse_costs(node, below[child], below[child + 1]));
  }
};

// Nodes and choices of `hierarchy`, which has room for them. `levels`: of as many `ranges` as there are nodes
// of a depth; the children of the first of them that has some are the first two of the next level, and so on.
// They are given up, the lowest first. split_nodes().combine(i, combined nodes) puts node i there.
template <class Executor, class Level>
void combine(Executor& executor, std::vector<Level> levels, BinaryHierarchy<Executor>& hierarchy) {
  std::uint64_t end = hierarchy.nodes.size();
  auto costs_below = executor.template array<CollapseCosts>(0);
  for (; !levels.empty(); levels.pop_back()) {
    const std::uint64_t count = levels.back().ranges.size(), first_below = end;
    end = levels.size() > 1 ? end - count : 0;
    auto level_costs = executor.template array<CollapseCosts>(count);
    const CombinedNodes to{hierarchy.nodes.data(),
                           hierarchy.choices.data(),
                           level_costs.data(),
                           costs_below.data(),
                           end,
                           first_below};
    executor.for_each(
        count, [=, own = levels.back().split_nodes()] MASU_PASS(std::uint64_t i) { own.combine(i, to); });
    costs_below = std::move(level_costs);
  }
}

} // namespace masu
