// What every tool's main shares: one line on stderr and an exit code for whatever goes wrong.
#pragma once

#include "libscene/error.h"
#include "libscene/scene.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cstdio>
#include <functional>
#include <map>
#include <string>
#include <thread>
#include <type_traits>
#include <vector>

namespace masu {

// Brings what was printed to standard output. Throws Error(output) where any of it was lost.
void flush_standard_output();

// No tool writes over what it reads, nor twice to one file: to be called before anything is opened. Empty
// names are none; - is standard input or output. Throws Error(usage, output, …).
void check_files(const std::vector<std::string>& inputs, const std::vector<std::string>& outputs);

// A tool's main: body(app, parse) adds the options to the CLI::App, calls parse(), and does the work. Returns
// the exit code of libscene/error.h; 0 for --help.
using ToolBody = std::function<void(CLI::App& app, const std::function<void()>& parse)>;
int run_tool(const char* name, const char* description, int argc, char** argv, const ToolBody& body);

// An option with one of some names for its value, which must be among them before.
template <class Value>
CLI::Option* add_choice(CLI::App& app, const std::string& option, Value& value,
                        std::map<std::string, std::type_identity_t<Value>> names, const std::string& help) {
  std::string all, chosen;
  for (const auto& [name, named] : names) {
    all += (all.empty() ? "" : "|") + name;
    if (named == value) chosen = name;
  }
  const auto to_number = [names, all](std::string& text) {
    const auto found = names.find(text);
    if (found == names.end()) return fmt::format("'{}' isn't one of {}", text, all);
    text = std::to_string(static_cast<int>(found->second)); // how CLI11 reads an enumeration
    return std::string();
  };
  return app.add_option(option, value, help)
      ->transform(CLI::Validator(to_number, "", "choice"))
      ->type_name(all)
      ->default_str(chosen);
}

// --size WxH; none keeps the camera's own. Throws Error(usage).
Camera resized(Camera camera, const std::string& size);

// --threads N; 0 is every core.
class Threads {
public:
  void add_to(CLI::App& app) {
    app.add_option("--threads", threads_, "threads; 0: every core")
        ->check(CLI::Range(0, 4096))
        ->capture_default_str();
  }
  // Holds for as long as the result lives.
  tbb::global_control limit() const {
    const std::size_t cores = std::max(1U, std::thread::hardware_concurrency());
    return {tbb::global_control::max_allowed_parallelism,
            threads_ > 0 ? static_cast<std::size_t>(threads_) : cores};
  }

private:
  int threads_ = 0;
};

} // namespace masu
