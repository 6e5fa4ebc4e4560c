// A long list of random rays in host memory with room for t and primitive, and plain copies of its bytes.
#pragma once

#include "renderer/tracer/tracer.h"

#include <memory>

namespace masu {

class HostList {
public:
  // Rays of random_rays(), repeated after 2^22. page_locked: for a CUDA device. Throws Error(device),
  // std::bad_alloc.
  HostList(const SceneFile& scene, std::size_t count, std::uint64_t seed, bool page_locked);

  std::size_t size() const { return count_; }
  // The first ones.
  RayList rays(std::size_t count) const { return relative({memory_.get(), count, own_format<float>}); }
  const RayResults& results() const { return results_; }

  // Seconds in which the bytes of rays and results are copied to a GPU and back, of the rays from first on.
  double plain_copy_seconds(std::size_t first, std::size_t count, int gpu) const;

private:
  std::size_t count_;
  bool page_locked_;
  std::shared_ptr<void> memory_, results_memory_;
  RayResults results_;
};

} // namespace masu
