// What is reported of a hit on a triangle, however thin it is: the side, the normal and the weights.
#include "libscene/geometry/orientation.h"
#include "libscene/geometry/surface.h"
#include "tests/random_test.h"
#include "tests/ray_case.h"

namespace masu {
namespace {

template <class Real>
class TriangleHits : public RandomTest {};
TYPED_TEST_SUITE(TriangleHits, Reals);

// direction · (b - a) × (c - a).
template <class Real>
oracle::Wide volume(const Triangle<Real>& t, const Vec3<Real>& direction) {
  return oracle::inner(oracle::point(direction), oracle::outer(oracle::point(t.b) - oracle::point(t.a),
                                                               oracle::point(t.c) - oracle::point(t.a)));
}

// Multiples of 2^-28, and numbers of type float: 113 bits hold sums of their products of three exactly.
template <class Real>
Vec3<Real> of_few_bits(const Vec3<Real>& v) {
  const auto rounded = [](Real value) {
    return static_cast<Real>(
        static_cast<float>(std::nearbyint(static_cast<double>(value) * 0x1p28) * 0x1p-28));
  };
  return {rounded(v.x), rounded(v.y), rounded(v.z)};
}

// Edge-on, nearly so, and whose corners are on a line, or nearly.
TYPED_TEST(TriangleHits, TheSideThatIsMetIsExact) {
  using Real = TypeParam;
  Chance& chance = this->chance_;
  int fronts = 0, backs = 0, none = 0, close = 0;
  for (std::int64_t i = cases(200'000); i > 0; --i) {
    const auto whole = [&] {
      return Vec3<Real>{static_cast<Real>(chance.whole(-9, 9)), static_cast<Real>(chance.whole(-9, 9)),
                        static_cast<Real>(chance.whole(-9, 9))};
    };
    Triangle<Real> triangle = random_triangle<Real>(chance, 1);
    for (Vec3<Real>* const corner : {&triangle.a, &triangle.b, &triangle.c})
      *corner = of_few_bits(chance.one_in(8) ? whole() : *corner);
    const Vec3d a = cast<double>(triangle.a), along = cast<double>(triangle.b) - a,
                other = cast<double>(triangle.c) - a;
    Vec3d wanted =
        chance.one_in(2) ? chance.direction() : along * chance.uniform(-1, 1) + other * chance.uniform(-1, 1);
    if (!(largest_magnitude(wanted) > 1e-20)) wanted = {1, 0, 0};
    const Vec3<Real> direction = of_few_bits(chance.one_in(8) ? whole() : cast<Real>(scaled_to_one(wanted)));
    const oracle::Wide exact = volume(triangle, direction);
    ASSERT_EQ(meets_front(direction, triangle), exact <= 0)
        << described(triangle) << " seen along " << described(direction);
    (exact < 0 ? fronts : exact > 0 ? backs : none) += 1;
    const oracle::Wide size =
        oracle::norm(oracle::point(direction)) * oracle::Wide(length(along)) * oracle::Wide(length(other));
    close += exact != 0 && oracle::magnitude(exact) < 1e-12 * size ? 1 : 0;
  }
  for (const int count : {fronts, backs, none, close})
    EXPECT_GT(count, cases(200));
}

TYPED_TEST(TriangleHits, NormalsAndWeightsOfSliversAreRight) {
  using Real = TypeParam;
  Chance& chance = this->chance_;
  const double off_by = sizeof(Real) == sizeof(float) ? 1e-13 : 1e-3; // of doubles, differences are rounded
  std::int64_t hits = 0;
  for (std::int64_t i = cases(40'000); i > 0; --i) {
    const Vec3d a = chance.in_cube(1), along = chance.direction() * chance.uniform(0.1, 1);
    const double width = chance.power_of_two(sizeof(Real) == sizeof(float) ? -24 : -38, -4);
    const Vec3d side = across(chance, along) * width;
    const Triangle<Real> triangle = triangle_of(cast<Real>(a), cast<Real>(a + along),
                                                cast<Real>(a + along * chance.uniform(0, 1) + side));
    const Vec3d target = a + along * chance.uniform(0, 1) + side * chance.uniform(-0.5, 1);
    const Vec3<Real> origin = cast<Real>(chance.in_cube(1));
    const Vec3<Real> direction = cast<Real>(target) - origin;
    const WatertightRay<Real> ray = prepared(origin, direction);
    Real t;
    if (!intersect(ray, triangle, t)) continue;
    ++hits;
    const TriangleHit hit = triangle_hit(ray, t, triangle);
    const std::string what = described(triangle) + "; " + described(origin, direction);
    ASSERT_GE(hit.u, 0) << what;
    ASSERT_GE(hit.v, 0) << what;
    ASSERT_LE(hit.u + hit.v, 1 + 1e-15) << what;
    const oracle::Point exact = oracle::outer(oracle::point(triangle.b) - oracle::point(triangle.a),
                                              oracle::point(triangle.c) - oracle::point(triangle.a));
    if (oracle::norm(exact) == 0) continue;
    const oracle::Point off = oracle::outer(oracle::point(hit.normal), exact * (1 / oracle::norm(exact)));
    ASSERT_LE(static_cast<double>(oracle::norm(off)), off_by) << what;
    ASSERT_GE(oracle::inner(oracle::point(hit.normal), exact), 0) << what;
    // What the weights lead to is as near to the ray as the hit.
    const oracle::Point at = oracle::point(triangle.a) * (1 - oracle::Wide(hit.u) - oracle::Wide(hit.v)) +
                             oracle::point(triangle.b) * oracle::Wide(hit.u) +
                             oracle::point(triangle.c) * oracle::Wide(hit.v);
    const oracle::Point from = at - oracle::point(origin), d = oracle::point(direction);
    const double aside = static_cast<double>(oracle::norm(oracle::outer(from, d)) / oracle::norm(d));
    ASSERT_LE(aside, 2 * triangle_error * static_cast<double>(RealTraits<Real>::unit_roundoff)) << what;
  }
  EXPECT_GT(hits, cases(5000));
}

} // namespace
} // namespace masu
