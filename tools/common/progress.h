// How far a tool is, and how long it will take: one line on standard error.
#pragma once

#include "libscene/base/stopwatch.h"
#include "tools/common/print.h"

#include <unistd.h>

#include <cmath>
#include <functional>
#include <mutex>

namespace masu {

// Shows shares of work done, where standard error is a terminal and work takes over a second; the line is
// removed in the end. Any thread may report; libraries do by std::ref() of it, which it must outlive.
class Progress {
public:
  // what: "rendering"
  explicit Progress(const char* what, bool quiet = false)
      : what_(what), shows_(!quiet && isatty(STDERR_FILENO) != 0) {}
  ~Progress() {
    if (shown_at_ > 0) static_cast<void>(std::fputs("\r\033[K", stderr));
  }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  // `share` of the work is done: 0 to 1.
  void operator()(double share) {
    if (!shows_) return;
    const std::lock_guard lock(mutex_);
    const double now = watch_.seconds();
    if (now < first_after || now - shown_at_ < again_after) return;
    shown_at_ = now;
    print_note("\r\033[K{}: {:.0f} %{}", what_, 100 * share,
               share > 0 ? fmt::format(", {} left", duration(now / share * (1 - share))) : "");
  }

private:
  static constexpr double first_after = 1, again_after = 0.2; // seconds

  static std::string duration(double seconds) {
    const long s = std::lround(seconds);
    if (s < 60) return fmt::format("{} s", s);
    if (s < 3600) return fmt::format("{} min {:02} s", s / 60, s % 60);
    return fmt::format("{} h {:02} min", s / 3600, s / 60 % 60);
  }

  const char* what_;
  bool shows_;
  Stopwatch watch_;
  std::mutex mutex_;
  double shown_at_ = 0; // seconds; 0: no line is shown
};

} // namespace masu
