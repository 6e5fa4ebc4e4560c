// Puts what comes in any order back in order.
#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <utility>

namespace masu {

// Values have positions, such as indices or offsets in a file, which follow each other from `first` on
// without gaps. For threads at the same time.
template <class Value>
class InOrder {
public:
  explicit InOrder(std::uint64_t first = 0) : next_(first) {}

  // Takes the value from `position` up to `end`, and calls sink(value) for it and for those waiting that
  // follow it, as soon as all before it have come.
  template <class Sink>
  void add(std::uint64_t position, std::uint64_t end, Value value, const Sink& sink) {
    const std::lock_guard lock(mutex_);
    waiting_.emplace(position, std::pair(end, std::move(value)));
    for (auto first = waiting_.begin(); first != waiting_.end() && first->first == next_;
         first = waiting_.erase(first)) {
      next_ = first->second.first;
      sink(first->second.second);
    }
  }

private:
  std::mutex mutex_;
  std::uint64_t next_;
  std::map<std::uint64_t, std::pair<std::uint64_t, Value>> waiting_; // by position
};

} // namespace masu
