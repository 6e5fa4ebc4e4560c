// Random rays that are hard cases of traversal: parallel and perpendicular to axes, through corners of voxels
// and primitives, from faces, from far away.
#pragma once

#include "libscene/geometry/ray.h"
#include "stability/same_bits.h"
#include "tests/random_grid.h"

namespace masu {

template <class Real>
class RayMaker {
public:
  RayMaker(Chance& chance, const TestScene<Real>& scene, const Boxd& bounds, const Structure& grid)
      : chance_(chance), scene_(scene), bounds_(bounds), grid_(grid), finest_(finest_layout(grid)) {}

  Ray<Real> ray() {
    if (chance_.one_in(16)) return very_far_ray();
    const Vec3<Real> target = point();
    Vec3<Real> origin = chance_.one_in(4) ? far_point(target) : point();
    // Perpendicular to one axis, or to two: share coordinates with the target.
    if (chance_.one_in(3)) {
      const int axis = chance_.whole(0, 2);
      origin.set(axis, target[axis]);
      if (chance_.one_in(2)) origin.set((axis + 1) % 3, target[(axis + 1) % 3]);
    }
    if (origin == target) origin = cast<Real>(chance_.in_box(padded()));
    Vec3<Real> direction = scaled_to_one(target - origin);
    for (int axis = 0; axis < 3; ++axis) {
      if (direction[axis] == 0 && chance_.one_in(4)) direction.set(axis, Real(-0.0));
      if (direction[axis] == 0 && chance_.one_in(4)) direction.set(axis, tiny());
    }
    return {origin, 0, direction,
            chance_.one_in(4) ? static_cast<Real>(size() * chance_.power_of_two(-6, 3))
                              : RealTraits<Real>::largest};
  }

  // From up to 1e30 (double: 1e90) times the scene's size away. Rounding moves such an origin by many sizes;
  // along whole numbers the ray meets the scene nevertheless, where that is round zero, or the ray parallel
  // to an axis.
  Ray<Real> very_far_ray() {
    const auto component = [&] { return static_cast<double>(chance_.whole(-2, 2)); };
    Vec3d along{component(), component(), component()};
    if (chance_.one_in(2)) along.set(chance_.whole(0, 2), 0);
    if (largest_magnitude(along) == 0) along.set(chance_.whole(0, 2), chance_.sign());
    const Vec3d from = cast<double>(point()) -
                       along * (size() * chance_.power_of_two(0, sizeof(Real) == sizeof(float) ? 100 : 300));
    return unbounded_ray(cast<Real>(from), scaled_to_one(cast<Real>(along)));
  }

private:
  Boxd padded() const { return padded_bounds<Real>(bounds_); }
  double size() const { return largest_magnitude(bounds_.max - bounds_.min); }

  Real tiny() {
    constexpr double lowest = std::is_same_v<Real, float> ? -148 : -1072;
    return static_cast<Real>(chance_.sign() * chance_.power_of_two(lowest, -20));
  }

  // The index of a plane between voxels; mostly one between cells.
  std::int32_t plane_index(int axis) {
    if (grid_.cells.empty() || chance_.one_in(4)) return chance_.whole(0, finest_.division[axis]);
    const VoxelBox box = box_of(grid_.cells[chance_.index(grid_.cells.size())]);
    return chance_.one_in(2) ? box.first[axis] : box.end[axis];
  }
  // The plane's coordinate, computed as in traversal.
  Real plane(int axis) {
    return fma(static_cast<Real>(plane_index(axis)), static_cast<Real>(voxel_size(finest_)[axis]),
               static_cast<Real>(finest_.space.min[axis]));
  }

  // Anywhere; on faces, edges and corners of voxels; on corners, edges and centers of primitives.
  Vec3<Real> point() {
    Vec3<Real> p = cast<Real>(chance_.in_box(padded()));
    switch (chance_.whole(0, 5)) {
    case 0:
      for (int axis = 0; axis < 3; ++axis)
        if (chance_.one_in(2)) p.set(axis, plane(axis));
      return p;
    case 1:
    case 2:
      if (!scene_.triangles.empty()) {
        const auto& t = scene_.triangles[chance_.index(scene_.triangles.size())];
        const Real share = static_cast<Real>(chance_.one_of({0.0, 0.5, chance_.uniform(0, 1)}));
        p = fma(t.b - t.a, share, t.a);
        if (chance_.one_in(2)) p = fma(t.c - p, static_cast<Real>(chance_.uniform(0, 1)), p);
      }
      return p;
    case 3:
      if (!scene_.cones.empty()) {
        const auto& c = scene_.cones[chance_.index(scene_.cones.size())];
        p = chance_.one_in(2) ? c.base : c.apex;
        if (chance_.one_in(2))
          p = cast<Real>(cast<double>(p) + chance_.in_cube(size() * chance_.power_of_two(-50, -1)));
      }
      return p;
    case 4:
      if (!scene_.spheres.empty()) {
        const auto& s = scene_.spheres[chance_.index(scene_.spheres.size())];
        p = cast<Real>(cast<double>(s.center) + chance_.direction() * static_cast<double>(s.radius));
      }
      return p;
    default:
      return p;
    }
  }

  Vec3<Real> far_point(const Vec3<Real>& target) {
    return cast<Real>(cast<double>(target) + chance_.direction() * (size() * chance_.power_of_two(0, 23.25)));
  }

  Chance& chance_;
  const TestScene<Real>& scene_;
  Boxd bounds_;
  const Structure& grid_;
  GridLayout finest_;
};

using stability::same_bits;

template <class Real>
std::string described(const Hit<Real>& hit) {
  return "primitive " + std::to_string(static_cast<std::int32_t>(hit.primitive)) + " at " + described(hit.t);
}
} // namespace masu
