#include "libscene/mesh/import/import_ply.h"

#include "libscene/base/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace masu::import {
namespace {

constexpr std::string_view line_ends = "\r\n", blanks = " \t";

// Removes the first line from `text`, and returns its words.
std::vector<std::string_view> next_line(std::string_view& text) {
  std::string_view line = text.substr(0, text.find_first_of(line_ends));
  const std::size_t end = text.substr(line.size()).starts_with("\r\n") ? 2 : 1;
  text.remove_prefix(std::min(text.size(), line.size() + end));
  std::vector<std::string_view> words;
  for (;;) {
    line.remove_prefix(std::min(line.size(), line.find_first_not_of(blanks)));
    if (line.empty()) return words;
    words.push_back(line.substr(0, line.find_first_of(blanks)));
    line.remove_prefix(words.back().size());
  }
}

// Other lines pass: some programs write comments without saying so.
bool is_valid(const std::vector<std::string_view>& words) {
  if (words[0] == "format" || words[0] == "element") return words.size() == 3;
  return words[0] != "property" || words.size() == (words.size() > 1 && words[1] == "list" ? 5 : 3);
}

// Assimp takes the magic word in any case.
bool is_ply(std::string_view file) {
  constexpr std::string_view magic = "ply";
  return file.size() >= magic.size() &&
         std::equal(magic.begin(), magic.end(), file.begin(), [](char a, char b) { return a == (b | ' '); });
}

} // namespace

void check_ply_header(std::string_view file, const std::string& name) {
  if (!is_ply(file)) return;
  next_line(file);
  for (int line = 2; !file.empty(); ++line) {
    const std::vector<std::string_view> words = next_line(file);
    if (words.empty()) continue;
    if (words[0] == "end_header" && words.size() == 1) return;
    if (!is_valid(words))
      throw Error(ErrorCode::input, name,
                  fmt::format("line {} of its PLY header is invalid: repair it", line));
    if (words[0] == "element" && words[1] == "tristrips")
      throw Error(ErrorCode::input, name, "has triangle strips, which aren't read: convert them to faces");
  }
  throw Error(ErrorCode::input, name, "is a PLY file without end_header: complete it");
}

} // namespace masu::import
