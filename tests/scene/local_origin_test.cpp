// Where a scene stands doesn't show: errors, bits and files' contents are those of the scene at its origin.
#include "libscene/local_origin.h"

#include "libscene/file/scene_file.h"
#include "libscene/float32_precision.h"
#include "libscene/nff/nff.h"
#include "tests/random_test.h"
#include "tests/rendering.h"
#include "tests/scene_builder.h"
#include "tests/spd_text.h"
#include "tests/tiny_scene.h"

namespace masu {
namespace {

using LocalOrigin = RandomTest;

constexpr double step = 0x1p-12; // coordinates are multiples of it, up to 2^5: exact up to 2^41 away

double rounded(double value) {
  return std::round(value / step) * step;
}
Vec3d rounded(const Vec3d& v) {
  return {rounded(v.x), rounded(v.y), rounded(v.z)};
}

// A floor, triangles, spheres, cones and lights around zero; seen from nearby.
Scene movable_scene(Chance& chance) {
  Scene scene = empty_scene(rounded(chance.in_cube(10) + Vec3d{0, 0, 14}), rounded(chance.in_cube(2)));
  scene.camera.width = scene.camera.height = 24;
  const auto place = [&] { return rounded(chance.in_cube(chance.one_of({4.0, 8.0}))); };
  const auto size = [&] { return rounded(chance.uniform(0.1, 3)) + step; };
  const auto material = [&] {
    return chance.one_in(4) ? mirror() : chance.one_in(4) ? glass(1.5F) : matte({0.5F, 0.75F, 1});
  };
  for (int i = chance.whole(1, 30); i > 0; --i)
    add_triangle(scene, place(), place(), place(), material());
  for (int i = chance.whole(0, 8); i > 0; --i)
    add_sphere(scene, place(), size() * chance.sign(), material());
  for (int i = chance.whole(0, 8); i > 0; --i) {
    const Vec3d base = place();
    add_cone(scene, {base, size(), base + Vec3d{size(), 0, size()}, chance.one_in(3) ? 0 : size()},
             material());
  }
  for (int i = chance.whole(0, 2); i > 0; --i)
    scene.lights.push_back({rounded(chance.in_cube(30)), {0.5, 0.5, 0.5}});
  return scene;
}

Scene moved(Scene scene, const Vec3d& by) {
  const Vec3d back = -by;
  for (SceneTriangle& t : scene.triangles)
    t = relative_to(back, t);
  for (Sphere<double>& s : scene.spheres)
    s = relative_to(back, s);
  for (Cone<double>& c : scene.cones)
    c = relative_to(back, c);
  for (Light<double>& l : scene.lights)
    l = relative_to(back, l);
  scene.camera = relative_to(back, scene.camera);
  return scene;
}

// From 1 to 10^12 long.
Vec3d far_away(Chance& chance, double least) {
  const double distance = std::pow(10.0, chance.uniform(std::log10(least), 12));
  return rounded(chance.direction() * distance);
}

template <class Stored>
void expect_same_records(const SceneFile& a, const SceneFile& b) {
  const auto x = spans_of(a.view<Stored>(), a.lighting<Stored>()),
             y = spans_of(b.view<Stored>(), b.lighting<Stored>());
  EXPECT_TRUE(same_values(x.triangles, y.triangles));
  EXPECT_TRUE(same_values(x.spheres, y.spheres));
  EXPECT_TRUE(same_values(x.cones, y.cones));
  EXPECT_TRUE(same_values(x.lights, y.lights));
}

// Rays towards the scene, in the world.
std::vector<Ray<double>> random_rays(Chance& chance, const Vec3d& by) {
  std::vector<Ray<double>> rays;
  for (int i = 0; i < 200; ++i) {
    const Vec3d from = rounded(chance.in_cube(20)), to = rounded(chance.in_cube(8));
    rays.push_back(unbounded_ray(from + by, to - from + Vec3d{step, 0, 0}));
  }
  return rays;
}

// Both were written from the same scene, `b` from where it is moved to.
void expect_same_results(const Rendering& a, const Rendering& b, const Vec3d& from_a, const Vec3d& from_b,
                         const RandomSeed& seed) {
  ASSERT_EQ(a.scene().is_float64(), b.scene().is_float64());
  a.scene().is_float64() ? expect_same_records<double>(a.scene(), b.scene())
                         : expect_same_records<float>(a.scene(), b.scene());
  expect_same_frames(a.frame(), b.frame());
  Chance first(seed), second(seed);
  const auto hits = [](const Rendering& r, const std::vector<Ray<double>>& rays) {
    return r.tracer().hits(rays, {}, HitName::primitive);
  };
  const RayHits found = hits(a, random_rays(first, from_a));
  EXPECT_TRUE(std::ranges::any_of(found.hits, [](const HitRecord& hit) { return hit.name >= 0; }));
  EXPECT_TRUE(same_values(found.hits, hits(b, random_rays(second, from_b)).hits));
}

TEST_F(LocalOrigin, AMovedSceneIsTheSameBitsAboutItsOwnOrigin) {
  for (int i = 0; i < cases(30); ++i) {
    const Scene scene = movable_scene(chance_);
    const Store store = chance_.one_of({Store::automatic, Store::float32, Store::float64});
    // Both far enough to have an origin.
    const Vec3d by = far_away(chance_, 100), other = far_away(chance_, 100);
    SCOPED_TRACE(testing::Message() << by.x << ' ' << by.y << ' ' << by.z << ", " << other.x << ' ' << other.y
                                    << ' ' << other.z);
    const Rendering a(moved(scene, by), store), b(moved(scene, other), store);
    EXPECT_EQ(a.scene().origin() - by, b.scene().origin() - other);
    EXPECT_EQ(a.scene().bounds().min, b.scene().bounds().min);
    EXPECT_EQ(a.scene().bounds().max, b.scene().bounds().max);
    expect_same_results(a, b, by, other, seed_);
  }
}

TEST_F(LocalOrigin, AMovedSceneIsTheSameBitsAsAtZeroWhereItIsCentredThere) {
  for (int i = 0; i < cases(15); ++i) {
    Scene scene = movable_scene(chance_);
    for (const Vec3d& corner : {Vec3d{-16, -16, -16}, Vec3d{16, 16, 16}})
      add_triangle(scene, corner, corner * 0.5, {0, 0, corner.z}, matte({1, 1, 1}));
    const Vec3d by = far_away(chance_, 100);
    const Rendering a(scene, Store::automatic), b(moved(scene, by), Store::automatic);
    EXPECT_EQ(a.scene().origin(), (Vec3d{0, 0, 0}));
    EXPECT_EQ(b.scene().origin(), by);
    expect_same_results(a, b, {0, 0, 0}, by, seed_);
  }
}

TEST_F(LocalOrigin, AGivenOneMakesAnySceneTheSameBitsAsAtZero) {
  for (int i = 0; i < cases(30); ++i) {
    const Scene scene = movable_scene(chance_);
    const Vec3d by = far_away(chance_, 1);
    const Rendering a(scene, Store::automatic, "auto", {}, Vec3d{0, 0, 0}),
        b(moved(scene, by), Store::automatic, "auto", {}, by);
    EXPECT_EQ(b.scene().origin(), by);
    expect_same_results(a, b, {0, 0, 0}, by, seed_);
  }
}

TEST_F(LocalOrigin, IsZeroForTheStandardScenes) {
  for (const SpdInfo& info : spd_scenes()) {
    SCOPED_TRACE(info.name);
    for (int size = info.min_size; size <= std::min(info.standard, 5); ++size)
      EXPECT_EQ(automatic_origin(parse_nff(spd_text({info.scene, size}), "")), (Vec3d{0, 0, 0})) << size;
  }
}

// The largest coordinate, of which error bounds are multiples, is half the scene's extent.
TEST_F(LocalOrigin, BoundsErrorsByTheExtent) {
  for (int i = 0; i < cases(200); ++i) {
    Scene scene = empty_scene({0, 0, 3}, {0, 0, 0});
    const Vec3d at = chance_.direction() * std::pow(10.0, chance_.uniform(-3, 12));
    const double size = largest_magnitude(at) * std::pow(10.0, chance_.uniform(-9, 3));
    for (int k = 0; k < 10; ++k)
      add_sphere(scene, at + chance_.in_cube(size), size * chance_.uniform(0.01, 0.3), matte({1, 1, 1}));
    const Boxd box = bounds(scene);
    const Vec3d origin = automatic_origin(scene);
    const double half = largest_magnitude(box.max - box.min) / 2;
    const double reach = largest_magnitude(relative_to(origin, box));
    const double center = length((box.min + box.max) * 0.5), diagonal = length(box.max - box.min) / 2;
    EXPECT_LE(reach, largest_magnitude(box) * (1 + 1e-15));
    if (origin == Vec3d{0, 0, 0})
      EXPECT_LE(center, diagonal * (1 + 1e-6));
    else
      EXPECT_LE(reach, half * (1 + 1.0 / 128) + 1e-15 * center);
  }
}

TEST_F(LocalOrigin, RaysOfFloatsKeepTheirDigitsRelativeToIt) {
  Scene scene = empty_scene({0, 0, 3}, {0, 0, 0});
  const Vec3d at{4.5e6, 5.25e6, 100};
  add_sphere(scene, at, 1, matte({1, 1, 1}));
  add_sphere(scene, at + Vec3d{0, 4, 0}, 0.5, matte({1, 1, 1}));
  const Rendering rendering(scene, Store::automatic);
  EXPECT_FALSE(rendering.scene().is_float64());
  const Vec3d origin = rendering.scene().origin();
  EXPECT_LE(largest_magnitude(origin - at), 4);
  const ResidentTracer tracer = rendering.tracer();
  const Vec3d from = at + Vec3d{0.125, 0.0625, 10};
  const std::vector<Ray<double>> world{unbounded_ray(from, Vec3d{0, 0, -1})};
  const std::vector<Ray<float>> local{unbounded_ray(cast<float>(from - origin), Vec3f{0, 0, -1})};
  const RayHits wide = tracer.hits(world, {}, HitName::primitive);
  EXPECT_TRUE(same_values(wide.hits, tracer.hits(relative(local), {}, HitName::primitive).hits));
  EXPECT_NEAR(wide.hits[0].t, 10 - std::sqrt(1 - 0.125 * 0.125 - 0.0625 * 0.0625), 1e-5);
}

TEST_F(LocalOrigin, ThatIsNoPointIsRefused) {
  const TemporaryFolder folder;
  const Scene scene = tiny_scene();
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(),
                   infinity = std::numeric_limits<double>::infinity();
  for (const Vec3d& origin :
       {Vec3d{nan, 0, 0}, Vec3d{0, infinity, 0}, Vec3d{0, 0, -1e300}, Vec3d{1e101, 0, 0}})
    EXPECT_THROW(write_scene(scene, Store::automatic, folder.file("scene"), origin), Error);
  // One that makes coordinates too large for the store.
  EXPECT_THROW(write_scene(scene, Store::float32, folder.file("scene"), Vec3d{1e99, 0, 0}), Error);
  EXPECT_THROW(write_scene(scene, Store::float32, folder.file("scene"), Vec3d{2e12, 0, 0}), Error);
}

} // namespace
} // namespace masu
