// Rays made ready eight at a time, that walk one after the other, as packets or in step, and whose triangles
// are tested eight at a time, give the bits that one ray gives that tries one primitive after the other.
#include "libscene/base/portable.h"

#ifdef MASU_HOST_AVX2
#include "renderer/cpu/pixel_lists.h"
#endif

#include "tests/random_grid.h"
#include "tests/random_ray.h"
#include "tests/random_scene.h"
#include "tests/random_test.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

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

template <Query query, class M>
void compare(const TestScene<float>& scene, const SceneView<float>& view, const Structure& grid,
             const std::vector<Ray<float>>& rays, std::size_t first, std::int64_t& hits) {
  const auto check = [&](std::size_t i, const Hit<float>& found) {
    NoCounts counts;
    const Hit<float> expected = trace_listed<query, M>(view, NoStructure{}, rays.at(i), counts);
    hits += expected.primitive != no_primitive;
    const Ray<float>& ray = rays[i];
    EXPECT_TRUE(found.primitive == no_primitive || query == Query::occlusion ||
                (ray.t_min < found.t && found.t < ray.t_max))
        << described(found);
    EXPECT_TRUE(found.primitive == expected.primitive &&
                (query == Query::occlusion || same_bits(found.t, expected.t)))
        << described(ray.origin, ray.direction) << " t_min " << described(ray.t_min) << " t_max "
        << described(ray.t_max) << ": " << described(found) << ", expected " << described(expected) << '\n'
        << described(scene);
  };
  const auto hierarchy = hierarchy_view_of<float>(grid);
  const auto trace_all = [&](const auto& trace) {
    std::vector<int> times(rays.size());
    const std::size_t end = trace(view, hierarchy, rays.data(), own_format<float>, first, rays.size(),
                                  [&](std::size_t i, const ListedHit& found) {
                                    ++times.at(i);
                                    check(i, reported(found));
                                  });
    EXPECT_LT(rays.size() - end, EightRays::count);
    for (std::size_t i = 0; i < rays.size(); ++i)
      EXPECT_EQ(times[i], i >= first && i < end ? 1 : 0);
  };
  trace_all([](const auto&... all) { return trace_in_turn<query, M>(all...); });
  trace_all([](const auto&... all) { return trace_packets<query, M>(all...); });
  trace_all([](const auto&... all) { return trace_in_step<query, M>(all...); });
}

// Returns how many rays hit something.
template <unsigned kinds>
std::int64_t compare_scenes(std::int64_t scenes, Chance& chance) {
  using M = Method<WatertightRay<float>, kinds>;
  std::int64_t hits = 0;
  for (std::int64_t s = scenes; s > 0 && !testing::Test::HasFailure(); --s) {
    TestScene<float> scene = SceneMaker<float>(chance, chance.power_of_two(-10, 20)).scene();
    if constexpr (kinds == with_triangles) {
      scene.spheres.clear();
      scene.cones.clear();
    }
    if (scene.count() == 0) continue;
    const Structure grid = hierarchy_of(scene);
    const SceneView<float> view = scene.view();
    const Boxd bounds = scene.bounds();
    RayMaker<float> maker(chance, scene, bounds, grid);
    // As many as take each other's places, or too few for that.
    std::vector<Ray<float>> rays(static_cast<std::size_t>(chance.one_in(2) ? chance.whole(0, 40) : 240));
    const bool alike = chance.one_in(2); // but for those that aren't valid
    for (std::size_t i = 0; i < rays.size(); ++i) {
      Ray<float> ray = maker.ray();
      if (alike && i % 32 != 0) {
        const Ray<float>& other = rays[i - 1];
        const auto moved = [&](const Vec3f& from, const Vec3f& to) {
          return fma(to - from, static_cast<float>(chance.power_of_two(-20, -4)), from);
        };
        ray = {moved(other.origin, ray.origin), other.t_min, moved(other.direction, ray.direction),
               other.t_max};
      }
      rays[i] = alike && !chance.one_in(40) ? ray : any_ray(chance, ray);
    }
    for (Ray<float>& ray : rays) { // limits at hits
      if (!chance.one_in(4)) continue;
      NoCounts counts;
      const Hit<float> hit = trace_listed<Query::nearest_hit, M>(view, NoStructure{}, ray, counts);
      if (hit.primitive == no_primitive) continue;
      const float t = chance.one_in(2) ? hit.t : chance.one_in(2) ? next_above(hit.t) : next_below(hit.t);
      (chance.one_in(2) ? ray.t_min : ray.t_max) = t;
    }
    const auto first = std::min(rays.size(), static_cast<std::size_t>(chance.whole(0, 9)));
    compare<Query::nearest_hit, M>(scene, view, grid, rays, first, hits);
    compare<Query::occlusion, M>(scene, view, grid, rays, first, hits);
  }
  return hits;
}

TEST_F(RaysByEight, HitTheTrianglesThatOneRayHits) {
  EXPECT_GT(compare_scenes<with_triangles>(cases(2000), chance_), cases(40'000));
}

TEST_F(RaysByEight, HitThePrimitivesOfAnyKindThatOneRayHits) {
  EXPECT_GT(compare_scenes<with_all_kinds>(cases(1000), chance_), cases(20'000));
}

// Mirrors and glass in the light of two lamps, some of which are inside of something or very far away; and
// camera rays that are alike, or not, or begin where no ray of a list may.
TEST_F(RaysByEight, ShowOfEachPixelWhatItSeesAlone) {
  using M = Method<WatertightRay<float>, with_triangles>;
  std::int64_t hits = 0;
  for (std::int64_t s = cases(300); s > 0 && !HasFailure(); --s) {
    TestScene<float> scene = SceneMaker<float>(chance_, chance_.power_of_two(-10, 20)).scene();
    scene.spheres.clear();
    scene.cones.clear();
    if (scene.count() == 0) continue;
    const auto share = [&] { return static_cast<float>(chance_.uniform(0, 1)); };
    scene.material = {{share(), share(), share()},
                      share(),
                      chance_.one_in(4) ? 0 : share(),
                      8 * share(),
                      chance_.one_in(2) ? 0 : 0.5F * share(),
                      1 + share()};
    const Boxd bounds = scene.bounds();
    const Structure grid = hierarchy_of(scene);
    RayMaker<float> maker(chance_, scene, bounds, grid);
    Light<float> lights[2];
    for (Light<float>& light : lights)
      light = {maker.ray().origin * (chance_.one_in(8) ? 1e5F : 1.0F), {share(), share(), share()}};
    SceneView<float> view = scene.view();
    view.lights = lights;
    view.light_count = 2;
    view.background = {share(), share(), share()};
    view.ambient = share();
    const RenderRules rules{chance_.whole(0, 6), chance_.one_in(3), HitName::primitive};
    const auto hierarchy = hierarchy_view_of<float>(grid);
    PixelLists<M, float> pixels(view, hierarchy, rules);
    std::vector<Ray<float>> rays(static_cast<std::size_t>(chance_.whole(1, 200)));
    for (std::size_t i = 0; i < rays.size(); ++i) {
      Ray<float> ray = maker.ray();
      if (i % 40 != 0) ray.origin = rays[i - 1].origin;
      if (chance_.one_in(50)) ray.origin = ray.origin * 1e20F;
      rays[i] = unbounded_ray(ray.origin, normalized(ray.direction));
      pixels.add(rays[i]);
    }
    pixels.follow_all();
    for (std::size_t i = 0; i < rays.size(); ++i) {
      NoCounts counts;
      HitRecord hit{};
      const Vec3f light = radiance<M>(view, NoStructure{}, rules, rays[i], hit, counts);
      hits += hit.name >= 0;
      const HitRecord& found = pixels.first_hit(i);
      EXPECT_TRUE(found.name == hit.name && same_bits(found.t, hit.t))
          << described(rays[i].origin, rays[i].direction);
      for (int channel = 0; channel < 3; ++channel)
        EXPECT_TRUE(same_bits(pixels.light(i)[channel], light[channel]))
            << described(rays[i].origin, rays[i].direction) << ": " << described(pixels.light(i))
            << ", expected " << described(light) << '\n'
            << described(scene);
    }
  }
  EXPECT_GT(hits, cases(2'000));
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
