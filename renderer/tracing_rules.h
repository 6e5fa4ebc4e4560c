// How rays are traced, and what that took.
#pragma once

#include "libgrid/trace/trace.h"
#include "renderer/precision.h"

namespace masu {

enum class Device { cpu, cuda };

inline constexpr int queries_per_gpu = 3; // to keep it busy: one computes, one comes back, one is prepared

// How rays are traced.
struct TracingRules {
  Precision precision = Precision::automatic;
  StopRule stop = StopRule::proven;
  bool count = false;              // fill in counts
  bool general = false;            // by the code for every kind of primitive, whatever the scene holds
  unsigned kinds = with_all_kinds; // that the scene holds: a tracer fills it in
};

// Seconds of wall-clock time; of kernels, on the device's own clock. The CPU traces files in the
// memory that they were read into and rays where the caller has them: nothing is uploaded or downloaded.
struct TraceSeconds {
  double upload = 0, trace = 0, download = 0;

  TraceSeconds& operator+=(const TraceSeconds& other) {
    upload += other.upload;
    trace += other.trace;
    download += other.download;
    return *this;
  }
};

// What a CUDA kernel takes per thread: registers, and bytes of local memory. 0 on the CPU.
struct KernelSize {
  std::int32_t registers = 0, local_bytes = 0;
};

} // namespace masu
