#include "libscene/base/printable.h"

#include <fmt/format.h>

#include <algorithm>

namespace masu {

TextCharacter first_of(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char head = byte(0);
  if (head < 0x80) return {head, 1};
  const std::size_t bytes = head >= 0xf0 ? 4 : head >= 0xe0 ? 3 : 2;
  if (head < 0xc2 || head > 0xf4 || text.size() < bytes) return {};
  std::uint32_t code = head & (0x7fU >> bytes);
  for (std::size_t i = 1; i < bytes; ++i) {
    if ((byte(i) & 0xc0) != 0x80) return {};
    code = code << 6 | (byte(i) & 0x3f);
  }
  constexpr std::uint32_t least[]{0, 0, 0x80, 0x800, 0x10000};
  if (code < least[bytes] || code > 0x10ffff || (code >= 0xd800 && code < 0xe000)) return {};
  return {code, bytes};
}

bool is_control(std::uint32_t code) {
  return code < 0x20 || (code >= 0x7f && code < 0xa0) || (code >= 0x2028 && code <= 0x202e) ||
         (code >= 0x2066 && code <= 0x2069);
}

std::string printable(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const TextCharacter next = first_of(text);
    const std::size_t bytes = std::max<std::size_t>(next.bytes, 1);
    // U+FFFE, U+FFFF and their like, which XML and Cairo refuse.
    const bool is_noncharacter =
        (next.code & 0xfffe) == 0xfffe || (next.code >= 0xfdd0 && next.code < 0xfdf0);
    if (next.bytes > 0 && !is_control(next.code) && !is_noncharacter) {
      result += text.substr(0, bytes);
    } else {
      for (const char c : text.substr(0, bytes))
        result += fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
    }
    text.remove_prefix(bytes);
  }
  return result;
}

} // namespace masu
