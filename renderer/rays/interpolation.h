// Values at the corners of triangles, interpolated at hits. One definition for both backends.
#pragma once

#include "libscene/geometry/primitives.h"

namespace masu {

// Rows of `width` floats. `indices`: three per triangle, the rows of its corners; null: those of triangle i
// are 3 i to 3 i + 2, or with `per_face` all row i.
struct CornerValues {
  const float* values;
  std::uint64_t width, rows;
  const std::uint32_t* indices;
  std::uint64_t triangles;
  bool per_face;
};

// Where they are to be interpolated, and to where: `width` floats each.
struct InterpolatedHits {
  const PrimitiveIndex* primitive;
  const float (*uv)[2]; // null where that doesn't matter: per_face
  float* results;
};

// Number k of hit i's row; 0 where there is no such triangle or row.
MASU_HD inline float interpolated(const CornerValues& of, const InterpolatedHits& hits, std::uint64_t i,
                                  std::uint64_t k) {
  const std::uint64_t triangle = hits.primitive[i];
  if (triangle >= of.triangles) return 0;
  double at[3];
  for (std::uint64_t corner = 0; corner < 3; ++corner) {
    const std::uint64_t number = 3 * triangle + corner, row = of.indices != nullptr ? of.indices[number]
                                                              : of.per_face         ? triangle
                                                                                    : number;
    if (row >= of.rows) return 0;
    at[corner] = static_cast<double>(of.values[row * of.width + k]);
  }
  if (of.per_face) return static_cast<float>(at[0]);
  const auto u = static_cast<double>(hits.uv[i][0]), v = static_cast<double>(hits.uv[i][1]);
  return static_cast<float>(fma(1 - u - v, at[0], fma(u, at[1], v * at[2])));
}

} // namespace masu
