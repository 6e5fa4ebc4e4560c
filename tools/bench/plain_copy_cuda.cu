#include "libscene/cuda/device_memory.h"
#include "libscene/file/mapped_file.h"
#include "libscene/stopwatch.h"
#include "tools/bench/file_reader.h"
#include "tools/bench/plain_copy.h"

#include <algorithm>

namespace masu {
namespace {

// Fits in the processor's cache, from which the bytes are copied to the device.
constexpr std::size_t buffer_bytes = std::size_t{4} << 20;

double copy_read(const std::string& path) {
  const PinnedBuffer buffer(buffer_bytes);
  const Stopwatch watch;
  FileReader file(path);
  const DeviceArray<std::uint8_t> copy(file.size());
  for (std::size_t at = 0; at < copy.size();) {
    const std::size_t got = file.read(buffer.bytes().first(std::min(buffer_bytes, copy.size() - at)));
    if (got == 0) throw Error(ErrorCode::input, path, "was cut short while it was read: try again");
    check(cudaMemcpy(copy.data() + at, buffer.bytes().data(), got, cudaMemcpyHostToDevice));
    at += got;
  }
  check(cudaDeviceSynchronize());
  return watch.seconds();
}

double copy_mapped(const std::string& path) {
  const Stopwatch watch;
  const MappedFile file(path);
  const DeviceArray<std::uint8_t> copy(file.bytes());
  check(cudaDeviceSynchronize());
  return watch.seconds();
}

} // namespace

double copy_seconds_cuda(const std::string& path, CopyFrom from) {
  check(cudaFree(nullptr)); // initialises the device outside the measured time
  return from == CopyFrom::mapping ? copy_mapped(path) : copy_read(path);
}

} // namespace masu
