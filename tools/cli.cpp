// Compiled once for all tools, since compiling CLI11 takes longer than most of them.
#include "tools/cli.h"

#include "libscene/file/same_file.h"
#include "libscene/file/temporary_name.h"
#include "libscene/processor.h"
#include "tools/printable.h"
#include "tools/version.h"

#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <exception>
#include <new>

namespace masu {
void flush_standard_output() {
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
    throw Error(ErrorCode::output, "standard output", "can't be written");
}

void check_files(const std::vector<std::string>& inputs, const std::vector<std::string>& outputs) {
  std::vector<std::string> written{"/dev/stdout"}; // results and reports
  if (std::ranges::count(outputs, "-") > 1)
    throw Error(ErrorCode::usage, "-", "would be written twice: name a file for one of them");
  for (const std::string& output : outputs) {
    if (output.empty() || output == "-") continue;
    for (const std::string& other : written) {
      if (is_same_file(output, other))
        throw Error(ErrorCode::usage, output, "would be written twice: give each output a name of its own");
    }
    written.push_back(output);
  }
  for (const std::string& input : inputs) {
    for (const std::string& output : written) {
      if (!input.empty() && is_same_file(input == "-" ? "/dev/stdin" : input, output))
        throw Error(ErrorCode::usage, output,
                    fmt::format("is the input {} itself: give the output another name", input));
    }
  }
}

namespace {

constexpr const char* no_memory = "memory: there isn't enough: choose a smaller scene or a coarser grid";

// Destructors of libraries (nlohmann's JSON, TBB) allocate memory, and end the process where there is none.
void end_without_memory() {
  try {
    // There is none where not even that for an exception could be had.
    if (const auto error = std::current_exception()) std::rethrow_exception(error);
  } catch (const std::bad_alloc&) {
  } catch (...) {
    std::abort();
  }
  static_cast<void>(std::fprintf(stderr, "%s: %s\n", program_invocation_short_name, no_memory));
  remove_temporary_names();
  _exit(static_cast<int>(ErrorCode::input));
}

} // namespace

void catch_no_memory() {
  std::set_terminate(end_without_memory);
}

int run_tool(const char* name, const char* description, int argc, char** argv, const ToolBody& body,
             const Printing& prints) {
  // Where no memory is left for the line, it says that.
  const auto report = [&](ErrorCode code, const char* line) {
    std::string text;
    if (line != nullptr) {
      try {
        text = printable(line);
      } catch (const std::bad_alloc&) {
      }
    }
    if (prints.error())
      static_cast<void>(std::fprintf(stderr, "%s: %s\n", name, text.empty() ? no_memory : text.c_str()));
    return static_cast<int>(code);
  };
  // A closed pipe and a file-size limit are write errors like any other.
  static_cast<void>(std::signal(SIGPIPE, SIG_IGN));
  static_cast<void>(std::signal(SIGXFSZ, SIG_IGN));
  remove_temporary_names_on_signals();
  catch_no_memory();
  try {
    check_processor();
    CLI::App app(description, name);
    app.set_version_flag("--version", fmt::format("{}, {}", name, program_name()));
    try {
      body(app, [&] { app.parse(argc, argv); });
    } catch (const CLI::Success& success) { // --help, --version
      if (prints.help()) app.exit(success);
    } catch (const CLI::ParseError& error) {
      std::string command = name; // with the subcommand whose help lists the options
      for (const CLI::App* const subcommand : app.get_subcommands())
        command += " " + subcommand->get_name();
      return report(ErrorCode::usage,
                    fmt::format("command line: {}: see {} --help", error.what(), command).c_str());
    }
    flush_standard_output();
    return 0;
  } catch (const Error& error) {
    return report(error.code(), error.what());
  } catch (const std::bad_alloc&) {
    return report(ErrorCode::input, nullptr);
  } catch (const std::exception& error) {
    if (std::ferror(stdout) != 0) return report(ErrorCode::output, "standard output: can't be written");
    return report(ErrorCode::input, error.what());
  } catch (...) {
    return report(ErrorCode::input, "an unknown error");
  }
}

Camera resized(Camera camera, const std::string& size) {
  if (size.empty()) return camera;
  int width = 0, height = 0, end = 0;
  if (std::sscanf(size.c_str(), "%dx%d%n", &width, &height, &end) != 2 ||
      static_cast<std::size_t>(end) != size.size() || width < 1 || height < 1 || width > 65536 ||
      height > 65536) {
    throw Error(ErrorCode::usage, "--size", fmt::format("'{}' isn't WxH with 1 to 65536 pixels each", size));
  }
  camera.width = width;
  camera.height = height;
  return camera;
}

} // namespace masu
