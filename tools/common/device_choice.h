// The options --backend, --devices, --precision and --first-cell-hit: where and how rays are traced.
#pragma once

#include "renderer/tracer.h"
#include "tools/common/cli.h"
#include "tools/jobs/ranks.h"

#include <fstream>
#include <string>
#include <vector>

namespace masu {

enum class Backend { automatic, cpu, cuda };

inline void add_backend(CLI::App& app, Backend& backend) {
  add_choice(app, "--backend", backend,
             {{"auto", Backend::automatic}, {"cpu", Backend::cpu}, {"cuda", Backend::cuda}},
             "cpu, cuda, or auto: cuda where there is a usable GPU, else cpu");
}

inline const std::map<std::string, Precision> all_precisions{{"auto", Precision::automatic},
                                                             {"fast", Precision::fast},
                                                             {"robust", Precision::robust},
                                                             {"double", Precision::doubled}};

inline void add_precision(CLI::App& app, Precision& precision) {
  add_choice(
      app, "--precision", precision, all_precisions,
      "arithmetic of intersection and traversal: fast (float32, textbook formulas, for comparison), robust "
      "(float32, watertight triangles, error-bounded), double, or auto: robust, and double where the "
      "scene is stored in float64, or of pictures where float32's errors may exceed a sixteenth of a pixel "
      "at the nearest surface");
}

inline void add_first_cell_hit(CLI::App& app, StopRule& stop) {
  app.add_flag_callback(
      "--first-cell-hit", [&stop] { stop = StopRule::first_cell; },
      "terminate at the first cell in which anything is hit, even if the hit lies beyond it: the rule of the "
      "2012 thesis, which misses closer hits; for comparison");
}

// Whether to trace by CUDA. Says so in a line where a program with CUDA finds no usable GPU. Throws
// Error(device) where `cuda` is given and there is none.
inline bool use_cuda(Backend backend, const char* tool, bool quiet = false) {
  std::string why;
  const bool available = backend != Backend::cpu && cuda_available(why);
  if (backend == Backend::cuda && !available)
    throw Error(ErrorCode::device, "cuda", why + ": use --backend cpu");
  if (backend == Backend::automatic && !available && built_with_cuda() && !quiet)
    print_note("{}: no usable GPU ({}): tracing on the CPU\n", tool, why);
  return available;
}

// The GPU's name, or the CPU's and the number of threads.
inline std::string device_name(bool cuda) {
  if (cuda) return cuda_device_name();
  std::ifstream file("/proc/cpuinfo");
  std::string name = "a CPU";
  for (std::string line; std::getline(file, line);) {
    if (!line.starts_with("model name") || line.find(": ") == std::string::npos) continue;
    name = line.substr(line.find(": ") + 2);
    break;
  }
  const auto threads = tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
  return fmt::format("{} ({} {})", name, threads, threads == 1 ? "thread" : "threads");
}

// --backend and --devices, of gridrender and gridtrace.
struct DeviceChoice {
  Backend backend = Backend::automatic;
  std::string devices; // all, cpu, or numbers of GPUs

  void add_to(CLI::App& app);
  // The GPUs to trace on, or none for the CPU. Says so where a program with CUDA finds no usable GPU. Throws
  // Error(usage) for what isn't a list of GPUs and for options that contradict each other, Error(device) for
  // GPUs that are named and aren't there.
  //
  // Collective. Ranks of one machine share its GPUs out: by default all of them. Where they are chosen
  // automatically, all ranks trace on GPUs, or all on CPUs.
  std::vector<int> gpus(const char* tool, Ranks& ranks, bool quiet) const;

private:
  std::vector<int> gpus_of_machine(const char* tool, Ranks& ranks, bool quiet) const;
};

// The CPU's name and number of threads, or the first GPU's name and how many they are.
std::string devices_name(const std::vector<int>& gpus);

} // namespace masu
