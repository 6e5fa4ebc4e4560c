// A grid that is checked only while it is brought to where it is traced, as gridrender has it on a GPU.
#pragma once

#include "renderer/backend.h"
#include "tests/hostile_files.h"
#include "tests/tiny_scene.h"

namespace masu {

// Whether render(scene, grid, request) refuses a grid that lists a primitive which isn't there.
template <class Render>
testing::AssertionResult is_refused_while_rendering(const Render& render) {
  const TemporaryFolder folder;
  const std::string scene_path = folder.file("good.scene"), grid_path = folder.file("hostile.grid");
  write_scene(tiny_scene(), Store::float32, scene_path);
  const SceneFile scene(scene_path, Checks::table);
  write_grid(tiny_merged_grid(), tiny_grid_origin(scene.hash()), grid_path);
  GridParts parts(grid_path);
  parts.set(fb::GridSection::references, 0, static_cast<std::uint32_t>(scene.primitive_count()));
  parts.write(grid_path);
  const auto open_and_render = [&](const std::string& path) {
    const GridFile grid(path, Checks::table);
    FrameRequest request;
    request.camera = scene.camera();
    request.before_tracing = [&] { check_records(scene, &grid); };
    render(scene, &grid, request);
  };
  return is_refused(open_and_render, grid_path);
}

} // namespace masu
