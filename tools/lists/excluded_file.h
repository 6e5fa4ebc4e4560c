// Files of primitives that rays exclude.
#pragma once

#include "libscene/file/input_file.h"
#include "libscene/geometry/primitives.h"

#include <optional>
#include <string>
#include <vector>

namespace masu {

// An int32 for each ray of a list, -1 for none: the numbers alone, or a NumPy array of shape (N,).
class ExcludedFile {
public:
  // `rays`: of the list, where that is known. Throws Error(input) for what isn't such a file, or of another
  // number of rays.
  ExcludedFile(const std::string& path, std::optional<std::uint64_t> rays);

  // Of `count` rays from `first` on. Throws Error(input) where the file has no more. For threads at the same
  // time.
  std::vector<PrimitiveIndex> of_rays(std::uint64_t first, std::size_t count) const;

private:
  InputFile file_;
  std::uint64_t first_byte_ = 0, count_ = 0;
};

} // namespace masu
