// A scene's triangles between vertices that have moved, on whatever executor (libscene/passes/executor.h).
// They are those of a new scene of these vertices with the same origin and store, byte for byte.
//
//   1. survey  of what they will be: bounds, the first one with an area, and what is wrong
//   2. write   them, relative to the origin, as they are stored
#pragma once

#include "libscene/base/error.h"
#include "libscene/file/scene_file.h"
#include "libscene/mesh/stored_triangles.h"
#include "libscene/passes/passes.h"
#include "libscene/scene_view.h"

#include <string>

namespace masu {

// What primitives will be.
struct MoveSurvey {
  Boxd bounds = empty_box<double>(); // of what can be hit, as it is stored
  // The first triangle that has an area; a coordinate that is none; an area, but isn't referred to.
  std::uint32_t first_surface = no_primitive, first_invalid = no_primitive, first_missing = no_primitive;
};
MASU_HD inline MoveSurvey join(const MoveSurvey& a, const MoveSurvey& b) {
  return {join(a.bounds, b.bounds), min(a.first_surface, b.first_surface),
          min(a.first_invalid, b.first_invalid), min(a.first_missing, b.first_missing)};
}

// Of primitive i.
template <class Stored, class Number>
struct SurveyOf {
  SceneView<Stored> scene;
  WorldVertices<Number> vertices;
  const std::uint32_t* listed; // the set of what a hierarchy refers to; null: nothing is missing

  MASU_HD MoveSurvey operator()(std::uint64_t index) const {
    MoveSurvey survey;
    const auto i = static_cast<std::uint32_t>(index), sphere = i - scene.triangle_count;
    if (i >= scene.triangle_count) {
      survey.bounds = sphere < scene.sphere_count ? cast<double>(bounds(scene.spheres[sphere]))
                                                  : bounds(scene.cones[sphere - scene.sphere_count]);
      return survey;
    }
    const Triangle<double> face = vertices.face(i);
    if (!is_coordinate(face.a) || !is_coordinate(face.b) || !is_coordinate(face.c)) {
      survey.first_invalid = i;
    } else if (has_distinct_corners(face.a, face.b, face.c)) {
      survey.first_surface = i;
      survey.bounds = cast<double>(bounds(stored_triangle<Stored>(vertices.origin, face)));
      if (listed != nullptr && (listed[i / 32] >> i % 32 & 1) == 0) survey.first_missing = i;
    }
    return survey;
  }
};

template <class Executor, class Stored>
struct MovedTriangles {
  bool is_missing = false; // one of them can be hit, but isn't referred to: nothing else is filled in then
  ArrayOf<Executor, Triangle<Stored>> triangles{}; // in the scene's order
  Boxd bounds{};                                   // of the whole scene, relative to its origin
};

// Of a scene where the executor sees it. `references`: so many of a hierarchy, or null where nothing is to be
// referred to. A hierarchy holds what is no farther than `max_reach`. Throws Error(usage, "vertices", …) for
// coordinates that aren't finite or beyond 1e100, or that the scene's store or a hierarchy doesn't hold.
// Vertices between which there is no triangle aren't read.
template <class Executor, class Stored, class Number>
MovedTriangles<Executor, Stored>
moved_triangles(Executor& executor, const SceneView<Stored>& scene, const WorldVertices<Number>& vertices,
                const PrimitiveIndex* references, std::uint64_t reference_count, double max_reach) {
  const auto fail = [](const std::string& what) { throw Error(ErrorCode::usage, "vertices", what); };
  const auto listed =
      set_of(executor, references, reference_count, references != nullptr ? scene.primitive_count() : 0);
  const auto survey =
      executor.value(executor.template joined<MoveSurvey>(
                         scene.primitive_count(), SurveyOf<Stored, Number>{scene, vertices, listed.data()}),
                     0);
  if (survey.first_invalid != no_primitive)
    fail("triangle " + std::to_string(survey.first_invalid) +
         " has a coordinate that isn't finite or beyond 1e100");
  if (survey.first_missing != no_primitive) return {true};
  const bool is_all_points = survey.first_surface == no_primitive;
  const auto in_no_surface = stored_point<Stored>(vertices.origin, points_without_surface);
  const bool in_leaf_order = scene.places != nullptr;
  const std::uint64_t records = in_leaf_order ? reference_count + 1 : scene.triangle_count;
  MovedTriangles<Executor, Stored> moved{false, executor.template array<Triangle<Stored>>(records),
                                         survey.bounds};
  if (is_all_points && scene.triangle_count > 0)
    moved.bounds = join(moved.bounds, cast<double>(in_no_surface));
  if (!reaches_within<Stored>(moved.bounds) ||
      largest_magnitude(padded_bounds<Stored>(moved.bounds)) > max_reach)
    fail("reach farther from the scene's origin than its store or a hierarchy holds: make a new scene");
  const Triangle<Stored>* const before = scene.triangles;
  Triangle<Stored>* const after = moved.triangles.data();
  const std::uint64_t first_corner = 3 * std::uint64_t{survey.first_surface};
  executor.for_each(records, [=] MASU_PASS(std::uint64_t i) {
    const std::uint64_t number = !in_leaf_order ? i : i < reference_count ? references[i] : no_primitive;
    if (number >= scene.triangle_count) { // of another kind, or none
      after[i] = before[i];
      return;
    }
    const Triangle<double> face = vertices.face(number);
    Triangle<Stored> triangle = stored_triangle<Stored>(vertices.origin, face);
    if (!has_distinct_corners(face.a, face.b, face.c))
      triangle.a = triangle.b = triangle.c =
          is_all_points ? in_no_surface
                        : stored_point<Stored>(vertices.origin, vertices.corner(first_corner));
    triangle.object = before[i].object;
    triangle.material = before[i].material;
    triangle.normals = before[i].normals;
    after[i] = triangle;
  });
  return moved;
}

} // namespace masu
