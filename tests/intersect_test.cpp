// Rays and single primitives: the tracer's answer against the oracle's, and the two promises on which all
// else rests: a computed hit lies within libscene/margin.h's bound of the surface, and closed meshes let no
// ray out.
//
// Errors are told in u M (unit roundoff times the largest coordinate of the scene's bounds), as margin.h
// does.
#include "libgrid/trace.h"
#include "libscene/surface.h"
#include "renderer/counts.h"
#include "tests/oracle.h"
#include "tests/random_mesh.h"
#include "tests/test_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <map>
#include <utility>

namespace masu {
namespace {

using Arithmetics = testing::Types<float, double>;

// What margin.h grants the hit, of the margin that covers all; and what can be asked of clip.h.
constexpr double triangle_error = 85, sphere_error = 60, cone_error = 60, clip_error = 8;

template <class T>
constexpr double documented_error(const Triangle<T>&) {
  return triangle_error;
}
template <class T>
constexpr double documented_error(const Sphere<T>&) {
  return sphere_error;
}
template <class T>
constexpr double documented_error(const Cone<T>&) {
  return cone_error;
}

// --- Cases -----------------------------------------------------------------------------------------------

template <class Real, class Primitive>
struct Case {
  Primitive primitive;
  Vec3<Real> origin, direction;
  double unit;    // u M
  Box<Real> clip; // of the scene

  Ray<Real> ray() const { return {origin, direction, RealTraits<Real>::largest}; }
};

template <class Real, class Primitive>
std::string case_described(const Case<Real, Primitive>& c) {
  return described(c.primitive) + "; " + described(c.origin, c.direction) + "; uM " + described(c.unit);
}

// Of the lengths that the renderer traces: one, or with a largest component between a half and one.
template <class Real>
Vec3<Real> sized(Chance& chance, const Vec3<Real>& direction) {
  int exponent = 0;
  std::frexp(largest_magnitude(direction), &exponent);
  const Vec3<Real> scaled{std::ldexp(direction.x, -exponent), std::ldexp(direction.y, -exponent),
                          std::ldexp(direction.z, -exponent)};
  if (largest_magnitude(scaled) == 0) return {0, 0, 1};
  return chance.one_in(2) ? scaled : normalized(scaled);
}

// The bounds of a scene that holds the primitive, and perhaps more; not much smaller than the scale.
template <class Primitive>
Boxd scene_bounds(Chance& chance, const Primitive& primitive, double scale) {
  const Boxd own = cast<double>(bounds(primitive));
  if (largest_magnitude(own) >= scale * 0x1p-10 && chance.one_in(2)) return own;
  if (chance.one_in(2)) return join(join(own, chance.in_cube(scale)), Vec3d{0, 0, scale});
  return join(own, Boxd{{-scale, -scale, -scale}, {scale, scale, scale}});
}

// A ray through `target` from `wanted`, or from as close to it as a clipped ray can start; `towards` is kept
// where the origin was not moved and a direction is wanted.
template <class Real, class Primitive>
Case<Real, Primitive> aimed(Chance& chance, const Primitive& primitive, const Boxd& bounds,
                            const Vec3d& wanted, const Vec3d& target, const Vec3d* towards = nullptr) {
  const Box<Real> clip = cast<Real>(padded_bounds<Real>(bounds));
  Vec3<Real> origin = cast<Real>(wanted);
  if (chance.one_in(3)) origin = nudged(chance, origin, 3);
  for (int axis = 0; axis < 3; ++axis)
    origin.set(axis, std::clamp(origin[axis], clip.min[axis], clip.max[axis]));
  // Now and then along an axis, or across one.
  const Vec3<Real> aim = cast<Real>(target);
  if (chance.one_in(6)) {
    const int kept = chance.whole(0, 2);
    for (int axis = 0; axis < 3; ++axis) {
      if (axis != kept && chance.one_in(2) && aim[axis] >= clip.min[axis] && aim[axis] <= clip.max[axis])
        origin.set(axis, aim[axis]);
    }
  }
  Vec3<Real> direction = towards != nullptr ? cast<Real>(*towards) : aim - origin;
  if (largest_magnitude(direction) == 0) direction = cast<Real>(chance.direction());
  direction = sized(chance, direction);
  if (chance.one_in(4)) {
    const Vec3<Real> near = nudged(chance, direction, 3);
    for (int axis = 0; axis < 3; ++axis)
      if (direction[axis] != 0) direction.set(axis, near[axis]);
  }
  return {primitive, origin, direction,
          static_cast<double>(RealTraits<Real>::unit_roundoff) * largest_magnitude(bounds), clip};
}

// How many of a number's digits a small difference may be lost behind.
template <class Real>
constexpr double digits = std::numeric_limits<Real>::digits;

template <class Real>
Triangle<Real> random_triangle(Chance& chance, double scale) {
  const double size = scale * chance.power_of_two(-digits<Real>, 0);
  const Vec3d around = chance.in_cube(chance.one_of({0.0, size, scale}));
  Vec3<Real> a = cast<Real>(around + chance.in_cube(size)), b = cast<Real>(around + chance.in_cube(size)),
             c = cast<Real>(around + chance.in_cube(size));
  const double share = chance.uniform(-0.5, 1.5), thin = chance.power_of_two(-1.2 * digits<Real>, -2);
  switch (chance.whole(0, 6)) {
  case 0: // a needle, or three points in a row
    c = cast<Real>(cast<double>(a) + cast<double>(b - a) * share + chance.in_cube(size * thin));
    if (chance.one_in(2)) c = nudged(chance, cast<Real>(cast<double>(a) + cast<double>(b - a) * share), 3);
    break;
  case 1: // one short side
    b = cast<Real>(cast<double>(a) + chance.in_cube(size * thin));
    break;
  case 2: { // in an axis' plane
    const int axis = chance.whole(0, 2);
    b.set(axis, a[axis]);
    c.set(axis, a[axis]);
    break;
  }
  case 3: { // nearly so
    const int axis = chance.whole(0, 2);
    b.set(axis, nudged(a[axis], chance.whole(-2, 2)));
    c.set(axis, nudged(a[axis], chance.whole(-2, 2)));
    break;
  }
  default:
    break;
  }
  return triangle_of(a, b, c);
}

template <class Real>
Case<Real, Triangle<Real>> random_triangle_case(Chance& chance, double scale) {
  const Triangle<Real> triangle = random_triangle<Real>(chance, scale);
  const Boxd bounds = scene_bounds(chance, triangle, scale);
  const Vec3d a = cast<double>(triangle.a), b = cast<double>(triangle.b), c = cast<double>(triangle.c);
  double u = chance.uniform(0, 1), v = chance.uniform(0, 1);
  if (u + v > 1) u = 1 - u, v = 1 - v;
  switch (chance.whole(0, 4)) {
  case 0: // on an edge
    v = 0;
    break;
  case 1: // on a corner
    u = chance.one_of({0.0, 1.0});
    v = 0;
    break;
  case 2: // by an edge
    v = chance.sign() * chance.power_of_two(-digits<Real> - 4, -4);
    break;
  default:
    break;
  }
  const Vec3d target = a + (b - a) * u + (c - a) * v;
  const Vec3d in_plane = (b - a) * chance.uniform(-1, 1) + (c - a) * chance.uniform(-1, 1);
  const double far = chance.power_of_two(0, digits<Real>);
  switch (chance.whole(0, 5)) {
  case 0: // edge-on
    return aimed<Real>(chance, triangle, bounds, target + in_plane * far, target);
  case 1:
    return aimed<Real>(chance, triangle, bounds, target + in_plane * far, target, &in_plane);
  case 2: // along an edge
    return aimed<Real>(chance, triangle, bounds, a + (a - b) * far, target);
  case 3: // from close by
    return aimed<Real>(chance, triangle, bounds,
                       target + chance.in_cube(scale * chance.power_of_two(-digits<Real>, 0)), target);
  default:
    return aimed<Real>(chance, triangle, bounds, chance.in_box(bounds), target);
  }
}

template <class Real>
Case<Real, Sphere<Real>> random_sphere_case(Chance& chance, double scale) {
  const double radius = scale * chance.power_of_two(-digits<Real>, 0);
  const Sphere<Real> sphere = sphere_of<Real>(chance.in_cube(chance.one_of({0.0, radius, scale})),
                                              radius * (chance.one_in(4) ? -1 : 1));
  const Boxd bounds = scene_bounds(chance, sphere, scale);
  const Vec3d center = cast<double>(sphere.center), out = chance.direction();
  const double off = 1 + chance.sign() * chance.power_of_two(-digits<Real> - 4, 0);
  switch (chance.whole(0, 6)) {
  case 0: { // grazing
    const Vec3d target = center + out * (radius * off), along = across(chance, out);
    return aimed<Real>(chance, sphere, bounds, target - along * (scale * chance.power_of_two(-20, 0)),
                       target);
  }
  case 1: // from inside
    return aimed<Real>(chance, sphere, bounds, center + chance.direction() * (radius * chance.uniform(0, 1)),
                       center + out * radius);
  case 2: // from the surface
    return aimed<Real>(chance, sphere, bounds, center + out * (radius * off),
                       center + chance.direction() * (radius * chance.uniform(0, 1.2)));
  case 3: // from the center
    return aimed<Real>(chance, sphere, bounds, center, center + out);
  case 4: { // from the surface, along it
    const Vec3d along = across(chance, out);
    return aimed<Real>(chance, sphere, bounds, center + out * (radius * off), center, &along);
  }
  default:
    return aimed<Real>(chance, sphere, bounds, chance.in_box(bounds),
                       center + out * (radius * chance.uniform(0, 1.2)));
  }
}

template <class Real>
Cone<Real> random_cone(Chance& chance, double scale) {
  Vec3d up = chance.direction();
  if (chance.one_in(2)) { // along an axis, or nearly
    Vec3d axis{};
    axis.set(chance.whole(0, 2), chance.sign());
    up = chance.one_in(2) ? axis : axis + up * chance.power_of_two(-digits<Real>, -3);
  }
  const double length = scale * chance.power_of_two(-20, 0),
               base_radius = scale * chance.power_of_two(-20, 0);
  double apex_radius = base_radius;
  switch (chance.whole(0, 5)) {
  case 0:
    break;
  case 1:
    apex_radius = 0;
    break;
  case 2: // hardly tapers
    apex_radius = base_radius * (1 + chance.sign() * chance.power_of_two(-30, -15));
    break;
  case 3: // nearly pointed
    apex_radius = base_radius * chance.power_of_two(-40, -5);
    break;
  default:
    apex_radius = scale * chance.power_of_two(-20, 0);
    break;
  }
  const Vec3d base = chance.in_cube(chance.one_of({0.0, length, scale}));
  const double inside = chance.one_in(5) ? -1 : 1;
  Cone<Real> cone = cone_of<Real>(base, inside * base_radius, base + up * length, inside * apex_radius);
  if (cone.base == cone.apex) cone.apex.x = nudged(cone.apex.x, 3);
  if (chance.one_in(2)) {
    std::swap(cone.base, cone.apex);
    std::swap(cone.base_radius, cone.apex_radius);
  }
  return cone;
}

template <class Real>
Case<Real, Cone<Real>> random_cone_case(Chance& chance, double scale) {
  const Cone<Real> cone = random_cone<Real>(chance, scale);
  const Boxd bounds = scene_bounds(chance, cone, scale);
  const Vec3d base = cast<double>(cone.base), apex = cast<double>(cone.apex), axis = apex - base;
  const double r0 = std::abs(static_cast<double>(cone.base_radius)),
               r1 = std::abs(static_cast<double>(cone.apex_radius));
  double z = chance.uniform(-0.1, 1.1);
  if (chance.one_in(3)) { // by an end
    z = chance.power_of_two(-50, 0);
    if (chance.one_in(2)) z = 1 - z;
  }
  const Vec3d out = across(chance, axis);
  const double radius = std::max(0.0, r0 + (r1 - r0) * z);
  const Vec3d target = base + axis * z + out * radius;
  const Vec3d generator = axis + out * (r1 - r0);
  const Vec3d round = cross(axis, out) * (1 / length(axis));
  const double far = chance.sign() * scale * chance.power_of_two(-20, 1) / length(axis);
  const double off = 1 + chance.sign() * chance.power_of_two(-digits<Real> - 4, 0);
  switch (chance.whole(0, 9)) {
  case 0: // parallel to the axis
    return aimed<Real>(chance, cone, bounds, target + axis * far, target, &axis);
  case 1: // nearly so
    return aimed<Real>(chance, cone, bounds,
                       target + axis * far + chance.in_cube(scale * chance.power_of_two(-40, -3)), target);
  case 2: // along the axis
    return aimed<Real>(chance, cone, bounds, base + axis * far, apex, &axis);
  case 3: // along the side
    return aimed<Real>(chance, cone, bounds, target + generator * far, target, &generator);
  case 4: // nearly so
    return aimed<Real>(chance, cone, bounds,
                       target + generator * far + chance.in_cube(scale * chance.power_of_two(-40, -3)),
                       target);
  case 5: { // grazing
    const Vec3d beside = base + axis * z + out * (radius * off);
    return aimed<Real>(chance, cone, bounds,
                       beside + round * far * length(axis) + generator * chance.uniform(-1, 1), beside);
  }
  case 6: // from inside
    return aimed<Real>(chance, cone, bounds, base + axis * chance.uniform(0, 1), target);
  case 7: // to the smaller end
    return aimed<Real>(chance, cone, bounds, chance.in_box(bounds), r0 < r1 ? base : apex);
  default:
    return aimed<Real>(chance, cone, bounds, chance.in_box(bounds), target);
  }
}

template <class Real, template <class> class Primitive>
Case<Real, Primitive<Real>> random_case(Chance& chance, double scale) {
  if constexpr (std::is_same_v<Primitive<Real>, Triangle<Real>>) {
    return random_triangle_case<Real>(chance, scale);
  } else if constexpr (std::is_same_v<Primitive<Real>, Sphere<Real>>) {
    return random_sphere_case<Real>(chance, scale);
  } else {
    return random_cone_case<Real>(chance, scale);
  }
}

// A scene of this primitive alone, in the case's own bounds.
template <class Real, class Primitive>
class Alone {
public:
  explicit Alone(const Case<Real, Primitive>& c) {
    if constexpr (std::is_same_v<Primitive, Triangle<Real>>) {
      scene_.triangles = {c.primitive};
    } else if constexpr (std::is_same_v<Primitive, Sphere<Real>>) {
      scene_.spheres = {c.primitive};
    } else {
      scene_.cones = {c.primitive};
    }
    view_ = scene_.view();
    view_.clip = c.clip;
  }

  const SceneView<Real>& view() const { return view_; }
  bool hit(const Ray<Real>& ray, Hit<Real>& found) const {
    NoCounts counts;
    found = nearest_hit<Robust<Real>>(view_, NoGrid{}, ray, counts);
    return found.primitive != no_primitive;
  }

private:
  TestScene<Real> scene_;
  SceneView<Real> view_;
};

template <class Real, class Primitive>
bool hit(const Case<Real, Primitive>& c, Real& t) {
  Hit<Real> found;
  const bool met = Alone(c).hit(c.ray(), found);
  t = found.t;
  return met;
}

// --- Every kind ------------------------------------------------------------------------------------------

template <class Real_, template <class> class Primitive>
struct Kind {
  using Real = Real_;
  static auto random(Chance& chance) {
    return random_case<Real, Primitive>(chance, chance.power_of_two(-10, 20));
  }
  static auto random(Chance& chance, double scale) { return random_case<Real, Primitive>(chance, scale); }
};
using Kinds = testing::Types<Kind<float, Triangle>, Kind<double, Triangle>, Kind<float, Sphere>,
                             Kind<double, Sphere>, Kind<float, Cone>, Kind<double, Cone>>;
struct KindNames {
  template <class K>
  static std::string GetName(int number) {
    constexpr std::array names{"triangle", "sphere", "cone"};
    return std::string(names[static_cast<std::size_t>(number / 2)]) +
           (std::is_same_v<typename K::Real, float> ? "_float" : "_double");
  }
};

template <class K>
class RayAndPrimitive : public testing::Test {
protected:
  RandomSeed seed_;
};
TYPED_TEST_SUITE(RayAndPrimitive, Kinds, KindNames);

// The largest distance of a computed hit from the surface, in u M.
template <class K, class Draw>
void expect_hits_on_the_surface(const RandomSeed& seed, std::int64_t tries, const Draw& draw) {
  using Real = typename K::Real;
  SCOPED_TRACE(seed.trace());
  Chance chance(seed);
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

// The property on which the grid's invisibility rests.
TYPED_TEST(RayAndPrimitive, ComputedHitsLieWithinTheDocumentedErrorOfTheSurface) {
  expect_hits_on_the_surface<TypeParam>(this->seed_, 100'000,
                                        [](Chance& chance) { return TypeParam::random(chance); });
}

// A scene's scale: smaller than usual, a millionth of a unit at least, or as large as the scene file takes
// it.
template <class Real>
double unusual_scale(Chance& chance) {
  if constexpr (std::is_same_v<Real, float>) {
    return chance.one_in(2) ? chance.power_of_two(-20, -10) : chance.power_of_two(20, 39.8);
  } else {
    return chance.one_in(2) ? chance.power_of_two(-150, -10) : chance.power_of_two(20, 332);
  }
}

TYPED_TEST(RayAndPrimitive, HitsAreAsGoodInScenesOfAnyScale) {
  using Real = typename TypeParam::Real;
  expect_hits_on_the_surface<TypeParam>(this->seed_, 100'000, [](Chance& chance) {
    return TypeParam::random(chance, unusual_scale<Real>(chance));
  });
}

// Directions all but across an axis, down to denormal components.
TYPED_TEST(RayAndPrimitive, HitsAreAsGoodAlongDirectionsWithTinyComponents) {
  using Real = typename TypeParam::Real;
  constexpr double lowest = std::is_same_v<Real, float> ? -148 : -1072;
  expect_hits_on_the_surface<TypeParam>(this->seed_, 50'000, [](Chance& chance) {
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

// Nothing is hit that isn't there, nor missed that is, but within the documented error of an edge, a rim or a
// silhouette; and t is right to that error, taken across the surface.
TYPED_TEST(RayAndPrimitive, AgreesWithTheOracle) {
  using Real = typename TypeParam::Real;
  SCOPED_TRACE(this->seed_.trace());
  Chance chance(this->seed_);
  std::map<oracle::Answer, std::int64_t> answers;
  std::int64_t wrong = 0;
  std::string first;
  for (std::int64_t i = cases(60'000); i > 0; --i) {
    const auto c = TypeParam::random(chance);
    const auto expected = oracle::expect(oracle::line(c.origin, c.direction), c.primitive,
                                         documented_error(c.primitive) * c.unit);
    ++answers[expected.answer];
    if (expected.answer == oracle::Answer::unsure) continue;
    Real t = 0;
    const bool met = hit(c, t);
    bool good = met == (expected.answer == oracle::Answer::hit);
    if (good && met) good = oracle::Wide(t) >= expected.low && oracle::Wide(t) <= expected.high;
    if (good || ++wrong > 1) continue;
    std::ostringstream out;
    out << case_described(c) << (met ? ": met at " + described(t) : ": missed") << ", expected "
        << (expected.answer == oracle::Answer::hit ? "a hit between " : "a miss ")
        << static_cast<double>(expected.low) << " and " << static_cast<double>(expected.high);
    first = out.str();
  }
  EXPECT_EQ(wrong, 0) << first;
  EXPECT_GT(answers[oracle::Answer::hit], cases(500));
  EXPECT_GT(answers[oracle::Answer::miss], cases(500));
}

// --- Triangles -------------------------------------------------------------------------------------------

template <class Real>
class RayAndMesh : public testing::Test {
protected:
  RandomSeed seed_;
};
TYPED_TEST_SUITE(RayAndMesh, Arithmetics);

// Sides of edges are decided exactly, so neither the order of the corners nor their winding can show. (t may
// differ in its last bits: its sums are rounded in another order.)
TYPED_TEST(RayAndMesh, TheOrderOfCornersDoesNotDecideWhetherATriangleIsHit) {
  using Real = TypeParam;
  SCOPED_TRACE(this->seed_.trace());
  Chance chance(this->seed_);
  double worst = 0;
  for (std::int64_t i = cases(200'000); i > 0; --i) {
    const auto c = random_triangle_case<Real>(chance, chance.power_of_two(-10, 20));
    const RayFrame<Real> ray = prepared(c.origin, c.direction);
    const std::array corners{c.primitive.a, c.primitive.b, c.primitive.c};
    Real first = 0;
    const bool met = intersect(ray, c.primitive, first);
    for (const auto& order :
         {std::array{0U, 2U, 1U}, {1U, 0U, 2U}, {1U, 2U, 0U}, {2U, 0U, 1U}, {2U, 1U, 0U}}) {
      Real t = 0;
      const Triangle<Real> turned = triangle_of(corners[order[0]], corners[order[1]], corners[order[2]]);
      ASSERT_EQ(intersect(ray, turned, t), met) << case_described(c);
      if (met) worst = std::max(worst, std::abs(static_cast<double>(t - first)) / c.unit);
    }
  }
  this->RecordProperty("worst_difference_of_t_in_uM", std::to_string(worst));
  EXPECT_LE(worst, 2 * triangle_error);
}

// Somewhere among the numbers that Real holds; or on a raster so coarse that differences, too, are exact.
template <class Real>
Mesh<Real> placed(Chance& chance, const Mesh<double>& mesh, bool raster, Vec3<Real>& origin) {
  const double scale = chance.power_of_two(-10, 20),
               unit = raster ? std::exp2(std::round(std::log2(scale))) : scale;
  const Vec3d at = raster ? Vec3d{0, 0, 0} : chance.in_cube(chance.one_of({0.0, unit, 100 * unit}));
  const auto place = [&](const Vec3d& v) {
    if (!raster) return cast<Real>(at + v * unit);
    const auto round = [](double c) { return std::round(c * 1024) / 1024; };
    return cast<Real>(Vec3d{round(v.x), round(v.y), round(v.z)} * unit);
  };
  origin = place(chance.one_in(4) ? Vec3d{0, 0, 0} : chance.in_cube(0.1));
  Mesh<Real> result{{}, mesh.faces};
  for (const Vec3d& corner : mesh.corners)
    result.corners.push_back(place(corner));
  return result;
}

TYPED_TEST(RayAndMesh, NoRayLeavesAClosedMeshThroughItsEdgesAndCorners) {
  using Real = TypeParam;
  SCOPED_TRACE(this->seed_.trace());
  Chance chance(this->seed_);
  constexpr int rays_a_mesh = 1000;
  std::int64_t leaks = 0;
  std::string first;
  for (std::int64_t m = cases(1000); m > 0; --m) {
    Vec3<Real> origin;
    const Mesh<Real> mesh = placed<Real>(chance, random_mesh(chance), chance.one_in(2), origin);
    std::vector<Triangle<Real>> triangles;
    for (const auto& [a, b, c] : mesh.faces)
      triangles.push_back(triangle_of(mesh.corners[a], mesh.corners[b], mesh.corners[c]));
    std::size_t start = 0;
    for (int i = 0; i < rays_a_mesh; ++i) {
      const auto& face = mesh.faces[chance.index(mesh.faces.size())];
      const std::size_t corner = chance.index(3);
      const Vec3<Real> a = mesh.corners[face[corner]], b = mesh.corners[face[(corner + 1) % 3]];
      const Real share = static_cast<Real>(chance.one_of({0.0, 0.0, 0.5, 0.25, chance.uniform(0, 1)}));
      const Vec3<Real> towards = sized(chance, fused(b - a, share, a) - origin);
      const RayFrame<Real> ray = prepared(origin, towards);
      bool met = false;
      // From the face that stopped the last ray on: any order will do.
      for (std::size_t n = 0; n < triangles.size() && !met; ++n) {
        Real t = 0;
        met = intersect(ray, triangles[start], t) && t > 0;
        if (!met) start = start + 1 == triangles.size() ? 0 : start + 1;
      }
      if (met || ++leaks > 1) continue;
      first = described(origin, towards) + " aimed at the edge from " + described(a) + " to " + described(b);
    }
  }
  EXPECT_EQ(leaks, 0) << first;
}

// --- Spheres and cones -----------------------------------------------------------------------------------

template <class Real, class Primitive>
testing::AssertionResult meets_at(const Primitive& primitive, const Vec3<Real>& origin,
                                  const Vec3<Real>& direction, double wanted) {
  Real t = 0;
  if (!intersect(prepared(origin, direction), primitive, t)) return testing::AssertionFailure() << "missed";
  if (std::abs(static_cast<double>(t) - wanted) <= 1e-6) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "met at " << t << " instead of " << wanted;
}
template <class Real, class Primitive>
bool misses(const Primitive& primitive, const Vec3<Real>& origin, const Vec3<Real>& direction) {
  Real t = 0;
  return !intersect(prepared(origin, direction), primitive, t);
}

template <class Real>
class RayAndRound : public testing::Test {};
TYPED_TEST_SUITE(RayAndRound, Arithmetics);

TYPED_TEST(RayAndRound, ANegativeRadiusShowsTheInsideOnly) {
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

TYPED_TEST(RayAndRound, AConeIsOpenAtItsEnds) {
  using Real = TypeParam;
  const Cone<Real> pipe{{0, 0, 0}, 1, {0, 0, 4}, 1}, tip{{0, 0, 0}, 2, {0, 0, 4}, 0},
      flare{{0, 0, 0}, 1, {0, 0, 4}, 3};
  EXPECT_TRUE(misses(pipe, Vec3<Real>{0, 0, -1}, Vec3<Real>{0, 0, 1}));
  EXPECT_TRUE(misses(pipe, Vec3<Real>{0.5, 0.25, -1}, Vec3<Real>{0, 0, 1}));
  EXPECT_TRUE(misses(pipe, Vec3<Real>{2, 0, -1}, Vec3<Real>{0, 0, 1}));
  EXPECT_TRUE(misses(tip, Vec3<Real>{-5, 0, 5}, Vec3<Real>{1, 0, 0}));
  EXPECT_TRUE(misses(tip, Vec3<Real>{-5, 0, -1}, Vec3<Real>{1, 0, 0}));
  // Parallel to the axis, inside, and out through the side.
  EXPECT_TRUE(meets_at(tip, Vec3<Real>{1, 0, 0.5}, Vec3<Real>{0, 0, 1}, 1.5));
  EXPECT_TRUE(meets_at(flare, Vec3<Real>{2, 0, 3.5}, Vec3<Real>{0, 0, -1}, 1.5));
  // Parallel to one side, which leaves one place to meet the other.
  EXPECT_TRUE(meets_at(flare, Vec3<Real>{0, 0, 3}, Vec3<Real>{-0.5, 0, -1}, 2.5));
  EXPECT_TRUE(meets_at(tip, Vec3<Real>{0, 0, 1}, Vec3<Real>{-0.5, 0, 1}, 1.5));
}

// Across the axis but for the smallest numbers, or a rounding: the ray reaches the ends' planes only where it
// is far off the axis, and must not be taken for met there.
TYPED_TEST(RayAndRound, ARayThatPassesBeyondTheEndsMisses) {
  using Real = TypeParam;
  const RandomSeed seed;
  SCOPED_TRACE(seed.trace());
  Chance chance(seed);
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

// The scene is clipped to this box, and voxels list the cone by it: no point of the side may lie outside.
TYPED_TEST(RayAndRound, BoundsHoldTheWholeCone) {
  using Real = TypeParam;
  const RandomSeed seed;
  SCOPED_TRACE(seed.trace());
  Chance chance(seed);
  double worst = 0;
  std::string worst_case;
  for (std::int64_t i = cases(50'000); i > 0; --i) {
    const Cone<Real> cone = random_cone<Real>(chance, chance.power_of_two(-10, 20));
    const Boxd box = bounds(cone);
    const oracle::Profile side = oracle::profile(cone);
    for (int axis = 0; axis < 3; ++axis) {
      // An end's disc reaches as far along the axis as its radius times the sine of the angle to it.
      Vec3d axis_vector{};
      axis_vector.set(axis, 1);
      const oracle::Point unit = oracle::point(axis_vector);
      const oracle::Wide sine = oracle::norm(oracle::outer(side.up, unit));
      for (const bool at_apex : {false, true}) {
        const oracle::Point center = oracle::point(at_apex ? cone.apex : cone.base);
        const oracle::Wide reach =
            sine * std::abs(static_cast<double>(at_apex ? cone.apex_radius : cone.base_radius));
        const oracle::Wide at = oracle::inner(center, unit);
        const oracle::Wide out = oracle::most(box.min[axis] - (at - reach), (at + reach) - box.max[axis]);
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

// --- Rays from afar --------------------------------------------------------------------------------------

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
    interval.enter = oracle::most(interval.enter, oracle::least(t0, t1));
    interval.leave = oracle::least(interval.leave, oracle::most(t0, t1));
  }
  return interval;
}

// Whether the ray starts beyond the box on a side that it doesn't come back to.
template <class Real>
bool starts_beyond(const Boxd& box, const Ray<Real>& ray) {
  for (int axis = 0; axis < 3; ++axis) {
    const auto origin = static_cast<double>(ray.origin[axis]);
    if (ray.direction[axis] >= 0 && origin > box.max[axis]) return true;
    if (ray.direction[axis] <= 0 && origin < box.min[axis]) return true;
  }
  return false;
}

// From up to 2^`distance` times the box's size away, aimed at what's in it or by its side.
template <class Real>
Ray<Real> from_afar(Chance& chance, const Boxd& box, double distance) {
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
  return {origin, sized(chance, aim - origin), RealTraits<Real>::largest};
}

template <class Real>
class RayFromAfar : public testing::Test {
protected:
  RandomSeed seed_;
};
TYPED_TEST_SUITE(RayFromAfar, Arithmetics);

template <class Real>
Boxd random_bounds(Chance& chance) {
  const double scale = chance.power_of_two(-10, 20);
  const Vec3d at = chance.in_cube(chance.one_of({0.0, scale, 100 * scale}));
  Boxd box{at, at};
  box = join(box, at + chance.in_cube(scale));
  if (chance.one_in(4)) box.max.set(2, box.min.z);
  return kept<Real>(box);
}

TYPED_TEST(RayFromAfar, ClippingKeepsTheRayAndMissesNothing) {
  using Real = TypeParam;
  SCOPED_TRACE(this->seed_.trace());
  Chance chance(this->seed_);
  double worst_off = 0, worst_late = 0, worst_outside = 0;
  std::string worst_case;
  for (std::int64_t i = cases(200'000); i > 0; --i) {
    const Boxd bounds = random_bounds<Real>(chance);
    const Box<Real> box = cast<Real>(padded_bounds<Real>(bounds));
    const Boxd wide = cast<double>(box);
    const Ray<Real> ray = from_afar<Real>(chance, wide, 23.25);
    const double unit = static_cast<double>(RealTraits<Real>::unit_roundoff) * largest_magnitude(wide);
    const oracle::Line line = oracle::line(ray.origin, ray.direction);
    // Where hits can lie: the padding beyond may be entered late, or missed.
    const Interval met = slabs(line, grown(bounds, rounding_margin<Real>(bounds)));
    ClippedRay<Real> clipped;
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
  // Rounded once a coordinate from nearby, and once before that from a few times the box's size.
  EXPECT_LE(worst_off, clip_error) << worst_case;
  EXPECT_LE(worst_late, clip_error);
  // From up to 256 times the box's size it is looked for once, and held back by 8 roundings of that, with 4
  // of its own: of the difference, the inverse, their product, and that held back. Then the origin is
  // rounded.
  EXPECT_LE(worst_outside, (8 + 4) * 256 + 1);
}

// What the oracle expects of a scene: nothing where any primitive leaves it unsure.
template <class Real>
oracle::Expected expect_nearest(const oracle::Line& line, const TestScene<Real>& scene, double slack) {
  oracle::Expected nearest{oracle::Answer::miss, 0, 0};
  const auto look = [&](const auto& primitives) {
    for (const auto& primitive : primitives) {
      const oracle::Expected one = oracle::expect(line, primitive, slack);
      if (one.answer == oracle::Answer::miss || nearest.answer == oracle::Answer::unsure) continue;
      if (one.answer == oracle::Answer::unsure || nearest.answer == oracle::Answer::miss) {
        nearest = one;
        continue;
      }
      nearest.low = oracle::least(nearest.low, one.low);
      nearest.high = oracle::least(nearest.high, one.high);
    }
  };
  look(scene.triangles);
  look(scene.spheres);
  look(scene.cones);
  return nearest;
}

template <class Real>
TestScene<Real> small_scene(Chance& chance) {
  const double scale = chance.power_of_two(-10, 20);
  TestScene<Real> scene;
  for (int i = chance.whole(1, 3); i > 0; --i) {
    const Vec3d at = chance.in_cube(scale);
    const auto corner = [&] { return at + chance.in_cube(scale / 2); };
    scene.triangles.push_back(
        triangle_of<Real>(cast<Real>(corner()), cast<Real>(corner()), cast<Real>(corner())));
    scene.spheres.push_back(sphere_of<Real>(chance.in_cube(scale), scale * chance.uniform(0.05, 0.5)));
    scene.cones.push_back(cone_of<Real>(corner(), scale * chance.uniform(0.1, 0.3), corner(),
                                        scale * chance.uniform(0.1, 0.3)));
  }
  return scene;
}

TYPED_TEST(RayFromAfar, FindsTheOraclesNearestHit) {
  using Real = TypeParam;
  SCOPED_TRACE(this->seed_.trace());
  Chance chance(this->seed_);
  std::map<oracle::Answer, std::int64_t> answers;
  std::int64_t wrong = 0;
  std::string first;
  for (std::int64_t s = cases(1500); s > 0; --s) {
    TestScene<Real> scene = small_scene<Real>(chance);
    const SceneView<Real> view = scene.view();
    const Boxd bounds = scene.bounds();
    for (int i = 0; i < 8; ++i) {
      const Ray<Real> ray = from_afar<Real>(chance, bounds, 23.25);
      const auto expected =
          expect_nearest(oracle::line(ray.origin, ray.direction), scene, rounding_margin<Real>(bounds));
      ++answers[expected.answer];
      if (expected.answer == oracle::Answer::unsure) continue;
      NoCounts counts;
      const Hit<Real> hit = nearest_hit<Robust<Real>>(view, NoGrid{}, ray, counts);
      const bool met = hit.primitive != no_primitive;
      bool good = met == (expected.answer == oracle::Answer::hit);
      // The t from afar is rounded once or twice more.
      const oracle::Wide rounding = 4 * oracle::Wide(hit.t) * RealTraits<Real>::unit_roundoff;
      if (good && met) good = hit.t >= expected.low - rounding && hit.t <= expected.high + rounding;
      if (good || ++wrong > 1) continue;
      std::ostringstream out;
      out << described(ray.origin, ray.direction) << ": " << (met ? described(hit.t) : "missed")
          << ", expected " << (expected.answer == oracle::Answer::hit ? "a hit between " : "a miss ")
          << static_cast<double>(expected.low) << " and " << static_cast<double>(expected.high);
      first = out.str();
    }
  }
  EXPECT_EQ(wrong, 0) << first;
  EXPECT_GT(answers[oracle::Answer::hit], cases(500));
  EXPECT_GT(answers[oracle::Answer::miss], cases(500));
}

// --- The surface at a hit --------------------------------------------------------------------------------

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

// Which way the front faces at a point of the surface; any length. None where a triangle's edges, rounded,
// have no side any more.
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
  // By a pointed end rounding leaves no direction off the axis.
  if (distance <= 64 * RealTraits<Real>::unit_roundoff * extent(c)) return {0, 0, 0};
  const oracle::Point away = off * (1 / distance);
  return (away - side.up * side.slope) * (c.base_radius < 0 || c.apex_radius < 0 ? -1 : 1);
}

// A triangle is left on either side, the others to the outside: to where they never are again.
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

template <class K, class Draw>
void expect_good_surfaces(const RandomSeed& seed, std::int64_t tries, const Draw& draw) {
  using Real = typename K::Real;
  SCOPED_TRACE(seed.trace());
  Chance chance(seed);
  constexpr double u = static_cast<double>(RealTraits<Real>::unit_roundoff);
  std::int64_t hits = 0, bad_normals = 0, wrong_sides = 0, self_hits = 0;
  double worst_off = 0;
  std::string normal_case, side_case, off_case, self_case;
  for (std::int64_t i = cases(tries); i > 0; --i) {
    const auto c = draw(chance);
    const Alone alone(c);
    Hit<Real> found;
    if (!alone.hit(c.ray(), found)) continue;
    ++hits;
    const SurfacePoint<Real> point = surface_at<with_all_kinds>(alone.view(), c.ray(), found);
    const Vec3<Real>& n = point.normal;
    const double square = static_cast<double>(oracle::inner(oracle::point(n), oracle::point(n)));
    if (!(std::abs(square - 1) <= 16 * u)) {
      if (++bad_normals == 1) normal_case = case_described(c) + " normal " + described(n);
      continue;
    }
    const oracle::Point at = oracle::point(point.position);
    const oracle::Point facing = front(c.primitive, at);
    if (oracle::inner(oracle::point(n), facing) < 0 && ++wrong_sides == 1)
      side_case = case_described(c) + " normal " + described(n);
    const double off = static_cast<double>(oracle::distance(at, c.primitive) / extent(c.primitive)) / u;
    if (!(off <= worst_off)) {
      worst_off = off;
      off_case = case_described(c) + " position " + described(point.position);
    }
    if (!has_two_sides(c.primitive) && oracle::inner(facing, facing) == 0) continue; // a tip
    for (int k = 0; k < 4; ++k) {
      Vec3<Real> towards = cast<Real>(chance.direction());
      if (k > 1) { // along the surface, nearly
        const Vec3d along = masu::across(chance, cast<double>(n));
        towards = cast<Real>(along + cast<double>(n) * (chance.sign() * chance.power_of_two(-30, -3)));
      }
      const bool outside = (dot(towards, n) > 0) != is_inside_out(c.primitive);
      if (!outside && !has_two_sides(c.primitive)) towards = -towards;
      if (dot(towards, n) == 0) continue;
      const Real by = dot(towards, n) < 0 ? -point.error : point.error;
      const Vec3<Real> origin = fused(n, by, point.position);
      Hit<Real> again;
      if (alone.hit({origin, towards, RealTraits<Real>::largest}, again) && ++self_hits == 1)
        self_case = case_described(c) + " left by " + described(origin, towards) + " met again at " +
                    described(again.t);
    }
  }
  EXPECT_GT(hits, cases(tries) / 10);
  testing::Test::RecordProperty("worst_position_in_u_extent", std::to_string(worst_off));
  EXPECT_EQ(bad_normals, 0) << "of " << hits << " aren't of unit length: " << normal_case;
  EXPECT_EQ(wrong_sides, 0) << "of " << hits << " normals don't point to the front: " << side_case;
  EXPECT_EQ(self_hits, 0) << "of " << hits << " times: " << self_case;
  EXPECT_LE(worst_off, 4 * std::sqrt(3.0)) << "u extent: " << off_case;
}

TYPED_TEST(RayAndPrimitive, RaysThatLeaveASurfaceDoNotMeetItAgain) {
  expect_good_surfaces<TypeParam>(this->seed_, 40'000,
                                  [](Chance& chance) { return TypeParam::random(chance); });
}

TYPED_TEST(RayAndPrimitive, SurfacesAreAsGoodInScenesOfAnyScale) {
  expect_good_surfaces<TypeParam>(this->seed_, 20'000, [](Chance& chance) {
    return TypeParam::random(chance, unusual_scale<typename TypeParam::Real>(chance));
  });
}

// The eye may be far off: what it sees must be placed as well as from nearby.
TYPED_TEST(RayFromAfar, SurfacesLieWhereTheRayMeetsThem) {
  using Real = TypeParam;
  SCOPED_TRACE(this->seed_.trace());
  Chance chance(this->seed_);
  double worst = 0;
  std::string worst_case;
  for (std::int64_t s = cases(5000); s > 0; --s) {
    TestScene<Real> scene = small_scene<Real>(chance);
    const SceneView<Real> view = scene.view();
    const Boxd bounds = scene.bounds();
    for (int i = 0; i < 8; ++i) {
      const Ray<Real> ray = from_afar<Real>(chance, bounds, 12);
      NoCounts counts;
      const Hit<Real> hit = nearest_hit<Robust<Real>>(view, NoGrid{}, ray, counts);
      if (hit.primitive == no_primitive) continue;
      const oracle::Line line = oracle::line(ray.origin, ray.direction);
      const SurfacePoint<Real> point = surface_at<with_all_kinds>(view, ray, hit);
      const oracle::Point at = oracle::point(point.position), n = oracle::point(point.normal);
      // Off the ray, that is; what a rounding moves a surface met aslant counts for little.
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
