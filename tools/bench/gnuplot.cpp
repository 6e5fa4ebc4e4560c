#include "tools/bench/gnuplot.h"

#include "libscene/base/error.h"
#include "libscene/file/memory_file.h"
#include "libscene/file/output_file.h"

#include <fmt/format.h>
#include <spawn.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <list>
#include <string_view>
#include <vector>

namespace masu {
namespace {

// This process's environment with a UTF-8 locale: in others gnuplot warns of characters that they lack.
std::vector<std::string> environment_in_utf8() {
  std::vector<std::string> variables;
  for (char** variable = environ; *variable != nullptr; ++variable) {
    const std::string_view text = *variable;
    if (!text.starts_with("LC_") && !text.starts_with("LANG=")) variables.emplace_back(text);
  }
  variables.emplace_back("LC_ALL=C.UTF-8");
  return variables;
}

std::vector<char*> pointers_to(std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  pointers.reserve(texts.size() + 1);
  for (std::string& text : texts)
    pointers.push_back(text.data());
  pointers.push_back(nullptr);
  return pointers;
}

// Runs a program in that folder, with those files open under the same descriptors. False where there is no
// such program.
bool run(std::vector<std::string> command, const std::string& folder, const std::vector<int>& files) {
  std::vector<std::string> environment = environment_in_utf8();
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  for (const int file : files)
    posix_spawn_file_actions_adddup2(&actions, file, file); // clears close-on-exec
  pid_t process = 0;
  const int error = posix_spawnp(&process, command.front().c_str(), &actions, nullptr,
                                 pointers_to(command).data(), pointers_to(environment).data());
  posix_spawn_file_actions_destroy(&actions);
  if (error == ENOENT || error == EACCES) return false;
  if (error != 0) throw Error(ErrorCode::output, command.front(), std::strerror(error));
  int status = 0;
  while (waitpid(process, &status, 0) < 0) {
    if (errno != EINTR) throw Error(ErrorCode::output, command.front(), std::strerror(errno));
  }
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
    throw Error(ErrorCode::output, command.front(),
                "fails on the data in " + folder + ": see its own message above");
  return true;
}

} // namespace

bool draw_charts(const std::string& script, const std::string& folder,
                 const std::vector<std::string>& names) {
  const auto path_of = [](int file) { return fmt::format("/proc/self/fd/{}", file); };
  const MemoryFile memory;
  OutputFile text(memory.path());
  text.write(script.data(), script.size());
  static_cast<void>(std::fflush(text.stream())); // into memory
  std::vector<int> files{fileno(text.stream())};
  std::list<OutputFile> charts;
  std::string outputs;
  for (const std::string& name : names) {
    files.push_back(fileno(charts.emplace_back(fmt::format("{}/{}", folder, name)).stream()));
    outputs += name + " " + path_of(files.back()) + " ";
  }
  if (!run({"gnuplot", "-e", "outputs = '" + outputs + "'", path_of(files.front())}, folder, files))
    return false;
  for (OutputFile& chart : charts) {
    struct stat state {};
    if (fstat(fileno(chart.stream()), &state) == 0 && state.st_size > 0) chart.commit();
  }
  return true;
}

} // namespace masu
