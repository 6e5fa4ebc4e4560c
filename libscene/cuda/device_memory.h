// RAII over the CUDA runtime: checked calls, the current device, launches (in CUDA sources), device arrays,
// pinned memory, a timer.
#pragma once

#include "libscene/base/error.h"

#include <cuda_runtime.h>

#include <cstdint>
#include <memory>
#include <source_location>
#include <span>
#include <string>
#include <utility>

namespace masu {

// Throws Error(device) with the source location of the call.
inline void check(cudaError_t error, const std::source_location& where = std::source_location::current()) {
  if (error == cudaSuccess) return;
  static_cast<void>(cudaGetLastError()); // or the next check of a launch would find it again
  const char* const advice =
      error == cudaErrorMemoryAllocation ? ": choose a coarser grid, or use the CPU" : ": try the CPU";
  throw Error(ErrorCode::device, "cuda",
              std::string(cudaGetErrorString(error)) + " (" + where.file_name() + ":" +
                  std::to_string(where.line()) + ")" + advice);
}

// Of memory that CUDA doesn't know all is zero.
inline cudaPointerAttributes attributes_of(const void* pointer) {
  cudaPointerAttributes attributes{};
  if (cudaPointerGetAttributes(&attributes, pointer) == cudaSuccess) return attributes;
  static_cast<void>(cudaGetLastError()); // older drivers call unknown memory an error
  return {};
}

// Makes a device the thread's current one, and leaves the thread as it was: with the context that it had, or
// with none, for to set the device before again would open a context on a GPU that the host program may never
// use. Throws Error(device).
class DeviceScope {
public:
  explicit DeviceScope(int device);
  ~DeviceScope();
  DeviceScope(const DeviceScope&) = delete;
  DeviceScope& operator=(const DeviceScope&) = delete;
};

// Calls act() with the device current, where it can be: for destructors. What act() doesn't give back is lost
// with the device.
template <class Act>
void on_device_if_possible(int device, const Act& act) noexcept {
  try {
    const DeviceScope scope(device);
    act();
  } catch (...) { // there is nobody to tell
  }
}

// Memory of the current device that is given back to the pool, not to the device, until the pool is
// destroyed: so it is there at once for what comes next. The device's default pool is the host program's.
class MemoryPool {
public:
  MemoryPool() {
    cudaMemPoolProps properties{};
    properties.allocType = cudaMemAllocationTypePinned;
    properties.location.type = cudaMemLocationTypeDevice;
    check(cudaGetDevice(&device_));
    properties.location.id = device_;
    check(cudaMemPoolCreate(&pool_, &properties));
    std::uint64_t all = ~std::uint64_t{0};
    if (const cudaError_t error = cudaMemPoolSetAttribute(pool_, cudaMemPoolAttrReleaseThreshold, &all);
        error != cudaSuccess) {
      static_cast<void>(cudaMemPoolDestroy(pool_));
      check(error);
    }
  }
  // Waits until what was freed in the order of a stream's work has come back: drivers have crashed at pools
  // that were destroyed before. Where that can't be waited for, the pool is lost with its device.
  ~MemoryPool() {
    on_device_if_possible(device_, [&] {
      check(cudaDeviceSynchronize());
      check(cudaMemPoolDestroy(pool_));
    });
  }
  MemoryPool(const MemoryPool&) = delete;
  MemoryPool& operator=(const MemoryPool&) = delete;
  operator cudaMemPool_t() const { return pool_; }
  // Gives what is free, once the device is done with it, back to the device.
  void trim() const {
    check(cudaDeviceSynchronize());
    check(cudaMemPoolTrimTo(pool_, 0));
  }

private:
  int device_ = 0;
  cudaMemPool_t pool_ = nullptr;
};

// Where work is queued, and where its memory is from: null for the default stream and the device's own pool.
struct StreamMemory {
  cudaStream_t stream = nullptr;
  cudaMemPool_t pool = nullptr;
};

#ifdef __CUDACC__
// Puts a kernel on a stream. Throws Error(device) for its own errors alone: what the host program has not yet
// looked at (cudaGetLastError) stays as it is.
template <class... Parameters, class... Arguments>
void launch(void (*kernel)(Parameters...), dim3 blocks, dim3 threads, cudaStream_t stream,
            Arguments&&... arguments) {
  cudaLaunchConfig_t config{};
  config.gridDim = blocks;
  config.blockDim = threads;
  config.stream = stream;
  check(cudaLaunchKernelEx(&config, kernel, std::forward<Arguments>(arguments)...));
}

inline unsigned blocks_of(unsigned threads, std::uint64_t items) {
  return static_cast<unsigned>((items + threads - 1) / threads);
}

namespace kernels {

template <class Act>
__global__ void each(std::uint64_t count, const __grid_constant__ Act act) {
  const std::uint64_t i = std::uint64_t{blockIdx.x} * blockDim.x + threadIdx.x;
  if (i < count) act(i);
}

} // namespace kernels

// Puts act(0) … act(count - 1) on a stream, a thread each.
template <class Act>
void for_each_on_device(std::uint64_t count, cudaStream_t stream, const Act& act) {
  constexpr unsigned threads = 256;
  if (count > 0) launch(kernels::each<Act>, blocks_of(threads, count), threads, stream, count, act);
}
#endif

// A stream that doesn't wait for the default one.
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

// Owns an array of records in device memory, from a stream-ordered memory pool: it is allocated and freed in
// the order of a stream's work, without waiting, and freed memory is used again. Allocates nothing for
// count 0.
template <class T>
class DeviceArray {
public:
  DeviceArray() = default;
  explicit DeviceArray(std::size_t count, const StreamMemory& memory = {})
      : count_(count), stream_(memory.stream) {
    if (count == 0) return;
    void** const data = reinterpret_cast<void**>(&data_);
    const std::size_t bytes = count * sizeof(T);
    check(memory.pool != nullptr ? cudaMallocFromPoolAsync(data, bytes, memory.pool, memory.stream)
                                 : cudaMallocAsync(data, bytes, memory.stream));
  }
  DeviceArray(const T* host, std::size_t count, const StreamMemory& memory = {})
      : DeviceArray(count, memory) {
    if (count > 0) check(cudaMemcpyAsync(data_, host, count * sizeof(T), cudaMemcpyHostToDevice, stream_));
  }
  // Of a larger array, some bytes after its beginning.
  DeviceArray(const std::shared_ptr<const DeviceArray<std::uint8_t>>& of, std::size_t offset,
              std::size_t count)
      : data_(reinterpret_cast<T*>(of->data() + offset)), count_(count), stream_(of->stream()), of_(of) {}
  DeviceArray(DeviceArray&& other) noexcept { *this = std::move(other); }
  DeviceArray& operator=(DeviceArray&& other) noexcept {
    std::swap(of_, other.of_);
    std::swap(data_, other.data_);
    std::swap(count_, other.count_);
    std::swap(stream_, other.stream_);
    return *this;
  }
  DeviceArray(const DeviceArray&) = delete;
  DeviceArray& operator=(const DeviceArray&) = delete;
  ~DeviceArray() {
    if (data_ != nullptr && of_ == nullptr) static_cast<void>(cudaFreeAsync(data_, stream_));
  }

  T* data() const { return data_; }
  std::size_t size() const { return count_; }
  cudaStream_t stream() const { return stream_; }
  void clear() const {
    if (count_ > 0) check(cudaMemsetAsync(data_, 0, count_ * sizeof(T), stream_));
  }
  // Waits for it.
  void download(T* host) const {
    if (count_ == 0) return;
    check(cudaMemcpyAsync(host, data_, count_ * sizeof(T), cudaMemcpyDeviceToHost, stream_));
    check(cudaStreamSynchronize(stream_));
  }

private:
  T* data_ = nullptr;
  std::size_t count_ = 0;
  cudaStream_t stream_ = nullptr;
  std::shared_ptr<const DeviceArray<std::uint8_t>> of_{}; // lives as long; null: none
};

// What arrays are in that are made on a device.
struct CudaMemory {
  template <class T>
  using Array = DeviceArray<T>;
};

// Page-locked host memory, which the device reads and writes directly.
class PinnedBuffer {
public:
  explicit PinnedBuffer(std::size_t bytes) : size_(bytes) {
    check(cudaMallocHost(reinterpret_cast<void**>(&data_), bytes));
  }
  PinnedBuffer(const PinnedBuffer&) = delete;
  PinnedBuffer& operator=(const PinnedBuffer&) = delete;
  ~PinnedBuffer() { static_cast<void>(cudaFreeHost(data_)); }

  std::span<std::uint8_t> bytes() const { return {data_, size_}; }

private:
  std::uint8_t* data_ = nullptr;
  std::size_t size_ = 0;
};

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

// Of events that have been reached.
inline double seconds_between(cudaEvent_t first, cudaEvent_t second) {
  float milliseconds = 0;
  check(cudaEventElapsedTime(&milliseconds, first, second));
  return static_cast<double>(milliseconds) * 1e-3;
}

// Time on a stream since construction.
class DeviceTimer {
public:
  explicit DeviceTimer(cudaStream_t stream = nullptr) : stream_(stream) {
    check(cudaEventRecord(start_, stream_));
  }

  // To be recorded again, where the time is to begin later.
  cudaEvent_t start() const { return start_; }
  // Waits for the work launched so far.
  double seconds() const {
    check(cudaEventRecord(stop_, stream_));
    check(cudaEventSynchronize(stop_));
    return seconds_between(start_, stop_);
  }

private:
  cudaStream_t stream_;
  Event start_, stop_;
};

} // namespace masu
