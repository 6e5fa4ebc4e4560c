// The options --backend and --devices of gridrender: where it traces.
#pragma once

#include "tools/backend_choice.h"

#include <string>
#include <vector>

namespace masu {

struct DeviceChoice {
  Backend backend = Backend::automatic;
  std::string devices; // all, cpu, or numbers of GPUs

  void add_to(CLI::App& app);
  // The GPUs to trace on, or none for the CPU. Says so where a program with CUDA finds no usable GPU. Throws
  // Error(usage) for what isn't a list of GPUs and for options that contradict each other, Error(device) for
  // GPUs that are named and aren't there.
  std::vector<int> gpus(const char* tool, bool quiet) const;
};

// The CPU's name and number of threads, or the first GPU's name and how many they are.
std::string devices_name(const std::vector<int>& gpus);

} // namespace masu
