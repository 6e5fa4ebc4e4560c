// Rays made ready several at a time, eight in float32 and four in float64, that walk one after the other, as
// packets or in step, and whose triangles are tested as many at a time, give the bits that one ray gives that
// tries one primitive after the other.
#include "libscene/base/portable.h"

#ifdef MASU_HOST_AVX2
#include "renderer/cpu/pixel_lists.h"
#endif

#include "tests/random_grid.h"
#include "tests/random_ray.h"
#include "tests/random_scene.h"
#include "tests/random_test.h"

#include <limits>
#include <vector>

namespace masu {
namespace {

using RaysByEight = RandomTest;

#ifdef MASU_HOST_AVX2

// As callers may store it: of any length, and sometimes not valid.
template <class Real>
Ray<Real> any_ray(Chance& chance, Ray<Real> ray) {
  if (chance.one_in(3)) ray.direction = ray.direction * static_cast<Real>(chance.power_of_two(-60, 60));
  if (chance.one_in(6)) ray.t_min = static_cast<Real>(chance.power_of_two(-30, 10) * chance.sign());
  if (chance.one_in(6)) ray.t_max = static_cast<Real>(chance.power_of_two(-30, 30));
  if (chance.one_in(6)) ray.t_max = static_cast<Real>(INFINITY);
  if (!chance.one_in(12)) return ray;
  constexpr Real nan = std::numeric_limits<Real>::quiet_NaN();
  const auto odd = static_cast<Real>(chance.one_of({0.0, 1e20, -1e20, static_cast<double>(INFINITY), 1.0}));
  const Real value = chance.one_in(3) ? nan : odd;
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

// In lengths of the direction, with all digits.
template <class M, class Stored, class Real>
Hit<Real> hit_alone(const SceneView<Stored>& view, Ray<Real> ray) {
  const Real scale = scale_direction(ray);
  NoCounts counts;
  const Hit<Real> hit = nearest_hit<M>(view, NoStructure{}, ray, counts);
  return hit.primitive == no_primitive ? no_hit<Real>() : Hit<Real>{hit.t * scale, hit.primitive};
}

template <Query query, class M, class Stored, class Real>
void compare(const TestScene<Stored>& scene, const SceneView<Stored>& view, const Structure& grid,
             const std::vector<Ray<Real>>& rays, std::size_t first, std::int64_t& hits) {
  const auto check = [&](std::size_t i, const ListedHit<Real>& listed) {
    const Ray<Real>& ray = rays.at(i);
    NoCounts counts;
    const Hit<float> short_hit = reported(listed),
                     expected_short = trace_listed<query, M>(view, NoStructure{}, ray, counts);
    hits += short_hit.primitive != no_primitive;
    const Hit<Real> expected = hit_alone<M>(view, ray),
                    found{(listed.near.t + listed.skipped) * listed.scale, listed.near.primitive};
    EXPECT_TRUE(found.primitive == no_primitive || query == Query::occlusion ||
                (ray.t_min < found.t && found.t < ray.t_max))
        << described(found);
    EXPECT_TRUE(short_hit.primitive == expected_short.primitive &&
                (query == Query::occlusion ||
                 (found.primitive == expected.primitive && same_bits(found.t, expected.t) &&
                  same_bits(short_hit.t, expected_short.t))))
        << described(ray.origin, ray.direction) << " t_min " << described(ray.t_min) << " t_max "
        << described(ray.t_max) << ": " << described(found) << ", expected " << described(expected) << '\n'
        << described(scene);
  };
  const auto hierarchy = hierarchy_view_of<Real>(grid);
  const auto trace_all = [&](const auto& trace) {
    std::vector<int> times(rays.size());
    const std::size_t end = trace(view, hierarchy, rays.data(), own_format<Real>, first, rays.size(),
                                  [&](std::size_t i, const ListedHit<Real>& found) {
                                    ++times.at(i);
                                    check(i, found);
                                  });
    EXPECT_LT(rays.size() - end, RayLanes<Real>::count);
    for (std::size_t i = 0; i < rays.size(); ++i)
      EXPECT_EQ(times[i], i >= first && i < end ? 1 : 0);
  };
  trace_all([](const auto&... all) { return trace_in_turn<query, M>(all...); });
  trace_all([](const auto&... all) { return trace_packets<query, M>(all...); });
  trace_all([](const auto&... all) { return trace_in_step<query, M>(all...); });
}

// Returns how many rays hit something.
template <class Real, class Stored, unsigned kinds>
std::int64_t compare_scenes(std::int64_t scenes, Chance& chance) {
  using M = Method<WatertightRay<Real>, kinds>;
  std::int64_t hits = 0;
  for (std::int64_t s = scenes; s > 0 && !testing::Test::HasFailure(); --s) {
    TestScene<Stored> scene = SceneMaker<Stored>(chance, chance.power_of_two(-10, 20)).scene();
    if constexpr (kinds == with_triangles) {
      scene.spheres.clear();
      scene.cones.clear();
    }
    if (scene.count() == 0) continue;
    const Structure grid = hierarchy_of(scene);
    const SceneView<Stored> view = scene.view();
    const Boxd bounds = scene.bounds();
    const auto aimed_at = converted<Real>(scene);
    RayMaker<Real> maker(chance, aimed_at, bounds, grid);
    // As many as take each other's places, or too few for that.
    std::vector<Ray<Real>> rays(static_cast<std::size_t>(chance.one_in(2) ? chance.whole(0, 40) : 240));
    const bool alike = chance.one_in(2); // but for those that aren't valid
    for (std::size_t i = 0; i < rays.size(); ++i) {
      Ray<Real> ray = maker.ray();
      if (alike && i % 32 != 0) {
        const Ray<Real>& other = rays[i - 1];
        const auto moved = [&](const Vec3<Real>& from, const Vec3<Real>& to) {
          return fma(to - from, static_cast<Real>(chance.power_of_two(-20, -4)), from);
        };
        ray = {moved(other.origin, ray.origin), other.t_min, moved(other.direction, ray.direction),
               other.t_max};
      }
      rays[i] = alike && !chance.one_in(40) ? ray : any_ray(chance, ray);
    }
    for (Ray<Real>& ray : rays) { // limits at hits
      if (!chance.one_in(4)) continue;
      const Hit<Real> hit = hit_alone<M>(view, ray);
      if (hit.primitive == no_primitive) continue;
      const Real t = chance.one_in(2) ? hit.t : chance.one_in(2) ? next_above(hit.t) : next_below(hit.t);
      (chance.one_in(2) ? ray.t_min : ray.t_max) = t;
    }
    const auto first = std::min(rays.size(), static_cast<std::size_t>(chance.whole(0, 9)));
    compare<Query::nearest_hit, M>(scene, view, grid, rays, first, hits);
    compare<Query::occlusion, M>(scene, view, grid, rays, first, hits);
  }
  return hits;
}

TEST_F(RaysByEight, HitTheTrianglesThatOneRayHits) {
  EXPECT_GT((compare_scenes<float, float, with_triangles>(cases(2000), chance_)), cases(40'000));
}
TEST_F(RaysByEight, HitThePrimitivesOfAnyKindThatOneRayHits) {
  EXPECT_GT((compare_scenes<float, float, with_all_kinds>(cases(1000), chance_)), cases(20'000));
}
TEST_F(RaysByEight, HitInFloat64TheTrianglesThatOneRayHits) {
  EXPECT_GT((compare_scenes<double, float, with_triangles>(cases(1000), chance_)), cases(20'000));
  EXPECT_GT((compare_scenes<double, double, with_triangles>(cases(1000), chance_)), cases(20'000));
}
TEST_F(RaysByEight, HitInFloat64ThePrimitivesOfAnyKindThatOneRayHits) {
  EXPECT_GT((compare_scenes<double, float, with_all_kinds>(cases(500), chance_)), cases(10'000));
  EXPECT_GT((compare_scenes<double, double, with_all_kinds>(cases(500), chance_)), cases(10'000));
}

// Mirrors and glass in the light of two lamps, some of which are inside of something or very far away; and
// camera rays that are alike, or not, or begin where no ray of a list may.
template <class Real>
void compare_pixels(std::int64_t scenes, Chance& chance) {
  using M = Method<WatertightRay<Real>, with_triangles>;
  std::int64_t hits = 0;
  for (std::int64_t s = scenes; s > 0 && !testing::Test::HasFailure(); --s) {
    TestScene<float> scene = SceneMaker<float>(chance, chance.power_of_two(-10, 20)).scene();
    scene.spheres.clear();
    scene.cones.clear();
    if (scene.count() == 0) continue;
    const auto share = [&] { return static_cast<float>(chance.uniform(0, 1)); };
    scene.material = {{share(), share(), share()},           share(),
                      chance.one_in(4) ? 0 : share(),        8 * share(),
                      chance.one_in(2) ? 0 : 0.5F * share(), 1 + share()};
    const Boxd bounds = scene.bounds();
    const Structure grid = hierarchy_of(scene);
    const auto aimed_at = converted<Real>(scene);
    RayMaker<Real> maker(chance, aimed_at, bounds, grid);
    Light<float> lights[2];
    for (Light<float>& light : lights)
      light = {cast<float>(maker.ray().origin) * (chance.one_in(8) ? 1e5F : 1.0F),
               {share(), share(), share()}};
    const SceneView<float> view = scene.view();
    const Lighting<float> lighting{lights, 2, {share(), share(), share()}, share()};
    const RenderRules rules{chance.whole(0, 6), chance.one_in(3), HitName::primitive};
    const auto hierarchy = hierarchy_view_of<Real>(grid);
    PixelLists<M, float> pixels(view, lighting, hierarchy, rules);
    std::vector<Ray<Real>> rays(static_cast<std::size_t>(chance.whole(1, 200)));
    for (std::size_t i = 0; i < rays.size(); ++i) {
      Ray<Real> ray = maker.ray();
      if (i % 40 != 0) ray.origin = rays[i - 1].origin;
      if (chance.one_in(50))
        ray.origin = ray.origin * static_cast<Real>(sizeof(Real) == sizeof(float) ? 1e20 : 1e110);
      rays[i] = unbounded_ray(ray.origin, normalized(ray.direction));
      pixels.pixels.emplace_back(rays[i]);
    }
    pixels.follow_all();
    for (std::size_t i = 0; i < rays.size(); ++i) {
      NoCounts counts;
      HitRecord hit{};
      const Vec3f light = radiance<M>(view, lighting, NoStructure{}, rules, rays[i], hit, counts);
      hits += hit.name >= 0;
      const HitRecord& found = pixels.pixels[i].first_hit;
      const Vec3f& seen = pixels.pixels[i].tree.light;
      EXPECT_TRUE(found.name == hit.name && same_bits(found.t, hit.t))
          << described(rays[i].origin, rays[i].direction);
      for (int channel = 0; channel < 3; ++channel)
        EXPECT_TRUE(same_bits(seen[channel], light[channel]))
            << described(rays[i].origin, rays[i].direction) << ": " << described(seen) << ", expected "
            << described(light) << '\n'
            << described(scene);
    }
  }
  EXPECT_GT(hits, scenes * 3);
}
TEST_F(RaysByEight, ShowOfEachPixelWhatItSeesAlone) {
  compare_pixels<float>(cases(300), chance_);
}
TEST_F(RaysByEight, ShowOfEachPixelInFloat64WhatItSeesAlone) {
  compare_pixels<double>(cases(300), chance_);
}

TEST_F(RaysByEight, AreCoherentWhereNeighboursAreAlike) {
  const Box<float> bounds{{-1, -1, -1}, {1, 1, 1}};
  const auto coordinate = [&] { return static_cast<float>(chance_.uniform(-1, 1)); };
  for (std::int64_t c = cases(200); c > 0; --c) {
    std::vector<Ray<float>> alike, apart, others;
    const Vec3f eye{coordinate(), coordinate(), 3};
    for (int i = 0; i < 500; ++i) {
      const Vec3f to{0.001F * static_cast<float>(i), coordinate() * 0.01F, 0};
      alike.push_back(unbounded_ray(eye, to - eye));
      apart.push_back(unbounded_ray(eye + to, to - eye));
      others.push_back(unbounded_ray(Vec3f{coordinate(), coordinate(), coordinate()},
                                     Vec3f{coordinate(), coordinate(), 0.1F + coordinate()}));
    }
    EXPECT_TRUE(are_coherent(0x1p-5F, alike.data(), own_format<float>, 3, alike.size(), bounds));
    EXPECT_TRUE(are_coherent(0x1p-5F, apart.data(), own_format<float>, 3, apart.size(), bounds));
    EXPECT_FALSE(are_coherent(0x1p-12F, apart.data(), own_format<float>, 3, apart.size(), bounds));
    EXPECT_FALSE(are_coherent(0x1p-5F, others.data(), own_format<float>, 3, others.size(), bounds));
  }
}

#else

TEST_F(RaysByEight, HitTheTrianglesThatOneRayHits) {
  GTEST_SKIP() << "built without AVX2: rays are prepared one at a time";
}

#endif

} // namespace
} // namespace masu
