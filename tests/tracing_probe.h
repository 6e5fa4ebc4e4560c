// Uses every kind of index in a scene and a grid, for tests with hostile files.
#pragma once

#include "renderer/tracer/tracer.h"
#include "tests/grid_of_scene.h"

#include <cmath>
#include <vector>

namespace masu {

// Rays from the camera, alike, or from places around what it looks at, each another way: lists of either kind
// are traced differently, eight rays at a time and the last few one by one.
inline std::vector<Ray<double>> a_few_rays(const Vec3d& from, const Vec3d& at, bool alike) {
  const double size = largest_magnitude(at - from);
  std::vector<Ray<double>> rays;
  for (int i = 0; i < 45; ++i) {
    const Vec3d any{std::sin(1.0 + i), std::sin(2.0 + 3 * i), std::sin(3.0 + 7 * i)};
    const Vec3d origin = alike ? from : at + any * (size / 4),
                toward = alike ? at + any * (size / 32) : at - Vec3d{any.y, any.z, any.x} * (size / 8);
    rays.push_back(unbounded_ray(origin, toward - origin));
  }
  return rays;
}

// Renders a few pixels, without and with counters and the SPD's rules, and traces lists of rays. grid: null
// for brute force.
inline void trace_a_little(const SceneFile& scene, const StructureFile* grid) {
  const auto vector = [](const fb::Vec3& v) { return Vec3d{v.x(), v.y(), v.z()}; };
  const fb::Camera& c = *scene.table().camera();
  FrameRequest request;
  request.camera = {vector(c.from()), vector(c.at()), vector(c.up()), c.angle(), c.hither(), 6, 6};
  request.hits = request.hither = true;
  const ResidentTracer tracer(scene, grid, Device::cpu);
  static_cast<void>(tracer.render(request));
  request.tracing.count = request.rules.spd_rules = true;
  static_cast<void>(tracer.render(request));
  for (const bool alike : {true, false}) {
    const std::vector<Ray<double>> rays = a_few_rays(request.camera.from, request.camera.at, alike);
    for (const Query query : {Query::nearest_hit, Query::occlusion}) {
      RaysRequest of_list;
      of_list.query = query;
      static_cast<void>(tracer.hits(rays, of_list, HitName::object));
    }
  }
}

// Builds a coarse grid and writes it to `path`. Throws Error when the space can't be divided.
inline void build_a_little(const SceneFile& scene, Overlap overlap, StructureKind kind,
                           const std::string& path) {
  StructureOptions options{kind};
  options.target = 1;
  write_grid_of(scene, "5x4x3", options, path, overlap);
}

} // namespace masu
