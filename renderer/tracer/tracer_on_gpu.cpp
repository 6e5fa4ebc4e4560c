// Tracers whose hierarchy GPUs have built, or fitted to a scene that has moved: apart, for who does neither
// does without the code.
#include "libgrid/structure/chosen_structure.h"
#include "libscene/base/on_threads.h"
#include "renderer/backend.h"
#include "renderer/tracer/tracer.h"

#include <algorithm>

namespace masu {

ResidentTracer ResidentTracer::by_fast_hierarchy(const SceneFile& scene, std::vector<int> gpus,
                                                 const std::function<void(double)>& progress) {
  ProgressMonitor monitor(progress);
  std::function<void()> meanwhile;
  if (gpus.size() > 1)
    meanwhile = [&] { monitor.check(); }; // by the caller's thread, which else does it itself
  ResidentTracer tracer(
      scene, nullptr, Device::cuda, std::move(gpus),
      [&](int gpu) { return built_files_cuda(scene, gpu, &monitor); }, meanwhile);
  tracer.is_hierarchy_ = true;
  return tracer;
}

StructureFile ResidentTracer::built_hierarchy() const {
  const Structure built = built_hierarchy_cuda(*files_.front());
  return structure_in_memory(
      built, provenance_of(scene_.geometry(), scene_.primitive_count(), fast_hierarchy_options(), built));
}

std::optional<ResidentTracer> ResidentTracer::moved(const Vertices& vertices) const {
  ResidentTracer tracer = *this;
  on_threads(files_.size(), [&](std::size_t i) {
    tracer.files_[i] = moved_files_cuda(*files_[i], scene_.origin(), vertices);
  });
  if (std::ranges::count(tracer.files_, nullptr) > 0) return std::nullopt;
  return tracer;
}

} // namespace masu
