// What is wrong with meshes, as comparing every edge and triangle with every other finds it.
#include "libscene/mesh/mesh_check.h"
#include "stability/closed_mesh.h"
#include "tests/random_test.h"

namespace masu {
namespace {

template <class Real>
class MeshChecks : public RandomTest {};
TYPED_TEST_SUITE(MeshChecks, Reals);

template <class Stored>
MeshCheck checked(const std::vector<Triangle<Stored>>& triangles) {
  TestScene<Stored> scene;
  scene.triangles = triangles;
  return check_mesh(scene.view());
}

void expect_faults(const MeshFaults& found, const std::vector<std::uint32_t>& expected, const char* kind) {
  EXPECT_EQ(found.count, expected.size()) << kind;
  ASSERT_TRUE(std::equal(found.first.begin(), found.first.begin() + found.examples(), expected.begin()))
      << kind;
  EXPECT_EQ(found.examples(), std::min<std::size_t>(expected.size(), 8));
}

template <class Stored>
bool same_points(const Triangle<Stored>& t, const Triangle<Stored>& u) {
  const Vec3<Stored> a[] = {t.a, t.b, t.c}, b[] = {u.a, u.b, u.c};
  return std::is_permutation(a, a + 3, b);
}

// By comparing each with each. Of coordinates whose products double holds.
template <class Stored>
void expect_check(const std::vector<Triangle<Stored>>& triangles) {
  const MeshCheck found = checked(triangles);
  std::vector<std::uint32_t> open, inconsistent, nonmanifold, no_area, duplicates;
  std::vector<Vec3<Stored>> points;
  std::uint64_t edges = 0;
  struct Edge {
    Vec3<Stored> from, to;
    std::uint32_t corner;
  };
  std::vector<Edge> all;
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    const Triangle<Stored>& t = triangles[i];
    const Vec3<Stored> corners[] = {t.a, t.b, t.c};
    const Triangle<double> wide = widened(t);
    if (cross(wide.b - wide.a, wide.c - wide.a) == Vec3d{}) no_area.push_back(3 * i);
    for (std::uint32_t c = 0; c < 3; ++c) {
      if (std::ranges::count(points, corners[c]) == 0) points.push_back(corners[c]);
      if (!(corners[c] == corners[(c + 1) % 3])) all.push_back({corners[c], corners[(c + 1) % 3], 3 * i + c});
    }
    const auto is_same = [&](const Triangle<Stored>& other) { return same_points(t, other); };
    if (has_surface(t) && std::any_of(triangles.begin(), triangles.begin() + i, is_same))
      duplicates.push_back(3 * i);
  }
  for (const Edge& edge : all) {
    const auto is_same = [&](const Edge& e) { return e.from == edge.from && e.to == edge.to; };
    const auto is_turned = [&](const Edge& e) { return e.from == edge.to && e.to == edge.from; };
    const auto first = std::ranges::find_if(all, [&](const Edge& e) { return is_same(e) || is_turned(e); });
    if (first->corner != edge.corner) continue;
    const auto same = std::ranges::count_if(all, is_same), turned = std::ranges::count_if(all, is_turned);
    ++edges;
    if ((same + turned) % 2 != 0) open.push_back(edge.corner);
    if ((same + turned) % 2 == 0 && same != turned) inconsistent.push_back(edge.corner);
    if (same + turned > 2) nonmanifold.push_back(edge.corner);
  }
  EXPECT_EQ(found.points, points.size());
  EXPECT_EQ(found.edges, edges);
  expect_faults(found.open, open, "open");
  expect_faults(found.inconsistent, inconsistent, "inconsistent");
  expect_faults(found.nonmanifold, nonmanifold, "nonmanifold");
  expect_faults(found.no_area, no_area, "no area");
  expect_faults(found.duplicates, duplicates, "duplicates");
}

// Between so few points that all of it occurs.
TYPED_TEST(MeshChecks, FindWhatComparingEachWithEachDoes) {
  using Stored = TypeParam;
  Chance& chance = this->chance_;
  for (std::int64_t s = cases(300); s > 0; --s) {
    const int side = chance.whole(1, 3);
    const auto corner = [&] {
      const auto coordinate = [&] {
        const int whole = chance.whole(0, side);
        return whole == 0 && chance.one_in(2) ? Stored(-0.0) : static_cast<Stored>(whole);
      };
      return Vec3<Stored>{coordinate(), coordinate(), coordinate()};
    };
    std::vector<Triangle<Stored>> triangles;
    for (int i = chance.whole(0, 40); i > 0; --i)
      triangles.push_back(triangle_of<Stored>(corner(), corner(), corner()));
    expect_check(triangles);
    if (this->HasFailure()) return;
  }
}

TYPED_TEST(MeshChecks, OfClosedMeshesFindNothingUntilATriangleIsTurnedOrMissing) {
  using Stored = TypeParam;
  Chance& chance = this->chance_;
  for (std::int64_t s = cases(100); s > 0; --s) {
    auto triangles = closed_mesh<Stored>(chance, 1, false);
    const MeshCheck whole = checked(triangles);
    EXPECT_EQ(whole.open.count + whole.inconsistent.count, 0U);
    Triangle<Stored>& one = triangles[chance.index(triangles.size())];
    if (one.a == one.b || one.b == one.c || one.c == one.a) continue; // its edges meet each other
    std::swap(one.a, one.b);
    EXPECT_EQ(checked(triangles).inconsistent.count, 3U);
    std::swap(one, triangles.back());
    triangles.pop_back();
    EXPECT_EQ(checked(triangles).open.count, 3U);
  }
}

// Corners on a line, in any direction and of any size, but for the last bit.
TYPED_TEST(MeshChecks, KnowExactlyWhatHasNoArea) {
  using Stored = TypeParam;
  Chance& chance = this->chance_;
  for (std::int64_t s = cases(10'000); s > 0; --s) {
    const double size = chance.power_of_two(-40, 40);
    const Vec3<Stored> a = cast<Stored>(chance.in_cube(size)),
                       step = cast<Stored>(cast<double>(cast<int>(chance.in_cube(1000))) * (size * 0x1p-12));
    // On a lattice of one bit that numbers of a's size have.
    const auto on_lattice = [&](const Vec3<Stored>& v) {
      const double unit = std::exp2(std::ceil(std::log2(size)) - 20);
      return cast<Stored>(Vec3d{std::round(static_cast<double>(v.x) / unit) * unit,
                                std::round(static_cast<double>(v.y) / unit) * unit,
                                std::round(static_cast<double>(v.z) / unit) * unit});
    };
    const Vec3<Stored> from = on_lattice(a), along = on_lattice(step);
    Vec3<Stored> corners[] = {from, from + along, from + along * Stored(2)};
    std::ranges::shuffle(corners, chance.engine());
    EXPECT_EQ(checked<Stored>({triangle_of<Stored>(corners[0], corners[1], corners[2])}).no_area.count, 1U);
    if (along == Vec3<Stored>{}) continue;
    const Vec3d aside = across(chance, cast<double>(along));
    int axis = 0;
    for (int i = 1; i < 3; ++i)
      if (std::abs(aside[i]) > std::abs(aside[axis])) axis = i;
    corners[1].set(axis, std::nextafter(corners[1][axis], Stored(INFINITY)));
    const Vec3d p = cast<double>(corners[1]) - cast<double>(corners[0]),
                q = cast<double>(corners[2]) - cast<double>(corners[0]);
    if (cross(p, q) == Vec3d{}) continue; // moved along the line
    EXPECT_EQ(checked<Stored>({triangle_of<Stored>(corners[0], corners[1], corners[2])}).no_area.count, 0U);
  }
}

} // namespace
} // namespace masu
