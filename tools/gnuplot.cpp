#include "tools/gnuplot.h"

#include "libscene/error.h"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace masu {

bool run_gnuplot(const std::string& folder, const std::string& script) {
  std::string program = "gnuplot", argument = script;
  char* const argv[] = {program.data(), argument.data(), nullptr};
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  pid_t process = 0;
  const int error = posix_spawnp(&process, program.c_str(), &actions, nullptr, argv, environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error == ENOENT || error == EACCES) return false;
  if (error != 0) throw Error(ErrorCode::output, "gnuplot", std::strerror(error));
  int status = 0;
  while (waitpid(process, &status, 0) < 0) {
    if (errno != EINTR) throw Error(ErrorCode::output, "gnuplot", std::strerror(errno));
  }
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
    throw Error(ErrorCode::output, "gnuplot",
                "fails on " + folder + "/" + script + ": see what it says of it");
  return true;
}

} // namespace masu
