// libFuzzer target: any text is parsed or throws Error. The first byte selects the size of pieces.
#include "libscene/base/error.h"
#include "libscene/nff/nff.h"

#include <tbb/task_arena.h>

#include <cstddef>
#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string_view text(reinterpret_cast<const char*>(data) + 1, size - 1);
  try {
    const masu::NffOptions options{data[0] < 128 ? std::size_t{1} << 20 : data[0]};
    tbb::task_arena(1).execute([&] { masu::parse_nff(text, "fuzz", options); });
  } catch (const masu::Error&) {
  }
  return 0;
}
