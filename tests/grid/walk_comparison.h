// Hits of walks through a grid or hierarchy, against those of trying every primitive: the same bits.
#pragma once

#include "libgrid/trace/trace.h"
#include "renderer/counts.h"
#include "tests/random_ray.h"
#include "tests/random_test.h"

namespace masu {

// Of scenes stored as Stored, traced by arithmetic of type Real.
template <class Stored, class Real>
class WalkComparison : public RandomTest {
protected:
  // Counts the rays whose result depends on the structure. describe() says which that is.
  template <class View, class MakeRay, class Describe>
  void compare_through(TestScene<Stored>& scene, const View& structure, int rays, const MakeRay& make_ray,
                       const Describe& describe) {
    const SceneView<Stored> view = scene.view();
    Chance& chance = chance_;
    for (int i = 0; i < rays; ++i) {
      Ray<Real> ray = make_ray();
      NoCounts counts;
      const Hit<Real> expected = nearest_hit<Robust<Real>>(view, NoGrid{}, ray, counts),
                      found = nearest_hit<Robust<Real>>(view, structure, ray, counts);
      const bool is_hit = expected.primitive != no_primitive;
      hits_ += is_hit;
      const bool same = found.primitive == expected.primitive && same_bits(found.t, expected.t);
      // Between bounds at, before and beyond the hit.
      if (is_hit && chance.one_in(2))
        ray.t_max = chance.one_of({expected.t, nudged(expected.t, 1), expected.t * 2, expected.t / 2});
      if (is_hit && chance.one_in(3))
        ray.t_min =
            chance.one_of({expected.t, nudged(expected.t, -1), nudged(expected.t, 1), expected.t / 2});
      const Hit<Real> within = nearest_hit<Robust<Real>>(view, NoGrid{}, ray, counts),
                      found_within = nearest_hit<Robust<Real>>(view, structure, ray, counts);
      const bool same_within =
          found_within.primitive == within.primitive && same_bits(found_within.t, within.t);
      const bool same_occlusion = is_occluded<Robust<Real>>(view, structure, ray, counts) ==
                                  is_occluded<Robust<Real>>(view, NoGrid{}, ray, counts);
      if ((same && same_within && same_occlusion) || ++different_ > 1) continue;
      first_ = described(ray.origin, ray.direction) + " t_min " + described(ray.t_min) + " t_max " +
               described(ray.t_max) + ": " + described(same ? found_within : found) + ", expected " +
               described(same ? within : expected) + "; " + describe() + '\n' + described(scene);
    }
  }

  std::int64_t hits_ = 0, different_ = 0;
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
         RealTraits<Real>::smallest_normal, static_cast<Real>(chance.uniform(-1, 1))});
  };
  return {{number(), number(), number()}, number(), {number(), number(), number()}, number()};
}

} // namespace masu
