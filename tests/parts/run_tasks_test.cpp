// Tasks that are traced and written at the same time, of which one fails.
#include "tools/jobs/run_tasks.h"

#include "tests/rendering.h"
#include "tests/scene_builder.h"

#include <tbb/parallel_for.h>

namespace masu {
namespace {

// False where it doesn't come within some seconds: where there is one thread only.
bool comes(const std::atomic<bool>& event) {
  for (int i = 0; i < 2000 && !event; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  return event;
}

TEST(RunTasks, WhatIsWrittenWhileAnotherTaskFailsIsWhole) {
  const Rendering rendering(empty_scene({0, 0, 5}, {0, 0, 0}), Store::float32);
  const ResidentTracer tracer = rendering.tracer();
  int beside = 0; // repeats in which another task was being written when the first one failed
  for (int repeat = 0; repeat < 10; ++repeat) {
    constexpr int tasks = 8, rows = 2000;
    int next = 0;
    std::atomic<int> whole = 0, cut = 0;
    std::atomic<bool> second_begun = false, first_failed = false, beside_failure = false;
    const auto trace = [&](std::size_t) {
      return next < tasks ? std::make_shared<int>(next++) : std::shared_ptr<int>();
    };
    const auto write = [&](int task) {
      if (task == 0) {
        comes(second_begun);
        first_failed = true;
        throw Error(ErrorCode::output, "the first", "can't be written");
      }
      second_begun = true;
      if (comes(first_failed)) beside_failure = true;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
      std::atomic<int> written = 0;
      tbb::parallel_for(0, rows, [&](int) { ++written; });
      ++(written == rows ? whole : cut);
    };
    try {
      run_tasks(tracer, 4, trace, write);
      FAIL() << "the error is lost";
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::output);
    }
    EXPECT_EQ(cut, 0) << "beside " << whole << " that are whole";
    beside += beside_failure && whole > 0 ? 1 : 0;
  }
  if (allowed_threads() > 1) {
    EXPECT_GT(beside, 0);
  }
}

} // namespace
} // namespace masu
