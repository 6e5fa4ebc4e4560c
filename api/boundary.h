// What the functions of the C interface share: arguments are checked, exceptions become statuses, and a
// program's go_on() (masu.h) the progress that libraries report to.
#pragma once

#include "libscene/base/error.h"
#include "masu.h"

#include <fmt/format.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstring>
#include <functional>
#include <new>
#include <string>
#include <string_view>
#include <thread>

namespace masu {

// Thrown where go_on() has returned 0.
struct Interrupted {};

// Of a call, in whose thread it is made: only there go_on() is called. Where libraries report from other
// threads, they learn whether it has returned 0.
class GoOn {
public:
  GoOn(masu_go_on go_on, void* user) : go_on_(go_on), user_(user) {}
  GoOn(const GoOn&) = delete;
  GoOn& operator=(const GoOn&) = delete;
  ~GoOn() = default;

  // Empty where there is no go_on(). It refers to this.
  std::function<void(double)> progress() {
    if (go_on_ == nullptr) return {};
    return [this](double done) { report(done); };
  }

private:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::milliseconds apart{100};

  void report(double done) {
    if (has_ended_) throw Interrupted();
    if (std::this_thread::get_id() != caller_) return;
    if (const Clock::time_point now = Clock::now(); now < next_) return;
    // Isolated, or what go_on() calls might wait by taking tasks of this call, which would get here again.
    has_ended_ = tbb::this_task_arena::isolate([&] { return go_on_(user_, done) == 0; });
    if (has_ended_) throw Interrupted();
    next_ = Clock::now() + apart;
  }

  masu_go_on go_on_;
  void* user_;
  std::thread::id caller_ = std::this_thread::get_id();
  std::atomic<bool> has_ended_ = false;
  Clock::time_point next_ = Clock::now() + apart; // the caller's thread alone looks at it
};

// Keeps the text for masu_error(), as one line, and returns the status.
masu_status report(masu_status status, std::string_view text) noexcept;

// The status of act(), which may throw.
template <class Act>
masu_status guarded(const Act& act) noexcept {
  try {
    act();
    return MASU_OK;
  } catch (const Error& error) {
    return report(static_cast<masu_status>(error.code()), error.text());
  } catch (const Interrupted&) {
    return report(MASU_ERROR_INTERRUPTED, "go_on: has ended the call");
  } catch (const std::bad_alloc&) {
    return report(MASU_ERROR_MEMORY, "memory: there isn't enough");
  } catch (const std::exception& error) {
    return report(MASU_ERROR_INPUT, error.what());
  } catch (...) {
    return report(MASU_ERROR_INPUT, "an unknown error");
  }
}

inline void require(const void* pointer, const char* place) {
  if (pointer == nullptr) fail(place, "is a null pointer");
}

// `count` groups of numbers of which one array is given, or neither where there are none.
inline void require_numbers(const float* floats, const double* doubles, std::size_t count,
                            const char* place) {
  if (count > 0 && floats == nullptr) require(doubles, place);
  if (floats != nullptr && doubles != nullptr) fail(place, "are given twice: as float and as double");
}

inline void require_range(double value, double low, double high, const char* place) {
  if (!(value >= low && value <= high)) fail(place, fmt::format("{} isn't from {} to {}", value, low, high));
}

// What act() returns, on no more threads than so many; 0: on all.
template <class Act>
auto on_threads_up_to(int threads, const Act& act) {
  require_range(threads, 0, 4096, "threads");
  // TBB warns on standard error of an arena that is larger than what there is.
  const int there = tbb::this_task_arena::max_concurrency();
  return threads == 0 || threads >= there ? act() : tbb::task_arena(threads).execute(act);
}

// An enumeration's value out of C, of so many that there are. C++ has no others, so its bytes are looked at.
template <class To, class From>
To choice(const From& value, int values, const char* place) {
  int number = 0;
  static_assert(sizeof number == sizeof value);
  std::memcpy(&number, &value, sizeof number);
  if (number < 0 || number >= values) fail(place, fmt::format("{} isn't one of its values", number));
  return static_cast<To>(number);
}

// The size of a structure in its first version: a program compiled with that one may call. Specialized when
// fields are added.
template <class Struct>
inline constexpr std::size_t first_size = sizeof(Struct);
template <>
inline constexpr std::size_t first_size<masu_geometry> = offsetof(masu_geometry, go_on);
template <>
inline constexpr std::size_t first_size<masu_build_options> = offsetof(masu_build_options, go_on);
template <>
inline constexpr std::size_t first_size<masu_tracer_options> = offsetof(masu_tracer_options, go_on);
template <>
inline constexpr std::size_t first_size<masu_query> = offsetof(masu_query, go_on);
template <>
inline constexpr std::size_t first_size<masu_hits> = offsetof(masu_hits, position);

template <class Struct>
std::size_t checked_size(const Struct* given, const char* place) {
  std::size_t size = 0;
  std::memcpy(&size, given, sizeof size);
  if (size < first_size<Struct> || size > 4096 || size % alignof(Struct) != 0)
    fail(place, fmt::format("{} isn't its size: set it to sizeof({})", size, place));
  return size;
}

// A program's structure as this library knows it: what an older program doesn't have is zero. What a newer
// one has besides must be zero.
template <class Struct>
Struct taken(const Struct* given, const char* place) {
  require(given, place);
  const std::size_t size = checked_size(given, place);
  const auto* const bytes = reinterpret_cast<const unsigned char*>(given);
  if (std::any_of(bytes + std::min(size, sizeof(Struct)), bytes + size,
                  [](unsigned char b) { return b != 0; }))
    fail(place, "has options that this version of the library doesn't know: install the program's");
  Struct known{};
  std::memcpy(&known, given, std::min(size, sizeof known));
  return known;
}

// An array of them, each as large as the first says.
template <class Struct, class Act>
void for_each_taken(const Struct* given, std::size_t count, const char* place, const Act& act) {
  if (count == 0) return;
  require(given, place);
  const std::size_t stride = checked_size(given, place);
  for (std::size_t i = 0; i < count; ++i)
    act(taken(reinterpret_cast<const Struct*>(reinterpret_cast<const unsigned char*>(given) + i * stride),
              place));
}

// The other way: fills in a program's structure, as far as it goes.
template <class Struct>
void give(Struct known, Struct* to, const char* place) {
  require(to, place);
  known.size = checked_size(to, place);
  if (known.size > sizeof known) std::memset(static_cast<void*>(to), 0, known.size);
  std::memcpy(static_cast<void*>(to), &known, std::min(known.size, sizeof known));
}

// What a call made, for the program.
template <class Object, class Make>
masu_status make(Object** made, const char* place, const Make& make_object) noexcept {
  return guarded([&] {
    require(made, place);
    *made = nullptr;
    *made = make_object().release();
  });
}

} // namespace masu
