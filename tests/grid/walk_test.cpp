// The grid never shows: through any grid a ray finds the same bits as by trying every primitive.
#include "tests/grid/walk_comparison.h"
#include "tests/random_grid.h"
#include "tests/random_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

namespace masu {
namespace {

// --- Hits ------------------------------------------------------------------------------------------------

template <class Real>
class GridWalk : public WalkComparison<Real, Real> {
protected:
  void compare(TestScene<Real>& scene, const Grid& grid, int rays_to_try) {
    const Boxd bounds = scene.bounds();
    RayMaker<Real> rays(this->chance_, scene, bounds, grid);
    compare_each(scene, grid, rays_to_try, [&] { return rays.ray(); });
  }
  template <class MakeRay>
  void compare_each(TestScene<Real>& scene, const Grid& grid, int rays_to_try, const MakeRay& make_ray) {
    with_view<Real>(grid, [&](const auto& grid_view) {
      this->compare_through(scene, grid_view, rays_to_try, make_ray, [&] { return described(grid); });
    });
  }
};
using Arithmetics = testing::Types<float, double>;
TYPED_TEST_SUITE(GridWalk, Arithmetics);

TYPED_TEST(GridWalk, FindsTheHitsOfTryingEveryPrimitive) {
  using Real = TypeParam;
  Chance& chance = this->chance_;
  for (std::int64_t s = cases(2000); s > 0; --s) {
    TestScene<Real> scene = SceneMaker<Real>(chance, chance.power_of_two(-10, 20)).scene();
    const Grid grid = random_grid(chance, scene.view(), scene.bounds());
    this->compare(scene, grid, 300);
  }
  EXPECT_EQ(this->different_, 0) << this->first_;
  EXPECT_GT(this->hits_, cases(100'000));
}

// Edge-on to triangles in a plane, but for the smallest numbers.
TYPED_TEST(GridWalk, FindsThemAlongDirectionsWithTinyComponents) {
  using Real = TypeParam;
  Chance& chance = this->chance_;
  constexpr double lowest = std::is_same_v<Real, float> ? -148 : -1072;
  for (std::int64_t s = cases(1000); s > 0; --s) {
    TestScene<Real> scene = SceneMaker<Real>(chance, 1).flat();
    const Boxd bounds = scene.bounds();
    const Grid grid = random_grid(chance, scene.view(), bounds);
    int across_plane = 0;
    for (int axis = 0; axis < 3; ++axis)
      if (bounds.min[axis] == bounds.max[axis]) across_plane = axis;
    const auto place = [&] { return cast<Real>(chance.in_box(bounds)); };
    this->compare_each(scene, grid, 200, [&] {
      const Vec3<Real> origin = place();
      Vec3<Real> direction = place() - origin;
      direction.set(across_plane, static_cast<Real>(chance.sign() * chance.power_of_two(lowest, lowest / 2)));
      return unbounded_ray(origin, direction);
    });
  }
  EXPECT_EQ(this->different_, 0) << "of " << this->hits_ << " hits: " << this->first_;
}

// Close to the tip, where all roots of the cone's quadratic meet; the grid's planes pass by it.
TYPED_TEST(GridWalk, FindsThemAtTheTipsOfCones) {
  using Real = TypeParam;
  Chance& chance = this->chance_;
  for (std::int64_t s = cases(1000); s > 0; --s) {
    TestScene<Real> scene = SceneMaker<Real>(chance, 1).pointed();
    const Boxd bounds = scene.bounds();
    const GridLayout layout = random_layout<Real>(chance, bounds);
    const Vec3d size = voxel_size(layout);
    for (std::size_t i = 0; i < scene.cones.size(); ++i) {
      Cone<Real>& cone = scene.cones[i];
      Triangle<Real>& triangle = scene.triangles[i];
      for (int axis = 0; axis < 3; ++axis) {
        const double at = static_cast<double>(cone.apex[axis]);
        const double number = std::round((at - layout.space.min[axis]) / size[axis]);
        if (number < 1 || number > layout.division[axis] - 1) continue; // the space's own
        const double plane = layout.space.min[axis] + size[axis] * number;
        const auto beside = [&] {
          return static_cast<Real>(plane + chance.sign() * chance.power_of_two(-40, -24));
        };
        const bool is_round = cone.base[axis] == cone.apex[axis];
        cone.apex.set(axis, beside());
        if (is_round) {
          cone.base.set(axis, cone.apex[axis]);
          continue;
        }
        const Real level = beside();
        for (Vec3<Real>* const corner : {&triangle.a, &triangle.b, &triangle.c})
          corner->set(axis, level);
      }
    }
    const Grid grid = build_grid(scene.view(), layout, Overlap::exact);
    this->compare_each(scene, grid, 200, [&] {
      const Cone<Real>& cone = scene.cones[chance.index(scene.cones.size())];
      const Vec3d tip = cast<double>(cone.apex), axis = normalized(cast<double>(cone.base) - tip);
      const Vec3d off = chance.in_cube(chance.power_of_two(-40, -20));
      const Vec3d towards = axis * chance.sign() + chance.in_cube(chance.power_of_two(-60, -20));
      const Vec3<Real> direction = cast<Real>(normalized(towards));
      return unbounded_ray(cast<Real>(tip + off - cast<double>(direction) * 0.01), direction);
    });
  }
  EXPECT_EQ(this->different_, 0) << "of " << this->hits_ << " hits: " << this->first_;
}

// So fine that the builder makes a map of two levels by itself.
TYPED_TEST(GridWalk, FindsThemThroughMillionsOfVoxels) {
  using Real = TypeParam;
  Chance& chance = this->chance_;
  for (std::int64_t s = std::max<std::int64_t>(cases(4), 1); s > 0; --s) {
    TestScene<Real> scene = SceneMaker<Real>(chance, 1).fine();
    const Boxd bounds = scene.bounds();
    const GridLayout layout{space_of<Real>(bounds, SpaceRule::tight),
                            {chance.whole(200, 300), chance.whole(200, 300), chance.whole(250, 300)},
                            rounding_margin<Real>(bounds)};
    const Grid grid = build_grid(scene.view(), layout, Overlap::exact);
    ASSERT_GT(grid.block_log2, 0);
    this->compare(scene, grid, 3000);
  }
  EXPECT_EQ(this->different_, 0) << this->first_;
  EXPECT_GT(this->hits_, cases(1000));
}

// Code that is compiled for fewer kinds of primitives does the same.
TYPED_TEST(GridWalk, FindsTheSameWithoutTheCodeForAbsentKinds) {
  using Real = TypeParam;
  Chance& chance = this->chance_;
  for (std::int64_t s = cases(200); s > 0 && !this->HasFailure(); --s) {
    TestScene<Real> scene = SceneMaker<Real>(chance, 1).scene();
    if (chance.one_in(3)) scene.triangles.clear();
    if (chance.one_in(3)) scene.spheres.clear();
    if (chance.one_in(2)) scene.cones.clear();
    if (scene.count() == 0) continue;
    const SceneView<Real> view = scene.view();
    const Boxd bounds = scene.bounds();
    const Grid grid = random_grid(chance, view, bounds);
    RayMaker<Real> rays(chance, scene, bounds, grid);
    with_view<Real>(grid, [&](const auto& grid_view) {
      for (int i = 0; i < 100; ++i) {
        const Ray<Real> ray = rays.ray();
        NoCounts counts;
        const Hit<Real> expected = nearest_hit<Robust<Real>>(view, grid_view, ray, counts);
        const auto expect_same = [&](const Hit<Real>& hit) {
          ASSERT_TRUE(hit.primitive == expected.primitive && same_bits(hit.t, expected.t));
        };
        if (scene.spheres.empty() && scene.cones.empty())
          expect_same(nearest_hit<Robust<Real, with_triangles>>(view, grid_view, ray, counts));
        if (scene.triangles.empty() && scene.cones.empty())
          expect_same(nearest_hit<Robust<Real, with_spheres>>(view, grid_view, ray, counts));
        if (scene.cones.empty())
          expect_same(nearest_hit<Robust<Real, with_triangles | with_spheres>>(view, grid_view, ray, counts));
      }
    });
  }
}

// The nearest hit by definition: of all primitives' own hits the least t, and there the lowest number.
template <class Real>
Hit<Real> nearest_of_all(const SceneView<Real>& scene, const Ray<Real>& ray, std::int64_t& ties) {
  NoCounts counts;
  const WatertightRay<Real> frame = prepared(ray.origin, ray.direction);
  Hit<Real> nearest{ray.t_max, no_primitive};
  for (std::uint32_t p = 0; p < scene.primitive_count(); ++p) {
    Real t = 0;
    if (!intersect<with_all_kinds>(scene, frame, p, t, counts)) continue;
    ties += t == nearest.t;
    if (t < nearest.t) nearest = {t, p};
  }
  return nearest;
}

template <class Real, class View>
void expect_nearest(const SceneView<Real>& scene, const View& grid, Ray<Real> ray, std::int64_t& ties) {
  const Hit<Real> expected = nearest_of_all(scene, ray, ties);
  NoCounts counts;
  const Hit<Real> found = nearest_hit<Robust<Real>>(scene, grid, ray, counts);
  ASSERT_TRUE(found.primitive == expected.primitive && same_bits(found.t, expected.t))
      << described(ray.origin, ray.direction) << ": " << described(found) << ", expected "
      << described(expected);
  if (expected.primitive == no_primitive) return;
  // t_max itself isn't reached, by either query.
  for (const bool beyond : {false, true}) {
    ray.t_max = beyond ? nudged(expected.t, 1) : expected.t;
    const Hit<Real> up_to = nearest_hit<Robust<Real>>(scene, grid, ray, counts);
    ASSERT_EQ(up_to.primitive, beyond ? expected.primitive : no_primitive);
    ASSERT_TRUE(same_bits(up_to.t, expected.t));
    ASSERT_EQ(is_occluded<Robust<Real>>(scene, grid, ray, counts), beyond);
  }
}

TYPED_TEST(GridWalk, TiesGoToTheLowestPrimitive) {
  using Real = TypeParam;
  Chance& chance = this->chance_;
  std::int64_t ties = 0;
  for (std::int64_t s = cases(300); s > 0; --s) {
    TestScene<Real> scene = SceneMaker<Real>(chance, 1).scene();
    const auto again = [](auto& primitives) {
      const auto once = primitives;
      primitives.insert(primitives.end(), once.begin(), once.end());
    };
    again(scene.triangles);
    again(scene.spheres);
    again(scene.cones);
    const SceneView<Real> view = scene.view();
    const Boxd bounds = scene.bounds();
    const Grid grid = random_grid(chance, view, bounds);
    RayMaker<Real> rays(chance, scene, bounds, grid);
    with_view<Real>(grid, [&](const auto& grid_view) {
      for (int i = 0; i < 100 && !this->HasFailure(); ++i) {
        Ray<Real> ray = rays.ray();
        ray.t_max = RealTraits<Real>::largest;
        if (!contains(view.clip, ray.origin)) continue; // a ray from inside isn't changed before it is tested
        expect_nearest(view, grid_view, ray, ties);
      }
    });
    ASSERT_FALSE(this->HasFailure()) << described(grid) << '\n' << described(scene);
  }
  EXPECT_GT(ties, cases(100));
}

// --- The way through the cells ---------------------------------------------------------------------------

// Walks to the end of the space, or until it must have lost its way.
template <class Real>
struct WholeWalk {
  std::int64_t max_voxels; // on a ray's way
  std::int64_t voxels = 0;
  double largest_fall = 0; // of the exits' distances

  template <class View>
  WholeWalk(const View& grid, const ClippedRay<Real>& near)
      : max_voxels(std::int64_t{grid.division.x} + grid.division.y + grid.division.z) {
    Walk<Real, View> walk(grid, near);
    Real last = -RealTraits<Real>::largest;
    for (bool inside = true; inside && voxels <= max_voxels;) {
      walk.enter(grid);
      if (walk.exit < last)
        largest_fall = std::max(largest_fall, static_cast<double>(last) - static_cast<double>(walk.exit));
      last = walk.exit;
      const Vec3i from = walk.voxel();
      inside = walk.leave(grid);
      const std::int64_t moved = walk.voxels_from(from);
      EXPECT_GE(moved, 1);
      voxels += moved;
    }
  }
};

TYPED_TEST(GridWalk, EndsAndGoesForward) {
  using Real = TypeParam;
  Chance& chance = this->chance_;
  for (std::int64_t s = cases(400); s > 0 && !this->HasFailure(); --s) {
    TestScene<Real> scene = SceneMaker<Real>(chance, chance.power_of_two(-10, 20)).scene();
    const SceneView<Real> view = scene.view();
    const Boxd bounds = scene.bounds();
    const Grid grid = random_grid(chance, view, bounds);
    RayMaker<Real> rays(chance, scene, bounds, grid);
    with_view<Real>(grid, [&](const auto& grid_view) {
      for (int i = 0; i < 100; ++i) {
        const Ray<Real> ray = rays.ray();
        ClippedRay<Real> clipped;
        if (!clip(ray, view.clip, clipped)) continue;
        const WholeWalk<Real> whole(grid_view, clipped);
        ASSERT_LE(whole.voxels, whole.max_voxels) << described(grid) << described(ray.origin, ray.direction);
        // After a cell of many voxels the place along the other axes is computed anew: off by a rounding.
        double slowest = 1;
        for (int axis = 0; axis < 3; ++axis) {
          const double d = std::abs(static_cast<double>(clipped.ray.direction[axis]));
          if (d > 0) slowest = std::min(slowest, d);
        }
        const bool single_voxels = grid.kind == GridKind::uniform && grid.block_log2 == 0;
        ASSERT_LE(whole.largest_fall * slowest, single_voxels ? 0 : grid.layout.margin)
            << described(grid) << described(ray.origin, ray.direction);
      }
    });
  }
}

// Goes to the end of the space.
struct Wayfarer {
  Counts counts;
  std::int64_t in_last_cell = 0; // voxels that the way crosses beyond the one it entered by

  template <class Real, class View>
  Wayfarer(const View& grid, const ClippedRay<Real>& ray) {
    Walk<Real, View> walk(grid, ray);
    Vec3i from{};
    do {
      from = walk.voxel();
    } while (visit_cell(grid, walk, *this));
    in_last_cell = walk.voxels_from(from) - 1;
  }
  void primitive(PrimitiveIndex) {}
  template <class Real>
  bool done(Real) const {
    return false;
  }
  std::int64_t voxels() const {
    return static_cast<std::int64_t>(counts.cells_visited + counts.voxels_skipped) + in_last_cell;
  }
};

// Visited or skipped, the voxels on a ray's way are the same however they are joined.
TYPED_TEST(GridWalk, EveryVoxelOnTheWayIsVisitedOrSkipped) {
  using Real = TypeParam;
  Chance& chance = this->chance_;
  std::int64_t skipped = 0;
  for (std::int64_t s = cases(100); s > 0 && !this->HasFailure(); --s) {
    TestScene<Real> scene = SceneMaker<Real>(chance, 1).scene();
    const SceneView<Real> view = scene.view();
    const Boxd bounds = scene.bounds();
    const GridLayout layout = random_layout<Real>(chance, bounds);
    const Grid uniform = build_grid(view, layout, Overlap::exact);
    std::vector<Grid> joined{in_blocks(uniform, 2)};
    for (const GridKind kind : {GridKind::x, GridKind::balance})
      joined.push_back(build_grid(view, layout, Overlap::exact, {kind, 2}));
    for (int i = 0; i < 30; ++i) {
      const Vec3<Real> origin = cast<Real>(chance.in_box(layout.space));
      const Vec3<Real> d = cast<Real>(chance.direction());
      const ClippedRay<Real> ray{unbounded_ray(origin, d), {1 / d.x, 1 / d.y, 1 / d.z}, 0};
      const Wayfarer expected(view_of<Real>(uniform), ray);
      EXPECT_EQ(expected.counts.voxels_skipped, 0U);
      for (const Grid& grid : joined) {
        std::int64_t voxels = 0;
        with_view<Real>(grid, [&](const auto& grid_view) {
          const Wayfarer way(grid_view, ray);
          voxels = way.voxels();
          skipped += static_cast<std::int64_t>(way.counts.voxels_skipped);
        });
        // Close by an edge of the space, rounding decides on which side of it the way ends.
        ASSERT_LE(std::abs(voxels - expected.voxels()), 2) << described(grid) << described(origin, d) << ": "
                                                           << voxels << " voxels, not " << expected.voxels();
      }
    }
  }
  EXPECT_GT(skipped, cases(1000));
}

TYPED_TEST(GridWalk, EndsForRaysOfAnyNumbers) {
  using Real = TypeParam;
  Chance& chance = this->chance_;
  TestScene<Real> scene;
  scene.triangles.push_back(triangle_of<Real>({0, 0, 0}, {1, 0, 0}, {0, 1, 1}));
  scene.spheres.push_back({{0, 0, 0}, Real(0.5)});
  const SceneView<Real> view = scene.view();
  const Boxd bounds = scene.bounds();
  const GridLayout layout{space_of<Real>(bounds, SpaceRule::tight), {5, 6, 7}, rounding_margin<Real>(bounds)};
  const Grid uniform = build_grid(view, layout, Overlap::exact);
  std::vector<Grid> grids{uniform, in_blocks(uniform, 2)};
  for (const GridKind kind : {GridKind::x, GridKind::balance, GridKind::irregular})
    grids.push_back(build_grid(view, layout, Overlap::exact, {kind, 1}));
  for (int i = 0; i < 45; ++i)
    grids.push_back(random_merged_grid(chance, view, bounds));
  for (const Grid& grid : grids) {
    with_view<Real>(grid, [&](const auto& grid_view) {
      for (std::int64_t i = cases(5'000); i > 0 && !this->HasFailure(); --i) {
        const Ray<Real> ray = ray_of_any_numbers<Real>(chance);
        NoCounts counts;
        nearest_hit<Robust<Real>>(view, grid_view, ray, counts);
        const Vec3<Real>& d = ray.direction;
        const WholeWalk<Real> whole(grid_view, {ray, {1 / d.x, 1 / d.y, 1 / d.z}, 0});
        ASSERT_LE(whole.voxels, whole.max_voxels) << described(grid) << described(ray.origin, ray.direction);
      }
    });
  }
}

} // namespace
} // namespace masu
