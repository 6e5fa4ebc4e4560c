// A damaged grid, as gridrender opens it for a device.
#pragma once

#include "renderer/tracer.h"
#include "tests/hostile_files.h"
#include "tests/tiny_scene.h"

namespace masu {

// Whether a grid with a reference to a primitive that doesn't exist is refused before it is traced.
inline testing::AssertionResult is_refused_by_tracer(Device device) {
  const Residence residence = device == Device::cuda ? Residence::file : Residence::mapping;
  const TemporaryFolder folder;
  const std::string scene_path = folder.file("good.scene"), grid_path = folder.file("hostile.grid");
  write_scene(tiny_scene(), Store::float32, scene_path);
  const SceneFile scene(scene_path, residence);
  write_grid(tiny_merged_grid(), tiny_grid_provenance(scene.geometry_hash()), grid_path);
  GridParts parts(grid_path);
  parts.set(fb::GridSection::references, 0, static_cast<std::uint32_t>(scene.primitive_count()));
  parts.write(grid_path);
  const auto open_and_render = [&](const std::string& path) {
    const GridFile grid(path, residence);
    FrameRequest request;
    request.camera = scene.camera();
    static_cast<void>(Tracer(scene, &grid, device).render(request));
  };
  return is_refused(open_and_render, grid_path);
}

} // namespace masu
