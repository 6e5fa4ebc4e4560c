#include "tools/bench/gnuplot.h"

#include "libscene/error.h"
#include "libscene/file/output_file.h"

#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <list>
#include <string_view>
#include <vector>

namespace masu {
namespace {

// This process's environment, but for the locale: charts are in UTF-8 wherever they are drawn, and gnuplot
// warns of a degree sign in a locale that hasn't any.
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
  for (std::string& text : texts)
    pointers.push_back(text.data());
  pointers.push_back(nullptr);
  return pointers;
}

// Runs it in that folder, with those files open. False where there is no such program.
bool run(std::vector<std::string> command, const std::string& folder, const std::vector<int>& files) {
  std::vector<std::string> environment = environment_in_utf8();
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  for (const int file : files)
    posix_spawn_file_actions_adddup2(&actions, file, file); // stays open
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
                "fails on " + folder + "/" + command.back() + ": see what it says of it");
  return true;
}

} // namespace

bool draw_charts(const ChartScript& script, const std::string& folder, const std::string& name) {
  OutputFile text(folder + "/" + name);
  text.write(script.text.data(), script.text.size());
  text.commit();
  std::list<OutputFile> charts;
  std::vector<int> files;
  std::string outputs;
  for (std::size_t i = 0; i < script.files.size(); ++i) {
    files.push_back(fileno(charts.emplace_back(folder + "/" + script.files[i]).stream()));
    outputs += fmt::format("chart_{} = '/proc/self/fd/{}'; ", i, files.back());
  }
  if (!run({"gnuplot", "-e", outputs, name}, folder, files)) return false;
  for (OutputFile& chart : charts)
    chart.commit();
  return true;
}

} // namespace masu
