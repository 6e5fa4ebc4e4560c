// Intersection of rays with single primitives, compared with an exact oracle: computed hits lie within the
// error bound of libscene/geometry/margin.h, on which the results' independence of the grid rests.
#include "tests/random_test.h"
#include "tests/ray_case.h"

#include <map>

namespace masu {
namespace {

template <class K>
class RayAndPrimitive : public RandomTest {};
TYPED_TEST_SUITE(RayAndPrimitive, Kinds, KindNames);

// The largest distance of a computed hit from the surface, in u M.
template <class K, class Draw>
void expect_hits_on_the_surface(Chance& chance, std::int64_t tries, const Draw& draw) {
  using Real = typename K::Real;
  double worst = 0, documented = 0;
  std::string worst_case;
  std::int64_t hits = 0;
  for (std::int64_t i = cases(tries); i > 0; --i) {
    const auto c = draw(chance);
    Real t = 0;
    if (!hit(c, t)) continue;
    ++hits;
    documented = documented_error(c.primitive);
    const oracle::Point at = oracle::line(c.origin, c.direction).at(t);
    const double error = static_cast<double>(oracle::distance(at, c.primitive)) / c.unit;
    if (error <= worst) continue;
    worst = error;
    worst_case = case_described(c) + "; t " + described(t);
  }
  EXPECT_GT(hits, cases(tries) / 10);
  testing::Test::RecordProperty("worst_error_in_uM", std::to_string(worst));
  EXPECT_LE(worst, documented) << worst_case;
}

// Conservative grids rely on this bound.
TYPED_TEST(RayAndPrimitive, ComputedHitsLieWithinTheDocumentedErrorOfTheSurface) {
  expect_hits_on_the_surface<TypeParam>(this->chance_, 100'000,
                                        [](Chance& chance) { return TypeParam::random(chance); });
}

TYPED_TEST(RayAndPrimitive, HitsAreAsAccurateAtAnyScale) {
  using Real = typename TypeParam::Real;
  expect_hits_on_the_surface<TypeParam>(this->chance_, 100'000, [](Chance& chance) {
    return TypeParam::random(chance, unusual_scale<Real>(chance));
  });
}

// Directions nearly perpendicular to an axis, with components down to denormal numbers.
TYPED_TEST(RayAndPrimitive, HitsAreAsAccurateAlongDirectionsWithTinyComponents) {
  using Real = typename TypeParam::Real;
  constexpr double lowest = std::is_same_v<Real, float> ? -148 : -1072;
  expect_hits_on_the_surface<TypeParam>(this->chance_, 50'000, [](Chance& chance) {
    for (;;) {
      auto c = TypeParam::random(chance);
      int set = 0;
      for (int axis = 0; axis < 3; ++axis) {
        if (c.direction[axis] != 0) continue;
        c.direction.set(axis, static_cast<Real>(chance.sign() * chance.power_of_two(lowest, -20)));
        ++set;
      }
      if (set > 0) return c;
    }
  });
}

// There are no false hits and no missed ones except within the documented error of an edge, a rim or a
// silhouette; the error of t, measured perpendicular to the surface, is within that bound.
TYPED_TEST(RayAndPrimitive, AgreesWithTheOracle) {
  using Real = typename TypeParam::Real;
  Chance& chance = this->chance_;
  std::map<oracle::Result, std::int64_t> results;
  for (std::int64_t i = cases(60'000); i > 0 && !this->HasFailure(); --i) {
    const auto c = TypeParam::random(chance);
    const auto expected = oracle::expect(oracle::line(c.origin, c.direction), c.primitive,
                                         documented_error(c.primitive) * c.unit);
    ++results[expected.result];
    if (expected.result == oracle::Result::unsure) continue;
    Real t = 0;
    const bool met = hit(c, t);
    expect_agreement(expected, met, t, 0, [&] { return case_described(c); });
  }
  EXPECT_GT(results[oracle::Result::hit], cases(500));
  EXPECT_GT(results[oracle::Result::miss], cases(500));
}

} // namespace
} // namespace masu
