// Closed meshes are watertight.
#include "stability/random_mesh.h"
#include "tests/random_test.h"
#include "tests/ray_case.h"

namespace masu {
namespace {

template <class Real>
class RayAndMesh : public RandomTest {};
TYPED_TEST_SUITE(RayAndMesh, Reals);

// The side of an edge is decided exactly, so that a hit doesn't depend on the corners' order or winding. (t
// may differ in its last bits: its sums are rounded in another order.)
TYPED_TEST(RayAndMesh, HitIsIndependentOfTheOrderOfCorners) {
  using Real = TypeParam;
  Chance& chance = this->chance_;
  double worst = 0;
  for (std::int64_t i = cases(200'000); i > 0; --i) {
    const auto c = random_triangle_case<Real>(chance, chance.power_of_two(-10, 20));
    const WatertightRay<Real> ray = prepared(c.origin, c.direction);
    const std::array corners{c.primitive.a, c.primitive.b, c.primitive.c};
    Real first = 0;
    const bool met = intersect(ray, c.primitive, first);
    for (const auto& order :
         {std::array{0U, 2U, 1U}, {1U, 0U, 2U}, {1U, 2U, 0U}, {2U, 0U, 1U}, {2U, 1U, 0U}}) {
      Real t = 0;
      const Triangle<Real> turned = triangle_of(corners[order[0]], corners[order[1]], corners[order[2]]);
      ASSERT_EQ(intersect(ray, turned, t), met) << case_described(c);
      if (met) worst = std::max(worst, std::abs(static_cast<double>(t - first)) / c.unit);
    }
  }
  this->RecordProperty("worst_difference_of_t_in_uM", std::to_string(worst));
  EXPECT_LE(worst, 2 * triangle_error);
}

// Any numbers in the range of Real; or on a raster so coarse that differences are exact, too.
template <class Real>
Mesh<Real> placed(Chance& chance, const Mesh<double>& mesh, bool raster, Vec3<Real>& origin) {
  const double scale = chance.power_of_two(-10, 20),
               unit = raster ? std::exp2(std::round(std::log2(scale))) : scale;
  const Vec3d at = raster ? Vec3d{0, 0, 0} : chance.in_cube(chance.one_of({0.0, unit, 100 * unit}));
  const auto place = [&](const Vec3d& v) {
    if (!raster) return cast<Real>(at + v * unit);
    const auto round = [](double c) { return std::round(c * 1024) / 1024; };
    return cast<Real>(Vec3d{round(v.x), round(v.y), round(v.z)} * unit);
  };
  origin = place(chance.one_in(4) ? Vec3d{0, 0, 0} : chance.in_cube(0.1));
  Mesh<Real> result{{}, mesh.faces};
  for (const Vec3d& corner : mesh.corners)
    result.corners.push_back(place(corner));
  return result;
}

TYPED_TEST(RayAndMesh, ClosedMeshIsWatertightAtEdgesAndCorners) {
  using Real = TypeParam;
  Chance& chance = this->chance_;
  constexpr int rays_a_mesh = 1000;
  std::int64_t leaks = 0;
  std::string first;
  for (std::int64_t m = cases(1000); m > 0; --m) {
    Vec3<Real> origin;
    const Mesh<Real> mesh = placed<Real>(chance, random_mesh(chance), chance.one_in(2), origin);
    std::vector<Triangle<Real>> triangles;
    for (const auto& [a, b, c] : mesh.faces)
      triangles.push_back(triangle_of(mesh.corners[a], mesh.corners[b], mesh.corners[c]));
    std::size_t start = 0;
    for (int i = 0; i < rays_a_mesh; ++i) {
      const auto& face = mesh.faces[chance.index(mesh.faces.size())];
      const std::size_t corner = chance.index(3);
      const Vec3<Real> a = mesh.corners[face[corner]], b = mesh.corners[face[(corner + 1) % 3]];
      const Real share = static_cast<Real>(chance.one_of({0.0, 0.0, 0.5, 0.25, chance.uniform(0, 1)}));
      const Vec3<Real> towards = sized(chance, fma(b - a, share, a) - origin);
      const WatertightRay<Real> ray = prepared(origin, towards);
      bool met = false;
      // Starting with the face that the last ray hit: the order doesn't matter.
      for (std::size_t n = 0; n < triangles.size() && !met; ++n) {
        Real t = 0;
        met = intersect(ray, triangles[start], t) && t > 0;
        if (!met) start = start + 1 == triangles.size() ? 0 : start + 1;
      }
      if (met || ++leaks > 1) continue;
      first = described(origin, towards) + " aimed at the edge from " + described(a) + " to " + described(b);
    }
  }
  EXPECT_EQ(leaks, 0) << first;
}

} // namespace
} // namespace masu
