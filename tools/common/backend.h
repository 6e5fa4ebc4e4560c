// The options --backend, --precision and --first-cell-hit: where and how rays are traced.
#pragma once

#include "renderer/precision.h"
#include "renderer/tracer.h"
#include "tools/common/cli.h"

#include <map>
#include <string>

namespace masu {

enum class Backend { automatic, cpu, cuda };

void add_backend(const CommandLine& command, Backend& backend);

extern const std::map<std::string, Precision> all_precisions;
void add_precision(const CommandLine& command, Precision& precision);

void add_first_cell_hit(const CommandLine& command, StopRule& stop);

// Whether to trace by CUDA. Says so in a line where a program with CUDA finds no usable GPU. Throws
// Error(device) where `cuda` is given and there is none.
bool use_cuda(Backend backend, const char* tool, bool quiet = false);

// The GPU's name, or the CPU's and the number of threads.
std::string device_name(bool cuda);

} // namespace masu
