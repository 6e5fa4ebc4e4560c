#include "tests/tools/run_tool.h"

#include <fcntl.h>
#include <nlohmann/json.hpp>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <iterator>
#include <sstream>

extern char** environ;

namespace masu {
namespace {

struct Spawned {
  pid_t process = -1;
  int error = 0;
};

Spawned spawn(const std::string& tool, const Arguments& arguments, const Surroundings& surroundings,
              const std::string& out, const std::string& err) {
  const std::string path = tool.starts_with('/') ? tool : std::string(MASU_BIN_DIR) + "/" + tool;
  std::vector<char*> argv{const_cast<char*>(path.c_str())};
  for (const std::string& argument : arguments)
    argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  std::vector<char*> environment;
  const std::string& own = surroundings.environment;
  if (!own.empty()) environment.push_back(const_cast<char*>(own.c_str()));
  const std::string name = own.substr(0, own.find('=') + 1);
  for (char** variable = environ; *variable != nullptr; ++variable)
    if (own.empty() || !std::string_view(*variable).starts_with(name)) environment.push_back(*variable);
  environment.push_back(nullptr);

  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, 0, surroundings.input.c_str(), O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, 1, out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  posix_spawn_file_actions_addopen(&actions, 2, err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  for (const int stream : surroundings.closed)
    posix_spawn_file_actions_addclose(&actions, stream);
  Spawned spawned;
  spawned.error =
      posix_spawn(&spawned.process, path.c_str(), &actions, nullptr, argv.data(), environment.data());
  posix_spawn_file_actions_destroy(&actions);
  EXPECT_EQ(spawned.error, 0) << path << " can't be started: " << std::strerror(spawned.error);
  return spawned;
}

// Rows of a table, one for each choice of [a|b].
std::vector<std::string> expanded(const std::string& row) {
  const std::size_t open = row.find('['), close = row.find(']', open);
  if (open == std::string::npos) return {row};
  std::vector<std::string> all;
  std::istringstream choices(row.substr(open + 1, close - open - 1));
  for (std::string choice; std::getline(choices, choice, '|');)
    for (const std::string& rest : expanded(row.substr(close + 1)))
      all.push_back(row.substr(0, open) + choice + rest);
  return all;
}
std::vector<std::string> rows_of(std::string_view commands) {
  std::vector<std::string> rows;
  std::istringstream table{std::string(commands)};
  for (std::string row; std::getline(table, row);)
    if (!row.empty()) std::ranges::move(expanded(row), std::back_inserter(rows));
  return rows;
}

} // namespace

Arguments joined(Arguments first, const Arguments& more) {
  first.insert(first.end(), more.begin(), more.end());
  return first;
}

ToolResult run(const std::string& tool, const Arguments& arguments, const Surroundings& surroundings) {
  const TemporaryFolder folder;
  const std::string out = surroundings.output.empty() ? folder.file("out") : surroundings.output;
  const std::string err = surroundings.error.empty() ? folder.file("err") : surroundings.error;
  const Spawned spawned = spawn(tool, arguments, surroundings, out, err);
  ToolResult result;
  if (spawned.error != 0) return result;
  int status = 0;
  if (waitpid(spawned.process, &status, 0) != spawned.process) return result;
  result.code = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  if (surroundings.output.empty()) result.out = read_text(out);
  if (surroundings.error.empty()) result.err = read_text(err);
  return result;
}

std::chrono::duration<double> time_of(const std::string& tool, const Arguments& arguments) {
  const auto begin = std::chrono::steady_clock::now();
  expect_run(tool, arguments);
  return std::chrono::steady_clock::now() - begin;
}

pid_t start(const std::string& tool, const Arguments& arguments) {
  return spawn(tool, arguments, {}, "/dev/null", "/dev/null").process;
}

testing::AssertionResult succeeded(const ToolResult& result) {
  bool only_notes = true;
  std::istringstream lines(result.err);
  for (std::string line; std::getline(lines, line);)
    only_notes = only_notes && (line.find(" rays in ") != std::string::npos ||
                                line.ends_with(" files are there and are kept") ||
                                line.ends_with(" lanes of a warp under way, on average over its turns") ||
                                line.find(": no usable GPU: ") != std::string::npos);
  if (result.code == 0 && only_notes) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "exit code " << result.code << ", stderr: " << result.err;
}

testing::AssertionResult failed(const ToolResult& result, int code, const std::string& tool,
                                const std::string& place, const std::string& says) {
  const auto no = [&](const std::string& why) {
    return testing::AssertionFailure()
           << why << "\nexit code " << result.code << ", stderr: " << result.err << "stdout: " << result.out;
  };
  if (result.code != code) return no("the exit code should be " + std::to_string(code));
  if (!result.out.empty()) return no("stdout should be empty");
  const std::string& error = result.err;
  if (error.empty() || error.find('\n') != error.size() - 1) return no("stderr should be one line");
  const std::string head = tool + ": " + place + ": ";
  if (!error.starts_with(head)) return no("stderr should begin with '" + head + "'");
  if (error.size() < head.size() + 8) return no("the line should say what is wrong");
  if (error.find(says, head.size()) == std::string::npos) return no("stderr should say '" + says + "'");
  return testing::AssertionSuccess();
}

std::string ToolTest::nff(const std::string& name, std::string_view text) const {
  write_text(file(name), text);
  return file(name);
}

std::string ToolTest::spd(const std::string& name, const std::string& scene, int size) const {
  const Arguments sized = size > 0 ? Arguments{"--size", std::to_string(size)} : Arguments{};
  expect_run("nffgen", joined({scene, "-o", file(name)}, sized));
  return file(name);
}

std::string ToolTest::scene(const std::string& name, const std::string& nff, const Arguments& more) const {
  expect_run("nff2bin", joined({nff, "-o", file(name)}, more));
  return file(name);
}

std::string ToolTest::grid(const std::string& name, const std::string& scene, const std::string& division,
                           const Arguments& more) const {
  expect_run("gridbuild", joined({scene, "-o", file(name), "--division", division}, more));
  return file(name);
}

nlohmann::json ToolTest::json_of(const std::string& tool, const Arguments& arguments) const {
  const ToolResult result = run(tool, joined(arguments, {"--json"}));
  EXPECT_TRUE(succeeded(result));
  auto json = nlohmann::json::parse(result.out, nullptr, false);
  EXPECT_FALSE(json.is_discarded()) << result.out;
  return json;
}

nlohmann::json ToolTest::json_in(const std::string& name) const {
  return nlohmann::json::parse(read_text(file(name)), nullptr, false);
}

nlohmann::json SmallSceneTest::stats_of(const Arguments& more) const {
  render(joined({"--stats", file("stats.json")}, more));
  return json_in("stats.json");
}

std::string ToolTest::with_folder(std::string text) const {
  const std::size_t at = text.find('~');
  return at == std::string::npos ? text : text.replace(at, 1, folder_.path().string());
}

Arguments ToolTest::words(std::string_view row) const {
  std::istringstream stream{std::string(row)};
  Arguments all{std::istream_iterator<std::string>(stream), {}};
  for (std::string& word : all) {
    std::ranges::replace(word, '_', ' ');
    word = with_folder(word);
  }
  return all;
}

void ToolTest::expect_runs(std::string_view commands) const {
  for (const std::string& row : rows_of(commands)) {
    const Arguments command = words(row);
    EXPECT_TRUE(succeeded(run(command[0], {command.begin() + 1, command.end()}))) << row;
  }
}

void ToolTest::expect_refused(int code, std::string_view commands, const Surroundings& surroundings) const {
  for (const std::string& row : rows_of(commands)) {
    const Arguments command = words(row.substr(0, row.find(" > ")));
    std::string place = "command line", says;
    if (const std::size_t end = row.find(" > "); end != std::string::npos) {
      const std::size_t colon = row.find(": ", end);
      place = with_folder(row.substr(end + 3, colon - end - 3));
      if (colon != std::string::npos) says = row.substr(colon + 2);
    }
    const auto is_option = [](const std::string& word) { return word.starts_with("--"); };
    if (place == "@") place = command.back();
    if (place == "@option") place = *std::ranges::find_if(command.rbegin(), command.rend(), is_option);
    EXPECT_TRUE(fails(code, command[0], {command.begin() + 1, command.end()}, place, says, surroundings))
        << row;
  }
}

testing::AssertionResult ToolTest::fails(int code, const std::string& tool, const Arguments& arguments,
                                         const std::string& place, const std::string& says,
                                         const Surroundings& surroundings) const {
  const auto before = folder_.listing();
  const auto result = failed(run(tool, arguments, surroundings), code, tool, place, says);
  if (result && folder_.listing() != before) return testing::AssertionFailure() << "a file was left behind";
  return result;
}

} // namespace masu
