// Meshes and their placements as tracing sees them: where their arrays lie, on the host or on the device.
// Passed by value.
//
// Placed triangles have the numbers that they would have in a scene that holds them all: those of the first
// placement first. What stands beside the meshes, spheres and cones, comes after them, in a SceneView that
// counts the placed triangles as its own, but has none.
#pragma once

#include "libgrid/hierarchy/hierarchy.h"
#include "libgrid/placed/placement.h"
#include "libscene/passes/executor.h"

namespace masu {

// Of all meshes, one after the other: nodes of their hierarchies, and leaves, triangles in their order, each
// with its number in its mesh. Nodes have the numbers of nodes and leaves of all meshes.
template <class Stored>
struct MeshArrays {
  const HierarchyNode* nodes;
  const Leaf<Stored>* leaves;
  const std::uint32_t* leaf_of; // of each triangle that has a surface
};
// Where one of them is in these.
template <class Stored>
struct PlacedMesh {
  std::uint32_t root, first_leaf, leaf_count, first_triangle;
  std::uint32_t extremes[6]; // leaves of the triangles that reach farthest along each axis, down and up
  Box<Stored> box;           // of what has a surface
};

inline constexpr std::uint32_t every_world = 0xffffffffU, no_root = 0xffffffffU;

template <class Stored>
struct PlacedView {
  MeshArrays<Stored> of_meshes;
  const PlacedMesh<Stored>* meshes;
  const Placement<Stored>* placements;
  const std::uint32_t* first_triangles; // of each placement; and where the last one's end
  // Above all of them, a hierarchy of each world from roots[world] on, and one of what is in every world from
  // roots[world_count] on (upper_passes.h). A node without boxes is an item: a placement, or from `count` on
  // one of what stands beside them. So items are visited in the order of nodes, the nearest first.
  const HierarchyNode* upper_nodes;
  const std::uint32_t* roots;
  std::uint32_t count, world_count;
  bool is_brute_force; // without any hierarchy

  MASU_HD std::uint32_t triangle_count() const { return first_triangles[count]; }
  // What a ray needs to enter the mesh of a placement, whose node of the hierarchies above it is.
  MASU_HD auto entrance(const HierarchyNode& item) const {
    if constexpr (std::is_same_v<Stored, float>)
      return std::bit_cast<ItemNode>(item);
    else
      return fetched(placements + item.first_reference);
  }
  // Of a triangle's number.
  MASU_HD std::uint32_t placement_of(PrimitiveIndex number) const {
    return last_not_above(count, number, [this](std::uint32_t i) { return first_triangles[i]; });
  }
  // Of a placement a leaf of its mesh: with its number among all triangles.
  MASU_HD Leaf<Stored> leaf(std::uint32_t placement, std::uint32_t of_mesh) const {
    const Placement<Stored> own = fetched(placements + placement);
    const Leaf<Stored> in_mesh = fetched(of_meshes.leaves + of_mesh);
    Leaf<Stored> leaf{placed_triangle(own, in_mesh.record)};
    leaf.record.object = own.first_triangle + in_mesh.primitive();
    return leaf;
  }
  // Of a triangle by its number.
  MASU_HD Leaf<Stored> leaf(PrimitiveIndex number) const {
    const std::uint32_t placement = placement_of(number);
    const PlacedMesh<Stored>& mesh = meshes[placements[placement].mesh];
    return leaf(placement, of_meshes.leaf_of[mesh.first_triangle + (number - first_triangles[placement])]);
  }
};

// What a ray sees of them: the structure through which it is traced (libgrid/trace/trace.h).
template <class Stored>
struct PlacedRay {
  const PlacedView<Stored>& placed;
  std::uint32_t world = 0, mask = 0xffffffffU;
  const std::uint32_t* object_masks = nullptr;  // of each placement; null: all bits
  std::uint32_t excluded_object = no_primitive; // that its excluded primitive is of

  // Of its world's hierarchy and that of all worlds, each if there is one: then no_root.
  struct Roots {
    std::uint32_t first, second;
  };
  MASU_HD Roots roots() const {
    const std::uint32_t own = world < placed.world_count ? placed.roots[world] : no_root,
                        of_all = placed.roots[placed.world_count];
    return own != no_root ? Roots{own, of_all} : Roots{of_all, no_root};
  }
  bool sees_as(const PlacedRay& other) const { return world == other.world && mask == other.mask; }
  template <class Placed>
  MASU_HD bool sees(std::uint32_t number, const Placed& placement) const {
    return (placement.mask & mask) != 0 && (object_masks == nullptr || (object_masks[number] & mask) != 0);
  }
};

} // namespace masu
