#include "libscene/geometry/orientation.h"
#include "libscene/mesh/sweep_triangulation.h"
#include "libscene/mesh/triangulate.h"
#include "tests/random_test.h"

#include <chrono>
#include <map>
#include <numbers>
#include <numeric>
#include <ranges>
#include <set>

namespace masu {
namespace {

using Orientation = RandomTest;
using SweepTriangulation = RandomTest;
using Triangulate = RandomTest;

using Flat = std::vector<Point2>; // a polygon in a plane

constexpr double pi = std::numbers::pi;

Triangulation triangulate(std::span<const Vec3d> polygon) {
  Triangulation result;
  masu::triangulate(polygon, result);
  return result;
}

// The plane spanned by two orthogonal unit vectors, moved and scaled: a random placement in space.
struct Placement {
  Vec3d along, across, origin;
  double scale;

  Vec3d of(const Point2& p) const { return origin + along * (p.x * scale) + across * (p.y * scale); }
  Vec3d normal() const { return cross(along, across); }
};

Placement random_placement(Chance& chance) {
  const Vec3d along = chance.direction();
  return {along, across(chance, along), chance.direction() * chance.uniform(0, 5),
          chance.power_of_two(-20, 20)};
}

std::vector<Vec3d> place(const Flat& flat, const Placement& placement) {
  std::vector<Vec3d> polygon;
  polygon.reserve(flat.size());
  for (const Point2& p : flat)
    polygon.push_back(placement.of(p));
  return polygon;
}
std::vector<Vec3d> in_plane(const Flat& flat) {
  return place(flat, {{1, 0, 0}, {0, 1, 0}, {0, 0, 0}, 1});
}

// --- Polygons

Point2 polar(double radius, double angle) {
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

Flat regular(int corners) {
  Flat flat;
  for (int i = 0; i < corners; ++i)
    flat.push_back(polar(1, 2 * pi * i / corners));
  return flat;
}

Flat star(Chance& chance, int corners) {
  Flat flat;
  for (int i = 0; i < corners; ++i)
    flat.push_back(polar(chance.uniform(0.1, 1), 2 * pi * i / corners));
  return flat;
}

// The SPD's gear: four vertices a tooth.
Flat gear(int teeth) {
  Flat flat;
  const double tooth = 2 * pi / teeth;
  for (int i = 0; i < teeth; ++i)
    for (const auto& [radius, at] : {std::pair{1.0, -0.19}, {1.0, 0.19}, {0.9, 0.3}, {0.9, 0.7}})
      flat.push_back(polar(radius, tooth * (i + at)));
  return flat;
}

Flat comb(int teeth) {
  Flat flat{{0, 0}, {static_cast<double>(teeth), 0}};
  for (int i = teeth; i > 0; --i) {
    flat.push_back({i - 0.25, 10});
    flat.push_back({i - 0.5, 1});
  }
  return flat;
}

Flat spiral(int steps) {
  Flat flat;
  for (int i = 0; i <= steps; ++i)
    flat.push_back(polar(2 + 0.1 * i, 0.3 * i));
  for (int i = steps; i >= 0; --i)
    flat.push_back(polar(1.5 + 0.1 * i, 0.3 * i));
  return flat;
}

// The outline of a connected set of grid cells, with every grid point on it as a vertex: many are collinear,
// and all coordinates are integers. The outline may touch itself at points, but doesn't cross itself.
Flat blob_outline(Chance& chance, int cells) {
  std::set<std::pair<int, int>> blob{{0, 0}};
  const std::array<std::pair<int, int>, 4> sides{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
  const auto neighbours = [&](std::pair<int, int> cell) {
    return std::count_if(sides.begin(), sides.end(), [&](const auto& side) {
      return blob.count({cell.first + side.first, cell.second + side.second}) > 0;
    });
  };
  const auto touches_by_corner_only = [&](std::pair<int, int> cell) {
    for (const int dx : {-1, 1})
      for (const int dy : {-1, 1})
        if (blob.count({cell.first + dx, cell.second + dy}) && !blob.count({cell.first + dx, cell.second}) &&
            !blob.count({cell.first, cell.second + dy}))
          return true;
    return false;
  };
  // Trees of cells enclose no hole.
  for (int tries = 0; static_cast<int>(blob.size()) < cells && tries < 100 * cells; ++tries) {
    auto from = blob.begin();
    std::advance(from, chance.whole(0, static_cast<int>(blob.size()) - 1));
    const auto& side = sides[static_cast<std::size_t>(chance.whole(0, 3))];
    const std::pair<int, int> cell{from->first + side.first, from->second + side.second};
    if (!blob.count(cell) && neighbours(cell) == 1 && !touches_by_corner_only(cell)) blob.insert(cell);
  }
  // Follow the outline with the set on the left, from the lowest cell's lower edge.
  const auto lowest = *std::min_element(blob.begin(), blob.end(), [](const auto& a, const auto& b) {
    return std::pair(a.second, a.first) < std::pair(b.second, b.first);
  });
  Flat flat;
  int x = lowest.first;
  int y = lowest.second;
  std::size_t heading = 0;
  do {
    flat.push_back({static_cast<double>(x), static_cast<double>(y)});
    x += sides[heading].first;
    y += sides[heading].second;
    const auto cell_ahead = [&](bool left) { // of the point reached
      const std::array<std::pair<int, int>, 4> left_cells{{{0, 0}, {-1, 0}, {-1, -1}, {0, -1}}};
      const auto& offset = left_cells[(heading + (left ? 0 : 3)) % 4];
      return blob.count({x + offset.first, y + offset.second}) > 0;
    };
    if (cell_ahead(false))
      heading = (heading + 3) % 4;
    else if (!cell_ahead(true))
      heading = (heading + 1) % 4;
  } while (x != lowest.first || y != lowest.second);
  return flat;
}

Flat with_points_on_edges(Chance& chance, const Flat& flat, int most) {
  Flat result;
  for (std::size_t i = 0; i < flat.size(); ++i) {
    const Point2 &a = flat[i], &b = flat[(i + 1) % flat.size()];
    const int parts = chance.whole(1, most + 1);
    for (int k = 0; k < parts; ++k)
      result.push_back({a.x + (b.x - a.x) * k / parts, a.y + (b.y - a.y) * k / parts});
  }
  return result;
}

// A square with square holes in a row, each cut in by a bridge.
Flat square_with_holes(int holes) {
  Flat flat{{0, 0}, {4.0 * holes, 0}, {4.0 * holes, 4}};
  for (int i = holes - 1; i >= 0; --i) {
    const double x = 4 * i + 1;
    const Point2 bridge{x + 1, 4};
    for (const Point2& p :
         {bridge, Point2{x + 1, 3}, {x + 2, 3}, {x + 2, 1}, {x, 1}, {x, 3}, {x + 1, 3}, bridge})
      flat.push_back(p);
  }
  flat.push_back({0, 4});
  return flat;
}

Flat turned(const Flat& flat, double angle) {
  Flat result;
  for (const Point2& p : flat)
    result.push_back(
        {std::cos(angle) * p.x - std::sin(angle) * p.y, std::sin(angle) * p.x + std::cos(angle) * p.y});
  return result;
}

// --- Properties

// Each edge of the polygon bounds one triangle, each other edge two in opposite directions: with triangles
// oriented as the polygon, a simple polygon is then covered exactly once.
void expect_edges_match(std::size_t size, const Triangulation& result) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (std::uint32_t i = 0; i < size; ++i)
    --edges[{i, (i + 1) % size}];
  for (const auto& t : result.triangles)
    for (std::size_t k = 0; k < 3; ++k)
      ++edges[{t[k], t[(k + 1) % 3]}];
  for (const auto& [edge, count] : edges) {
    if (count == 0) continue;
    const auto opposite = edges.find({edge.second, edge.first});
    ASSERT_TRUE(count == 1 && opposite != edges.end() && opposite->second == 1)
        << "edge " << edge.first << "-" << edge.second << " stands alone";
  }
}

// `flat` must be counter-clockwise and without repeated vertices.
void expect_covers(const Flat& flat, const Triangulation& result) {
  EXPECT_EQ(result.triangles.size(), flat.size() - 2);
  EXPECT_EQ(result.slivers, 0U);
  EXPECT_FALSE(result.crosses_itself);
  expect_edges_match(flat.size(), result);
  std::vector<bool> is_used(flat.size(), false);
  // Twice the area between an edge and the origin, and what it is the difference of: a thin polygon's area is
  // far smaller than that.
  long double products = 0;
  const auto beside = [&](const Point2& a, const Point2& b) {
    const auto up = static_cast<long double>(a.x) * static_cast<long double>(b.y),
               down = static_cast<long double>(b.x) * static_cast<long double>(a.y);
    products += std::abs(up) + std::abs(down);
    return up - down;
  };
  long double area = 0;
  for (const auto& t : result.triangles) {
    for (const std::uint32_t v : t) {
      ASSERT_LT(v, flat.size());
      is_used[v] = true;
    }
    EXPECT_GT(orientation(flat[t[0]], flat[t[1]], flat[t[2]]), 0);
    for (std::size_t i = 0; i < 3; ++i)
      area += beside(flat[t[i]], flat[t[(i + 1) % 3]]);
  }
  long double expected = 0;
  for (std::size_t i = 0; i < flat.size(); ++i)
    expected += beside(flat[i], flat[(i + 1) % flat.size()]);
  constexpr long double rounding = std::numeric_limits<long double>::epsilon();
  EXPECT_LE(std::abs(area - expected), 4 * rounding * products);
  EXPECT_EQ(std::count(is_used.begin(), is_used.end(), false), 0);
}

// In the plane, mirrored, and anywhere in space.
void expect_covers_anywhere(const Flat& flat, Chance& chance) {
  expect_covers(flat, triangulate(in_plane(flat)));

  Flat turned_over;
  std::vector<Vec3d> clockwise = in_plane(flat);
  std::reverse(clockwise.begin(), clockwise.end());
  for (const Vec3d& p : clockwise)
    turned_over.push_back({-p.x, p.y}); // as seen from below
  expect_covers(turned_over, triangulate(clockwise));

  const Placement placement = random_placement(chance);
  const std::vector<Vec3d> polygon = place(flat, placement);
  const Triangulation result = triangulate(polygon);
  EXPECT_EQ(result.triangles.size(), flat.size() - 2);
  EXPECT_EQ(result.slivers, 0U);
  expect_edges_match(flat.size(), result);
  for (const auto& t : result.triangles)
    EXPECT_GT(dot(cross(polygon[t[1]] - polygon[t[0]], polygon[t[2]] - polygon[t[0]]), placement.normal()),
              0);
}

// --- Tests

TEST_F(Orientation, SignIsExact) {
  for (int i = 0; i < 20000; ++i) {
    // On a lattice of 2^-30 products are exact in 128 bits; nearly collinear by construction.
    const auto lattice = [&] { return chance_.whole(-(1 << 30), 1 << 30); };
    const std::array<std::int64_t, 4> ends{lattice(), lattice(), lattice(), lattice()};
    const double share = chance_.uniform(-1, 1);
    const auto part = [&](std::int64_t a, std::int64_t b) {
      return static_cast<std::int64_t>(static_cast<double>(a) + share * static_cast<double>(b - a)) +
             chance_.whole(-1, 1);
    };
    const std::array<std::int64_t, 2> third{part(ends[0], ends[2]), part(ends[1], ends[3])};
    const auto exact = static_cast<__int128>(ends[0] - third[0]) * (ends[3] - third[1]) -
                       static_cast<__int128>(ends[1] - third[1]) * (ends[2] - third[0]);
    const auto point = [](std::int64_t x, std::int64_t y) {
      return Point2{std::ldexp(static_cast<double>(x), -31), std::ldexp(static_cast<double>(y), -31)};
    };
    const double found =
        orientation(point(ends[0], ends[1]), point(ends[2], ends[3]), point(third[0], third[1]));
    ASSERT_EQ(found > 0, exact > 0);
    ASSERT_EQ(found < 0, exact < 0);
  }
}

TEST_F(Orientation, SumOfProductsIsExact) {
  // (1+e)² - 1 - 2e = e² with e = 2^-40: zero in double arithmetic.
  const double e = std::exp2(-40);
  const double sum = sum_of_products<6>({{1 + e, 1 + e}, {-1, 1}, {-2, e}, {0, 0}, {0, 0}, {0, 0}});
  EXPECT_EQ(sum, e * e);
  EXPECT_EQ(sum_of_products<6>({{0.1, 0.3}, {-0.3, 0.1}, {0.7, 0.9}, {-0.9, 0.7}, {0, 1}, {1, 0}}), 0);
}

TEST_F(Triangulate, CoversPolygonsOfAnyShape) {
  const std::pair<const char*, Flat (*)(Chance&)> shapes[] = {
      {"convex", [](Chance& chance) { return regular(chance.whole(3, 200)); }},
      {"star", [](Chance& chance) { return star(chance, chance.whole(3, 300)); }},
      {"gear", [](Chance& chance) { return gear(chance.whole(3, 36)); }},
      {"comb", [](Chance& chance) { return comb(chance.whole(1, 100)); }},
      {"spiral", [](Chance& chance) { return spiral(chance.whole(1, 150)); }},
      {"outline with many collinear vertices",
       [](Chance& chance) { return blob_outline(chance, chance.whole(1, 80)); }},
      {"vertices on straight edges", [](Chance& chance) {
         // Halves, quarters and eighths of integers are exact, and so are collinear vertices.
         const Flat flat = blob_outline(chance, chance.whole(1, 10));
         Flat finer;
         for (std::size_t i = 0; i < flat.size(); ++i) {
           const Point2 &a = flat[i], &b = flat[(i + 1) % flat.size()];
           for (int k = 0; k < 8; k += chance.whole(1, 8))
             finer.push_back({a.x + (b.x - a.x) * k / 8, a.y + (b.y - a.y) * k / 8});
         }
         return finer;
       }}};
  for (const auto& [name, shape] : shapes) {
    SCOPED_TRACE(name);
    for (int i = 0; i < 60 && !HasFailure(); ++i)
      expect_covers_anywhere(shape(chance_), chance_);
  }
  EXPECT_EQ(triangulate(in_plane(gear(36))).triangles.size(), 142U);
}

// Vertices on edges up to rounding: no slivers, and every vertex is used; in space, too.
TEST_F(Triangulate, UsesEveryVertexOnARoundedStraightEdge) {
  for (int i = 0; i < 100; ++i) {
    const Flat flat = with_points_on_edges(chance_, star(chance_, chance_.whole(3, 40)), 6);
    const Triangulation result = triangulate(place(flat, random_placement(chance_)));
    ASSERT_EQ(result.triangles.size(), flat.size() - 2);
    ASSERT_EQ(result.slivers, 0U);
    expect_edges_match(flat.size(), result);
  }
}

TEST_F(Triangulate, CoversHolesCutInByBridges) {
  for (int i = 0; i < 50; ++i) {
    const int holes = chance_.whole(1, 9);
    const double angle = i == 0 ? 0 : chance_.uniform(0, 7); // turned, the bridges are off by rounding
    const Flat flat = turned(square_with_holes(holes), angle);
    expect_covers(flat, triangulate(in_plane(flat)));
  }
}

TEST_F(Triangulate, SkipsRepeatedVertices) {
  for (int i = 0; i < 100; ++i) {
    const Flat flat = star(chance_, chance_.whole(3, 30));
    std::vector<Vec3d> repeated;
    for (const Vec3d& p : in_plane(flat))
      repeated.insert(repeated.end(), static_cast<std::size_t>(chance_.whole(1, 3)), p);
    repeated.push_back(repeated.front()); // closed
    const Triangulation result = triangulate(repeated);
    EXPECT_EQ(result.triangles.size(), flat.size() - 2);
    EXPECT_EQ(result.slivers, 0U);
    EXPECT_FALSE(result.crosses_itself);
  }
}

TEST_F(Triangulate, DropsPolygonsWithoutArea) {
  const auto count = [](const Flat& flat) { return triangulate(in_plane(flat)).triangles.size(); };
  EXPECT_EQ(count({}), 0U);
  EXPECT_EQ(count({{0, 0}, {1, 1}}), 0U);
  EXPECT_EQ(count({{0, 0}, {1, 1}, {3, 3}}), 0U);
  EXPECT_EQ(count({{0.1, 0.3}, {0.2, 0.6}, {0.3, 0.9}}), 0U); // collinear up to rounding
  EXPECT_EQ(count({{0, 0}, {0, 0}, {0, 0}, {0, 0}}), 0U);
  EXPECT_EQ(count({{0, 0}, {1, 1}, {3, 3}, {2, 2}, {5, 5}}), 0U);
  EXPECT_EQ(count({{0, 0}, {1, 0}, {1, 1}, {1, 1}}), 1U);
}

TEST_F(Triangulate, CutsOffSpikes) {
  // A square with a line out of one corner and back.
  const Triangulation result =
      triangulate(in_plane({{0, 0}, {1, 0}, {1, 1}, {2, 2}, {3, 3}, {2, 2}, {1, 1}, {0, 1}}));
  EXPECT_EQ(result.triangles.size(), 2U);
  EXPECT_FALSE(result.crosses_itself);
  EXPECT_GE(result.slivers, 1U);
}

TEST_F(Triangulate, ReportsSelfCrossingPolygons) {
  const auto crosses = [](const Flat& flat) { return triangulate(in_plane(flat)).crosses_itself; };
  EXPECT_TRUE(crosses({{0, 0}, {2, 2}, {2, 0}, {0, 2}}));
  EXPECT_TRUE(crosses({{0, 0}, {4, 0}, {4, 2}, {3, 2}, {2, -1}, {1, 2}, {0, 2}}));
  const Flat corners = regular(5);
  EXPECT_TRUE(crosses({corners[0], corners[2], corners[4], corners[1], corners[3]}));
}

TEST_F(Triangulate, TerminatesOnAnyInput) {
  for (int i = 0; i < 3000; ++i) {
    const int range = chance_.whole(1, 6);
    std::vector<Vec3d> polygon(static_cast<std::size_t>(chance_.whole(0, 40)));
    const double scale = std::pow(10.0, chance_.uniform(-100, 99));
    for (Vec3d& p : polygon)
      p = Vec3d{static_cast<double>(chance_.whole(-range, range)),
                static_cast<double>(chance_.whole(-range, range)),
                static_cast<double>(i % 2 == 0 ? 0 : chance_.whole(-range, range))} *
          scale;
    const Triangulation result = triangulate(polygon);
    EXPECT_LE(result.triangles.size() + 2, std::max<std::size_t>(polygon.size(), 2));
    for (const auto& [a, b, c] : result.triangles) {
      ASSERT_LT(std::max({a, b, c}), polygon.size());
      EXPECT_TRUE(has_area(polygon[a], polygon[b], polygon[c]));
    }
  }
}

TEST_F(Triangulate, KeepsThinTriangles) {
  EXPECT_TRUE(has_area({0, 0, 0}, {1, 0, 0}, {0.5, 1e-12, 0}));
  EXPECT_FALSE(has_area({0, 0, 0}, {1, 0, 0}, {0.5, 1e-17, 0}));
  EXPECT_TRUE(has_area({0, 0, 0}, {1e-90, 0, 0}, {0, 1e-90, 0}));
  EXPECT_TRUE(has_area({0, 0, 0}, {1e100, 0, 0}, {0, 1e100, 0}));
}

TEST_F(Triangulate, SplitsQuadsByTheShorterDiagonal) {
  const Triangulation result = triangulate(in_plane({{-5, 0}, {0, -1}, {5, 0}, {0, 1}}));
  ASSERT_EQ(result.triangles.size(), 2U);
  for (const auto& t : result.triangles)
    EXPECT_TRUE(std::count(t.begin(), t.end(), 1U) && std::count(t.begin(), t.end(), 3U));
}

// --- The sweep

std::pair<SweepOutcome, Triangulation> by_sweep(const Flat& flat) {
  std::vector<std::uint32_t> ring(flat.size());
  std::iota(ring.begin(), ring.end(), 0U);
  Triangulation result;
  const SweepOutcome outcome = triangulate_by_sweep(flat, ring, result.triangles);
  return {outcome, result};
}

double signed_area(const Flat& flat) {
  double area = 0;
  for (std::size_t i = 0; i < flat.size(); ++i) {
    const Point2 &a = flat[i], &b = flat[(i + 1) % flat.size()];
    area += a.x * b.y - b.x * a.y;
  }
  return area;
}

enum class Simplicity { simple, touches, crosses };

// Of all pairs of edges.
Simplicity simplicity_of(const Flat& flat) {
  const std::size_t n = flat.size();
  Simplicity worst = Simplicity::simple;
  const auto on = [](const Point2& a, const Point2& b, const Point2& p) {
    return orientation(a, b, p) == 0 && std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) &&
           std::min(a.y, b.y) <= p.y && p.y <= std::max(a.y, b.y);
  };
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 1; j < n; ++j) {
      const Point2 &a = flat[i], &b = flat[(i + 1) % n], &c = flat[j], &d = flat[(j + 1) % n];
      if (j == i + 1 || (i == 0 && j == n - 1)) { // neighbours: one goes back over the other
        if (j == i + 1 ? on(a, b, d) || on(c, d, a) : on(c, d, b) || on(a, b, c))
          worst = std::max(worst, Simplicity::touches);
        continue;
      }
      const auto sign = [](double x) { return x > 0 ? 1 : x < 0 ? -1 : 0; };
      const int by_c = sign(orientation(a, b, c)), by_d = sign(orientation(a, b, d)),
                by_a = sign(orientation(c, d, a)), by_b = sign(orientation(c, d, b));
      if (by_c * by_d < 0 && by_a * by_b < 0)
        worst = Simplicity::crosses;
      else if (on(a, b, c) || on(a, b, d) || on(c, d, a) || on(c, d, b))
        worst = std::max(worst, Simplicity::touches);
    }
  }
  return worst;
}

TEST_F(SweepTriangulation, CoversSimplePolygons) {
  for (int i = 0; i < 200; ++i) {
    const double angle = chance_.uniform(0, 7);
    const int size = chance_.whole(1, 60);
    for (const Flat& flat :
         {star(chance_, size + 2), regular(size + 2), gear(size + 2), comb(size), spiral(size + 20)}) {
      const Flat placed = turned(flat, angle);
      const auto [outcome, result] = by_sweep(placed);
      ASSERT_EQ(outcome, SweepOutcome::triangulated) << flat.size() << " corners";
      expect_covers(placed, result);
    }
  }
}

// Few corners, so that many are simple: in general position, and on a lattice, where points coincide, edges
// overlap, and many corners have the same x.
TEST_F(SweepTriangulation, KnowsSimplePolygonsFromOthers) {
  std::map<std::pair<Simplicity, SweepOutcome>, int> seen;
  for (int i = 0; i < 20000; ++i) {
    const bool on_lattice = i % 2 == 0;
    const int range = chance_.whole(1, 5);
    Flat flat(static_cast<std::size_t>(chance_.whole(3, 9)));
    for (Point2& p : flat)
      p = on_lattice ? Point2{double(chance_.whole(0, range)), double(chance_.whole(0, range))}
                     : Point2{chance_.uniform(0, 1), chance_.uniform(0, 1)};
    if (signed_area(flat) == 0) continue;
    if (signed_area(flat) < 0) std::reverse(flat.begin(), flat.end());
    const Simplicity simplicity = simplicity_of(flat);
    const auto [outcome, result] = by_sweep(flat);
    ++seen[{simplicity, outcome}];
    if (simplicity == Simplicity::simple) {
      const bool is_straight = std::ranges::any_of(std::views::iota(0U, flat.size()), [&](std::size_t v) {
        return orientation(flat[v], flat[(v + 1) % flat.size()], flat[(v + 2) % flat.size()]) == 0;
      });
      ASSERT_TRUE(is_straight || outcome == SweepOutcome::triangulated);
    }
    if (outcome == SweepOutcome::triangulated) {
      ASSERT_EQ(simplicity, Simplicity::simple);
      expect_covers(flat, result);
    }
    ASSERT_TRUE(outcome != SweepOutcome::crosses || simplicity != Simplicity::simple);
    ASSERT_TRUE(on_lattice || simplicity != Simplicity::crosses || outcome == SweepOutcome::crosses);
  }
  EXPECT_GT((seen[{Simplicity::simple, SweepOutcome::triangulated}]), 1000);
  EXPECT_GT((seen[{Simplicity::crosses, SweepOutcome::crosses}]), 1000);
  EXPECT_GT((seen[{Simplicity::touches, SweepOutcome::undecided}]), 100);
}

// Holes cut in by bridges, and outlines that touch themselves at points.
TEST_F(SweepTriangulation, TouchingIsNoCrossing) {
  for (int i = 0; i < 300; ++i) {
    for (const Flat& flat :
         {blob_outline(chance_, chance_.whole(1, 30)), square_with_holes(chance_.whole(1, 9))}) {
      const auto [outcome, result] = by_sweep(flat);
      ASSERT_NE(outcome, SweepOutcome::crosses);
      if (outcome == SweepOutcome::triangulated) expect_covers(flat, result);
    }
  }
}

// Where no result can be right, one comes soon all the same.
TEST_F(SweepTriangulation, HugePolygonsTakeSeconds) {
  Flat crossing(200'000);
  for (Point2& p : crossing)
    p = {chance_.uniform(0, 1), chance_.uniform(0, 1)};
  const Flat huge_star = star(chance_, 200'000); // ear clipping gives up
  const auto start = std::chrono::steady_clock::now();
  for (const Flat& flat : {huge_star, comb(50'000), spiral(50'000), regular(100'000), crossing}) {
    const bool crosses = flat[0].x == crossing[0].x;
    const Triangulation result = triangulate(in_plane(flat));
    EXPECT_EQ(result.crosses_itself, crosses);
    EXPECT_EQ(result.triangles.size() + result.slivers, flat.size() - 2);
    EXPECT_TRUE(crosses || result.slivers == 0);
  }
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  EXPECT_LT(seconds.count(), 240); // seconds at most, with room for sanitizers
  const auto [outcome, swept] = by_sweep(huge_star);
  ASSERT_EQ(outcome, SweepOutcome::triangulated);
  expect_covers(huge_star, swept);
  EXPECT_EQ(triangulate(in_plane(huge_star)).triangles, swept.triangles);
}

} // namespace
} // namespace masu
