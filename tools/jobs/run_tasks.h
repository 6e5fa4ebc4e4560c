// Tasks on a tracer's devices: some are traced while others are written.
#pragma once

#include "libscene/base/on_threads.h"
#include "renderer/tracer.h"

#include <tbb/global_control.h>
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <optional>
#include <semaphore>
#include <vector>

namespace masu {

inline std::size_t allowed_threads() {
  return tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
}

// How many tasks are under way at most, of so many bytes each: enough for devices and encoding threads, as
// far as memory allows.
inline std::size_t tasks_under_way(const Tracer& tracer, std::size_t bytes_a_task) {
  constexpr std::size_t all_bytes = std::size_t{4} << 30;
  const std::size_t devices = tracer.device() == Device::cuda ? queries_per_gpu * tracer.device_count() : 1;
  return std::clamp<std::size_t>(all_bytes / std::max<std::size_t>(bytes_a_task, 1), 2,
                                 allowed_threads() + devices);
}

// Devices that are free for a query: a GPU for several at a time.
class FreeDevices {
public:
  explicit FreeDevices(std::size_t devices) {
    for (int query = 0; query < queries_per_gpu; ++query)
      for (std::size_t device = 0; device < devices; ++device)
        free_.push_back(device);
    count_.release(static_cast<std::ptrdiff_t>(free_.size()));
  }

  // act(device's index), when one is free.
  template <class Act>
  auto with(const Act& act) {
    const Taken taken(*this);
    return act(taken.device);
  }

private:
  class Taken {
  public:
    explicit Taken(FreeDevices& devices) : device(devices.take()), devices_(devices) {}
    ~Taken() { devices_.give_back(device); }
    Taken(const Taken&) = delete;
    Taken(Taken&&) = delete;
    Taken& operator=(const Taken&) = delete;
    Taken& operator=(Taken&&) = delete;
    const std::size_t device;

  private:
    FreeDevices& devices_;
  };
  std::size_t take() {
    count_.acquire();
    const std::lock_guard lock(mutex_);
    const std::size_t device = free_.back();
    free_.pop_back();
    return device;
  }
  void give_back(std::size_t device) {
    const std::lock_guard lock(mutex_);
    free_.insert(free_.begin(), device);
    count_.release();
  }

  std::counting_semaphore<> count_{0};
  std::mutex mutex_;
  std::vector<std::size_t> free_;
};

// Calls trace(device's index) again and again, which takes the next task and returns what it traced, or
// nothing after the last task; and write(what it traced) meanwhile, in any order. At most `under_way` at the
// same time. The CPU's threads share each task, and trace() is called by one at a time; GPUs have several
// tasks each. When either throws, what is under way ends, and no more is begun.
template <class Trace, class Write>
void run_tasks(const Tracer& tracer, std::size_t under_way, const Trace& trace, const Write& write) {
  using Traced = decltype(trace(std::size_t{0}));
  if (tracer.device() == Device::cpu) {
    // TBB mustn't see what is thrown: it would end every loop under way within the pipeline early, and a
    // picture that another thread is writing meanwhile would be cut short.
    std::exception_ptr error;
    std::mutex mutex;
    std::atomic<bool> ended = false;
    const auto kept = [&](const auto& act) {
      try {
        act();
      } catch (...) {
        const std::lock_guard lock(mutex);
        if (!error) error = std::current_exception();
        ended = true;
      }
    };
    const auto traced = [&](tbb::flow_control& control) {
      Traced result{};
      // A thread that waits for the task's last rays doesn't begin another task meanwhile.
      if (!ended) kept([&] { tbb::this_task_arena::isolate([&] { result = trace(std::size_t{0}); }); });
      if (!result) control.stop();
      return result;
    };
    const auto written = [&](const Traced& result) {
      if (!ended) kept([&] { write(*result); });
    };
    tbb::parallel_pipeline(under_way,
                           tbb::make_filter<void, Traced>(tbb::filter_mode::serial_in_order, traced) &
                               tbb::make_filter<Traced, void>(tbb::filter_mode::parallel, written));
    if (error) std::rethrow_exception(error);
    return;
  }
  FreeDevices devices(tracer.device_count());
  std::atomic<bool> ended = false;
  on_threads(under_way, [&](std::size_t) {
    try {
      while (!ended) {
        const Traced result = devices.with(trace);
        if (!result) break;
        write(*result);
      }
    } catch (...) {
      ended = true;
      throw;
    }
  });
}

} // namespace masu
