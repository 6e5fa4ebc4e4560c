// Golden bytes of files as text: lines `offset: bytes` in hex without lines of zeros, then `end: size`.
#pragma once

#include "tests/temporary_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

namespace masu {

inline std::string hex_lines(std::span<const std::uint8_t> bytes) {
  constexpr std::size_t bytes_a_line = 32;
  std::string text;
  for (std::size_t at = 0; at < bytes.size(); at += bytes_a_line) {
    const auto line = bytes.subspan(at, std::min(bytes_a_line, bytes.size() - at));
    if (std::ranges::all_of(line, [](std::uint8_t byte) { return byte == 0; })) continue;
    text += fmt::format("{:x}: {:02x}\n", at, fmt::join(line, ""));
  }
  return text + fmt::format("end: {:x}\n", bytes.size());
}

inline Bytes bytes_of_hex_lines(std::string_view text) {
  Bytes bytes;
  std::istringstream lines{std::string(text)};
  for (std::string place, hex; lines >> place >> hex;) {
    if (place == "end:") {
      bytes.resize(std::stoul(hex, nullptr, 16));
      break;
    }
    bytes.resize(std::stoul(place, nullptr, 16));
    for (std::size_t i = 0; i + 1 < hex.size(); i += 2)
      bytes.push_back(static_cast<std::uint8_t>(std::stoul(hex.substr(i, 2), nullptr, 16)));
  }
  return bytes;
}

} // namespace masu
