// Placements made ready for tracing, on whatever executor (libscene/passes/executor.h):
//
//   1. invert  transforms; boxes around what they place
//   2. survey  of all boxes, of triangles that reach far, and of what is wrong
//   3. sort    placements, padded as far as rays can reach, and what stands beside them, along a Morton
//              curve, world by world
//   4. bounds  of all triangles, exactly: rays are clipped to them, so they decide bits of every t. Of
//              meshes' hierarchies only those boxes are looked into that reach beyond what is known.
//   5. build   the hierarchies above them, a world's each (upper_passes.h)
//
// What a pass finds out stays where the next one reads it: the host looks at it once, in the end. Hits don't
// depend on the order; it is the same on all executors, up to what they round alike.
#pragma once

#include "libgrid/hierarchy/hierarchy_builder.h"
#include "libgrid/hierarchy/leaf_passes.h"
#include "libgrid/placed/bounds_search.h"
#include "libgrid/placed/placed_walk.h"
#include "libgrid/placed/upper_passes.h"
#include "libscene/base/error.h"
#include "libscene/file/scene_file.h"
#include "libscene/mesh/triangle_area.h"
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
  bool is_brute_force;
};

// What does, beside that: the result.
template <class Executor, class Stored>
struct PlacedArrays {
  PlacedParts<Stored> parts;
  ArrayOf<Executor, Transform> transforms{};
  ArrayOf<Executor, Placement<Stored>> placements{};
  ArrayOf<Executor, HierarchyNode> upper_nodes{};
  ArrayOf<Executor, std::uint32_t> roots{};
  Boxd bounds{}; // of all triangles, and what stands beside them, relative to the origin

  // As tracing sees it: the meshes, and what stands beside them (placed_view.h).
  PlacedView<Stored> view() const {
    return {parts.of_meshes, parts.meshes, placements.data(), parts.first_triangles, upper_nodes.data(),
            roots.data(),    parts.count,  parts.world_count, parts.is_brute_force};
  }
  SceneView<Stored> scene() const {
    SceneView<Stored> scene = parts.beside;
    scene.triangle_count = parts.triangle_count;
    scene.clip = cast<Stored>(padded_bounds<Stored>(bounds));
    return scene;
  }
};

// Of each placement which of the moves is its last, from 1 on, or 0; nothing where they are of all. Throws
// Error(usage, "indices", …) for one that isn't a placement's.
template <class Executor>
ArrayOf<Executor, std::uint32_t> last_moves(const Executor& executor, const PlacementMoves& moves,
                                            std::uint32_t count) {
  if (moves.indices == nullptr) return {};
  auto last = executor.template zeros<std::uint32_t>(count + std::uint64_t{1});
  std::uint32_t* const last_of = last.data();
  const std::uint32_t* const indices = moves.indices;
  executor.for_each(moves.count, [=] MASU_PASS(std::uint64_t i) {
    if (indices[i] < count)
      raise(last_of[indices[i]], static_cast<std::uint32_t>(i) + 1);
    else
      raise(last_of[count], indices[i]);
  });
  if (const std::uint32_t wrong = executor.value(last, count); wrong != 0)
    fail("indices", std::to_string(wrong) + " isn't a placement's: there are " + std::to_string(count));
  return last;
}

// Of placements: before they are known to be sound, and once they are padded and searched.
template <class Stored>
struct PlacedSurvey {
  Box<Stored> around = empty_box<Stored>();    // boxes
  Box<Stored> triangles = empty_box<Stored>(); // those that reach far; in the end all
  std::uint32_t first_singular = no_primitive;
  std::uint32_t first_far = no_primitive; // that is too large for the others' reach
};
template <class Stored>
MASU_HD inline PlacedSurvey<Stored> join(const PlacedSurvey<Stored>& a, const PlacedSurvey<Stored>& b) {
  return {join(a.around, b.around), join(a.triangles, b.triangles), min(a.first_singular, b.first_singular),
          min(a.first_far, b.first_far)};
}
// Inverts placement i where it is now, and looks at it.
template <class Stored>
struct InvertPlacement {
  PlacedParts<Stored> parts;
  Placement<Stored>* placements;
  PlacementMoves moves;
  const std::uint32_t* last; // last_moves()
  const Transform* before;   // where not all are moved
  Transform* after;

  MASU_HD PlacedSurvey<Stored> operator()(std::uint64_t i) const {
    PlacedSurvey<Stored> survey;
    const PlacedMesh<Stored>& mesh = parts.meshes[parts.mesh[i]];
    Placement<Stored> placement{};
    placement.root = mesh.root;
    placement.first_triangle = parts.first_triangles[i];
    placement.mesh = parts.mesh[i];
    placement.mask = parts.mask[i];
    placement.world = parts.world[i];
    const bool is_sound = set_transform(parts.origin, after[i] = moved(i), placement);
    placements[i] = placement;
    if (!is_sound) survey.first_singular = static_cast<std::uint32_t>(i);
    if (!is_sound || is_empty(mesh.box)) return survey;
    survey.around = placed_box(placement, mesh.box);
    for (const std::uint32_t leaf : mesh.extremes) {
      const Triangle<Stored> triangle = placed_surface(placement, parts.of_meshes.leaves[leaf].record);
      if (has_surface(triangle)) survey.triangles = join(survey.triangles, bounds(triangle));
    }
    return survey;
  }

private:
  MASU_HD Transform moved(std::uint64_t i) const {
    const std::uint64_t move = moves.indices != nullptr ? std::uint64_t{last[i]} : i + 1;
    if (move == 0) return before[i];
    const std::uint64_t first = (move - 1) * moves.numbers();
    Transform transform{};
    for (unsigned k = 0; k < 12; ++k)
      transform.rows[k / 4][k % 4] =
          moves.floats != nullptr ? double{moves.floats[first + k]} : moves.doubles[first + k];
    return transform;
  }
};

// The box that placements and what stands beside them are in.
template <class Stored>
MASU_HD inline Boxd around_all(const PlacedParts<Stored>& parts, const PlacedSurvey<Stored>& survey) {
  return join(cast<double>(survey.around), parts.beside_bounds);
}

// What all triangles are in, whether any has a surface or none. Of such without any a scene has a point.
template <class Stored>
MASU_HD inline Boxd around_triangles(const PlacedParts<Stored>& parts, const Box<Stored>& with_surface,
                                     const Boxd& around) {
  if (!is_empty(with_surface) || parts.triangle_count == 0) return join(around, parts.beside_bounds);
  // By its numbers: a device doesn't have the constant.
  const Vec3d nowhere{points_without_surface.x, points_without_surface.y, points_without_surface.z};
  const Vec3d point = cast<double>(cast<Stored>(relative_to(parts.origin, nowhere)));
  return join(join(around, point), parts.beside_bounds);
}

// Items of the upper hierarchies: placements, and after them what stands beside them; made ready, by their
// places in the order, of a world and along the curve.
template <class Stored>
struct PlacedItems {
  PlacedParts<Stored> parts;
  const PlacedSurvey<Stored>* survey;
  Placement<Stored>* placements;
  std::uint32_t *listed, *listed_count; // whose box reaches beyond the triangles that are known
  std::uint32_t* arrivals;              // become 0 (upper_passes.h)

  // With the margin of the placements' boxes, which contain what is traced: its own bounds are found later.
  MASU_HD Boxf box(std::uint32_t item) const {
    const double margin =
        rounding_margin<Stored>(around_triangles(parts, survey->triangles, cast<double>(survey->around)));
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
    arrivals[i] = 0;
    if (is_placement) make_ready(item);
    if (is_placement && is_empty(parts.meshes[parts.mesh[item]].box))
      return std::uint64_t{parts.world_count + 1} << code_bits;
    const std::uint32_t world = is_placement ? parts.world[item] : every_world;
    const std::uint64_t group = world == every_world ? parts.world_count : world;
    const MortonCurve curve(padded_bounds<Stored>(around_all(parts, *survey)));
    return group << code_bits | curve.code(box(item), code_bits);
  }

private:
  // Pads placement i, and lists it if it is to be searched.
  MASU_HD void make_ready(std::uint32_t i) const {
    const PlacedMesh<Stored>& mesh = parts.meshes[parts.mesh[i]];
    if (survey->first_singular != no_primitive || is_empty(mesh.box)) return;
    const double reach = largest_magnitude(padded_bounds<Stored>(around_all(parts, *survey)));
    const Boxd own = cast<double>(mesh.box);
    const Vec3d low = magnitudes(own.min), high = magnitudes(own.max);
    const Vec3d extent{max(low.x, high.x), max(low.y, high.y), max(low.z, high.z)};
    if (!pad(extent, reach, placements[i])) return;
    if (reach_beyond(survey->triangles, placed_box(placements[i], mesh.box)) > 0)
      listed[added(*listed_count, 1)] = i;
  }
};

// The bounds of what is known, and of listed placements' triangles where they reach beyond that: of number i,
// and of every `groups`-th after it.
template <class Stored>
struct SearchListed {
  using Scratch = typename BoundsSearch<Stored>::Scratch;
  static constexpr unsigned threads = BoundsSearch<Stored>::most_nodes * boxes_per_node;
  PlacedItems<Stored> items;
  Box<Stored>* bounds;
  std::uint32_t groups;

  template <class Group>
  MASU_HD void operator()(const Group& group, Scratch& scratch, std::uint64_t i) const {
    for (; i < *items.listed_count; i += groups) {
      BoundsSearch<Stored> search{items.parts.of_meshes, items.placements[items.listed[i]],
                                  items.survey->triangles};
      search.run(group, scratch);
      if (group.thread_rank() == 0) bounds[i] = search.bounds;
    }
  }
};

// Of what is traced. Throws Error(usage, "placements", …) for a transform that has no inverse or isn't
// finite, and for what reaches farther than the store or a hierarchy holds.
template <class Stored>
Boxd checked_bounds(const PlacedParts<Stored>& parts, const PlacedSurvey<Stored>& found) {
  if (const std::uint32_t singular = found.first_singular; singular != no_primitive)
    fail("placements", "number " + std::to_string(singular) + " " + not_invertible);
  const auto check_reach = [&](const Boxd& box) {
    if (!reaches_within<Stored>(box) || largest_magnitude(padded_bounds<Stored>(box)) > max_hierarchy_reach)
      fail("placements", "reach farther from the scene's origin than its store or a hierarchy holds");
  };
  const Boxd around = around_all(parts, found);
  if (!is_empty(around) && largest_magnitude(around) > 2 * max_hierarchy_reach) check_reach(around);
  if (found.first_far != no_primitive)
    fail("placements", "number " + std::to_string(found.first_far) +
                           " shrinks its mesh too much for how far the scene reaches");
  const Boxd bounds = around_triangles(parts, found.triangles, cast<double>(found.triangles));
  check_reach(bounds);
  return bounds;
}

// The survey of what is made ready.
template <class Executor, class Stored>
ArrayOf<Executor, PlacedSurvey<Stored>> searched(const Executor& executor, const PlacedItems<Stored>& items) {
  const std::uint32_t count = items.parts.count;
  auto bounds_there = executor.template array<Box<Stored>>(count);
  Box<Stored>* const bounds = bounds_there.data();
  const std::uint32_t groups = min(count, 4096U); // fill any device; few are listed
  executor.for_each_by_group(groups, SearchListed<Stored>{items, bounds, groups});
  return executor.template joined<PlacedSurvey<Stored>>(count, [=] MASU_PASS(std::uint64_t i) {
    PlacedSurvey<Stored> found = *items.survey;
    if (items.placements[i].padding == too_far) found.first_far = static_cast<std::uint32_t>(i);
    if (i < *items.listed_count) found.triangles = bounds[i];
    return found;
  });
}

// `before`: where those are that don't move. Throws as last_moves() and checked_bounds() do. A device is
// given all there is to do before the host waits for it, and what it needs meanwhile is given back before,
// too, where it can be: that takes the host as long as a pass.
template <class Executor, class Stored>
PlacedArrays<Executor, Stored> placed(const Executor& executor, const PlacedParts<Stored>& parts,
                                      const PlacementMoves& moves, const Transform* before) {
  const auto last = last_moves(executor, moves, parts.count);
  PlacedArrays<Executor, Stored> made{parts, executor.template array<Transform>(parts.count),
                                      executor.template array<Placement<Stored>>(parts.count)};
  Placement<Stored>* const placements = made.placements.data();
  auto listed = executor.template array<std::uint32_t>(parts.count);
  auto listed_count = executor.template zeros<std::uint32_t>(1);
  const auto survey = executor.template joined<PlacedSurvey<Stored>>(
      parts.count,
      InvertPlacement<Stored>{parts, placements, moves, last.data(), before, made.transforms.data()});

  const std::uint64_t count =
      parts.count + parts.beside.sphere_count + std::uint64_t{parts.beside.cone_count};
  const std::uint32_t worlds = parts.world_count + 1;
  auto arrivals = executor.template array<std::uint32_t>(count);
  const PlacedItems<Stored> items{parts,         survey.data(),       placements,
                                  listed.data(), listed_count.data(), arrivals.data()};
  auto sorted = executor.sorted(count, static_cast<int>(std::bit_width(worlds)) + code_bits, items);

  const Executor& beside = executor.beside();
  ArrayOf<Executor, PlacedSurvey<Stored>> found;
  const auto check = [&] { made.bounds = checked_bounds(parts, beside.value(found, 0)); };
  try {
    found = searched(beside, items);
    if constexpr (!Executor::has_warps) check();
    std::tie(made.upper_nodes, made.roots) =
        upper_hierarchies(executor, sorted, arrivals.data(), worlds, items);
  } catch (...) {
    beside.wait(); // before what it reads is given back
    throw;
  }
  if constexpr (Executor::has_warps) {
    arrivals = {};
    sorted = {};
    check();
    executor.wait();
  }
  return made;
}

} // namespace masu
