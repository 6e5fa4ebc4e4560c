// Results are independent of the structure: through any grid and any hierarchy a ray finds the same bits as
// by trying every primitive. And walks go forward, and end.
#include "libgrid/hierarchy/hierarchy_builder.h"
#include "libgrid/statistics/statistics.h"
#include "tests/hierarchy/walk_comparison.h"
#include "tests/random_grid.h"
#include "tests/random_scene.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace masu {
namespace {

// --- Hits ------------------------------------------------------------------------------------------------

template <class T>
class Walks : public WalkComparison<T> {};
using Ways = testing::Types<Traced<float, float>, Traced<float, double>, Traced<double, double>>;
TYPED_TEST_SUITE(Walks, Ways);

TYPED_TEST(Walks, FindTheHitsOfTryingEveryPrimitive) {
  using Stored = typename TypeParam::Stored;
  Chance& chance = this->chance_;
  for (std::int64_t s = cases(4000); s > 0; --s) {
    TestScene<Stored> scene = SceneMaker<Stored>(chance, chance.power_of_two(-10, 20)).scene();
    this->compare(scene, random_structure(chance, scene), 200);
  }
  this->expect_same_hits(cases(120'000));
  EXPECT_GT(this->hits_[1] + this->hits_[2], cases(5000));
}

// However far away: t is from near the scene, and fine enough for what the ray meets.
TYPED_TEST(Walks, FindThemFromAnyDistance) {
  using Stored = typename TypeParam::Stored;
  Chance& chance = this->chance_;
  for (std::int64_t s = cases(1000); s > 0; --s) {
    const bool is_tiny = chance.one_in(2);
    TestScene<Stored> scene =
        SceneMaker<Stored>(chance, chance.power_of_two(is_tiny ? -33 : -10, is_tiny ? -20 : 20)).scene();
    const Structure structures[]{random_uniform_grid(chance, scene.view(), scene.bounds()),
                                 random_merged_grid(chance, scene.view(), scene.bounds()),
                                 hierarchy_of(scene)};
    RayMaker<Stored> rays(chance, scene, scene.bounds(), structures[0]);
    for (const Structure& structure : structures)
      this->compare(scene, structure, 40, [&] { return this->as_traced(rays.very_far_ray()); });
  }
  this->expect_same_hits();
  EXPECT_GT(this->hits_[0], cases(500));
  EXPECT_GT(this->hits_[1], cases(1000));
  EXPECT_GT(this->hits_[2], cases(1000));
}

// Edge-on to triangles in a plane, but for the smallest numbers.
TYPED_TEST(Walks, FindThemAlongDirectionsWithTinyComponents) {
  using Stored = typename TypeParam::Stored;
  using Real = typename TypeParam::Real;
  Chance& chance = this->chance_;
  constexpr double lowest = std::is_same_v<Real, float> ? -148 : -1072;
  for (std::int64_t s = cases(1000); s > 0; --s) {
    TestScene<Stored> scene = SceneMaker<Stored>(chance, 1).flat();
    const Boxd bounds = scene.bounds();
    const Structure grid = random_structure(chance, scene);
    int across_plane = 0;
    for (int axis = 0; axis < 3; ++axis)
      if (bounds.min[axis] == bounds.max[axis]) across_plane = axis;
    const auto place = [&] { return cast<Real>(chance.in_box(bounds)); };
    this->compare(scene, grid, 200, [&] {
      const Vec3<Real> origin = place();
      Vec3<Real> direction = place() - origin;
      direction.set(across_plane,
                    static_cast<Real>(chance.sign() *
                                      chance.power_of_two(lowest, chance.one_in(2) ? lowest / 2 : -20)));
      if (chance.one_in(4)) direction.set((across_plane + 1) % 3, Real(0));
      return unbounded_ray(origin, direction);
    });
  }
  this->expect_same_hits();
}

// Close to the tip, where all roots of the cone's quadratic meet; the grid's planes pass by it.
TYPED_TEST(Walks, FindThemAtTheTipsOfCones) {
  using Stored = typename TypeParam::Stored;
  using Real = typename TypeParam::Real;
  Chance& chance = this->chance_;
  for (std::int64_t s = cases(1000); s > 0; --s) {
    TestScene<Stored> scene = SceneMaker<Stored>(chance, 1).pointed();
    const Boxd bounds = scene.bounds();
    const GridLayout layout = random_layout<Stored>(chance, bounds);
    const Vec3d size = voxel_size(layout);
    for (std::size_t i = 0; i < scene.cones.size(); ++i) {
      Cone<Stored>& cone = scene.cones[i];
      Triangle<Stored>& triangle = scene.triangles[i];
      for (int axis = 0; axis < 3; ++axis) {
        const double at = static_cast<double>(cone.apex[axis]);
        const double number = std::round((at - layout.space.min[axis]) / size[axis]);
        if (number < 1 || number > layout.division[axis] - 1) continue; // the space's own
        const double plane = layout.space.min[axis] + size[axis] * number;
        const auto beside = [&] {
          return static_cast<Stored>(plane + chance.sign() * chance.power_of_two(-40, -24));
        };
        const bool is_round = cone.base[axis] == cone.apex[axis];
        cone.apex.set(axis, beside());
        if (is_round) {
          cone.base.set(axis, cone.apex[axis]);
          continue;
        }
        const Stored level = beside();
        for (Vec3<Stored>* const corner : {&triangle.a, &triangle.b, &triangle.c})
          corner->set(axis, level);
      }
    }
    const Structure grid = build_structure(scene.view(), layout, Overlap::exact);
    this->compare(scene, grid, 200, [&] {
      const Cone<Stored>& cone = scene.cones[chance.index(scene.cones.size())];
      const Vec3d tip = cast<double>(cone.apex), axis = normalized(cast<double>(cone.base) - tip);
      const Vec3d off = chance.in_cube(chance.power_of_two(-40, -20));
      const Vec3d towards = axis * chance.sign() + chance.in_cube(chance.power_of_two(-60, -20));
      const Vec3<Real> direction = cast<Real>(normalized(towards));
      return unbounded_ray(cast<Real>(tip + off - cast<double>(direction) * 0.01), direction);
    });
  }
  this->expect_same_hits();
}

// So fine that the builder makes a map of two levels by itself.
TYPED_TEST(Walks, FindThemThroughMillionsOfVoxels) {
  using Stored = typename TypeParam::Stored;
  Chance& chance = this->chance_;
  for (std::int64_t s = std::max<std::int64_t>(cases(4), 1); s > 0; --s) {
    TestScene<Stored> scene = SceneMaker<Stored>(chance, 1).fine();
    const auto layout = layout_in<Stored>(
        scene.bounds(), {chance.whole(200, 300), chance.whole(200, 300), chance.whole(250, 300)});
    const Structure grid = build_structure(scene.view(), layout, Overlap::exact);
    ASSERT_GT(grid.block_log2, 0);
    this->compare(scene, grid, 3000);
  }
  this->expect_same_hits(cases(1000));
}

// Several levels of nodes, with primitives large and small that overlap: some are cut by spatial splits.
TYPED_TEST(Walks, FindThemAmongThousandsOfPrimitives) {
  using Stored = typename TypeParam::Stored;
  Chance& chance = this->chance_;
  std::size_t cut = 0;
  for (std::int64_t s = cases(16); s > 0; --s) {
    TestScene<Stored> scene;
    const Vec3d middle = chance.in_cube(chance.one_of({0.0, 1.0, 30.0}));
    for (int i = chance.whole(500, 3000); i > 0; --i) {
      const Vec3d at = middle + chance.in_cube(1);
      const double size = chance.power_of_two(-9, chance.one_in(20) ? 0 : -4);
      const auto corner = [&] { return cast<Stored>(at + chance.in_cube(size)); };
      switch (chance.whole(0, 5)) {
      case 0:
        scene.spheres.push_back(sphere_of<Stored>(at, size));
        break;
      case 1:
        scene.cones.push_back(cone_of<Stored>(at, size, at + chance.direction() * (size * 4),
                                              size * chance.one_of({0.0, 0.5, 1.0})));
        break;
      default:
        scene.triangles.push_back(triangle_of(corner(), corner(), corner()));
      }
    }
    const Structure grid = hierarchy_of(scene, s % 2 == 0 ? HierarchyQuality::high : HierarchyQuality::fast);
    EXPECT_GT(hierarchy_statistics(grid.nodes).depth, 2);
    cut += grid.references.size() - scene.count();
    this->compare(scene, grid, 250);
  }
  this->expect_same_hits(cases(1000));
  this->RecordProperty("references_of_cut_primitives", static_cast<int>(cut));
}

TYPED_TEST(Walks, FindThemThroughARefittedHierarchy) {
  using Stored = typename TypeParam::Stored;
  Chance& chance = this->chance_;
  for (std::int64_t s = cases(500); s > 0; --s) {
    const double scale = chance.power_of_two(-10, 20);
    TestScene<Stored> scene = SceneMaker<Stored>(chance, scale).scene();
    Structure grid = hierarchy_of(scene, any_quality(chance));
    for (int moves = chance.whole(1, 3); moves > 0; --moves) {
      const std::size_t cones = scene.cones.size();
      move_primitives(chance, scene, scale * chance.power_of_two(-20, 4));
      if (scene.cones.size() != cones) grid = hierarchy_of(scene); // one that is a point now is gone
      ASSERT_TRUE(refit_hierarchy(scene.view(), hierarchy_layout(scene), grid));
    }
    this->compare(scene, grid, 100);
  }
  this->expect_same_hits(cases(10'000));
}

// As large, as small and as far from the origin as scene files allow.
TYPED_TEST(Walks, FindThemInScenesOfAnyScaleAndPlace) {
  using Stored = typename TypeParam::Stored;
  Chance& chance = this->chance_;
  const bool wide = std::is_same_v<Stored, double>;
  for (std::int64_t s = cases(800); s > 0; --s) {
    const double scale = chance.power_of_two(wide ? -298 : -31, wide ? 49 : 39);
    TestScene<Stored> scene = SceneMaker<Stored>(chance, scale).scene();
    const Boxd bounds = scene.bounds();
    const double most = wide ? 1e15 : 1e12, far = largest_magnitude(bounds);
    if (far >= most / 2) continue;
    if (chance.one_in(2)) { // far away for its size
      const Vec3<Stored> by =
          cast<Stored>(chance.direction() * std::min(far * chance.power_of_two(0, 16), most / 4));
      for_each_points(scene, [&](auto&... points) { ((points = points + by), ...); });
      std::erase_if(scene.cones, [](const auto& cone) { return cone.base == cone.apex; });
      if (scene.count() == 0) continue;
    }
    this->compare(scene, random_structure(chance, scene), 200);
  }
  this->expect_same_hits();
}

TYPED_TEST(Walks, FindTheFirstOfThousandsThatAreEqual) {
  using Stored = typename TypeParam::Stored;
  using Real = typename TypeParam::Real;
  TestScene<Stored> scene;
  scene.triangles.assign(5000, triangle_of<Stored>({0, 0, 0}, {1, 0, 0}, {0, 1, 0}));
  const SceneView<Stored> view = scene.view();
  for (const HierarchyQuality quality : {HierarchyQuality::high, HierarchyQuality::fast}) {
    const Structure grid = hierarchy_of(scene, quality);
    EXPECT_EQ(grid.references.size(), 5000U);
    EXPECT_LE(hierarchy_statistics(grid.nodes).depth, 6U);
    NoCounts counts;
    const auto hit =
        nearest_hit<Robust<Real>>(view, hierarchy_view_of<Real>(grid),
                                  unbounded_ray<Real>({Real(0.25), Real(0.25), 1}, {0, 0, -1}), counts);
    EXPECT_EQ(hit.primitive, 0U);
    EXPECT_EQ(hit.t, 1);
  }
}

TYPED_TEST(Walks, FindNothingInAnEmptyScene) {
  using Stored = typename TypeParam::Stored;
  using Real = typename TypeParam::Real;
  TestScene<Stored> empty, without_surface;
  without_surface.triangles.assign(3, triangle_of<Stored>({0, 0, 0}, {0, 0, 0}, {0, 0, 0}));
  for (TestScene<Stored>* const scene : {&empty, &without_surface}) {
    for (const HierarchyQuality quality : {HierarchyQuality::high, HierarchyQuality::fast}) {
      const Structure grid = hierarchy_of(*scene, quality);
      EXPECT_EQ(grid.nodes.size(), 1U);
      EXPECT_TRUE(grid.references.empty());
      const auto ray = unbounded_ray<Real>({0, 0, 0}, {0, 0, -1});
      const auto view = hierarchy_view_of<Real>(grid);
      Counts counts;
      EXPECT_EQ(nearest_hit<Robust<Real>>(scene->view(), view, ray, counts).primitive, no_primitive);
      EXPECT_FALSE(is_occluded<Robust<Real>>(scene->view(), view, ray, counts));
    }
  }
}

TYPED_TEST(Walks, EndForRaysOfAnyNumbers) {
  using Stored = typename TypeParam::Stored;
  using Real = typename TypeParam::Real;
  Chance& chance = this->chance_;
  for (std::int64_t s = cases(30); s > 0; --s) {
    TestScene<Stored> scene = SceneMaker<Stored>(chance, 1).scene();
    const Structure grid = hierarchy_of(scene, any_quality(chance));
    const SceneView<Stored> view = scene.view();
    for (int i = 0; i < 2000; ++i) {
      const Ray<Real> ray = ray_of_any_numbers<Real>(chance);
      Counts counts;
      nearest_hit<Robust<Real>>(view, hierarchy_view_of<Real>(grid), ray, counts);
      ASSERT_LE(counts.cells_visited, grid.nodes.size());
    }
  }
}

// --- Walks through cells ---------------------------------------------------------------------------------

template <class Real>
class GridWalk : public RandomTest {
protected:
  TestScene<Real> scene_of_any_size() {
    return SceneMaker<Real>(chance_, chance_.power_of_two(-10, 20)).scene();
  }
  // Calls act(scene, the grid's view, its margin, ray) for rays through random grids of the scenes.
  template <class MakeScene, class Act>
  void with_rays(std::int64_t scenes, const MakeScene& make_scene, const Act& act) {
    for (std::int64_t s = scenes; s > 0 && !HasFailure(); --s) {
      TestScene<Real> scene = make_scene();
      if (scene.count() == 0) continue;
      const SceneView<Real> view = scene.view();
      const Boxd bounds = scene.bounds();
      const Structure grid = random_grid(chance_, view, bounds);
      RayMaker<Real> rays(chance_, scene, bounds, grid);
      with_view<Real>(grid, [&](const auto& grid_view) {
        for (int i = 0; i < 100 && !HasFailure(); ++i)
          act(view, grid_view, grid.layout.margin, rays.ray());
      });
      EXPECT_FALSE(HasFailure()) << described(grid) << '\n' << described(scene);
    }
  }
};
TYPED_TEST_SUITE(GridWalk, Reals);

// Code that is compiled for fewer kinds of primitives does the same.
TYPED_TEST(GridWalk, FindsTheSameWithoutTheCodeForAbsentKinds) {
  using Real = TypeParam;
  Chance& chance = this->chance_;
  const auto make_scene = [&] {
    TestScene<Real> scene = SceneMaker<Real>(chance, 1).scene();
    if (chance.one_in(3)) scene.triangles.clear();
    if (chance.one_in(3)) scene.spheres.clear();
    if (chance.one_in(2)) scene.cones.clear();
    return scene;
  };
  const auto compare = [](const SceneView<Real>& view, const auto& grid, double, const Ray<Real>& ray) {
    NoCounts counts;
    const Hit<Real> expected = nearest_hit<Robust<Real>>(view, grid, ray, counts);
    const auto expect_same = [&](const Hit<Real>& hit) {
      ASSERT_TRUE(hit.primitive == expected.primitive && same_bits(hit.t, expected.t));
    };
    const bool no_spheres = view.sphere_count == 0, no_cones = view.cone_count == 0;
    if (no_spheres && no_cones)
      expect_same(nearest_hit<Robust<Real, with_triangles>>(view, grid, ray, counts));
    if (view.triangle_count == 0 && no_cones)
      expect_same(nearest_hit<Robust<Real, with_spheres>>(view, grid, ray, counts));
    if (no_cones)
      expect_same(nearest_hit<Robust<Real, with_triangles | with_spheres>>(view, grid, ray, counts));
  };
  this->with_rays(cases(200), make_scene, compare);
}

// The nearest hit by definition: of all primitives' own hits the least t, and there the lowest number.
template <class Real>
Hit<Real> nearest_of_all(const SceneView<Real>& scene, const Ray<Real>& ray, std::int64_t& ties) {
  NoCounts counts;
  const WatertightRay<Real> frame = prepared(ray.origin, ray.direction);
  Hit<Real> nearest{ray.t_max, no_primitive};
  for (std::uint32_t p = 0; p < scene.primitive_count(); ++p) {
    Real t = 0;
    const SceneRecord<Real> from{scene, p};
    if (!intersect<with_all_kinds>(scene, frame, p, from, Real(0), t, counts)) continue;
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
  std::int64_t ties = 0;
  const auto make_scene = [&] {
    TestScene<Real> scene = SceneMaker<Real>(this->chance_, 1).scene();
    repeat_primitives(scene, 1);
    return scene;
  };
  this->with_rays(cases(300), make_scene,
                  [&](const SceneView<Real>& view, const auto& grid, double, Ray<Real> ray) {
                    ray.t_max = RealTraits<Real>::largest;
                    // A ray from inside isn't changed before it is tested.
                    if (contains(view.clip, ray.origin)) expect_nearest(view, grid, ray, ties);
                  });
  EXPECT_GT(ties, cases(100));
}

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
    NearestHit<M, Real, NoCounts> visitor{scene, frame, counts, near.ray.t_min, near.ray.t_max, nothing};
    Walk<Real, View> walk(grid, near);
    if (i > 0) walk.begin_at(grid, at[i]);
    while (visit_cell(grid, walk, visitor) && (i + 1 == at.size() || walk.exit < at[i + 1])) {
    }
    if (is_nearer(visitor.hit.t, visitor.hit.primitive, nearest)) nearest = visitor.hit;
  }
  if (!(nearest.t < near.ray.t_max)) return {ray.t_max, no_primitive};
  return {nearest.t + near.skipped, nearest.primitive};
}

// By whoever has time: the nearest of what the pieces find is what the whole walk finds.
TYPED_TEST(GridWalk, FindsTheSameInPieces) {
  using Real = TypeParam;
  std::int64_t hits = 0;
  this->with_rays(
      cases(1000), [&] { return this->scene_of_any_size(); },
      [&](const SceneView<Real>& view, const auto& grid, double, const Ray<Real>& ray) {
        NoCounts counts;
        const Hit<Real> expected = nearest_hit<Robust<Real>>(view, NoStructure{}, ray, counts);
        const Hit<Real> found = found_in_pieces(this->chance_, view, grid, ray);
        hits += expected.primitive != no_primitive;
        EXPECT_TRUE(found.primitive == expected.primitive && same_bits(found.t, expected.t))
            << described(ray.origin, ray.direction) << ": " << described(found) << ", expected "
            << described(expected);
      });
  EXPECT_GT(hits, cases(10'000));
}

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
  this->with_rays(
      cases(400), [&] { return this->scene_of_any_size(); },
      [&]<class View>(const SceneView<Real>& view, const View& grid, double margin, const Ray<Real>& ray) {
        ClippedRay<Real> clipped;
        if (!clip(ray, view.clip, clipped)) return;
        const WholeWalk<Real> whole(grid, clipped);
        ASSERT_LE(whole.voxels, whole.max_voxels) << described(ray.origin, ray.direction);
        // After a cell of many voxels the place along the other axes is computed anew: off by a rounding.
        double slowest = 1;
        for (int axis = 0; axis < 3; ++axis) {
          const double d = std::abs(static_cast<double>(clipped.ray.direction[axis]));
          if (d > 0) slowest = std::min(slowest, d);
        }
        bool single_voxels = false;
        if constexpr (std::is_same_v<View, GridView<Real>>) single_voxels = grid.block_log2 == 0;
        ASSERT_LE(whole.largest_fall * slowest, single_voxels ? 0 : margin)
            << described(ray.origin, ray.direction);
      });
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
    const Structure uniform = build_structure(view, layout, Overlap::exact);
    std::vector<Structure> joined{in_blocks(uniform, 2)};
    for (const StructureKind kind : {StructureKind::x, StructureKind::balance})
      joined.push_back(build_structure(view, layout, Overlap::exact, {kind, 2}));
    for (int i = 0; i < 30; ++i) {
      const Vec3<Real> origin = cast<Real>(chance.in_box(layout.space));
      const Vec3<Real> d = cast<Real>(chance.direction());
      const ClippedRay<Real> ray{unbounded_ray(origin, d), {1 / d.x, 1 / d.y, 1 / d.z}, 0};
      const Wayfarer expected(view_of<Real>(uniform), ray);
      EXPECT_EQ(expected.counts.voxels_skipped, 0U);
      for (const Structure& grid : joined) {
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
  const auto layout = layout_in<Real>(bounds, {5, 6, 7});
  const Structure uniform = build_structure(view, layout, Overlap::exact);
  std::vector<Structure> grids{uniform, in_blocks(uniform, 2)};
  for (const StructureKind kind : {StructureKind::x, StructureKind::balance, StructureKind::irregular})
    grids.push_back(build_structure(view, layout, Overlap::exact, {kind, 1}));
  for (int i = 0; i < 45; ++i)
    grids.push_back(random_merged_grid(chance, view, bounds));
  for (const Structure& grid : grids) {
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
