// Pictures follow the rules: shading by its formula, mirrors and glass by their laws, shadows, depth.
#include "tests/random_test.h"
#include "tests/rendering.h"
#include "tests/scene_builder.h"

#include <cmath>
#include <functional>
#include <span>

namespace masu {
namespace {

// Of the ray straight ahead, among the nine that empty_scene's camera shoots.
constexpr std::size_t middle = 4;

void expect_color(const Vec3f& actual, const Vec3d& expected, double tolerance) {
  for (int channel = 0; channel < 3; ++channel) {
    const double allowed = tolerance * std::max(1.0, std::abs(expected[channel]));
    EXPECT_NEAR(static_cast<double>(actual[channel]), expected[channel], allowed) << "channel " << channel;
  }
}
void expect_color(const Vec3f& actual, const Vec3f& expected) {
  expect_color(actual, cast<double>(expected), 1e-5);
}

// A material with a highlight, and lights before the surface at the origin that faces `normal`.
Material lit_from(Scene& scene, Chance& chance, const Vec3d& normal) {
  scene.ambient = random_share(chance);
  for (int i = 0; i < 3; ++i)
    add_light(scene, random_towards(chance, normal) * chance.uniform(2, 20),
              cast<double>(random_color(chance)));
  return {random_color(chance),
          random_share(chance),
          0.2F + 0.8F * random_share(chance),
          static_cast<float>(chance.uniform(1, 30)),
          0,
          1};
}
// The shading formula, in double: I = Ia Kd C + Σ visible Il (Kd C (N·L) + Ks max(0, R·V)^n).
// `outwards` and `to_viewer` are unit vectors; all lights are visible.
Vec3d direct_light_of(const Scene& scene, const Material& material, const Vec3d& point, const Vec3d& outwards,
                      const Vec3d& to_viewer) {
  const Vec3d normal = dot(outwards, to_viewer) >= 0 ? outwards : -outwards;
  const Vec3d diffuse = cast<double>(material.color) * static_cast<double>(material.diffuse);
  Vec3d sum = diffuse * static_cast<double>(scene.ambient);
  for (const Light<double>& light : scene.lights) {
    const Vec3d l = normalized(light.position - point);
    const double cosine = dot(normal, l);
    if (cosine <= 0) continue;
    const Vec3d r = normal * (2 * cosine) - l;
    const double highlight = static_cast<double>(material.specular) *
                             std::pow(std::max(0.0, dot(r, to_viewer)), static_cast<double>(material.shine));
    sum = sum + light.intensity * (diffuse * cosine + Vec3d{highlight, highlight, highlight});
  }
  return sum;
}
// What has a highlight is a mirror too: where nothing stands before it, the background's part comes on top.
Vec3d with_background(const Vec3d& direct, const Material& material) {
  return direct + cast<double>(test_background) * static_cast<double>(material.specular);
}

// All of it holds for either store, and so for either arithmetic.
class Render : public RandomTest, public testing::WithParamInterface<Store> {
protected:
  Frame render(const Scene& scene, std::int32_t depth = 5) const {
    const Rendering rendering(scene, GetParam());
    FrameRequest request = rendering.request();
    request.rules.depth = depth;
    return rendering.frame(request);
  }
  Vec3f color_ahead(const Scene& scene) const { return render(scene).radiance[middle]; }
  // Of what `add` puts into the scene: its surface at the origin has the material and the normal.
  template <class Add>
  void expect_shaded(const Vec3d& normal, const Add& add) {
    const Vec3d to_viewer = random_towards(chance_, normal);
    Scene scene = empty_scene(to_viewer * chance_.uniform(1, 10), {0, 0, 0});
    const Material material = lit_from(scene, chance_, normal);
    add(scene, material);
    const Vec3d direct = direct_light_of(scene, material, {0, 0, 0}, normal, to_viewer);
    expect_color(color_ahead(scene), with_background(direct, material), tolerance());
  }
  double tolerance() const { return GetParam() == Store::float64 ? 1e-5 : 2e-3; }
};

const auto by_store = [](const auto& test) {
  return std::string(test.param == Store::float32 ? "Float32" : "Float64");
};
INSTANTIATE_TEST_SUITE_P(Stores, Render, testing::Values(Store::float32, Store::float64), by_store);

TEST_P(Render, ATriangleIsShadedByTheFormulaFromEitherSide) {
  const Vec3d normal{0, 0, 1};
  for (const Vec3d& front : {normal, -normal})
    for (int i = 0; i < 25; ++i)
      expect_shaded(normal, [&](Scene& scene, const Material& material) {
        add_wall(scene, {0, 0, 0}, front, material, 1);
      });
}

TEST_P(Render, ASphereIsShadedByTheFormula) {
  for (int i = 0; i < 50; ++i) {
    const Vec3d normal = chance_.direction();
    const double radius = chance_.uniform(0.1, 3);
    expect_shaded(normal, [&](Scene& scene, const Material& material) {
      add_sphere(scene, normal * -radius, radius, material);
    });
  }
}

TEST_P(Render, AConeIsShadedByTheFormula) {
  for (int i = 0; i < 50; ++i) {
    // The middle of the side's line that lies towards `out` comes to the origin.
    const Vec3d axis = chance_.direction(),
                out = normalized(cross(axis, random_towards(chance_, axis, -0.9)));
    const double r0 = chance_.uniform(0.2, 1), r1 = i % 3 == 0   ? r0
                                                    : i % 3 == 1 ? 0
                                                                 : chance_.uniform(0.2, 1);
    const Vec3d base = axis * -1.0 - out * ((r0 + r1) / 2), apex = base + axis * 2.0;
    expect_shaded(normalized(out * 2.0 - axis * (r1 - r0)), [&](Scene& scene, const Material& material) {
      add_cone(scene, {base, r0, apex, r1}, material);
    });
  }
}

TEST_P(Render, APatchIsShadedByTheNormalBetweenItsCorners) {
  for (int i = 0; i < 50; ++i) {
    const Vec3d front{0, 0, 1}, to_viewer = random_towards(chance_, front, 0.6);
    Scene scene = empty_scene(to_viewer * 5.0, {0, 0, 0});
    const Material material = lit_from(scene, chance_, front);
    const Vec3d a = random_towards(chance_, front, 0.8), b = random_towards(chance_, front, 0.8),
                c = random_towards(chance_, front, 0.8);
    add_triangle(scene, {-1, -1, 0}, {2, -1, 0}, {-1, 2, 0}, material); // about the origin
    scene.normals = {{a * chance_.uniform(0.1, 9), b * chance_.uniform(0.1, 9), c * chance_.uniform(0.1, 9)}};
    scene.triangles[0].normals = 0;
    const Vec3d normal = normalized(a + b + c);
    const Vec3d direct = direct_light_of(scene, material, {0, 0, 0}, normal, to_viewer);
    expect_color(render(scene, 1).radiance[middle], direct, tolerance());
  }
}

TEST_P(Render, WithoutLightsAmbientIsAllThatThereIs) {
  Scene scene = empty_scene({0, 0, 5}, {0, 0, 0});
  scene.ambient = 0.5F;
  add_wall(scene, {0, 0, 0}, {0, 0, 1}, {{0.25F, 0.5F, 1}, 0.5F, 0, 0, 0, 1});
  const Frame frame = render(scene);
  for (const Vec3f& color : frame.radiance)
    expect_color(color, {0.0625F, 0.125F, 0.25F});
  EXPECT_EQ(frame.counts.shadow_rays, 0U);
}

TEST_P(Render, OfNothingIsTheBackground) {
  const Frame frame = render(empty_scene({0, 0, 5}, {0, 0, 0}));
  for (const Vec3f& color : frame.radiance)
    EXPECT_EQ(color, test_background);
  for (const HitRecord& hit : frame.hits)
    EXPECT_EQ(hit.name, -1);
  EXPECT_EQ(frame.counts.camera_rays, 9U);
  EXPECT_EQ(frame.counts.camera_hits, 0U);
}

TEST_P(Render, AMirrorShowsTheBackground) {
  Scene scene = empty_scene({1, 2, 5}, {0, 0, 0});
  add_wall(scene, {0, 0, 0}, {0, 0, 1}, mirror());
  const Frame frame = render(scene);
  for (const Vec3f& color : frame.radiance)
    EXPECT_EQ(color, test_background);
  EXPECT_EQ(frame.counts.camera_hits, 9U);
  EXPECT_EQ(frame.counts.reflection_rays, 9U);
  EXPECT_EQ(frame.counts.secondary_hits, 0U);
}

TEST_P(Render, AMirrorShowsWhatStandsInTheMirroredDirection) {
  for (int i = 0; i < 50; ++i) {
    const Vec3d normal = chance_.direction(), to_viewer = random_towards(chance_, normal, 0.3);
    if (dot(to_viewer, normal) > 0.95) continue; // the target would stand before the eye
    Scene scene = empty_scene(to_viewer * 4.0, {0, 0, 0});
    add_wall(scene, {0, 0, 0}, normal, mirror(), 1);
    const Vec3d seen = normal * (2 * dot(normal, to_viewer)) - to_viewer;
    const Vec3f color = random_color(chance_);
    add_sphere(scene, seen * 3.0, 0.02, matte(color));
    expect_color(color_ahead(scene), color);
  }
}

TEST_P(Render, GlassBendsBySnellsLawOnEitherSide) {
  for (int i = 0; i < 60; ++i) {
    const float index = static_cast<float>(chance_.uniform(1.05, 2));
    const bool enters = i % 2 == 0; // the eye is in the air, before the front
    const Vec3d normal = chance_.direction(), to_viewer = random_towards(chance_, normal, 0.05);
    const double ratio = enters ? 1 / static_cast<double>(index) : static_cast<double>(index);
    const Vec3d sideways = (to_viewer - normal * dot(normal, to_viewer)) * -ratio;
    const double depth_square = 1 - dot(sideways, sideways);
    if (depth_square < 0.02) continue; // nearly or fully mirrored
    Scene scene = empty_scene(to_viewer * 4.0, {0, 0, 0});
    add_wall(scene, {0, 0, 0}, enters ? normal : -normal, glass(index), 1);
    const Vec3f color = random_color(chance_);
    add_sphere(scene, (sideways - normal * std::sqrt(depth_square)) * 3.0, 0.02, matte(color));
    expect_color(color_ahead(scene), color);
  }
}

TEST_P(Render, BeyondTheCriticalAngleNothingIsRefracted) {
  for (const bool is_beyond : {false, true}) {
    const double sine = is_beyond ? 0.68 : 0.65; // critical: 1/1.5
    Scene scene = empty_scene(Vec3d{sine, 0, std::sqrt(1 - sine * sine)} * 4.0, {0, 0, 0});
    scene.camera.angle = 0.01;
    Material material = glass(1.5F);
    material.specular = 0.5F;
    add_wall(scene, {0, 0, 0}, {0, 0, -1}, material); // the eye is inside
    const Frame frame = render(scene);
    EXPECT_EQ(frame.counts.refraction_rays, is_beyond ? 0U : 9U);
    EXPECT_EQ(frame.counts.reflection_rays, 9U);
    for (const Vec3f& color : frame.radiance)
      expect_color(color, test_background * (is_beyond ? 0.5F : 1.5F));
  }
}

// How far a ray passes from where another sphere, or none, becomes the nearest that it hits.
double distance_to_edge(std::span<const Sphere<double>> spheres, const Ray<double>& ray) {
  double nearest = INFINITY, edge = INFINITY;
  for (const Sphere<double>& sphere : spheres) {
    const Vec3d to_center = sphere.center - ray.origin;
    const double ahead = dot(to_center, ray.direction), across = length(to_center - ray.direction * ahead);
    edge = std::min(edge, std::abs(across - sphere.radius));
    if (!(across < sphere.radius)) continue;
    const double t = ahead - std::sqrt(sphere.radius * sphere.radius - across * across);
    edge = std::min(edge, std::abs(t - nearest));
    nearest = std::min(nearest, t);
  }
  return edge;
}

TEST_P(Render, GlassOfIndexOneIsInvisible) {
  Scene scene = empty_scene({0, 0, 5}, {0, 0, 0});
  scene.camera.width = scene.camera.height = 31;
  for (int i = 0; i < 20; ++i)
    add_sphere(scene, {chance_.uniform(-4, 4), chance_.uniform(-4, 4), chance_.uniform(-9, -4)}, 0.5,
               matte(random_color(chance_)));
  const Frame without = render(scene);
  const std::size_t opaque = scene.spheres.size();
  add_sphere(scene, {0, 0, 0}, 2, glass(1));
  add_sphere(scene, {0, 1, 0}, 0.5, glass(1)); // inside the first
  add_wall(scene, {0, 0, -3}, {1, 2, 3}, glass(1));
  const Frame with = render(scene, 9);
  EXPECT_GT(with.counts.refraction_rays, 900U);
  // Only where an edge passes so near that a ray's errors reach it. The largest is that of a refracted
  // direction: u / cos of the angle of incidence, √u at most, which for float32 is 5e-3 over a path of 20.
  const std::span spheres(scene.spheres.data(), opaque);
  const auto rays = camera_rays<double>(scene.camera, Sampling::corners, false);
  for (std::size_t i = 0; i < with.radiance.size(); ++i) {
    if (with.radiance[i] == without.radiance[i]) continue;
    const auto column = static_cast<std::int32_t>(i) % rays.columns,
               row = static_cast<std::int32_t>(i) / rays.columns;
    EXPECT_LT(distance_to_edge(spheres, camera_ray(rays, column, row)), 5e-3) << column << ", " << row;
  }
}

// What can stand between a point and a light: about `at`, within a few times `size`.
using Block = std::function<void(Scene&, const Vec3d& at, const Vec3d& towards, double size)>;
std::vector<std::pair<const char*, Block>> blockers() {
  const Material white = matte({1, 1, 1});
  return {{"triangle",
           [=](Scene& s, const Vec3d& at, const Vec3d& n, double size) { add_wall(s, at, n, white, size); }},
          {"triangle from behind",
           [=](Scene& s, const Vec3d& at, const Vec3d& n, double size) { add_wall(s, at, -n, white, size); }},
          {"sphere",
           [=](Scene& s, const Vec3d& at, const Vec3d&, double size) { add_sphere(s, at, size, white); }},
          {"glass",
           [=](Scene& s, const Vec3d& at, const Vec3d&, double size) { add_sphere(s, at, size, glass(1)); }},
          {"cone", [=](Scene& s, const Vec3d& at, const Vec3d& n, double size) {
             const Vec3d half = normalized(cross(n, {0.3, -0.5, 0.8})) * size;
             add_cone(s, {at - half, size / 2, at + half, size}, white);
           }}};
}

TEST_P(Render, AnyObjectBetweenPointAndLightThrowsAShadow) {
  for (const auto& [name, block] : blockers()) {
    for (const double share : {0.5, 0.02, 1.5, -0.5}) { // of the way from the point to the light
      SCOPED_TRACE(testing::Message() << name << " at " << share);
      const Vec3d normal = chance_.direction(), to_light = random_towards(chance_, normal);
      Vec3d to_viewer = random_towards(chance_, normal);
      while (dot(to_viewer, to_light) > 0.7)
        to_viewer = random_towards(chance_, normal);
      Scene scene = empty_scene(to_viewer * 20.0, {0, 0, 0});
      scene.ambient = 0.25F;
      scene.camera.angle = 1e-3;
      add_light(scene, to_light * 20.0, {1, 1, 1});
      add_wall(scene, {0, 0, 0}, normal, matte({1, 1, 1}), 1);
      block(scene, to_light * (20 * share), to_light, std::min(0.2, 1.5 * std::abs(share)));
      const bool is_dark = share > 0 && share < 1;
      const double light = is_dark ? 0.25 : 0.25 + dot(normal, to_light);
      const Frame frame = render(scene);
      expect_color(frame.radiance[middle], Vec3d{light, light, light}, 1e-4);
      EXPECT_EQ(frame.counts.shadow_rays, 9U);
      EXPECT_EQ(frame.counts.shadow_hits, is_dark ? 9U : 0U);
    }
  }
}

TEST_P(Render, ALightBehindTheSurfaceGetsNoShadowRay) {
  Scene scene = empty_scene({0, 0, 5}, {0, 0, 0});
  add_wall(scene, {0, 0, 0}, {0, 0, 1}, matte({0.5F, 0.5F, 0.5F}));
  add_light(scene, {0, 0, -5});
  add_light(scene, {3, 0, 0}); // in the surface's own plane
  const Frame frame = render(scene);
  EXPECT_EQ(frame.counts.shadow_rays, 0U);
  for (const Vec3f& color : frame.radiance)
    expect_color(color, {0.5F, 0.5F, 0.5F});
}

// The camera stands between two walls.
Scene between_walls(const Material& material) {
  Scene scene = empty_scene({0, 0, 0}, {0, 0, -1});
  scene.camera.angle = 10;
  add_wall(scene, {0, 0, -1}, {0, 0, 1}, material);
  add_wall(scene, {0, 0, 1}, {0, 0, -1}, material);
  return scene;
}

TEST_P(Render, RaysEndAtTheDepthAskedFor) {
  const Scene scene = between_walls({{1, 1, 1}, 0.25F, 0.5F, 1, 0, 1});
  for (const std::int32_t depth : {1, 2, 5, 8, largest_depth}) {
    const Frame frame = render(scene, depth);
    EXPECT_EQ(frame.counts.reflection_rays, 9U * static_cast<unsigned>(depth - 1));
    EXPECT_EQ(frame.counts.secondary_hits, frame.counts.reflection_rays);
    const double sum = 0.25 * (1 - std::pow(0.5, depth)) / 0.5; // a geometric series
    expect_color(frame.radiance[middle], Vec3d{sum, sum, sum}, 1e-5);
  }
}

TEST_P(Render, GlassAndMirrorAtOnceBranchAtEveryDepth) {
  // Between two half-transparent mirrors each ray goes on as two, of which one leaves for good.
  const Scene scene = between_walls({{0, 0, 0}, 0, 0.5F, 1, 0.5F, 1});
  for (const std::int32_t depth : {1, 2, 5, largest_depth}) {
    const Frame frame = render(scene, depth);
    EXPECT_EQ(frame.counts.reflection_rays, 9U * static_cast<unsigned>(depth - 1));
    EXPECT_EQ(frame.counts.refraction_rays, frame.counts.reflection_rays);
    expect_color(frame.radiance[middle], cast<double>(test_background) * (1 - std::pow(0.5, depth - 1)),
                 1e-5);
  }
}

TEST_P(Render, SpdRulesCountRaysThatCannotBeSeen) {
  Scene scene = empty_scene({0, 0, 5}, {0, 0, 0});
  add_wall(scene, {0, 0, 0}, {0, 0, 1}, glass(1.5F)); // Ks is 0
  const Rendering rendering(scene, GetParam());
  FrameRequest request = rendering.request();
  const Frame usual = rendering.frame(request);
  request.rules.spd_rules = true;
  const Frame spd = rendering.frame(request);
  EXPECT_EQ(usual.counts.reflection_rays, 0U);
  EXPECT_EQ(spd.counts.reflection_rays, 9U);
  EXPECT_EQ(usual.counts.refraction_rays, spd.counts.refraction_rays);
  EXPECT_EQ(usual.radiance, spd.radiance);
}

} // namespace
} // namespace masu
