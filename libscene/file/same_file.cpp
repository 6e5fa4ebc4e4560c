#include "libscene/file/same_file.h"

#include "libscene/file/output_file.h"

#include <cerrno>
#include <filesystem>

namespace masu {

bool is_same_file(const std::string& a, const std::string& b) {
  struct stat a_status {
  }, b_status{};
  const bool a_exists = stat(a.c_str(), &a_status) == 0, a_is_loop = !a_exists && errno == ELOOP;
  const bool b_exists = stat(b.c_str(), &b_status) == 0, b_is_loop = !b_exists && errno == ELOOP;
  if (a_exists != b_exists || a_is_loop || b_is_loop) return false;
  if (a_exists) return S_ISREG(a_status.st_mode) && is_same_file(a_status, b_status);
  const std::filesystem::path a_target = followed(a), b_target = followed(b);
  const auto folder_of = [](const std::filesystem::path& path) {
    return path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
  };
  std::error_code missing;
  return a_target.filename() == b_target.filename() &&
         std::filesystem::equivalent(folder_of(a_target), folder_of(b_target), missing) && !missing;
}

} // namespace masu
