// One picture is traced at a time, for each takes the whole device: requests wait for their turn in the order
// in which they came, and leave when nobody needs them any more.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <mutex>

namespace masu {

// The client has hung up, or asked for something newer.
struct Abandoned {};

class Turns {
public:
  explicit Turns(std::size_t most_waiting) : most_waiting_(most_waiting) {}

  // Runs work() when it is its turn, and returns its result. Throws Abandoned when is_gone() while it waits,
  // or where too many wait already.
  template <class Work>
  auto run(const std::function<bool()>& is_gone, const Work& work) {
    const Turn turn(*this, is_gone);
    return work();
  }

private:
  class Turn {
  public:
    Turn(Turns& turns, const std::function<bool()>& is_gone) : turns_(turns) {
      std::unique_lock lock(turns.mutex_);
      if (turns.queue_.size() >= turns.most_waiting_) throw Abandoned();
      const std::uint64_t number = turns.next_++;
      turns.queue_.push_back(number);
      while (turns.queue_.front() != number) {
        turns.moved_.wait_for(lock, std::chrono::milliseconds(20));
        if (turns.queue_.front() == number || !is_gone()) continue;
        std::erase(turns.queue_, number);
        throw Abandoned();
      }
    }
    ~Turn() {
      const std::lock_guard lock(turns_.mutex_);
      turns_.queue_.pop_front();
      turns_.moved_.notify_all();
    }
    Turn(const Turn&) = delete;
    Turn(Turn&&) = delete;
    Turn& operator=(const Turn&) = delete;
    Turn& operator=(Turn&&) = delete;

  private:
    Turns& turns_;
  };

  std::size_t most_waiting_;
  std::mutex mutex_;
  std::condition_variable moved_;
  std::deque<std::uint64_t> queue_; // the first one works
  std::uint64_t next_ = 0;
};

} // namespace masu
