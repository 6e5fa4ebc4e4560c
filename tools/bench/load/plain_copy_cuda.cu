#include "libscene/base/stopwatch.h"
#include "libscene/cuda/device_memory.h"
#include "libscene/cuda/transfer.h"
#include "libscene/file/file_mapping.h"
#include "renderer/cuda/host_rays.h"
#include "tools/bench/load/plain_copy.h"

#include <algorithm>
#include <cstdlib>
#include <new>

namespace masu {
namespace {

// Fits in the processor's cache, from which the bytes are copied to the device.
constexpr std::size_t buffer_bytes = std::size_t{4} << 20;

double copy_read(const std::string& path) {
  const PinnedBuffer buffer(buffer_bytes);
  const Stopwatch watch;
  const InputFile file(path);
  const DeviceArray<std::uint8_t> copy(file.size());
  for (std::size_t at = 0; at < copy.size(); at += buffer_bytes) {
    const auto piece = buffer.bytes().first(std::min(buffer_bytes, copy.size() - at));
    file.read(at, piece);
    check(cudaMemcpy(copy.data() + at, piece.data(), piece.size(), cudaMemcpyHostToDevice));
  }
  check(cudaDeviceSynchronize());
  return watch.seconds();
}

double copy_mapped(const std::string& path) {
  const Stopwatch watch;
  const InputFile file(path);
  const FileMapping mapping(file);
  const DeviceArray<std::uint8_t> copy(mapping.bytes().data(), mapping.bytes().size());
  check(cudaDeviceSynchronize());
  return watch.seconds();
}

} // namespace

double copy_seconds_cuda(const std::string& path, CopyFrom from) {
  check(cudaFree(nullptr)); // initialises the device outside the measured time
  return from == CopyFrom::mapping ? copy_mapped(path) : copy_read(path);
}

std::shared_ptr<void> host_memory_cuda(std::size_t bytes) {
  void* memory = nullptr;
  check(cudaMallocHost(&memory, bytes));
  return {memory, [](void* m) { static_cast<void>(cudaFreeHost(m)); }};
}

double round_trip_seconds_cuda(const void* up, std::size_t up_bytes, void* down, std::size_t down_bytes,
                               int pieces, bool page_locked, int gpu) {
  const DeviceScope scope(gpu);
  constexpr std::size_t in_flight = 3;
  const auto all = static_cast<std::size_t>(pieces);
  const std::size_t up_piece = (up_bytes + all - 1) / all, down_piece = (down_bytes + all - 1) / all;
  struct Flight {
    Stream stream;
    PinnedRoom up, down;
    DeviceArray<std::uint8_t> device_up, device_down;
    std::size_t down_begin = 0, down_size = 0;
  } flights[in_flight];
  for (Flight& flight : flights) {
    flight.device_up = DeviceArray<std::uint8_t>(up_piece);
    flight.device_down = DeviceArray<std::uint8_t>(down_piece);
    if (page_locked) continue;
    flight.up.of(up_piece);
    flight.down.of(down_piece);
  }
  check(cudaDeviceSynchronize());
  auto* const to = static_cast<std::uint8_t*>(down);
  const auto* const from = static_cast<const std::uint8_t*>(up);
  const auto finish = [&](Flight& flight) {
    check(cudaStreamSynchronize(flight.stream));
    if (!page_locked) copy_in_parallel(to + flight.down_begin, flight.down.of(0), flight.down_size);
    flight.down_size = 0;
  };
  const Stopwatch watch;
  for (std::size_t i = 0; i < all; ++i) {
    Flight& flight = flights[i % in_flight];
    finish(flight);
    const std::size_t up_begin = std::min(i * up_piece, up_bytes),
                      up_size = std::min(up_piece, up_bytes - up_begin);
    flight.down_begin = std::min(i * down_piece, down_bytes);
    flight.down_size = std::min(down_piece, down_bytes - flight.down_begin);
    const void* source = from + up_begin;
    if (!page_locked) {
      copy_in_parallel(flight.up.of(0), source, up_size);
      source = flight.up.of(0);
    }
    check(cudaMemcpyAsync(flight.device_up.data(), source, up_size, cudaMemcpyHostToDevice, flight.stream));
    check(cudaMemcpyAsync(page_locked ? to + flight.down_begin : flight.down.of(0), flight.device_down.data(),
                          flight.down_size, cudaMemcpyDeviceToHost, flight.stream));
  }
  for (Flight& flight : flights)
    finish(flight);
  return watch.seconds();
}

} // namespace masu
