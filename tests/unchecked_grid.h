// A damaged grid whose records weren't checked when it was opened, as gridrender opens it for a GPU.
#pragma once

#include "renderer/tracer.h"
#include "tests/hostile_files.h"
#include "tests/tiny_scene.h"

namespace masu {

// Whether a tracer refuses a grid with a reference to a primitive that doesn't exist.
inline testing::AssertionResult is_refused_by_tracer(Device device) {
  const TemporaryFolder folder;
  const std::string scene_path = folder.file("good.scene"), grid_path = folder.file("hostile.grid");
  write_scene(tiny_scene(), Store::float32, scene_path);
  const SceneFile scene(scene_path, Checks::table);
  write_grid(tiny_merged_grid(), tiny_grid_origin(scene.geometry_hash()), grid_path);
  GridParts parts(grid_path);
  parts.set(fb::GridSection::references, 0, static_cast<std::uint32_t>(scene.primitive_count()));
  parts.write(grid_path);
  const auto open_and_render = [&](const std::string& path) {
    const GridFile grid(path, Checks::table);
    FrameRequest request;
    request.camera = scene.camera();
    static_cast<void>(Tracer(scene, &grid, device).render(request));
  };
  return is_refused(open_and_render, grid_path);
}

} // namespace masu
