// Where the vertices of a scene's triangles are.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace masu {

// Positions in the world, in host memory or a GPU's, of the vertices of a scene's triangles.
struct Vertices {
  const float* floats = nullptr; // three per vertex; or
  const double* doubles = nullptr;
  std::size_t count = 0;
  std::span<const std::uint32_t> indices{}; // three per triangle, below `count`; empty: one after the other
};

} // namespace masu
