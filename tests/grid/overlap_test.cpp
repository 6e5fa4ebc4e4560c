// Which voxels list a primitive: all that its surface touches, and under the exact test no others; against an
// oracle that clips triangles, measures distances and cuts voxels up.
#include "libgrid/grid/division.h"
#include "libgrid/grid/overlap/clipped_bounds.h"
#include "libgrid/grid/overlap/overlap.h"
#include "libgrid/hierarchy/binary/clipped_lanes.h"
#include "stability/oracle/oracle.h"
#include "tests/grid/lists.h"
#include "tests/random_test.h"
#include "tests/ray_case.h"
#include "tests/surface_point.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

namespace masu {
namespace {

using OverlapsOfAFlatCone = RandomTest;
using PrimitivesCutByAPlane = RandomTest;

using oracle::Wide;

constexpr double own_roundoff = RealTraits<double>::unit_roundoff;

// --- Voxels ----------------------------------------------------------------------------------------------

struct WideBox {
  oracle::Point min, max;
};

WideBox voxel_box(const GridLayout& layout, const Vec3i& voxel) {
  const oracle::Point low = oracle::point(layout.space.min), extent = oracle::point(layout.space.max) - low;
  const Vec3i& n = layout.division;
  const auto corner = [&](int step) {
    return low + oracle::Point{extent.x * (voxel.x + step) / n.x, extent.y * (voxel.y + step) / n.y,
                               extent.z * (voxel.z + step) / n.z};
  };
  return {corner(0), corner(1)};
}

WideBox grown(const WideBox& box, Wide by) {
  return {box.min - oracle::Point{by, by, by}, box.max + oracle::Point{by, by, by}};
}

std::string described(const GridLayout& layout, const Vec3i& voxel = {}) {
  return "space " + masu::described(layout.space.min) + masu::described(layout.space.max) +
         fmt::format(" division {}x{}x{} margin {:a} voxel {} {} {}", layout.division.x, layout.division.y,
                     layout.division.z, layout.margin, voxel.x, voxel.y, voxel.z);
}

// What the builder lists, in the order of voxels; each must come once and lie in the space.
class Listing {
public:
  template <class Primitive>
  Listing(const GridLayout& layout, Overlap overlap, const Primitive& primitive)
      : division_(layout.division) {
    for_each_overlap(layout, overlap, primitive, [&](const Vec3i& voxel) {
      for (int axis = 0; axis < 3; ++axis)
        inside_ = inside_ && voxel[axis] >= 0 && voxel[axis] < division_[axis];
      voxels_.push_back(linear_index(voxel, division_));
    });
    std::ranges::sort(voxels_);
  }

  bool lists(const Vec3i& voxel) const {
    return std::ranges::binary_search(voxels_, linear_index(voxel, division_));
  }
  bool each_once() const { return std::ranges::adjacent_find(voxels_) == voxels_.end(); }
  bool inside() const { return inside_; }
  bool within(const Listing& other) const { return std::ranges::includes(other.voxels_, voxels_); }
  std::size_t size() const { return voxels_.size(); }

private:
  Vec3i division_;
  std::vector<std::uint64_t> voxels_;
  bool inside_ = true;
};

// --- The oracle ------------------------------------------------------------------------------------------

// Whether the triangle meets the closed box: cut by one face's plane after the other, is anything left?
bool meets(const Triangle<double>& triangle, const WideBox& box) {
  std::vector<oracle::Point> polygon{oracle::point(triangle.a), oracle::point(triangle.b),
                                     oracle::point(triangle.c)};
  const auto cut = [&](auto inside_by) {
    std::vector<oracle::Point> rest;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const oracle::Point &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
      const Wide at_a = inside_by(a), at_b = inside_by(b);
      if (at_a >= 0) rest.push_back(a);
      if ((at_a >= 0) != (at_b >= 0)) rest.push_back(a + (b - a) * (at_a / (at_a - at_b)));
    }
    polygon = std::move(rest);
  };
  cut([&](const oracle::Point& p) { return p.x - box.min.x; });
  cut([&](const oracle::Point& p) { return box.max.x - p.x; });
  cut([&](const oracle::Point& p) { return p.y - box.min.y; });
  cut([&](const oracle::Point& p) { return box.max.y - p.y; });
  cut([&](const oracle::Point& p) { return p.z - box.min.z; });
  cut([&](const oracle::Point& p) { return box.max.z - p.z; });
  return !polygon.empty();
}

// The box's least and greatest distance from a point.
std::pair<Wide, Wide> distances(const oracle::Point& p, const WideBox& box) {
  const auto axis = [](Wide at, Wide low, Wide high) {
    const Wide gap = oracle::max(0, oracle::max(low - at, at - high));
    const Wide most = oracle::max(oracle::magnitude(low - at), oracle::magnitude(high - at));
    return std::pair{gap, most};
  };
  const auto [x, fx] = axis(p.x, box.min.x, box.max.x);
  const auto [y, fy] = axis(p.y, box.min.y, box.max.y);
  const auto [z, fz] = axis(p.z, box.min.z, box.max.z);
  return {oracle::norm({x, y, z}), oracle::norm({fx, fy, fz})};
}

bool shell_within(const Sphere<double>& sphere, const WideBox& box, Wide distance) {
  const auto [nearest, farthest] = distances(oracle::point(sphere.center), box);
  const Wide radius = std::abs(sphere.radius);
  return nearest <= radius + distance && farthest >= radius - distance;
}

// Whether some part of the box may lie within `distance` of the cone's side: the box is cut up until its
// parts are far, or small.
bool side_may_be_within(const Cone<double>& cone, const WideBox& box, Wide distance, int cuts) {
  const oracle::Point half = (box.max - box.min) * Wide(0.5), center = box.min + half;
  if (oracle::distance(center, cone) > oracle::norm(half) + distance) return false;
  if (cuts == 0) return true;
  for (unsigned part = 0; part < 8; ++part) {
    const oracle::Point low{(part & 1) != 0 ? center.x : box.min.x, (part & 2) != 0 ? center.y : box.min.y,
                            (part & 4) != 0 ? center.z : box.min.z};
    if (side_may_be_within(cone, {low, low + half}, distance, cuts - 1)) return true;
  }
  return false;
}

// --- Random cases ----------------------------------------------------------------------------------------

// A layout as gridbuild makes it, in a scene that reaches to ±scale.
template <class Real>
GridLayout random_layout(Chance& chance, double scale, int finest) {
  const Boxd bounds{{-scale, -scale, -scale}, {scale, scale, scale}};
  const auto voxels = [&] {
    return static_cast<std::int32_t>(std::lround(chance.power_of_two(0, std::log2(finest))));
  };
  return layout_in<Real>(bounds, {voxels(), voxels(), voxels()},
                         chance.one_in(2) ? SpaceRule::tight : SpaceRule::cube);
}

Vec3d random_corner(Chance& chance, const GridLayout& layout) {
  const Vec3d size = voxel_size(layout);
  Vec3d corner{};
  for (int axis = 0; axis < 3; ++axis)
    corner.set(axis, layout.space.min[axis] + size[axis] * chance.whole(0, layout.division[axis]));
  return corner;
}

// In the space's middle half; anywhere along an axis of one voxel.
Vec3d inner_corner(Chance& chance, const GridLayout& layout) {
  const Vec3d size = voxel_size(layout);
  Vec3d corner{};
  for (int axis = 0; axis < 3; ++axis) {
    const double share = chance.uniform(0.25, 0.75) * layout.division[axis];
    const double plane = std::clamp(std::round(share), 1.0, std::max(1.0, layout.division[axis] - 1.0));
    corner.set(axis, layout.space.min[axis] + size[axis] * (layout.division[axis] > 1 ? plane : share));
  }
  return corner;
}

// Points for triangles: anywhere, on the layout's planes, or on its corners.
Vec3d random_point(Chance& chance, const GridLayout& layout, double scale) {
  Vec3d p = chance.in_cube(scale);
  const Vec3d corner = random_corner(chance, layout);
  for (int axis = 0; axis < 3; ++axis)
    if (chance.one_in(4)) p.set(axis, corner[axis]);
  return chance.one_in(8) ? corner : p;
}

// Not a point, which is listed nowhere.
template <class Real>
Triangle<double> random_triangle(Chance& chance, const GridLayout& layout, double scale) {
  Vec3d a = random_point(chance, layout, scale), b = random_point(chance, layout, scale),
        c = random_point(chance, layout, scale);
  const double size = chance.power_of_two(-12, 0);
  switch (chance.whole(0, 7)) {
  case 0: // a needle
    c = a + (b - a) * chance.uniform(0, 1) + chance.in_cube(scale * chance.power_of_two(-50, -3));
    break;
  case 1: // a segment
    c = chance.one_in(2) ? a : a + (b - a) * 0.5;
    break;
  case 2: // hardly more than a point
    b = a;
    c = a * (1 + 0x1p-20);
    break;
  case 3: // across an axis
    b.z = a.z;
    c.z = a.z;
    break;
  default: // smaller
    b = a + (b - a) * size;
    c = a + (c - a) * size;
    break;
  }
  const Triangle<double> triangle = triangle_of(kept<Real>(a), kept<Real>(b), kept<Real>(c));
  return has_surface(triangle) ? triangle : random_triangle<Real>(chance, layout, scale);
}

template <class Real>
Sphere<double> random_sphere(Chance& chance, const GridLayout& layout, double scale) {
  const double radius = scale / 2 * chance.power_of_two(-12, 0);
  return {kept<Real>(random_point(chance, layout, scale / 2)),
          kept<Real>(chance.one_in(4) ? -radius : radius)};
}

template <class Real>
Cone<double> random_cone(Chance& chance, const GridLayout& layout, double scale) {
  const double length = scale / 2 * chance.power_of_two(-12, 0), r0 = scale / 4 * chance.power_of_two(-16, 0);
  Vec3d axis = chance.direction();
  if (chance.one_in(2)) {
    Vec3d along{};
    along.set(chance.whole(0, 2), chance.sign());
    axis = chance.one_in(2) ? along : along + axis * chance.power_of_two(-40, -3);
  }
  const double r1 = chance.one_of({r0, 0.0, r0 * (1 + 1e-7), scale / 4 * chance.power_of_two(-16, 0)});
  const Vec3d base = random_point(chance, layout, scale / 4);
  Cone<double> cone{kept<Real>(base), kept<Real>(r0), kept<Real>(base + axis * length), kept<Real>(r1)};
  if (cone.base == cone.apex) cone.apex.x = kept<Real>(cone.apex.x + length);
  if (chance.one_in(2)) {
    std::swap(cone.base, cone.apex);
    std::swap(cone.base_radius, cone.apex_radius);
  }
  return cone;
}

template <class K>
auto random_primitive(Chance& chance, const GridLayout& layout, double scale) {
  using Real = typename K::Real;
  using Primitive = typename K::template Primitive<Real>;
  if constexpr (std::is_same_v<Primitive, Triangle<Real>>) {
    return random_triangle<Real>(chance, layout, scale);
  } else if constexpr (std::is_same_v<Primitive, Sphere<Real>>) {
    return random_sphere<Real>(chance, layout, scale);
  } else {
    return random_cone<Real>(chance, layout, scale);
  }
}

template <class K>
class Overlaps : public RandomTest {};
TYPED_TEST_SUITE(Overlaps, Kinds, KindNames);

// --- What must be listed ---------------------------------------------------------------------------------

// How close to a voxel a surface must be listed: what margin.h needs for hits and walks. The rest of the
// margin is the builder's own, for its rounding.
double needed(const GridLayout& layout, double scale) {
  return layout.margin - 28 * own_roundoff * scale;
}

// Expects the listing to have all voxels that are so near to the surface, by a point that is on it but for
// its own rounding.
template <class Primitive>
void expect_listed_near(const Vec3d& point, const Primitive& primitive, const GridLayout& layout,
                        const Listing& listing, double of_surface) {
  const oracle::Point at = oracle::point(point);
  const Wide reach = of_surface - oracle::distance(at, primitive);
  const oracle::Point low = oracle::point(layout.space.min), extent = oracle::point(layout.space.max) - low;
  const auto first_last = [&](Wide p, Wide from, Wide along, std::int32_t division) {
    // A little more on both sides, to be looked at closely.
    const auto voxel_of = [&](Wide number, double more) {
      return static_cast<std::int32_t>(
          std::clamp(std::floor(static_cast<double>(number) + more), 0.0, division - 1.0));
    };
    return std::pair{voxel_of((p - reach - from) / along * division, -1e-6),
                     voxel_of((p + reach - from) / along * division, 1e-6)};
  };
  const auto [x0, x1] = first_last(at.x, low.x, extent.x, layout.division.x);
  const auto [y0, y1] = first_last(at.y, low.y, extent.y, layout.division.y);
  const auto [z0, z1] = first_last(at.z, low.z, extent.z, layout.division.z);
  for_each_voxel({{x0, y0, z0}, {x1, y1, z1}}, [&](const Vec3i& voxel) {
    if (distances(at, voxel_box(layout, voxel)).first > reach) return;
    ASSERT_TRUE(listing.lists(voxel))
        << described(primitive) << ' ' << described(layout, voxel) << " by " << described(point);
  });
}

TYPED_TEST(Overlaps, EveryVoxelNearASampledPointOfTheSurfaceIsListed) {
  Chance& chance = this->chance_;
  for (std::int64_t i = cases(1500); i > 0 && !this->HasFailure(); --i) {
    const double scale = std::exp2(chance.whole(-10, 20));
    const GridLayout layout = random_layout<typename TypeParam::Real>(chance, scale, 48);
    const auto primitive = random_primitive<TypeParam>(chance, layout, scale);
    const Listing exact(layout, Overlap::exact, primitive), box(layout, Overlap::box, primitive);
    ASSERT_TRUE(exact.each_once() && box.each_once()) << described(primitive) << described(layout);
    ASSERT_TRUE(exact.inside() && box.inside()) << described(primitive) << described(layout);
    ASSERT_TRUE(exact.within(box)) << described(primitive) << described(layout);
    for (int k = 0; k < 100; ++k)
      expect_listed_near(on_surface(chance, primitive).at, primitive, layout, exact, needed(layout, scale));
  }
}

// The surface touches a corner, an edge or a face of the voxels, and may hardly enter them.
TYPED_TEST(Overlaps, WhatTouchesACornerIsListedAllRound) {
  Chance& chance = this->chance_;
  for (std::int64_t i = cases(40'000); i > 0 && !this->HasFailure(); --i) {
    const double scale = std::exp2(chance.whole(-10, 20));
    const GridLayout layout = random_layout<typename TypeParam::Real>(chance, scale, 16);
    const auto start = random_primitive<TypeParam>(chance, layout, scale / 4);
    const Vec3d corner = inner_corner(chance, layout);
    const Vec3d by = corner - on_surface(chance, start).at;
    auto primitive = start;
    with_points(primitive,
                [&](auto&... points) { ((points = kept<typename TypeParam::Real>(points + by)), ...); });
    if (!has_surface(primitive)) continue; // a point once it is rounded
    const Listing exact(layout, Overlap::exact, primitive);
    expect_listed_near(corner, primitive, layout, exact, needed(layout, scale));
  }
}

// --- What must not be listed -----------------------------------------------------------------------------

template <class Primitive>
bool must_be_listed(const Primitive& primitive, const WideBox& voxel, double distance) {
  if constexpr (std::is_same_v<Primitive, Triangle<double>>) {
    return meets(primitive, grown(voxel, distance));
  } else if constexpr (std::is_same_v<Primitive, Sphere<double>>) {
    return shell_within(primitive, voxel, distance);
  } else {
    return false;
  }
}
bool may_be_listed(const Triangle<double>& triangle, const WideBox& voxel, double distance) {
  const Vec3d ab = triangle.b - triangle.a, ac = triangle.c - triangle.a;
  const bool needle = length(cross(ab, ac)) <= 1e-6 * length(ab) * length(ac);
  return needle || must_be_listed(triangle, voxel, distance);
}
bool may_be_listed(const Sphere<double>& sphere, const WideBox& voxel, double distance) {
  return must_be_listed(sphere, voxel, distance);
}
bool may_be_listed(const Cone<double>& cone, const WideBox& voxel, double distance) {
  // A flat cone is moved along its axis by the margin, and its rim by far more.
  const double steepest =
      std::abs(std::abs(cone.apex_radius) - std::abs(cone.base_radius)) / length(cone.apex - cone.base);
  return side_may_be_within(cone, voxel, 2 * (1 + steepest) * distance, 5);
}

TYPED_TEST(Overlaps, TheExactTestListsWhatTheOracleDoes) {
  Chance& chance = this->chance_;
  for (std::int64_t i = cases(2000); i > 0 && !this->HasFailure(); --i) {
    const double scale = std::exp2(chance.whole(-10, 20));
    const GridLayout layout = random_layout<typename TypeParam::Real>(chance, scale, 12);
    const auto primitive = random_primitive<TypeParam>(chance, layout, scale);
    const Listing exact(layout, Overlap::exact, primitive);
    for_each_voxel_of({{0, 0, 0}, layout.division}, [&](const Vec3i& voxel) {
      const WideBox box = voxel_box(layout, voxel);
      const bool listed = exact.lists(voxel);
      ASSERT_TRUE(listed ? may_be_listed(primitive, box, layout.margin + 28 * own_roundoff * scale)
                         : !must_be_listed(primitive, box, needed(layout, scale)))
          << described(primitive) << ' ' << described(layout, voxel);
    });
  }
}

// A margin along a flat cone's axis moves its side by many voxels; its rims stay where they are.
TEST_F(OverlapsOfAFlatCone, StayByItsRims) {
  for (int i = 0; i < 20; ++i) {
    const GridLayout layout{{{-1, -1, -1}, {1, 1, 1}}, {50, 50, 50}, 1e-5};
    const Vec3d up = chance_.direction() * 1e-6;
    const Cone<double> cone{{0, 0, 0}, 0.6, up, 0.3};
    std::int64_t apart = 0, listed = 0;
    for_each_overlap(layout, Overlap::exact, cone, [&](const Vec3i& voxel) {
      const WideBox box = voxel_box(layout, voxel);
      const oracle::Point center = (box.min + box.max) * 0.5;
      ++listed;
      apart += oracle::distance(center, cone) > oracle::norm(box.max - box.min);
    });
    EXPECT_GT(listed, 500);
    EXPECT_EQ(apart, 0) << "of " << listed << ": " << masu::described(cone);
  }
}

// --- Touching, to the last bit ---------------------------------------------------------------------------

// Without a margin, and with coordinates that make all arithmetic exact, touching alone decides.
class Touching : public RandomTest {
protected:
  // Multiples of a quarter in the space.
  Vec3d point() {
    const auto c = [&] { return chance_.whole(0, 32) / 4.0; };
    return {c(), c(), c()};
  }
  // Of primitives that make() returns, those voxels are listed that touch(primitive, voxel) says.
  template <class Make, class Touch>
  void expect_listed(Overlap overlap, const Make& make, const Touch& touch) {
    for (std::int64_t i = cases(600); i > 0 && !HasFailure(); --i) {
      const auto primitive = make();
      const Listing listing(layout_, overlap, primitive);
      for_each_voxel_of({{0, 0, 0}, layout_.division}, [&](const Vec3i& voxel) {
        EXPECT_EQ(listing.lists(voxel), touch(primitive, voxel_box(layout_, voxel)))
            << described(primitive) << " voxel " << voxel.x << ' ' << voxel.y << ' ' << voxel.z;
      });
    }
  }

  GridLayout layout_{{{0, 0, 0}, {8, 8, 8}}, {8, 8, 4}, 0};
};

// Gaps between such things are far larger than this.
constexpr double next_to_nothing = 1e-20;

constexpr auto by_the_oracle = [](const auto& primitive, const WideBox& voxel) {
  return must_be_listed(primitive, voxel, next_to_nothing);
};

TEST_F(Touching, CountsForTriangles) {
  const auto floor_or_other = [&] {
    Triangle<double> triangle = triangle_of(point(), point(), point());
    if (chance_.one_in(3)) { // a floor, now and then on the lowest face or the highest
      const double at = chance_.one_of({0.0, 8.0, triangle.a.z});
      triangle.a.z = triangle.b.z = triangle.c.z = at;
    }
    return triangle;
  };
  expect_listed(Overlap::exact, floor_or_other, by_the_oracle);
}

TEST_F(Touching, CountsForSpheres) {
  const auto sphere = [&] { return Sphere<double>{point(), chance_.whole(1, 16) / 4.0}; };
  expect_listed(Overlap::exact, sphere, by_the_oracle);
}

TEST_F(Touching, CountsForBoundingBoxes) {
  expect_listed(
      Overlap::box, [&] { return triangle_of(point(), point(), point()); },
      [](const auto& triangle, const WideBox& own) {
        const Boxd around = bounds(triangle);
        return own.max.x >= around.min.x && own.min.x <= around.max.x && own.max.y >= around.min.y &&
               own.min.y <= around.max.y && own.max.z >= around.min.z && own.min.z <= around.max.z;
      });
}

// A cylinder of radius 1 about the middle of the first voxels, 2 wide: it touches all four side faces.
TEST_F(Touching, CountsForCylinders) {
  const GridLayout layout{{{-1, -1, 0}, {7, 7, 4}}, {4, 4, 4}, 1e-15};
  const Listing exact(layout, Overlap::exact, Cone<double>{{1, 1, 0}, 1, {1, 1, 2}, 1}),
      inner(layout, Overlap::exact, Cone<double>{{2, 2, 0}, 1, {2, 2, 2}, 1});
  for_each_voxel_of({{0, 0, 0}, layout.division}, [&](const Vec3i& voxel) {
    // From 0 to 2 along x and y it crosses voxels 0 and 1, and along z it ends on the face between 1 and 2.
    EXPECT_EQ(exact.lists(voxel), voxel.x <= 1 && voxel.y <= 1 && voxel.z <= 2)
        << voxel.x << voxel.y << voxel.z;
    // Voxel (1, 1) is 1 to 3 wide: this one touches its faces from inside, and so its four neighbours.
    const int off = std::abs(voxel.x - 1) + std::abs(voxel.y - 1);
    EXPECT_EQ(inner.lists(voxel), off <= 1 && voxel.z <= 2) << voxel.x << voxel.y << voxel.z;
  });
}

// The founding study's box test: a cone by its larger radius round both ends.
TEST_F(Touching, AConesBoxIsTakenWithItsLargerRadius) {
  const Boxd box = box_for_overlap(Cone<double>{{1, 2, 3}, -0.5, {1, 2, 7}, -2});
  EXPECT_EQ(box.min, (Vec3d{-1, 0, 1}));
  EXPECT_EQ(box.max, (Vec3d{3, 4, 9}));
}

// All in one plane: the space gets its thickness from the padding alone, and every voxel across it is near.
TEST_F(Touching, FlatScenesAreListedThroughTheirWholeThickness) {
  const Triangle<double> floor = triangle_of(Vec3d{0, 0, 5}, Vec3d{4, 0, 5}, Vec3d{0, 4, 5});
  const Boxd box = bounds(floor);
  const auto layout = layout_in<float>(box, {4, 4, 1});
  ASSERT_LT(layout.space.min.z, 5);
  ASSERT_GT(layout.space.max.z, 5);
  const Listing exact(layout, Overlap::exact, floor);
  // Those on the diagonal touch it at a corner.
  for_each_voxel({{0, 0, 0}, {3, 3, 0}}, [&](const Vec3i& voxel) {
    EXPECT_EQ(exact.lists(voxel), voxel.x + voxel.y <= 4) << voxel.x << voxel.y;
  });
}

TEST_F(Touching, ALargeTriangleIsListedInThePlaneOfVoxelsItCrosses) {
  const Triangle<double> large = triangle_of(Vec3d{0, 0, 0.3}, Vec3d{512, 0, 0.3}, Vec3d{0, 512, 0.3});
  const GridLayout layout{{{0, 0, 0}, {512, 512, 512}}, {512, 512, 512}, 1e-9};
  const Listing exact(layout, Overlap::exact, large);
  // Half of the squares, and the two diagonals of those that the long side crosses or touches.
  EXPECT_EQ(exact.size(), 512U * 513U / 2 + 511U);
}

// --- Parts -----------------------------------------------------------------------------------------------

TEST_F(PrimitivesCutByAPlane, HaveTheirSurfaceInThePartsBounds) {
  const auto parts_hold_the_surface = [&](const auto& primitive) {
    const Boxd whole = bounds(primitive);
    const double rounding = 64 * own_roundoff * largest_magnitude(whole);
    const int axis = chance_.whole(0, 2);
    const double plane = chance_.one_in(2)
                             ? on_surface(chance_, primitive).at[axis]
                             : chance_.uniform(whole.min[axis] - rounding, whole.max[axis] + rounding);
    const ClippedBounds sides = sides_of(primitive, axis, plane, plane);
    const auto is_within = [&](const Boxd& part) {
      return is_empty(part) ||
             (contains(grown(whole, rounding), part.min) && contains(grown(whole, rounding), part.max));
    };
    ASSERT_TRUE(is_within(sides.below) && is_within(sides.above)) << axis << ' ' << plane;
    ASSERT_TRUE(is_empty(sides.below) || sides.below.max[axis] <= plane);
    ASSERT_TRUE(is_empty(sides.above) || sides.above.min[axis] >= plane);
    for (int point = 0; point < 100; ++point) {
      const Vec3d at = on_surface(chance_, primitive).at;
      ASSERT_TRUE(at[axis] >= plane - rounding || contains(grown(sides.below, rounding), at))
          << masu::described(at);
      ASSERT_TRUE(at[axis] <= plane + rounding || contains(grown(sides.above, rounding), at))
          << masu::described(at);
    }
  };
  for (int count = 0; count < 2000; ++count) {
    const double scale = std::pow(10.0, chance_.uniform(-6, 6));
    parts_hold_the_surface(random_triangle<double>(chance_, scale));
    parts_hold_the_surface(random_sphere_case<double>(chance_, scale).primitive);
    parts_hold_the_surface(random_cone<double>(chance_, scale));
    if (HasFatalFailure()) return;
  }
}

TEST_F(PrimitivesCutByAPlane, AreAsSmallAsAShortenedCone) {
  for (int count = 0; count < 1000; ++count) {
    // A stick through the middle of the space, at least a little aslant.
    Vec3d along = chance_.direction();
    const int axis = chance_.whole(0, 2);
    if (std::abs(along[axis]) < 0.1) continue;
    const Cone<double> stick{along * -1.0, 0.01, along, 0.01};
    const double share = chance_.uniform(-0.9, 0.9);
    const double plane = along[axis] * share;
    const ClippedBounds sides = sides_of(stick, axis, plane, plane);
    const Vec3d end = along * (along[axis] > 0 ? -1.0 : 1.0), middle = along * share;
    // Around where the plane cuts the stick the part reaches a radius over the cut's slant farther.
    const Boxd expected = grown(join(Boxd{end, end}, middle), 0.01 + 0.02 / std::abs(along[axis]));
    EXPECT_TRUE(contains(expected, sides.below.min) && contains(expected, sides.below.max));
  }
}

TEST_F(PrimitivesCutByAPlane, AreTheSameBitsInLanes) {
  const auto are_the_same = [&](const auto& primitive, double margin) {
    const Boxd whole = bounds(primitive);
    const int axis = chance_.whole(0, 2);
    const double plane = chance_.one_in(3) ? chance_.one_of({whole.min, whole.max})[axis]
                                           : chance_.uniform(whole.min[axis], whole.max[axis]);
    const Sides expected = sides_with_margin(primitive, axis, plane, margin);
    const LaneSides sides = ClippedLanes(primitive).sides(axis, plane, margin);
    const auto expect_box = [&](const Boxf& box, const LaneBox& lanes) {
      for (int i = 0; i < 3 && !is_empty(box); ++i) {
        EXPECT_EQ(box.min[i], lanes.low[i]);
        EXPECT_EQ(box.max[i], lanes.high[i]);
      }
      EXPECT_EQ(is_empty(box), lanes.low[axis] > lanes.high[axis]);
    };
    expect_box(expected.below, sides.below);
    expect_box(expected.above, sides.above);
  };
  for (int count = 0; count < 20000 && !HasFailure(); ++count) {
    const double scale = std::pow(10.0, chance_.uniform(-6, 6)),
                 margin = chance_.one_in(2) ? 0 : 1e-6 * scale;
    are_the_same(random_triangle<double>(chance_, scale), margin);
    are_the_same(random_cone<double>(chance_, scale), margin);
  }
}

} // namespace
} // namespace masu
