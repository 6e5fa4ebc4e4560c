// Text from outside (names of files, strings in them) as part of a line that a terminal shows.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <string_view>

namespace masu {

// With \xNN for each byte that is a control character (also of two bytes, U+0080 to U+009F), could turn the
// line round (U+202A to U+202E, U+2066 to U+2069), is one of Unicode's noncharacters, or isn't valid UTF-8:
// what is printed can't be taken for another line, nor move the terminal's cursor.
std::string printable(std::string_view text);

// JSON text of strings that can hold any bytes: what isn't UTF-8 becomes U+FFFD, and control characters are
// escaped, those from U+007F to U+009F too. Compiled once, for the code that prints JSON is long.
std::string json_text(const nlohmann::ordered_json& json, int indent = 2);

} // namespace masu
