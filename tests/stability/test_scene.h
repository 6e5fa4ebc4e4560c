// Scenes of tests, made by hand or at random, as views to trace; and random numbers.
#pragma once

#include "libgrid/trace/trace.h"
#include "libscene/geometry/cone.h"
#include "libscene/geometry/margin.h"
#include "libscene/scene_view.h"
#include "stability/random_seed.h"

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <initializer_list>
#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace masu {

// --- Random numbers -------------------------------------------------------------------------------------

class Chance {
public:
  explicit Chance(const RandomSeed& seed) : engine_(seed.engine()) {}

  double uniform(double from, double to) { return std::uniform_real_distribution(from, to)(engine_); }
  int whole(int from, int to) { return std::uniform_int_distribution(from, to)(engine_); }
  std::size_t index(std::size_t count) {
    return std::uniform_int_distribution<std::size_t>(0, count - 1)(engine_);
  }
  bool one_in(int n) { return whole(1, n) == 1; }
  double power_of_two(double from, double to) { return std::exp2(uniform(from, to)); }
  double sign() { return one_in(2) ? 1.0 : -1.0; }
  template <class T>
  T one_of(std::initializer_list<T> values) {
    return values.begin()[index(values.size())];
  }
  Vec3d in_box(const Boxd& box) {
    return {uniform(box.min.x, box.max.x), uniform(box.min.y, box.max.y), uniform(box.min.z, box.max.z)};
  }
  Vec3d in_cube(double half) { return in_box({{-half, -half, -half}, {half, half, half}}); }
  // Of unit length.
  Vec3d direction() {
    std::normal_distribution<double> normal;
    for (;;) {
      const Vec3d v{normal(engine_), normal(engine_), normal(engine_)};
      if (dot(v, v) > 1e-6) return normalized(v);
    }
  }
  std::mt19937_64& engine() { return engine_; }

private:
  std::mt19937_64 engine_;
};

// A random unit vector orthogonal to `v`.
inline Vec3d across(Chance& chance, const Vec3d& v) {
  for (;;) {
    const Vec3d c = cross(v, chance.direction());
    if (largest_magnitude(c) > 1e-3 * largest_magnitude(v)) return normalized(c * (1 / largest_magnitude(c)));
  }
}

// v scaled by a power of two to a largest component between a half and one; {1, 0, 0} for zero.
template <class Real>
Vec3<Real> scaled_to_one(const Vec3<Real>& v) {
  int exponent = 0;
  std::frexp(largest_magnitude(v), &exponent);
  if (largest_magnitude(v) == 0) return {1, 0, 0};
  return {std::ldexp(v.x, -exponent), std::ldexp(v.y, -exponent), std::ldexp(v.z, -exponent)};
}

// Moved by `steps` representable numbers.
template <class Real>
Real nudged(Real value, int steps) {
  const Real towards = steps < 0 ? -RealTraits<Real>::largest : RealTraits<Real>::largest;
  for (int i = std::abs(steps); i > 0; --i)
    value = std::nextafter(value, towards);
  return value;
}
template <class Real>
Vec3<Real> nudged(Chance& chance, const Vec3<Real>& v, int most) {
  return {nudged(v.x, chance.whole(-most, most)), nudged(v.y, chance.whole(-most, most)),
          nudged(v.z, chance.whole(-most, most))};
}

// Rounded to Real. Through memory, because GCC 12 drops such conversions when it vectorises them.
template <class Real>
double kept(double value) {
  volatile Real stored = static_cast<Real>(value);
  return static_cast<double>(stored);
}
template <class Real>
Vec3d kept(const Vec3d& v) {
  return {kept<Real>(v.x), kept<Real>(v.y), kept<Real>(v.z)};
}
template <class Real>
Boxd kept(const Boxd& box) {
  return {kept<Real>(box.min), kept<Real>(box.max)};
}

// --- Scenes ---------------------------------------------------------------------------------------------

template <class Stored>
Triangle<Stored> triangle_of(const Vec3<Stored>& a, const Vec3<Stored>& b, const Vec3<Stored>& c) {
  return {a, 0, b, 0, c, no_normals};
}
template <class Stored>
Triangle<Stored> triangle_of(const Vec3d& a, const Vec3d& b,
                             const Vec3d& c) requires(!std::is_same_v<Stored, double>) {
  return triangle_of<Stored>(cast<Stored>(a), cast<Stored>(b), cast<Stored>(c));
}
template <class Stored>
Sphere<Stored> sphere_of(const Vec3d& center, double radius) {
  return cast<Stored>(Sphere<double>{center, radius});
}
template <class Stored>
Cone<Stored> cone_of(const Vec3d& base, double base_radius, const Vec3d& apex, double apex_radius) {
  return cast<Stored>(Cone<double>{base, base_radius, apex, apex_radius});
}

// Calls act(primitives) for a scene's list of each kind.
template <class SceneOfAKind, class Act>
void for_each_kind(SceneOfAKind& scene, const Act& act) {
  act(scene.triangles);
  act(scene.spheres);
  act(scene.cones);
}
// Calls act(primitive) for each of a scene.
template <class SceneOfAKind, class Act>
void for_each_primitive(SceneOfAKind& scene, const Act& act) {
  for_each_kind(scene, [&](auto& primitives) {
    for (auto& primitive : primitives)
      act(primitive);
  });
}
// Calls act(points…) with those that a primitive is moved by; and for each primitive of a scene.
template <class Stored, class Act>
void with_points(Triangle<Stored>& triangle, const Act& act) {
  act(triangle.a, triangle.b, triangle.c);
}
template <class Stored, class Act>
void with_points(Sphere<Stored>& sphere, const Act& act) {
  act(sphere.center);
}
template <class Stored, class Act>
void with_points(Cone<Stored>& cone, const Act& act) {
  act(cone.base, cone.apex);
}
template <class SceneOfAKind, class Act>
void for_each_points(SceneOfAKind& scene, const Act& act) {
  for_each_primitive(scene, [&](auto& primitive) { with_points(primitive, act); });
}

// Owns what its view points to.
template <class Stored>
struct TestScene {
  std::vector<Triangle<Stored>> triangles;
  std::vector<CornerNormals<Stored>> normals;
  std::vector<Sphere<Stored>> spheres;
  std::vector<Cone<Stored>> cones;
  std::vector<Surface> surfaces; // shared by spheres and cones; view() fills it
  Material material{{1, 1, 1}, 1, 0, 0, 0, 1};

  void add(const Triangle<Stored>& triangle) { triangles.push_back(triangle); }
  void add(const Sphere<Stored>& sphere) { spheres.push_back(sphere); }
  void add(const Cone<Stored>& cone) { cones.push_back(cone); }
  // Behind its own, those of another scene.
  void add(const TestScene& other) {
    for_each_primitive(other, [&](const auto& primitive) { add(primitive); });
  }

  std::uint32_t count() const {
    return static_cast<std::uint32_t>(triangles.size() + spheres.size() + cones.size());
  }

  // As in the scene file.
  Boxd bounds() const {
    Boxd box = empty_box<double>();
    for_each_primitive(
        *this, [&](const auto& primitive) { box = join(box, cast<double>(masu::bounds(primitive))); });
    return box;
  }

  SceneView<Stored> view() {
    surfaces.assign(std::max(spheres.size(), cones.size()), Surface{0, 0});
    const auto number = [](const auto& records) { return static_cast<std::uint32_t>(records.size()); };
    return {triangles.data(),
            nullptr,
            normals.data(),
            spheres.data(),
            surfaces.data(),
            cones.data(),
            surfaces.data(),
            nullptr,
            &material,
            number(triangles),
            number(spheres),
            number(cones),
            cast<Stored>(padded_bounds<Stored>(bounds()))};
  }
};

// The same primitives in another store, or in an arithmetic's numbers.
template <class Real, class Stored>
TestScene<Real> converted(const TestScene<Stored>& scene) {
  TestScene<Real> result;
  for_each_primitive(scene, [&](const auto& primitive) { result.add(cast<Real>(primitive)); });
  return result;
}

// --- Tracing --------------------------------------------------------------------------------------------

template <class Real, unsigned kinds = with_all_kinds>
using Robust = Method<WatertightRay<Real>, kinds>;

template <class Real>
WatertightRay<Real> prepared(const Vec3<Real>& origin, const Vec3<Real>& direction) {
  WatertightRay<Real> ray;
  prepare(ray, origin, direction);
  return ray;
}

// --- Descriptions ---------------------------------------------------------------------------------------

// With every digit, so that a case can be reproduced.
template <class T>
std::string described(const Vec3<T>& v) {
  std::ostringstream out;
  out << std::hexfloat << '{' << v.x << ", " << v.y << ", " << v.z << '}';
  return out.str();
}
template <class T>
std::string described(T value) {
  std::ostringstream out;
  out << std::hexfloat << value;
  return out.str();
}
template <class T>
std::string described(const Triangle<T>& t) {
  return "triangle " + described(t.a) + ' ' + described(t.b) + ' ' + described(t.c);
}
template <class T>
std::string described(const Sphere<T>& s) {
  return "sphere " + described(s.center) + " radius " + described(s.radius);
}
template <class T>
std::string described(const Cone<T>& c) {
  return "cone " + described(c.base) + " radius " + described(c.base_radius) + " to " + described(c.apex) +
         " radius " + described(c.apex_radius);
}
template <class T>
std::string described(const Vec3<T>& origin, const Vec3<T>& direction) {
  return "ray " + described(origin) + " towards " + described(direction);
}

} // namespace masu
