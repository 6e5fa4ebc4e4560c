#include "tools/child_process.h"

#include "libscene/error.h"
#include "libscene/file/temporary_name.h"

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>

namespace masu {
namespace {

bool is_ignored(int signal) {
  struct sigaction action {};
  return sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

// How the child ended, as waitpid() has it. `awaited` are blocked, and so wait for sigwaitinfo().
int status_of(pid_t child, const sigset_t& awaited) {
  for (;;) {
    const int signal = sigwaitinfo(&awaited, nullptr);
    int status = 0;
    if (signal == SIGCHLD && waitpid(child, &status, WNOHANG) == child) return status;
    if (signal > 0 && signal != SIGCHLD) kill(child, signal);
  }
}

} // namespace

int continue_in_child() {
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
      prctl(PR_SET_PDEATHSIG, SIGTERM);
      if (getppid() != parent) std::raise(SIGTERM); // killed before that
    }
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
    if (child == 0) return 0;
    throw Error(ErrorCode::input, "process",
                std::string("can't be started: ") + std::strerror(reason) + ": end others, or free memory");
  }
  const int status = status_of(child, awaited);
  if (WIFEXITED(status)) _exit(WEXITSTATUS(status));
  const int signal = WTERMSIG(status);
  const bool was_passed_on = std::ranges::count(ending_signals, signal) > 0;
  if (was_passed_on) std::signal(signal, SIG_DFL);
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  if (was_passed_on) std::raise(signal);
  return signal;
}

} // namespace masu
