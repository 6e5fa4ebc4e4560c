// Placements made ready for tracing, on whatever executor (libscene/passes/executor.h):
//
//   1. invert  transforms; boxes around what they place
//   2. survey  of all boxes, of triangles that reach far, and of what is wrong
//   3. bounds  of all triangles, exactly: rays are clipped to them, so they decide bits of every t. Of
//              meshes' hierarchies only those boxes are looked into that reach beyond what is known.
//   4. pad     placements, as far as rays can reach
//   5. sort    placements and what stands beside them along a Morton curve, world by world
//   6. build   the hierarchies above them, a world's each (upper_passes.h)
//
// What a pass finds out stays where the next one reads it: the host looks at it once, in the end. Hits don't
// depend on the order; it is the same on all executors, up to what they round alike.
#pragma once

#include "libgrid/hierarchy/hierarchy_builder.h"
#include "libgrid/hierarchy/leaf_passes.h"
#include "libgrid/placed/placed_walk.h"
#include "libgrid/placed/upper_passes.h"
#include "libscene/base/error.h"
#include "libscene/file/scene_file.h"
#include "libscene/mesh/points.h"
#include "libscene/passes/passes.h"

#include <algorithm>
#include <string>
#include <tuple>
#include <utility>

namespace masu {

// What doesn't move, where the executor sees it.
template <class Stored>
struct PlacedParts {
  MeshArrays<Stored> of_meshes;
  const PlacedMesh<Stored>* meshes;
  const std::uint32_t *mesh, *mask, *world; // of each placement
  const std::uint32_t* first_triangles;     // as PlacedView has them
  std::uint32_t count, world_count, triangle_count;
  Vec3d origin;
  SceneView<Stored> beside; // spheres and cones alone, relative to the origin
  Boxd beside_bounds;
};

// What does: the result.
template <class Executor, class Stored>
struct PlacedArrays {
  ArrayOf<Executor, Placement<Stored>> placements{};
  ArrayOf<Executor, HierarchyNode> upper_nodes{};
  ArrayOf<Executor, std::uint32_t> roots{};
  Boxd bounds{}; // of all triangles, and what stands beside them, relative to the origin
};

// As tracing sees it.
template <class Executor, class Stored>
PlacedView<Stored> view_of(const PlacedParts<Stored>& parts, const PlacedArrays<Executor, Stored>& arrays,
                           bool is_brute_force) {
  return {parts.of_meshes,
          parts.meshes,
          arrays.placements.data(),
          parts.first_triangles,
          arrays.upper_nodes.data(),
          arrays.roots.data(),
          parts.count,
          parts.world_count,
          is_brute_force};
}

// How far a box reaches beyond another, along any axis; not positive where that contains it.
template <class Stored>
MASU_HD inline Stored reach_beyond(const Box<Stored>& box, const Box<Stored>& other) {
  const Vec3<Stored> low = box.min - other.min, high = other.max - box.max;
  return max(max(max(low.x, low.y), low.z), max(max(high.x, high.y), high.z));
}

// Joins to `bounds` those of all triangles of a placement, as they are stored: of what reaches beyond them
// that first which reaches farthest.
template <class Stored>
MASU_HD inline void join_placed_bounds(const MeshArrays<Stored>& meshes, const Placement<Stored>& placement,
                                       Box<Stored>& bounds) {
  struct Held {
    std::uint32_t node, slot;
  };
  const auto reach = [&](const HierarchyNode& node, std::uint32_t slot) {
    return reach_beyond(bounds, placed_box(placement, cast<Stored>(box_around(box_of(node, slot), 0))));
  };
  Held stack[max_hierarchy_depth * (boxes_per_node - 1) + 1];
  int height = 0;
  for (std::uint32_t number = placement.root;;) {
    const HierarchyNode& node = meshes.nodes[number];
    const int floor = height;
    Stored reaches[boxes_per_node];
    for (std::uint32_t slot = 0; slot < boxes_per_node; ++slot) {
      const std::uint32_t held = slot_byte(node.slots, static_cast<int>(slot));
      const Stored own = held != 0 ? reach(node, slot) : Stored{0};
      if (!(own > 0)) continue;
      if ((node_slots(node) >> slot & 1) != 0) {
        int at = height++;
        for (; at > floor && reaches[at - floor - 1] > own; --at) {
          stack[at] = stack[at - 1];
          reaches[at - floor] = reaches[at - floor - 1];
        }
        stack[at] = {number, slot};
        reaches[at - floor] = own;
        continue;
      }
      const std::uint32_t begin = node.first_reference + references_begin(held);
      for (std::uint32_t i = begin; i < begin + references_in(held); ++i) {
        const Triangle<Stored> triangle = placed_surface(placement, meshes.leaves[i].record);
        if (has_surface(triangle)) bounds = join(bounds, masu::bounds(triangle));
      }
    }
    while (height > 0 && !(reach(meshes.nodes[stack[height - 1].node], stack[height - 1].slot) > 0))
      --height;
    if (height == 0) return;
    const HierarchyNode& above = meshes.nodes[stack[--height].node];
    number = node_in(above.first_node, node_slots(above), stack[height].slot);
  }
}

// Of placements, before they are known to be sound.
template <class Stored>
struct PlacedSurvey {
  Box<Stored> around = empty_box<Stored>(), known = empty_box<Stored>(); // boxes; triangles that reach far
  std::uint32_t first_singular = no_primitive;
};
template <class Stored>
MASU_HD inline PlacedSurvey<Stored> join(const PlacedSurvey<Stored>& a, const PlacedSurvey<Stored>& b) {
  return {join(a.around, b.around), join(a.known, b.known), min(a.first_singular, b.first_singular)};
}
// Inverts placement i, and looks at it.
template <class Stored>
struct InvertPlacement {
  PlacedParts<Stored> parts;
  const Transform* transforms;
  Placement<Stored>* placements;

  MASU_HD PlacedSurvey<Stored> operator()(std::uint64_t i) const {
    PlacedSurvey<Stored> survey;
    const PlacedMesh<Stored>& mesh = parts.meshes[parts.mesh[i]];
    Placement<Stored> placement{};
    placement.root = mesh.root;
    placement.first_triangle = parts.first_triangles[i];
    placement.mesh = parts.mesh[i];
    placement.mask = parts.mask[i];
    placement.world = parts.world[i];
    const bool is_sound = set_transform(parts.origin, transforms[i], placement);
    placements[i] = placement;
    if (!is_sound) survey.first_singular = static_cast<std::uint32_t>(i);
    if (!is_sound || is_empty(mesh.box)) return survey;
    survey.around = placed_box(placement, mesh.box);
    for (const std::uint32_t leaf : mesh.extremes) {
      const Triangle<Stored> triangle = placed_surface(placement, parts.of_meshes.leaves[leaf].record);
      if (has_surface(triangle)) survey.known = join(survey.known, bounds(triangle));
    }
    return survey;
  }
};

// The box that placements and what stands beside them are in.
template <class Stored>
MASU_HD inline Boxd around_all(const PlacedParts<Stored>& parts, const PlacedSurvey<Stored>& survey) {
  return join(cast<double>(survey.around), parts.beside_bounds);
}

// The bounds found so far, and the first placement that is too large for the others' reach.
template <class Stored>
struct PlacedBounds {
  Box<Stored> box = empty_box<Stored>();
  std::uint32_t first_far = no_primitive;
};
template <class Stored>
MASU_HD inline PlacedBounds<Stored> join(const PlacedBounds<Stored>& a, const PlacedBounds<Stored>& b) {
  return {join(a.box, b.box), min(a.first_far, b.first_far)};
}
// Pads placement i, and joins its triangles to what is known.
template <class Stored>
struct PadPlacement {
  PlacedParts<Stored> parts;
  const PlacedSurvey<Stored>* survey;
  Placement<Stored>* placements;

  MASU_HD PlacedBounds<Stored> operator()(std::uint64_t i) const {
    PlacedBounds<Stored> bounds{survey->known};
    const PlacedMesh<Stored>& mesh = parts.meshes[parts.mesh[i]];
    if (survey->first_singular != no_primitive || is_empty(mesh.box)) return bounds;
    const double reach = largest_magnitude(padded_bounds<Stored>(around_all(parts, *survey)));
    const Boxd box = cast<double>(mesh.box);
    const Vec3d low = magnitudes(box.min), high = magnitudes(box.max);
    const Vec3d extent{max(low.x, high.x), max(low.y, high.y), max(low.z, high.z)};
    if (!pad(extent, reach, placements[i]))
      bounds.first_far = static_cast<std::uint32_t>(i);
    else if (reach_beyond(bounds.box, placed_box(placements[i], mesh.box)) > 0)
      join_placed_bounds(parts.of_meshes, placements[i], bounds.box);
    return bounds;
  }
};

// Bounds of what is traced. Of triangles without any surface those that a scene of such has.
template <class Stored>
MASU_HD inline Boxd bounds_of_all(const PlacedParts<Stored>& parts, const PlacedBounds<Stored>& placed) {
  Boxd bounds = cast<double>(placed.box);
  if (is_empty(bounds) && parts.triangle_count > 0) {
    // By its numbers: a device doesn't have the constant.
    const Vec3d nowhere{points_without_surface.x, points_without_surface.y, points_without_surface.z};
    const Vec3d point = cast<double>(cast<Stored>(relative_to(parts.origin, nowhere)));
    bounds = {point, point};
  }
  return join(bounds, parts.beside_bounds);
}

// Items of the upper hierarchies, and their places in the order: of a world, and along the curve.
template <class Stored>
struct UpperItems {
  PlacedParts<Stored> parts;
  const Placement<Stored>* placements;
  const PlacedSurvey<Stored>* survey;
  const PlacedBounds<Stored>* bounds;

  MASU_HD Boxf box(std::uint32_t item) const {
    const double margin = rounding_margin<Stored>(bounds_of_all(parts, *bounds));
    if (item >= parts.count) return box_of_primitive(parts.beside, item - parts.count, margin);
    return box_around(cast<double>(placed_box(placements[item], parts.meshes[parts.mesh[item]].box)), margin);
  }
  // What holds nothing comes after all groups.
  MASU_HD std::uint64_t operator()(std::uint64_t i) const {
    const auto item = static_cast<std::uint32_t>(i);
    const bool is_placement = item < parts.count;
    if (is_placement && is_empty(parts.meshes[parts.mesh[item]].box))
      return std::uint64_t{parts.world_count + 1} << code_bits;
    const std::uint32_t world = is_placement ? parts.world[item] : every_world;
    const std::uint64_t group = world == every_world ? parts.world_count : world;
    const MortonCurve curve(padded_bounds<Stored>(around_all(parts, *survey)));
    return group << code_bits | curve.code(box(item)) >> (3 * MortonCurve::bits_per_axis - code_bits);
  }
};

// results[i] = act(i).
template <class Executor, class Part, class Act>
void run_for_each(Executor& executor, std::uint64_t count, Part* results, const Act& act) {
  executor.for_each(count, [=] MASU_PASS(std::uint64_t i) { results[i] = act(i); });
}

// Throws Error(usage, "placements", …) for a transform that has no inverse or isn't finite, and for what
// reaches farther than the store or a hierarchy holds.
template <class Executor, class Stored>
PlacedArrays<Executor, Stored> placed(Executor& executor, const PlacedParts<Stored>& parts,
                                      const Transform* transforms) {
  PlacedArrays<Executor, Stored> made{executor.template array<Placement<Stored>>(parts.count)};
  Placement<Stored>* const placements = made.placements.data();
  // What act(i) finds out about the placements, together: one, in the executor's memory.
  const auto joined_of = [&]<class Part>(Part, const auto& act) {
    auto each = executor.template array<Part>(parts.count);
    Part* const own = each.data();
    run_for_each(executor, parts.count, own, act);
    return joined_there<Part, 16>(executor, parts.count, ElementOf<Part>{own});
  };
  const auto survey_there =
      joined_of(PlacedSurvey<Stored>{}, InvertPlacement<Stored>{parts, transforms, placements});
  const auto bounds_there =
      joined_of(PlacedBounds<Stored>{}, PadPlacement<Stored>{parts, survey_there.data(), placements});

  // What is wrong. On a device all is queued before the host waits for it.
  const auto check = [&] {
    const auto fail = [](const std::string& what) { throw Error(ErrorCode::usage, "placements", what); };
    const PlacedSurvey<Stored> survey = executor.value(survey_there, 0);
    if (survey.first_singular != no_primitive)
      fail("number " + std::to_string(survey.first_singular) + " " + not_invertible);
    const auto check_reach = [&](const Boxd& bounds) {
      if (!reaches_within<Stored>(bounds) ||
          largest_magnitude(padded_bounds<Stored>(bounds)) > max_hierarchy_reach)
        fail("reach farther from the scene's origin than its store or a hierarchy holds");
    };
    const Boxd around = around_all(parts, survey);
    if (!is_empty(around) && largest_magnitude(around) > 2 * max_hierarchy_reach) check_reach(around);
    const PlacedBounds<Stored> bounds = executor.value(bounds_there, 0);
    if (bounds.first_far != no_primitive)
      fail("number " + std::to_string(bounds.first_far) +
           " shrinks its mesh too much for how far the scene reaches");
    made.bounds = bounds_of_all(parts, bounds);
    check_reach(made.bounds);
  };
  if constexpr (!Executor::has_warps) check();

  const std::uint64_t items =
      parts.count + parts.beside.sphere_count + std::uint64_t{parts.beside.cone_count};
  const std::uint32_t groups = parts.world_count + 1;
  const int group_bits = static_cast<int>(std::bit_width(groups));
  const UpperItems<Stored> upper{parts, placements, survey_there.data(), bounds_there.data()};
  const auto sorted = executor.sorted(items, group_bits + code_bits, upper);
  std::tie(made.upper_nodes, made.roots) = upper_hierarchies(
      executor, sorted, groups, [=] MASU_PASS(std::uint32_t item) { return upper.box(item); });
  if constexpr (Executor::has_warps) check();
  return made;
}

} // namespace masu
