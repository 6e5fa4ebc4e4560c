// Text from outside (names of files, strings in them) as part of a line that a terminal shows.
#pragma once

#include <nlohmann/json.hpp>

#include <string>
#include <string_view>

namespace masu {

// With \xNN for each byte that is a control character (also of two bytes, U+0080 to U+009F), could turn the
// line round (U+202A to U+202E, U+2066 to U+2069), is one of Unicode's noncharacters, or isn't valid UTF-8:
// what is printed can't be taken for another line, nor move the terminal's cursor.
std::string printable(std::string_view text);

// JSON text of strings that can hold any bytes: what isn't UTF-8 becomes U+FFFD, and control characters are
// escaped, those from U+007F to U+009F too.
std::string escaped_controls(std::string_view json);
template <class Json>
std::string json_text(const Json& json, int indent = 2) {
  return escaped_controls(json.dump(indent, ' ', false, Json::error_handler_t::replace));
}

} // namespace masu
