// Renders many views of a scene, and large ones in bands: some are traced while others are encoded and
// written.
#pragma once

#include "renderer/image/image.h"
#include "renderer/tracer/tracer.h"
#include "tools/jobs/parted_file.h"
#include "tools/jobs/tracing_report.h"
#include "tools/lists/hit_file.h"
#include "tools/render/views.h"

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
  std::vector<ViewFiles> files{};     // one for each view
  ImageOptions image{};               // texts: the same for all views, and then each view's own
  std::vector<HitField> hit_fields{}; // of HitRecord
  Resume resume = Resume::off;
  int repeat = 1; // trace each view so often; seconds are medians
};

// Collective (tools/jobs/ranks.h). Files are the same bytes for any number of ranks, devices and threads.
// With `resume` files that are there are kept, and views without others aren't traced; the report has the
// others'. Shows the finished share unless `quiet`. When it throws (Error of the tracer and of output files),
// files of some views have been written, each whole.
TracingReport render_views(const ResidentTracer& tracer, const ViewsRequest& request, Ranks& ranks,
                           bool quiet);

} // namespace masu
