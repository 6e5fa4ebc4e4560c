// The curves in which a plane perpendicular to an axis cuts a scene's primitives, as line segments: the
// outline of the geometry in pictures of slices.
#pragma once

#include "libscene/scene_view.h"

#include <array>
#include <vector>

namespace masu {

// Points in the world along the axes other than the plane's, in their order. They lie on the primitive, up
// to rounding; curves are polygons of such points.
struct CutSegment {
  std::array<double, 2> from, to;
  PrimitiveIndex primitive;
};

// The plane, and what is wanted of it, in the world. `deviation`: how far a polygon may be from its curve, in
// scene units, greater than 0; a curve has 8 to 512 segments.
struct PlaneCut {
  int axis = 0; // to 2
  double position = 0;
  std::array<double, 2> min{}, max{}; // a window: segments of primitives whose bounds miss it are left out
  double deviation = 0;
  Vec3d origin{0, 0, 0}; // the scene's (local_origin.h)
};

// Triangles give the segment that they share with the plane, or their three sides when they lie in it;
// spheres a circle; cones and cylinders their side's ellipse, parabola, hyperbola or lines. What only touches
// the plane in a point gives nothing.
template <class Stored>
std::vector<CutSegment> plane_cut_of(const SceneView<Stored>& scene, const PlaneCut& options);

} // namespace masu
