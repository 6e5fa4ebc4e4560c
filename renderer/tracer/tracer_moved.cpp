// A tracer whose scene has moved: apart, for who doesn't move one does without the code that refits.
#include "libscene/base/on_threads.h"
#include "renderer/backend.h"
#include "renderer/tracer/tracer.h"

#include <algorithm>

namespace masu {

std::optional<ResidentTracer> ResidentTracer::moved(const Vertices& vertices) const {
  ResidentTracer tracer = *this;
  on_threads(files_.size(), [&](std::size_t i) {
    tracer.files_[i] = moved_files_cuda(*files_[i], scene_.origin(), vertices);
  });
  if (std::ranges::count(tracer.files_, nullptr) > 0) return std::nullopt;
  return tracer;
}

} // namespace masu
