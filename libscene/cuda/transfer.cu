#include "libscene/cuda/transfer.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cstring>

namespace masu {
namespace {

constexpr std::size_t piece_bytes = std::size_t{1} << 20;
constexpr int copy_threads = 4;                           // about enough to saturate the bus
constexpr std::size_t min_pinned_bytes = 8 * piece_bytes; // less isn't worth allocating page-locked memory

// The staging buffers of one thread. Uploads alternate: one buffer is transferred while the other is filled.
class StagingBuffers {
public:
  void upload(void* device, const void* host, std::size_t bytes) {
    Staging& staging = stagings_[next_];
    next_ = 1 - next_;
    check(cudaStreamSynchronize(staging.stream));
    std::memcpy(staging.buffer.bytes().data(), host, bytes);
    check(cudaMemcpyAsync(device, staging.buffer.bytes().data(), bytes, cudaMemcpyHostToDevice,
                          staging.stream));
  }
  void download(void* host, const void* device, std::size_t bytes) {
    Staging& staging = stagings_[0];
    check(cudaMemcpyAsync(staging.buffer.bytes().data(), device, bytes, cudaMemcpyDeviceToHost,
                          staging.stream));
    check(cudaStreamSynchronize(staging.stream));
    std::memcpy(host, staging.buffer.bytes().data(), bytes);
  }

private:
  struct Staging {
    PinnedBuffer buffer{piece_bytes};
    Stream stream;
    // After an error the arrays are given back next: nothing may still be copied to them.
    ~Staging() { static_cast<void>(cudaStreamSynchronize(stream)); }
  };
  Staging stagings_[2];
  int next_ = 0;
};

} // namespace

Transfer::Transfer() {
  check(cudaGetDevice(&device_));
}

void Transfer::run(const std::function<void()>& meanwhile) {
  tbb::parallel_invoke([&] { copy_all(); }, meanwhile);
}

void Transfer::copy_all() {
  const DeviceScope device(device_); // of a thread that may be another one
  std::vector<Copy> pieces;
  std::size_t total = 0;
  for (const Copy& copy : copies_) {
    total += copy.bytes;
    for (std::size_t offset = 0; offset < copy.bytes; offset += piece_bytes)
      pieces.push_back({static_cast<std::uint8_t*>(copy.to) + offset,
                        static_cast<const std::uint8_t*>(copy.from) + offset,
                        std::min(piece_bytes, copy.bytes - offset), copy.direction});
  }
  check(cudaDeviceSynchronize());
  if (total < min_pinned_bytes) {
    for (const Copy& copy : copies_)
      check(cudaMemcpy(copy.to, copy.from, copy.bytes, copy.direction));
  } else {
    tbb::enumerable_thread_specific<StagingBuffers> buffers;
    const auto allowed = tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
    tbb::task_arena arena(std::min(copy_threads, static_cast<int>(allowed)));
    arena.execute([&] {
      tbb::parallel_for(std::size_t{0}, pieces.size(), [&](std::size_t i) {
        const DeviceScope of_thread(device_);
        const Copy& piece = pieces[i];
        piece.direction == cudaMemcpyHostToDevice
            ? buffers.local().upload(piece.to, piece.from, piece.bytes)
            : buffers.local().download(piece.to, piece.from, piece.bytes);
      });
    });
    check(cudaDeviceSynchronize());
  }
  copies_.clear();
}

} // namespace masu
