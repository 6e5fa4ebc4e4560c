// Random rays through a scene's bounds, for measurements and samples.
#pragma once

#include "libscene/geometry/box.h"
#include "libscene/geometry/ray.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace masu {

// SplitMix64's finalizer (Steele, Lea & Flood, OOPSLA 2014): every bit of the result depends on every bit of
// z.
inline std::uint64_t mixed_bits(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
  return z ^ (z >> 31);
}

// SplitMix64: a sequence of its own for each ray, so that rays can be made
// in parallel.
class RandomSequence {
public:
  RandomSequence(std::uint64_t seed, std::uint64_t ray)
      : state_(mixed_bits(seed) ^ mixed_bits(ray + 0x632be59bd9b4e019U)) {}

  // In [0, 1).
  double uniform() {
    state_ += 0x9e3779b97f4a7c15U;
    return static_cast<double>(mixed_bits(state_) >> 11) * 0x1p-53;
  }

private:
  std::uint64_t state_;
};

// Uniform over the unit sphere.
inline Vec3d random_direction(RandomSequence& random) {
  const double z = 2 * random.uniform() - 1, turn = 2 * std::numbers::pi * random.uniform();
  const double across = std::sqrt(std::max(0.0, 1 - z * z));
  return {across * std::cos(turn), across * std::sin(turn), z};
}

// About a surface's normal, of unit length, with cosine distribution: towards a random point of the unit
// sphere tangent to the surface.
inline Vec3d random_diffuse_direction(const Vec3d& normal, RandomSequence& random) {
  return normalized(normal + random_direction(random) * (1 - 1e-6));
}

// Of a scene without primitives: around the cube of side 2.
inline Sphere<double> sphere_around(const Boxd& bounds) {
  const Boxd box = is_empty(bounds) ? Boxd{{-1, -1, -1}, {1, 1, 1}} : bounds;
  const Vec3d center = (box.min + box.max) * 0.5;
  return {center, length(box.max - center)};
}

// Between two random points of the sphere; t = 1 is the second one. Its coordinates are numbers of type
// Stored.
template <class Stored>
Ray<double> random_ray(const Sphere<double>& sphere, RandomSequence& random) {
  const Vec3d from = fma(random_direction(random), sphere.radius, sphere.center);
  const Vec3d to = fma(random_direction(random), sphere.radius, sphere.center);
  return unbounded_ray(cast<double>(cast<Stored>(from)), cast<double>(cast<Stored>(to - from)));
}

} // namespace masu
