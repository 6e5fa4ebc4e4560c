// Shared by all tools: command lines, errors as one line on stderr, exit codes.
#pragma once

#include "libscene/base/error.h"
#include "libscene/scene.h"
#include "tools/common/help.h"
#include "tools/common/print.h"

#include <CLI/CLI.hpp>
#include <tbb/global_control.h>

#include <algorithm>
#include <functional>
#include <map>
#include <string>
#include <thread>
#include <type_traits>
#include <utility>
#include <vector>

namespace masu {

// Refuses outputs that are an input, or each other, by whatever name. To be called before anything is opened.
// Empty names are ignored; - is standard input or output (output_file.h). Throws Error(usage, output, …).
void check_files(const std::vector<std::string>& inputs, const std::vector<std::string>& outputs);

// Throws Error(input, path, …) for an NFF text or a mesh that is given for a scene file, by the name's end:
// with the command that makes a scene file of it. Says nothing of other files, nor of those that can't be
// read or begin as scene files do.
void check_scene_input(const std::string& path);

// The first thing that a main does; run_tool() calls it. Standard streams that the process was started
// without (by >&-, say) are opened, or files would take their descriptors: reading standard input or writing
// standard output then fails, and what is written to standard error is lost. And from now on a process whose
// memory doesn't suffice ends with one line and the exit code for that, wherever it is noticed.
void prepare_process();

// A tool's main: body(app, parse) adds options and an example, the footer, to the app, calls parse(), and
// runs the tool. Returns the exit code of libscene/base/error.h; 0 for --help.
using ToolBody = std::function<void(CLI::App& app, const std::function<void()>& parse)>;
// Of several processes of a tool, which one prints --help and --version, and which one its error.
struct Printing {
  std::function<bool()> help = [] { return true; }, error = [] { return true; };
};
int run_tool(const char* name, const char* description, int argc, char** argv, const ToolBody& body,
             const Printing& prints = {});

// An option whose values have names. The initial `value` is its default, and must be among them.
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
    text = std::to_string(static_cast<int>(found->second)); // CLI11 reads enumerations as numbers
    return std::string();
  };
  return app.add_option(option, value, help)
      ->transform(CLI::Validator(to_number, "", "choice"))
      ->type_name(all)
      ->default_str(chosen);
}

// A number from `least` to `most`, whose initial value is its default.
template <class Number>
CLI::Option* add_number(CLI::App& app, const std::string& option, Number& number,
                        std::type_identity_t<Number> least, std::type_identity_t<Number> most,
                        const std::string& help) {
  return app.add_option(option, number, help)->check(CLI::Range(least, most))->capture_default_str();
}

inline CLI::Option* add_file(CLI::App& app, const std::string& option, std::string& path,
                             const std::string& help) {
  return app.add_option(option, path, help)->type_name("FILE");
}

// -q, among the general options.
inline void add_quiet(CLI::App& app, bool& quiet, const std::string& help) {
  app.add_flag("-q,--quiet", quiet, help)->group("General");
}

// The camera with the pixels of --size WxH; unchanged where `size` is empty. Throws Error(usage).
Camera resized(Camera camera, const std::string& size);

// --threads N; 0: all cores.
class Threads {
public:
  void add_to(CLI::App& app) {
    add_number(app, "--threads", threads_, 0, 4096, "number of CPU threads; 0: all cores")->group("General");
  }
  // The limit is in force while the result lives.
  tbb::global_control limit(std::size_t cores = std::max(1U, std::thread::hardware_concurrency())) const {
    return {tbb::global_control::max_allowed_parallelism,
            threads_ > 0 ? static_cast<std::size_t>(threads_) : cores};
  }

private:
  int threads_ = 0;
};

} // namespace masu
