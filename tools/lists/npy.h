// Headers of NumPy's .npy files, after NEP 1 (numpy.lib.format): what rays and hits need of them.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace masu {

inline constexpr std::string_view npy_magic = "\x93NUMPY";

struct NpyArray {
  std::string type; // of the elements, such as <f4
  std::vector<std::uint64_t> shape;
};

// What a header's dictionary says of an array of plain numbers in C order; nothing for what isn't one.
std::optional<NpyArray> parsed_npy_header(const std::string& dictionary);

// The same of what a file begins with: is_read(to, bytes) reads its next bytes, if there are so many. Nothing
// also where the file ends before, and for a header of more than 64 KiB.
std::optional<NpyArray> read_npy_head(const std::function<bool(void*, std::size_t)>& is_read);

// Magic, version 1.0 and the header of an array in C order. As NumPy has them: the type of its elements, such
// as '<f4' (with quotes) or [('t', '<f4')], and what stands in the parentheses of its shape, such as 3, 4,
std::string npy_header(const std::string& type, const std::string& shape);

} // namespace masu
