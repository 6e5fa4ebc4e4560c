#include "libscene/file/file_mapping.h"

#include "libscene/base/error.h"
#include "libscene/file/temporary_name.h"

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <condition_variable>
#include <csignal>
#include <cstring>
#include <ctime>
#include <mutex>
#include <stop_token>
#include <string_view>
#include <utility>

namespace masu {
namespace {

// The mappings that there are, in static storage for the signal handler. Faults in those that don't fit in
// end the program as by default.
struct RegisteredMapping {
  std::atomic<bool> reserved{false};
  std::atomic<const std::uint8_t*> begin{nullptr}; // not null: the rest is valid
  std::size_t size = 0;
  int file = -1;
  struct stat opened {};
  std::array<char, 1024> path{};
};
constinit std::array<RegisteredMapping, 16> registered_mappings;
constinit std::atomic<const char*> name_of_tool{nullptr};

void register_mapping(const std::uint8_t* begin, const InputFile& file) {
  for (RegisteredMapping& entry : registered_mappings) {
    if (entry.reserved.exchange(true)) continue;
    entry.size = file.size();
    entry.file = file.descriptor();
    entry.opened = file.opened();
    const std::string_view path = std::string_view(file.path()).substr(0, entry.path.size() - 1);
    std::ranges::copy(path, entry.path.begin());
    entry.path[path.size()] = '\0';
    entry.begin = begin;
    return;
  }
}

void unregister_mapping(const std::uint8_t* begin) {
  for (RegisteredMapping& entry : registered_mappings) {
    if (entry.begin != begin) continue;
    entry.begin = nullptr;
    entry.reserved = false;
    return;
  }
}

// What follows, up to end_by_fault(), calls only async-signal-safe functions.

const RegisteredMapping* first_changed() {
  for (const RegisteredMapping& entry : registered_mappings)
    if (entry.begin != nullptr && has_changed(entry.file, entry.opened)) return &entry;
  return nullptr;
}

const RegisteredMapping* mapping_of(const void* address) {
  const auto* const byte = static_cast<const std::uint8_t*>(address);
  for (const RegisteredMapping& entry : registered_mappings) {
    const std::uint8_t* const begin = entry.begin;
    if (begin != nullptr && byte >= begin && byte < begin + entry.size) return &entry;
  }
  return nullptr;
}

[[noreturn]] void end_for(const RegisteredMapping& mapping, const char* what) {
  end_with_line({name_of_tool, ": ", mapping.path.data(), ": ", what});
}

constexpr const char* changed = "was changed while it was in use: run again when it is complete";

void end_by_fault(int signal, siginfo_t* fault, void*) {
  if (const RegisteredMapping* const mapping = first_changed()) end_for(*mapping, changed);
  if (const RegisteredMapping* const mapping = signal == SIGBUS ? mapping_of(fault->si_addr) : nullptr)
    end_for(*mapping, "can't be read: the disk or the network reports an error");
  std::signal(signal, SIG_DFL); // and the same instruction faults again
}

constexpr std::array fault_signals{SIGBUS, SIGSEGV};

void watch_mappings(const std::stop_token& stop) {
  // A query that is under way when a file changes ends before that, as a rule, and says so itself.
  constexpr std::chrono::milliseconds interval(100), patience(1000);
  std::mutex mutex;
  std::condition_variable_any stopped;
  std::unique_lock lock(mutex);
  for (std::chrono::milliseconds waited(0); !stop.stop_requested();) {
    stopped.wait_for(lock, stop, interval, [] { return false; });
    const RegisteredMapping* const mapping = first_changed();
    waited = mapping != nullptr ? waited + interval : std::chrono::milliseconds(0);
    if (mapping != nullptr && waited > patience && !stop.stop_requested()) end_for(*mapping, changed);
  }
}

// Times of files are those of the kernel's last tick.
void wait_until_later_than(const timespec& written) {
  constexpr int longest_wait = 50; // ms; times that other machines set may be in the future
  timespec now{};
  for (int waited = 0; waited < longest_wait; ++waited) {
    clock_gettime(CLOCK_REALTIME_COARSE, &now);
    if (now.tv_sec > written.tv_sec || (now.tv_sec == written.tv_sec && now.tv_nsec > written.tv_nsec))
      return;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

} // namespace

FileMapping::FileMapping(const InputFile& file) : size_(file.size()) {
  wait_until_later_than(file.opened().st_mtim);
  if (size_ == 0) return;
  void* const mapped = mmap(nullptr, size_, PROT_READ, MAP_SHARED, file.descriptor(), 0);
  if (mapped == MAP_FAILED)
    throw Error(ErrorCode::input, file.path(), std::string("can't be mapped: ") + std::strerror(errno));
  begin_ = static_cast<const std::uint8_t*>(mapped);
  static_cast<void>(madvise(mapped, size_, MADV_WILLNEED)); // a hint
  register_mapping(begin_, file);
}

FileMapping::~FileMapping() {
  if (begin_ == nullptr) return;
  unregister_mapping(begin_);
  munmap(const_cast<std::uint8_t*>(begin_), size_);
}

FileMapping& FileMapping::operator=(FileMapping&& other) noexcept {
  std::swap(begin_, other.begin_);
  std::swap(size_, other.size_);
  return *this;
}

MappingFaults::MappingFaults(const char* tool) {
  name_of_tool = tool;
  struct sigaction action {};
  action.sa_sigaction = end_by_fault;
  action.sa_flags = SA_SIGINFO;
  for (const int signal : fault_signals)
    sigaction(signal, &action, nullptr);
  watch_ = std::jthread(watch_mappings);
}

MappingFaults::~MappingFaults() {
  watch_.request_stop();
  watch_.join();
  for (const int signal : fault_signals)
    std::signal(signal, SIG_DFL);
}

} // namespace masu
