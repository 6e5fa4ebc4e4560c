// The options --backend, --precision and --first-cell-hit: where and how rays are traced.
#pragma once

#include "renderer/tracer/tracer.h"
#include "tools/common/cli.h"

#include <map>
#include <string>

namespace masu {

enum class Backend { automatic, cpu, cuda };

void add_backend(const CommandLine& command, Backend& backend);

extern const std::map<std::string, Precision> all_precisions;
void add_precision(const CommandLine& command, Precision& precision);

void add_first_cell_hit(const CommandLine& command, StopRule& stop);

// Whether to trace by CUDA, on the first GPU or on any. Throws Error(device) where `cuda` is given and there
// is no usable GPU.
bool use_cuda(Backend backend, bool first_gpu_alone = true);
// Why a program with CUDA that chose for itself traces on the CPU, "no usable GPU: …"; else empty. To be
// printed with results: an error is a line alone.
std::string why_no_gpu(Backend backend);

// The GPU's name, or the CPU's and the number of threads.
std::string device_name(bool cuda);

} // namespace masu
