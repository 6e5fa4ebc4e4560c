// The processes of a run, which share its tasks: one, or under MPI several ranks. Implemented twice, by
// ranks_none.cpp and ranks_mpi.cpp; nothing else knows MPI.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>

namespace masu {

// Functions may be called by any thread; collective ones by one thread of each rank, in the same order. Ranks
// that wait don't keep a core busy.
class Ranks {
public:
  Ranks(); // takes no memory: a main has it before it reports errors
  ~Ranks();
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;

  // Whether this process is the one to print --help and --version, which need no MPI.
  static bool prints_help();
  // When the command line is whole, before what follows. Ends the process where MPI doesn't start.
  void start();

  int rank() const { return rank_; }
  int count() const { return count_; }
  // Of the ranks on this machine.
  int local_rank() const { return local_rank_; }
  int local_count() const { return local_count_; }

  // 0, 1, 2, …: each number once, to whichever rank is the next to call.
  std::uint64_t next();
  // Adds to what all ranks have finished, and says how much that is.
  std::uint64_t add_finished(std::uint64_t amount);

  // --- Collective
  // Returns when all ranks have called. Calls idle() now and then.
  void wait_for_all(const std::function<void()>& idle = {});
  // Sums over the ranks, on each of them.
  void sum(std::span<std::uint64_t> values);
  void sum(std::span<double> values);
  // Rank 0's on all ranks.
  void broadcast(std::string& text);

  // --- The end
  // Whether this rank is the first that asks: the one to report its error. Also before start().
  bool is_first_to_fail();
  // The exit code of the main. An error of one rank ends all of them with its code.
  int ended(int code);

private:
  int rank_ = 0, count_ = 1, local_rank_ = 0, local_count_ = 1;
  struct State;
  std::unique_ptr<State> state_;
};

} // namespace masu
