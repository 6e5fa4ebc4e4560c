#include "tools/lists/excluded_file.h"

#include "libscene/base/error.h"
#include "tools/lists/npy.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace masu {

ExcludedFile::ExcludedFile(const std::string& path, std::optional<std::uint64_t> rays) : file_(path) {
  const auto fail = [&](const std::string& what) { throw Error(ErrorCode::input, path, what); };
  constexpr std::size_t preamble = 10;
  std::array<std::uint8_t, preamble> start{};
  if (file_.size() >= preamble) file_.read(0, start);
  std::uint64_t bytes = file_.size();
  if (std::equal(npy_magic.begin(), npy_magic.end(), start.begin(),
                 [](char a, std::uint8_t b) { return static_cast<std::uint8_t>(a) == b; })) {
    std::string header(start[8] | static_cast<std::size_t>(start[9]) << 8, ' ');
    first_byte_ = preamble + header.size();
    if (start[6] != 1 || first_byte_ > bytes) fail("isn't a NumPy array of version 1.0");
    file_.read(preamble, {reinterpret_cast<std::uint8_t*>(header.data()), header.size()});
    const std::optional<NpyArray> array = parsed_npy_header(header);
    if (!array || (array->type != "<i4" && array->type != "<u4") || array->shape.size() != 1)
      fail("isn't a NumPy array of int32 of shape (N,)");
    bytes -= first_byte_;
    if (array->shape[0] != bytes / sizeof(PrimitiveIndex)) fail("isn't as long as its header says");
  } else if (path.ends_with(".npy")) {
    fail("isn't a NumPy array");
  }
  if (bytes % sizeof(PrimitiveIndex) != 0) fail("isn't a whole number of int32 numbers");
  count_ = bytes / sizeof(PrimitiveIndex);
  if (rays && *rays != count_) fail(fmt::format("holds {} primitives for {} rays", count_, *rays));
}

std::vector<PrimitiveIndex> ExcludedFile::of_rays(std::uint64_t first, std::size_t count) const {
  if (first > count_ || count > count_ - first)
    throw Error(ErrorCode::input, file_.path(), fmt::format("holds {} primitives, fewer than rays", count_));
  std::vector<PrimitiveIndex> excluded(count);
  file_.read(first_byte_ + first * sizeof(PrimitiveIndex),
             {reinterpret_cast<std::uint8_t*>(excluded.data()), count * sizeof(PrimitiveIndex)});
  return excluded;
}

} // namespace masu
