// A binary hierarchy that was split level by level, on whatever executor (executor.h): its nodes, and what
// they cost, from the lowest level up.
#pragma once

#include "libgrid/hierarchy/collapse_passes.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace masu {

// Nodes and choices of `hierarchy`, which has room for them. `levels`: of as many `ranges` as there are nodes
// of a depth; the children of the first of them that has some are the first two of the next level, and so on.
// They are given up, the lowest first. split_nodes() say of node i whether it is_there(i) at all; whether it
// is_made(i), with all that is below it, then its costs(i); or is_leaf(i), then its leaf(i); else its
// first_child(i) in the next level, and its box(i, left child, right child). number(i, first) and pair(i,
// first) are its own number in the hierarchy and that of its left child, which the right one's follows, where
// levels follow each other there and this or the next one begins with `first`.
template <class Executor, class Level>
void combine(Executor& executor, std::vector<Level> levels, BinaryHierarchy<Executor>& hierarchy) {
  std::uint64_t end = hierarchy.nodes.size();
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
      if (!own.is_there(i)) return;
      if (own.is_made(i)) {
        costs[i] = own.costs(i);
        return;
      }
      const std::uint64_t number = own.number(i, end);
      BinaryNode& node = nodes[number];
      if (own.is_leaf(i)) {
        node = own.leaf(i);
        costs[i] = collapse_costs_of_leaf(node);
      } else {
        const std::uint32_t child = own.first_child(i),
                            pair = static_cast<std::uint32_t>(own.pair(i, first_below));
        const BinaryNode &left = nodes[pair], &right = nodes[pair + 1];
        node = node_of(own.box(i, left, right), pair, left, right);
        costs[i] = collapse_costs(node, below[child], below[child + 1]);
      }
      choices[number] = costs[i].choice;
    });
    costs_below = std::move(level_costs);
  }
}

// Room for so many nodes.
template <class Executor>
BinaryHierarchy<Executor> room_for_nodes(const Executor& executor, std::uint64_t count) {
  return {executor.template array<BinaryNode>(count), executor.template array<CollapseChoice>(count)};
}

} // namespace masu
