// Points as JSON.
#pragma once

#include "libscene/geometry/vector.h"

#include <nlohmann/json.hpp>

namespace masu {

// [x, y, z]
inline nlohmann::ordered_json vector_json(const Vec3d& v) {
  return {v.x, v.y, v.z};
}

} // namespace masu
