#include "libscene/base/available_memory.h"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string_view>

namespace masu {
namespace {

constexpr double unknown = std::numeric_limits<double>::infinity();

// The number in the file, or that behind a key at the beginning of one of its lines; `otherwise` where there
// is none ("max" is no number either).
double number_in(const std::string& path, double otherwise, std::string_view key = {}) {
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string first;
    if (!key.empty() && !(words >> first && first == key)) continue;
    double number = 0;
    return words >> number ? number : otherwise;
  }
  return otherwise;
}

// The files of one version of control groups.
struct MemoryFiles {
  const char *limit, *usage, *inactive, *active;
};
constexpr MemoryFiles version1{"memory.limit_in_bytes", "memory.usage_in_bytes", "total_inactive_file",
                               "total_active_file"};
constexpr MemoryFiles version2{"memory.max", "memory.current", "inactive_file", "active_file"};

// The least that a group and those around it leave. A container may see its own group as the mount's root,
// and its path from outside: what doesn't exist doesn't limit.
double left_by_groups(const std::string& mount, std::string path, const MemoryFiles& files) {
  double left = unknown;
  for (;;) {
    const std::string group = mount + path + '/';
    const double limit = number_in(group + files.limit, unknown);
    if (limit < unknown) {
      // Usage counts the file cache, which makes way.
      const std::string statistics = group + "memory.stat";
      const double used = number_in(group + files.usage, 0) - number_in(statistics, 0, files.inactive) -
                          number_in(statistics, 0, files.active);
      left = std::min(left, std::max(0.0, limit - std::max(0.0, used)));
    }
    const auto slash = path.find_last_of('/');
    if (path.empty() || slash == std::string::npos) return left;
    path.resize(slash);
  }
}

} // namespace

double available_memory(const std::string& root) {
  double available = number_in(root + "/proc/meminfo", unknown, "MemAvailable:") * 1024;
  // Lines are hierarchy:controllers:path; version 2 has the hierarchy 0, and no list of controllers.
  std::ifstream groups(root + "/proc/self/cgroup");
  for (std::string hierarchy, controllers, path; std::getline(groups, hierarchy, ':') &&
                                                 std::getline(groups, controllers, ':') &&
                                                 std::getline(groups, path);) {
    const std::string mount = root + "/sys/fs/cgroup";
    if (hierarchy == "0" && controllers.empty())
      available = std::min(available, left_by_groups(mount, path, version2));
    else if (("," + controllers + ",").find(",memory,") != std::string::npos)
      available = std::min(available, left_by_groups(mount + "/memory", path, version1));
  }
  return available;
}

} // namespace masu
