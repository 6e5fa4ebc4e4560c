// Normals at the vertices of an Assimp mesh that has none.
#pragma once

#include "libscene/geometry/vector.h"

#include <assimp/mesh.h>

#include <vector>

namespace masu::import {

// For each vertex the sum of the unit normals of all faces with a corner at its position, weighted by the
// corner's angle, after Thürmer & Wüthrich, "Computing Vertex Normals from Polygonal Facets", Journal of
// Graphics Tools 3(1), 1998. Zero where there is no such face, or none with area. Corners' indices must be
// valid.
std::vector<Vec3d> vertex_normals(const aiMesh& mesh);

} // namespace masu::import
