#include "libscene/file/temporary_name.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <functional>

namespace masu {
namespace {

// The names taken, where a signal's handler, which is told nothing, finds them. Names beyond those that fit
// aren't removed on signals.
struct TakenName {
  std::atomic<bool> reserved{false};
  std::atomic<int> folder{-1}; // at least 0: what follows is a name in it
  std::array<char, 64> name{};
};
constinit std::array<TakenName, 64> taken_names;

void remember(int folder, const std::string& name) {
  for (TakenName& taken : taken_names) {
    if (name.size() >= taken.name.size() || taken.reserved.exchange(true)) continue;
    std::copy(name.begin(), name.end(), taken.name.begin());
    taken.name[name.size()] = '\0';
    taken.folder = folder;
    return;
  }
}

void forget(int folder, const std::string& name) {
  for (TakenName& taken : taken_names) {
    if (taken.folder != folder || name != taken.name.data()) continue;
    taken.folder = -1;
    taken.reserved = false;
    return;
  }
}

// Calls only what may be called in a signal's handler.
void remove_all_and_end(int signal) {
  for (const TakenName& taken : taken_names) {
    if (const int folder = taken.folder; folder >= 0) unlinkat(folder, taken.name.data(), 0);
  }
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

bool is_same_file(const struct stat& a, const struct stat& b) {
  return a.st_dev == b.st_dev && a.st_ino == b.st_ino;
}

// Whether the file still has that name.
bool has_name(int file, int folder, const char* name) {
  struct stat its {
  }, of_name{};
  return fstat(file, &its) == 0 && fstatat(folder, name, &of_name, AT_SYMLINK_NOFOLLOW) == 0 &&
         is_same_file(its, of_name);
}

// False where another process has the lock. File systems without locks have nothing to lock out.
bool lock(int file) {
  return flock(file, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK;
}

} // namespace

TemporaryName::TemporaryName(int folder, const std::string& name)
    : folder_(folder), hash_(std::hash<std::string>()(name)) {}

TemporaryName::~TemporaryName() {
  if (name_.empty()) return;
  unlinkat(folder_, name_.c_str(), 0);
  forget(folder_, name_);
}

// The name's file is unlocked, regular, and still has the name once it is locked here: then only this process
// may remove it.
bool TemporaryName::remove_abandoned(const char* name) const {
  const int file = openat(folder_, name, O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (file < 0) return errno == ENOENT; // gone meanwhile
  struct stat status {};
  const bool removed = fstat(file, &status) == 0 && S_ISREG(status.st_mode) &&
                       flock(file, LOCK_EX | LOCK_NB) == 0 && has_name(file, folder_, name) &&
                       unlinkat(folder_, name, 0) == 0;
  close(file);
  return removed;
}

template <class Act>
bool TemporaryName::take(const Act& act) {
  constexpr int most_names = 1000, most_turns = 100;
  for (int number = 0; number < most_names; ++number) {
    const std::string name = fmt::format(".masu-{:016x}-{}.tmp", hash_, number);
    for (int turn = 0; turn < most_turns; ++turn) {
      if (act(name.c_str())) {
        name_ = name;
        remember(folder_, name_);
        return true;
      }
      if (errno != EEXIST) return false;
      if (!remove_abandoned(name.c_str())) break; // somebody is at work there
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
    // Until it was locked, another process could take it for abandoned.
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
  if (renameat(folder_, name_.c_str(), folder_, name.c_str()) != 0) return false;
  forget(folder_, name_);
  name_.clear();
  return true;
}

void remove_temporary_names_on_signals() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    if (std::signal(signal, remove_all_and_end) == SIG_IGN) std::signal(signal, SIG_IGN);
  }
}

} // namespace masu
