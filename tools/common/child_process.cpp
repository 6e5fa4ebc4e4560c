#include "tools/common/child_process.h"

#include "libscene/base/error.h"
#include "libscene/file/temporary_name.h"

#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>

namespace masu {
namespace {

bool is_ignored(int signal) {
  struct sigaction action {};
  return sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

// How the child ended, as waitpid() has it. `awaited`: signals that are blocked, so that sigwaitinfo() gets
// them.
int status_of(pid_t child, const sigset_t& awaited) {
  for (;;) {
    const int signal = sigwaitinfo(&awaited, nullptr);
    int status = 0;
    if (signal == SIGCHLD && waitpid(child, &status, WNOHANG) == child) return status;
    if (signal > 0 && signal != SIGCHLD) kill(child, signal);
  }
}

// Lines for standard error, held back in memory; -1 where a person reads along, there is no memory, or a
// limit of files, which it counts as, leaves no room for them.
int open_lines() {
  constexpr rlim_t enough = 1 << 20;
  rlimit limit{};
  const bool has_room = getrlimit(RLIMIT_FSIZE, &limit) != 0 || limit.rlim_cur >= enough;
  return isatty(STDERR_FILENO) != 0 || !has_room ? -1 : memfd_create("lines", MFD_CLOEXEC);
}
void print_lines(int lines) {
  std::array<char, 4096> part{};
  const off_t size = lseek(lines, 0, SEEK_END);
  for (off_t at = 0; at < size;) {
    const ssize_t got =
        pread(lines, part.data(), std::min(part.size(), static_cast<std::size_t>(size - at)), at);
    if (got <= 0 || write(STDERR_FILENO, part.data(), static_cast<std::size_t>(got)) != got) return;
    at += got;
  }
}

} // namespace

int continue_in_child() {
  const int lines = open_lines();
  sigset_t awaited, before;
  sigemptyset(&awaited);
  sigaddset(&awaited, SIGCHLD);
  for (const int signal : ending_signals)
    if (!is_ignored(signal)) sigaddset(&awaited, signal);
  std::signal(SIGCHLD, SIG_DFL); // ignored, it would leave no status
  pthread_sigmask(SIG_BLOCK, &awaited, &before);
  const pid_t parent = getpid(), child = fork();
  if (child <= 0) {
    const int reason = errno;
    if (child == 0) {
      if (lines >= 0) dup2(lines, STDERR_FILENO);
      prctl(PR_SET_PDEATHSIG, SIGTERM);
      if (getppid() != parent) std::raise(SIGTERM); // killed before that
    }
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
    if (child == 0) return 0;
    throw Error(ErrorCode::input, "process",
                std::string("can't be started: ") + std::strerror(reason) + ": end others, or free memory");
  }
  const int status = status_of(child, awaited);
  if (WIFEXITED(status)) {
    print_lines(lines);
    _exit(WEXITSTATUS(status));
  }
  const int signal = WTERMSIG(status);
  const bool was_passed_on = std::ranges::count(ending_signals, signal) > 0;
  if (was_passed_on) std::signal(signal, SIG_DFL);
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  if (was_passed_on) std::raise(signal);
  return signal;
}

} // namespace masu
