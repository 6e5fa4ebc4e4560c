// The page as one file that needs no server: pictures of an orbit, channels, slices, statistics.
#pragma once

#include "tools/view/viewer.h"

#include <functional>
#include <string>

namespace masu {

struct ExportSettings {
  std::string path;                       // .html
  int views = 12;                         // around the point that the scene's camera looks at
  std::int32_t width = 640, height = 480; // pixels
};

// progress gets the share that is done. Throws Error(output), and what Viewer's functions throw.
void export_page(const Viewer& viewer, const ExportSettings& settings,
                 const std::function<void(double)>& progress);

} // namespace masu
