// The bounds of a placement's triangles, by a search through its mesh's hierarchy.
#pragma once

#include "libgrid/hierarchy/node_boxes.h"
#include "libgrid/hierarchy/walk/hierarchy_walk.h"
#include "libgrid/placed/placed_view.h"

namespace masu {

// How far a box reaches beyond another, along any axis; not positive where that contains it.
template <class Stored>
MASU_HD inline Stored reach_beyond(const Box<Stored>& box, const Box<Stored>& other) {
  const Vec3<Stored> low = box.min - other.min, high = other.max - box.max;
  return max(max(max(low.x, low.y), low.z), max(max(high.x, high.y), high.z));
}

// A search for the bounds of all triangles of a placement, as they are stored, by a group of threads.
template <class Stored>
struct BoundsSearch {
  struct Held { // a box that there is something below
    std::uint32_t node, slot;
  };
  // What the group shares: boxes that wait, the nodes it is at, and how far their boxes reach beyond the
  // bounds.
  static constexpr std::uint32_t most_nodes = 4;
  struct Scratch {
    Held stack[max_hierarchy_depth * (most_nodes * boxes_per_node - 1) + 1];
    std::uint32_t nodes[most_nodes];
    Stored reaches[most_nodes * boxes_per_node];
  };
  MeshArrays<Stored> meshes;
  Placement<Stored> placement;
  Box<Stored> bounds; // all that is known, alike in all threads

  // Of what reaches beyond the bounds that first which reaches farthest; of a large group each eight threads
  // look into a node.
  template <class Group>
  MASU_HD void run(const Group& group, Scratch& scratch) {
    if (group.thread_rank() == 0) scratch.nodes[0] = placement.root;
    for (std::uint32_t height = 0, count = 1;;) {
      group.sync();
      Box<Stored> own = bounds;
      for (std::uint32_t box = group.thread_rank(); box < count * boxes_per_node; box += group.size())
        scratch.reaches[box] =
            look_into(meshes.nodes[scratch.nodes[box / boxes_per_node]], box % boxes_per_node, own);
      bounds = joined_by(group, own);
      group.sync();
      height = hold(group, count * boxes_per_node, height, scratch);
      group.sync();
      height = drop(group, scratch, height);
      if (height == 0) return;
      count = min(height, max(min(group.size() / boxes_per_node, most_nodes), 1U));
      if (group.thread_rank() < count) {
        const Held next = scratch.stack[height - 1 - group.thread_rank()];
        const HierarchyNode& above = meshes.nodes[next.node];
        scratch.nodes[group.thread_rank()] = node_in(above.first_node, node_slots(above), next.slot);
      }
      height -= count;
    }
  }

private:
  MASU_HD Stored reach(const HierarchyNode& node, std::uint32_t slot) const {
    return reach_beyond(
        bounds, placed_box(placement, cast<Stored>(box_around(box_of(node, static_cast<int>(slot)), 0))));
  }
  // How far a node below reaches beyond the bounds; triangles are joined to `own`.
  MASU_HD Stored look_into(const HierarchyNode& node, std::uint32_t slot, Box<Stored>& own) const {
    const std::uint32_t held = slot_byte(node.slots, static_cast<int>(slot));
    const Stored beyond = held != 0 ? reach(node, slot) : Stored{0};
    if (!(beyond > 0)) return 0;
    if ((node_slots(node) >> slot & 1) != 0) return beyond;
    const std::uint32_t begin = node.first_reference + references_begin(held);
    for (std::uint32_t i = begin; i < begin + references_in(held); ++i) {
      const Triangle<Stored> triangle = placed_surface(placement, meshes.leaves[i].record);
      if (has_surface(triangle)) own = join(own, masu::bounds(triangle));
    }
    return 0;
  }
  // Puts the nodes' boxes that reach beyond onto the stack, the one that reaches farthest on top.
  template <class Group>
  MASU_HD static std::uint32_t hold(const Group& group, std::uint32_t boxes, std::uint32_t height,
                                    Scratch& scratch) {
    std::uint32_t holding = 0;
    for (std::uint32_t k = 0; k < boxes; ++k)
      holding += scratch.reaches[k] > 0;
    for (std::uint32_t box = group.thread_rank(); box < boxes; box += group.size()) {
      const Stored own = scratch.reaches[box];
      if (!(own > 0)) continue;
      std::uint32_t nearer = 0;
      for (std::uint32_t k = 0; k < boxes; ++k)
        nearer +=
            scratch.reaches[k] > 0 && (scratch.reaches[k] < own || (scratch.reaches[k] == own && k > box));
      scratch.stack[height + nearer] = {scratch.nodes[box / boxes_per_node], box % boxes_per_node};
    }
    return height + holding;
  }
  // Drops what no longer reaches beyond the bounds from the top of the stack; each thread looks at one.
  template <class Group>
  MASU_HD std::uint32_t drop(const Group& group, const Scratch& scratch, std::uint32_t height) const {
    for (;;) {
      const std::uint32_t rank = group.thread_rank();
      bool reaches = false;
      if (rank < height) {
        const Held held = scratch.stack[height - 1 - rank];
        reaches = reach(meshes.nodes[held.node], held.slot) > 0;
      }
      const std::uint32_t bits = group.all_bits(reaches ? 1U << rank : 0U);
      if (bits != 0) return height - lowest_bit(bits);
      if (height <= group.size()) return 0;
      height -= group.size();
    }
  }
};

} // namespace masu
