// One process.
#include "tools/jobs/ranks.h"

#include <atomic>

namespace masu {

struct Ranks::State {
  std::atomic<std::uint64_t> next = 0, finished = 0;
};

Ranks::Ranks() = default;
Ranks::~Ranks() = default;

bool Ranks::prints_help() {
  return true;
}
void Ranks::start() {
  state_ = std::make_unique<State>();
}

std::uint64_t Ranks::next() {
  return state_->next++;
}
std::uint64_t Ranks::add_finished(std::uint64_t amount) {
  return state_->finished += amount;
}
void Ranks::wait_for_all(const std::function<void()>&) {}
void Ranks::sum(std::span<std::uint64_t>) {}
void Ranks::sum(std::span<double>) {}
void Ranks::broadcast(std::string&) {}
bool Ranks::is_first_to_fail() {
  return true;
}
int Ranks::ended(int code) {
  return code;
}

} // namespace masu
