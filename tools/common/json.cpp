#include "tools/common/json.h"

#include "tools/common/version.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <utility>

namespace masu {

std::vector<std::string> command_line() {
  std::ifstream file("/proc/self/cmdline", std::ios::binary); // each ends with a zero
  std::vector<std::string> words;
  for (std::string word; std::getline(file, word, '\0');)
    words.push_back(std::move(word));
  return words;
}

Json program_version() {
  return {{"version", version}, {"commit", commit}};
}

Json provenance() {
  Json origin = program_version();
  origin["command"] = command_line();
  return origin;
}

std::string json_text(const Json& value, int indent) {
  const std::string text = value.dump(indent, ' ', false, Json::error_handler_t::replace);
  std::string_view json = text;
  std::string result;
  while (!json.empty()) {
    const TextCharacter next = first_of(json);
    const std::size_t bytes = std::max<std::size_t>(next.bytes, 1);
    // Below 0x20 it is white space between values: in strings it is escaped already.
    if (next.bytes > 0 && next.code >= 0x20 && is_control(next.code))
      result += fmt::format("\\u{:04x}", next.code);
    else
      result += json.substr(0, bytes);
    json.remove_prefix(bytes);
  }
  return result;
}

} // namespace masu
