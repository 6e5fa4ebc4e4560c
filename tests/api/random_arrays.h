// Random meshes and rays as arrays of the C interface.
#pragma once

#include "tests/seeded_test.h"

#include <masu/masu.hpp>

#include <algorithm>
#include <array>
#include <limits>
#include <random>
#include <span>
#include <vector>

namespace masu {

inline constexpr float infinity = std::numeric_limits<float>::infinity(),
                       not_a_number = std::numeric_limits<float>::quiet_NaN();

struct ArrayMesh {
  std::vector<float> vertices;
  std::vector<std::uint32_t> indices;

  masu_mesh view() const { return mesh(vertices, indices); }
  Scene scene() const { return Scene(vertices, indices); }
};

inline masu_geometry geometry_of(std::span<const masu_mesh> meshes) {
  auto geometry = sized<masu_geometry>();
  geometry.meshes = meshes.data();
  geometry.mesh_count = meshes.size();
  return geometry;
}

inline masu_quadrics quadrics_of(std::span<const float> values, std::size_t count = 1) {
  auto quadrics = sized<masu_quadrics>();
  quadrics.values = values.data();
  quadrics.count = count;
  return quadrics;
}

inline Grid built(const Scene& scene, masu_structure structure, masu_quality quality = MASU_QUALITY_HIGH) {
  auto options = default_build_options();
  options.structure = structure;
  options.quality = quality;
  return Grid(scene, options);
}
inline Grid hierarchy_of(const Scene& scene, masu_quality quality = MASU_QUALITY_HIGH) {
  return built(scene, MASU_STRUCTURE_BVH, quality);
}
inline Tracer brute_force(const Scene& scene) {
  return {scene, nullptr, {}, true};
}

// Calls act(list, format) with the rays in every format; `more`: added to doubles, which floats haven't.
template <class Act>
void in_every_format(const std::vector<masu_ray>& rays, const Act& act, double more = 0) {
  std::vector<masu_ray64> doubles;
  std::vector<std::array<float, 6>> six;
  std::vector<std::array<double, 6>> six_doubles;
  for (const masu_ray& ray : rays) {
    const auto [x, y, z] = ray.origin;
    const auto [dx, dy, dz] = ray.direction;
    doubles.push_back({{x + more, y, z}, ray.tmin, {dx, dy, dz}, ray.tmax});
    six.push_back({x, y, z, dx, dy, dz});
    six_doubles.push_back({x, y, z, dx, dy, dz + more});
  }
  act(rays, MASU_RAYS_FLOAT32);
  act(doubles, MASU_RAYS_FLOAT64);
  act(six, MASU_RAYS_FLOAT32_6);
  act(six_doubles, MASU_RAYS_FLOAT64_6);
}

class RandomArrays : public SeededTest {
protected:
  float coordinate() { return std::uniform_real_distribution<float>(-1, 1)(engine_); }

  // Separate triangles in a cube from -1 to 1: of that size against it.
  ArrayMesh random_mesh(std::uint32_t triangles, float size = 1) {
    ArrayMesh mesh;
    for (std::uint32_t i = 0; i < 3 * triangles; ++i) {
      if (i % 3 == 0) std::ranges::generate(center_, [&] { return coordinate(); });
      for (const float c : center_)
        mesh.vertices.push_back((1 - size) * c + size * coordinate());
      mesh.indices.push_back(i);
    }
    return mesh;
  }

  // From so far away at most; some of them begin late, or are short.
  std::vector<masu_ray> random_rays(std::size_t count, float far = 2) {
    std::vector<masu_ray> rays(count);
    for (masu_ray& ray : rays) {
      for (int axis = 0; axis < 3; ++axis) {
        ray.origin[axis] = far * coordinate();
        ray.direction[axis] = coordinate();
      }
      ray.tmin = std::max(coordinate(), 0.0F);
      ray.tmax = engine_() % 2 == 0 ? infinity : 1 + coordinate();
    }
    return rays;
  }

  std::mt19937_64 engine_ = seed_.engine();

private:
  float center_[3]{};
};

} // namespace masu
