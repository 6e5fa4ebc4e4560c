// A binary hierarchy that was split level by level, on whatever executor (executor.h): its nodes, and what
// they cost, from the lowest level up.
#pragma once

#include "libgrid/hierarchy/collapse_passes.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace masu {

// `levels`: of as many `ranges` as there are nodes of a depth; the children of the first of them are the
// first two of the next level, and so on. They are given up, the lowest first. split_nodes() say of
// node i whether it is_leaf(i), then its leaf(i), else its first_child(i) in the
// next level, and its box(i, left child, right child).
template <class Executor, class Level>
BinaryHierarchy<Executor> combined(Executor& executor, std::vector<Level> levels) {
  // The root, one that isn't there, and the others in pairs, one level after another.
  std::uint64_t end = 1;
  for (const Level& level : levels)
    end += level.ranges.size();
  BinaryHierarchy<Executor> hierarchy{executor.template array<BinaryNode>(end),
                                      executor.template array<CollapseChoice>(end)};
  BinaryNode* const nodes = hierarchy.nodes.data();
  CollapseChoice* const choices = hierarchy.choices.data();
  auto costs_below = executor.template array<CollapseCosts>(0);
  for (; !levels.empty(); levels.pop_back()) {
    const std::uint64_t count = levels.back().ranges.size(), first_below = end;
    end = levels.size() > 1 ? end - count : 0;
    auto level_costs = executor.template array<CollapseCosts>(count);
    CollapseCosts* const costs = level_costs.data();
    const CollapseCosts* const below = costs_below.data();
    executor.for_each(count, [=, own = levels.back().split_nodes()] MASU_PASS(std::uint64_t i) {
      BinaryNode& node = nodes[end + i];
      if (own.is_leaf(i)) {
        node = own.leaf(i);
        costs[i] = collapse_costs_of_leaf(node);
      } else {
        const std::uint32_t child = own.first_child(i);
        const BinaryNode &left = nodes[first_below + child], &right = nodes[first_below + child + 1];
        const Boxf box = own.box(i, left, right);
        node = {box.min, static_cast<std::uint32_t>(first_below) + child, box.max, left.count + right.count};
        costs[i] = collapse_costs(node, below[child], below[child + 1]);
      }
      choices[end + i] = costs[i].choice;
    });
    costs_below = std::move(level_costs);
  }
  return hierarchy;
}

} // namespace masu
