// Hits of walks through a grid or a hierarchy, against those of trying every primitive: the same bits.
#pragma once

#include "libgrid/trace/trace.h"
#include "renderer/counts.h"
#include "tests/random_ray.h"
#include "tests/random_test.h"

#include <array>
#include <numeric>

namespace masu {

// Of scenes stored as Stored, traced by arithmetic of type Real.
template <class Stored_, class Real_>
struct Traced {
  using Stored = Stored_;
  using Real = Real_;
};

template <class T>
class WalkComparison : public RandomTest {
protected:
  using StoredReal = typename T::Stored;
  using TracedReal = typename T::Real;

  static Ray<TracedReal> as_traced(const Ray<StoredReal>& ray) {
    return {cast<TracedReal>(ray.origin), static_cast<TracedReal>(ray.t_min), cast<TracedReal>(ray.direction),
            static_cast<TracedReal>(ray.t_max)};
  }
  // Of rays that are hard for it.
  void compare(TestScene<StoredReal>& scene, const Structure& structure, int rays) {
    const Boxd bounds = scene.bounds();
    RayMaker<StoredReal> maker(chance_, scene, bounds, structure);
    compare(scene, structure, rays, [&] {
      Ray<TracedReal> ray = as_traced(maker.ray());
      if (!structure.nodes.empty() && chance_.one_in(4)) put_on_planes(structure, ray);
      return ray;
    });
  }
  // Counts the rays whose result depends on the structure.
  template <class MakeRay>
  void compare(TestScene<StoredReal>& scene, const Structure& structure, int rays, const MakeRay& make_ray) {
    with_structure_view<TracedReal>(structure, [&](const auto& view) {
      for (int i = 0; i < rays; ++i)
        compare_one(scene, structure, view, make_ray());
    });
  }
  void expect_same_hits(std::int64_t least_hits = 1) {
    const std::int64_t hits = std::accumulate(hits_.begin(), hits_.end(), std::int64_t{0});
    EXPECT_EQ(different_, 0) << "of " << hits << " hits: " << first_;
    EXPECT_GE(hits, least_hits);
  }

  std::array<std::int64_t, 3> hits_{}; // by how often their rays are clipped: once, twice, more

private:
  template <class View>
  void compare_one(TestScene<StoredReal>& scene, const Structure& structure, const View& view,
                   Ray<TracedReal> ray) {
    using M = Robust<TracedReal>;
    const SceneView<StoredReal> all = scene.view();
    NoCounts counts;
    const Hit<TracedReal> expected = nearest_hit<M>(all, NoStructure{}, ray, counts),
                          found = nearest_hit<M>(all, view, ray, counts);
    const bool is_hit = expected.primitive != no_primitive;
    constexpr double one_clip = 256, two_clips = one_clip / 12 / RealTraits<TracedReal>::unit_roundoff;
    const double away =
        static_cast<double>(largest_magnitude(ray.origin)) / static_cast<double>(largest_magnitude(all.clip));
    if (is_hit) ++hits_[away < one_clip ? 0 : away < two_clips ? 1 : 2];
    const bool same = found.primitive == expected.primitive && same_bits(found.t, expected.t);
    // Between bounds at, before and beyond the hit.
    if (is_hit && chance_.one_in(2))
      ray.t_max = chance_.one_of({expected.t, nudged(expected.t, 1), expected.t * 2, expected.t / 2});
    if (is_hit && chance_.one_in(3))
      ray.t_min = chance_.one_of({expected.t, nudged(expected.t, -1), nudged(expected.t, 1), expected.t / 2});
    const Hit<TracedReal> within = nearest_hit<M>(all, NoStructure{}, ray, counts),
                          found_within = nearest_hit<M>(all, view, ray, counts);
    const bool same_within =
        found_within.primitive == within.primitive && same_bits(found_within.t, within.t);
    const bool same_occlusion =
        is_occluded<M>(all, view, ray, counts) == is_occluded<M>(all, NoStructure{}, ray, counts);
    if ((same && same_within && same_occlusion) || ++different_ > 1) return;
    first_ = described(ray.origin, ray.direction) + " t_min " + described(ray.t_min) + " t_max " +
             described(ray.t_max) + ": " + described(same ? found_within : found) + ", expected " +
             described(same ? within : expected) + "; " + described(structure) + '\n' + described(scene);
  }

  // Into planes of boxes of a node, or along their edges.
  void put_on_planes(const Structure& hierarchy, Ray<TracedReal>& ray) {
    const Boxd box =
        box_of(hierarchy.nodes[chance_.index(hierarchy.nodes.size())], chance_.whole(0, boxes_per_node - 1));
    for (int axis = 0; axis < 3; ++axis) {
      if (chance_.one_in(2)) continue;
      ray.origin.set(axis, static_cast<TracedReal>(chance_.one_in(2) ? box.min[axis] : box.max[axis]));
      if (chance_.one_in(2)) ray.direction.set(axis, chance_.one_in(2) ? TracedReal(0) : TracedReal(-0.0));
    }
    ray.direction = scaled_to_one(ray.direction); // as scale_direction() has them
  }

  std::int64_t different_ = 0;
  std::string first_;
};

// What a blind or hostile caller may hand over.
template <class Real>
Ray<Real> ray_of_any_numbers(Chance& chance) {
  const auto number = [&]() -> Real {
    constexpr Real infinity = std::numeric_limits<Real>::infinity();
    return chance.one_of<Real>(
        {0, Real(-0.0), 1, -1, Real(0.5), infinity, -infinity, std::numeric_limits<Real>::quiet_NaN(),
         std::numeric_limits<Real>::denorm_min(), RealTraits<Real>::largest, -RealTraits<Real>::largest,
         std::numeric_limits<Real>::min(), static_cast<Real>(chance.uniform(-1, 1))});
  };
  return {{number(), number(), number()}, number(), {number(), number(), number()}, number()};
}

} // namespace masu
