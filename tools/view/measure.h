// How many pictures a second gridview sends, end to end: traced, copied, encoded, and received over loopback.
#pragma once

#include "tools/view/viewer.h"

#include <nlohmann/json.hpp>

namespace masu {

struct MeasureSettings {
  std::int32_t width = 1024, height = 1024; // pixels
  int warm_up = 5, repeat = 50;             // pictures
};

// A row for each grid, quality (moving, still) and number of requests in flight (1, 2): pictures a second,
// and medians of each stage in ms. Views are those of a turntable.
nlohmann::ordered_json measure(const Viewer& viewer, const MeasureSettings& settings);

} // namespace masu
