// A ray's t_min and t_max are compared with t as it is reported, which doesn't depend on them: through every
// structure and none, of every primitive, and for every query.
#include "libgrid/trace/hits_in_order.h"
#include "renderer/rays/ray_query.h"
#include "tests/random_grid.h"
#include "tests/random_ray.h"
#include "tests/random_scene.h"
#include "tests/random_test.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <vector>

namespace masu {
namespace {

template <class Real>
class RayLimits : public RandomTest {
protected:
  // Random bits: of any magnitude, not negative, finite.
  Real number() {
    for (;;) {
      const auto value = std::bit_cast<Real>(static_cast<decltype(bits_of(Real{}))>(chance_.engine()()));
      if (value >= 0 && value < RealTraits<Real>::largest / 4) return value;
    }
  }
};
TYPED_TEST_SUITE(RayLimits, Reals);

TYPED_TEST(RayLimits, AreReachedByTheLeastNumberWhoseRoundedSumReachesThem) {
  using Real = TypeParam;
  Chance& chance = this->chance_;
  for (std::int64_t i = cases(200'000); i > 0; --i) {
    const Real skipped = this->number();
    Real t = chance.one_in(2) ? this->number() : skipped * static_cast<Real>(chance.uniform(1, 4));
    for (int steps = chance.one_in(3) ? chance.whole(0, 4) : 0; steps > 0; --steps)
      t = next_above(chance.one_in(2) ? skipped : t);
    const Real found = first_reaching(t, skipped);
    ASSERT_TRUE(found >= 0 && found + skipped >= t) << described(t) << ' ' << described(skipped);
    ASSERT_TRUE(found == 0 || next_below(found) + skipped < t) << described(t) << ' ' << described(skipped);
  }
}

TYPED_TEST(RayLimits, AreComparedWithTheReportedT) {
  using Real = TypeParam;
  Chance& chance = this->chance_;
  std::size_t beyond = 0, between = 0;
  for (std::int64_t s = cases(300); s > 0; --s) {
    TestScene<Real> scene = SceneMaker<Real>(chance, chance.power_of_two(-10, 20)).scene();
    if (scene.count() == 0) continue;
    const SceneView<Real> view = scene.view();
    const Boxd bounds = scene.bounds();
    const Structure grid = random_grid(chance, view, bounds), hierarchy = hierarchy_of(scene);
    RayMaker<Real> rays(chance, scene, bounds, grid);
    for (int r = 0; r < 40; ++r) {
      Ray<Real> ray = rays.ray();
      ray.t_max = RealTraits<Real>::largest;
      // What it hits, whatever its limits.
      std::vector<Hit<Real>> all;
      hits_in_order<Robust<Real>>(
          view, NoStructure{}, ray, {Faces::both, EdgeRule::closed}, no_primitive,
          [&](std::uint32_t, const auto& near, bool) { all.push_back(relative_to_origin(near)); });
      if (all.empty()) continue;
      const auto limit = [&] {
        const Real t = all[chance.index(all.size())].t;
        return chance.one_in(4) ? next_above(t) : chance.one_in(4) ? next_below(t) : t;
      };
      if (chance.one_in(2)) ray.t_min = limit();
      if (chance.one_in(2)) ray.t_max = limit();
      std::erase_if(all, [&](const Hit<Real>& hit) { return !(ray.t_min < hit.t && hit.t < ray.t_max); });
      beyond += all.empty();
      between += !all.empty();
      const auto same = [](const Hit<Real>& a, const Hit<Real>& b) {
        return same_bits(a.t, b.t) && a.primitive == b.primitive;
      };
      const auto check = [&](const auto& structure) {
        const testing::Message of = testing::Message()
                                    << described(ray.origin, ray.direction) << " from "
                                    << described(ray.t_min) << " to " << described(ray.t_max) << '\n'
                                    << described(scene);
        NoCounts counts;
        const Hit<Real> nearest = nearest_hit<Robust<Real>>(view, structure, ray, counts);
        ASSERT_EQ(nearest.primitive != no_primitive, !all.empty()) << of;
        ASSERT_TRUE(all.empty() || same(nearest, all[0])) << of;
        ASSERT_EQ(is_occluded<Robust<Real>>(view, structure, ray, counts), !all.empty()) << of;
        std::vector<Hit<Real>> listed;
        hits_in_order<Robust<Real>>(
            view, structure, ray, {Faces::both, EdgeRule::closed}, no_primitive,
            [&](std::uint32_t, const auto& near, bool) { listed.push_back(relative_to_origin(near)); });
        ASSERT_TRUE(std::ranges::equal(listed, all, same)) << of;
      };
      check(NoStructure{});
      with_structure_view<Real>(grid, check);
      with_structure_view<Real>(hierarchy, check);
    }
  }
  EXPECT_GT(beyond, 500U);
  EXPECT_GT(between, 500U);
}

using ListedLimits = RandomTest;

// Of a list in float32 t is float32, too, whatever the arithmetic.
TEST_F(ListedLimits, OfFloat32AreComparedWithTAsFloat32) {
  std::size_t hits = 0, again = 0;
  for (std::int64_t s = cases(300); s > 0; --s) {
    TestScene<double> scene = SceneMaker<double>(chance_, chance_.power_of_two(-10, 20)).scene();
    if (scene.count() == 0) continue;
    const SceneView<double> view = scene.view();
    const Boxd bounds = scene.bounds();
    const Structure hierarchy = hierarchy_of(scene);
    RayMaker<double> rays(chance_, scene, bounds, hierarchy);
    for (int r = 0; r < 40; ++r) {
      const Ray<double> made = rays.ray();
      if (largest_magnitude(made.origin) > 1e30) continue; // t would be infinite as float32
      Ray<float> ray{cast<float>(made.origin), 0, cast<float>(made.direction), INFINITY};
      const auto traced = [&] {
        NoCounts counts;
        const Ray<double> loaded = masu::loaded<double>(&ray, own_format<float>, 0);
        return trace_listed<Query::nearest_hit, Robust<double>>(view, NoStructure{}, loaded, counts);
      };
      const Hit<float> first = traced();
      if (first.primitive == no_primitive) continue;
      (chance_.one_in(2) ? ray.t_min : ray.t_max) = first.t;
      const Hit<float> second = traced();
      ++hits;
      again += second.primitive != no_primitive;
      ASSERT_TRUE(second.primitive == no_primitive || (ray.t_min < second.t && second.t < ray.t_max))
          << described(made.origin, made.direction) << ' ' << described(second.t);
    }
  }
  EXPECT_GT(hits, 500U);
  EXPECT_GT(again, 50U);
}

} // namespace
} // namespace masu
