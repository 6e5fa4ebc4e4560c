// What a scene's triangles must be for inside and outside to mean something: closed, and turned alike.
#pragma once

#include "libscene/scene_view.h"

#include <array>

namespace masu {

// How many there are of a kind, and the first of them: each by the first corner, 3 t + c of triangle t, where
// it is met. An edge runs from its corner to the triangle's next one.
struct MeshFaults {
  std::uint64_t count = 0;
  std::array<std::uint32_t, 8> first{};

  std::size_t examples() const {
    return count < first.size() ? static_cast<std::size_t>(count) : first.size();
  }
};

// Corners with the same stored coordinates are one point, whatever their objects. Edges have a length, and
// are of triangles that have a surface.
struct MeshCheck {
  std::uint64_t points = 0, edges = 0;
  MeshFaults open;         // edges of an odd number of triangles: lines don't cross an even number of times
  MeshFaults inconsistent; // edges of an even number, of which not half run along it either way
  MeshFaults nonmanifold;  // edges of more than two triangles
  MeshFaults no_area;      // triangles whose corners are on a line, or one point
  MeshFaults duplicates;   // triangles with the three points of one before, in any order
};

// Throws Error(usage) for more triangles than corners can be numbered.
template <class Stored>
MeshCheck check_mesh(const SceneView<Stored>& scene);

} // namespace masu
