// All hits of a ray: the same for every structure, and each crossing of a closed mesh once. And those between
// its limits, t_min and t_max: they are compared with t as it is reported, which doesn't depend on them,
// through every structure and none, of every primitive, and for every query.
#include "libgrid/trace/hits_in_order.h"
#include "renderer/rays/ray_query.h"
#include "stability/closed_mesh.h"
#include "tests/random_grid.h"
#include "tests/random_ray.h"
#include "tests/random_scene.h"
#include "tests/random_test.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <tuple>
#include <vector>

namespace masu {
namespace {

template <class Real>
struct Crossing {
  Real t;
  PrimitiveIndex primitive;
  bool front;
  bool operator==(const Crossing&) const = default;
};

template <class Real>
using List = std::vector<Crossing<Real>>;

template <class Real, class Stored, class Structure>
List<Real> list_along(const SceneView<Stored>& scene, const Structure& grid, const Ray<Real>& ray,
                      const HitFilter& filter, std::uint32_t limit = no_primitive) {
  List<Real> list;
  const std::uint32_t count = hits_in_order<Robust<Real>>(
      scene, grid, ray, filter, limit, [&](std::uint32_t i, const auto& near, bool front) {
        EXPECT_EQ(i, list.size());
        list.push_back({near.hit.t + near.skipped, near.hit.primitive, front});
      });
  EXPECT_EQ(count, list.size());
  return list;
}

// Of every primitive, by its own test alone, sorted.
template <class Real, class Stored>
List<Real> tried(const SceneView<Stored>& scene, const Ray<Real>& ray, const HitFilter& filter) {
  struct Found : Crossing<Real> {
    Real near_t;
  };
  std::vector<Found> found;
  ClippedRay<Real> near{};
  if (!clip(ray, cast<Real>(scene.clip), near)) return {};
  const WatertightRay<Real> test_ray = prepared(near.ray.origin, near.ray.direction);
  for (PrimitiveIndex i = 0; i < scene.primitive_count(); ++i) {
    if (i == filter.excluded) continue;
    const std::uint32_t object = surface_of(scene, i).object;
    if (filter.object_masks != nullptr && (filter.object_masks[object] & filter.ray_mask) == 0) continue;
    each_hit<with_all_kinds>(scene, test_ray, i, SceneRecord<Stored>{scene, i}, filter.edges,
                             [&](Real t, bool front) {
                               if (t > near.ray.t_min && t < near.ray.t_max &&
                                   (filter.faces == Faces::both || front == (filter.faces == Faces::front)))
                                 found.push_back({{t + near.skipped, i, front}, t});
                             });
  }
  std::ranges::sort(found, {}, [](const Found& f) { return std::tuple(f.near_t, f.primitive, !f.front); });
  return {found.begin(), found.end()};
}

template <class Real>
class HitsInOrder : public RandomTest {
protected:
  HitFilter filter(const SceneView<Real>& scene) {
    return {chance_.one_of({Faces::both, Faces::front, Faces::back}),
            chance_.one_of({EdgeRule::closed, EdgeRule::half_open}),
            chance_.one_in(2) ? no_primitive
                              : static_cast<PrimitiveIndex>(chance_.index(scene.primitive_count())),
            chance_.one_in(2) ? nullptr : masks_.data(),
            chance_.one_in(4) ? 0xffffffffU : static_cast<std::uint32_t>(chance_.whole(0, 7))};
  }
  // Of a scene that has a view: gives primitives objects, whose masks filter() may take.
  void number_objects(TestScene<Real>& scene) {
    const auto object = [&] { return static_cast<std::uint32_t>(chance_.index(masks_.size())); };
    for (std::uint32_t& mask : masks_)
      mask = static_cast<std::uint32_t>(chance_.whole(0, 7));
    for (Triangle<Real>& triangle : scene.triangles)
      triangle.object = object();
    for (Surface& surface : scene.surfaces)
      surface.object = object();
  }
  std::vector<std::uint32_t> masks_ = std::vector<std::uint32_t>(5);
  // Through a random grid and a hierarchy, as they are and as structures known when they are traced.
  template <class Act>
  void with_structures(const Structure& grid, const Structure& hierarchy, const Act& act) {
    for (const Structure* const structure : {&grid, &hierarchy}) {
      with_structure_view<Real>(*structure, act);
      act(any_structure<Real>(*structure));
    }
    act(AnyStructure<Real>{});
  }
};
TYPED_TEST_SUITE(HitsInOrder, Reals);

TYPED_TEST(HitsInOrder, AreThoseOfTryingEveryPrimitive) {
  using Real = TypeParam;
  Chance& chance = this->chance_;
  std::size_t hits = 0, many = 0;
  for (std::int64_t s = cases(300); s > 0; --s) {
    TestScene<Real> scene = SceneMaker<Real>(chance, chance.power_of_two(-10, 20)).scene();
    if (scene.count() == 0) continue;
    if (!scene.triangles.empty() && chance.one_in(4)) { // more hits than a pass keeps, some of them ties
      const Triangle<Real> triangle = scene.triangles[chance.index(scene.triangles.size())];
      const Vec3<Real> step = (triangle.b - triangle.a) * static_cast<Real>(chance.one_of({0.0, 0.01}));
      const int layers = chance.one_in(8) ? 800 : 60;
      for (int i = 0; i < layers; ++i) {
        const Vec3<Real> by = step * static_cast<Real>(i / 2);
        scene.triangles.push_back(triangle_of(triangle.a + by, triangle.b + by, triangle.c + by));
      }
    }
    const SceneView<Real> view = scene.view();
    this->number_objects(scene);
    const Structure grid = random_grid(chance, view, scene.bounds()), hierarchy = hierarchy_of(scene);
    RayMaker<Real> rays(chance, scene, scene.bounds(), grid);
    for (int r = 0; r < 60; ++r) {
      const Ray<Real> ray = rays.ray();
      const HitFilter filter = this->filter(view);
      const List<Real> expected = tried(view, ray, filter);
      NoCounts counts;
      const Hit<Real> nearest = nearest_hit<Robust<Real>>(view, NoStructure{}, ray, counts);
      const List<Real> all = tried(view, ray, {Faces::both, EdgeRule::closed});
      ASSERT_EQ(all.empty(), nearest.primitive == no_primitive) << described(ray.origin, ray.direction);
      ASSERT_TRUE(all.empty() || (same_bits(all[0].t, nearest.t) && all[0].primitive == nearest.primitive))
          << described(ray.origin, ray.direction);
      const std::uint32_t limit =
          chance.one_in(2) ? no_primitive : static_cast<std::uint32_t>(chance.whole(1, 40));
      List<Real> first = expected;
      first.resize(std::min<std::size_t>(first.size(), limit));
      hits += first.size();
      many += first.size() > hits_per_pass ? 1 : 0;
      this->with_structures(grid, hierarchy, [&](const auto& structure) {
        ASSERT_EQ(list_along(view, structure, ray, filter, limit), first)
            << described(ray.origin, ray.direction) << ' ' << described(grid);
      });
    }
  }
  EXPECT_GT(hits, static_cast<std::size_t>(cases(5000)));
  EXPECT_GT(many, static_cast<std::size_t>(cases(50)));
}

// Every primitive is tried, and counted.
struct CountedTrials {
  std::uint64_t* shown;
};
template <class Real, class Visitor>
void visit(const CountedTrials& trials, const ClippedRay<Real>& near, std::uint32_t primitives,
           Visitor& visitor) {
  visit(NoStructure{}, near, primitives, visitor);
  *trials.shown += primitives;
}

// Of n primitives that all are hit, and at one place or at many.
TYPED_TEST(HitsInOrder, TakeAFewPassesHoweverManyThereAre) {
  using Real = TypeParam;
  for (const double apart : {0.0, 0.25}) {
    for (const std::uint32_t n : {1000U, 10'000U, 100'000U}) {
      TestScene<Real> scene;
      for (std::uint32_t i = 0; i < n; ++i) {
        const double z = apart * ((i * 7919U) % n); // in no order
        scene.triangles.push_back(triangle_of<Real>(Vec3d{-1, -1, z}, Vec3d{2, -1, z}, Vec3d{-1, 2, z}));
      }
      const SceneView<Real> view = scene.view();
      const Ray<Real> ray = unbounded_ray<Real>({0, 0, -1}, {0, 0, 1});
      std::uint64_t shown = 0;
      const List<Real> list = list_along(view, CountedTrials{&shown}, ray, {});
      EXPECT_EQ(list.size(), n);
      EXPECT_LE(shown, 6U * n) << n << " hits " << apart << " apart";
      EXPECT_EQ(list, tried(view, ray, {}));
    }
  }
}

// Also of meshes so small that products of two coordinates underflow.
TYPED_TEST(HitsInOrder, CrossAClosedMeshAsOftenInwardsAsOutwards) {
  using Real = TypeParam;
  Chance& chance = this->chance_;
  std::size_t crossed = 0;
  for (std::int64_t s = cases(400); s > 0; --s) {
    const double size = std::exp2(chance.one_in(2) ? 0 : chance.whole(-60, 20));
    TestScene<Real> scene;
    scene.triangles = closed_mesh<Real>(chance, size, true);
    const std::span<const Triangle<Real>> triangles(scene.triangles);
    ASSERT_TRUE(is_closed(triangles));
    const SceneView<Real> view = scene.view();
    const Structure grid = random_grid(chance, view, scene.bounds());
    with_view<Real>(grid, [&](const auto& structure) {
      for (int r = 0; r < 200; ++r) {
        const Ray<Real> ray = crossing_ray<Real>(chance, triangles, size);
        const List<Real> list = list_along(view, structure, ray, {});
        const auto fronts = std::ranges::count(list, true, &Crossing<Real>::front);
        ASSERT_EQ(static_cast<std::size_t>(2 * fronts), list.size())
            << described(ray.origin, ray.direction) << " size " << size;
        crossed += list.empty() ? 0 : 1;
      }
    });
  }
  EXPECT_GT(crossed, static_cast<std::size_t>(cases(30'000)));
}

TYPED_TEST(HitsInOrder, TellPointsInsideAClosedMesh) {
  using Real = TypeParam;
  Chance& chance = this->chance_;
  int inside = 0, points = 0;
  for (std::int64_t s = cases(200); s > 0; --s) {
    TestScene<Real> scene;
    scene.triangles = closed_mesh<Real>(chance, 1, false);
    const std::span<const Triangle<Real>> triangles(scene.triangles);
    const SceneView<Real> view = scene.view();
    for (int p = 0; p < 20; ++p) {
      // On a coarse lattice, where many rays meet edges and corners exactly.
      const Vec3d point = chance.one_in(2) ? kept<float>(chance.in_cube(1.2))
                                           : cast<double>(cast<int>(chance.in_cube(5))) * 0.25;
      const double winding = winding_number(triangles, point);
      bool near_surface = std::abs(winding - std::round(winding)) > 1e-6;
      for (int axis = 0; axis < 3 && !near_surface; ++axis)
        for (const double step : {-1e-4, 1e-4}) {
          Vec3d beside = point;
          beside.set(axis, beside[axis] + step);
          near_surface |= std::abs(winding_number(triangles, beside) - winding) > 1e-3;
        }
      if (near_surface) continue;
      ++points;
      const bool is_inside = std::lround(winding) % 2 != 0;
      inside += is_inside ? 1 : 0;
      for (int d = 0; d < 10; ++d) {
        Vec3d direction = chance.direction();
        if (chance.one_in(2)) direction = cast<double>(cast<int>(chance.in_cube(2.9)));
        if (largest_magnitude(direction) == 0) direction = {0, 1, 0};
        const Ray<Real> ray = unbounded_ray(cast<Real>(point), cast<Real>(direction));
        ASSERT_EQ(list_along(view, NoStructure{}, ray, {}).size() % 2 != 0, is_inside)
            << described(ray.origin, ray.direction);
      }
    }
  }
  EXPECT_GT(inside, points / 10);
  EXPECT_GT(points, cases(2000));
}

TYPED_TEST(HitsInOrder, EnterAndLeaveSpheresAndCones) {
  using Real = TypeParam;
  TestScene<Real> scene;
  scene.spheres = {sphere_of<Real>({0, 0, 0}, 1), sphere_of<Real>({0, 0, 0}, -2)};
  scene.cones = {cone_of<Real>({0, -1, 5}, 1, {0, 1, 5}, 1),
                 cone_of<Real>({0, -1, 10}, -2, {0, 1, 10}, -0.5)};
  const auto hits = [&](Real from) {
    return list_along(scene.view(), NoStructure{}, unbounded_ray<Real>({0, 0, from}, {0, 0, 1}), {});
  };
  // Of the negative radii the inside alone is visible, and is the front.
  const List<Real> all = hits(-5), expected = {{4, 0, true}, {6, 0, false},  {7, 1, true},
                                               {9, 2, true}, {11, 2, false}, {16.25, 3, true}};
  ASSERT_EQ(all.size(), expected.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_NEAR(static_cast<double>(all[i].t), static_cast<double>(expected[i].t), 1e-4);
    EXPECT_EQ(all[i].primitive, expected[i].primitive);
    EXPECT_EQ(all[i].front, expected[i].front) << i;
  }
  EXPECT_EQ(hits(0).size(), 5U);
}

// --- Limits ----------------------------------------------------------------------------------------------

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

// Of faces of either side, with their edges.
template <class Real, class Structure>
std::vector<Hit<Real>> closed_hits(const SceneView<Real>& scene, const Structure& structure,
                                   const Ray<Real>& ray) {
  std::vector<Hit<Real>> hits;
  hits_in_order<Robust<Real>>(
      scene, structure, ray, {Faces::both, EdgeRule::closed}, no_primitive,
      [&](std::uint32_t, const auto& near, bool) { hits.push_back(relative_to_origin(near)); });
  return hits;
}

TYPED_TEST(RayLimits, AreComparedWithTheReportedT) {
  using Real = TypeParam;
  Chance& chance = this->chance_;
  std::size_t beyond = 0, between = 0, ties = 0;
  for (std::int64_t s = cases(300); s > 0; --s) {
    TestScene<Real> scene = SceneMaker<Real>(chance, chance.power_of_two(-10, 20)).scene();
    if (scene.count() == 0) continue;
    if (chance.one_in(2)) repeat_primitives(scene, 1);
    const SceneView<Real> view = scene.view();
    const Structure grid = random_grid(chance, view, scene.bounds()), hierarchy = hierarchy_of(scene);
    RayMaker<Real> rays(chance, scene, scene.bounds(), grid);
    for (int r = 0; r < 40; ++r) {
      Ray<Real> ray = rays.ray();
      ray.t_max = RealTraits<Real>::largest;
      // What it hits, whatever its limits.
      std::vector<Hit<Real>> all = closed_hits(view, NoStructure{}, ray);
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
      ties += all.size() > 1 && all[0].t == all[1].t;
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
        ASSERT_TRUE(all.empty() ? same_bits(nearest.t, ray.t_max) : same(nearest, all[0])) << of;
        ASSERT_EQ(is_occluded<Robust<Real>>(view, structure, ray, counts), !all.empty()) << of;
        ASSERT_TRUE(std::ranges::equal(closed_hits(view, structure, ray), all, same)) << of;
      };
      check(NoStructure{});
      with_structure_view<Real>(grid, check);
      with_structure_view<Real>(hierarchy, check);
    }
  }
  EXPECT_GT(beyond, 500U);
  EXPECT_GT(between, 500U);
  EXPECT_GT(ties, 100U);
}

using ListedLimits = RandomTest;

// Of a list in float32 t is float32, too, whatever the arithmetic.
TEST_F(ListedLimits, OfFloat32AreComparedWithTAsFloat32) {
  std::size_t hits = 0, again = 0;
  for (std::int64_t s = cases(300); s > 0; --s) {
    TestScene<double> scene = SceneMaker<double>(chance_, chance_.power_of_two(-10, 20)).scene();
    if (scene.count() == 0) continue;
    const SceneView<double> view = scene.view();
    const Structure hierarchy = hierarchy_of(scene);
    RayMaker<double> rays(chance_, scene, scene.bounds(), hierarchy);
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
