// Random scenes of placed meshes, and the same with all vertices written out.
#pragma once

#include <masu/masu.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

namespace masu {

using Matrix = std::array<double, 12>;

// What placements are like: how large the world is, and meshes in it.
struct PlacedKind {
  double extent = 10, center = 0; // of the world; how far it is from zero
  double least_scale = 0.1, most_scale = 10;
  double stretch = 1; // of one axis against the others
  bool are_quadrics_beside = false;
  masu_store store = MASU_STORE_FLOAT32;
  int worlds = 1;
  int meshes = 3, placements = 20, triangles = 60;
};

class PlacedScenes {
public:
  PlacedScenes(std::mt19937_64& engine, const PlacedKind& kind) : kind_(kind), engine_(engine) {
    for (int i = 0; i < kind.meshes; ++i) {
      std::vector<float>& vertices = meshes_.emplace_back();
      const double far = one_in(4) ? 20 : 0;
      for (int t = 0; t < 3 * kind.triangles; t += 3) {
        const std::array<double, 3> at{number(1) + far, number(1), number(1)};
        for (int corner = 0; corner < 3; ++corner)
          for (const double c : at)
            vertices.push_back(static_cast<float>(c + number(0.3)));
      }
      if (kind.triangles > 2) { // two alike, and one without a surface
        std::copy_n(vertices.begin(), 9, vertices.begin() + 9);
        std::copy_n(vertices.begin() + 18, 3, vertices.begin() + 21);
      }
    }
    for (int i = 0; i < kind.placements; ++i) {
      mesh_.push_back(static_cast<std::uint32_t>(engine_() % meshes_.size()));
      world_.push_back(kind.worlds > 1 && one_in(5)
                           ? MASU_EVERY_WORLD
                           : static_cast<std::uint32_t>(engine_() % static_cast<unsigned>(kind.worlds)));
      mask_.push_back(static_cast<std::uint32_t>(engine_() % 7));
      transforms.push_back(random_transform());
    }
    if (kind.placements > 1) { // the same twice: ties
      transforms[1] = transforms[0];
      mesh_[1] = mesh_[0];
      world_[1] = world_[0];
    }
    transforms.back() = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
    for (int i = 0; kind.are_quadrics_beside && i < 5; ++i) {
      for (int axis = 0; axis < 3; ++axis)
        spheres_.push_back(kind.center + number(kind.extent));
      spheres_.push_back(0.1 * kind.extent);
    }
  }

  Scene placed() const {
    std::vector<masu_mesh> meshes;
    for (const auto& vertices : meshes_)
      meshes.push_back(view(vertices));
    std::vector<masu_placement> placements;
    for (std::size_t i = 0; i < mesh_.size(); ++i)
      placements.push_back(placement(mesh_[i], transforms[i], world_[i], mask_[i]));
    auto geometry = geometry_of(meshes, spheres_, kind_.center);
    geometry.placements = placements.data();
    geometry.placement_count = placements.size();
    return Scene(geometry);
  }
  // Relative to the placed scene's origin: moved by center() there and back, rays and hits are the same.
  Scene written_out() const {
    return kind_.store == MASU_STORE_FLOAT64 ? written_out<double>() : written_out<float>();
  }
  double center() const { return kind_.center; }

  // From around the scene, between its parts, along axes, from one vertex towards another. Every other list
  // is of neighbours that are alike.
  std::vector<masu_ray64> rays(std::size_t count) {
    std::vector<masu_ray64> rays(count);
    are_alike_ = !are_alike_;
    for (std::size_t i = 0; i < count; ++i) {
      masu_ray64& ray = rays[i];
      if (are_alike_ && i % 60 != 0) {
        ray = rays[i - 1];
        const double size = std::hypot(ray.direction[0], ray.direction[1], ray.direction[2]);
        for (std::size_t axis = 0; axis < 3; ++axis) {
          ray.origin[axis] += number(1e-5 * kind_.extent);
          ray.direction[axis] += number(0.02 * size);
        }
        continue;
      }
      const double far = one_in(4) ? 20 : 1.2;
      const Point target = one_in(2) ? vertex() : point(1);
      const Point from = one_in(4) ? vertex() : point(far);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        ray.origin[axis] = from[axis];
        ray.direction[axis] = target[axis] - from[axis] + (one_in(2) ? 0 : number(1e-3 * kind_.extent));
        if (one_in(12)) ray.direction[axis] = 0;
      }
      ray.tmin = one_in(4) ? 0.1 : 0;
      ray.tmax = one_in(4) ? 1 : INFINITY;
    }
    return rays;
  }
  std::vector<std::array<double, 3>> places(std::size_t count) {
    std::vector<std::array<double, 3>> places(count);
    for (auto& place : places)
      place = one_in(3) ? vertex() : point(one_in(4) ? 20 : 1.2);
    return places;
  }
  std::vector<std::uint32_t> numbers(std::size_t count, std::uint32_t below) {
    std::vector<std::uint32_t> numbers(count);
    for (auto& each : numbers)
      each = static_cast<std::uint32_t>(engine_() % below);
    return numbers;
  }

  // By the written-out scene's numbers.
  std::uint32_t object_count() const {
    return static_cast<std::uint32_t>(mesh_.size() + (spheres_.empty() ? 0 : 1));
  }
  std::uint32_t triangles() const { return static_cast<std::uint32_t>(kind_.triangles); } // of any mesh
  std::uint32_t written_number(std::uint32_t object, std::uint32_t primitive) const {
    if (object == MASU_NONE) return MASU_NONE;
    return primitive + triangles() * std::min(object, static_cast<std::uint32_t>(mesh_.size()));
  }
  std::uint32_t mask_of(std::uint32_t object) const {
    return object < mask_.size() && mask_[object] != 0 ? mask_[object] : ~0U;
  }
  bool sees(std::uint32_t world, std::uint32_t object) const {
    return object >= world_.size() || world_[object] == world || world_[object] == MASU_EVERY_WORLD;
  }
  void move() {
    for (Matrix& transform : transforms)
      transform = random_transform();
  }

  std::vector<Matrix> transforms;

private:
  using Point = std::array<double, 3>;

  double number(double most) { return std::uniform_real_distribution<double>(-most, most)(engine_); }
  bool one_in(unsigned n) { return engine_() % n == 0; }
  Point point(double far) {
    Point point{};
    for (double& c : point)
      c = kind_.center + number(far * kind_.extent);
    return point;
  }
  Point vertex() {
    const std::size_t i = engine_() % mesh_.size();
    const auto& mesh = meshes_[mesh_[i]];
    const std::size_t v = engine_() % (mesh.size() / 3) * 3;
    Point point{};
    for (std::size_t row = 0; row < 3; ++row) {
      const double* const m = transforms[i].data() + 4 * row;
      point[row] = m[0] * mesh[v] + m[1] * mesh[v + 1] + m[2] * mesh[v + 2] + m[3];
    }
    return point;
  }
  Matrix random_transform() {
    // A rotation by a random quaternion, scaled along its axes; one in three is mirrored.
    std::normal_distribution<double> normal;
    double q[4], size = 0;
    for (double& part : q) {
      part = normal(engine_);
      size += part * part;
    }
    for (double& part : q)
      part /= std::sqrt(size);
    const double w = q[0], x = q[1], y = q[2], z = q[3];
    const double rotation[9] = {1 - 2 * (y * y + z * z), 2 * (x * y - w * z),     2 * (x * z + w * y),
                                2 * (x * y + w * z),     1 - 2 * (x * x + z * z), 2 * (y * z - w * x),
                                2 * (x * z - w * y),     2 * (y * z + w * x),     1 - 2 * (x * x + y * y)};
    const double scale = kind_.least_scale * std::pow(kind_.most_scale / kind_.least_scale,
                                                      std::uniform_real_distribution<double>(0, 1)(engine_));
    const double scales[3] = {one_in(3) ? -scale : scale, scale * kind_.stretch, scale};
    const bool is_turned = !one_in(4);
    Matrix transform{};
    for (std::size_t row = 0; row < 3; ++row) {
      for (std::size_t column = 0; column < 3; ++column)
        transform[4 * row + column] =
            (is_turned ? rotation[3 * row + column] : (row == column ? 1 : 0)) * scales[column];
      transform[4 * row + 3] = kind_.center + number(kind_.extent);
    }
    return transform;
  }
  template <class Stored>
  Scene written_out() const {
    std::vector<std::vector<double>> vertices;
    for (std::size_t i = 0; i < mesh_.size(); ++i) {
      const Matrix& m = transforms[i];
      std::vector<double>& placed = vertices.emplace_back();
      const auto& mesh = meshes_[mesh_[i]];
      for (std::size_t v = 0; v < mesh.size(); v += 3)
        for (std::size_t row = 0; row < 12; row += 4) {
          auto sum = static_cast<Stored>(m[row + 3] - kind_.center);
          for (const std::size_t column : {2, 1, 0})
            sum = std::fma(static_cast<Stored>(m[row + column]), static_cast<Stored>(mesh[v + column]), sum);
          placed.push_back(static_cast<double>(sum));
        }
    }
    std::vector<masu_mesh> meshes;
    for (const auto& placed : vertices)
      meshes.push_back(view(placed));
    std::vector<double> spheres = spheres_;
    for (std::size_t i = 0; i < spheres.size(); ++i)
      if (i % 4 != 3) spheres[i] -= kind_.center;
    return Scene(geometry_of(meshes, spheres, 0));
  }
  template <class Number>
  static masu_mesh view(const std::vector<Number>& vertices) {
    auto view = mesh(vertices, std::array<std::uint32_t, 0>{});
    view.indices = nullptr;
    view.triangle_count = vertices.size() / 9;
    return view;
  }
  masu_geometry geometry_of(const std::vector<masu_mesh>& meshes, const std::vector<double>& spheres,
                            double origin) const {
    origin_ = {origin, origin, origin};
    auto geometry = sized<masu_geometry>();
    geometry.meshes = meshes.data();
    geometry.mesh_count = meshes.size();
    geometry.store = kind_.store;
    geometry.origin = origin_.data();
    if (!spheres.empty()) {
      quadrics_ = sized<masu_quadrics>();
      quadrics_.values64 = spheres.data();
      quadrics_.count = spheres.size() / 4;
      geometry.spheres = &quadrics_;
      geometry.sphere_count = 1;
    }
    return geometry;
  }

  PlacedKind kind_;
  std::mt19937_64& engine_;
  std::vector<std::vector<float>> meshes_;
  std::vector<std::uint32_t> mesh_, world_, mask_;
  std::vector<double> spheres_;
  bool are_alike_ = false;
  mutable std::array<double, 3> origin_{};
  mutable masu_quadrics quadrics_{};
};

// All that queries find, in the written-out scene's numbers where these are given; by rays and places moved
// by -`by`, and moved back.
struct PlacedFound {
  std::vector<float> t, uv, normal, shading;
  std::vector<double> t64, position, row_position, distance, points;
  std::vector<std::uint32_t> primitive, object, counts, row_primitive, closest, closest_object;
  std::vector<std::uint8_t> front, occluded, inside, row_front;
  std::vector<double> rows;

  bool operator==(const PlacedFound&) const = default;
};
inline constexpr std::uint32_t row_limit = 20;

inline PlacedFound found_by(const Tracer& tracer, std::vector<masu_ray64> rays,
                            std::vector<std::array<double, 3>> places, const QueryOptions& options,
                            const PlacedScenes* numbers_of, double by = 0) {
  const std::size_t n = rays.size();
  for (masu_ray64& ray : rays)
    for (double& c : ray.origin)
      c -= by;
  for (auto& place : places)
    for (double& c : place)
      c -= by;
  const auto room = [](auto& values, std::size_t count) {
    values.resize(count);
    return values.data();
  };
  PlacedFound found;
  auto hits = sized<masu_hits>(), sided = hits, rows = hits, closest = hits;
  hits.t = room(found.t, n);
  hits.uv = room(found.uv, 2 * n);
  hits.normal = room(found.normal, 3 * n);
  hits.shading = room(found.shading, 3 * n);
  hits.position = room(found.position, 3 * n);
  hits.primitive = room(found.primitive, n);
  hits.object = room(found.object, n);
  tracer.nearest(rays.data(), n, hits, options);
  tracer.occluded(rays.data(), n, room(found.occluded, n), options);
  sided.t64 = room(found.t64, n);
  sided.front = room(found.front, n);
  tracer.nearest(rays.data(), n, sided, options);
  std::vector<std::uint32_t> row_object, row_counts(n);
  rows.t64 = room(found.rows, row_limit * n);
  rows.position = room(found.row_position, 3 * row_limit * n);
  rows.primitive = room(found.row_primitive, row_limit * n);
  rows.object = room(row_object, row_limit * n);
  rows.front = room(found.row_front, row_limit * n);
  tracer.all_hits(rays.data(), n, row_limit, rows, row_counts.data(), options);
  tracer.count_hits(rays.data(), n, room(found.counts, n), options);
  for (std::size_t i = 0; i < n; ++i)
    EXPECT_EQ(row_counts[i], std::min(found.counts[i], row_limit));
  tracer.inside(rays.data(), n, room(found.inside, n), options);
  if (const std::size_t m = places.size(); m > 0) {
    closest.t64 = room(found.distance, m);
    closest.primitive = room(found.closest, m);
    closest.object = room(found.closest_object, m);
    tracer.closest(places.data(), m, closest, room(found.points, 3 * m), options);
  }
  if (numbers_of != nullptr) {
    const auto renumber = [&](auto& primitives, const auto& objects) {
      for (std::size_t i = 0; i < primitives.size(); ++i)
        primitives[i] = numbers_of->written_number(objects[i], primitives[i]);
    };
    renumber(found.primitive, found.object);
    renumber(found.row_primitive, row_object);
    renumber(found.closest, found.closest_object);
  }
  for (auto* const points : {&found.position, &found.row_position, &found.points})
    for (double& c : *points)
      c = std::isnan(c) ? -1 : c + by; // which equals itself
  return found;
}

inline void expect_same(const PlacedFound& a, const PlacedFound& b) {
  EXPECT_EQ(a.t, b.t);
  EXPECT_EQ(a.uv, b.uv);
  EXPECT_EQ(a.normal, b.normal);
  EXPECT_EQ(a.shading, b.shading);
  EXPECT_EQ(a.position, b.position);
  EXPECT_EQ(a.t64, b.t64);
  EXPECT_EQ(a.front, b.front);
  EXPECT_EQ(a.primitive, b.primitive);
  EXPECT_EQ(a.object, b.object);
  EXPECT_EQ(a.occluded, b.occluded);
  EXPECT_EQ(a.counts, b.counts);
  EXPECT_EQ(a.inside, b.inside);
  EXPECT_EQ(a.rows, b.rows);
  EXPECT_EQ(a.row_position, b.row_position);
  EXPECT_EQ(a.row_primitive, b.row_primitive);
  EXPECT_EQ(a.row_front, b.row_front);
  EXPECT_EQ(a.distance, b.distance);
  EXPECT_EQ(a.points, b.points);
  EXPECT_EQ(a.closest, b.closest);
  EXPECT_EQ(a.closest_object, b.closest_object);
}

inline std::vector<PlacedKind> placed_kinds() {
  return {{},
          {.least_scale = 1e-3, .most_scale = 1e3},
          {.extent = 1e7, .most_scale = 1e6},
          {.center = 1e7},
          {.extent = 100, .stretch = 1e4},
          {.stretch = 1e-4},
          {.stretch = 1e4, .store = MASU_STORE_FLOAT64},
          {.extent = 3, .are_quadrics_beside = true},
          {.least_scale = 1, .placements = 700, .triangles = 12},
          {.stretch = 100, .placements = 8, .triangles = 3000}}; // of hierarchies with several levels
}

} // namespace masu
