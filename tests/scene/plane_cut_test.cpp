// The curves in which planes cut primitives, against what defines the primitives.
#include "libscene/plane_cut.h"
#include "stability/oracle/oracle.h"
#include "tests/random_scene.h"
#include "tests/random_test.h"
#include "tests/surface_point.h"

#include <numbers>

namespace masu {
namespace {

using Section = RandomTest;

constexpr double no_limit = 1e300;

PlaneCut everywhere(int axis, double position, double deviation) {
  return {axis, position, {-no_limit, -no_limit}, {no_limit, no_limit}, deviation};
}

Vec3d in_space(const PlaneCut& plane, const std::array<double, 2>& at) {
  Vec3d p{};
  p.set(plane.axis, plane.position);
  p.set(plane.axis == 0 ? 1 : 0, at[0]);
  p.set(plane.axis == 2 ? 1 : 2, at[1]);
  return p;
}

double distance_to_segment(const Vec3d& p, const Vec3d& a, const Vec3d& b) {
  return static_cast<double>(
      oracle::distance_to_segment(oracle::point(p), oracle::point(a), oracle::point(b)));
}

// How wide it is across its longest extent: a needle's section may be a point once rounded.
double thickness(const Triangle<double>& t) {
  const Vec3d n = cross(t.b - t.a, t.c - t.a);
  return length(n) / std::max({length(t.b - t.a), length(t.c - t.b), length(t.a - t.c)});
}
template <class Primitive>
double thickness(const Primitive& primitive) {
  const Boxd box = bounds(primitive);
  return length(box.max - box.min);
}

double size_of(const Boxd& box) {
  return std::max(length(box.max - box.min), largest_magnitude(box));
}

TEST_F(Section, LiesOnItsPrimitives) {
  std::size_t segments = 0;
  for (int i = 0; i < 300; ++i) {
    TestScene<double> scene = SceneMaker<double>(chance_, 1).scene();
    const Boxd box = scene.bounds();
    const int axis = chance_.whole(0, 2);
    const double position = chance_.uniform(box.min[axis], box.max[axis]);
    const PlaneCut plane = everywhere(axis, position, 1e-3);
    for (const CutSegment& segment : plane_cut_of(scene.view(), plane)) {
      ++segments;
      with_primitive(scene.view(), segment.primitive, [&](const auto& primitive) {
        for (const auto& end : {segment.from, segment.to})
          EXPECT_LE(oracle::distance(oracle::point(in_space(plane, end)), primitive), 1e-9 * size_of(box))
              << described(primitive) << " axis " << axis << " at " << position;
      });
    }
    if (HasFailure()) return;
  }
  EXPECT_GT(segments, 1000U);
}

// Any point of a primitive is near a segment of the plane through it.
TEST_F(Section, HasEveryPointOfItsPrimitives) {
  for (int i = 0; i < 400; ++i) {
    TestScene<double> scene = SceneMaker<double>(chance_, 1).scene();
    const SceneView<double> view = scene.view();
    if (view.primitive_count() == 0) continue;
    const auto index = static_cast<PrimitiveIndex>(chance_.index(view.primitive_count()));
    with_primitive(view, index, [&](const auto& primitive) {
      const Vec3d p = on_surface(chance_, primitive).at;
      const Boxd own = bounds(primitive);
      const double extent = length(own.max - own.min);
      const int axis = chance_.whole(0, 2);
      const PlaneCut plane = everywhere(axis, p[axis], 1e-4 * extent);
      double nearest = std::numeric_limits<double>::infinity();
      for (const CutSegment& segment : plane_cut_of(view, plane)) {
        if (segment.primitive == index)
          nearest = std::min(
              nearest, distance_to_segment(p, in_space(plane, segment.from), in_space(plane, segment.to)));
      }
      // Where the plane all but touches, the point may be beyond the primitive by rounding.
      const double slack = 1e-6 * size_of(own);
      const bool only_touches = p[axis] < own.min[axis] + slack || p[axis] > own.max[axis] - slack;
      if (!only_touches && thickness(primitive) > slack) {
        EXPECT_LE(nearest, 0.02 * extent)
            << described(primitive) << " axis " << axis << " at " << described(p);
      }
    });
    if (HasFailure()) return;
  }
}

TEST_F(Section, OfTheWindowHasAllThatIsInIt) {
  for (int i = 0; i < 100; ++i) {
    TestScene<double> scene = SceneMaker<double>(chance_, 1).scene();
    const Boxd box = scene.bounds();
    const int axis = chance_.whole(0, 2);
    PlaneCut plane = everywhere(axis, chance_.uniform(box.min[axis], box.max[axis]), 1e-3);
    const auto all = plane_cut_of(scene.view(), plane);
    const Vec3d a = chance_.in_box(box), b = chance_.in_box(box);
    for (std::size_t k = 0; k < 2; ++k) {
      const int along = k == 0 ? (axis == 0 ? 1 : 0) : (axis == 2 ? 1 : 2);
      plane.min[k] = std::min(a[along], b[along]);
      plane.max[k] = std::max(a[along], b[along]);
    }
    const auto some = plane_cut_of(scene.view(), plane);
    for (const CutSegment& segment : all) {
      const auto is_inside = [&](const std::array<double, 2>& p) {
        return p[0] > plane.min[0] && p[0] < plane.max[0] && p[1] > plane.min[1] && p[1] < plane.max[1];
      };
      if (!is_inside(segment.from) && !is_inside(segment.to)) continue;
      EXPECT_TRUE(std::ranges::any_of(some, [&](const CutSegment& other) {
        return other.from == segment.from && other.to == segment.to && other.primitive == segment.primitive;
      }));
    }
  }
}

double total_length(const std::vector<CutSegment>& segments) {
  double sum = 0;
  for (const CutSegment& s : segments)
    sum += std::hypot(s.to[0] - s.from[0], s.to[1] - s.from[1]);
  return sum;
}

template <class Primitive>
std::vector<CutSegment> cut(const Primitive& primitive, int axis, double position) {
  TestScene<double> scene;
  if constexpr (std::is_same_v<Primitive, Triangle<double>>) scene.triangles.push_back(primitive);
  if constexpr (std::is_same_v<Primitive, Sphere<double>>) scene.spheres.push_back(primitive);
  if constexpr (std::is_same_v<Primitive, Cone<double>>) scene.cones.push_back(primitive);
  return plane_cut_of(scene.view(), everywhere(axis, position, 1e-6));
}

TEST_F(Section, HasTheLengthsOfKnownCurves) {
  constexpr double pi = std::numbers::pi;
  const auto triangle = triangle_of<double>(Vec3d{0, 0, 0}, Vec3d{2, 0, 0}, Vec3d{0, 2, 2});
  EXPECT_DOUBLE_EQ(total_length(cut(triangle, 2, 1)), 1);
  EXPECT_DOUBLE_EQ(total_length(cut(triangle, 2, 0)), 2); // its side in the plane
  EXPECT_TRUE(cut(triangle, 2, 2).empty());               // its corner
  const auto flat = triangle_of<double>(Vec3d{0, 0, 1}, Vec3d{3, 0, 1}, Vec3d{0, 4, 1});
  EXPECT_DOUBLE_EQ(total_length(cut(flat, 2, 1)), 12);
  EXPECT_NEAR(total_length(cut(sphere_of<double>({1, 2, 3}, -5), 0, 4)), 2 * pi * 4, 1e-3);
  EXPECT_TRUE(cut(sphere_of<double>({0, 0, 0}, 1), 1, 1).empty()); // touches
  const auto cylinder = cone_of<double>({0, 0, 0}, 1, {0, 0, 3}, 1);
  EXPECT_NEAR(total_length(cut(cylinder, 2, 1.5)), 2 * pi, 1e-3);
  EXPECT_NEAR(total_length(cut(cylinder, 2, 3)), 2 * pi, 1e-3);
  EXPECT_NEAR(total_length(cut(cylinder, 0, 0.5)), 6, 1e-9); // two lines
  EXPECT_TRUE(cut(cylinder, 0, 1.01).empty());
  const auto pointed = cone_of<double>({0, 0, 0}, 1, {0, 0, 1}, 0);
  EXPECT_NEAR(total_length(cut(pointed, 2, 0.75)), 2 * pi * 0.25, 1e-3);
  EXPECT_NEAR(total_length(cut(pointed, 1, 0)), 2 * std::sqrt(2), 1e-9); // through the axis
}

} // namespace
} // namespace masu
