#include "tools/lists/excluded_file.h"

#include "libscene/base/error.h"
#include "tools/lists/npy.h"

#include <fmt/format.h>

namespace masu {

ExcludedFile::ExcludedFile(const std::string& path, std::optional<std::uint64_t> rays) : file_(path) {
  const auto fail = [&](const std::string& what) { throw Error(ErrorCode::input, path, what); };
  std::uint64_t bytes = file_.size();
  const auto is_read = [&](void* to, std::size_t count) {
    if (count > file_.size() - first_byte_) return false;
    file_.read(first_byte_, {static_cast<std::uint8_t*>(to), count});
    first_byte_ += count;
    return true;
  };
  std::string start(npy_magic.size(), ' ');
  const bool is_npy = is_read(start.data(), start.size()) && start == npy_magic;
  first_byte_ = 0;
  if (is_npy) {
    const std::optional<NpyArray> array = read_npy_head(is_read);
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
