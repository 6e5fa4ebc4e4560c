// Tasks on a tracer's devices: some are traced while others are written.
#pragma once

#include "libscene/base/on_threads.h"
#include "renderer/tracer/tracer.h"
#include "tools/common/cli.h"

#include <tbb/concurrent_queue.h>
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>

namespace masu {

// How many tasks are under way at most, of so many bytes each: enough for devices and encoding threads, as
// far as memory allows.
inline std::size_t tasks_under_way(const ResidentTracer& tracer, std::size_t bytes_per_task) {
  constexpr std::size_t all_bytes = std::size_t{4} << 30;
  const std::size_t devices = tracer.device() == Device::cuda ? queries_per_gpu * tracer.device_count() : 1;
  return std::clamp<std::size_t>(all_bytes / std::max<std::size_t>(bytes_per_task, 1), 2,
                                 allowed_threads() + devices);
}

// Calls trace(device's index) again and again, which takes the next task and returns what it traced, or
// nothing after the last task; and write(what it traced) meanwhile, in any order. At most `under_way` at the
// same time. The CPU's threads share each task, and trace() is called by one at a time; GPUs have several
// tasks each. When either throws, what is under way ends, and no more is begun.
template <class Trace, class Write>
void run_tasks(const ResidentTracer& tracer, std::size_t under_way, const Trace& trace, const Write& write) {
  using Traced = decltype(trace(std::size_t{0}));
  // The first error. TBB mustn't see what is thrown: it would end every loop under way within the pipeline
  // early, and a picture that another thread is writing meanwhile would be cut short.
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
  if (tracer.device() == Device::cpu) {
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
  } else {
    tbb::concurrent_bounded_queue<std::size_t> free_devices; // a GPU for several queries at a time
    for (int query = 0; query < queries_per_gpu; ++query)
      for (std::size_t device = 0; device < tracer.device_count(); ++device)
        free_devices.push(device);
    on_threads(under_way, [&](std::size_t) {
      while (!ended) {
        Traced result{};
        std::size_t device = 0;
        free_devices.pop(device);
        kept([&] { result = trace(device); });
        free_devices.push(device); // other threads wait for it
        if (!result) break;
        kept([&] { write(*result); });
      }
    });
  }
  if (error) std::rethrow_exception(error);
}

} // namespace masu
