#include "tools/render/frame_options.h"

#include "tools/render/views.h"

namespace masu {

void FrameOptions::add_camera(const CommandLine& command) {
  command.add_option("--size", size, "pixels instead of the view's resolution", "WxH");
  command.add_option("--from", from, "where the camera is, instead of the scene's", "X,Y,Z");
  command.add_option("--at", at, "the point in the middle of the picture", "X,Y,Z");
  command.add_option("--up", up, "the direction that is up in the picture", "X,Y,Z");
  command.add_option("--angle", angle, "degrees that the picture's height spans", "DEGREES");
}

void FrameOptions::add_sampling(const CommandLine& command) {
  command.add_choice("--sampling", sampling, {{"corners", Sampling::corners}, {"centers", Sampling::centers}},
                     "rays through pixel corners, four averaged (corners), or through pixel centers");
  command.add_flag("--hither", hither, "ignore hits in front of the view's hither plane");
}

void FrameOptions::add_secondary(const CommandLine& command) {
  command.add_number("--depth", depth, 1, largest_depth, "largest depth of rays; camera rays have depth 1");
  command.add_flag("--spd-rules", spd_rules,
                   "spawn the secondary rays that the SPD counts, even those of weight zero");
}

Camera FrameOptions::camera(const SceneFile& scene) const {
  Camera camera = resized(scene.camera(), size);
  if (!from.empty()) camera.from = parse_vector("--from", from);
  if (!at.empty()) camera.at = parse_vector("--at", at);
  if (!up.empty()) camera.up = parse_vector("--up", up);
  camera.angle = angle.value_or(camera.angle);
  return camera;
}

void FrameOptions::check(const Camera& camera, const SceneFile& scene) const {
  if (from.empty() && at.empty() && up.empty() && !angle) return; // the scene's
  if (const auto fault = fault_of(camera, camera_places(scene)))
    throw Error(ErrorCode::usage, std::string("--") + fault->part, fault->what);
}

FrameRequest FrameOptions::frame(const TracingRules& tracing) const {
  FrameRequest request;
  request.tracing = tracing;
  request.sampling = sampling;
  request.hither = hither;
  request.rules = {depth, spd_rules, HitName::object};
  return request;
}

} // namespace masu
