// The grid never shows: through any grid a ray finds the same bits as by trying every primitive.
#include "libgrid/build.h"
#include "libgrid/division.h"
#include "libgrid/grid_file.h"
#include "libgrid/trace.h"
#include "renderer/counts.h"
#include "tests/test_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

namespace masu {
namespace {

// --- Scenes ----------------------------------------------------------------------------------------------

// Puts scenes together; everything lies within ±scale of some place.
template <class Stored>
class SceneMaker {
public:
  SceneMaker(Chance& chance, double scale) : chance_(chance), scale_(scale) {
    if (chance.one_in(3)) at_ = chance.in_cube(scale * chance.one_of({1.0, 30.0, 1000.0}));
  }

  TestScene<Stored> scene() {
    switch (chance_.whole(0, 9)) {
    case 0:
      return clustered();
    case 1:
      return doubled();
    case 2:
      return coplanar();
    case 3:
      return floor_with_crumbs();
    case 4:
      return on_a_raster();
    case 5:
      return flat();
    case 6:
      return mesh();
    case 7:
      return needles();
    case 8:
      return pointed();
    default:
      return mixed(at_, scale_);
    }
  }

  // Triangles, and small things: quickly listed however fine the grid is.
  TestScene<Stored> fine() {
    TestScene<Stored> scene = floor_with_crumbs();
    const TestScene<Stored> sheet = mesh();
    scene.triangles.insert(scene.triangles.end(), sheet.triangles.begin(), sheet.triangles.end());
    return scene;
  }

  // Overlapping triangles in one plane across an axis.
  TestScene<Stored> flat() {
    TestScene<Stored> scene;
    const int axis = chance_.whole(0, 2);
    const auto corner = [&] {
      Vec3d p = near(at_, scale_);
      p.set(axis, at_[axis]);
      return p;
    };
    for (int i = chance_.whole(1, 12); i > 0; --i)
      add_triangle(scene, corner(), corner(), corner());
    return scene;
  }
  // Cones whose tips nearly touch triangles, all across the same axis; and a last triangle as large as the
  // space.
  TestScene<Stored> pointed() {
    TestScene<Stored> scene;
    const int axis = chance_.whole(0, 2);
    Vec3d along{}, side{}, other{};
    along.set(axis, 1);
    side.set((axis + 1) % 3, 1);
    other.set((axis + 2) % 3, 1);
    for (int i = chance_.whole(1, 6); i > 0; --i) {
      const Vec3d tip = near(at_, scale_ / 2);
      const double length = scale_ * chance_.uniform(0.05, 0.5), radius = scale_ * chance_.uniform(0.01, 0.5);
      const double facing = chance_.sign(), gap = scale_ * chance_.power_of_two(-50, -10);
      add_cone(scene, tip + along * (facing * length), radius, tip, 0);
      const Vec3d at = tip + along * (gap * chance_.sign());
      const double size = scale_ * 0.1;
      add_triangle(scene, at - side * size - other * size, at + side * (2 * size) - other * size,
                   at + other * (2 * size) - side * size);
    }
    const Vec3d corner = Vec3d{1, 1, 1} * (2 * scale_);
    add_triangle(scene, at_ - corner, at_ + corner, at_ + corner - side * scale_);
    return scene;
  }

private:
  Vec3d near(const Vec3d& at, double size) { return at + chance_.in_cube(size); }

  void add_triangle(TestScene<Stored>& scene, const Vec3d& a, const Vec3d& b, const Vec3d& c) {
    scene.triangles.push_back(triangle_of(cast<Stored>(a), cast<Stored>(b), cast<Stored>(c)));
  }
  void add_cone(TestScene<Stored>& scene, const Vec3d& base, double r0, const Vec3d& apex, double r1) {
    const Cone<Stored> cone = cone_of<Stored>(base, r0, apex, r1);
    if (cone.base != cone.apex && (cone.base_radius != 0 || cone.apex_radius != 0))
      scene.cones.push_back(cone);
  }

  TestScene<Stored> mixed(const Vec3d& at, double size) {
    TestScene<Stored> scene;
    const int kinds = chance_.whole(1, 7);
    for (int i = chance_.whole(1, 15); i > 0; --i) {
      const double own = size * chance_.power_of_two(-8, -1);
      const double inside = chance_.one_in(5) ? -1 : 1;
      const Vec3d here = near(at, size);
      if ((kinds & 1) != 0) add_triangle(scene, near(here, own), near(here, own), near(here, own));
      if ((kinds & 2) != 0) scene.spheres.push_back(sphere_of<Stored>(here, inside * own));
      if ((kinds & 4) != 0)
        add_cone(scene, near(here, own), inside * own * chance_.one_of({0.1, 0.5, 1.0}), near(here, own),
                 inside * own * chance_.one_of({0.0, 0.1, 0.5}));
    }
    return scene;
  }
  TestScene<Stored> clustered() {
    TestScene<Stored> scene = mixed(at_, scale_);
    const TestScene<Stored> cluster = mixed(near(at_, scale_), scale_ * chance_.power_of_two(-16, -4));
    scene.triangles.insert(scene.triangles.end(), cluster.triangles.begin(), cluster.triangles.end());
    scene.spheres.insert(scene.spheres.end(), cluster.spheres.begin(), cluster.spheres.end());
    scene.cones.insert(scene.cones.end(), cluster.cones.begin(), cluster.cones.end());
    return scene;
  }
  // Everything twice or more, so that hits are tied.
  TestScene<Stored> doubled() {
    TestScene<Stored> scene = mixed(at_, scale_);
    const auto again = [&](auto& primitives) {
      const auto once = primitives;
      for (int i = chance_.whole(1, 3); i > 0; --i)
        primitives.insert(primitives.begin(), once.begin(), once.end());
    };
    again(scene.triangles);
    again(scene.spheres);
    again(scene.cones);
    return scene;
  }
  // Overlapping triangles in a few planes across an axis.
  TestScene<Stored> coplanar() {
    TestScene<Stored> scene;
    const int axis = chance_.whole(0, 2);
    for (int plane = chance_.whole(1, 3); plane > 0; --plane) {
      const double level = at_[axis] + chance_.uniform(-scale_, scale_);
      const auto corner = [&] {
        Vec3d p = near(at_, scale_);
        p.set(axis, level);
        return p;
      };
      for (int i = chance_.whole(1, 8); i > 0; --i)
        add_triangle(scene, corner(), corner(), corner());
    }
    return scene;
  }
  TestScene<Stored> floor_with_crumbs() {
    TestScene<Stored> scene = mixed(near(at_, scale_), scale_ * chance_.power_of_two(-14, -6));
    const double far = scale_ * 2;
    const Vec3d low = at_ - Vec3d{scale_, scale_, scale_};
    add_triangle(scene, low, low + Vec3d{far, 0, 0}, low + Vec3d{far, far, 0});
    add_triangle(scene, low, low + Vec3d{far, far, 0}, low + Vec3d{0, far, 0});
    return scene;
  }
  // Corners on a coarse raster, with the raster's own bounds: most lie on faces of divisions by 2, 4 or 8.
  TestScene<Stored> on_a_raster() {
    TestScene<Stored> scene;
    const double unit = std::exp2(std::round(std::log2(scale_)) - 2);
    const auto corner = [&] {
      return Vec3d{unit * chance_.whole(-4, 4), unit * chance_.whole(-4, 4), unit * chance_.whole(-4, 4)};
    };
    for (int i = chance_.whole(2, 20); i > 0; --i) {
      add_triangle(scene, corner(), corner(), corner());
      if (chance_.one_in(3))
        scene.spheres.push_back(sphere_of<Stored>(corner() * 0.5, unit * chance_.whole(1, 2)));
      if (chance_.one_in(3))
        add_cone(scene, corner() * 0.5, unit, corner() * 0.5, unit * chance_.whole(0, 1));
    }
    add_triangle(scene, Vec3d{-4, -4, -4} * unit, Vec3d{4, 4, 4} * unit, corner());
    return scene;
  }
  // A wavy sheet whose triangles share edges.
  TestScene<Stored> mesh() {
    TestScene<Stored> scene;
    constexpr int side = 6;
    std::vector<Vec3d> corners;
    for (int y = 0; y <= side; ++y)
      for (int x = 0; x <= side; ++x)
        corners.push_back(at_ + Vec3d{(2.0 * x / side - 1) * scale_, (2.0 * y / side - 1) * scale_,
                                      chance_.uniform(-0.2, 0.2) * scale_});
    const auto number = [&](int x, int y) { return static_cast<std::size_t>(y * (side + 1) + x); };
    for (int y = 0; y < side; ++y) {
      for (int x = 0; x < side; ++x) {
        add_triangle(scene, corners[number(x, y)], corners[number(x + 1, y)], corners[number(x + 1, y + 1)]);
        add_triangle(scene, corners[number(x, y)], corners[number(x + 1, y + 1)], corners[number(x, y + 1)]);
      }
    }
    return scene;
  }
  TestScene<Stored> needles() {
    TestScene<Stored> scene;
    for (int i = chance_.whole(3, 20); i > 0; --i) {
      const Vec3d a = near(at_, scale_), b = near(at_, scale_);
      const Vec3d c =
          a + (b - a) * chance_.uniform(-0.2, 1.2) + chance_.in_cube(scale_ * chance_.power_of_two(-50, -6));
      add_triangle(scene, a, b, c);
    }
    return scene;
  }
  Chance& chance_;
  double scale_;
  Vec3d at_{0, 0, 0};
};

// --- Grids -----------------------------------------------------------------------------------------------

template <class Stored>
Lattice random_lattice(Chance& chance, const Boxd& bounds) {
  const auto voxels = [&] {
    if (chance.one_in(3)) return std::int32_t{1} << chance.whole(0, 5);
    return chance.whole(1, 64);
  };
  return {space_of<Stored>(bounds, chance.one_in(2) ? SpaceRule::tight : SpaceRule::cube),
          {voxels(), voxels(), voxels()},
          rounding_margin<Stored>(bounds)};
}

// The same grid with a map of two levels, which the builder makes for large divisions only.
Grid in_blocks(const Grid& grid, std::int32_t block_log2) {
  Grid blocked{grid.lattice, block_log2, {}, grid.cells, grid.references};
  const Vec3i blocks = blocks_of(grid.lattice.division, block_log2);
  const std::size_t words = std::size_t{1} << (3 * block_log2);
  blocked.voxel_map.assign(voxel_count(blocks), 0);
  std::uint32_t count = 0;
  for_each_voxel({{0, 0, 0}, grid.lattice.division - Vec3i{1, 1, 1}}, [&](const Vec3i& voxel) {
    const std::uint32_t word = grid.voxel_map[linear_index(voxel, grid.lattice.division)];
    if ((word & occupied_bit) == 0) return;
    std::uint32_t& block = blocked.voxel_map[linear_index(
        {voxel.x >> block_log2, voxel.y >> block_log2, voxel.z >> block_log2}, blocks)];
    if (block == 0) block = occupied_bit | count++;
    const std::size_t begin = voxel_count(blocks) + (block & ~occupied_bit) * words;
    if (blocked.voxel_map.size() < begin + words) blocked.voxel_map.resize(begin + words, 0);
    blocked.voxel_map[begin + index_in_block(voxel, block_log2)] = word;
  });
  return blocked;
}

template <class Stored>
Grid random_grid(Chance& chance, const SceneView<Stored>& scene, const Boxd& bounds) {
  const Overlap overlap = chance.one_in(2) ? Overlap::exact : Overlap::box;
  const Grid grid = build_uniform(scene, random_lattice<Stored>(chance, bounds), overlap);
  return grid.block_log2 == 0 && chance.one_in(2) ? in_blocks(grid, chance.whole(1, 5)) : grid;
}

std::string described(const Grid& grid) {
  const Boxd& s = grid.lattice.space;
  const Vec3i n = grid.lattice.division;
  return "space " + masu::described(s.min) + masu::described(s.max) + " division " + std::to_string(n.x) +
         'x' + std::to_string(n.y) + 'x' + std::to_string(n.z) + " blocks of 2^" +
         std::to_string(grid.block_log2);
}

// --- Rays ------------------------------------------------------------------------------------------------

template <class Real>
class RayMaker {
public:
  RayMaker(Chance& chance, const TestScene<Real>& scene, const Boxd& bounds, const Lattice& lattice)
      : chance_(chance), scene_(scene), bounds_(bounds), lattice_(lattice) {}

  Ray<Real> ray() {
    const Vec3<Real> target = place();
    Vec3<Real> origin = chance_.one_in(4) ? afar(target) : place();
    // Along an axis, or across one: through the target's own coordinates.
    if (chance_.one_in(3)) {
      const int axis = chance_.whole(0, 2);
      origin.set(axis, target[axis]);
      if (chance_.one_in(2)) origin.set((axis + 1) % 3, target[(axis + 1) % 3]);
    }
    if (origin == target) origin = cast<Real>(chance_.in_box(padded()));
    Vec3<Real> direction = sized(target - origin);
    for (int axis = 0; axis < 3; ++axis) {
      if (direction[axis] == 0 && chance_.one_in(4)) direction.set(axis, Real(-0.0));
      if (direction[axis] == 0 && chance_.one_in(4)) direction.set(axis, tiny());
    }
    return {origin, direction,
            chance_.one_in(4) ? static_cast<Real>(size() * chance_.power_of_two(-6, 3))
                              : RealTraits<Real>::largest};
  }

private:
  Boxd padded() const { return padded_bounds<Real>(bounds_); }
  double size() const { return largest_magnitude(bounds_.max - bounds_.min); }

  static Vec3<Real> sized(const Vec3<Real>& v) {
    int exponent = 0;
    std::frexp(largest_magnitude(v), &exponent);
    const Vec3<Real> scaled{std::ldexp(v.x, -exponent), std::ldexp(v.y, -exponent),
                            std::ldexp(v.z, -exponent)};
    return largest_magnitude(scaled) == 0 ? Vec3<Real>{1, 0, 0} : scaled;
  }

  Real tiny() {
    constexpr double lowest = std::is_same_v<Real, float> ? -148 : -1072;
    return static_cast<Real>(chance_.sign() * chance_.power_of_two(lowest, -20));
  }

  // As the walk computes it.
  Real plane(int axis) {
    const Real at = static_cast<Real>(chance_.whole(0, lattice_.division[axis]));
    return fused(at, static_cast<Real>(voxel_size(lattice_)[axis]),
                 static_cast<Real>(lattice_.space.min[axis]));
  }

  // Anywhere; on the lattice's faces, edges and corners; on corners, edges and centers of primitives.
  Vec3<Real> place() {
    Vec3<Real> p = cast<Real>(chance_.in_box(padded()));
    switch (chance_.whole(0, 5)) {
    case 0:
      for (int axis = 0; axis < 3; ++axis)
        if (chance_.one_in(2)) p.set(axis, plane(axis));
      return p;
    case 1:
    case 2:
      if (!scene_.triangles.empty()) {
        const auto& t = scene_.triangles[chance_.index(scene_.triangles.size())];
        const Real share = static_cast<Real>(chance_.one_of({0.0, 0.5, chance_.uniform(0, 1)}));
        p = fused(t.b - t.a, share, t.a);
        if (chance_.one_in(2)) p = fused(t.c - p, static_cast<Real>(chance_.uniform(0, 1)), p);
      }
      return p;
    case 3:
      if (!scene_.cones.empty()) {
        const auto& c = scene_.cones[chance_.index(scene_.cones.size())];
        p = chance_.one_in(2) ? c.base : c.apex;
        if (chance_.one_in(2))
          p = cast<Real>(cast<double>(p) + chance_.in_cube(size() * chance_.power_of_two(-50, -1)));
      }
      return p;
    case 4:
      if (!scene_.spheres.empty()) {
        const auto& s = scene_.spheres[chance_.index(scene_.spheres.size())];
        p = cast<Real>(cast<double>(s.center) + chance_.direction() * static_cast<double>(s.radius));
      }
      return p;
    default:
      return p;
    }
  }

  Vec3<Real> afar(const Vec3<Real>& target) {
    return cast<Real>(cast<double>(target) + chance_.direction() * (size() * chance_.power_of_two(0, 23.25)));
  }

  Chance& chance_;
  const TestScene<Real>& scene_;
  const Boxd& bounds_;
  const Lattice& lattice_;
};

// --- Hits ------------------------------------------------------------------------------------------------

template <class Real>
bool same_bits(Real a, Real b) {
  if constexpr (std::is_same_v<Real, float>) {
    return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
  } else {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
  }
}

template <class Real>
std::string described(const Hit<Real>& hit) {
  return "primitive " + std::to_string(static_cast<std::int32_t>(hit.primitive)) + " at " +
         masu::described(hit.t);
}
template <class Real>
std::string described(const TestScene<Real>& scene) {
  std::string text;
  const auto add = [&](const auto& primitives) {
    for (const auto& primitive : primitives)
      if (text.size() < 4000) text += masu::described(primitive) + '\n';
  };
  add(scene.triangles);
  add(scene.spheres);
  add(scene.cones);
  return text;
}

template <class Real>
class Walk : public testing::Test {
protected:
  // Counts the rays whose answer depends on whether there is a grid.
  void compare(Chance& chance, TestScene<Real>& scene, const Grid& grid, int rays_to_try) {
    const Boxd bounds = scene.bounds();
    RayMaker<Real> rays(chance, scene, bounds, grid.lattice);
    compare_each(chance, scene, grid, rays_to_try, [&] { return rays.ray(); });
  }
  template <class MakeRay>
  void compare_each(Chance& chance, TestScene<Real>& scene, const Grid& grid, int rays_to_try,
                    const MakeRay& make_ray) {
    const SceneView<Real> view = scene.view();
    const GridView<Real> grid_view = view_of<Real>(grid);
    for (int i = 0; i < rays_to_try; ++i) {
      Ray<Real> ray = make_ray();
      NoCounts counts;
      const Hit<Real> expected = nearest_hit<with_all_kinds>(view, NoGrid{}, ray, counts);
      const Hit<Real> found = nearest_hit<with_all_kinds>(view, grid_view, ray, counts);
      hits_ += expected.primitive != no_primitive;
      const bool same = found.primitive == expected.primitive && same_bits(found.t, expected.t);
      // Anything nearer than about the hit, or the whole ray.
      if (expected.primitive != no_primitive && chance.one_in(2))
        ray.t_max = chance.one_of({expected.t, nudged(expected.t, 1), expected.t * 2, expected.t / 2});
      const bool same_shadow = is_blocked<with_all_kinds>(view, grid_view, ray, counts) ==
                               is_blocked<with_all_kinds>(view, NoGrid{}, ray, counts);
      if ((same && same_shadow) || ++different_ > 1) continue;
      first_ = masu::described(ray.origin, ray.direction) + " t_max " + masu::described(ray.t_max) + ": " +
               described(found) + ", expected " + described(expected) + "; " + described(grid) + '\n' +
               described(scene);
    }
  }

  RandomSeed seed_;
  std::int64_t hits_ = 0, different_ = 0;
  std::string first_;
};
using Arithmetics = testing::Types<float, double>;
TYPED_TEST_SUITE(Walk, Arithmetics);

TYPED_TEST(Walk, FindsTheHitsOfTryingEveryPrimitive) {
  using Real = TypeParam;
  SCOPED_TRACE(this->seed_.trace());
  Chance chance(this->seed_);
  for (std::int64_t s = cases(2000); s > 0; --s) {
    TestScene<Real> scene = SceneMaker<Real>(chance, chance.power_of_two(-10, 20)).scene();
    const Grid grid = random_grid(chance, scene.view(), scene.bounds());
    this->compare(chance, scene, grid, 300);
  }
  EXPECT_EQ(this->different_, 0) << this->first_;
  EXPECT_GT(this->hits_, cases(100'000));
}

// Edge-on to triangles in a plane, but for the smallest numbers.
TYPED_TEST(Walk, FindsThemAlongDirectionsWithTinyComponents) {
  using Real = TypeParam;
  SCOPED_TRACE(this->seed_.trace());
  Chance chance(this->seed_);
  constexpr double lowest = std::is_same_v<Real, float> ? -148 : -1072;
  for (std::int64_t s = cases(1000); s > 0; --s) {
    TestScene<Real> scene = SceneMaker<Real>(chance, 1).flat();
    const Boxd bounds = scene.bounds();
    const Grid grid = random_grid(chance, scene.view(), bounds);
    int across_plane = 0;
    for (int axis = 0; axis < 3; ++axis)
      if (bounds.min[axis] == bounds.max[axis]) across_plane = axis;
    const auto place = [&] { return cast<Real>(chance.in_box(bounds)); };
    this->compare_each(chance, scene, grid, 200, [&] {
      const Vec3<Real> origin = place();
      Vec3<Real> direction = place() - origin;
      direction.set(across_plane, static_cast<Real>(chance.sign() * chance.power_of_two(lowest, lowest / 2)));
      return Ray<Real>{origin, direction, RealTraits<Real>::largest};
    });
  }
  EXPECT_EQ(this->different_, 0) << "of " << this->hits_ << " hits: " << this->first_;
}

// Close to the tip, where all roots of the cone's quadratic meet; the grid's planes pass by it.
TYPED_TEST(Walk, FindsThemAtTheTipsOfCones) {
  using Real = TypeParam;
  SCOPED_TRACE(this->seed_.trace());
  Chance chance(this->seed_);
  for (std::int64_t s = cases(1000); s > 0; --s) {
    TestScene<Real> scene = SceneMaker<Real>(chance, 1).pointed();
    const Boxd bounds = scene.bounds();
    const Lattice lattice = random_lattice<Real>(chance, bounds);
    const Vec3d size = voxel_size(lattice);
    for (std::size_t i = 0; i < scene.cones.size(); ++i) {
      Cone<Real>& cone = scene.cones[i];
      Triangle<Real>& triangle = scene.triangles[i];
      for (int axis = 0; axis < 3; ++axis) {
        const double at = static_cast<double>(cone.apex[axis]);
        const double number = std::round((at - lattice.space.min[axis]) / size[axis]);
        if (number < 1 || number > lattice.division[axis] - 1) continue; // the space's own
        const double plane = lattice.space.min[axis] + size[axis] * number;
        const auto beside = [&] {
          return static_cast<Real>(plane + chance.sign() * chance.power_of_two(-40, -24));
        };
        const bool is_round = cone.base[axis] == cone.apex[axis];
        cone.apex.set(axis, beside());
        if (is_round) {
          cone.base.set(axis, cone.apex[axis]);
          continue;
        }
        const Real level = beside();
        for (Vec3<Real>* const corner : {&triangle.a, &triangle.b, &triangle.c})
          corner->set(axis, level);
      }
    }
    const Grid grid = build_uniform(scene.view(), lattice, Overlap::exact);
    this->compare_each(chance, scene, grid, 200, [&] {
      const Cone<Real>& cone = scene.cones[chance.index(scene.cones.size())];
      const Vec3d tip = cast<double>(cone.apex), axis = normalized(cast<double>(cone.base) - tip);
      const Vec3d off = chance.in_cube(chance.power_of_two(-40, -20));
      const Vec3d towards = axis * chance.sign() + chance.in_cube(chance.power_of_two(-60, -20));
      const Vec3<Real> direction = cast<Real>(normalized(towards));
      return Ray<Real>{cast<Real>(tip + off - cast<double>(direction) * 0.01), direction,
                       RealTraits<Real>::largest};
    });
  }
  EXPECT_EQ(this->different_, 0) << "of " << this->hits_ << " hits: " << this->first_;
}

// So fine that the builder makes a map of two levels by itself.
TYPED_TEST(Walk, FindsThemThroughMillionsOfVoxels) {
  using Real = TypeParam;
  SCOPED_TRACE(this->seed_.trace());
  Chance chance(this->seed_);
  for (std::int64_t s = std::max<std::int64_t>(cases(4), 1); s > 0; --s) {
    TestScene<Real> scene = SceneMaker<Real>(chance, 1).fine();
    const Boxd bounds = scene.bounds();
    const Lattice lattice{space_of<Real>(bounds, SpaceRule::tight),
                          {chance.whole(200, 300), chance.whole(200, 300), chance.whole(250, 300)},
                          rounding_margin<Real>(bounds)};
    const Grid grid = build_uniform(scene.view(), lattice, Overlap::exact);
    ASSERT_GT(grid.block_log2, 0);
    this->compare(chance, scene, grid, 3000);
  }
  EXPECT_EQ(this->different_, 0) << this->first_;
  EXPECT_GT(this->hits_, cases(1000));
}

// Code that is compiled for fewer kinds of primitives does the same.
TYPED_TEST(Walk, FindsTheSameWithoutTheCodeForAbsentKinds) {
  using Real = TypeParam;
  SCOPED_TRACE(this->seed_.trace());
  Chance chance(this->seed_);
  for (std::int64_t s = cases(200); s > 0; --s) {
    TestScene<Real> scene = SceneMaker<Real>(chance, 1).scene();
    if (chance.one_in(3)) scene.triangles.clear();
    if (chance.one_in(3)) scene.spheres.clear();
    if (chance.one_in(2)) scene.cones.clear();
    if (scene.count() == 0) continue;
    const SceneView<Real> view = scene.view();
    const Boxd bounds = scene.bounds();
    const Grid grid = random_grid(chance, view, bounds);
    const GridView<Real> grid_view = view_of<Real>(grid);
    RayMaker<Real> rays(chance, scene, bounds, grid.lattice);
    for (int i = 0; i < 100; ++i) {
      const Ray<Real> ray = rays.ray();
      NoCounts counts;
      const Hit<Real> expected = nearest_hit<with_all_kinds>(view, grid_view, ray, counts);
      const auto expect_same = [&](const Hit<Real>& hit) {
        ASSERT_TRUE(hit.primitive == expected.primitive && same_bits(hit.t, expected.t));
      };
      if (scene.spheres.empty() && scene.cones.empty())
        expect_same(nearest_hit<with_triangles>(view, grid_view, ray, counts));
      if (scene.triangles.empty() && scene.cones.empty())
        expect_same(nearest_hit<with_spheres>(view, grid_view, ray, counts));
      if (scene.cones.empty())
        expect_same(nearest_hit<with_triangles | with_spheres>(view, grid_view, ray, counts));
    }
  }
}

// The nearest hit by definition: of all primitives' own hits the least t, and there the lowest number.
TYPED_TEST(Walk, TiesGoToTheLowestPrimitive) {
  using Real = TypeParam;
  SCOPED_TRACE(this->seed_.trace());
  Chance chance(this->seed_);
  std::int64_t ties = 0;
  for (std::int64_t s = cases(300); s > 0; --s) {
    TestScene<Real> scene = SceneMaker<Real>(chance, 1).scene();
    const auto again = [](auto& primitives) {
      const auto once = primitives;
      primitives.insert(primitives.end(), once.begin(), once.end());
    };
    again(scene.triangles);
    again(scene.spheres);
    again(scene.cones);
    const SceneView<Real> view = scene.view();
    const Boxd bounds = scene.bounds();
    const Grid grid = random_grid(chance, view, bounds);
    const GridView<Real> grid_view = view_of<Real>(grid);
    RayMaker<Real> rays(chance, scene, bounds, grid.lattice);
    for (int i = 0; i < 100; ++i) {
      Ray<Real> ray = rays.ray();
      ray.t_max = RealTraits<Real>::largest;
      if (!contains(view.clip, ray.origin)) continue; // a ray from inside isn't changed before it is tested
      NoCounts counts;
      const RayFrame<Real> frame = ray_frame(ray.origin, ray.direction);
      Hit<Real> expected{ray.t_max, no_primitive};
      for (std::uint32_t p = 0; p < scene.count(); ++p) {
        Real t = 0;
        if (!intersect<with_all_kinds>(view, frame, p, t, counts)) continue;
        ties += t == expected.t;
        if (t < expected.t) expected = {t, p};
      }
      const Hit<Real> found = nearest_hit<with_all_kinds>(view, grid_view, ray, counts);
      ASSERT_TRUE(found.primitive == expected.primitive && same_bits(found.t, expected.t))
          << masu::described(ray.origin, ray.direction) << ": " << described(found) << ", expected "
          << described(expected) << "; " << described(grid) << '\n'
          << described(scene);
      if (expected.primitive == no_primitive) continue;
      // t_max itself isn't reached, by either question.
      for (const bool beyond : {false, true}) {
        ray.t_max = beyond ? nudged(expected.t, 1) : expected.t;
        const Hit<Real> up_to = nearest_hit<with_all_kinds>(view, grid_view, ray, counts);
        ASSERT_EQ(up_to.primitive, beyond ? expected.primitive : no_primitive);
        ASSERT_TRUE(same_bits(up_to.t, expected.t));
        ASSERT_EQ(is_blocked<with_all_kinds>(view, grid_view, ray, counts), beyond);
      }
    }
  }
  EXPECT_GT(ties, cases(100));
}

// --- The way through the cells ---------------------------------------------------------------------------

// Walks to the end of the space, or until it must have lost its way.
template <class Real>
struct WholeWalk {
  std::int64_t most_steps;
  Real leave = RealTraits<Real>::largest; // of the space; blocks at its end reach beyond
  std::int64_t steps = 0;
  double largest_fall = 0; // of the exits' distances
  Real last = 0;

  void cell(std::uint32_t, std::uint32_t) {}
  void empty_cell(std::uint64_t) {}
  bool done(Real exit) {
    exit = smaller(exit, leave);
    if (++steps > 1 && exit < last)
      largest_fall = std::max(largest_fall, static_cast<double>(last) - static_cast<double>(exit));
    last = exit;
    return steps > most_steps;
  }
};

TYPED_TEST(Walk, EndsAndGoesForward) {
  using Real = TypeParam;
  SCOPED_TRACE(this->seed_.trace());
  Chance chance(this->seed_);
  for (std::int64_t s = cases(400); s > 0; --s) {
    TestScene<Real> scene = SceneMaker<Real>(chance, chance.power_of_two(-10, 20)).scene();
    const SceneView<Real> view = scene.view();
    const Boxd bounds = scene.bounds();
    const Grid grid = random_grid(chance, view, bounds);
    const GridView<Real> grid_view = view_of<Real>(grid);
    const Vec3i n = grid.lattice.division;
    RayMaker<Real> rays(chance, scene, bounds, grid.lattice);
    for (int i = 0; i < 100; ++i) {
      const Ray<Real> ray = rays.ray();
      ClippedRay<Real> clipped;
      if (!clip(ray, view.clip, clipped)) continue;
      WholeWalk<Real> whole{n.x + n.y + n.z};
      for (int axis = 0; axis < 3; ++axis) {
        const Real d = clipped.ray.direction[axis], past = static_cast<Real>(n[axis]);
        const Real face =
            d > 0 ? fused(past, grid_view.voxel_size[axis], grid_view.min[axis]) : grid_view.min[axis];
        if (d != 0) whole.leave = smaller(whole.leave, (face - clipped.ray.origin[axis]) / d);
      }
      walk(grid_view, clipped.ray.origin, clipped.ray.direction, whole);
      ASSERT_LE(whole.steps, whole.most_steps)
          << described(grid) << masu::described(ray.origin, ray.direction);
      if (grid.block_log2 == 0) {
        ASSERT_EQ(whole.largest_fall, 0) << described(grid) << masu::described(ray.origin, ray.direction);
      } else {
        // After an empty block the place along the other axes is computed anew: off by a rounding.
        double slowest = 1;
        for (int axis = 0; axis < 3; ++axis) {
          const double d = std::abs(static_cast<double>(clipped.ray.direction[axis]));
          if (d > 0) slowest = std::min(slowest, d);
        }
        ASSERT_LE(whole.largest_fall * slowest, grid.lattice.margin)
            << described(grid) << masu::described(ray.origin, ray.direction);
      }
    }
  }
}

// What a blind or hostile caller may hand over: every walk still ends.
TYPED_TEST(Walk, EndsForRaysOfAnyNumbers) {
  using Real = TypeParam;
  SCOPED_TRACE(this->seed_.trace());
  Chance chance(this->seed_);
  TestScene<Real> scene;
  scene.triangles.push_back(triangle_of<Real>({0, 0, 0}, {1, 0, 0}, {0, 1, 1}));
  scene.spheres.push_back({{0, 0, 0}, Real(0.5)});
  const SceneView<Real> view = scene.view();
  const Boxd bounds = scene.bounds();
  const auto number = [&]() -> Real {
    constexpr Real infinity = std::numeric_limits<Real>::infinity();
    return chance.one_of<Real>(
        {0, Real(-0.0), 1, -1, Real(0.5), infinity, -infinity, std::numeric_limits<Real>::quiet_NaN(),
         std::numeric_limits<Real>::denorm_min(), RealTraits<Real>::largest, -RealTraits<Real>::largest,
         RealTraits<Real>::smallest_normal, static_cast<Real>(chance.uniform(-1, 1))});
  };
  for (const std::int32_t block_log2 : {0, 2}) {
    Grid grid = build_uniform(
        view, {space_of<Real>(bounds, SpaceRule::tight), {5, 6, 7}, rounding_margin<Real>(bounds)},
        Overlap::exact);
    if (block_log2 > 0) grid = in_blocks(grid, block_log2);
    const GridView<Real> grid_view = view_of<Real>(grid);
    for (std::int64_t i = cases(50'000); i > 0; --i) {
      const Ray<Real> ray{{number(), number(), number()}, {number(), number(), number()}, number()};
      NoCounts counts;
      nearest_hit<with_all_kinds>(view, grid_view, ray, counts);
      WholeWalk<Real> whole{5 + 6 + 7};
      walk(grid_view, ray.origin, ray.direction, whole);
      ASSERT_LE(whole.steps, whole.most_steps) << masu::described(ray.origin, ray.direction);
    }
  }
}

} // namespace
} // namespace masu
