#include "renderer/cuda/host_rays.h"

#include "libscene/base/parallel.h"
#include "renderer/cuda/ray_batch.h"

#include <algorithm>
#include <array>

namespace masu {
namespace {

// So few rays are read, and their results written, where they lie in page-locked memory: their few bytes take
// less time over the bus than copies take to be begun. But to lock memory takes as long as dozens of such
// queries: the first one is of copies from and to the caller's memory.
constexpr std::size_t rays_in_place = 4096;

bool is_page_locked(const void* host) {
  return host != nullptr && attributes_of(host).type == cudaMemoryTypeHost;
}

// An array of results in host memory: null where it isn't wanted.
struct ResultArray {
  void* host;
  std::size_t bytes_per_ray;
};
using ResultArrays = std::array<ResultArray, 15>;

// `row`: elements per ray of the arrays of hits.
ResultArrays arrays_of(const RayResults& results, std::size_t row) {
  ResultArrays arrays{};
  std::size_t k = 0;
  for_each_array(results, [&](auto* host) {
    arrays[k] = {host, (k < arrays_of_hits ? row : 1) * sizeof(*host)};
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

// Of a list, so many rays from `first` on.
struct Piece {
  std::size_t first = 0, count = 0;
};

// A list in host memory, its results, and what all of its pieces need on the device.
struct HostList {
  const DeviceFiles& files;
  const RayList& rays;
  const RaysRequest& request;
  ResultArrays arrays;
  DeviceArray<Counts> counts;
  DeviceArray<std::uint32_t> object_masks;
  std::size_t ray_bytes = rays.format.bytes_per_ray();

  bool is_short() const { return rays.count <= std::min(rays_in_place, rays_per_piece(request)); }
  const std::uint8_t* rays_of(const Piece& piece) const {
    return static_cast<const std::uint8_t*>(rays.rays) + piece.first * ray_bytes;
  }
  std::uint8_t* result_of(const Piece& piece, std::size_t array) const {
    return static_cast<std::uint8_t*>(arrays[array].host) + piece.first * arrays[array].bytes_per_ray;
  }
  std::size_t bytes_of_results(const Piece& piece) const {
    return for_each_array(arrays, piece.count, [](auto...) {});
  }

  // Queues the piece's query: its rays, and a block for its results, where the device sees them.
  KernelSize launch(const Piece& piece, const void* from, std::uint8_t* found, cudaStream_t stream) const {
    const auto one_per_ray = [&](const std::uint32_t* numbers) {
      const bool there = numbers != nullptr;
      return DeviceArray<std::uint32_t>(there ? numbers + piece.first : nullptr, there ? piece.count : 0,
                                        {stream, files.memory->pool});
    };
    const DeviceArray<std::uint32_t> excluded = one_per_ray(rays.filters.excluded),
                                     ray_masks = one_per_ray(rays.filters.ray_masks),
                                     excluded_objects = one_per_ray(rays.filters.excluded_objects),
                                     worlds = one_per_ray(rays.filters.worlds);
    RayList list(from, piece.count, rays.format);
    list.filters = {excluded.data(),     ray_masks.data(),        object_masks.data(),
                    object_masks.size(), excluded_objects.data(), worlds.data()};
    return launcher_of(files, request)(files, list, results_in(found, arrays, piece.count), request,
                                       counts.data(), stream, nullptr);
  }
};

void trace_in_place(const HostList& list, HostRayBuffers::Piece& buffers, QueryReport& report) {
  const Piece all{0, list.rays.count};
  const std::size_t bytes = all.count * list.ray_bytes, results_at = (bytes + 15) / 16 * 16;
  std::uint8_t* const rays = buffers.rays.of(results_at + list.bytes_of_results(all));
  std::uint8_t* const found = rays + results_at;
  copy_in_parallel(rays, list.rays_of(all), bytes);
  check(cudaEventRecord(buffers.begun, buffers.stream));
  report.kernel = list.launch(all, rays, found, buffers.stream);
  check(cudaEventRecord(buffers.downloaded, buffers.stream));
  check(cudaEventSynchronize(buffers.downloaded));
  report.seconds.trace = seconds_between(buffers.begun, buffers.downloaded);
  for_each_array(list.arrays, all.count, [&](std::size_t k, std::size_t offset, std::size_t array_bytes) {
    copy_in_parallel(list.result_of(all, k), found + offset, array_bytes);
  });
}

// Turn by turn: what a slot's last piece found leaves its buffers while the next one's rays enter them.
void trace_in_pieces(const HostList& list, HostRayBuffers& borrowed, QueryReport& report,
                     std::atomic<std::size_t>& next_piece) {
  const RayList& rays = list.rays;
  const MemoryPool& pool = list.files.memory->pool;
  const std::size_t piece_rays = rays_per_piece(list.request);
  // What is copied from where it lies, and to where it belongs.
  const auto is_direct = [&](const void* host) { return list.is_short() || is_page_locked(host); };
  const bool rays_direct = is_direct(rays.rays);
  std::array<bool, std::tuple_size_v<ResultArrays>> direct{};
  for (std::size_t k = 0; k < direct.size(); ++k)
    direct[k] = is_direct(list.arrays[k].host);
  Piece pieces[pieces_in_flight];

  const auto copy_in = [&](HostRayBuffers::Piece& buffers, const Piece& piece) {
    const std::size_t bytes = piece.count * list.ray_bytes;
    if (!rays_direct && bytes > 0) copy_in_parallel(buffers.rays.of(bytes), list.rays_of(piece), bytes);
  };
  const auto begin = [&](HostRayBuffers::Piece& buffers, const Piece& piece) {
    const cudaStream_t stream = buffers.stream;
    const std::size_t bytes = piece.count * list.ray_bytes, result_bytes = list.bytes_of_results(piece);
    const void* const from = rays_direct ? list.rays_of(piece) : buffers.rays.of(bytes);
    const DeviceArray<std::uint8_t> device_rays(bytes, {stream, pool}), found(result_bytes, {stream, pool});
    check(cudaEventRecord(buffers.begun, stream));
    check(cudaMemcpyAsync(device_rays.data(), from, bytes, cudaMemcpyHostToDevice, stream));
    check(cudaEventRecord(buffers.uploaded, stream));
    report.kernel = list.launch(piece, device_rays.data(), found.data(), stream);
    check(cudaEventRecord(buffers.traced, stream));
    for_each_array(list.arrays, piece.count, [&](std::size_t k, std::size_t offset, std::size_t array_bytes) {
      void* const to = direct[k] ? list.result_of(piece, k) : buffers.results.of(result_bytes) + offset;
      check(cudaMemcpyAsync(to, found.data() + offset, array_bytes, cudaMemcpyDeviceToHost, stream));
    });
    check(cudaEventRecord(buffers.downloaded, stream));
  };
  const auto wait = [&](const HostRayBuffers::Piece& buffers, const Piece& piece) {
    if (piece.count == 0) return;
    check(cudaEventSynchronize(buffers.downloaded));
    report.seconds.upload += seconds_between(buffers.begun, buffers.uploaded);
    report.seconds.trace += seconds_between(buffers.uploaded, buffers.traced);
    report.seconds.download += seconds_between(buffers.traced, buffers.downloaded);
  };
  const auto copy_out = [&](HostRayBuffers::Piece& buffers, const Piece& piece) {
    for_each_array(list.arrays, piece.count, [&](std::size_t k, std::size_t offset, std::size_t array_bytes) {
      if (!direct[k]) copy_in_parallel(list.result_of(piece, k), buffers.results.of(0) + offset, array_bytes);
    });
  };

  // The last turns have no piece to begin.
  for (std::size_t turn = 0, last_turns = 0; last_turns < pieces_in_flight; ++turn) {
    HostRayBuffers::Piece& buffers = borrowed.piece(turn);
    Piece& piece = pieces[turn % pieces_in_flight];
    const Piece last = piece;
    if (list.request.progress) list.request.progress(share_of_pieces(next_piece, rays, list.request));
    const std::size_t first = std::min(next_piece.fetch_add(1) * piece_rays, rays.count);
    piece = {first, std::min(piece_rays, rays.count - first)};
    last_turns += piece.count == 0 ? 1 : 0;
    wait(buffers, last);
    parallel_invoke([&] { copy_out(buffers, last); }, [&] { copy_in(buffers, piece); });
    if (piece.count > 0) begin(buffers, piece);
  }
}

} // namespace

QueryReport trace_rays_cuda(const DeviceFiles& files, const RayList& rays, const RayResults& results,
                            const RaysRequest& request, std::atomic<std::size_t>& next_piece) {
  QueryReport report;
  if (rays.count == 0) return report;
  const DeviceScope device(files.memory->device);
  const StreamMemory memory{nullptr, files.memory->pool};
  DeviceArray<Counts> counts(&report.counts, files.are_counted(request.tracing) ? 1 : 0, memory);
  DeviceArray<std::uint32_t> masks(rays.filters.object_masks, rays.filters.object_count, memory);
  if (counts.size() + masks.size() > 0) check(cudaStreamSynchronize(nullptr));
  const ResultArrays arrays = arrays_of(results, hit_rules(request).row());
  const HostList list{files, rays, request, arrays, std::move(counts), std::move(masks)};
  const auto borrowed = files.memory->buffers.borrow();
  struct Drain { // after an error something may still be copied to them
    HostRayBuffers& buffers;
    ~Drain() {
      for (const auto& piece : buffers.pieces)
        if (piece) static_cast<void>(cudaStreamSynchronize(piece->stream));
    }
  } const drain{*borrowed};
  if (list.is_short() && borrowed->is_used) {
    if (request.progress) request.progress(0);
    trace_in_place(list, borrowed->piece(0), report);
  } else {
    trace_in_pieces(list, *borrowed, report, next_piece);
  }
  borrowed->is_used = true;
  list.counts.download(&report.counts);
  return report;
}

} // namespace masu
