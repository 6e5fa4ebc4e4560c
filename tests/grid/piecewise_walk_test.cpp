// A ray's way may be walked in pieces, by whoever has time: the nearest of what the pieces find is what the
// whole walk finds.
#include "libgrid/trace/trace.h"
#include "renderer/counts.h"
#include "tests/random_grid.h"
#include "tests/random_ray.h"
#include "tests/random_scene.h"
#include "tests/random_test.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace masu {
namespace {

template <class Real>
class PiecewiseWalk : public RandomTest {};
using Arithmetics = testing::Types<float, double>;
TYPED_TEST_SUITE(PiecewiseWalk, Arithmetics);

// Places to cut the way from t = 0 to `to`: of equal length, anywhere, or just where the ray leaves cells.
template <class Real, class View>
std::vector<Real> cuts(Chance& chance, const View& grid, const ClippedRay<Real>& near, Real to) {
  std::vector<Real> at;
  const int pieces = chance.whole(2, 32), kind = chance.whole(0, 2);
  const Real step = to / static_cast<Real>(pieces);
  if (kind == 0) {
    for (int i = 1; i < pieces; ++i)
      at.push_back(fma(step, static_cast<Real>(i), Real(0)));
  } else if (kind == 1) {
    for (int i = 1; i < pieces; ++i)
      at.push_back(static_cast<Real>(chance.uniform(0, 1) * static_cast<double>(to)));
  } else {
    Walk<Real, View> walk(grid, near);
    do {
      walk.enter(grid);
      if (chance.one_in(3))
        at.push_back(chance.one_in(2) ? walk.exit : nudged(walk.exit, chance.one_in(2) ? 1 : -1));
    } while (walk.leave(grid));
  }
  std::erase_if(at, [&](Real t) { return !(t > 0 && t < to); });
  std::sort(at.begin(), at.end());
  return at;
}

template <class Real, class View>
Hit<Real> found_in_pieces(Chance& chance, const SceneView<Real>& scene, const View& grid,
                          const Ray<Real>& ray) {
  using M = Robust<Real>;
  ClippedRay<Real> near{};
  if (!clip(ray, scene.clip, near)) return {ray.t_max, no_primitive};
  WatertightRay<Real> frame{};
  prepare(frame, near.ray.origin, near.ray.direction);
  NoCounts counts;
  const Hit<Real> nothing{near.ray.t_max, 0};
  Hit<Real> nearest = nothing;
  std::vector<Real> at =
      cuts(chance, grid, near, fast_min(Walk<Real, View>(grid, near).end(grid), near.ray.t_max));
  at.insert(at.begin(), Real(0));
  for (std::size_t i = 0; i < at.size(); ++i) {
    NearestHit<M, Real, NoCounts> visitor{scene, frame, counts, near.ray.t_max, nothing};
    Walk<Real, View> walk(grid, near);
    if (i > 0) walk.begin_at(grid, at[i]);
    while (visit_cell(grid, walk, visitor) && (i + 1 == at.size() || walk.exit < at[i + 1])) {
    }
    if (is_nearer(visitor.hit.t, visitor.hit.primitive, nearest)) nearest = visitor.hit;
  }
  if (!(nearest.t < near.ray.t_max)) return {ray.t_max, no_primitive};
  return {nearest.t + near.skipped, nearest.primitive};
}

TYPED_TEST(PiecewiseWalk, FindsTheHitsOfTryingEveryPrimitive) {
  using Real = TypeParam;
  Chance& chance = this->chance_;
  std::int64_t hits = 0;
  for (std::int64_t s = cases(1000); s > 0 && !this->HasFailure(); --s) {
    TestScene<Real> scene = SceneMaker<Real>(chance, chance.power_of_two(-10, 20)).scene();
    const SceneView<Real> view = scene.view();
    const Boxd bounds = scene.bounds();
    const Grid grid = random_grid(chance, view, bounds);
    RayMaker<Real> rays(chance, scene, bounds, grid);
    with_view<Real>(grid, [&](const auto& grid_view) {
      for (int i = 0; i < 100 && !this->HasFailure(); ++i) {
        const Ray<Real> ray = rays.ray();
        NoCounts counts;
        const Hit<Real> expected = nearest_hit<Robust<Real>>(view, NoGrid{}, ray, counts);
        const Hit<Real> found = found_in_pieces(chance, view, grid_view, ray);
        hits += expected.primitive != no_primitive;
        EXPECT_TRUE(found.primitive == expected.primitive && same_bits(found.t, expected.t))
            << described(ray.origin, ray.direction) << ": " << described(found) << ", expected "
            << described(expected) << "; " << described(grid) << '\n'
            << described(scene);
      }
    });
  }
  EXPECT_GT(hits, cases(10'000));
}

} // namespace
} // namespace masu
