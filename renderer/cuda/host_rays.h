// Buffers between the host and a CUDA device: of pictures, and of lists of rays in host memory, which are
// streamed through the device. CUDA sources only.
#pragma once

#include "libscene/cuda/device_memory.h"
#include "libscene/cuda/near_device.h"

#include <optional>

namespace masu {

inline constexpr int pieces_in_flight = 3; // of rays_per_piece (backend.h)

// Page-locked memory near the device that was the current one where it was made, that grows to what was
// needed most. Any thread may call of().
class PinnedRoom {
public:
  PinnedRoom() { check(cudaGetDevice(&device_)); }
  std::uint8_t* of(std::size_t bytes) {
    if (!buffer_ || buffer_->bytes().size() < bytes) {
      const DeviceScope scope(device_); // or a worker thread would make a context on its own device
      buffer_.reset();
      const NearDevice near;
      buffer_.emplace(bytes);
    }
    return buffer_->bytes().data();
  }

private:
  int device_ = 0;
  std::optional<PinnedBuffer> buffer_;
};

// Of one picture.
struct FrameBuffers {
  Stream stream;
  PinnedRoom staging; // of one array after another
};

// Of one list of rays.
struct HostRayBuffers {
  struct Piece {
    Stream stream;
    Event begun, uploaded, traced, downloaded;
    PinnedRoom rays,
        results; // where the caller's memory isn't page-locked; of few rays both are in the first
  };
  // Made when it is first asked for: short lists need one.
  Piece& piece(std::size_t turn) {
    std::optional<Piece>& own = pieces[turn % pieces_in_flight];
    return own ? *own : own.emplace();
  }
  std::optional<Piece> pieces[pieces_in_flight];
  bool is_used = false; // by a query before
};

} // namespace masu
