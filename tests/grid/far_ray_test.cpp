// Rays from far away: clipping to the scene's bounds, and their hits.
#include "libscene/geometry/surface.h"
#include "renderer/rays/ray_query.h"
#include "tests/random_test.h"
#include "tests/ray_case.h"

#include <algorithm>
#include <cstring>
#include <map>

namespace masu {
namespace {

// The error bound of margin.h, in u M.
constexpr double clip_error = 8;

struct Interval {
  oracle::Wide enter, leave;
};

Interval slabs(const oracle::Line& line, const Boxd& box) {
  Interval interval{0, std::numeric_limits<double>::max()};
  const oracle::Wide origin[]{line.origin.x, line.origin.y, line.origin.z},
      direction[]{line.direction.x, line.direction.y, line.direction.z};
  for (int axis = 0; axis < 3; ++axis) {
    if (direction[axis] == 0) {
      if (origin[axis] < box.min[axis] || origin[axis] > box.max[axis]) return {1, 0};
      continue;
    }
    const oracle::Wide t0 = (box.min[axis] - origin[axis]) / direction[axis],
                       t1 = (box.max[axis] - origin[axis]) / direction[axis];
    interval.enter = oracle::max(interval.enter, oracle::min(t0, t1));
    interval.leave = oracle::min(interval.leave, oracle::max(t0, t1));
  }
  return interval;
}

// Whether the ray starts beyond the box and moves away from it.
template <class Real>
bool starts_beyond(const Boxd& box, const Ray<Real>& ray) {
  for (int axis = 0; axis < 3; ++axis) {
    const auto origin = static_cast<double>(ray.origin[axis]);
    if (ray.direction[axis] >= 0 && origin > box.max[axis]) return true;
    if (ray.direction[axis] <= 0 && origin < box.min[axis]) return true;
  }
  return false;
}

// A ray from up to 2^`distance` times the box's size away, aimed into the box or close by it.
template <class Real>
Ray<Real> far_ray(Chance& chance, const Boxd& box, double distance) {
  const double size = largest_magnitude(box.max - box.min);
  Vec3d target = chance.in_box(box);
  const int axis = chance.whole(0, 2);
  switch (chance.whole(0, 3)) {
  case 0: // on a face
    target.set(axis, chance.one_in(2) ? box.min[axis] : box.max[axis]);
    break;
  case 1: // a corner
    target = {chance.one_in(2) ? box.min.x : box.max.x, chance.one_in(2) ? box.min.y : box.max.y,
              chance.one_in(2) ? box.min.z : box.max.z};
    break;
  case 2:
    target = target + chance.in_cube(size);
    break;
  default:
    break;
  }
  const Vec3d back = chance.direction() * (size * chance.power_of_two(-2, distance));
  Vec3<Real> origin = cast<Real>(target + back), aim = cast<Real>(target);
  if (chance.one_in(4)) origin.set(axis, aim[axis]);
  if (chance.one_in(8)) origin.set((axis + 1) % 3, aim[(axis + 1) % 3]);
  if (origin == aim) origin.x += static_cast<Real>(size);
  return unbounded_ray(origin, sized(chance, aim - origin));
}

template <class Real>
class FarRay : public RandomTest {};
TYPED_TEST_SUITE(FarRay, Reals);

template <class Real>
Boxd random_bounds(Chance& chance) {
  const double scale = chance.power_of_two(-10, 20);
  const Vec3d at = chance.in_cube(chance.one_of({0.0, scale, 100 * scale}));
  Boxd box{at, at};
  box = join(box, at + chance.in_cube(scale));
  if (chance.one_in(4)) box.max.set(2, box.min.z);
  return kept<Real>(box);
}

TYPED_TEST(FarRay, ClippingIsAccurateAndConservative) {
  using Real = TypeParam;
  Chance& chance = this->chance_;
  double worst_off = 0, worst_late = 0, worst_outside = 0;
  std::string worst_case;
  for (std::int64_t i = cases(200'000); i > 0; --i) {
    const Boxd bounds = random_bounds<Real>(chance);
    const Box<Real> box = cast<Real>(padded_bounds<Real>(bounds));
    const Boxd wide = cast<double>(box);
    const Ray<Real> ray = far_ray<Real>(chance, wide, digits<Real> - 0.75);
    const double unit = static_cast<double>(RealTraits<Real>::unit_roundoff) * largest_magnitude(wide);
    const oracle::Line line = oracle::line(ray.origin, ray.direction);
    // Where hits can be: the padding outside may be entered late, or missed.
    const Interval met = slabs(line, grown(bounds, rounding_margin<Real>(bounds)));
    ClippedRay<Real> clipped{};
    if (!clip(ray, box, clipped)) {
      ASSERT_TRUE(starts_beyond(bounds, ray) || met.enter > met.leave)
          << "missed by " << described(ray.origin, ray.direction) << " box " << described(box.min)
          << described(box.max);
      continue;
    }
    if (contains(box, ray.origin)) {
      ASSERT_TRUE(clipped.ray.origin == ray.origin && clipped.skipped == 0)
          << described(ray.origin, ray.direction) << " box " << described(box.min) << described(box.max)
          << " skipped " << clipped.skipped;
      continue;
    }
    if (met.enter > met.leave) continue;
    const oracle::Wide square = oracle::inner(line.direction, line.direction);
    const oracle::Point at = oracle::point(clipped.ray.origin);
    const oracle::Wide along = oracle::inner(at - line.origin, line.direction) / square;
    const double off = static_cast<double>(oracle::norm(at - line.at(along))) / unit;
    const double late = static_cast<double>((along - met.enter) * oracle::root(square)) / unit;
    double outside = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double c = static_cast<double>(clipped.ray.origin[axis]);
      outside = std::max(outside, std::max(wide.min[axis] - c, c - wide.max[axis]) / unit);
    }
    if (off > worst_off) worst_case = described(ray.origin, ray.direction);
    worst_off = std::max(worst_off, off);
    worst_late = std::max(worst_late, late);
    worst_outside = std::max(worst_outside, outside);
  }
  this->RecordProperty("worst_distance_from_the_ray_in_uM", std::to_string(worst_off));
  this->RecordProperty("worst_distance_beyond_the_entry_in_uM", std::to_string(worst_late));
  this->RecordProperty("worst_distance_before_the_box_in_uM", std::to_string(worst_outside));
  // Each coordinate is rounded once, and before when clipped from far away.
  EXPECT_LE(worst_off, clip_error) << worst_case;
  EXPECT_LE(worst_late, clip_error);
  // From up to 256 times the box's size the ray is clipped once: `enter` is reduced by 8 roundings and has 4
  // of its own (difference, inverse, product, reduction). Then the origin is rounded.
  EXPECT_LE(worst_outside, (8 + 4) * 256 + 1);
}

// The oracle's nearest hit in a scene; unsure where it is for any primitive in question.
template <class Real>
oracle::Expected expect_nearest(const oracle::Line& line, const TestScene<Real>& scene, double slack) {
  oracle::Expected nearest{oracle::Result::miss, 0, 0};
  for_each_kind(scene, [&](const auto& primitives) {
    for (const auto& primitive : primitives) {
      const oracle::Expected one = oracle::expect(line, primitive, slack);
      if (one.result == oracle::Result::miss || nearest.result == oracle::Result::unsure) continue;
      if (one.result == oracle::Result::unsure || nearest.result == oracle::Result::miss) {
        nearest = one;
        continue;
      }
      nearest.low = oracle::min(nearest.low, one.low);
      nearest.high = oracle::min(nearest.high, one.high);
    }
  });
  return nearest;
}

template <class Real>
TestScene<Real> small_scene(Chance& chance) {
  const double scale = chance.power_of_two(-10, 20);
  TestScene<Real> scene;
  for (int i = chance.whole(1, 3); i > 0; --i) {
    const Vec3d at = chance.in_cube(scale);
    const auto corner = [&] { return at + chance.in_cube(scale / 2); };
    scene.triangles.push_back(triangle_of<Real>(corner(), corner(), corner()));
    scene.spheres.push_back(sphere_of<Real>(chance.in_cube(scale), scale * chance.uniform(0.05, 0.5)));
    scene.cones.push_back(cone_of<Real>(corner(), scale * chance.uniform(0.1, 0.3), corner(),
                                        scale * chance.uniform(0.1, 0.3)));
  }
  return scene;
}

TYPED_TEST(FarRay, FindsTheOraclesNearestHit) {
  using Real = TypeParam;
  Chance& chance = this->chance_;
  std::map<oracle::Result, std::int64_t> results;
  for (std::int64_t s = cases(1500); s > 0 && !this->HasFailure(); --s) {
    TestScene<Real> scene = small_scene<Real>(chance);
    const SceneView<Real> view = scene.view();
    const Boxd bounds = scene.bounds();
    for (int i = 0; i < 8; ++i) {
      const Ray<Real> ray = far_ray<Real>(chance, bounds, 23.25);
      const auto expected =
          expect_nearest(oracle::line(ray.origin, ray.direction), scene, rounding_margin<Real>(bounds));
      ++results[expected.result];
      if (expected.result == oracle::Result::unsure) continue;
      NoCounts counts;
      const Hit<Real> hit = nearest_hit<Robust<Real>>(view, NoStructure{}, ray, counts);
      // t from far away is rounded once or twice more.
      const oracle::Wide rounding = 4 * oracle::Wide(hit.t) * RealTraits<Real>::unit_roundoff;
      expect_agreement(expected, hit.primitive != no_primitive, hit.t, rounding,
                       [&] { return described(ray.origin, ray.direction); });
    }
  }
  EXPECT_GT(results[oracle::Result::hit], cases(500));
  EXPECT_GT(results[oracle::Result::miss], cases(500));
}

// Lists may be stored in float64 and traced in float32.
using FarListedRay = RandomTest;

TEST_F(FarListedRay, FindsTheOraclesNearestHitFromAnyDistance) {
  std::map<oracle::Result, std::int64_t> results;
  std::int64_t moved = 0;
  for (std::int64_t s = cases(1500); s > 0 && !HasFailure(); --s) {
    TestScene<float> scene = small_scene<float>(chance_);
    const SceneView<float> view = scene.view();
    const Boxd bounds = scene.bounds();
    for (int i = 0; i < 8; ++i) {
      const Ray<double> ray = far_ray<double>(chance_, bounds, chance_.one_of({4.0, 30.0, 45.0}));
      if (largest_magnitude(ray.origin) > 1e14) continue; // not valid in float32
      const ListedRay<float> listed = listed_ray<float>(&ray, own_format<double>, 0, view.clip);
      moved += listed.skipped != 0;
      const auto expected =
          expect_nearest(oracle::line(ray.origin, ray.direction), scene, rounding_margin<float>(bounds));
      ++results[expected.result];
      if (expected.result == oracle::Result::unsure) continue;
      NoCounts counts;
      const Hit<float> hit =
          trace_listed<Query::nearest_hit, Robust<float>>(view, NoStructure{}, listed.ray, counts);
      const double t = static_cast<double>(hit.t) + listed.skipped;
      const oracle::Wide rounding = 4 * oracle::Wide(hit.t) * RealTraits<float>::unit_roundoff +
                                    4 * oracle::Wide(t) * RealTraits<double>::unit_roundoff;
      expect_agreement(expected, hit.primitive != no_primitive, t, rounding,
                       [&] { return described(ray.origin, ray.direction); });
    }
  }
  EXPECT_GT(results[oracle::Result::hit], cases(500));
  EXPECT_GT(results[oracle::Result::miss], cases(500));
  EXPECT_GT(moved, cases(2000));
}

TEST_F(FarListedRay, IsTheSameHoweverItsNumbersAreStored) {
  for (std::int64_t i = cases(100'000); i > 0; --i) {
    const Boxd bounds = random_bounds<float>(chance_);
    const Boxf box = cast<float>(padded_bounds<float>(bounds));
    Ray<float> ray = far_ray<float>(chance_, cast<double>(box), 40);
    if (chance_.one_in(2)) ray.t_min = static_cast<float>(chance_.power_of_two(-30, 30));
    if (chance_.one_in(2)) ray.t_max = ray.t_min + static_cast<float>(chance_.power_of_two(-30, 30));
    const Ray<double> wide = loaded<double>(&ray, own_format<float>, 0);
    const ListedRay<float> a = listed_ray<float>(&ray, own_format<float>, 0, box),
                           b = listed_ray<float>(&wide, own_format<double>, 0, box);
    ASSERT_EQ(b.skipped, 0) << described(ray.origin, ray.direction);
    ASSERT_EQ(std::memcmp(&a.ray, &ray, sizeof ray), 0) << described(ray.origin, ray.direction);
    ASSERT_EQ(std::memcmp(&b.ray, &ray, sizeof ray), 0) << described(ray.origin, ray.direction);
  }
}

// t as it is reported of whatever float32's arithmetic finds between the limits that it gets.
TEST_F(FarListedRay, HasLimitsThatLeaveTBetweenThoseGiven) {
  std::int64_t moved = 0;
  for (std::int64_t i = cases(100'000); i > 0; --i) {
    const Boxd bounds = random_bounds<float>(chance_);
    const Boxf box = cast<float>(padded_bounds<float>(bounds));
    Ray<double> ray = far_ray<double>(chance_, cast<double>(box), chance_.one_of({2.0, 40.0}));
    const double there = length(ray.origin) / length(ray.direction);
    ray.t_min =
        there * chance_.one_of({0.0, 0.5, chance_.uniform(0.9, 1.1), 1 + chance_.power_of_two(-50, 0)});
    ray.t_max = std::max(ray.t_min, there) * (1 + chance_.power_of_two(-52, 2));
    if (largest_magnitude(ray.origin) > 1e14) continue;
    const auto [traced, skipped] = listed_ray<float>(&ray, own_format<double>, 0, box);
    if (traced.t_max < 0) continue; // it misses
    moved += skipped != 0;
    const auto reported = [skipped = skipped](float t) { return static_cast<double>(t) + skipped; };
    ASSERT_LT(reported(std::nextafter(traced.t_max, -INFINITY)), ray.t_max)
        << described(ray.origin, ray.direction);
    ASSERT_GT(reported(std::nextafter(traced.t_min, INFINITY)), ray.t_min)
        << described(ray.origin, ray.direction);
    // And not much less than that.
    const double error = 8 * (RealTraits<double>::unit_roundoff * ray.t_max +
                              static_cast<double>(RealTraits<float>::unit_roundoff) * (ray.t_max - skipped));
    ASSERT_GT(reported(traced.t_max), ray.t_max - error) << described(ray.origin, ray.direction);
    ASSERT_LT(reported(traced.t_min), ray.t_min + error) << described(ray.origin, ray.direction);
  }
  EXPECT_GT(moved, cases(10'000));
}

// Hit points of a far camera are as accurate as those of a near one.
TYPED_TEST(FarRay, SurfacePointsAreAccurate) {
  using Real = TypeParam;
  Chance& chance = this->chance_;
  double worst = 0;
  std::string worst_case;
  for (std::int64_t s = cases(5000); s > 0; --s) {
    TestScene<Real> scene = small_scene<Real>(chance);
    const SceneView<Real> view = scene.view();
    const Boxd bounds = scene.bounds();
    for (int i = 0; i < 8; ++i) {
      const Ray<Real> ray = far_ray<Real>(chance, bounds, 12);
      NoCounts counts;
      const Hit<Real> hit = nearest_hit<Robust<Real>>(view, NoStructure{}, ray, counts);
      if (hit.primitive == no_primitive) continue;
      const oracle::Line line = oracle::line(ray.origin, ray.direction);
      const SurfacePoint<Real> point = surface_at<with_all_kinds>(
          view, hit_again(view, ray, hit, [&] { return leaf_of(view, hit.primitive); }));
      const oracle::Point at = oracle::point(point.position), n = oracle::point(point.normal);
      // Measured from the ray: at a grazing hit a rounding moves the point far along the surface.
      const oracle::Wide square = oracle::inner(line.direction, line.direction);
      const oracle::Wide along = oracle::inner(at - line.origin, line.direction) / square;
      const oracle::Wide cosine = oracle::magnitude(oracle::inner(n, line.direction)) / oracle::root(square);
      const double off =
          static_cast<double>(oracle::norm(at - line.at(along)) * cosine / rounding_margin<Real>(bounds));
      if (off <= worst) continue;
      worst = off;
      worst_case = "primitive " + std::to_string(hit.primitive) + "; " +
                   described(ray.origin, ray.direction) + " at " + described(point.position);
    }
  }
  EXPECT_LE(worst, 1) << "margins: " << worst_case;
}

} // namespace
} // namespace masu
