// libFuzzer target: any bytes as a list of views are refused by Error, or are views that can be traced from;
// any bytes as the header of a NumPy array are refused, or tell its type and shape. The first byte selects
// one.
#include "libscene/error.h"
#include "tools/npy.h"
#include "tools/views.h"

#include <cstdlib>
#include <string>
#include <string_view>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string_view text(reinterpret_cast<const char*>(data) + 1, size - 1);
  if (data[0] % 2 == 0) {
    static_cast<void>(masu::parsed_npy_header(std::string(text)));
    return 0;
  }
  try {
    constexpr double reach = 1e15;
    for (const masu::View& view : masu::parse_views(std::string(text), "fuzz", {}, reach)) {
      if (masu::fault_of(view.camera, reach)) std::abort();
      if (view.name.find('/') != std::string::npos) std::abort();
    }
  } catch (const masu::Error&) {
  }
  return 0;
}
