// Text from outside (names of files, strings in them) as part of a line that a terminal shows.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace masu {

// With \xNN for each byte that is a control character (also of two bytes, U+0080 to U+009F), could turn the
// line round (U+202A to U+202E, U+2066 to U+2069), is one of Unicode's noncharacters, or isn't valid UTF-8:
// what is printed can't be taken for another line, nor move the terminal's cursor.
std::string printable(std::string_view text);

struct TextCharacter {
  std::uint32_t code = 0;
  std::size_t bytes = 0; // 0: not valid UTF-8
};
// The first character of a text that isn't empty.
TextCharacter first_of(std::string_view text);
// One that printable() replaces.
bool is_control(std::uint32_t code);

} // namespace masu
