// Renders many views of a scene, and large ones in bands: some are traced while others are encoded and
// written.
#pragma once

#include "renderer/image.h"
#include "renderer/tracer.h"
#include "tools/view_output.h"
#include "tools/views.h"

#include <functional>
#include <string>
#include <vector>

namespace masu {

struct ViewsRequest {
  FrameRequest frame{}; // of every view but for the camera
  std::vector<View> views{};
  std::vector<ViewFiles> files{}; // a view each
  ImageOptions image{};           // texts: the same for all views, and then each view's own
  int repeat = 1;                 // trace each view so often; seconds are medians
};

// Of all views together. Seconds of tracing overlap those of writing, and on a GPU each other.
struct ViewsReport {
  std::uint64_t rays = 0; // camera rays
  Counts counts;
  TraceSeconds seconds;
  double write_seconds = 0;
  double elapsed_seconds = 0; // from the first ray to the last byte
};

// Files are the same bytes for any number of devices and threads. `progress` gets the finished share, from
// any thread. When it throws (Error of the tracer and of output files), files of some views have been
// written, each whole.
ViewsReport render_views(const Tracer& tracer, const ViewsRequest& request,
                         const std::function<void(double)>& progress);

} // namespace masu
