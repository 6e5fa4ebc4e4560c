// Runs the built tools, each in a process of its own.
#pragma once

#include "tests/seeded_test.h"
#include "tests/temporary_folder.h"

#include <nlohmann/json_fwd.hpp>
#include <sys/types.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace masu {

using Arguments = std::vector<std::string>;

struct ToolResult {
  int code = -1; // exit code; minus the signal's number where a signal terminated it
  std::string out, err;
};

Arguments joined(Arguments first, const Arguments& more);

// Standard streams and environment of a tool.
struct Surroundings {
  std::string input = "/dev/null"; // a file as standard input
  std::string output{};            // a file for standard output, instead of ToolResult::out
  std::string environment{};       // one more variable, NAME=value
  std::string error{};             // a file for standard error, instead of ToolResult::err
  std::vector<int> closed{};       // descriptors that the tool is started without
};

// `tool`: its name, or the path of another program.
ToolResult run(const std::string& tool, const Arguments& arguments, const Surroundings& surroundings = {});

// How long it takes; it must succeed.
std::chrono::duration<double> time_of(const std::string& tool, const Arguments& arguments);

// Starts the tool without waiting for it. Its output is discarded.
pid_t start(const std::string& tool, const Arguments& arguments);

// Whether its exit code is 0, and stderr says at most what was kept and traced, how full warps are, and that
// there is no usable GPU.
testing::AssertionResult succeeded(const ToolResult& result);

// Runs the tool, which must succeed so.
inline void expect_run(const std::string& tool, const Arguments& arguments,
                       const Surroundings& surroundings = {}) {
  EXPECT_TRUE(succeeded(run(tool, arguments, surroundings)));
}

// Whether its exit code is `code`, stdout is empty, and stderr is one line `tool: place: message` that
// contains `says`.
testing::AssertionResult failed(const ToolResult& result, int code, const std::string& tool,
                                const std::string& place, const std::string& says = "");

// A text of names and numbers, separated by commas.
template <class Number>
struct Csv {
  std::string names; // the first line
  std::vector<std::vector<Number>> rows{};
};
template <class Number>
Csv<Number> read_csv(const std::string& path) {
  std::istringstream lines(read_text(path));
  Csv<Number> csv;
  std::getline(lines, csv.names);
  for (std::string line, word; std::getline(lines, line);) {
    std::vector<Number>& row = csv.rows.emplace_back();
    for (std::istringstream words(line); std::getline(words, word, ',');)
      if (std::from_chars(word.data(), word.data() + word.size(), row.emplace_back()).ec != std::errc())
        ADD_FAILURE() << word << " isn't a number";
  }
  return csv;
}

// An array's header, and the bytes after it.
struct Npy {
  std::string head;
  Bytes values;
};
inline Npy read_npy(const std::string& path) {
  const Bytes bytes = read_bytes(path);
  const auto end = std::ranges::find(bytes, '\n') + 1;
  EXPECT_EQ((end - bytes.begin()) % 64, 0) << path;
  return {{bytes.begin(), end}, {end, bytes.end()}};
}

// What comes before an array's values, with such a dictionary.
inline std::string npy_head(const std::string& dictionary) {
  return std::string("\x93NUMPY\x01\0", 8) + static_cast<char>(dictionary.size()) + '\0' + dictionary;
}

// Of six numbers each, up to `most` from 0.
inline std::vector<float> random_rays(std::size_t count, float most) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> coordinate(-most, most);
  std::vector<float> rays(6 * count);
  std::ranges::generate(rays, [&] { return coordinate(random); });
  return rays;
}

// A test with a temporary folder for files. What fails says how to repeat it with the same random numbers.
class ToolTest : public SeededTest {
protected:
  std::string file(std::string_view name) const { return folder_.file(name); }

  // Each writes a file of that name and returns its path; the test fails where that fails.
  std::string nff(const std::string& name, std::string_view text) const;
  std::string spd(const std::string& name, const std::string& scene,
                  int size = 0) const; // 0: the standard size
  std::string scene(const std::string& name, const std::string& nff, const Arguments& more = {}) const;
  std::string grid(const std::string& name, const std::string& scene, const std::string& division = "auto",
                   const Arguments& more = {}) const;

  // What the tool prints with --json, and what a file holds; the test fails where the tool does.
  nlohmann::json json_of(const std::string& tool, const Arguments& arguments) const;
  nlohmann::json json_in(const std::string& name) const;

  // Runs the tool: whether it fails as failed() says, and leaves the folder's files as they are.
  testing::AssertionResult fails(int code, const std::string& tool, const Arguments& arguments,
                                 const std::string& place, const std::string& says = "",
                                 const Surroundings& surroundings = {}) const;

  // Runs a table of commands, which must fail with that exit code. A row is a command, and after ` > ` the
  // place that the error names (`command line` without) and what it says: `nff2bin ~/a -o ~/b > ~/a: No such
  // file`. [a|b] stands for a row with a and one with b, ~ for the test's folder, _ for a space, and at the
  // place @ for the last argument, @option for the last option.
  void expect_refused(int code, std::string_view commands, const Surroundings& surroundings = {}) const;
  // Runs such a table of commands that must succeed.
  void expect_runs(std::string_view commands) const;
  // A row's words.
  Arguments words(std::string_view row) const;

  const TemporaryFolder folder_;

private:
  std::string with_folder(std::string text) const;
};

// A light, a floor, a sphere, and a view.
inline constexpr std::string_view small_nff =
    "v\nfrom 3 -4 2\nat 0 0 0.5\nup 0 0 1\nangle 45\nhither 0.1\n"
    "resolution 16 12\nb 0.1 0.2 0.3\nl 5 -5 9\n"
    "f 1 0.5 0.25 0.7 0.3 10 0 1\np 4\n-2 -2 0\n2 -2 0\n2 2 0\n-2 2 0\n"
    "f 0.2 0.4 0.9 0.6 0.4 30 0 1\ns 0 0 0.5 0.5\n";
// The same with a sphere of another radius.
inline const std::string other_nff = [] {
  std::string other(small_nff.substr(0, small_nff.size() - 4));
  other += "0.25\n";
  return other;
}();

// With a scene of small_nff, and a grid for it.
class SmallSceneTest : public ToolTest {
protected:
  explicit SmallSceneTest(const std::string& division = "auto") : grid_(grid("a.grid", scene_, division)) {}

  Arguments on_cpu(const Arguments& more) const { return joined({scene_, grid_, "--backend", "cpu"}, more); }
  void render(const Arguments& more) const { expect_run("gridrender", on_cpu(more)); }
  void trace(const Arguments& more) const { expect_run("gridtrace", on_cpu(more)); }
  nlohmann::json stats_of(const Arguments& more) const; // of a picture

  const std::string text_ = nff("a.nff", small_nff), scene_ = scene("a.scene", text_), grid_;
};

} // namespace masu
