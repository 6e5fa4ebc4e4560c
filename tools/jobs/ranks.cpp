#include "tools/jobs/ranks.h"

#include <sched.h>
#include <unistd.h>

#include <algorithm>

namespace masu {

std::size_t cores_of(const Ranks& ranks) {
  const auto machine = static_cast<std::size_t>(std::max(1L, sysconf(_SC_NPROCESSORS_ONLN)));
  cpu_set_t allowed;
  CPU_ZERO(&allowed);
  const int count = sched_getaffinity(0, sizeof allowed, &allowed) == 0 ? CPU_COUNT(&allowed) : 0;
  const std::size_t mine = count > 0 ? static_cast<std::size_t>(count) : machine;
  return std::clamp<std::size_t>(machine / static_cast<std::size_t>(ranks.local_count()), 1, mine);
}

} // namespace masu
