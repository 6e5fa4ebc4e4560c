// One picture is traced at a time, for each takes the whole device, and one walk: requests wait for their
// turn in the order in which they came, and leave when nobody needs them any more.
#pragma once

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
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
    const Request own{is_gone};
    wait_for(own);
    const std::unique_ptr<Turns, void (*)(Turns*)> ended(this, [](Turns* turns) {
      const std::lock_guard lock(turns->mutex_);
      turns->queue_.pop_front();
      turns->moved_.notify_all();
    });
    return work();
  }

  // Besides the one that works.
  std::size_t waiting() const {
    const std::lock_guard lock(mutex_);
    return queue_.empty() ? 0 : queue_.size() - 1;
  }

private:
  struct Request {
    const std::function<bool()>& is_gone;
  };
  void wait_for(const Request& own) {
    std::unique_lock lock(mutex_);
    // A full queue asks those who wait at once, so that many who have hung up don't turn away one who is
    // there.
    const auto has_gone = [](const Request* request) { return request->is_gone(); };
    if (queue_.size() >= most_waiting_)
      queue_.erase(std::remove_if(queue_.begin() + 1, queue_.end(), has_gone), queue_.end());
    if (queue_.size() >= most_waiting_) throw Abandoned();
    queue_.push_back(&own);
    while (queue_.front() != &own) {
      moved_.wait_for(lock, std::chrono::milliseconds(20));
      if (std::ranges::find(queue_, &own) == queue_.end()) throw Abandoned();
      if (queue_.front() == &own || !own.is_gone()) continue;
      std::erase(queue_, &own);
      throw Abandoned();
    }
  }

  std::size_t most_waiting_;
  mutable std::mutex mutex_;
  std::condition_variable moved_;
  std::deque<const Request*> queue_; // the first one works
};

} // namespace masu
