// How far work is that may take long, and whether it is to end.
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <utility>

namespace masu {

// Any thread may report, by the share of the work that is done, or by check() where no more is known than
// before: every some milliseconds, for what the function throws ends the work. It changes no result.
class ProgressMonitor {
public:
  // `report` gets the share of all work that is done, from 0 to 1; it may be empty.
  explicit ProgressMonitor(std::function<void(double)> report = {}) : report_(std::move(report)) {}

  // What comes next is part `part` of so many, each as long. Not while threads report.
  void begin_part(std::size_t part, std::size_t parts) {
    first_ = static_cast<double>(part) / static_cast<double>(parts);
    share_ = 1 / static_cast<double>(parts);
    operator()(0);
  }
  // A share of the part is done.
  void operator()(double done) {
    done_.store(first_ + done * share_, std::memory_order_relaxed);
    check();
  }
  void check() const {
    if (report_) report_(done_.load(std::memory_order_relaxed));
  }

private:
  std::function<void(double)> report_;
  double first_ = 0, share_ = 1; // of the part
  std::atomic<double> done_ = 0;
};

// Of work that may have none.
inline void check_progress(const ProgressMonitor* progress) {
  if (progress != nullptr) progress->check();
}

} // namespace masu
