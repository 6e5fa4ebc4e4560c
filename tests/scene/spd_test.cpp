// The SPD scenes have their defining properties at every size.
#include "libscene/spd/spd.h"

#include "libscene/geometry/primitives.h"
#include "tests/refused.h"
#include "tests/spd_text.h"

#include <sys/resource.h>

#include <algorithm>
#include <climits>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <sstream>
#include <tuple>
#include <vector>

namespace {

using masu::ErrorCode;
using masu::is_refused_with;
using masu::SpdInfo;
using masu::SpdScene;
using masu::Vec3d;

// Six significant digits of coordinates up to 10.
constexpr double digit = 1e-5;

using Sphere = masu::Sphere<double>;
using Cone = masu::Cone<double>;
using Polygon = std::vector<Vec3d>;

struct Parsed {
  std::vector<Sphere> spheres;
  std::vector<Cone> cones;
  std::vector<Polygon> polygons;  // `p`
  std::vector<Polygon> triangles; // `pp`
  std::vector<Polygon> normals;   // of the triangles' corners

  std::size_t objects() const { return spheres.size() + cones.size() + polygons.size() + triangles.size(); }
};

std::istream& operator>>(std::istream& in, Vec3d& v) {
  return in >> v.x >> v.y >> v.z;
}

Parsed parse(const std::string& text) {
  Parsed parsed;
  std::istringstream in(text);
  std::string keyword, line;
  while (in >> keyword) {
    if (keyword == "s") {
      Sphere s{};
      in >> s.center >> s.radius;
      parsed.spheres.push_back(s);
    } else if (keyword == "c") {
      Cone c{};
      in >> c.base >> c.base_radius >> c.apex >> c.apex_radius;
      parsed.cones.push_back(c);
    } else if (keyword == "p" || keyword == "pp") {
      std::size_t corners = 0;
      in >> corners;
      Polygon polygon(corners), normals(corners);
      for (std::size_t i = 0; i < corners; ++i) {
        in >> polygon[i];
        if (keyword == "pp") in >> normals[i];
      }
      if (keyword == "pp") parsed.normals.push_back(normals);
      (keyword == "pp" ? parsed.triangles : parsed.polygons).push_back(polygon);
    } else {
      std::getline(in, line); // the view, a light, a material
    }
  }
  return parsed;
}

Parsed scene_of(SpdScene scene, int size, bool background = true) {
  return parse(masu::spd_text({scene, size, background}));
}

double distance(const Vec3d& a, const Vec3d& b) {
  return length(a - b);
}

// Twice the area, along the normal (Newell's method).
Vec3d doubled_area(const Polygon& polygon) {
  Vec3d sum{0, 0, 0};
  for (std::size_t i = 0; i < polygon.size(); ++i)
    sum = sum + cross(polygon[i] - polygon[0], polygon[(i + 1) % polygon.size()] - polygon[0]);
  return sum;
}

double area(const Polygon& polygon) {
  return length(doubled_area(polygon)) / 2;
}

using Key = std::tuple<double, double, double>;

Key key(const Vec3d& v) {
  return {v.x, v.y, v.z};
}

std::size_t open_edges(const std::vector<Polygon>& polygons) {
  // For every edge between two corners: uses forwards minus uses backwards.
  std::map<std::pair<Key, Key>, int> balance;
  for (const Polygon& polygon : polygons)
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Key a = key(polygon[i]), b = key(polygon[(i + 1) % polygon.size()]);
      a < b ? ++balance[{a, b}] : --balance[{b, a}];
    }
  return static_cast<std::size_t>(
      std::ranges::count_if(balance, [](const auto& edge) { return edge.second != 0; }));
}

// Six times the volume inside a closed surface; positive when it is counter-clockwise seen from outside.
double sixfold_volume(const std::vector<Polygon>& polygons) {
  double sum = 0;
  for (const Polygon& p : polygons)
    sum += dot(p[0], doubled_area(p));
  return sum;
}

std::size_t power(std::size_t base, int exponent) {
  return exponent == 0 ? 1 : base * power(base, exponent - 1);
}

std::size_t objects_by_formula(SpdScene scene, int size) {
  const auto n = static_cast<std::size_t>(size);
  switch (scene) {
  case SpdScene::balls:
    return (power(9, size + 1) - 1) / 8 + 1;
  case SpdScene::gears:
    return 146 * n * n * n + 1;
  case SpdScene::mount:
    return 2 * power(4, size) + 4;
  case SpdScene::nurbs:
    return 60 * n * n;
  case SpdScene::rings:
    return 10 * n * (n + 1) * (2 * n + 1) + 1;
  case SpdScene::teapot:
    return 65 * n * n - 8 * n;
  case SpdScene::tetra:
    return power(4, size);
  case SpdScene::tree:
    return 2 * (power(2, size + 1) - 1) + 1;
  }
  return 0;
}

TEST(Spd, ObjectsFollowTheClosedForms) {
  for (const SpdInfo& info : masu::spd_scenes())
    for (int size = 1; size <= 4; ++size) {
      EXPECT_EQ(scene_of(info.scene, size).objects(), objects_by_formula(info.scene, size))
          << info.name << ' ' << size;
      EXPECT_EQ(masu::spd_objects(info.scene, size), objects_by_formula(info.scene, size))
          << info.name << ' ' << size;
    }
}

TEST(Spd, StandardSizesHaveThePublishedCounts) {
  const std::map<std::string_view, std::size_t> published = {
      {"balls", 7382}, {"gears", 9345},  {"mount", 8196}, {"nurbs", 1500},
      {"rings", 8401}, {"teapot", 9264}, {"tetra", 4096}, {"tree", 8191}};
  for (const SpdInfo& info : masu::spd_scenes())
    EXPECT_EQ(scene_of(info.scene, info.standard).objects(), published.at(info.name)) << info.name;
}

TEST(Spd, CountsAtTheLargestSizesFitInt32) {
  for (const SpdInfo& info : masu::spd_scenes())
    EXPECT_LE(objects_by_formula(info.scene, info.max_size), std::size_t{INT32_MAX}) << info.name;
}

TEST(Spd, BackgroundIsLeftOutOnRequest) {
  std::map<std::string_view, std::size_t> backgrounds{
      {"balls", 1}, {"gears", 1}, {"mount", 4}, {"rings", 1}, {"tree", 1}};
  for (const SpdInfo& info : masu::spd_scenes())
    EXPECT_EQ(scene_of(info.scene, 3, false).objects() + backgrounds[info.name],
              scene_of(info.scene, 3).objects())
        << info.name;
}

TEST(Spd, NamesAndScenesCorrespond) {
  for (const SpdInfo& info : masu::spd_scenes()) {
    EXPECT_EQ(masu::spd_info(info.name).scene, info.scene);
    EXPECT_EQ(masu::spd_scenes()[static_cast<std::size_t>(info.scene)].name, info.name);
  }
}

TEST(Spd, NumbersAreFiniteAndRounded) {
  for (const SpdInfo& info : masu::spd_scenes()) {
    std::istringstream words(masu::spd_text({info.scene, 4}));
    std::string word;
    while (words >> word) {
      ASSERT_NE(word, "-0") << info.name;
      for (const char* const wrong : {"nan", "inf", "e-1"})
        ASSERT_EQ(word.find(wrong), std::string::npos) << info.name << ": " << word;
    }
  }
}

TEST(Spd, BallsTouchTheirParents) {
  const std::vector<Sphere> spheres = scene_of(SpdScene::balls, 4).spheres;
  std::vector<Sphere> ancestors; // the spheres come depth first
  for (const Sphere& s : spheres) {
    while (!ancestors.empty() && ancestors.back().radius < 2 * s.radius)
      ancestors.pop_back();
    if (!ancestors.empty()) {
      const Sphere& parent = ancestors.back();
      EXPECT_NEAR(s.radius, parent.radius / 3, 1e-6);
      EXPECT_NEAR(distance(s.center, parent.center), s.radius + parent.radius, 3e-6);
    }
    ancestors.push_back(s);
  }
}

TEST(Spd, BallsOfOneParentDontOverlap) {
  const std::vector<Sphere> spheres = scene_of(SpdScene::balls, 1).spheres;
  for (std::size_t i = 1; i < spheres.size(); ++i)
    for (std::size_t j = i + 1; j < spheres.size(); ++j)
      EXPECT_GE(distance(spheres[i].center, spheres[j].center), 2 * spheres[i].radius - digit);
}

TEST(Spd, TetraFillsItsCubeWithConstantArea) {
  for (int size = 1; size <= 6; ++size) {
    double sum = 0, largest = 0;
    for (const Polygon& triangle : scene_of(SpdScene::tetra, size).polygons) {
      sum += area(triangle);
      for (const Vec3d& v : triangle)
        largest = std::max(largest, masu::largest_magnitude(v));
    }
    EXPECT_NEAR(sum, 8 * std::sqrt(3.0), digit) << size;
    EXPECT_EQ(largest, 1) << size;
  }
}

TEST(Spd, TetraIsClosedAndFacesOutwards) {
  const std::vector<Polygon> triangles = scene_of(SpdScene::tetra, 4).polygons;
  EXPECT_EQ(open_edges(triangles), 0U);
  // Every level halves the volume.
  EXPECT_NEAR(sixfold_volume(triangles) / 6, 8.0 / 3 / 8, digit);
}

TEST(Spd, RingsAreClosedTubes) {
  const Parsed rings = scene_of(SpdScene::rings, 2);
  ASSERT_EQ(rings.cones.size(), rings.spheres.size());
  for (std::size_t i = 0; i < rings.cones.size(); ++i) {
    const Cone& tube = rings.cones[i];
    const std::size_t previous = i % 5 == 0 ? i + 4 : i - 1;
    EXPECT_EQ(key(tube.base), key(rings.spheres[i].center));
    EXPECT_EQ(key(tube.apex), key(rings.spheres[previous].center));
    EXPECT_EQ(tube.base_radius, tube.apex_radius);
    EXPECT_EQ(tube.base_radius, rings.spheres[i].radius);
    EXPECT_NEAR(distance(tube.base, tube.apex), 2 * std::sin(std::numbers::pi / 5) / 1.07412, 2 * digit);
  }
}

TEST(Spd, RingsOfOneObjectDontMeet) {
  const std::vector<Cone> tubes = scene_of(SpdScene::rings, 1).cones;
  constexpr int steps = 40;
  const auto along = [](const Cone& tube, int i) {
    return tube.base + (tube.apex - tube.base) * (1.0 * i / steps);
  };
  for (std::size_t a = 0; a < tubes.size(); ++a)
    for (std::size_t b = 5 * (a / 5 + 1); b < tubes.size(); ++b)
      for (int i = 0; i <= steps; ++i)
        for (int j = 0; j <= steps; ++j)
          ASSERT_GT(distance(along(tubes[a], i), along(tubes[b], j)),
                    0.13); // of the axes; the tubes nearly touch
}

TEST(Spd, BranchesOfTheTreeGrowFromKnots) {
  const Parsed tree = scene_of(SpdScene::tree, 8);
  std::map<Key, double> knots = {{{0, 0, 0}, 0.15}};
  for (std::size_t i = 0; i < tree.cones.size(); ++i) {
    const Cone& branch = tree.cones[i];
    EXPECT_EQ(key(branch.apex), key(tree.spheres[i].center));
    EXPECT_EQ(branch.apex_radius, tree.spheres[i].radius);
    EXPECT_NEAR(branch.apex_radius, branch.base_radius * 0.67, 1e-6);
    ASSERT_TRUE(knots.contains(key(branch.base)));
    EXPECT_EQ(knots.at(key(branch.base)), branch.base_radius);
    knots[key(branch.apex)] = branch.apex_radius;
  }
}

TEST(Spd, GearsAreClosedAndFaceOutwards) {
  const std::vector<Polygon> polygons = scene_of(SpdScene::gears, 3, false).polygons;
  constexpr std::ptrdiff_t each = 146;
  ASSERT_EQ(polygons.size() % each, 0U);
  for (auto first = polygons.begin(); first != polygons.end(); first += each) {
    const std::vector<Polygon> gear(first, first + each);
    EXPECT_EQ(open_edges(gear), 0U);
    EXPECT_GT(sixfold_volume(gear), 0);
    EXPECT_EQ(gear.front().size(), 144U);
    EXPECT_EQ(gear.back().size(), 144U);
    EXPECT_GT(doubled_area(gear.front()).z, 0);
    EXPECT_LT(doubled_area(gear.back()).z, 0);
  }
}

TEST(Spd, GearsLieInTheirBlock) {
  for (int size = 1; size <= 4; ++size)
    for (const Polygon& polygon : scene_of(SpdScene::gears, size, false).polygons)
      for (const Vec3d& v : polygon) {
        ASSERT_LE(std::max(std::abs(v.x), std::abs(v.y)), 1);
        ASSERT_GT(v.z, 0);
        ASSERT_LE(v.z, 1);
      }
}

// The height at every lattice point; EXPECTs that cells agree on it.
std::map<std::pair<double, double>, double> heights_of_mount(int size) {
  std::map<std::pair<double, double>, double> heights;
  for (const Polygon& triangle : scene_of(SpdScene::mount, size).polygons)
    for (const Vec3d& v : triangle)
      EXPECT_EQ(heights.emplace(std::pair(v.x, v.y), v.z).first->second, v.z);
  return heights;
}

TEST(Spd, MountIsOneSheetSeenFromAbove) {
  const std::vector<Polygon> triangles = scene_of(SpdScene::mount, 5).polygons;
  double ground = 0;
  for (const Polygon& triangle : triangles) {
    EXPECT_GT(doubled_area(triangle).z, 0);
    ground += doubled_area(triangle).z / 2;
  }
  EXPECT_NEAR(ground, 4, digit);
  EXPECT_EQ(open_edges(triangles), 4U * 32);
}

TEST(Spd, MountsOuterCornersLieAtHeightZero) {
  for (const int size : {1, 6, 8}) {
    const auto heights = heights_of_mount(size);
    for (const double x : {-1, 1})
      for (const double y : {-1, 1})
        EXPECT_EQ(heights.at({x, y}), 0) << size;
  }
}

TEST(Spd, LargerMountsRefineSmallerOnes) {
  // Size 8 is the first beyond the definition's random numbers.
  const auto coarse = heights_of_mount(5), fine = heights_of_mount(8);
  EXPECT_EQ(fine.size(), 257U * 257U);
  for (const auto& [place, height] : coarse)
    EXPECT_EQ(fine.at(place), height);
}

TEST(Spd, MountHasThePublishedShape) {
  const auto heights = heights_of_mount(6);
  EXPECT_EQ(heights.at({-0.96875, -1}), -0.0160409);
  EXPECT_EQ(heights.at({-0.9375, -0.9375}), 0.0669606);
  EXPECT_EQ(heights.at({-0.96875, 1}), 0.0324693);
}

TEST(Spd, MountsSpheresTouch) {
  const std::vector<Sphere> spheres = scene_of(SpdScene::mount, 1).spheres;
  ASSERT_EQ(spheres.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j)
      EXPECT_NEAR(distance(spheres[i].center, spheres[j].center), 0.34, digit);
}

TEST(Spd, TeapotHasItsPatchesAndSquares) {
  for (const std::size_t n : {1U, 2U, 5U, 12U}) {
    const Parsed teapot = scene_of(SpdScene::teapot, static_cast<int>(n));
    EXPECT_EQ(teapot.triangles.size(), 64 * n * n - 8 * n);
    EXPECT_EQ(teapot.polygons.size(), n * n);
    double board = 0;
    for (const Polygon& square : teapot.polygons)
      board += doubled_area(square).z / 2;
    EXPECT_NEAR(board, 64, 64 * digit);
  }
}

TEST(Spd, TeapotsPatchesShareTheirEdges) {
  // Open edges: the rim's inner and the lid's outer edge, both ends of the handle and of the spout.
  for (const std::size_t n : {2U, 7U, 12U})
    EXPECT_EQ(open_edges(scene_of(SpdScene::teapot, static_cast<int>(n)).triangles), 16 * n) << n;
}

TEST(Spd, TeapotIsSymmetric) {
  std::set<Key> corners;
  for (const Polygon& triangle : scene_of(SpdScene::teapot, 6).triangles)
    for (const Vec3d& v : triangle)
      corners.insert(key(v));
  const auto has_near = [&](const Vec3d& v) { // heights half-way between two digits may be rounded either way
    return std::ranges::any_of(corners, [&](const Key& k) {
      const auto [x, y, z] = k;
      return distance(v, {x, y, z}) < 2 * digit;
    });
  };
  for (const auto& [x, y, z] : corners)
    EXPECT_TRUE(has_near({x, y == 0 ? 0 : -y, z}));
}

void expect_unit_normals_beside_triangles(const Parsed& scene, double side) {
  for (std::size_t i = 0; i < scene.triangles.size(); ++i) {
    const Vec3d facing = doubled_area(scene.triangles[i]) * side;
    EXPECT_GT(length(facing), 0);
    for (const Vec3d& normal : scene.normals[i]) {
      EXPECT_NEAR(length(normal), 1, digit);
      EXPECT_GT(dot(normal, facing), 0);
    }
  }
}

TEST(Spd, TeapotsNormalsAgreeWithItsTriangles) {
  expect_unit_normals_beside_triangles(scene_of(SpdScene::teapot, 12), 1);
}

TEST(Spd, NurbsNormalsAreOppositeToItsTriangles) {
  expect_unit_normals_beside_triangles(scene_of(SpdScene::nurbs, 5), -1);
}

TEST(Spd, NurbsStartsAndEndsInItsCornerControlPoints) {
  const Parsed surface = scene_of(SpdScene::nurbs, 2);
  const double c = std::cos(std::numbers::pi / 6), s = 0.5;
  const auto turned = [&](double x, double z) { return Vec3d{x * c + z * s, 0, z * c - x * s}; };
  EXPECT_NEAR(distance(surface.triangles.front()[0], turned(-2, 2.5)), 0, digit);
  EXPECT_NEAR(distance(surface.triangles.back()[1], turned(2, -2.5)), 0, digit);
  EXPECT_EQ(open_edges(surface.triangles), 2U * (10 + 12));
}

TEST(Spd, UnknownScenesAndSizesOutOfRangeAreUsageErrors) {
  for (const char* const name : {"bolls", ""})
    EXPECT_TRUE(is_refused_with(ErrorCode::usage, name, [&] { masu::spd_info(name); }));
  for (const SpdInfo& info : masu::spd_scenes()) {
    EXPECT_NO_THROW(masu::check_spd_size(info.scene, info.min_size));
    EXPECT_NO_THROW(masu::check_spd_size(info.scene, info.max_size));
    for (const int size : {INT_MIN, info.min_size - 1, info.max_size + 1, INT_MAX})
      EXPECT_TRUE(is_refused_with(ErrorCode::usage, "size " + std::to_string(size), [&] {
        masu::write_spd({info.scene, size}, nullptr, "");
      })) << info.name;
  }
}

TEST(Spd, FullDiskIsAnOutputError) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> full(std::fopen("/dev/full", "wb"), std::fclose);
  if (!full) GTEST_SKIP() << "no /dev/full here";
  for (const int size : {1, 6}) // fails in the last flush, and before
    EXPECT_TRUE(is_refused_with(ErrorCode::output, "disk.nff", [&] {
      masu::write_spd({SpdScene::tetra, size}, full.get(), "disk.nff");
    }));
}

// Peak memory of this process, in KiB.
long peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss;
}

TEST(Spd, MemoryIsIndependentOfSize) {
#ifdef __SANITIZE_THREAD__
  GTEST_SKIP() << "ThreadSanitizer's own memory grows with what is looked at";
#endif
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> nowhere(std::fopen("/dev/null", "wb"), std::fclose);
  const auto write = [&](int size) { masu::write_spd({SpdScene::balls, size}, nowhere.get(), "nowhere"); };
  write(1);
  const long before = peak_memory();
  write(6); // 600 000 spheres, 25 MB of text
  EXPECT_LT(peak_memory() - before, 4096);
}

} // namespace
