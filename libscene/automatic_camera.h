// A camera that shows a whole scene: the scene's bounding sphere, and the distance to it.
#pragma once

#include "libscene/scene.h"

namespace masu {

// Not tight, but enough for a view. Its radius is never so small that a camera would round to its centre; a
// unit sphere where the scene is empty.
template <class Triangles>
Sphere<double> bounding_sphere(const SceneOf<Triangles>& scene);

// From a camera of the given vertical angle (degrees) and pixels to the centre of a sphere that fills the
// smaller of the image's height and width.
double framing_distance(double radius, double angle, std::int32_t width, std::int32_t height);

// NFF's automatic view: the whole scene from the front, right and above, at 45°; +z is up, or +y.
Camera automatic_camera(const Sphere<double>& whole, bool is_y_up, std::int32_t width, std::int32_t height);

// v normalised, also when its square is out of a double's range.
Vec3d direction(const Vec3d& v);

} // namespace masu
