// One picture is traced at a time, for each takes the whole device, and one walk: requests wait for their
// turn in the order in which they came, and leave when nobody needs them any more.
#pragma once

#include <algorithm>
#include <chrono>
#include <condition_variable>
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

  // Besides the one that works.
  std::size_t waiting() const {
    const std::lock_guard lock(mutex_);
    return queue_.empty() ? 0 : queue_.size() - 1;
  }

private:
  class Turn {
  public:
    Turn(Turns& turns, const std::function<bool()>& is_gone) : turns_(turns), is_gone_(is_gone) {
      std::unique_lock lock(turns.mutex_);
      std::deque<const Turn*>& queue = turns.queue_;
      // A full queue asks those who wait at once, so that many who have hung up don't turn away one who is
      // there.
      const auto has_gone = [](const Turn* turn) { return turn->is_gone_(); };
      if (queue.size() >= turns.most_waiting_)
        queue.erase(std::remove_if(queue.begin() + 1, queue.end(), has_gone), queue.end());
      if (queue.size() >= turns.most_waiting_) throw Abandoned();
      queue.push_back(this);
      while (queue.front() != this) {
        turns.moved_.wait_for(lock, std::chrono::milliseconds(20));
        if (std::find(queue.begin(), queue.end(), this) == queue.end()) throw Abandoned();
        if (queue.front() == this || !is_gone()) continue;
        std::erase(queue, this);
        throw Abandoned();
      }
    }
    ~Turn() {
      const std::lock_guard lock(turns_.mutex_);
      turns_.queue_.pop_front();
      turns_.moved_.notify_all();
    }
    Turn(const Turn&) = delete;
    Turn& operator=(const Turn&) = delete;

  private:
    Turns& turns_;
    const std::function<bool()>& is_gone_;
  };

  std::size_t most_waiting_;
  mutable std::mutex mutex_;
  std::condition_variable moved_;
  std::deque<const Turn*> queue_; // the first one works
};

} // namespace masu
