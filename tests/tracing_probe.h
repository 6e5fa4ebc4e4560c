// Uses every kind of index in a scene and a grid, for tests with hostile files.
#pragma once

#include "renderer/tracer.h"
#include "tests/grid_of_scene.h"

namespace masu {

// Renders a few pixels, without and with counters and the SPD's rules. grid: null for brute force.
inline void trace_a_little(const SceneFile& scene, const GridFile* grid) {
  const auto vector = [](const fb::Vec3& v) { return Vec3d{v.x(), v.y(), v.z()}; };
  const fb::Camera& c = *scene.table().camera();
  FrameRequest request;
  request.camera = {vector(c.from()), vector(c.at()), vector(c.up()), c.angle(), c.hither(), 6, 6};
  request.hits = request.hither = true;
  const Tracer tracer(scene, grid, Device::cpu);
  static_cast<void>(tracer.render(request));
  request.tracing.count = request.rules.spd_rules = true;
  static_cast<void>(tracer.render(request));
}

// Builds a coarse grid and writes it to `path`. Throws Error when the space can't be divided.
inline void build_a_little(const SceneFile& scene, Overlap overlap, GridKind kind, const std::string& path) {
  GridOptions options{kind};
  options.target = 1;
  write_grid_of(scene, "5x4x3", options, path, overlap);
}

} // namespace masu
