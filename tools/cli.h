// What every tool's main shares: one line on stderr and an exit code for whatever goes wrong.
#pragma once

#include "libscene/error.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <tbb/global_control.h>

#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <thread>

namespace masu {

// The CPU level this program was compiled for must be there.
inline void check_processor() {
#if defined(__x86_64__) && defined(__AVX2__)
  if (!__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("fma")) {
    throw Error(ErrorCode::device, "processor", "lacks AVX2 or FMA: build with -DMASU_CPU=x86-64 for it");
  }
#endif
}

// Parses the command line into `app` and calls body(). Returns the exit code of libscene/error.h; 0 for
// --help.
template <class Body>
int run_tool(CLI::App& app, int argc, char** argv, const Body& body) {
  const std::string& name = app.get_name();
  const auto report = [&](const std::string& line) { fmt::print(stderr, "{}: {}\n", name, line); };
  try {
    check_processor();
    app.parse(argc, argv);
    body();
    if (std::fflush(stdout) != 0) throw Error(ErrorCode::output, "standard output", "can't be written");
    return 0;
  } catch (const CLI::Success& success) { // --help, --version
    return app.exit(success);
  } catch (const CLI::ParseError& error) {
    report(fmt::format("command line: {}: see {} --help", error.what(), name));
    return static_cast<int>(ErrorCode::usage);
  } catch (const Error& error) {
    report(error.what());
    return static_cast<int>(error.code());
  } catch (const std::bad_alloc&) {
    report("memory: there isn't enough: choose a smaller scene or a coarser grid");
    return static_cast<int>(ErrorCode::input);
  } catch (const std::exception& error) {
    report(error.what());
    return static_cast<int>(ErrorCode::input);
  }
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
