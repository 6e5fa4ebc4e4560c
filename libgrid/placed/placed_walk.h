// The walk of one ray through placed meshes, on any processor: the hierarchy above the placements, and from
// each box of it that the ray meets on through the mesh's own, by the ray carried there (placement.h). One
// stack serves both.
#pragma once

#include "libgrid/hierarchy/walk/hierarchy_walk.h"
#include "libgrid/placed/upper_passes.h"

namespace masu {

template <class Real>
struct PlacedWalk {
  static constexpr std::uint32_t none = ~0U;

  HierarchyWalk<Real> walk; // of the level that it is in
  Vec3<Real> origin;        // of the ray there
  Real padding;             // of planes
  std::uint32_t placement;  // in whose mesh it is, or none

  template <class Stored, class TestRay>
  MASU_HD void begin(const PlacedRay<Stored>& seen, const TestRay& ray, HierarchyStack& stack) {
    walk = {};
    leave(ray);
    walk.next = HierarchyWalk<Real>::no_node;
    const PlacedView<Stored>& placed = seen.placed;
    const auto visit_later = [&](std::uint32_t root) {
      if (root != no_root) push(stack, walk.height, nodes_group(root, 1, 1, 0));
    };
    if (seen.world < placed.world_count) visit_later(placed.roots[seen.world]);
    visit_later(placed.roots[placed.world_count]);
    walk.go_back(stack, RealTraits<Real>::largest);
  }

  // As HierarchyWalk::advance().
  template <class Stored, class Visitor>
  MASU_HD bool advance(const PlacedRay<Stored>& seen, HierarchyStack& stack, Visitor& visitor) {
    constexpr std::uint32_t no_node = HierarchyWalk<Real>::no_node;
    const PlacedView<Stored>& placed = seen.placed;
    HierarchyNode node;
    if (walk.next != no_node) {
      node = fetched((placement == none ? placed.upper_nodes : placed.of_meshes.nodes) + walk.next);
      if (placement == none && node_slots(node) == 0) {
        visit_item(seen, node.first_reference, stack, visitor);
        if (walk.next != no_node) node = fetched(placed.of_meshes.nodes + walk.next);
      }
    }
    if (walk.next != no_node) {
      const MetBoxes met = boxes_met(node, origin, walk.inverse, visitor.farthest(), padding);
      visitor.counts.cell(met.bits == 0);
      walk.template enter<needs_order<Visitor>>(node, met, stack);
    }
    test(placed, stack, visitor);
    if (visitor.ends()) return false;
    while (walk.go_back(stack, visitor.farthest())) {
      if (!is_mark(walk.references) || walk.next != no_node) return true;
      if (walk.height == 0) return false; // nothing above it is left
      leave(visitor.ray);
    }
    return false;
  }

private:
  // On the stack below all that is of a placement's mesh.
  MASU_HD static HierarchyGroup mark() { return {none, 0}; }
  MASU_HD static bool is_mark(const HierarchyGroup& group) { return group.bits == 0; }

  // Shows the visitor the mesh's triangles in the boxes that were met.
  template <class Stored, class Visitor>
  MASU_HD void test(const PlacedView<Stored>& placed, [[maybe_unused]] HierarchyStack& stack,
                    Visitor& visitor) {
#ifdef __CUDA_ARCH__
    const int testing = __popc(__activemask());
#endif
    while (walk.references.bits != 0) {
#ifdef __CUDA_ARCH__
      if (__popc(__activemask()) * 4 < testing) return push(stack, walk.height, walk.references);
#endif
      const int leaf = lowest_bit(walk.references.bits);
      walk.references.bits &= walk.references.bits - 1;
      visitor.leaf(placed.leaf(placement, walk.references.first + static_cast<std::uint32_t>(leaf)));
    }
  }
  // Enters a placement, or shows the visitor what stands beside them.
  template <class Stored, class Visitor>
  MASU_HD void visit_item(const PlacedRay<Stored>& seen, std::uint32_t item, HierarchyStack& stack,
                          Visitor& visitor) {
    const PlacedView<Stored>& placed = seen.placed;
    walk.next = HierarchyWalk<Real>::no_node;
    if (item >= placed.count) return visitor.primitive(placed.triangle_count() + (item - placed.count));
    const Placement<Stored> own = fetched(placed.placements + item);
    if (!seen.sees(item, own)) return;
    push(stack, walk.height, mark());
    placement = item;
    origin = carried_point(own, visitor.ray.origin);
    invert(carried(own, visitor.ray.direction));
    padding = static_cast<Real>(own.padding);
    walk.next = own.root;
  }
  template <class TestRay>
  MASU_HD void leave(const TestRay& ray) {
    placement = none;
    origin = ray.origin;
    invert(ray.direction);
    padding = 0;
  }
  MASU_HD void invert(const Vec3<Real>& direction) {
    walk.inverse = bounded_inverse<Real>(
        {{}, {finite_inverse(direction.x), finite_inverse(direction.y), finite_inverse(direction.z)}, 0});
  }
};
// A node of a mesh's hierarchy leaves two groups at most, one above it a single one; roots and a mark are
// three.
static_assert(2 * max_hierarchy_depth + max_upper_levels + 3 <= max_stack_height);

// Every triangle of every placement that the ray sees, and what stands beside them.
template <class Stored, class Visitor>
MASU_HD inline void visit_all_placed(const PlacedRay<Stored>& seen, std::uint32_t primitives,
                                     Visitor& visitor) {
  const PlacedView<Stored>& placed = seen.placed;
  for (std::uint32_t i = 0; i < placed.count && !visitor.ends(); ++i) {
    const Placement<Stored>& own = placed.placements[i];
    if (!seen.sees(i, own) || (own.world != seen.world && own.world != every_world)) continue;
    const PlacedMesh<Stored>& mesh = placed.meshes[own.mesh];
    for (std::uint32_t leaf = 0; leaf < mesh.leaf_count; ++leaf)
      visitor.leaf(placed.leaf(i, mesh.first_leaf + leaf));
  }
  for (std::uint32_t number = placed.triangle_count(); number < primitives; ++number)
    visitor.primitive(number);
}

template <class Stored, class Real, class Visitor>
MASU_HD inline void visit(const PlacedRay<Stored>& seen, const ClippedRay<Real>&, std::uint32_t primitives,
                          Visitor& visitor) {
  if (seen.placed.is_brute_force) return visit_all_placed(seen, primitives, visitor);
  HierarchyStack stack;
  PlacedWalk<Real> walk;
  walk.begin(seen, visitor.ray, stack);
  while (walk.advance(seen, stack, visitor)) {
  }
}

} // namespace masu
