// Random rays aimed at single primitives that are hard cases of intersection: from far away and nearby, along
// edges and axes, grazing, at tips.
//
// Errors are in u M (unit roundoff times the largest coordinate of the scene's bounds), as
// libscene/geometry/margin.h does.
#pragma once

#include "libgrid/trace/trace.h"
#include "renderer/counts.h"
#include "stability/oracle/oracle.h"
#include "stability/test_scene.h"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <type_traits>

namespace masu {

// The parts of margin.h's bound for hits, in u M.
inline constexpr double triangle_error = 85, sphere_error = 60, cone_error = 60;

template <template <class> class Primitive, class T>
constexpr double documented_error(const Primitive<T>&) {
  if (std::is_same_v<Primitive<T>, Triangle<T>>) return triangle_error;
  return std::is_same_v<Primitive<T>, Sphere<T>> ? sphere_error : cone_error;
}

template <class Real, class Primitive>
struct Case {
  Primitive primitive;
  Vec3<Real> origin, direction;
  double unit;    // u M
  Box<Real> clip; // of the scene

  Ray<Real> ray() const { return unbounded_ray(origin, direction); }
};

template <class Real, class Primitive>
std::string case_described(const Case<Real, Primitive>& c) {
  return described(c.primitive) + "; " + described(c.origin, c.direction) + "; uM " + described(c.unit);
}

// Scaled as the renderer's directions: to unit length, or to a largest component between a half and one.
template <class Real>
Vec3<Real> sized(Chance& chance, const Vec3<Real>& direction) {
  if (largest_magnitude(direction) == 0) return {0, 0, 1};
  const Vec3<Real> scaled = scaled_to_one(direction);
  return chance.one_in(2) ? scaled : normalized(scaled);
}

// Bounds of a scene with the primitive and maybe others; not much smaller than the scale.
template <class Primitive>
Boxd scene_bounds(Chance& chance, const Primitive& primitive, double scale) {
  const Boxd own = cast<double>(bounds(primitive));
  if (largest_magnitude(own) >= scale * 0x1p-10 && chance.one_in(2)) return own;
  if (chance.one_in(2)) return join(join(own, chance.in_cube(scale)), Vec3d{0, 0, scale});
  return join(own, Boxd{{-scale, -scale, -scale}, {scale, scale, scale}});
}

// A ray through `target` from `wanted`, or from the nearest point at which a clipped ray can start.
// `towards`: its direction instead, if given.
template <class Real, class Primitive>
Case<Real, Primitive> aimed(Chance& chance, const Primitive& primitive, const Boxd& bounds,
                            const Vec3d& wanted, const Vec3d& target, const Vec3d* towards = nullptr) {
  const Box<Real> clip = cast<Real>(padded_bounds<Real>(bounds));
  Vec3<Real> origin = cast<Real>(wanted);
  if (chance.one_in(3)) origin = nudged(chance, origin, 3);
  for (int axis = 0; axis < 3; ++axis)
    origin.set(axis, std::clamp(origin[axis], clip.min[axis], clip.max[axis]));
  // Sometimes parallel or perpendicular to an axis.
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

// Small differences are drawn down to this many binary digits.
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
  case 0: // thin, or three collinear points
    c = cast<Real>(cast<double>(a) + cast<double>(b - a) * share + chance.in_cube(size * thin));
    if (chance.one_in(2)) c = nudged(chance, cast<Real>(cast<double>(a) + cast<double>(b - a) * share), 3);
    break;
  case 1: // one short side
    b = cast<Real>(cast<double>(a) + chance.in_cube(size * thin));
    break;
  case 2:   // in an axis' plane
  case 3: { // nearly so
    const int axis = chance.whole(0, 2), most = 2 * chance.whole(0, 1);
    b.set(axis, nudged(a[axis], chance.whole(-most, most)));
    c.set(axis, nudged(a[axis], chance.whole(-most, most)));
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

// A scene of one primitive with the case's bounds.
template <class Real, class Primitive>
class Alone {
public:
  explicit Alone(const Case<Real, Primitive>& c) {
    scene_.add(c.primitive);
    view_ = scene_.view();
    view_.clip = c.clip;
  }

  const SceneView<Real>& view() const { return view_; }
  bool hit(const Ray<Real>& ray, Hit<Real>& found) const {
    NoCounts counts;
    found = nearest_hit<Robust<Real>>(view_, NoStructure{}, ray, counts);
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

// Expects what was found to be what the oracle says; t may be off by `rounding`. what(): of the message.
template <class Real, class What>
void expect_agreement(const oracle::Expected& expected, bool met, Real t, oracle::Wide rounding,
                      const What& what) {
  const bool is_hit = expected.result == oracle::Result::hit;
  EXPECT_TRUE(met == is_hit && (!met || (t >= expected.low - rounding && t <= expected.high + rounding)))
      << what() << ": " << (met ? "met at " + described(t) : "missed") << ", expected "
      << (is_hit ? "a hit between " : "a miss ") << static_cast<double>(expected.low) << " and "
      << static_cast<double>(expected.high);
}

// A scene's scale: small, or as large as the scene file allows.
template <class Real>
double unusual_scale(Chance& chance) {
  if constexpr (std::is_same_v<Real, float>) {
    return chance.one_in(2) ? chance.power_of_two(-20, -10) : chance.power_of_two(20, 39.8);
  } else {
    return chance.one_in(2) ? chance.power_of_two(-150, -10) : chance.power_of_two(20, 332);
  }
}

// The type parameters of tests: every kind of primitive.
template <class Real_, template <class> class Primitive_>
struct Kind {
  using Real = Real_;
  template <class T>
  using Primitive = Primitive_<T>;
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

} // namespace masu
