// The surface at a hit: position and normal, and no self-intersection of secondary rays.
#include "libscene/geometry/surface.h"
#include "tests/random_test.h"
#include "tests/ray_case.h"

namespace masu {
namespace {

template <class Real>
oracle::Wide extent(const Triangle<Real>& t) {
  return std::max(largest_magnitude(t.a), std::max(largest_magnitude(t.b), largest_magnitude(t.c)));
}
template <class Real>
oracle::Wide extent(const Sphere<Real>& s) {
  return oracle::Wide(largest_magnitude(s.center)) + std::abs(s.radius);
}
template <class Real>
oracle::Wide extent(const Cone<Real>& c) {
  return oracle::Wide(std::max(largest_magnitude(c.base), largest_magnitude(c.apex))) +
         std::max(std::abs(c.base_radius), std::abs(c.apex_radius));
}

// The normal at a point of the surface, of any length. Zero where a triangle is too thin to have one after
// rounding.
template <class Real>
oracle::Point front(const Triangle<Real>& t, const oracle::Point&) {
  const oracle::Point ab = oracle::point(t.b) - oracle::point(t.a),
                      ac = oracle::point(t.c) - oracle::point(t.a);
  const oracle::Point normal = oracle::outer(ab, ac);
  const bool needle =
      oracle::norm(normal) <= 8 * RealTraits<Real>::unit_roundoff * oracle::norm(ab) * oracle::norm(ac);
  return needle ? oracle::Point{0, 0, 0} : normal;
}
template <class Real>
oracle::Point front(const Sphere<Real>& s, const oracle::Point& at) {
  return (at - oracle::point(s.center)) * (s.radius < 0 ? -1 : 1);
}
template <class Real>
oracle::Point front(const Cone<Real>& c, const oracle::Point& at) {
  const oracle::Profile side = oracle::profile(c);
  const oracle::Point off = at - side.base - side.up * side.height(at);
  const oracle::Wide distance = oracle::norm(off);
  // Near a pointed end the direction is lost to rounding.
  if (distance <= 64 * RealTraits<Real>::unit_roundoff * extent(c)) return {0, 0, 0};
  const oracle::Point away = off * (1 / distance);
  return (away - side.up * side.slope) * (c.base_radius < 0 || c.apex_radius < 0 ? -1 : 1);
}

// Rays may leave a triangle on either side, other primitives only to the outside, where they can't hit them
// again.
template <class Real>
constexpr bool has_two_sides(const Triangle<Real>&) {
  return true;
}
template <class Real, template <class> class Primitive>
constexpr bool has_two_sides(const Primitive<Real>&) {
  return false;
}
template <class Real>
bool is_inside_out(const Triangle<Real>&) {
  return false;
}
template <class Real>
bool is_inside_out(const Sphere<Real>& sphere) {
  return sphere.radius < 0;
}

template <class K>
class SurfaceAtHit : public RandomTest {};
TYPED_TEST_SUITE(SurfaceAtHit, Kinds, KindNames);

template <class K, class Draw>
void expect_good_surfaces(Chance& chance, std::int64_t tries, const Draw& draw) {
  using Real = typename K::Real;
  constexpr double u = static_cast<double>(RealTraits<Real>::unit_roundoff);
  std::int64_t hits = 0;
  double worst_off = 0;
  std::string off_case;
  for (std::int64_t i = cases(tries); i > 0 && !testing::Test::HasFailure(); --i) {
    const auto c = draw(chance);
    const Alone alone(c);
    Hit<Real> found{};
    if (!alone.hit(c.ray(), found)) continue;
    ++hits;
    const SurfacePoint<Real> point = surface_at<with_all_kinds>(
        alone.view(),
        hit_again(alone.view(), c.ray(), found, [&] { return leaf_of(alone.view(), found.primitive); }));
    const Vec3<Real>& n = point.normal;
    const double square = static_cast<double>(oracle::inner(oracle::point(n), oracle::point(n)));
    ASSERT_LE(std::abs(square - 1), 16 * u)
        << "not of unit length: " << case_described(c) << " normal " << described(n);
    const oracle::Point at = oracle::point(point.position);
    const oracle::Point facing = front(c.primitive, at);
    EXPECT_TRUE(oracle::inner(oracle::point(n), facing) >= 0)
        << "not to the front: " << case_described(c) << " normal " << described(n);
    const double off = static_cast<double>(oracle::distance(at, c.primitive) / extent(c.primitive)) / u;
    if (!(off <= worst_off)) {
      worst_off = off;
      off_case = case_described(c) + " position " + described(point.position);
    }
    if (!has_two_sides(c.primitive) && oracle::inner(facing, facing) == 0) continue; // a tip
    for (int k = 0; k < 4; ++k) {
      Vec3<Real> towards = cast<Real>(chance.direction());
      if (k > 1) { // nearly tangential
        const Vec3d along = masu::across(chance, cast<double>(n));
        towards = cast<Real>(along + cast<double>(n) * (chance.sign() * chance.power_of_two(-30, -3)));
      }
      const bool outside = (dot(towards, n) > 0) != is_inside_out(c.primitive);
      if (!outside && !has_two_sides(c.primitive)) towards = -towards;
      if (dot(towards, n) == 0) continue;
      const Vec3<Real> origin = leaving(point, towards);
      Hit<Real> again{};
      EXPECT_FALSE(alone.hit(unbounded_ray(origin, towards), again))
          << case_described(c) << " left by " << described(origin, towards) << " met again at "
          << described(again.t);
    }
  }
  EXPECT_GT(hits, cases(tries) / 10);
  testing::Test::RecordProperty("worst_position_in_u_extent", std::to_string(worst_off));
  EXPECT_LE(worst_off, 4 * std::sqrt(3.0)) << "u extent: " << off_case;
}

TYPED_TEST(SurfaceAtHit, SecondaryRaysDoNotHitTheirSurface) {
  expect_good_surfaces<TypeParam>(this->chance_, 40'000,
                                  [](Chance& chance) { return TypeParam::random(chance); });
}

TYPED_TEST(SurfaceAtHit, SurfacesAreAsAccurateAtAnyScale) {
  expect_good_surfaces<TypeParam>(this->chance_, 20'000, [](Chance& chance) {
    return TypeParam::random(chance, unusual_scale<typename TypeParam::Real>(chance));
  });
}

} // namespace
} // namespace masu
