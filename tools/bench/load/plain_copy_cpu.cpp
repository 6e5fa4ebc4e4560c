#include "libscene/base/stopwatch.h"
#include "libscene/file/file_mapping.h"
#include "tools/bench/load/plain_copy.h"

#include <cstring>
#include <memory>

namespace masu {
namespace {

// Keeps the compiler from removing the copy, which nothing reads.
void pretend_to_read(const std::uint8_t* bytes) {
  asm volatile("" : : "r"(bytes) : "memory");
}

} // namespace

double copy_seconds_cpu(const std::string& path, CopyFrom from) {
  const Stopwatch watch;
  const InputFile file(path);
  const auto copy = std::make_unique_for_overwrite<std::uint8_t[]>(file.size());
  if (from == CopyFrom::mapping) {
    const FileMapping mapping(file);
    std::memcpy(copy.get(), mapping.bytes().data(), mapping.bytes().size());
  } else {
    file.read(0, {copy.get(), file.size()});
  }
  pretend_to_read(copy.get());
  return watch.seconds();
}

} // namespace masu
