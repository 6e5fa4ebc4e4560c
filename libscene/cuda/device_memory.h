// RAII over the CUDA runtime: checked calls, device arrays, pinned memory, a timer.
#pragma once

#include "libscene/error.h"

#include <cuda_runtime.h>

#include <cstdint>
#include <source_location>
#include <span>
#include <string>
#include <utility>

namespace masu {

// Throws Error(device) with the source location of the call.
inline void check(cudaError_t error, const std::source_location& where = std::source_location::current()) {
  if (error == cudaSuccess) return;
  const char* const advice =
      error == cudaErrorMemoryAllocation ? ": choose a coarser grid, or use the CPU" : ": try the CPU";
  throw Error(ErrorCode::device, "cuda",
              std::string(cudaGetErrorString(error)) + " (" + where.file_name() + ":" +
                  std::to_string(where.line()) + ")" + advice);
}

// Owns an array of records in device memory; allocates nothing for count 0.
template <class T>
class DeviceArray {
public:
  DeviceArray() = default;
  explicit DeviceArray(std::size_t count) : count_(count) {
    if (count > 0) check(cudaMalloc(reinterpret_cast<void**>(&data_), count * sizeof(T)));
  }
  DeviceArray(const T* host, std::size_t count) : DeviceArray(count) {
    if (count > 0) check(cudaMemcpy(data_, host, count * sizeof(T), cudaMemcpyHostToDevice));
  }
  explicit DeviceArray(std::span<const T> host) : DeviceArray(host.data(), host.size()) {}
  DeviceArray(DeviceArray&& other) noexcept
      : data_(std::exchange(other.data_, nullptr)), count_(std::exchange(other.count_, 0)) {}
  DeviceArray& operator=(DeviceArray&& other) noexcept {
    std::swap(data_, other.data_);
    std::swap(count_, other.count_);
    return *this;
  }
  DeviceArray(const DeviceArray&) = delete;
  DeviceArray& operator=(const DeviceArray&) = delete;
  ~DeviceArray() { static_cast<void>(cudaFree(data_)); }

  T* data() const { return data_; }
  std::size_t size() const { return count_; }
  void download(T* host) const {
    if (count_ > 0) check(cudaMemcpy(host, data_, count_ * sizeof(T), cudaMemcpyDeviceToHost));
  }

private:
  T* data_ = nullptr;
  std::size_t count_ = 0;
};

// A device array from the stream-ordered memory pool, on the default stream: allocating and freeing don't
// synchronise, and freed memory is reused.
template <class T>
class PooledArray {
public:
  PooledArray() = default;
  explicit PooledArray(std::uint64_t count) : count_(count) {
    if (count > 0) check(cudaMallocAsync(reinterpret_cast<void**>(&data_), count * sizeof(T), nullptr));
  }
  PooledArray(PooledArray&& other) noexcept
      : data_(std::exchange(other.data_, nullptr)), count_(std::exchange(other.count_, 0)) {}
  PooledArray& operator=(PooledArray&& other) noexcept {
    std::swap(data_, other.data_);
    std::swap(count_, other.count_);
    return *this;
  }
  PooledArray(const PooledArray&) = delete;
  PooledArray& operator=(const PooledArray&) = delete;
  ~PooledArray() {
    if (data_ != nullptr) static_cast<void>(cudaFreeAsync(data_, nullptr));
  }

  T* data() const { return data_; }
  std::uint64_t size() const { return count_; }
  void download(T* host) const {
    if (count_ > 0) check(cudaMemcpy(host, data_, count_ * sizeof(T), cudaMemcpyDeviceToHost));
  }

private:
  T* data_ = nullptr;
  std::uint64_t count_ = 0;
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

// Time on the default stream since construction.
class DeviceTimer {
public:
  DeviceTimer() {
    check(cudaEventCreate(&start_));
    check(cudaEventCreate(&stop_));
    check(cudaEventRecord(start_));
  }
  ~DeviceTimer() {
    static_cast<void>(cudaEventDestroy(start_));
    static_cast<void>(cudaEventDestroy(stop_));
  }
  DeviceTimer(const DeviceTimer&) = delete;
  DeviceTimer& operator=(const DeviceTimer&) = delete;

  // Waits for the work launched so far.
  double seconds() const {
    check(cudaEventRecord(stop_));
    check(cudaEventSynchronize(stop_));
    float milliseconds = 0;
    check(cudaEventElapsedTime(&milliseconds, start_, stop_));
    return static_cast<double>(milliseconds) * 1e-3;
  }

private:
  cudaEvent_t start_ = nullptr, stop_ = nullptr;
};

} // namespace masu
