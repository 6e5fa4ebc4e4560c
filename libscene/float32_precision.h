// Whether float32 is precise enough for a scene: the rule of `--store auto`.
//
// A scene is stored as float32 unless float32 arithmetic couldn't tell its parts from each other. Digits
// beyond float32's are no reason: rounding a coordinate changes it by at most 1/128 of the error bound
// (margin.h), and results are right to that bound in any case.
#pragma once

#include "libscene/base/progress_monitor.h"
#include "libscene/local_origin.h"
#include "libscene/scene_view.h"

#include <cstdint>
#include <span>

namespace masu {

// The range of a scene's largest coordinate, and the largest of a light's, for which products of three
// coordinates neither overflow nor underflow in float32.
inline constexpr double min_float32_reach = 1e-10, max_float32_reach = 1e12;

// What float32 does to a scene. Lengths are in the scene's units.
struct Float32Precision {
  double margin = 0;   // the error bound of float32 arithmetic
  double across = 1;   // the longest side of the scene's bounds
  double rounding = 0; // the largest change of a coordinate or radius; infinite beyond float32's range
  std::uint64_t standing_alone = 0; // parts no larger than twice the margin, which rays may miss
  std::uint64_t moved_cones = 0;    // rounding moves them by more than the margin, or leaves them no length
  bool in_range = true;

  // So far from its local origin for its size that most hits are unreliable.
  bool is_far() const { return across < 256 * margin; }
  bool suffices() const { return in_range && !is_far() && standing_alone == 0 && moved_cones == 0; }
};

// The primitives and lights of a scene in host memory, to be stored relative to `origin`.
template <class Stored, class Triangles = std::span<const Triangle<Stored>>>
struct SceneSpans {
  Triangles triangles;
  std::span<const Sphere<Stored>> spheres;
  std::span<const Cone<Stored>> cones;
  std::span<const Light<Stored>> lights;
  Vec3d origin{0, 0, 0};
};
template <class Triangles>
SceneSpans<double, const Triangles&> spans_of(const SceneOf<Triangles>& scene, const Vec3d& origin) {
  return {scene.triangles, scene.spheres, scene.cones, scene.lights, origin};
}
// Of a view the coordinates are relative to its origin already.
template <class Stored>
SceneSpans<Stored> spans_of(const SceneView<Stored>& view, const Lighting<Stored>& lighting) {
  return {{view.triangles, view.triangle_count},
          {view.spheres, view.sphere_count},
          {view.cones, view.cone_count},
          {lighting.lights, lighting.light_count}};
}

// Coordinates must be finite. Takes time for one pass over the scene, but for triangles of meshes, of which
// enough is known, except the rounding; if there are small triangles, for two more, and about 100 bytes for
// each.
//
// A part is a sphere, a cone, or triangles that share corners. Parts with a triangle larger than twice the
// margin aren't counted: their small triangles belong to a surface that no ray slips through, and a ray that
// misses one of them for its neighbour is within the margin of either.
//
// Corners are shared if they are equal once rounded to float32. This is sound, since the rounded scene is
// traced: corners that were equal stay so, and what rounding joins was no farther apart than a hundredth of
// the margin, which results can't tell anyway. Corners farther apart may be meant as one, but a gap is
// between them, so they aren't.
template <class Stored, class Triangles>
Float32Precision float32_precision(const SceneSpans<Stored, Triangles>& scene,
                                   const ProgressMonitor* progress = nullptr);
template <class Triangles>
Float32Precision float32_precision(const SceneOf<Triangles>& scene, const Vec3d& origin = {0, 0, 0},
                                   const ProgressMonitor* progress = nullptr) {
  return float32_precision(spans_of(scene, origin), progress);
}

} // namespace masu
