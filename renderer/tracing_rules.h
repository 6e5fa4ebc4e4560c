// How rays are traced, by which arithmetic, and what that took.
#pragma once

#include "libgrid/trace/trace.h"
#include "libscene/base/error.h"
#include "libscene/file/scene_file.h"

#include <array>

namespace masu {

// fast: float32 by textbook formulas (libscene/geometry/textbook.h), to be measured against. robust: float32
// that loses no hit beyond the bound of libscene/geometry/margin.h. doubled: the same in float64. automatic:
// what the scene's store asks for, robust for float32 and doubled for float64; of pictures what the view
// asks for, too (view_precision.h).
enum class Precision { automatic, fast, robust, doubled };

// The one that `automatic` stands for by the store alone; others stay. Throws Error(usage) for float32
// arithmetic on a scene whose coordinates don't fit it: its results would be wrong without a word.
inline Precision resolved(Precision precision, const SceneFile& scene) {
  if (precision == Precision::automatic) return scene.is_float64() ? Precision::doubled : Precision::robust;
  if (scene.is_float64() && precision != Precision::doubled) {
    throw Error(ErrorCode::usage, "precision",
                scene.path() +
                    " holds float64 coordinates, which float32 arithmetic would round: take double, "
                    "or make the scene with nff2bin --store float32");
  }
  return precision;
}

inline const char* name_of(Precision precision) {
  constexpr std::array names{"auto", "fast", "robust", "double"};
  return names.at(static_cast<std::size_t>(precision));
}

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
