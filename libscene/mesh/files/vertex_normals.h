// Normals at the vertices of an object that has none.
#pragma once

#include "libscene/mesh/files/mesh_file.h"

#include <span>
#include <vector>

namespace masu {

// For each vertex the sum of the unit normals of all the object's faces with a corner at its position,
// weighted by the corner's angle, after Thürmer & Wüthrich, "Computing Vertex Normals from Polygonal Facets",
// Journal of Graphics Tools 3(1), 1998. Zero where there is no such face, or none with area.
class VertexNormals {
public:
  // `file` outlives it.
  explicit VertexNormals(const MeshFile& file);
  // Takes that object's faces, in time of their number; before, and again for another one.
  void take(const MeshObject& object);
  Vec3d operator[](std::uint32_t vertex) const { return normals_[first_[vertex]]; }

private:
  const MeshFile& file_;
  std::vector<std::uint32_t> first_; // of each vertex: the first at its position
  std::vector<Vec3d> normals_;       // of those
};

} // namespace masu
