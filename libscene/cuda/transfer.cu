#include "libscene/cuda/transfer.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cstring>

namespace masu {
namespace {

constexpr std::size_t piece_bytes = std::size_t{1} << 20;
constexpr int lanes = 4;                       // threads that copy: about what it takes to fill the bus
constexpr std::size_t small = 8 * piece_bytes; // less isn't worth the page-locked memory

class Stream {
public:
  Stream() { check(cudaStreamCreateWithFlags(&stream_, cudaStreamNonBlocking)); }
  ~Stream() { static_cast<void>(cudaStreamDestroy(stream_)); }
  Stream(const Stream&) = delete;
  Stream& operator=(const Stream&) = delete;
  operator cudaStream_t() const { return stream_; }

private:
  cudaStream_t stream_ = nullptr;
};

// A thread's own. Upwards one half is on its way to the device while the other is filled.
class Lane {
public:
  void upload(void* device, const void* host, std::size_t bytes) {
    Half& half = halves_[turn_];
    turn_ = 1 - turn_;
    check(cudaStreamSynchronize(half.stream));
    std::memcpy(half.buffer.bytes().data(), host, bytes);
    check(cudaMemcpyAsync(device, half.buffer.bytes().data(), bytes, cudaMemcpyHostToDevice, half.stream));
  }
  void download(void* host, const void* device, std::size_t bytes) {
    Half& half = halves_[0];
    check(cudaMemcpyAsync(half.buffer.bytes().data(), device, bytes, cudaMemcpyDeviceToHost, half.stream));
    check(cudaStreamSynchronize(half.stream));
    std::memcpy(host, half.buffer.bytes().data(), bytes);
  }

private:
  struct Half {
    PinnedBuffer buffer{piece_bytes};
    Stream stream;
  };
  Half halves_[2];
  int turn_ = 0;
};

} // namespace

void Transfer::run(const std::function<void()>& meanwhile) {
  tbb::parallel_invoke([&] { copy_all(); }, meanwhile);
}

void Transfer::copy_all() {
  std::vector<Copy> pieces;
  std::size_t all = 0;
  for (const Copy& copy : copies_) {
    all += copy.bytes;
    for (std::size_t at = 0; at < copy.bytes; at += piece_bytes)
      pieces.push_back({static_cast<std::uint8_t*>(copy.to) + at,
                        static_cast<const std::uint8_t*>(copy.from) + at,
                        std::min(piece_bytes, copy.bytes - at), copy.direction});
  }
  check(cudaDeviceSynchronize());
  if (all < small) {
    for (const Copy& copy : copies_)
      check(cudaMemcpy(copy.to, copy.from, copy.bytes, copy.direction));
  } else {
    tbb::enumerable_thread_specific<Lane> own;
    tbb::task_arena arena(lanes);
    arena.execute([&] {
      tbb::parallel_for(std::size_t{0}, pieces.size(), [&](std::size_t i) {
        const Copy& piece = pieces[i];
        piece.direction == cudaMemcpyHostToDevice ? own.local().upload(piece.to, piece.from, piece.bytes)
                                                  : own.local().download(piece.to, piece.from, piece.bytes);
      });
    });
    check(cudaDeviceSynchronize());
  }
  copies_.clear();
}

} // namespace masu
