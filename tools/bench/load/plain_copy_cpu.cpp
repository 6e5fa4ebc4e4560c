#include "libscene/base/stopwatch.h"
#include "tools/bench/load/file_reader.h"
#include "tools/bench/load/mapped_file.h"
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
  if (from == CopyFrom::mapping) {
    const MappedFile file(path);
    const auto copy = std::make_unique_for_overwrite<std::uint8_t[]>(file.bytes().size());
    std::memcpy(copy.get(), file.bytes().data(), file.bytes().size());
    pretend_to_read(copy.get());
    return watch.seconds();
  }
  FileReader file(path);
  const auto copy = std::make_unique_for_overwrite<std::uint8_t[]>(file.size());
  file.read({copy.get(), file.size()});
  pretend_to_read(copy.get());
  return watch.seconds();
}

} // namespace masu
