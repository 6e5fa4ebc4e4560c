#include "renderer/backend.h"

namespace masu {

Frame empty_frame(const FrameRequest& request) {
  Frame frame;
  const std::int32_t more = request.sampling == Sampling::corners ? 1 : 0;
  frame.columns = request.camera.width + more;
  frame.rows = request.camera.height + more;
  const std::size_t rays = static_cast<std::size_t>(frame.columns) * static_cast<std::size_t>(frame.rows);
  frame.radiance.resize(rays);
  if (request.hits) frame.hits.resize(rays);
  return frame;
}

} // namespace masu
