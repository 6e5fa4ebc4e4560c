// Triangles that nothing can hit: they keep the numbers of a mesh's faces of which two corners coincide.
//
// Such a face isn't stored as it is: far from the others it would enlarge the scene's bounds, and with them
// every error bound. All three corners of its triangle are one point instead (has_surface, primitives.h),
// which no test hits, and which builders leave out.
#pragma once

#include "libscene/scene.h"

namespace masu {

// Puts the triangles without a surface where others are: in a corner of the first one that has a surface. So
// neither bounds nor the choice of the store depend on them. Where none has one, in this point.
inline constexpr Vec3d points_without_surface{1, 1, 1};
void place_points(GrowingArray<SceneTriangle>& triangles);

} // namespace masu
