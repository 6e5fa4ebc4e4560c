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
  Real outwards;            // that planes are moved
  std::uint32_t placement;  // in whose mesh it is, or none

  template <class Stored>
  MASU_HD void begin(const PlacedRay<Stored>& seen, const ClippedRay<Real>& near, HierarchyStack& stack) {
    walk.begin(near);
    placement = none;
    origin = near.ray.origin;
    outwards = 0;
    const auto [first, second] = seen.roots();
    walk.next = first;
    if (second != no_root) push(stack, walk.height, nodes_group(second, 1, 1, 0));
  }

  // As HierarchyWalk's, and the following.
  template <class Stored, class Visitor>
  MASU_HD bool advance(const PlacedRay<Stored>& seen, HierarchyStack& stack, Visitor& visitor) {
    HierarchyNode node; // NOLINT(cppcoreguidelines-pro-type-member-init): written where it is read
    if (comes_to_node(seen, stack, visitor, node)) {
      const MetBoxes met = boxes_met(node, origin, walk.inverse, visitor.farthest(), outwards);
      visitor.counts.cell(met.bits == 0);
      walk.template enter<needs_order<Visitor>>(node, met, stack);
    }
    walk.show_references(stack, visitor, [&](std::uint32_t leaf) { show_reference(seen, leaf, visitor); });
    return !visitor.ends() && comes_back(stack, visitor);
  }

  MASU_HD HierarchyWalk<Real>& level() { return walk; }
  template <class Stored, class Visitor>
  MASU_HD bool comes_to_node(const PlacedRay<Stored>& seen, HierarchyStack& stack, Visitor& visitor,
                             HierarchyNode& node) {
    if (walk.next == no_node) return false;
    const HierarchyNode* const of_meshes = seen.placed.of_meshes.nodes;
    node = fetched((placement == none ? seen.placed.upper_nodes : of_meshes) + walk.next);
    if (placement != none || node_slots(node) != 0) return true;
    visit_item(seen, node, stack, visitor);
    if (walk.next == no_node) return false;
    node = fetched(of_meshes + walk.next);
    return true;
  }
  template <class TestRay>
  MASU_HD const Vec3<Real>& origin_of(const TestRay&) const {
    return origin;
  }
  MASU_HD Real padding() const { return outwards; }
  template <class Stored, class Visitor>
  MASU_HD void show_reference(const PlacedRay<Stored>& seen, std::uint32_t leaf, Visitor& visitor) const {
    visitor.leaf(seen.placed.leaf(placement, leaf));
  }
  template <class Visitor>
  MASU_HD bool comes_back(HierarchyStack& stack, Visitor& visitor) {
    return walk.go_back(stack, visitor.farthest(), [&] {
      if (walk.height == 0) return false; // nothing above the mesh is left
      placement = none;
      origin = visitor.ray.origin;
      invert(visitor.ray.direction);
      outwards = 0;
      return true;
    });
  }

private:
  static constexpr std::uint32_t no_node = HierarchyWalk<Real>::no_node;

  // Enters a placement, or shows the visitor what stands beside them.
  template <class Stored, class Visitor>
  MASU_HD void visit_item(const PlacedRay<Stored>& seen, const HierarchyNode& node, HierarchyStack& stack,
                          Visitor& visitor) {
    const PlacedView<Stored>& placed = seen.placed;
    const std::uint32_t item = node.first_reference;
    walk.next = no_node;
    if constexpr (Visitor::kinds != with_triangles)
      if (item >= placed.count) return visitor.primitive(placed.triangle_count() + (item - placed.count));
    const auto own = placed.entrance(node);
    if (!seen.sees(item, own)) return;
    push(stack, walk.height, {none, 0}); // a mark below all that is of its mesh
    placement = item;
    origin = carried_point(own, visitor.ray.origin);
    invert(carried(own, visitor.ray.direction));
    outwards = static_cast<Real>(own.padding);
    walk.next = own.root;
  }
  MASU_HD void invert(const Vec3<Real>& direction) {
    walk.inverse = {bounded_reciprocal(direction.x), bounded_reciprocal(direction.y),
                    bounded_reciprocal(direction.z)};
  }
  // As bounded_inverse() has them; in float32 on a GPU within an ulp (placement.h), by one instruction.
  MASU_HD static Real bounded_reciprocal(Real along) {
    constexpr Real limit = 0x1p64F;
#ifdef __CUDA_ARCH__
    if constexpr (std::is_same_v<Real, float>) {
      asm("rcp.approx.ftz.f32 %0, %0;" : "+f"(along));
      return fast_min(fast_max(along, -limit), limit);
    }
#endif
    return fast_min(fast_max(finite_inverse(along), -limit), limit);
  }
};
// A node of a mesh's hierarchy leaves two groups at most, one above it a single one; roots and a mark are
// three.
static_assert(2 * max_hierarchy_depth + max_upper_levels + 3 <= max_stack_height);
static_assert(no_root == HierarchyWalk<float>::no_node);

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
MASU_HD inline void visit(const PlacedRay<Stored>& seen, const ClippedRay<Real>& near,
                          std::uint32_t primitives, Visitor& visitor) {
  if (seen.placed.is_brute_force) return visit_all_placed(seen, primitives, visitor);
  HierarchyStack stack;
  PlacedWalk<Real> walk{};
  walk.begin(seen, near, stack);
  while (walk.advance(seen, stack, visitor)) {
  }
}

} // namespace masu
