// Placements made ready for tracing, on whatever executor (libscene/passes/executor.h):
//
//   1. invert  transforms; boxes around what they place
//   2. survey  of all boxes, of triangles that reach far, and of what is wrong
//   3. pad     placements, as far as rays can reach
//   4. bounds  of all triangles, exactly: rays are clipped to them, so they decide bits of every t. Of
//              meshes' hierarchies only those boxes are looked into that reach beyond what is known.
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
  std::uint32_t* listed_count; // becomes 0: a launch less than to clear it

  MASU_HD PlacedSurvey<Stored> operator()(std::uint64_t i) const {
    if (i == 0) *listed_count = 0;
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

// The first placement that is too large for the others' reach.
struct FirstFar {
  std::uint32_t number = no_primitive;
};
MASU_HD inline FirstFar join(const FirstFar& a, const FirstFar& b) {
  return {min(a.number, b.number)};
}
// Pads placement i, and lists those whose box reaches beyond the triangles that are known.
template <class Stored>
struct PadPlacement {
  PlacedParts<Stored> parts;
  const PlacedSurvey<Stored>* survey;
  Placement<Stored>* placements;
  std::uint32_t *listed, *listed_count;

  MASU_HD FirstFar operator()(std::uint64_t index) const {
    const auto i = static_cast<std::uint32_t>(index);
    const PlacedMesh<Stored>& mesh = parts.meshes[parts.mesh[i]];
    if (survey->first_singular != no_primitive || is_empty(mesh.box)) return {};
    const double reach = largest_magnitude(padded_bounds<Stored>(around_all(parts, *survey)));
    const Boxd box = cast<double>(mesh.box);
    const Vec3d low = magnitudes(box.min), high = magnitudes(box.max);
    const Vec3d extent{max(low.x, high.x), max(low.y, high.y), max(low.z, high.z)};
    if (!pad(extent, reach, placements[i])) return {i};
    if (reach_beyond(survey->known, placed_box(placements[i], mesh.box)) > 0)
      listed[added(*listed_count, 1)] = i;
    return {};
  }
};

// The bounds of what is known, and of listed placements' triangles where they reach beyond that: of number i,
// and of every `groups`-th after it.
template <class Stored>
struct SearchListed {
  using Scratch = typename BoundsSearch<Stored>::Scratch;
  static constexpr unsigned threads = BoundsSearch<Stored>::most_nodes * boxes_per_node;
  PlacedParts<Stored> parts;
  const PlacedSurvey<Stored>* survey;
  const Placement<Stored>* placements;
  const std::uint32_t *listed, *listed_count;
  Box<Stored>* bounds;
  std::uint32_t groups;

  template <class Group>
  MASU_HD void operator()(const Group& group, Scratch& scratch, std::uint64_t i) const {
    for (; i < *listed_count; i += groups) {
      BoundsSearch<Stored> search{parts.of_meshes, placements[listed[i]], survey->known};
      search.run(group, scratch);
      if (group.thread_rank() == 0) bounds[i] = search.bounds;
    }
  }
};

// All placements together, once they are padded and searched.
template <class Stored>
struct PlacedFindings {
  PlacedSurvey<Stored> survey{};
  FirstFar far{};
  Box<Stored> triangles = empty_box<Stored>(); // their bounds
};
template <class Stored>
MASU_HD inline PlacedFindings<Stored> join(const PlacedFindings<Stored>& a, const PlacedFindings<Stored>& b) {
  return {join(a.survey, b.survey), join(a.far, b.far), join(a.triangles, b.triangles)};
}
template <class Stored>
struct FindingsOf {
  const PlacedSurvey<Stored>* survey;
  const FirstFar* far;
  const std::uint32_t* listed_count;
  const Box<Stored>* bounds;

  MASU_HD PlacedFindings<Stored> operator()(std::uint64_t i) const {
    return {*survey, *far, i < *listed_count ? bounds[i] : survey->known};
  }
};

// Bounds of what is traced. Of triangles without any surface those that a scene of such has.
template <class Stored>
MASU_HD inline Boxd bounds_of_all(const PlacedParts<Stored>& parts, const PlacedFindings<Stored>& found) {
  Boxd bounds = cast<double>(found.triangles);
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
  const PlacedFindings<Stored>* found;

  MASU_HD Boxf box(std::uint32_t item) const {
    const double margin = rounding_margin<Stored>(bounds_of_all(parts, *found));
    if (item >= parts.count) return box_of_primitive(parts.beside, item - parts.count, margin);
    return box_around(cast<double>(placed_box(placements[item], parts.meshes[parts.mesh[item]].box)), margin);
  }
  MASU_HD HierarchyNode node(std::uint32_t item) const {
    return item_node(item, item < parts.count ? placements + item : nullptr);
  }
  // What holds nothing comes after all groups.
  MASU_HD std::uint64_t operator()(std::uint64_t i) const {
    const auto item = static_cast<std::uint32_t>(i);
    const bool is_placement = item < parts.count;
    if (is_placement && is_empty(parts.meshes[parts.mesh[item]].box))
      return std::uint64_t{parts.world_count + 1} << code_bits;
    const std::uint32_t world = is_placement ? parts.world[item] : every_world;
    const std::uint64_t group = world == every_world ? parts.world_count : world;
    const MortonCurve curve(padded_bounds<Stored>(around_all(parts, found->survey)));
    return group << code_bits | curve.code(box(item)) >> (3 * MortonCurve::bits_per_axis - code_bits);
  }
};

// Throws Error(usage, "placements", …) for a transform that has no inverse or isn't finite, and for what
// reaches farther than the store or a hierarchy holds.
template <class Executor, class Stored>
PlacedArrays<Executor, Stored> placed(Executor& executor, const PlacedParts<Stored>& parts,
                                      const Transform* transforms) {
  PlacedArrays<Executor, Stored> made{executor.template array<Placement<Stored>>(parts.count)};
  Placement<Stored>* const placements = made.placements.data();
  auto listed_there = executor.template array<std::uint32_t>(parts.count + std::uint64_t{1});
  auto bounds_there = executor.template array<Box<Stored>>(parts.count);
  std::uint32_t *const listed_count = listed_there.data(), *const listed = listed_count + 1;
  Box<Stored>* const bounds = bounds_there.data();
  const auto survey_there = executor.template joined<PlacedSurvey<Stored>>(
      parts.count, InvertPlacement<Stored>{parts, transforms, placements, listed_count});
  const PlacedSurvey<Stored>* const survey = survey_there.data();
  const auto far_there = executor.template joined<FirstFar>(
      parts.count, PadPlacement<Stored>{parts, survey, placements, listed, listed_count});
  const std::uint32_t groups = min(parts.count, 4096U); // fill any device; few are listed
  executor.for_each_by_group(
      groups, SearchListed<Stored>{parts, survey, placements, listed, listed_count, bounds, groups});
  const auto found_there = executor.template joined<PlacedFindings<Stored>>(
      parts.count, FindingsOf<Stored>{survey, far_there.data(), listed_count, bounds});

  // What is wrong. On a device all is queued before the host waits for it.
  const auto check = [&] {
    const auto fail = [](const std::string& what) { throw Error(ErrorCode::usage, "placements", what); };
    const PlacedFindings<Stored> found = executor.value(found_there, 0);
    if (const std::uint32_t singular = found.survey.first_singular; singular != no_primitive)
      fail("number " + std::to_string(singular) + " " + not_invertible);
    const auto check_reach = [&](const Boxd& box) {
      if (!reaches_within<Stored>(box) || largest_magnitude(padded_bounds<Stored>(box)) > max_hierarchy_reach)
        fail("reach farther from the scene's origin than its store or a hierarchy holds");
    };
    const Boxd around = around_all(parts, found.survey);
    if (!is_empty(around) && largest_magnitude(around) > 2 * max_hierarchy_reach) check_reach(around);
    if (found.far.number != no_primitive)
      fail("number " + std::to_string(found.far.number) +
           " shrinks its mesh too much for how far the scene reaches");
    made.bounds = bounds_of_all(parts, found);
    check_reach(made.bounds);
  };
  if constexpr (!Executor::has_warps) check();

  const std::uint64_t items =
      parts.count + parts.beside.sphere_count + std::uint64_t{parts.beside.cone_count};
  const std::uint32_t worlds = parts.world_count + 1;
  const int world_bits = static_cast<int>(std::bit_width(worlds));
  const UpperItems<Stored> upper{parts, placements, found_there.data()};
  const auto sorted = executor.sorted(items, world_bits + code_bits, upper);
  std::tie(made.upper_nodes, made.roots) = upper_hierarchies(executor, sorted, worlds, upper);
  if constexpr (Executor::has_warps) check();
  return made;
}

} // namespace masu
