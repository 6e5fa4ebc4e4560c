// --backend: which of the backends traces.
#pragma once

#include "renderer/backend.h"
#include "tools/cli.h"

namespace masu {

enum class Backend { automatic, cpu, cuda };

inline void add_backend(CLI::App& app, Backend& backend) {
  add_choice(app, "--backend", backend,
             {{"auto", Backend::automatic}, {"cpu", Backend::cpu}, {"cuda", Backend::cuda}},
             "auto (the GPU where there is one), cpu or cuda");
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
