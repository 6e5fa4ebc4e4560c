// How far a tool is, and how long it will take: one line on standard error.
#pragma once

#include "libscene/base/stopwatch.h"

#include <functional>
#include <mutex>

namespace masu {

// Shows shares of work done, where standard error is a terminal and work takes over a second; the line is
// removed in the end. Any thread may report.
class Progress {
public:
  // what: "rendering"
  explicit Progress(const char* what, bool quiet = false);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  // `share` of the work is done: 0 to 1.
  void operator()(double share);

  // For libraries, which know a plain function. The progress must outlive it.
  std::function<void(double)> callback() {
    return [this](double share) { (*this)(share); };
  }

private:
  const char* what_;
  bool shows_;
  Stopwatch watch_;
  std::mutex mutex_;
  double shown_at_ = 0; // seconds; 0: no line is shown
};

} // namespace masu
