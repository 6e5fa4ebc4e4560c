#include "tools/jobs/kept_file.h"

#include "libscene/base/error.h"
#include "libscene/file/input_file.h"

#include <algorithm>

namespace masu {

bool is_kept(const std::string& path, const KnownBy& known_by) {
  constexpr std::uint64_t before = 4096; // of a JPEG's comment: its tables
  try {
    const InputFile file(path);
    if (known_by.bytes && file.size() != *known_by.bytes) return false;
    std::string begin(std::min(file.size(), known_by.text.size() + before), ' ');
    file.read(0, {reinterpret_cast<std::uint8_t*>(begin.data()), begin.size()});
    return begin.find(known_by.text) != std::string::npos;
  } catch (const Error&) { // none, a folder, a pipe
    return false;
  }
}

} // namespace masu
