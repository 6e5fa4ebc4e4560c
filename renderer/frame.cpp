#include "renderer/frame.h"

#include "libscene/base/error.h"

#include <fmt/format.h>

#include <utility>

namespace masu {
namespace {

// Whether `count` from `first` on lie below `end`, and are at least one.
bool is_within(std::int32_t first, std::int32_t count, std::int32_t end) {
  return first >= 0 && count > 0 && first < end && count <= end - first;
}

} // namespace

void check_depth(std::int32_t depth) {
  if (depth < 1 || depth > largest_depth)
    throw Error(ErrorCode::usage, "depth", fmt::format("{} isn't from 1 to {}", depth, largest_depth));
}

void check_request(const FrameRequest& request) {
  check_depth(request.rules.depth);
  if (request.attributes && !(request.hits && request.rules.hit_name == HitName::primitive))
    throw Error(ErrorCode::usage, "attributes", "need hits that are named by primitive");
  const RayWindow &window = request.window, all = all_rays(request.camera, request.sampling);
  if (window.columns > 0 && (!is_within(window.first_column, window.columns, all.columns) ||
                             !is_within(window.first_row, window.rows, all.rows)))
    throw Error(ErrorCode::usage, "window",
                fmt::format("{} x {} rays from column {}, row {} aren't within the picture's {} x {}",
                            window.columns, window.rows, window.first_column, window.first_row, all.columns,
                            all.rows));
}

RayWindow window_of(const FrameRequest& request) {
  return request.window.columns > 0 ? request.window : all_rays(request.camera, request.sampling);
}

Frame sized_frame(const FrameRequest& request, Frame memory) {
  Frame frame;
  for_each_array(frame, memory, [](auto& array, auto& spare) { array = std::move(spare); });
  const RayWindow window = window_of(request);
  frame.columns = window.columns;
  frame.rows = window.rows;
  const std::size_t rays = static_cast<std::size_t>(frame.columns) * static_cast<std::size_t>(frame.rows);
  frame.radiance.resize(request.shaded && !request.rgb ? rays : 0);
  const std::int32_t more = rays_beyond_pixels(request.sampling);
  frame.rgb.resize(request.rgb ? 3 * static_cast<std::size_t>(frame.columns - more) *
                                     static_cast<std::size_t>(frame.rows - more)
                               : 0);
  frame.hits.resize(request.hits ? rays : 0);
  frame.objects.resize(request.attributes ? rays : 0);
  frame.normals.resize(request.attributes ? rays : 0);
  frame.cells.resize(request.costs ? rays : 0);
  frame.tests.resize(request.costs ? rays : 0);
  return frame;
}

} // namespace masu
