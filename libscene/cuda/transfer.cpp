#include "libscene/cuda/transfer.h"
#include "libscene/base/parallel.h"

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cstring>
#include <optional>

namespace masu {
namespace {

// Of a staging buffer, or copied by a thread: smaller parts take longer to queue than to copy. Where there is
// much to copy, larger ones make up for the time it takes to lock their pages.
constexpr std::size_t part_bytes = std::size_t{1} << 18, large_part_bytes = std::size_t{1} << 20,
                      min_bytes_for_large = std::size_t{256} << 20;
constexpr int copy_threads = 4; // about enough to saturate the bus
constexpr std::size_t min_pinned_bytes = std::size_t{8}
                                         << 20; // less isn't worth allocating page-locked memory

using Fill = SectionReader::Fill;

std::uint8_t* moved_by(const void* pointer, std::size_t offset) {
  return static_cast<std::uint8_t*>(const_cast<void*>(pointer)) + offset;
}

} // namespace

// The staging buffers of one thread, parts of memory that should be page-locked. Uploads alternate: one
// buffer is transferred while the other is filled.
class StagingBuffers {
public:
  StagingBuffers(std::span<std::uint8_t> memory, cudaMemPool_t pool) : part_(memory.size() / 2), pool_(pool) {
    stagings_[0].buffer = memory.first(part_);
    stagings_[1].buffer = memory.last(part_);
  }
  std::size_t part() const { return part_; } // in bytes, at most

  void upload(const Transfer::Copy& copy, std::uint64_t offset, std::size_t bytes, const Fill& fill) {
    Staging& staging = stagings_[next_];
    next_ = 1 - next_;
    check(cudaStreamSynchronize(staging.stream));
    fill(staging.buffer.first(bytes));
    if (copy.place != nullptr && staging.unplaced.size() < bytes)
      staging.unplaced = DeviceArray<std::uint8_t>(bytes, {staging.stream, pool_});
    void* const to = copy.place != nullptr ? staging.unplaced.data() : moved_by(copy.to, offset);
    check(cudaMemcpyAsync(to, staging.buffer.data(), bytes, cudaMemcpyHostToDevice, staging.stream));
    if (copy.place != nullptr) copy.place(to, offset, bytes, staging.stream);
  }
  void download(void* host, const void* device, std::size_t bytes) {
    Staging& staging = stagings_[0];
    check(cudaMemcpyAsync(staging.buffer.data(), device, bytes, cudaMemcpyDeviceToHost, staging.stream));
    check(cudaStreamSynchronize(staging.stream));
    std::memcpy(host, staging.buffer.data(), bytes);
  }

private:
  struct Staging {
    std::span<std::uint8_t> buffer;
    Stream stream;
    DeviceArray<std::uint8_t> unplaced; // a part that lies on the device until it is placed
    // After an error the arrays are given back next: nothing may still be copied to them.
    ~Staging() { static_cast<void>(cudaStreamSynchronize(stream)); }
  };
  Staging stagings_[2];
  std::size_t part_;
  cudaMemPool_t pool_;
  int next_ = 0;
};

// All at once: to lock few pages takes as long as many.
struct StagingOfThreads {
  PinnedBuffer memory;
  std::vector<std::unique_ptr<StagingBuffers>> of_threads; // by their places in an arena

  StagingOfThreads(std::size_t of_part, cudaMemPool_t pool) : memory(copy_threads * 2 * of_part) {
    for (std::size_t i = 0; i < copy_threads; ++i)
      of_threads.push_back(
          std::make_unique<StagingBuffers>(memory.bytes().subspan(2 * i * of_part, 2 * of_part), pool));
  }
};

Transfer::Transfer(cudaMemPool_t pool) : pool_(pool) {
  check(cudaGetDevice(&device_));
}

void Transfer::run() {
  struct Piece {
    const Copy* copy;
    std::uint64_t i;
  };
  std::vector<Piece> pieces;
  std::size_t total = 0;
  for (const Copy& copy : copies_) {
    total += copy.bytes;
    for (std::uint64_t i = 0; i * SectionReader::piece_bytes < copy.bytes; ++i)
      pieces.push_back({&copy, i});
  }
  const auto make = [](const Piece& piece, StagingBuffers& buffers) {
    const Copy& copy = *piece.copy;
    const auto upload = [&](std::uint64_t offset, std::size_t bytes, const Fill& fill) {
      buffers.upload(copy, offset, bytes, fill);
    };
    if (copy.section != nullptr) return copy.section->read_piece(piece.i, buffers.part(), upload);
    const std::uint64_t end = std::min<std::uint64_t>((piece.i + 1) * SectionReader::piece_bytes, copy.bytes);
    for (std::uint64_t offset = piece.i * SectionReader::piece_bytes; offset < end;
         offset += buffers.part()) {
      const std::size_t bytes = std::min<std::uint64_t>(buffers.part(), end - offset);
      const auto* const from = moved_by(copy.from, offset);
      if (copy.direction == cudaMemcpyDeviceToHost)
        buffers.download(moved_by(copy.to, offset), from, bytes);
      else
        upload(offset, bytes, [&](std::span<std::uint8_t> to) { std::memcpy(to.data(), from, bytes); });
    }
  };
  const DeviceScope device(device_);
  check(cudaDeviceSynchronize());
  if (total < min_pinned_bytes && staging_ == nullptr) {
    HostBytes pageable; // for little
    std::optional<StagingBuffers> buffers;
    for (const Piece& piece : pieces) {
      const Copy& copy = *piece.copy;
      if (copy.section != nullptr || copy.place != nullptr) {
        pageable.resize(2 * part_bytes);
        if (!buffers) buffers.emplace(pageable, pool_);
        make(piece, *buffers);
      } else if (piece.i == 0) { // all at once
        check(cudaMemcpy(copy.to, copy.from, copy.bytes, copy.direction));
      }
    }
  } else {
    if (staging_ == nullptr)
      staging_ = std::make_shared<StagingOfThreads>(
          total < min_bytes_for_large ? part_bytes : large_part_bytes, pool_);
    const auto allowed = tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
    tbb::task_arena arena(std::min(copy_threads, static_cast<int>(allowed)));
    arena.execute([&] {
      parallel_for(pieces.size(), [&](std::size_t i) {
        const DeviceScope of_thread(device_);
        make(pieces[i],
             *staging_->of_threads[static_cast<std::size_t>(tbb::this_task_arena::current_thread_index())]);
      });
    });
  }
  // Also of pageable memory: then the driver may still be copying, and streams of queries don't wait for it.
  check(cudaDeviceSynchronize());
  for (const Copy& copy : copies_)
    if (copy.section != nullptr) copy.section->check();
  copies_.clear();
}

void copy_in_parallel(void* to, const void* from, std::size_t bytes) {
  parallel_for((bytes + part_bytes - 1) / part_bytes, [&](std::size_t i) {
    const std::size_t begin = i * part_bytes;
    std::memcpy(moved_by(to, begin), moved_by(from, begin), std::min(part_bytes, bytes - begin));
  });
}

} // namespace masu
