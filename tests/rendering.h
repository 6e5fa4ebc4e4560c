// Small scenes made and rendered in a test: through the files, as the tools do it.
#pragma once

#include "renderer/tracer/tracer.h"
#include "tests/grid_of_scene.h"
#include "tests/same_values.h"
#include "tests/temporary_folder.h"

#include <memory>

namespace masu {

// A scene file and a grid for it.
class Rendering {
public:
  template <class Triangles>
  Rendering(const SceneOf<Triangles>& scene, Store store, const std::string& division = "auto",
            const StructureOptions& options = {}, const std::optional<Vec3d>& origin = {})
      : camera_(scene.camera) {
    write_scene(scene, store, folder_.file("scene"), origin);
    scene_ = std::make_unique<SceneFile>(folder_.file("scene"));
    write_grid_of(*scene_, division, options, folder_.file("grid"));
    grid_ = std::make_unique<StructureFile>(folder_.file("grid"));
  }

  const SceneFile& scene() const { return *scene_; }
  const StructureFile& grid() const { return *grid_; }

  // Counting hits and rays; corners; five deep.
  FrameRequest request() const {
    FrameRequest request;
    request.camera = camera_;
    request.hits = request.tracing.count = true;
    return request;
  }
  ResidentTracer tracer(Device device = Device::cpu, bool with_grid = true) const {
    return {*scene_, with_grid ? grid_.get() : nullptr, device};
  }
  Frame frame(const FrameRequest& request) const { return tracer().render(request); }
  Frame frame() const { return frame(request()); }

private:
  TemporaryFolder folder_;
  Camera camera_;
  std::unique_ptr<SceneFile> scene_;
  std::unique_ptr<StructureFile> grid_;
};

// A frame's memory that was used for something else.
inline Frame used_memory(std::size_t rays) {
  constexpr float garbage = 1e30F;
  Frame frame;
  frame.radiance.assign(rays, {garbage, garbage, garbage});
  frame.rgb.assign(rays, 123);
  frame.hits.assign(rays, {garbage, 12345});
  frame.cells.assign(rays, 12345);
  frame.tests.assign(rays, 12345);
  return frame;
}

inline void expect_same_frames(const Frame& a, const Frame& b) {
  EXPECT_TRUE(same_values(a.radiance, b.radiance));
  EXPECT_TRUE(same_values(a.rgb, b.rgb));
  EXPECT_TRUE(same_values(a.hits, b.hits));
  EXPECT_TRUE(same_values(a.cells, b.cells));
  EXPECT_TRUE(same_values(a.tests, b.tests));
}

} // namespace masu
