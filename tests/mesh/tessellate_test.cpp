// Tessellation of spheres and cones.
#include "libscene/mesh/tessellate.h"

#include "libscene/geometry/cone.h"
#include "tests/refused.h"
#include "tests/scene_builder.h"

#include <map>
#include <set>
#include <tuple>

namespace masu {
namespace {

constexpr std::array all_facets{4, 8, 12, 20, 64};
const Material gray = matte({0.5F, 0.5F, 0.5F});

Scene nothing() {
  return empty_scene({0, 0, 9}, {0, 0, 0});
}
Scene one_sphere(const Sphere<double>& sphere, int facets) {
  Scene scene = nothing();
  add_sphere(scene, sphere.center, sphere.radius, gray);
  return tessellated(std::move(scene), facets);
}
Scene one_cone(const Cone<double>& cone, int facets) {
  Scene scene = nothing();
  add_cone(scene, cone, gray);
  return tessellated(std::move(scene), facets);
}

Sphere<double> random_sphere(Chance& chance, double sign) {
  const double scale = std::exp(chance.uniform(-20, 20));
  return {chance.direction() * (scale * chance.uniform(0, 30)), sign * scale};
}
// Slender and flat cones, pointed at either end or not, of any size.
Cone<double> random_cone(Chance& chance, double sign) {
  const double scale = std::exp(chance.uniform(-20, 20));
  const Vec3d base = chance.direction() * (scale * chance.uniform(0, 30));
  const Vec3d apex = base + chance.direction() * (scale * std::exp(chance.uniform(-3, 3)));
  const double end = chance.uniform(0, 3);
  const double base_radius = end < 1 ? 0 : sign * scale * chance.uniform(0.01, 2);
  const double apex_radius = end > 2 ? 0 : sign * scale * chance.uniform(0.01, 2);
  return {base, base_radius, apex, apex_radius};
}

// Calls body(sign) for random cases with either sign of the radius.
template <class Body>
void for_random_cases(const Body& body) {
  const RandomSeed seed;
  SCOPED_TRACE(seed.trace());
  Chance chance(seed);
  for (int i = 0; i < 100; ++i)
    body(chance, i % 2 == 0 ? 1.0 : -1.0, all_facets[static_cast<std::size_t>(i) % all_facets.size()]);
}

std::array<Vec3d, 3> corners(const Triangle<double>& t) {
  return {t.a, t.b, t.c};
}
std::array<Vec3d, 3> normals(const Scene& scene, const Triangle<double>& t) {
  const CornerNormals<double>& n = scene.normals[t.normals];
  return {n.a, n.b, n.c};
}

// How often each directed edge is used; corners are compared bit for bit.
using Place = std::tuple<double, double, double>;
std::map<std::pair<Place, Place>, int> edges(const Scene& scene) {
  const auto place = [](const Vec3d& v) { return Place{v.x, v.y, v.z}; };
  std::map<std::pair<Place, Place>, int> walked;
  for (const SceneTriangle& t : scene.triangles) {
    const auto corner = corners(t);
    for (std::size_t i = 0; i < 3; ++i)
      ++walked[{place(corner[i]), place(corner[(i + 1) % 3])}];
  }
  return walked;
}
// Edges that aren't used exactly once in each direction.
std::size_t open_edges(const Scene& scene) {
  const auto walked = edges(scene);
  return static_cast<std::size_t>(std::count_if(walked.begin(), walked.end(), [&](const auto& edge) {
    const auto back = walked.find({edge.first.second, edge.first.first});
    return edge.second != 1 || back == walked.end() || back->second != 1;
  }));
}

double distance_from_axis(const Cone<double>& cone, const Vec3d& p) {
  return length(cross(p - cone.base, normalized(cone.apex - cone.base)));
}

// --- Counts

TEST(Tessellation, HasTheDocumentedNumberOfTriangles) {
  for (const int n : all_facets) {
    const auto sides = static_cast<std::size_t>(n);
    EXPECT_EQ(one_sphere({{1, 2, 3}, 4}, n).triangles.size(), 12 * (sides / 4) * (sides / 4));
    EXPECT_EQ(one_cone({{0, 0, 0}, 2, {0, 0, 1}, 1}, n).triangles.size(), 2 * sides);
    EXPECT_EQ(one_cone({{0, 0, 0}, 1, {0, 0, 1}, 1}, n).triangles.size(), 2 * sides);
    EXPECT_EQ(one_cone({{0, 0, 0}, 2, {0, 0, 1}, 0}, n).triangles.size(), sides) << "pointed";
    EXPECT_EQ(one_cone({{0, 0, 0}, 0, {0, 0, 1}, 2}, n).triangles.size(), sides) << "pointed at its base";
  }
}

TEST(Tessellation, TooManyTrianglesAreRefused) {
  Scene scene = nothing();
  // 12 (1024/4)² triangles each: 5462 of them are over 2^32.
  for (int i = 0; i < 5462; ++i)
    scene.spheres.push_back({{0, 0, 0}, 1});
  scene.sphere_surfaces.assign(5462, {});
  EXPECT_TRUE(
      is_refused_with(ErrorCode::usage, "--tessellate", [&] { tessellated(std::move(scene), 1024); }));
}

// --- Shape

TEST(Tessellation, CornersLieOnTheSphere) {
  for_random_cases([](Chance& chance, double sign, int facets) {
    const Sphere<double> sphere = random_sphere(chance, sign);
    const double size = largest_magnitude(sphere.center) + std::abs(sphere.radius);
    for (const SceneTriangle& t : one_sphere(sphere, facets).triangles)
      for (const Vec3d& p : corners(t))
        ASSERT_NEAR(length(p - sphere.center), std::abs(sphere.radius), 1e-15 * size);
  });
}

TEST(Tessellation, CornersLieOnTheConesEnds) {
  for_random_cases([](Chance& chance, double sign, int facets) {
    const Cone<double> cone = random_cone(chance, sign);
    const double reach = length(cone.apex - cone.base);
    const double size = largest_magnitude(bounds(cone));
    for (const SceneTriangle& t : one_cone(cone, facets).triangles)
      for (const Vec3d& p : corners(t)) {
        const double along = dot(p - cone.base, normalized(cone.apex - cone.base));
        const bool at_base = along < reach / 2;
        ASSERT_NEAR(along, at_base ? 0 : reach, 2e-15 * size);
        ASSERT_NEAR(distance_from_axis(cone, p), std::abs(at_base ? cone.base_radius : cone.apex_radius),
                    4e-15 * size);
      }
  });
}

TEST(Tessellation, SpheresAreClosed) {
  for_random_cases([](Chance& chance, double sign, int facets) {
    const Scene scene = one_sphere(random_sphere(chance, sign), facets);
    ASSERT_EQ(open_edges(scene), 0U);
    // Euler: corners + triangles = edges + 2.
    std::set<Place> places;
    for (const auto& [edge, times] : edges(scene))
      places.insert(edge.first);
    ASSERT_EQ(places.size(), scene.triangles.size() / 2 + 2);
  });
}

TEST(Tessellation, ConesAreOpenAtTheirWideEndsOnly) {
  for_random_cases([](Chance& chance, double sign, int facets) {
    const Cone<double> cone = random_cone(chance, sign);
    const std::size_t ends = (cone.base_radius != 0 ? 1U : 0U) + (cone.apex_radius != 0 ? 1U : 0U);
    ASSERT_EQ(open_edges(one_cone(cone, facets)), ends * static_cast<std::size_t>(facets));
  });
}

// --- Facing

TEST(Tessellation, FrontsFaceOutwardsOrInwardsForNegativeRadii) {
  for_random_cases([](Chance& chance, double sign, int facets) {
    const Sphere<double> sphere = random_sphere(chance, sign);
    for (const SceneTriangle& t : one_sphere(sphere, facets).triangles)
      ASSERT_GT(dot(cross(t.b - t.a, t.c - t.a), t.a - sphere.center) * sign, 0);
    const Cone<double> cone = random_cone(chance, sign);
    const Vec3d along = normalized(cone.apex - cone.base);
    for (const SceneTriangle& t : one_cone(cone, facets).triangles) {
      const Vec3d middle = (t.a + t.b + t.c) * (1.0 / 3) - cone.base;
      ASSERT_GT(dot(cross(t.b - t.a, t.c - t.a), middle - along * dot(middle, along)) * sign, 0);
    }
  });
}

TEST(Tessellation, CornerNormalsAreTheSurfaces) {
  for_random_cases([](Chance& chance, double sign, int facets) {
    const Sphere<double> sphere = random_sphere(chance, sign);
    Scene scene = one_sphere(sphere, facets);
    for (const SceneTriangle& t : scene.triangles)
      for (std::size_t i = 0; i < 3; ++i) {
        const Vec3d outwards = normalized(corners(t)[i] - sphere.center);
        ASSERT_LT(length(normals(scene, t)[i] - outwards * sign), 1e-13);
      }
    const Cone<double> cone = random_cone(chance, sign);
    const Vec3d axis = cone.apex - cone.base;
    scene = one_cone(cone, facets);
    for (const SceneTriangle& t : scene.triangles)
      for (std::size_t i = 0; i < 3; ++i) {
        const Vec3d n = normals(scene, t)[i], p = corners(t)[i] - cone.base;
        const Vec3d off_axis = p - axis * (dot(p, axis) / dot(axis, axis));
        if (length(off_axis) < 1e-9 * length(axis)) continue; // a pointed end has no normal
        const double growth = std::abs(cone.apex_radius) - std::abs(cone.base_radius);
        const Vec3d outwards = normalized(normalized(off_axis) * dot(axis, axis) - axis * growth);
        ASSERT_LT(length(n - outwards * sign), 1e-12);
      }
  });
}

TEST(Tessellation, NormalsOfATipAreOnItsSidesFront) {
  for (const double sign : {1.0, -1.0}) {
    const Scene scene = one_cone({{0, 0, 0}, sign, {0, 0, 3}, 0}, 12);
    for (const SceneTriangle& t : scene.triangles) {
      const Vec3d front = normalized(cross(t.b - t.a, t.c - t.a));
      for (const Vec3d& n : normals(scene, t))
        EXPECT_GT(dot(normalized(n), front), 0.9);
    }
  }
}

TEST(Tessellation, SpheresShareTheirNormals) {
  Scene scene = nothing();
  for (int i = 0; i < 10; ++i)
    add_sphere(scene, {3.0 * i, 0, 0}, i % 2 == 0 ? 1 : -1, gray);
  scene = tessellated(std::move(scene), 12);
  EXPECT_EQ(scene.triangles.size(), 1080U);
  EXPECT_EQ(scene.normals.size(), 108U);
}

TEST(Tessellation, ConesOfExtremeShapeHaveFiniteNormals) {
  for (const double far : {1e-300, 1e-150, 1.0, 1e99})
    for (const double radius : {1e-300, 1.0, 1e99}) {
      const Scene scene = one_cone({{0, 0, 0}, radius, {far, far, -far}, 0}, 12);
      for (const SceneTriangle& t : scene.triangles)
        for (const Vec3d& n : normals(scene, t)) {
          EXPECT_GT(length(n), 0.5);
          EXPECT_LT(length(n), 2.5);
        }
    }
}

// --- Objects and materials

TEST(Tessellation, ObjectsAndMaterialsAreKept) {
  Scene scene = nothing();
  add_cone(scene, {{0, 0, 0}, 2, {0, 0, 1}, 1}, mirror());
  add_sphere(scene, {0, 0, 0}, 1, gray);
  add_wall(scene, {1, 2, 3}, {0, 0, 1}, glass(1.5F));
  const Triangle<double> wall = scene.triangles[0];
  add_sphere(scene, {5, 0, 0}, 1, gray);
  const Scene made = tessellated(scene, 8);
  EXPECT_EQ(object_count(made), 4U);
  EXPECT_EQ(made.objects.spheres, 2U);
  EXPECT_EQ(made.objects.cones, 1U);
  EXPECT_EQ(made.materials.size(), scene.materials.size());
  EXPECT_TRUE(made.spheres.empty() && made.sphere_surfaces.empty());
  EXPECT_TRUE(made.cones.empty() && made.cone_surfaces.empty());
  // Triangles first, then spheres, then cones; each object has its own material here.
  std::vector<std::uint64_t> expected{2};
  expected.insert(expected.end(), 48, 1);
  expected.insert(expected.end(), 48, 3);
  expected.insert(expected.end(), 16, 0);
  ASSERT_EQ(made.triangles.size(), expected.size());
  EXPECT_EQ(corners(made.triangles[0]), corners(wall));
  EXPECT_EQ(made.triangles[0].normals, no_normals);
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(made.triangles[i].object, expected[i]) << i;
    EXPECT_EQ(made.triangles[i].material, expected[i]) << i;
  }
}

} // namespace
} // namespace masu
