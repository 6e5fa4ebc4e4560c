#include "libscene/file/temporary_name.h"

#include "libscene/base/error.h"

#include <fcntl.h>
#include <poll.h>
#include <pthread.h>
#include <sys/file.h>
#include <unistd.h>

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <functional>
#include <utility>

namespace masu {
namespace {

constexpr int max_names = 1000; // for a file

// The names in use, in static storage for the signal handler. Names that don't fit in aren't removed on
// signals.
struct RegisteredName {
  std::atomic<bool> reserved{false};
  std::atomic<int> folder{-1}; // 0 or more: `name` is valid
  std::array<char, 64> name{};
};
constinit std::array<RegisteredName, 64> registered_names;

void register_name(int folder, const std::string& name) {
  for (RegisteredName& entry : registered_names) {
    if (name.size() >= entry.name.size() || entry.reserved.exchange(true)) continue;
    std::copy(name.begin(), name.end(), entry.name.begin());
    entry.name[name.size()] = '\0';
    entry.folder = folder;
    return;
  }
}

void unregister_name(int folder, const std::string& name) {
  for (RegisteredName& entry : registered_names) {
    if (entry.folder != folder || name != entry.name.data()) continue;
    entry.folder = -1;
    entry.reserved = false;
    return;
  }
}

constinit std::atomic<bool> is_ending{false};
constinit std::atomic<int> changes{0}; // of names, under way

// A name that is made, renamed or removed, and what registered_names says of it: signals, also those which
// another thread handles, and other ends of the process wait until both are true.
class NameChange {
public:
  NameChange() {
    sigset_t held;
    sigemptyset(&held);
    for (const int signal : ending_signals)
      sigaddset(&held, signal);
    pthread_sigmask(SIG_BLOCK, &held, &before_);
    ++changes;
    if (!is_ending) return;
    --changes;
    for (;;) // the names that there were are being removed: no new ones
      pause();
  }
  ~NameChange() {
    const int reason = errno;
    --changes;
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
    errno = reason;
  }
  NameChange(const NameChange&) = delete;
  NameChange& operator=(const NameChange&) = delete;

private:
  sigset_t before_{};
};

// As the process ends: also names that are just being made.
void remove_temporary_names() {
  is_ending = true;
  constexpr int longest_wait = 5000; // ms: a file system that doesn't answer
  for (int waited = 0; changes > 0 && waited < longest_wait; ++waited)
    poll(nullptr, 0, 1);
  for (const RegisteredName& entry : registered_names) {
    if (const int folder = entry.folder; folder >= 0) unlinkat(folder, entry.name.data(), 0);
  }
}

void remove_all_and_end(int signal) {
  remove_temporary_names();
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

// Whether `name` still is a name of the file.
bool has_name(int file, int folder, const char* name) {
  struct stat status {
  }, named{};
  return fstat(file, &status) == 0 && fstatat(folder, name, &named, AT_SYMLINK_NOFOLLOW) == 0 &&
         is_same_file(status, named);
}

// False when another process holds the lock; true on file systems without locks.
bool lock(int file) {
  return flock(file, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK;
}

} // namespace

TemporaryName::TemporaryName(int folder, const std::string& name)
    : folder_(folder), hash_(std::hash<std::string>()(name)) {}

TemporaryName::~TemporaryName() {
  if (name_.empty()) return;
  const NameChange change;
  unlinkat(folder_, name_.c_str(), 0);
  unregister_name(folder_, name_);
}

// Removes a stale file: regular, unlocked, and still of that name once this process has locked it, after
// which no other process removes it.
bool TemporaryName::remove_stale(const char* name) const {
  const int file = openat(folder_, name, O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (file < 0) return errno == ENOENT; // removed meanwhile
  struct stat status {};
  const bool removed = fstat(file, &status) == 0 && S_ISREG(status.st_mode) &&
                       flock(file, LOCK_EX | LOCK_NB) == 0 && has_name(file, folder_, name) &&
                       unlinkat(folder_, name, 0) == 0;
  close(file);
  return removed;
}

std::string TemporaryName::numbered(int number) const {
  return fmt::format(".masu-{:016x}-{}.tmp", hash_, number);
}

void TemporaryName::remove_left() const {
  for (int number = 0; number < max_names; ++number) {
    const std::string name = numbered(number);
    if (faccessat(folder_, name.c_str(), F_OK, AT_SYMLINK_NOFOLLOW) != 0) return;
    remove_stale(name.c_str());
  }
}

template <class Act>
bool TemporaryName::take(const Act& act) {
  const NameChange change;
  constexpr int max_attempts = 100;
  for (int number = 0; number < max_names; ++number) {
    std::string name = numbered(number);
    for (int attempt = 0; attempt < max_attempts; ++attempt) {
      if (act(name.c_str())) {
        name_ = std::move(name); // can't throw: the file would be left
        register_name(folder_, name_);
        return true;
      }
      if (errno != EEXIST) return false;
      if (!remove_stale(name.c_str())) break; // another process is writing it
    }
  }
  errno = EEXIST;
  return false;
}

int TemporaryName::create() {
  int file = -1;
  take([&](const char* name) {
    file = openat(folder_, name, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (file < 0) return false;
    // Before it was locked, another process could have removed it as stale.
    if (lock(file) && has_name(file, folder_, name)) return true;
    close(file);
    file = -1;
    errno = EEXIST;
    return false;
  });
  return file;
}

bool TemporaryName::link(int file) {
  static_cast<void>(lock(file));
  const std::string unnamed = fmt::format("/proc/self/fd/{}", file);
  return take([&](const char* name) {
    return linkat(AT_FDCWD, unnamed.c_str(), folder_, name, AT_SYMLINK_FOLLOW) == 0;
  });
}

bool TemporaryName::rename_to(const std::string& name) {
  const NameChange change;
  if (renameat(folder_, name_.c_str(), folder_, name.c_str()) != 0) return false;
  unregister_name(folder_, name_);
  name_.clear();
  return true;
}

void claim_last_line() {
  static constinit std::atomic<pthread_t> owner{0};
  pthread_t before = 0;
  if (owner.compare_exchange_strong(before, pthread_self()) || pthread_equal(before, pthread_self()) != 0)
    return;
  for (;;)
    pause();
}

void end_with_line(std::initializer_list<const char*> parts) {
  claim_last_line();
  std::array<char, 1400> line{};
  std::size_t length = 0;
  for (const char* const part : parts)
    for (const char* c = part; *c != '\0' && length < line.size() - 1; ++c)
      line[length++] = *c;
  line[length++] = '\n';
  static_cast<void>(!write(STDERR_FILENO, line.data(), length));
  remove_temporary_names();
  _exit(static_cast<int>(ErrorCode::input));
}

void remove_temporary_names_on_signals() {
  for (const int signal : ending_signals) {
    if (std::signal(signal, remove_all_and_end) == SIG_IGN) std::signal(signal, SIG_IGN);
  }
}

} // namespace masu
