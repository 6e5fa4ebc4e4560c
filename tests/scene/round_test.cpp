// Rays and the special cases of spheres and cones: insides, open ends, bounds.
#include "tests/random_test.h"
#include "tests/ray_case.h"

namespace masu {
namespace {

template <class Real, class Primitive>
testing::AssertionResult meets_at(const Primitive& primitive, const Vec3<Real>& origin,
                                  const Vec3<Real>& direction, double wanted) {
  Real t = 0;
  if (!intersect(prepared(origin, direction), primitive, Real(0), t))
    return testing::AssertionFailure() << "missed";
  if (std::abs(static_cast<double>(t) - wanted) <= 1e-6) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "met at " << t << " instead of " << wanted;
}
template <class Real, class Primitive>
bool misses(const Primitive& primitive, const Vec3<Real>& origin, const Vec3<Real>& direction) {
  Real t = 0;
  return !intersect(prepared(origin, direction), primitive, Real(0), t);
}

template <class Real>
class RayAndRound : public RandomTest {};
TYPED_TEST_SUITE(RayAndRound, Reals);

TYPED_TEST(RayAndRound, NegativeRadiusShowsOnlyTheInside) {
  using Real = TypeParam;
  const Vec3<Real> left{-5, 0, 0}, middle{0, 0, 0}, right{5, 0, 0}, x{1, 0, 0};
  EXPECT_TRUE(meets_at(Sphere<Real>{{0, 0, 0}, 2}, left, x, 3));
  EXPECT_TRUE(meets_at(Sphere<Real>{{0, 0, 0}, -2}, left, x, 7));
  EXPECT_TRUE(meets_at(Sphere<Real>{{0, 0, 0}, -2}, middle, x, 2));
  EXPECT_TRUE(misses(Sphere<Real>{{0, 0, 0}, -2}, right, x));
  EXPECT_TRUE(meets_at(Cone<Real>{{0, -1, 0}, 2, {0, 1, 0}, 2}, left, x, 3));
  EXPECT_TRUE(meets_at(Cone<Real>{{0, -1, 0}, -2, {0, 1, 0}, -2}, left, x, 7));
  EXPECT_TRUE(meets_at(Cone<Real>{{0, -1, 0}, -3, {0, 1, 0}, -1}, middle, x, 2));
  EXPECT_TRUE(meets_at(Cone<Real>{{0, -2, 0}, -4, {0, 2, 0}, 0}, left, x, 7));
  EXPECT_TRUE(misses(Cone<Real>{{0, -1, 0}, -2, {0, 1, 0}, -2}, right, x));
}

TYPED_TEST(RayAndRound, ConesAreOpenAtTheirEnds) {
  using Real = TypeParam;
  const Cone<Real> pipe{{0, 0, 0}, 1, {0, 0, 4}, 1}, tip{{0, 0, 0}, 2, {0, 0, 4}, 0},
      flare{{0, 0, 0}, 1, {0, 0, 4}, 3};
  EXPECT_TRUE(misses(pipe, Vec3<Real>{0, 0, -1}, Vec3<Real>{0, 0, 1}));
  EXPECT_TRUE(misses(pipe, Vec3<Real>{0.5, 0.25, -1}, Vec3<Real>{0, 0, 1}));
  EXPECT_TRUE(misses(pipe, Vec3<Real>{2, 0, -1}, Vec3<Real>{0, 0, 1}));
  EXPECT_TRUE(misses(tip, Vec3<Real>{-5, 0, 5}, Vec3<Real>{1, 0, 0}));
  EXPECT_TRUE(misses(tip, Vec3<Real>{-5, 0, -1}, Vec3<Real>{1, 0, 0}));
  // Parallel to the axis, from inside out through the side.
  EXPECT_TRUE(meets_at(tip, Vec3<Real>{1, 0, 0.5}, Vec3<Real>{0, 0, 1}, 1.5));
  EXPECT_TRUE(meets_at(flare, Vec3<Real>{2, 0, 3.5}, Vec3<Real>{0, 0, -1}, 1.5));
  // Parallel to one side: one hit on the other side.
  EXPECT_TRUE(meets_at(flare, Vec3<Real>{0, 0, 3}, Vec3<Real>{-0.5, 0, -1}, 2.5));
  EXPECT_TRUE(meets_at(tip, Vec3<Real>{0, 0, 1}, Vec3<Real>{-0.5, 0, 1}, 1.5));
}

// Perpendicular to the axis up to the smallest numbers, or a rounding: the ray reaches the ends' planes only
// far from the axis, where there must be no hit.
TYPED_TEST(RayAndRound, RaysBeyondTheEndsMiss) {
  using Real = TypeParam;
  Chance& chance = this->chance_;
  constexpr double lowest = std::is_same_v<Real, float> ? -148 : -1072;
  std::int64_t hits = 0;
  std::string first;
  for (std::int64_t i = cases(100'000); i > 0; --i) {
    const auto whole = [&] { return static_cast<double>(chance.whole(1, 3)) * chance.sign(); };
    const bool exact = chance.one_in(2);
    const Vec3d up = exact ? Vec3d{whole(), whole(), whole()} : chance.direction();
    const Vec3d base{whole(), whole(), whole()};
    const double radius = chance.whole(1, 4);
    const Cone<Real> cone = cone_of<Real>(base, radius, base + up, chance.one_of({radius, 0.0, 0.5}));
    const Vec3d beyond = base + up * chance.one_of({-0.5, 1.5, 2.0, -1.0});
    Vec3d across =
        exact ? Vec3d{0, up.z / 4, -up.y / 4} : masu::across(chance, cast<double>(cone.apex - cone.base));
    const Vec3<Real> origin = cast<Real>(beyond + across * chance.uniform(-3, 3));
    if (exact) across.x = chance.sign() * chance.power_of_two(chance.one_in(2) ? lowest : -60, -30);
    const Boxd box{{-20, -20, -20}, {20, 20, 20}};
    const Case<Real, Cone<Real>> c{cone, origin, cast<Real>(across), 0, cast<Real>(box)};
    Real t = 0;
    if (!hit(c, t) || ++hits > 1) continue;
    first = case_described(c) + " met at " + described(t);
  }
  EXPECT_EQ(hits, 0) << first;
}

// Scenes whose cones are all cylinders use specialised code: adding a cone must not change any hit.
TYPED_TEST(RayAndRound, CylinderCodeGivesTheBitsOfConeCode) {
  using Real = TypeParam;
  Chance& chance = this->chance_;
  std::int64_t hits = 0;
  for (std::int64_t i = cases(100'000); i > 0; --i) {
    Case<Real, Cone<Real>> c = random_case<Real, Cone>(chance, chance.power_of_two(-10, 20));
    c.primitive.apex_radius = c.primitive.base_radius;
    PreparedRay<Real> ray{};
    prepare(ray, c.origin, c.direction);
    Real as_cone = 0, as_cylinder = 0;
    const bool met = intersect<true>(ray, c.primitive, Real(0), as_cone);
    ASSERT_EQ(met, intersect<false>(ray, c.primitive, Real(0), as_cylinder)) << case_described(c);
    ASSERT_EQ(bits_of(as_cone), bits_of(as_cylinder)) << case_described(c);
    hits += met ? 1 : 0;
  }
  EXPECT_GT(hits, cases(100'000) / 10);
}

// Rays are clipped to this box, and voxels list cones by it: it must contain every point of the side.
TYPED_TEST(RayAndRound, BoundsContainTheWholeCone) {
  using Real = TypeParam;
  Chance& chance = this->chance_;
  double worst = 0;
  std::string worst_case;
  for (std::int64_t i = cases(50'000); i > 0; --i) {
    const Cone<Real> cone = random_cone<Real>(chance, chance.power_of_two(-10, 20));
    const Boxd box = bounds(cone);
    const oracle::Profile side = oracle::profile(cone);
    for (int axis = 0; axis < 3; ++axis) {
      // The extent of an end's disc along an axis is its radius times the sine of the angle between them.
      Vec3d axis_vector{};
      axis_vector.set(axis, 1);
      const oracle::Point unit = oracle::point(axis_vector);
      const oracle::Wide sine = oracle::norm(oracle::outer(side.up, unit));
      for (const bool at_apex : {false, true}) {
        const oracle::Point center = oracle::point(at_apex ? cone.apex : cone.base);
        const oracle::Wide reach =
            sine * std::abs(static_cast<double>(at_apex ? cone.apex_radius : cone.base_radius));
        const oracle::Wide at = oracle::inner(center, unit);
        const oracle::Wide out = oracle::max(box.min[axis] - (at - reach), (at + reach) - box.max[axis]);
        const double share = static_cast<double>(out) /
                             (static_cast<double>(RealTraits<Real>::unit_roundoff) * largest_magnitude(box));
        if (share <= worst) continue;
        worst = share;
        worst_case = described(cone);
      }
    }
  }
  this->RecordProperty("worst_excess_in_uM", std::to_string(worst));
  EXPECT_LE(worst, 4) << "u M outside: " << worst_case;
}

} // namespace
} // namespace masu
