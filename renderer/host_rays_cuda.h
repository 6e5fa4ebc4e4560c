// Buffers between the host and a CUDA device: of pictures, and of lists of rays in host memory, which are
// streamed through the device. CUDA sources only.
#pragma once

#include "libscene/cuda/device_memory.h"

#include <optional>

namespace masu {

// Rays on the device at a time, for each of the stages: one piece is uploaded while another is traced and the
// results of a third come back.
inline constexpr std::size_t rays_a_piece = std::size_t{1} << 20;
inline constexpr int pieces_in_flight = 3;

class Event {
public:
  Event() { check(cudaEventCreate(&event_)); }
  ~Event() { static_cast<void>(cudaEventDestroy(event_)); }
  Event(const Event&) = delete;
  Event& operator=(const Event&) = delete;
  operator cudaEvent_t() const { return event_; }

private:
  cudaEvent_t event_ = nullptr;
};

// Page-locked memory that grows to what was needed most.
class PinnedRoom {
public:
  std::uint8_t* of(std::size_t bytes) {
    if (!buffer_ || buffer_->bytes().size() < bytes) {
      buffer_.reset();
      buffer_.emplace(bytes);
    }
    return buffer_->bytes().data();
  }

private:
  std::optional<PinnedBuffer> buffer_;
};

// Of one picture.
struct FrameBuffers {
  Stream stream;
  PinnedRoom radiance, hits, costs;
};

// Copies with many threads: one doesn't copy as fast as the bus does.
void copy_in_parallel(void* to, const void* from, std::size_t bytes);

// Of one list of rays.
struct HostRayBuffers {
  struct Piece {
    Stream stream;
    Event begun, uploaded, traced, downloaded;
    PinnedRoom rays, results; // where the caller's memory isn't page-locked
  };
  Piece pieces[pieces_in_flight];
};

} // namespace masu
