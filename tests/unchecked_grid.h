// Damaged grids, as gridrender opens them for a device.
#pragma once

#include "renderer/tracer/tracer.h"
#include "tests/hostile_files.h"
#include "tests/tracing_probe.h"

namespace masu {

// Whether a grid with a reference to a primitive that doesn't exist is refused before it is traced.
inline testing::AssertionResult is_refused_by_tracer(Device device) {
  const Residence residence = device == Device::cuda ? Residence::file : Residence::mapping;
  const TemporaryFolder folder;
  const std::string scene_path = folder.file("good.scene"), grid_path = folder.file("hostile.grid");
  write_scene(tiny_scene(), Store::float32, scene_path);
  const SceneFile scene(scene_path, residence);
  write_structure(tiny_merged_grid(), tiny_grid_provenance(scene.geometry_hash()), grid_path);
  GridParts parts(grid_path);
  parts.set(fb::StructureSection::references, 0, static_cast<std::uint32_t>(scene.primitive_count()));
  parts.write(grid_path);
  const auto open_and_render = [&](const std::string& path) {
    const StructureFile grid(path, residence);
    FrameRequest request;
    request.camera = scene.camera();
    static_cast<void>(ResidentTracer(scene, &grid, device).render(request));
  };
  return is_refused(open_and_render, grid_path);
}

struct OpenedAndRefused {
  int opened = 0, refused = 0;
};

// Opens the grid with its file as `parts` are, and traces what opens.
inline void open_and_trace(const GridParts& parts, const SceneFile& scene, const std::string& path,
                           OpenedAndRefused& count) {
  parts.write(path);
  try {
    const StructureFile grid(path);
    ++count.opened;
    trace_a_little(scene, &grid);
  } catch (const Error& error) {
    ++count.refused;
    ASSERT_EQ(error.code(), ErrorCode::input) << error.what();
    ASSERT_EQ(error.place(), path);
  }
}

// With any bit of its sections flipped.
inline OpenedAndRefused with_any_flipped_bit(const Structure& grid, const std::string& merge_rule) {
  const TemporaryFolder folder;
  const std::string scene_path = folder.file("scene"), path = folder.file("grid");
  write_scene(tiny_scene(), Store::float32, scene_path);
  const SceneFile scene(scene_path);
  write_structure(grid, tiny_grid_provenance(scene.geometry_hash(), merge_rule), path);
  const GridParts parts(path);
  OpenedAndRefused count;
  for (std::size_t section = 0; section < parts.sections.size(); ++section) {
    for (std::size_t bit = 0; bit < 8 * parts.sections[section].bytes.size(); ++bit) {
      GridParts spoilt = parts;
      spoilt.sections[section].bytes[bit / 8] ^= static_cast<std::uint8_t>(1U << (bit % 8));
      open_and_trace(spoilt, scene, path, count);
    }
  }
  return count;
}

} // namespace masu
