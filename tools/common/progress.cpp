#include "tools/common/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>

namespace masu {
namespace {

constexpr double first_after = 1, again_after = 0.2; // seconds

std::string duration(double seconds) {
  const long s = std::lround(seconds);
  if (s < 60) return fmt::format("{} s", s);
  if (s < 3600) return fmt::format("{} min {:02} s", s / 60, s % 60);
  return fmt::format("{} h {:02} min", s / 3600, s / 60 % 60);
}

void print(const std::string& text) { // over the line before; lost where it can't be written
  static_cast<void>(std::fputs(("\r\033[K" + text).c_str(), stderr));
  static_cast<void>(std::fflush(stderr));
}

} // namespace

Progress::Progress(const char* what, bool quiet)
    : what_(what), shows_(!quiet && isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() {
  if (shown_at_ > 0) static_cast<void>(std::fputs("\r\033[K", stderr));
}

void Progress::operator()(double share) {
  if (!shows_) return;
  const std::lock_guard lock(mutex_);
  const double now = watch_.seconds();
  if (now < first_after || now - shown_at_ < again_after) return;
  shown_at_ = now;
  const std::string left =
      share > 0 ? fmt::format(", {} left", duration(now / share * (1 - share))) : std::string();
  print(fmt::format("{}: {:.0f} %{}", what_, 100 * share, left));
}

} // namespace masu
