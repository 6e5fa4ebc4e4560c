// libFuzzer target: any bytes as a list of views are refused by Error, or are views that can be traced from;
// any bytes as the header of a NumPy array are refused, or tell its type and shape; any bytes as a list of
// rays in text are refused, or are the same rays in whatever pieces they are read. The first byte selects
// one.
#include "libscene/base/error.h"
#include "tools/lists/npy.h"
#include "tools/lists/ray_csv.h"
#include "tools/render/views.h"

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

namespace {

// In pieces of so many bytes.
std::vector<double> rays_of(std::string_view text, std::size_t piece) {
  masu::RayCsv csv("fuzz");
  std::vector<double> rays;
  std::size_t begin = 0, end = 0;
  const auto is_all = [&] { return end == text.size(); };
  const auto known = [&] { return text.substr(begin, end - begin); };
  do {
    end = std::min(text.size(), end + piece);
    begin = csv.read_names(known(), is_all());
  } while (begin == 0);
  for (;;) {
    begin += csv.read_rays(known(), is_all(), text.size(), rays);
    if (is_all()) break;
    end = std::min(text.size(), end + piece);
  }
  if (rays.size() % static_cast<std::size_t>(csv.numbers()) != 0) std::abort();
  return rays;
}

void try_rays(std::string_view text, std::size_t piece) {
  std::vector<double> rays;
  try {
    rays = rays_of(text, text.size());
  } catch (const masu::Error&) {
    return;
  }
  const std::vector<double> same = rays_of(text, piece);
  const auto bits = [](double number) { return std::bit_cast<std::uint64_t>(number); }; // of NaN, too
  if (!std::ranges::equal(same, rays, {}, bits, bits)) std::abort();
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string_view text(reinterpret_cast<const char*>(data) + 1, size - 1);
  if (data[0] % 3 == 0) {
    static_cast<void>(masu::parsed_npy_header(std::string(text)));
    return 0;
  }
  if (data[0] % 3 == 2) {
    try_rays(text, 1 + data[0] / 3);
    return 0;
  }
  try {
    constexpr masu::Boxd places{{-1e15, -1e15, -1e15}, {1e15, 1e15, 1e15}};
    for (const masu::View& view : masu::parse_views(std::string(text), "fuzz", {}, places)) {
      if (masu::fault_of(view.camera, places)) std::abort();
      if (view.name.find('/') != std::string::npos) std::abort();
    }
  } catch (const masu::Error&) {
  }
  return 0;
}
