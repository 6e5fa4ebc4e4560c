// The options --backend, --precision and --first-cell-hit.
#pragma once

#include "renderer/tracer.h"
#include "tools/cli.h"

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
      "scene is stored in float64");
}

inline void add_first_cell_hit(CLI::App& app, StopRule& stop) {
  app.add_flag_callback(
      "--first-cell-hit", [&stop] { stop = StopRule::first_cell; },
      "terminate at the first cell in which anything is hit, even if the hit lies beyond it: the rule of the "
      "2012 thesis, which misses closer hits; for comparison");
}

// Whether to trace by CUDA. Throws Error(device) where `cuda` is given and there is no usable GPU.
inline bool use_cuda(Backend backend) {
  std::string why;
  const bool available = backend != Backend::cpu && cuda_available(why);
  if (backend == Backend::cuda && !available)
    throw Error(ErrorCode::device, "cuda", why + ": use --backend cpu");
  return available;
}

} // namespace masu
