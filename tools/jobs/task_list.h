// The tasks of a run: which there are, which were finished by an interrupted run, and who takes the next one.
#pragma once

#include "renderer/counts.h"
#include "tools/jobs/partial_file.h"
#include "tools/jobs/ranks.h"

#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace masu {

// What was traced, as it is summed up in the end.
struct TaskTotals {
  std::uint64_t rays = 0;
  std::uint64_t invalid = 0; // of a list
  Counts counts;
};

// Calls act(a's number, b's) for each of them.
template <class A, class B, class Act>
void for_each_total(A& a, B& b, const Act& act) {
  act(a.rays, b.rays);
  act(a.invalid, b.invalid);
  for_each_count(a.counts, b.counts, act);
}

inline TaskTotals& operator+=(TaskTotals& a, const TaskTotals& b) {
  for_each_total(a, b, [](std::uint64_t& sum, std::uint64_t total) { sum += total; });
  return a;
}

// How a run is shared and resumed. ranks outlives all that have this.
struct Sharing {
  Ranks& ranks;
  bool resume = false;

  // Files are made in parts beside them (partial_file.h), by several processes or by several runs.
  bool in_parts() const { return resume || ranks.count() > 1; }
};

// What a run's bytes depend on, and its tasks.
struct TaskListOf {
  std::string description; // of inputs and options
  std::string output;      // a file that is written: the journal's name is made of it
  std::uint64_t count = 0; // tasks
  // What a task writes: ranges, without bytes and hash yet. Those with an offset are in partial files.
  std::function<std::vector<FileRange>(std::uint64_t task)> writes{};
};

// OUTPUT.journal.RANK
std::string journal_name(const std::string& output, int rank);
// The files beside outputs while several processes or runs make them; the first output that has a name names
// the journals. Throws Error(usage) for an output that can't have any.
std::vector<std::string> files_beside(const std::vector<std::string>& outputs, const Sharing& sharing);

// For threads at the same time, but for what is collective (tools/jobs/ranks.h). To be resumed, each rank
// keeps a journal: a line of JSON for the run's hash and its partial files, and one for each finished task,
// with its own hash and that of each range of a file that the task wrote. A task whose line or ranges don't
// have their hash any more, or aren't what it writes, is done again.
//
// Other files are neither replaced nor removed: a journal is known by its first line, and a partial file by a
// journal that names it. So rank 0 keeps a journal of that line alone where a run has partial files and isn't
// to be resumed.
class TaskList {
public:
  // Collective. Throws Error(output): also where another file has the name of a journal or a partial file.
  TaskList(const Sharing& sharing, const TaskListOf& tasks);
  ~TaskList();
  TaskList(const TaskList&) = delete;
  TaskList& operator=(const TaskList&) = delete;

  // The next task that isn't done; nothing after the last.
  std::optional<std::uint64_t> next();
  // The ranges' bytes are in their files. Returns the share of all tasks that is done, by all ranks. Throws
  // Error(output).
  double finish(std::uint64_t task, const std::vector<FileRange>& written, const TaskTotals& totals);
  // The share of all tasks that is done.
  double share();
  // Those that this rank finished; rank 0's have those of interrupted runs.
  const TaskTotals& totals() const { return totals_; }
  // When all files are there. By rank 0.
  void remove_journals() const;

  bool keeps_journal() const { return journal_ >= 0; }

private:
  void take_over(const TaskListOf& tasks);
  std::string taken_over(const TaskListOf& tasks, std::string lines);

  const Sharing sharing_;
  std::uint64_t count_, left_ = 0;   // left_: tasks that were not done at the beginning
  std::vector<std::uint64_t> to_do_; // their numbers
  std::string output_, run_;         // run_: its hash, in hexadecimal
  int journal_ = -1;                 // file descriptor
  std::mutex mutex_;                 // of what follows
  TaskTotals totals_;
};

} // namespace masu
