// Renders many views of a scene: one is traced while others are encoded and written.
#pragma once

#include "renderer/image.h"
#include "renderer/tracer.h"
#include "tools/views.h"

#include <functional>
#include <string>
#include <vector>

namespace masu {

// The files of a view; an empty name: not written. - is standard output.
struct ViewFiles {
  std::string picture, hits;
};

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

// Files are the same bytes for any number of threads. `progress` gets the finished share, from any thread.
// When it throws (Error of the tracer and of output files), files of some views have been written, each
// whole.
ViewsReport render_views(const Tracer& tracer, const ViewsRequest& request,
                         const std::function<void(double)>& progress);

} // namespace masu
