// Parallel work within other parallel work.
#pragma once

#include "libscene/base/error.h"

#include <tbb/task_group.h>

namespace masu {

// Calls run(context), which gives the context to one of TBB's algorithms. Where a task of the work that this
// is part of has thrown, TBB leaves out, without a word, what hasn't begun of the rest. Then this throws,
// lest somebody goes on with what wasn't made; TBB has the first exception already, and drops this one.
template <class Run>
void run_whole(const Run& run) {
  tbb::task_group_context context;
  run(context);
  if (context.is_group_execution_cancelled()) throw Error(ErrorCode::usage, "tasks", "have been cancelled");
}

} // namespace masu
