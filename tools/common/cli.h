// Shared by all tools: command lines, errors as one line on stderr, exit codes.
#pragma once

#include "libscene/base/error.h"
#include "libscene/scene.h"
#include "tools/common/command_line.h"
#include "tools/common/print.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace masu {

// Refuses outputs that are an input, or each other, by whatever name. To be called before anything is opened.
// Empty names are ignored; - is standard input or output (output_file.h). Throws Error(usage, output, …).
void check_files(const std::vector<std::string>& inputs, const std::vector<std::string>& outputs);

// Of a regular file that can be read: whether it begins as scene files do. Pipes, which are read once, don't.
bool is_scene_file(const std::string& path);

// Throws Error(input, path, …) for an NFF text or a mesh that is given for a scene file, by the name's end:
// with the command that makes a scene file of it. Says nothing of other files, nor of those that can't be
// read or begin as scene files do.
void check_scene_input(const std::string& path);

// The first thing that a main does; run_tool() calls it. Standard streams that the process was started
// without (by >&-, say) are opened, or files would take their descriptors: reading standard input or writing
// standard output then fails, and what is written to standard error is lost. And from now on a process whose
// memory doesn't suffice ends with one line and the exit code for that, wherever it is noticed.
void prepare_process();

// Of several processes of a tool, which one prints --help and --version, and which one its error.
struct Printing {
  std::function<bool()> help = [] { return true; }, error = [] { return true; };
};
// A tool's main. Returns the exit code of libscene/base/error.h; 0 for --help.
int run_tool(const char* name, const char* description, int argc, char** argv, const ToolBody& body,
             const Printing& prints = {});
// The same by add_options(command, settings), and then run(settings), or run(settings, command).
template <class Settings, class Run>
int run_tool(const char* name, const char* description, int argc, char** argv,
             void (*add_options)(const CommandLine&, Settings&), const Run& run) {
  return run_tool(name, description, argc, argv, [&](const CommandLine& command, const auto& parse) {
    Settings settings;
    add_options(command, settings);
    parse();
    if constexpr (std::is_invocable_v<Run, Settings&, const CommandLine&>)
      run(settings, command);
    else
      run(settings);
  });
}

// The camera with the pixels of --size WxH; unchanged where `size` is empty. Throws Error(usage).
Camera resized(Camera camera, const std::string& size);

// No more threads than these compute while the limit lives.
using ThreadLimit = std::shared_ptr<const void>;
ThreadLimit limit_threads(std::size_t threads);
std::size_t allowed_threads(); // that the limits allow; without one, the cores that this process may use
std::size_t all_cores();

// Lets CUDA see its first GPU alone, before its first call, unless the environment says what it sees: to
// start takes it 0.2 s longer for each GPU more.
void see_first_gpu_alone();

// --threads N; 0: all cores.
struct Threads {
  int count = 0;

  void add_to(const CommandLine& command) {
    command.add_number("--threads", count, 0, 4096, "number of CPU threads; 0: all cores").under("General");
  }
  // Of `cores` where the option isn't given.
  ThreadLimit limit(std::size_t cores = all_cores()) const {
    return limit_threads(count > 0 ? static_cast<std::size_t>(count) : cores);
  }
};

} // namespace masu
