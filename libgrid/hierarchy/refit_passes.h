// A hierarchy fitted to primitives that have moved, on whatever executor (executor.h): the same nodes and
// references, with other boxes.
//
//   1. owners  of what was divided: of its references the first, which holds it whole; the others hold
//              nothing
//   2. levels  of nodes, from the root down
//   3. boxes   of nodes, from the lowest level up, as the builder would write them; of what holds nothing a
//              point at the node's origin, which lies outside of all else there
//
// No byte of the result depends on the executor or its number of threads.
#pragma once

#include "libgrid/hierarchy/node_boxes.h"
#include "libscene/passes/passes.h"

#include <utility>
#include <vector>

namespace masu {

// Whether every primitive that can be hit is referred to. One that had no surface when the hierarchy was
// built isn't in it.
template <class Executor, class Stored>
bool holds_all(Executor& executor, const SceneView<Stored>& scene,
               const ArrayOf<Executor, PrimitiveIndex>& references) {
  const auto listed_set = set_of(executor, references.data(), references.size(), scene.primitive_count());
  auto missing_count = executor.template zeros<std::uint32_t>(1);
  executor.for_each(scene.primitive_count(), [=, listed = listed_set.data(),
                                              missing = missing_count.data()] MASU_PASS(std::uint64_t i) {
    if ((listed[i / 32] >> i % 32 & 1) != 0) return;
    with_primitive(scene, static_cast<PrimitiveIndex>(i), [&](const auto& primitive) {
      if (has_surface(primitive)) added(*missing, 1);
    });
  });
  return executor.value(missing_count, 0) == 0;
}

// The nodes of those in a level.
template <class Executor>
ArrayOf<Executor, std::uint32_t> nodes_below(Executor& executor, const HierarchyNode* nodes,
                                             const ArrayOf<Executor, std::uint32_t>& level) {
  const std::uint32_t* const parent = level.data();
  const auto first_child = sums_before(executor, level.size(), [=] MASU_PASS(std::uint64_t i) {
    return count_bits(node_slots(nodes[parent[i]]));
  });
  auto below = executor.template array<std::uint32_t>(executor.value(first_child, level.size()));
  std::uint32_t* const child = below.data();
  const std::uint32_t* const first = first_child.data();
  executor.for_each(level.size(), [=] MASU_PASS(std::uint64_t i) {
    for (std::uint32_t k = 0; k != first[i + 1] - first[i]; ++k)
      child[first[i] + k] = nodes[parent[i]].first_node + k;
  });
  return below;
}

// Fits a node's boxes to what they hold; returns what is around them all. `owners`: of each primitive the
// reference that holds it; `boxes`: of the nodes below.
template <class Stored>
MASU_HD Boxf refit_node(const SceneView<Stored>& scene, double margin, const PrimitiveIndex* references,
                        const std::uint32_t* owners, const Boxf* boxes, HierarchyNode& node) {
  Boxf box[boxes_per_node], around = empty_box<float>();
  // A bit for each slot: nvcc 13.0 drops the last loop if that reads it of the boxes.
  std::uint32_t holding = 0;
  std::uint32_t next_node = node.first_node;
  for (int slot = 0; slot < boxes_per_node; ++slot) {
    box[slot] = empty_box<float>();
    const std::uint32_t held = slot_byte(node.slots, slot);
    if ((node_slots(node) >> slot & 1) != 0) {
      box[slot] = boxes[next_node++];
    } else {
      const std::uint32_t first = node.first_reference + references_begin(held);
      for (std::uint32_t i = first; i < first + references_in(held); ++i)
        if (owners[references[i]] == i)
          box[slot] = join(box[slot], box_of_primitive(scene, references[i], margin));
    }
    if (!is_empty(box[slot])) holding |= 1U << slot;
    around = join(around, box[slot]);
    for (int axis = 0; axis < 3; ++axis) {
      node.low[axis][slot / 4] &= ~(0xffU << slot % 4 * 8);
      node.high[axis][slot / 4] &= ~(0xffU << slot % 4 * 8);
    }
  }
  if (is_empty(around)) return around;
  const NodeUnits units(around, node);
  for (int slot = 0; slot < boxes_per_node; ++slot)
    if ((holding >> slot & 1) != 0) units.add_planes(slot, box[slot], node);
  return around;
}

template <class Executor, class Stored>
void refit(Executor& executor, const SceneView<Stored>& scene, double margin,
           ArrayOf<Executor, HierarchyNode>& nodes, const PrimitiveIndex* references,
           std::uint64_t reference_count) {
  auto all_owners = executor.template array<std::uint32_t>(scene.primitive_count());
  std::uint32_t* const owners = all_owners.data();
  executor.for_each(scene.primitive_count(), [=] MASU_PASS(std::uint64_t i) { owners[i] = 0xffffffffU; });
  executor.for_each(scene.primitive_count() > 0 ? reference_count : 0, [=] MASU_PASS(std::uint64_t i) {
    lower(owners[references[i]], static_cast<std::uint32_t>(i));
  });
  HierarchyNode* const node = nodes.data();
  std::vector<ArrayOf<Executor, std::uint32_t>> levels;
  for (auto level = executor.template zeros<std::uint32_t>(1); level.size() > 0;
       level = nodes_below(executor, node, levels.back()))
    levels.push_back(std::move(level));
  auto boxes = executor.template array<Boxf>(nodes.size());
  Boxf* const box = boxes.data();
  for (; !levels.empty(); levels.pop_back()) {
    const std::uint32_t* const number = levels.back().data();
    executor.for_each(levels.back().size(), [=] MASU_PASS(std::uint64_t i) {
      box[number[i]] = refit_node(scene, margin, references, owners, box, node[number[i]]);
    });
  }
}

} // namespace masu
