// Lists of rays in float64 from far away: every query, through every structure, has the hits of `double`.
#include "renderer/rays/walk_report.h"
#include "tests/random_test.h"
#include "tests/rendering.h"
#include "tests/scene_builder.h"
#include "tests/tiny_scene.h"

#include <algorithm>
#include <cmath>

namespace masu {
namespace {

using FarList = RandomTest;

// Triangles of about a tenth of the scene, which is of size 2, somewhere in the world.
Scene scattered(Chance& chance, const Vec3d& at, int count) {
  Scene scene = empty_scene(at + Vec3d{0, 0, 5}, at);
  for (int i = 0; i < count; ++i) {
    const Vec3d middle = at + chance.in_cube(1);
    const auto corner = [&] { return middle + chance.in_cube(0.1); };
    add_triangle(scene, corner(), corner(), corner(), matte({1, 1, 1}));
  }
  return scene;
}

// How far from its edges a ray sees the middle of a triangle: little where it comes in flat.
double seen_inside(const SceneTriangle& t, const Vec3d& direction) {
  const double longest = std::max({length(t.b - t.a), length(t.c - t.b), length(t.a - t.c)});
  return std::abs(dot(cross(t.b - t.a, t.c - t.a), normalized(direction))) / (3 * longest);
}

// From `distance` away into the scene; half aim at the middle of a triangle of their own.
std::vector<Ray<double>> rays_at(Chance& chance, const Scene& scene, const Vec3d& at, double distance,
                                 std::size_t count) {
  std::vector<Ray<double>> rays;
  for (std::size_t i = 0; i < count; ++i) {
    const SceneTriangle& t = scene.triangles[i % scene.triangles.size()];
    const Vec3d target = i % 2 == 0 ? (t.a + t.b + t.c) * (1.0 / 3) : at + chance.in_cube(1.2);
    const Vec3d origin = at + chance.direction() * (distance * chance.uniform(0.5, 1));
    rays.push_back(unbounded_ray(origin, (target - origin) * chance.power_of_two(-3, 3)));
  }
  return rays;
}

// What is found of each ray.
struct Found {
  std::vector<float> t, u;
  std::vector<double> t64;
  std::vector<std::uint32_t> primitive;
};
Found found(const ResidentTracer& tracer, const std::vector<Ray<double>>& rays, const RaysRequest& request,
            bool with_t64) {
  Found found;
  found.t.resize(rays.size());
  found.u.resize(2 * rays.size());
  found.t64.resize(rays.size());
  found.primitive.resize(rays.size());
  RayResults results;
  results.t = found.t.data();
  results.uv = reinterpret_cast<float(*)[2]>(found.u.data());
  results.primitive = found.primitive.data();
  if (with_t64) results.t64 = found.t64.data();
  tracer.trace(RayList(rays), results, request);
  return found;
}

TEST_F(FarList, HasTheHitsOfDoubleFromAnyDistance) {
  std::size_t hits = 0;
  for (int i = 0; i < cases(12); ++i) {
    const Vec3d at = chance_.one_in(2) ? Vec3d{0, 0, 0} : chance_.in_cube(chance_.power_of_two(0, 24));
    const double distance = chance_.power_of_two(2, 34);
    const Scene scene = scattered(chance_, at, 40);
    const Rendering built(
        scene, Store::float32, "auto",
        {chance_.one_of({StructureKind::uniform, StructureKind::hierarchy, StructureKind::irregular})});
    SCOPED_TRACE(testing::Message() << distance << " from " << at.x << ' ' << at.y << ' ' << at.z);
    const std::vector<Ray<double>> rays = rays_at(chance_, scene, at, distance, 400);
    const ResidentTracer tracer = built.tracer(), brute = built.tracer(Device::cpu, false);
    RaysRequest request;
    const Found nearest = found(tracer, rays, request, false), with_t64 = found(tracer, rays, request, true);
    EXPECT_TRUE(same_values(nearest.t, with_t64.t));
    EXPECT_TRUE(same_values(nearest.primitive, with_t64.primitive));
    EXPECT_TRUE(same_values(nearest.u, with_t64.u));
    const Found by_brute_force = found(brute, rays, request, false);
    EXPECT_TRUE(same_values(nearest.t, by_brute_force.t));
    EXPECT_TRUE(same_values(nearest.primitive, by_brute_force.primitive));

    RaysRequest in_double = request;
    in_double.tracing.precision = Precision::doubled;
    const Found exact = found(tracer, rays, in_double, true);
    const double bound = rounding_margin<float>(built.scene().bounds());
    std::size_t differ = 0;
    for (std::size_t k = 0; k < rays.size(); ++k) {
      EXPECT_EQ(nearest.t[k], static_cast<float>(with_t64.t64[k]));
      hits += nearest.primitive[k] != no_primitive;
      const bool aimed =
          k % 2 == 0 && seen_inside(scene.triangles[k % scene.triangles.size()], rays[k].direction) > bound;
      EXPECT_TRUE(!aimed || nearest.primitive[k] != no_primitive) << k;
      if (nearest.primitive[k] != exact.primitive[k]) { // at an edge, or of two at nearly the same t
        ++differ;
        continue;
      }
      if (nearest.primitive[k] == no_primitive) continue;
      const SceneTriangle& t = scene.triangles[nearest.primitive[k]];
      const Vec3d n = normalized(cross(t.b - t.a, t.c - t.a)), d = rays[k].direction;
      // Across the triangle's plane; and roundings of t itself.
      EXPECT_LE(std::abs((with_t64.t64[k] - exact.t64[k]) * dot(n, d)),
                bound + 8 * RealTraits<double>::unit_roundoff * exact.t64[k] * length(d));
    }
    EXPECT_LE(differ, 2U);

    // All hits, their number, whether there is any, and a walk agree.
    constexpr std::uint32_t limit = 4;
    std::vector<double> rows(limit * rays.size());
    std::vector<std::uint32_t> counts(rays.size());
    std::vector<std::uint8_t> occluded(rays.size());
    RayResults all, any;
    all.t64 = rows.data();
    all.count = counts.data();
    request.query = Query::all_hits;
    request.limit = limit;
    tracer.trace(RayList(rays), all, request);
    any.occluded = occluded.data();
    request.query = Query::occlusion;
    tracer.trace(RayList(rays), any, request);
    for (std::size_t k = 0; k < rays.size(); ++k) {
      const bool hit = nearest.primitive[k] != no_primitive;
      EXPECT_EQ(counts[k] > 0, hit);
      EXPECT_EQ(occluded[k] != 0, hit);
      EXPECT_TRUE(same_values(std::vector{rows[limit * k]}, std::vector{with_t64.t64[k]}));
      for (std::uint32_t j = 1; j < limit; ++j)
        EXPECT_GE(rows[limit * k + j], rows[limit * k + j - 1]);
    }
    for (std::size_t k = 0; k < rays.size(); k += 37) {
      WalkRequest walk;
      walk.ray = rays[k];
      const WalkReport report = trace_walk(tracer, walk);
      EXPECT_EQ(report.rays.at(0).t, nearest.t[k]);
      EXPECT_EQ(report.rays.at(0).primitive, nearest.primitive[k]);
      if (nearest.primitive[k] == no_primitive) continue;
      const WalkStep& first = report.rays.at(0).steps.at(0);
      EXPECT_LE(first.enter, static_cast<double>(nearest.t[k]) * (1 + 1e-6));
      EXPECT_GE(first.enter * length(rays[k].direction), distance * 0.4 - 4);
    }
  }
  EXPECT_GT(hits, static_cast<std::size_t>(cases(12)) * 200);
}

} // namespace
} // namespace masu
