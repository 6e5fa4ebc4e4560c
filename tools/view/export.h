// The page as one file that needs no server: pictures of an orbit, channels, slices, statistics.
#pragma once

#include "tools/view/viewer.h"

#include <functional>
#include <string>
#include <vector>

namespace masu {

struct ExportSettings {
  std::string path;                       // .html
  int views = 12;                         // around the point that the scene's camera looks at
  std::int32_t width = 640, height = 480; // pixels
  std::vector<SharePlane> slices{};       // at least one
  std::vector<Ray<double>> rays{};        // in slices: walked besides those from point to point
  std::string opens_with{};               // the fragment of the address that is shown first
  int most_boxes = 1000;                  // of each depth
};

// progress gets the share that is done. Throws Error(output), Error(usage) for a ray in none of the slices,
// and what Viewer's functions throw.
void export_page(const Viewer& viewer, const ExportSettings& settings,
                 const std::function<void(double)>& progress);

} // namespace masu
