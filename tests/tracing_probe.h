// Uses every kind of index in a scene and a grid, for tests with hostile files.
#pragma once

#include "libgrid/build/builder.h"
#include "libgrid/build/division.h"
#include "libgrid/file/grid_file.h"
#include "libscene/file/scene_file.h"
#include "renderer/tracer.h"

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
template <class Stored>
void build_a_little(const SceneFile& scene, Overlap overlap, GridKind kind, const std::string& path) {
  const SceneView<Stored> view = scene.view<Stored>();
  const GridLayout layout = make_grid_layout<Stored>(scene.bounds(), SpaceRule::tight,
                                                     parse_division("5x4x3"), division_statistics(view));
  GridOptions options;
  options.kind = kind;
  options.target = 1;
  write_grid(build_grid(view, layout, overlap, options),
             {scene.geometry_hash(), scene.primitive_count(), scene.origin(), SpaceRule::tight, overlap,
              "5x4x3", ""},
             path);
}
inline void build_a_little(const SceneFile& scene, Overlap overlap, GridKind kind, const std::string& path) {
  scene.is_float64() ? build_a_little<double>(scene, overlap, kind, path)
                     : build_a_little<float>(scene, overlap, kind, path);
}

} // namespace masu
