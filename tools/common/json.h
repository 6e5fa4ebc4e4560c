// JSON that tools write: of points and boxes, with what it says of the program that wrote it, as text.
#pragma once

#include "libscene/base/printable.h"
#include "libscene/geometry/box.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace masu {

using Json = nlohmann::ordered_json;

// [x, y, z]
template <class T>
void to_json(Json& json, const Vec3<T>& v) {
  json = {v.x, v.y, v.z};
}

// {"min", "max"}
template <class T>
void to_json(Json& json, const Box<T>& box) {
  json = {{"min", box.min}, {"max", box.max}};
}

// The program's name and arguments.
std::vector<std::string> command_line();

Json program_version(); // {version, commit}
Json provenance();      // {version, commit, command}

// JSON text of strings that can hold any bytes: what isn't UTF-8 becomes U+FFFD, and control characters are
// escaped, those from U+007F to U+009F too. Compiled once, for the code that prints JSON is long.
std::string json_text(const Json& json, int indent = 2);

} // namespace masu
