// Points and boxes as JSON: values of an nlohmann::ordered_json.
#pragma once

#include "libscene/geometry/vector.h"

#include <nlohmann/json.hpp>

namespace masu {

// [x, y, z]
template <class T>
void to_json(nlohmann::ordered_json& json, const Vec3<T>& v) {
  json = {v.x, v.y, v.z};
}

// {"min", "max"}
template <class T>
void to_json(nlohmann::ordered_json& json, const Box<T>& box) {
  json = {{"min", box.min}, {"max", box.max}};
}

} // namespace masu
