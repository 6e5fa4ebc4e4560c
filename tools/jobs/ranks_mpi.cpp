// The ranks of an MPI run. Counters are words of rank 0's memory. Ranks of one machine share it. Where there
// are several machines, a thread of rank 0 counts for the others, which send it messages: one-sided
// communication would do so without that thread, but not on every network.
//
// One thread at a time calls MPI, and no call waits for another rank.
#include "tools/jobs/ranks.h"

#include "libscene/base/error.h"

#include <mpi.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <optional>
#include <thread>

namespace masu {
namespace {

enum Word : std::size_t { next_task, finished_tasks, failures, words };
using Memory = std::array<std::uint64_t, words>;

// A request to rank 0; it replies with the word as it was.
struct Addition {
  std::uint64_t word = 0, amount = 0;
};
enum Tag : int { addition_tag = 1, reply_tag = 2 };

// Between two looks at what others do; longer and longer for who waits.
constexpr auto pause = std::chrono::microseconds(200), longest_pause = std::chrono::microseconds(5000);
constexpr auto between_idle_calls = std::chrono::milliseconds(200);
constexpr auto patience = std::chrono::seconds(20);         // for the rank that reports an error to end all
constexpr auto forwarding = std::chrono::milliseconds(100); // its line, before mpirun's own about the end

// The rank that this process was launched as; nothing where it was started by itself.
std::optional<int> launched_as() {
  for (const char* const name : {"PMIX_RANK", "PMI_RANK", "OMPI_COMM_WORLD_RANK", "SLURM_PROCID"}) {
    if (const char* const rank = std::getenv(name)) return std::atoi(rank);
  }
  return {};
}

} // namespace

struct Ranks::State {
  std::mutex mpi;
  bool is_first = false;         // rank 0
  MPI_Win window = MPI_WIN_NULL; // where all ranks are on one machine: memory that they share
  Memory own{};                  // else rank 0's
  Memory* memory = &own;
  std::atomic<bool> ended = false, reports = false; // reports: this rank was the first to fail
  std::thread helper;

  bool has_memory() const { return window != MPI_WIN_NULL || is_first; }

  std::uint64_t add(std::uint64_t word, std::uint64_t amount) {
    return std::atomic_ref((*memory)[word]).fetch_add(amount);
  }

  // NOLINTBEGIN(clang-analyzer-optin.mpi.MPI-Checker): it doesn't see that complete() waits for all requests.
  std::uint64_t fetch_and_add(Word word, std::uint64_t amount) {
    if (has_memory()) return add(word, amount);
    const Addition addition{word, amount};
    std::uint64_t before = 0;
    MPI_Request sent = MPI_REQUEST_NULL;
    complete([&](MPI_Request* reply) { // together: replies come in the order of what was sent
      MPI_Irecv(&before, 1, MPI_UINT64_T, 0, reply_tag, MPI_COMM_WORLD, reply);
      MPI_Isend(&addition, sizeof addition, MPI_BYTE, 0, addition_tag, MPI_COMM_WORLD, &sent);
    });
    complete([&](MPI_Request* request) { *request = sent; });
    return before;
  }

  // Waits for a request that start(request) makes.
  template <class Start>
  void complete(const Start& start, const std::function<void()>& idle = {}) {
    MPI_Request request = MPI_REQUEST_NULL;
    {
      const std::lock_guard lock(mpi);
      start(&request);
    }
    auto length = pause;
    for (auto last_idle = std::chrono::steady_clock::now();;) {
      int done = 0;
      {
        const std::lock_guard lock(mpi);
        MPI_Test(&request, &done, MPI_STATUS_IGNORE);
      }
      if (done != 0) return;
      if (const auto now = std::chrono::steady_clock::now(); idle && now - last_idle > between_idle_calls) {
        idle();
        last_idle = now;
      }
      std::this_thread::sleep_for(length);
      length = std::min(2 * length, longest_pause);
    }
  }

  template <class Number>
  void sum(std::span<Number> values, MPI_Datatype type) {
    complete([&](MPI_Request* request) {
      MPI_Iallreduce(MPI_IN_PLACE, values.data(), static_cast<int>(values.size()), type, MPI_SUM,
                     MPI_COMM_WORLD, request);
    });
  }
  // NOLINTEND(clang-analyzer-optin.mpi.MPI-Checker)

  void share_memory() {
    const MPI_Aint bytes = is_first ? sizeof *memory : 0;
    MPI_Win_allocate_shared(bytes, 1, MPI_INFO_NULL, MPI_COMM_WORLD, &memory, &window);
    MPI_Aint size = 0;
    int unit = 0;
    MPI_Win_shared_query(window, 0, &size, &unit, &memory);
    MPI_Win_lock_all(MPI_MODE_NOCHECK, window);
    if (is_first) memory->fill(0);
    MPI_Win_sync(window);
  }

  // Replies to one rank, if there is a request. Small messages don't wait for who receives them.
  bool reply() {
    const std::lock_guard lock(mpi);
    int found = 0;
    MPI_Status asked;
    MPI_Iprobe(MPI_ANY_SOURCE, addition_tag, MPI_COMM_WORLD, &found, &asked);
    if (found == 0) return false;
    Addition addition;
    MPI_Recv(&addition, sizeof addition, MPI_BYTE, asked.MPI_SOURCE, addition_tag, MPI_COMM_WORLD,
             MPI_STATUS_IGNORE);
    const std::uint64_t before = add(addition.word, addition.amount);
    MPI_Send(&before, 1, MPI_UINT64_T, asked.MPI_SOURCE, reply_tag, MPI_COMM_WORLD);
    return true;
  }
  void reply_until_ended() {
    while (!ended) {
      if (!reply()) std::this_thread::sleep_for(pause);
    }
  }
};

Ranks::Ranks() = default;

bool Ranks::prints_help() {
  return launched_as().value_or(0) == 0;
}

void Ranks::start() {
  state_ = std::make_unique<State>();
  State& state = *state_;
  int provided = 0;
  if (MPI_Init_thread(nullptr, nullptr, MPI_THREAD_SERIALIZED, &provided) != MPI_SUCCESS ||
      provided < MPI_THREAD_SERIALIZED) {
    static_cast<void>(
        std::fprintf(stderr, "%s: MPI: has no threads (MPI_THREAD_SERIALIZED): take another build of it\n",
                     program_invocation_short_name));
    MPI_Abort(MPI_COMM_WORLD, static_cast<int>(ErrorCode::device));
  }
  MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &count_);
  state.is_first = rank_ == 0;
  MPI_Comm local = MPI_COMM_NULL;
  MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, rank_, MPI_INFO_NULL, &local);
  MPI_Comm_rank(local, &local_rank_);
  MPI_Comm_size(local, &local_count_);
  MPI_Comm_free(&local);
  if (local_count_ == count_) {
    state.share_memory();
    wait_for_all(); // the counters are zero
    MPI_Win_sync(state.window);
  } else if (state.is_first) {
    state.helper = std::thread([&state] { state.reply_until_ended(); });
  }
}

Ranks::~Ranks() {
  if (!state_) return;
  wait_for_all();
  state_->ended = true;
  if (state_->helper.joinable()) state_->helper.join();
  if (state_->window != MPI_WIN_NULL) {
    MPI_Win_unlock_all(state_->window);
    MPI_Win_free(&state_->window);
  }
  MPI_Finalize();
}

std::uint64_t Ranks::next() {
  return state_->fetch_and_add(next_task, 1);
}
std::uint64_t Ranks::add_finished(std::uint64_t amount) {
  return state_->fetch_and_add(finished_tasks, amount) + amount;
}

void Ranks::wait_for_all(const std::function<void()>& idle) {
  state_->complete([](MPI_Request* request) { MPI_Ibarrier(MPI_COMM_WORLD, request); }, idle);
}

void Ranks::sum(std::span<std::uint64_t> values) {
  state_->sum(values, MPI_UINT64_T);
}
void Ranks::sum(std::span<double> values) {
  state_->sum(values, MPI_DOUBLE);
}

void Ranks::broadcast(std::string& text) {
  std::uint64_t size = text.size();
  state_->complete(
      [&](MPI_Request* request) { MPI_Ibcast(&size, 1, MPI_UINT64_T, 0, MPI_COMM_WORLD, request); });
  text.resize(size);
  state_->complete([&](MPI_Request* request) {
    MPI_Ibcast(text.data(), static_cast<int>(size), MPI_CHAR, 0, MPI_COMM_WORLD, request);
  });
}

bool Ranks::is_first_to_fail() {
  if (!state_ && !launched_as()) return true;
  if (!state_) start();
  state_->reports = state_->fetch_and_add(failures, 1) == 0;
  return state_->reports;
}

int Ranks::ended(int code) {
  if (code == 0 || count_ == 1) return code;
  // The first one to fail ends all, when mpirun has had time to forward its line. The others let it.
  std::this_thread::sleep_for(state_->reports ? forwarding : patience);
  MPI_Abort(MPI_COMM_WORLD, code);
  return code;
}

} // namespace masu
