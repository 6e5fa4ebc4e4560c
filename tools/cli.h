// What every tool's main shares: one line on stderr and an exit code for whatever goes wrong.
#pragma once

#include "libscene/error.h"
#include "libscene/scene.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <exception>
#include <map>
#include <new>
#include <string>
#include <thread>
#include <type_traits>

namespace masu {

// The CPU level this program was compiled for must be there.
inline void check_processor() {
#if defined(__x86_64__) && defined(__AVX2__)
  if (!__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("fma")) {
    throw Error(ErrorCode::device, "processor", "lacks AVX2 or FMA: build with -DMASU_CPU=x86-64 for it");
  }
#endif
}

// A tool's main: body(app, parse) adds the options to the CLI::App, calls parse(), and does the work. Returns
// the exit code of libscene/error.h; 0 for --help.
template <class Body>
int run_tool(const char* name, const char* description, int argc, char** argv, const Body& body) {
  const auto report = [&](ErrorCode code, const char* line) {
    static_cast<void>(std::fprintf(stderr, "%s: %s\n", name, line));
    return static_cast<int>(code);
  };
  // A closed pipe and a file-size limit are write errors like any other.
  static_cast<void>(std::signal(SIGPIPE, SIG_IGN));
  static_cast<void>(std::signal(SIGXFSZ, SIG_IGN));
  try {
    check_processor();
    CLI::App app(description, name);
    try {
      body(app, [&] { app.parse(argc, argv); });
    } catch (const CLI::Success& success) { // --help
      app.exit(success);
    } catch (const CLI::ParseError& error) {
      return report(ErrorCode::usage,
                    (std::string("command line: ") + error.what() + ": see " + name + " --help").c_str());
    }
    if (std::fflush(stdout) != 0) throw Error(ErrorCode::output, "standard output", "can't be written");
    return 0;
  } catch (const Error& error) {
    return report(error.code(), error.what());
  } catch (const std::bad_alloc&) {
    return report(ErrorCode::input, "memory: there isn't enough: choose a smaller scene or a coarser grid");
  } catch (const std::exception& error) {
    return report(ErrorCode::input, error.what());
  } catch (...) {
    return report(ErrorCode::input, "an unknown error");
  }
}

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

// --size WxH; none keeps the camera's own.
inline Camera resized(Camera camera, const std::string& size) {
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
