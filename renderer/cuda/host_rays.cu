#include "renderer/cuda/host_rays.h"

#include "renderer/cuda/ray_batch.h"

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <array>

namespace masu {
namespace {

// So few rays are read, and their results written, where they lie in page-locked memory: their few bytes take
// less time over the bus than copies take to be begun.
constexpr std::size_t rays_in_place = 4096;

bool is_page_locked(const void* host) {
  return host != nullptr && attributes_of(host).type == cudaMemoryTypeHost;
}

// An array of results in host memory: null where it isn't wanted.
struct ResultArray {
  void* host;
  std::size_t bytes_per_ray;
  bool page_locked;
};
using ResultArrays = std::array<ResultArray, 15>;

// `row`: elements per ray of the arrays of hits. In place, they are copied from the buffers.
ResultArrays arrays_of(const RayResults& results, std::size_t row, bool in_place) {
  ResultArrays arrays{};
  std::size_t k = 0;
  for_each_array(results, [&](auto* host) {
    arrays[k] = {host, (k < arrays_of_hits ? row : 1) * sizeof(*host), !in_place && is_page_locked(host)};
    ++k;
  });
  return arrays;
}

// One array after another in a block of memory, for so many rays; 16-byte boundaries.
template <class Act>
std::size_t for_each_array(const ResultArrays& arrays, std::size_t rays, const Act& act) {
  std::size_t offset = 0;
  for (std::size_t k = 0; k < arrays.size(); ++k) {
    if (arrays[k].host == nullptr) continue;
    act(k, offset, rays * arrays[k].bytes_per_ray);
    offset += (rays * arrays[k].bytes_per_ray + 15) / 16 * 16;
  }
  return offset;
}

RayResults results_in(std::uint8_t* block, const ResultArrays& arrays, std::size_t rays) {
  std::array<std::uint8_t*, std::tuple_size_v<ResultArrays>> at{};
  for_each_array(arrays, rays,
                 [&](std::size_t k, std::size_t offset, std::size_t) { at[k] = block + offset; });
  RayResults results;
  std::size_t k = 0;
  for_each_array(results, [&]<class T>(T*& array) { array = reinterpret_cast<T*>(at[k++]); });
  return results;
}

double seconds_between(cudaEvent_t first, cudaEvent_t second) {
  float milliseconds = 0;
  check(cudaEventElapsedTime(&milliseconds, first, second));
  return static_cast<double>(milliseconds) * 1e-3;
}

} // namespace

QueryReport trace_rays_cuda(const DeviceFiles& files, const RayList& rays, const RayResults& results,
                            const RaysRequest& request, std::atomic<std::size_t>& next_piece) {
  QueryReport report;
  if (rays.count == 0) return report;
  const DeviceScope device(files.memory->device);
  const std::size_t piece_rays = rays_per_piece(request);
  const bool in_place = rays.count <= std::min(rays_in_place, piece_rays);
  const ResultArrays arrays = arrays_of(results, hit_rules(request).row(), in_place);
  const bool rays_page_locked = !in_place && is_page_locked(rays.rays);
  const std::size_t ray_bytes = rays.format.bytes_per_ray();
  const DeviceArray<Counts> counts(&report.counts, files.are_counted(request.tracing) ? 1 : 0,
                                   {nullptr, files.memory->pool});
  const DeviceArray<std::uint32_t> object_masks(rays.filters.object_masks, rays.filters.object_count,
                                                {nullptr, files.memory->pool});
  if (counts.size() + object_masks.size() > 0) check(cudaStreamSynchronize(nullptr));
  const auto borrowed = files.memory->buffers.borrow();
  struct Drain { // after an error something may still be copied to them
    HostRayBuffers& buffers;
    ~Drain() {
      for (const auto& piece : buffers.pieces)
        static_cast<void>(cudaStreamSynchronize(piece.stream));
    }
  } const drain{*borrowed};
  struct Work {
    std::size_t first = 0, count = 0;
  } works[pieces_in_flight];

  const auto rays_of = [&](const Work& work) {
    return static_cast<const std::uint8_t*>(rays.rays) + work.first * ray_bytes;
  };
  const auto copy_in = [&](HostRayBuffers::Piece& piece, const Work& work) {
    const std::size_t bytes = work.count * ray_bytes;
    if (!rays_page_locked && bytes > 0) copy_in_parallel(piece.rays.of(bytes), rays_of(work), bytes);
  };
  const auto begin = [&](HostRayBuffers::Piece& piece, const Work& work) {
    const cudaStream_t stream = piece.stream;
    const std::size_t bytes = work.count * ray_bytes;
    const void* const from = rays_page_locked ? rays_of(work) : piece.rays.of(bytes);
    const std::size_t result_bytes = for_each_array(arrays, work.count, [](auto...) {});
    std::uint8_t* const staging = piece.results.of(result_bytes);
    const DeviceArray<std::uint8_t> device_rays(in_place ? 0 : bytes, {stream, files.memory->pool}),
        device_results(in_place ? 0 : result_bytes, {stream, files.memory->pool});
    std::uint8_t* const found = in_place ? staging : device_results.data();
    const auto one_per_ray = [&](const std::uint32_t* numbers) {
      const bool there = numbers != nullptr;
      return DeviceArray<std::uint32_t>(there ? numbers + work.first : nullptr, there ? work.count : 0,
                                        {stream, files.memory->pool});
    };
    const DeviceArray<std::uint32_t> excluded = one_per_ray(rays.filters.excluded),
                                     ray_masks = one_per_ray(rays.filters.ray_masks),
                                     excluded_objects = one_per_ray(rays.placed_filters.excluded_objects),
                                     worlds = one_per_ray(rays.placed_filters.worlds);
    RayList list(in_place ? from : device_rays.data(), work.count, rays.format);
    list.filters = {excluded.data(), ray_masks.data(), object_masks.data(), object_masks.size()};
    list.placed_filters = {excluded_objects.data(), worlds.data()};
    check(cudaEventRecord(piece.begun, stream));
    if (!in_place) check(cudaMemcpyAsync(device_rays.data(), from, bytes, cudaMemcpyHostToDevice, stream));
    if (!in_place) check(cudaEventRecord(piece.uploaded, stream));
    report.kernel =
        launch_rays(files, list, results_in(found, arrays, work.count), request, counts.data(), stream);
    if (!in_place) check(cudaEventRecord(piece.traced, stream));
    const auto bring = [&](std::size_t k, std::size_t offset, std::size_t array_bytes) {
      const ResultArray& array = arrays[k];
      void* const to = array.page_locked
                           ? static_cast<std::uint8_t*>(array.host) + work.first * array.bytes_per_ray
                           : staging + offset;
      check(cudaMemcpyAsync(to, found + offset, array_bytes, cudaMemcpyDeviceToHost, stream));
    };
    if (!in_place) for_each_array(arrays, work.count, bring);
    check(cudaEventRecord(piece.downloaded, stream));
  };
  const auto wait = [&](const HostRayBuffers::Piece& piece, const Work& work) {
    if (work.count == 0) return;
    check(cudaEventSynchronize(piece.downloaded));
    if (in_place) {
      report.seconds.trace = seconds_between(piece.begun, piece.downloaded);
      return;
    }
    report.seconds.upload += seconds_between(piece.begun, piece.uploaded);
    report.seconds.trace += seconds_between(piece.uploaded, piece.traced);
    report.seconds.download += seconds_between(piece.traced, piece.downloaded);
  };
  const auto copy_out = [&](HostRayBuffers::Piece& piece, const Work& work) {
    for_each_array(arrays, work.count, [&](std::size_t k, std::size_t offset, std::size_t array_bytes) {
      const ResultArray& array = arrays[k];
      if (!array.page_locked)
        copy_in_parallel(static_cast<std::uint8_t*>(array.host) + work.first * array.bytes_per_ray,
                         piece.results.of(0) + offset, array_bytes);
    });
  };

  if (in_place) {
    HostRayBuffers::Piece& piece = borrowed->pieces[0];
    const Work all{0, rays.count};
    if (request.progress) request.progress(0);
    copy_in(piece, all);
    begin(piece, all);
    wait(piece, all);
    copy_out(piece, all);
    counts.download(&report.counts);
    return report;
  }
  // Turn by turn: what a slot's last piece found leaves its buffers while the next one's rays enter them. The
  // last turns have none.
  for (std::size_t turn = 0, last_turns = 0; last_turns < pieces_in_flight; ++turn) {
    HostRayBuffers::Piece& piece = borrowed->pieces[turn % pieces_in_flight];
    Work& work = works[turn % pieces_in_flight];
    const Work last = work;
    if (request.progress) request.progress(share_of_pieces(next_piece, rays, request));
    const std::size_t first = std::min(next_piece.fetch_add(1) * piece_rays, rays.count);
    work = {first, std::min(piece_rays, rays.count - first)};
    last_turns += work.count == 0 ? 1 : 0;
    wait(piece, last);
    tbb::parallel_invoke([&] { copy_out(piece, last); }, [&] { copy_in(piece, work); });
    if (work.count > 0) begin(piece, work);
  }
  counts.download(&report.counts);
  return report;
}

} // namespace masu
