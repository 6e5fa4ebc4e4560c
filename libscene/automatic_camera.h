// What a camera that shows a whole scene needs: the scene's bounding sphere and the distance to it.
#pragma once

#include "libscene/scene.h"

namespace masu {

// Not tight, but enough for a view. Its radius is never so small that a camera would round to its centre; a
// unit sphere where the scene is empty.
Sphere<double> bounding_sphere(const Scene& scene);

// From a camera of the given vertical angle (degrees) and pixels to the centre of a sphere that fills the
// smaller of the image's height and width.
double framing_distance(double radius, double angle, std::int32_t width, std::int32_t height);

// v normalised, also when its square is out of a double's range.
Vec3d direction(const Vec3d& v);

} // namespace masu
