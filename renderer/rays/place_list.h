// Lists of places: RayList with 3 numbers each. One definition for both backends.
#pragma once

#include "renderer/rays/ray_query.h"

namespace masu {

// Place i, relative to the scene's origin.
MASU_HD inline Vec3d place_at(const void* places, const RayFormat& format, std::size_t i) {
  const auto place = [i](const auto* numbers) {
    return Vec3d{static_cast<double>(numbers[3 * i]), static_cast<double>(numbers[3 * i + 1]),
                 static_cast<double>(numbers[3 * i + 2])};
  };
  return (format.is_float64 ? place(static_cast<const double*>(places))
                            : place(static_cast<const float*>(places))) -
         format.origin;
}

} // namespace masu
