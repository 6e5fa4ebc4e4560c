// A program's go_on() (masu.h), as the progress that libraries report to.
#pragma once

#include "masu.h"

#include <tbb/task_arena.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <thread>

namespace masu {

// Thrown where go_on() has returned 0.
struct Interrupted {};

// Of a call, in whose thread it is made: only there go_on() is called. Where libraries report from other
// threads, they learn whether it has returned 0.
class GoOn {
public:
  GoOn(masu_go_on go_on, void* user) : go_on_(go_on), user_(user) {}
  GoOn(const GoOn&) = delete;
  GoOn& operator=(const GoOn&) = delete;
  ~GoOn() = default;

  // Empty where there is no go_on(). It refers to this.
  std::function<void(double)> progress() {
    if (go_on_ == nullptr) return {};
    return [this](double done) { report(done); };
  }

private:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::milliseconds apart{100};

  void report(double done) {
    if (has_ended_) throw Interrupted();
    if (std::this_thread::get_id() != caller_) return;
    if (const Clock::time_point now = Clock::now(); now < next_) return;
    // Isolated, or what go_on() calls might wait by taking tasks of this call, which would get here again.
    has_ended_ = tbb::this_task_arena::isolate([&] { return go_on_(user_, done) == 0; });
    if (has_ended_) throw Interrupted();
    next_ = Clock::now() + apart;
  }

  masu_go_on go_on_;
  void* user_;
  std::thread::id caller_ = std::this_thread::get_id();
  std::atomic<bool> has_ended_ = false;
  Clock::time_point next_ = Clock::now() + apart; // the caller's thread alone looks at it
};

} // namespace masu
