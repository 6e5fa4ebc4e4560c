#include "tools/bench/host_list.h"

#include "tests/stability/ray_sets.h"
#include "tools/bench/load/plain_copy.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstdlib>
#include <new>

namespace masu {
namespace {

constexpr std::size_t different_rays = std::size_t{1} << 22;
constexpr std::size_t rays_per_piece = std::size_t{1} << 19; // of the plain copy
constexpr std::size_t result_bytes = sizeof(float) + sizeof(std::uint32_t);

std::shared_ptr<void> room(std::size_t bytes, bool page_locked) {
  if (page_locked) return host_memory_cuda(bytes);
  void* const memory = std::malloc(bytes);
  if (memory == nullptr) throw std::bad_alloc();
  return {memory, [](void* m) { std::free(m); }};
}

} // namespace

HostList::HostList(const SceneFile& scene, std::size_t count, std::uint64_t seed, bool page_locked)
    : count_(count), page_locked_(page_locked), memory_(room(count * sizeof(Ray<float>), page_locked)),
      results_memory_(room(count * result_bytes, page_locked)) {
  const std::vector<Ray<double>> made = random_rays(scene, std::min(count, different_rays), seed);
  auto* const rays = static_cast<Ray<float>*>(memory_.get());
  tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
    rays[i] = loaded<float>(made.data(), own_format<double>, i % made.size());
  });
  results_.t = static_cast<float*>(results_memory_.get());
  results_.primitive = reinterpret_cast<std::uint32_t*>(results_.t + count);
}

double HostList::plain_copy_seconds(std::size_t first, std::size_t count, int gpu) const {
  const auto* const rays = static_cast<const Ray<float>*>(memory_.get());
  auto* const results = static_cast<std::uint8_t*>(results_memory_.get());
  const auto pieces = static_cast<int>(count / rays_per_piece + 1);
  return round_trip_seconds_cuda(rays + first, count * sizeof(Ray<float>), results + first * result_bytes,
                                 count * result_bytes, pieces, page_locked_, gpu);
}

} // namespace masu
