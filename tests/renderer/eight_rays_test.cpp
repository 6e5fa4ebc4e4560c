// Rays made ready eight at a time, and triangles tested several at a time, give the bits that one ray gives
// that tries one primitive after the other.
#include "libscene/base/portable.h"

#ifdef MASU_HOST_AVX2
#include "renderer/cpu/eight_rays.h"
#endif

#include "tests/random_grid.h"
#include "tests/random_ray.h"
#include "tests/random_scene.h"
#include "tests/random_test.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>

namespace masu {
namespace {

using RaysByEight = RandomTest;

#ifdef MASU_HOST_AVX2

// As callers may store it: of any length, and sometimes not valid.
Ray<float> any_ray(Chance& chance, Ray<float> ray) {
  if (chance.one_in(3)) ray.direction = ray.direction * static_cast<float>(chance.power_of_two(-60, 60));
  if (chance.one_in(6)) ray.t_min = static_cast<float>(chance.power_of_two(-30, 10) * chance.sign());
  if (chance.one_in(6)) ray.t_max = static_cast<float>(chance.power_of_two(-30, 30));
  if (!chance.one_in(12)) return ray;
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  const auto odd = static_cast<float>(chance.one_of({0.0, 1e20, -1e20, static_cast<double>(INFINITY), 1.0}));
  const float value = chance.one_in(3) ? nan : odd;
  switch (chance.whole(0, 4)) {
  case 0:
    ray.origin.set(chance.whole(0, 2), value);
    break;
  case 1:
    ray.direction.set(chance.whole(0, 2), value);
    break;
  case 2:
    ray.direction = {value, value, value};
    break;
  case 3:
    ray.t_min = value;
    break;
  default:
    ray.t_max = value;
  }
  return ray;
}

struct Tally {
  std::int64_t hits = 0, different = 0;
  std::string first;
};

template <Query query, class M>
void compare(const TestScene<float>& scene, const SceneView<float>& view, const Grid& grid,
             const std::array<Ray<float>, EightRays::count>& rays, Tally& tally) {
  EightRays eight;
  eight.load(rays.data(), own_format<float>, 0);
  eight.prepare(view.clip);
  trace_eight<query, M>(
      view, hierarchy_view_of<float>(grid), eight, [&](std::size_t i, const Hit<float>& found) {
        NoCounts counts;
        const Hit<float> expected = trace_listed<query, M>(view, NoGrid{}, rays[i], counts);
        tally.hits += expected.primitive != no_primitive;
        const bool same = found.primitive == expected.primitive &&
                          (query == Query::occlusion || same_bits(found.t, expected.t));
        if (same || ++tally.different > 1) return;
        const Ray<float>& ray = rays[i];
        tally.first = described(ray.origin, ray.direction) + " t_min " + described(ray.t_min) + " t_max " +
                      described(ray.t_max) + ": " + described(found) + ", expected " + described(expected) +
                      '\n' + described(scene);
      });
}

template <unsigned kinds>
void compare_scenes(std::int64_t scenes, Chance& chance, Tally& tally) {
  using M = Method<WatertightRay<float>, kinds>;
  for (std::int64_t s = scenes; s > 0; --s) {
    TestScene<float> scene = SceneMaker<float>(chance, chance.power_of_two(-10, 20)).scene();
    if constexpr (kinds == with_triangles) {
      scene.spheres.clear();
      scene.cones.clear();
    }
    if (scene.count() == 0) continue;
    const Grid grid = hierarchy_of(scene);
    const SceneView<float> view = scene.view();
    const Boxd bounds = scene.bounds();
    RayMaker<float> maker(chance, scene, bounds, grid);
    for (int i = 0; i < 30; ++i) {
      std::array<Ray<float>, EightRays::count> rays;
      for (Ray<float>& ray : rays)
        ray = any_ray(chance, maker.ray());
      compare<Query::nearest_hit, M>(scene, view, grid, rays, tally);
      compare<Query::occlusion, M>(scene, view, grid, rays, tally);
    }
  }
}

TEST_F(RaysByEight, HitTheTrianglesThatOneRayHits) {
  Tally tally;
  compare_scenes<with_triangles>(cases(2000), chance_, tally);
  EXPECT_EQ(tally.different, 0) << tally.first;
  EXPECT_GT(tally.hits, cases(40'000));
}

TEST_F(RaysByEight, HitThePrimitivesOfAnyKindThatOneRayHits) {
  Tally tally;
  compare_scenes<with_all_kinds>(cases(1000), chance_, tally);
  EXPECT_EQ(tally.different, 0) << tally.first;
  EXPECT_GT(tally.hits, cases(20'000));
}

#else

TEST_F(RaysByEight, HitTheTrianglesThatOneRayHits) {
  GTEST_SKIP() << "built without AVX2: rays are prepared one at a time";
}

#endif

} // namespace
} // namespace masu
