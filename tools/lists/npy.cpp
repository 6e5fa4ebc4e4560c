#include "tools/lists/npy.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>

namespace masu {
namespace {

// What follows 'key': in the dictionary, without blanks before it.
std::optional<std::string> value_of(const std::string& dictionary, const std::string& key) {
  const std::size_t found = dictionary.find("'" + key + "'");
  if (found == std::string::npos) return {};
  const std::size_t colon = dictionary.find(':', found + key.size() + 2);
  if (colon == std::string::npos) return {};
  const std::size_t begin = dictionary.find_first_not_of(" \t", colon + 1);
  if (begin == std::string::npos) return {};
  return dictionary.substr(begin);
}

} // namespace

std::optional<NpyArray> parsed_npy_header(const std::string& dictionary) {
  const auto type = value_of(dictionary, "descr"), fortran = value_of(dictionary, "fortran_order"),
             shape = value_of(dictionary, "shape");
  if (!type || !fortran || !shape || !fortran->starts_with("False") || !type->starts_with('\'') ||
      !shape->starts_with('('))
    return {};
  NpyArray array;
  array.type = type->substr(1, type->find('\'', 1) - 1);
  for (const char* at = shape->data() + 1;;) {
    const char* const end = shape->data() + shape->size();
    at = std::find_if(at, end, [](char c) { return c != ' ' && c != ','; });
    if (at == end) return {};
    if (*at == ')') return array;
    std::uint64_t length = 0;
    const auto [after, error] = std::from_chars(at, end, length);
    if (error != std::errc()) return {};
    array.shape.push_back(length);
    at = after;
  }
}

std::optional<NpyArray> read_npy_head(const std::function<bool(void*, std::size_t)>& is_read) {
  std::array<std::uint8_t, npy_magic.size() + 4> begin{}; // with the version and a length of two bytes
  std::array<std::uint8_t, 2> more{};
  if (!is_read(begin.data(), begin.size()) || (begin[6] > 1 && !is_read(more.data(), more.size()))) return {};
  const std::size_t length =
      begin[8] | std::size_t{begin[9]} << 8 | std::size_t{more[0]} << 16 | std::size_t{more[1]} << 24;
  std::string header(std::min<std::size_t>(length, 1 << 16), ' ');
  if (length > header.size() || !is_read(header.data(), header.size())) return {};
  return parsed_npy_header(header);
}

std::string npy_header(const std::string& type, const std::string& shape) {
  constexpr std::size_t preamble = 10, alignment = 64;
  std::string dictionary =
      fmt::format("{{'descr': {}, 'fortran_order': False, 'shape': ({}), }}", type, shape);
  const std::size_t unpadded = preamble + dictionary.size() + 1;
  dictionary.append((alignment - unpadded % alignment) % alignment, ' ');
  dictionary += '\n';
  std::string header(npy_magic);
  header += '\x01';
  header += '\x00';
  header += static_cast<char>(dictionary.size() & 0xff);
  header += static_cast<char>(dictionary.size() >> 8 & 0xff);
  return header + dictionary;
}

} // namespace masu
