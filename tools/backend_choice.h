// --backend, --precision and --first-cell-hit: who traces, and how.
#pragma once

#include "renderer/tracer.h"
#include "tools/cli.h"

namespace masu {

enum class Backend { automatic, cpu, cuda };

inline void add_backend(CLI::App& app, Backend& backend) {
  add_choice(app, "--backend", backend,
             {{"auto", Backend::automatic}, {"cpu", Backend::cpu}, {"cuda", Backend::cuda}},
             "auto (the GPU where there is one), cpu or cuda");
}

inline const std::map<std::string, Precision> all_precisions{{"auto", Precision::automatic},
                                                             {"fast", Precision::fast},
                                                             {"robust", Precision::robust},
                                                             {"double", Precision::doubled}};

inline void add_precision(CLI::App& app, Precision& precision) {
  add_choice(app, "--precision", precision, all_precisions,
             "auto (robust; double where the scene is stored so), fast (float32 by textbook formulas, for "
             "comparison), robust (float32 that loses no hit) or double");
}

inline void add_first_cell_hit(CLI::App& app, StopRule& stop) {
  app.add_flag_callback(
      "--first-cell-hit", [&stop] { stop = StopRule::first_cell; },
      "end with the first hit of the first cell that has any, wherever it lies: a shortcut of 2012, for "
      "comparison");
}

// `auto` takes the GPU where there is one. Throws Error(device) where one was asked for in vain.
inline bool use_cuda(Backend backend) {
  std::string why;
  const bool available = backend != Backend::cpu && cuda_available(why);
  if (backend == Backend::cuda && !available)
    throw Error(ErrorCode::device, "cuda", why + ": use --backend cpu");
  return available;
}

} // namespace masu
