// The rule of --store auto: which scenes float32 is precise enough for.
#include "libscene/float32_precision.h"
#include "libscene/geometry/margin.h"
#include "tests/random_test.h"
#include "tests/scene_builder.h"
#include "tests/temporary_folder.h"
#include "tests/tiny_scene.h"

namespace masu {
namespace {

using Float32Precisions = RandomTest;

const Material plain_white = matte({1, 1, 1});

// Within ±1, so that twice the margin is 1.53e-5.
constexpr double speck_size = 2.0 * margin_roundings / (1 << 24);

Scene wall_of_size_1() {
  Scene scene = empty_scene({0, 0, 3}, {0, 0, 0});
  add_triangle(scene, {-1, -1, 0}, {1, -1, 0}, {0, 1, 0}, plain_white);
  return scene;
}
void add_speck(Scene& scene, const Vec3d& at, double across = 0.5 * speck_size) {
  add_triangle(scene, at, at + Vec3d{across, 0, 0}, at + Vec3d{0, across / 2, across / 2}, plain_white);
}
std::uint64_t parts_of(const Scene& scene) {
  return float32_precision(scene).standing_alone;
}

TEST_F(Float32Precisions, SpecksThatStandAloneAreCounted) {
  Scene scene = wall_of_size_1();
  EXPECT_TRUE(float32_precision(scene).suffices());
  EXPECT_DOUBLE_EQ(2 * float32_precision(scene).margin, speck_size);
  add_speck(scene, {0.25, 0.25, 0.25});
  EXPECT_EQ(parts_of(scene), 1U);
  EXPECT_FALSE(float32_precision(scene).suffices());
  add_speck(scene, {-0.25, 0.25, 0.25}, speck_size);       // no larger
  add_speck(scene, {-0.5, 0.25, 0.25}, 1.01 * speck_size); // larger
  add_sphere(scene, {0, 0, 0.5}, 0.4 * speck_size, plain_white);
  add_sphere(scene, {0, 0, 0.5}, 0.6 * speck_size, plain_white);
  add_cone(scene, {{0, 0.5, 0.5}, speck_size / 4, {0, 0.5, 0.5 + speck_size / 2}, 0}, plain_white);
  EXPECT_EQ(parts_of(scene), 4U);
  // Of no area and of no size.
  add_triangle(scene, {0.5, 0, 0.5}, {0.5, 0, 0.5}, {0.5, 0, 0.5 + speck_size / 4}, plain_white);
  add_triangle(scene, {0.5, 0, 0.75}, {0.5, 0, 0.75}, {0.5, 0, 0.75}, plain_white);
  EXPECT_EQ(parts_of(scene), 6U);
}

TEST_F(Float32Precisions, SpecksAtACornerOfALargerTriangleBelongToIt) {
  Scene scene = wall_of_size_1();
  add_speck(scene, {0, 1, 0});
  add_speck(scene, {0.5 * speck_size, 1, 0}); // at a corner of the last one alone
  EXPECT_EQ(parts_of(scene), 0U);
  add_speck(scene, {0, 0.5, 0}); // inside the large one, at none of its corners
  EXPECT_EQ(parts_of(scene), 1U);
}

TEST_F(Float32Precisions, CornersAreSharedThatRoundToTheSame) {
  Scene scene = wall_of_size_1();
  add_speck(scene, {1 + 1e-9, -1 - 1e-9, 0});
  EXPECT_EQ(parts_of(scene), 0U);
  add_speck(scene, {-1, -1 + 1e-6, 0});
  EXPECT_EQ(parts_of(scene), 1U);
  Scene signs = empty_scene({0, 0, 3}, {0, 0, 0});
  add_triangle(signs, {-0.0, 0, -0.0}, {1, 0, 0}, {0, 1, 0}, plain_white);
  add_speck(signs, {0.0, -0.0, 0.0});
  EXPECT_EQ(parts_of(signs), 0U);
}

TEST_F(Float32Precisions, AFineMeshIsOnePart) {
  Scene scene = wall_of_size_1();
  const double step = 0.25 * speck_size;
  const auto add_strip = [&](double y, int length) {
    for (int i = 0; i < length; ++i)
      add_triangle(scene, {i * step, y, 0.5}, {(i + 1) * step, y, 0.5}, {i * step, y + step, 0.5},
                   plain_white);
  };
  add_strip(0.25, 5);
  EXPECT_EQ(parts_of(scene), 0U);
  add_strip(-0.25, 4);
  EXPECT_EQ(parts_of(scene), 1U);
}

TEST_F(Float32Precisions, DigitsAreNoReason) {
  Scene scene = empty_scene({0, 0, 3}, {0, 0, 0});
  add_triangle(scene, {0.123456789012, 1.0 / 3, 0}, {1.0 / 7, -1.0 / 9, 0}, {-2.0 / 3, 0, 1.0 / 11},
               plain_white);
  add_sphere(scene, {0.1, 0.2, 0.3}, 1.0 / 3, plain_white);
  add_cone(scene, {{0.1, 0.2, 0.3}, 0.1, {0.3, 0.1, 0.2}, 0.2}, plain_white);
  const Float32Precision precision = float32_precision(scene);
  EXPECT_TRUE(precision.suffices());
  EXPECT_GT(precision.rounding, 0);
  EXPECT_LE(precision.rounding, precision.margin / margin_roundings);
}

TEST_F(Float32Precisions, RoundingIsTheLargestOfAnyNumber) {
  constexpr double off = 0x1p-27; // of 0.5: float32 has 0x1p-25
  using Change = void (*)(Scene&);
  const std::initializer_list<Change> changes{
      [](Scene& s) { s.triangles[0].a.x += off; },     [](Scene& s) { s.triangles[0].c.z += off; },
      [](Scene& s) { s.spheres[0].center.y += off; },  [](Scene& s) { s.spheres[0].radius += off; },
      [](Scene& s) { s.cones[0].base.x += off; },      [](Scene& s) { s.cones[0].apex.z += off; },
      [](Scene& s) { s.cones[0].base_radius += off; }, [](Scene& s) { s.cones[0].apex_radius -= off; }};
  Scene scene = empty_scene({0, 0, 3}, {0, 0, 0});
  add_triangle(scene, {0.5, 0.5, 0.5}, {1, 0.5, 0}, {0, 0.5, 0.5}, plain_white);
  add_sphere(scene, {0.5, 0.5, 0.5}, 0.5, plain_white);
  add_cone(scene, {{0.5, 0, 0}, 0.5, {0.5, 0.5, 0.5}, 0.75}, plain_white);
  EXPECT_EQ(float32_precision(scene).rounding, 0);
  for (const Change& change : changes) {
    Scene changed = scene;
    change(changed);
    EXPECT_EQ(float32_precision(changed).rounding, off);
  }
}

TEST_F(Float32Precisions, ConesThatRoundingTurnsAreCounted) {
  Scene scene = wall_of_size_1();
  // Its axis of 1e-6 turns by a few percent; twice as a number of float32 it doesn't.
  add_cone(scene, {{0.3, 0.3, 0.3}, 0.5, {0.3 + 3e-8, 0.3, 0.3 + 1e-6}, 0.25}, plain_white);
  EXPECT_EQ(float32_precision(scene).moved_cones, 1U);
  add_cone(scene, {{0.25, 0.25, 0.25}, 0.5, {0.25, 0.25, 0.25 + 0x1p-20}, 0.25}, plain_white);
  EXPECT_EQ(float32_precision(scene).moved_cones, 1U);
  add_cone(scene, {{0.3, 0.3, 0.3}, 0.5, {0.3, 0.3, 0.3 + 1e-10}, 0.25}, plain_white); // no length
  EXPECT_EQ(float32_precision(scene).moved_cones, 2U);
}

TEST_F(Float32Precisions, DependsOnRangeAndDistance) {
  const auto sphere = [](double x, double radius) {
    Scene scene = empty_scene({0, 0, 3}, {0, 0, 0});
    add_sphere(scene, {x, 0, 0}, radius, plain_white);
    return scene;
  };
  EXPECT_TRUE(float32_precision(sphere(1000, 16)).suffices());
  EXPECT_TRUE(float32_precision(sphere(1e6, 1)).is_far());
  EXPECT_FALSE(float32_precision(sphere(0, 2e12)).in_range);
  EXPECT_FALSE(float32_precision(sphere(1e50, 1)).in_range);
  EXPECT_TRUE(std::isinf(float32_precision(sphere(1e50, 1)).rounding));
  EXPECT_FALSE(float32_precision(sphere(0, 1e-11)).in_range);
  Scene lit = sphere(0, 1);
  add_light(lit, {0, -2e12, 0});
  EXPECT_FALSE(float32_precision(lit).in_range);
  EXPECT_TRUE(float32_precision(empty_scene({0, 0, 3}, {0, 0, 0})).suffices());
}

// Parts by definition: grown from each triangle until nothing more shares a corner.
std::uint64_t parts_by_definition(const GrowingArray<SceneTriangle>& triangles, double limit) {
  const auto shares = [](const SceneTriangle& s, const SceneTriangle& t) {
    for (const Vec3d& a : {s.a, s.b, s.c})
      for (const Vec3d& b : {t.a, t.b, t.c})
        if (cast<float>(a) == cast<float>(b)) return true;
    return false;
  };
  const auto largest = [](const Boxd& box) { return largest_magnitude(box.max - box.min); };
  const auto is_small = [&](std::size_t i) { return largest(bounds(triangles[i])) <= limit; };
  std::vector<bool> seen(triangles.size());
  std::uint64_t parts = 0;
  for (std::size_t first = 0; first < triangles.size(); ++first) {
    if (seen[first] || !is_small(first)) continue;
    std::vector<std::size_t> part{first};
    seen[first] = true;
    bool attached = false;
    Boxd box = empty_box<double>();
    for (std::size_t next = 0; next < part.size(); ++next) {
      box = join(box, cast<double>(cast<float>(bounds(triangles[part[next]]))));
      for (std::size_t i = 0; i < triangles.size(); ++i) {
        if (seen[i] || !shares(triangles[i], triangles[part[next]])) continue;
        if (!is_small(i)) {
          attached = true;
          continue;
        }
        seen[i] = true;
        part.push_back(i);
      }
    }
    parts += !attached && largest(box) <= limit ? 1 : 0;
  }
  return parts;
}

TEST_F(Float32Precisions, PartsOfRandomTrianglesAreThoseOfTheDefinition) {
  std::uint64_t counted = 0, scenes_without = 0;
  for (int i = 0; i < 300; ++i) {
    Scene scene = wall_of_size_1();
    // Corners on a few points of a fine lattice, some of them off by less than rounding.
    const double lattice = 0.3 * speck_size, spread = chance_.uniform(1, 40);
    const auto corner = [&] {
      const auto on_lattice = [&] { return std::floor(chance_.uniform(0, spread)) * lattice; };
      const Vec3d at{0.5 + on_lattice(), 0.5 + on_lattice(), 0.5};
      return at + Vec3d{chance_.uniform(0, 1e-9), 0, 0};
    };
    const int triangles = static_cast<int>(chance_.uniform(1, 60));
    for (int n = 0; n < triangles; ++n) {
      const Vec3d a = corner();
      const auto near = [&] {
        const auto off = [&] { return std::floor(chance_.uniform(-2, 3)) * lattice; };
        return a + Vec3d{off(), off(), 0};
      };
      if (n % 7 == 6)
        add_triangle(scene, a, {0, 0, 0}, corner(), plain_white);
      else
        add_triangle(scene, a, near(), near(), plain_white);
    }
    const Float32Precision precision = float32_precision(scene);
    const std::uint64_t expected = parts_by_definition(scene.triangles, 2 * precision.margin);
    ASSERT_EQ(precision.standing_alone, expected) << "scene " << i;
    counted += expected;
    scenes_without += expected == 0 ? 1 : 0;
  }
  EXPECT_GT(counted, 0U);
  EXPECT_GT(scenes_without, 0U);
}

// The scene file's geometry is judged as the text's was, except for what rounding did.
TEST_F(Float32Precisions, IsThatOfTheStoredScene) {
  const TemporaryFolder folder;
  Scene scene = wall_of_size_1();
  add_speck(scene, {0.25, 0.25, 0.25});
  for (const Store store : {Store::float32, Store::float64}) {
    write_scene(scene, store, folder.file("a.scene"));
    const SceneFile file(folder.file("a.scene"));
    const Float32Precision precision =
        store == Store::float32 ? float32_precision(spans_of(file.view<float>(), file.lighting<float>()))
                                : float32_precision(spans_of(file.view<double>(), file.lighting<double>()));
    EXPECT_EQ(precision.standing_alone, 1U);
    EXPECT_EQ(precision.rounding, store == Store::float32 ? 0 : float32_precision(scene).rounding);
  }
}

} // namespace
} // namespace masu
