// Random scenes that are hard cases for grids: clusters, floors, axis-aligned planes, needles, primitives on
// faces of voxels, ties.
#pragma once

#include "stability/test_scene.h"

namespace masu {

// Triangles of about that size, anywhere within ±1, or half of them within ±crowd.
template <class Stored>
void add_triangles(TestScene<Stored>& scene, Chance& chance, int count, double size, double crowd = 1) {
  for (int i = 0; i < count; ++i) {
    const Vec3d at = chance.in_cube(1) * (chance.one_in(2) ? crowd : 1.0);
    const auto corner = [&] { return at + chance.in_cube(size); };
    const Vec3d a = corner(), b = corner(), c = corner();
    scene.add(triangle_of<Stored>(a, b, c));
  }
}

// Up to so many primitives of any kind, small and apart, within about ±1.
template <class Stored>
TestScene<Stored> scattered_scene(Chance& chance, int most) {
  TestScene<Stored> scene;
  for (int i = chance.whole(0, most); i > 0; --i) {
    const Vec3d at = chance.in_cube(1);
    const double size = chance.power_of_two(-6, -2);
    const auto corner = [&] { return at + chance.in_cube(size); };
    switch (chance.whole(0, 2)) {
    case 0:
      scene.add(triangle_of<Stored>(corner(), corner(), corner()));
      break;
    case 1:
      scene.add(sphere_of<Stored>(at, size));
      break;
    default:
      scene.add(cone_of<Stored>(corner(), size, corner(), size / 2));
    }
  }
  return scene;
}

// Each by up to so much along each axis, on its own.
template <class Stored>
void move_primitives(Chance& chance, TestScene<Stored>& scene, double most) {
  for_each_points(scene, [&](auto&... points) {
    const Vec3<Stored> by = cast<Stored>(chance.in_cube(most));
    ((points = points + by), ...);
  });
  std::erase_if(scene.cones, [](const auto& cone) { return cone.base == cone.apex; });
}

// Every primitive so many times more, before the others.
template <class Stored>
void repeat_primitives(TestScene<Stored>& scene, int times) {
  for_each_kind(scene, [&](auto& primitives) {
    const auto once = primitives;
    for (int i = 0; i < times; ++i)
      primitives.insert(primitives.begin(), once.begin(), once.end());
  });
}

// Makes scenes; everything lies within ±scale of some point.
template <class Stored>
class SceneMaker {
public:
  SceneMaker(Chance& chance, double scale) : chance_(chance), scale_(scale) {
    if (chance.one_in(3)) at_ = chance.in_cube(scale * chance.one_of({1.0, 30.0, 1000.0}));
  }

  TestScene<Stored> scene() {
    using Self = SceneMaker;
    const auto make = chance_.one_of({&Self::clustered, &Self::doubled, &Self::coplanar,
                                      &Self::floor_with_crumbs, &Self::on_a_raster, &Self::flat, &Self::mesh,
                                      &Self::needles, &Self::pointed, &Self::single, &Self::mixture});
    return (this->*make)();
  }

  // Triangles and small objects: fast to build, even with fine grids.
  TestScene<Stored> fine() {
    TestScene<Stored> scene = floor_with_crumbs();
    scene.add(mesh());
    return scene;
  }

  // Overlapping triangles in one axis-aligned plane.
  TestScene<Stored> flat() {
    TestScene<Stored> scene;
    const int axis = chance_.whole(0, 2);
    add_in_plane(scene, axis, at_[axis], 12);
    return scene;
  }
  // Cones whose tips nearly touch triangles, all perpendicular to one axis; and a last triangle as large as
  // the space.
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
    scene.add(triangle_of<Stored>(a, b, c));
  }
  void add_cone(TestScene<Stored>& scene, const Vec3d& base, double r0, const Vec3d& apex, double r1) {
    const Cone<Stored> cone = cone_of<Stored>(base, r0, apex, r1);
    if (cone.base != cone.apex && (cone.base_radius != 0 || cone.apex_radius != 0)) scene.add(cone);
  }

  // Up to so many triangles across an axis.
  void add_in_plane(TestScene<Stored>& scene, int axis, double level, int most) {
    const auto corner = [&] {
      Vec3d p = near(at_, scale_);
      p.set(axis, level);
      return p;
    };
    for (int i = chance_.whole(1, most); i > 0; --i)
      add_triangle(scene, corner(), corner(), corner());
  }

  TestScene<Stored> mixed(const Vec3d& at, double size) {
    TestScene<Stored> scene;
    const int kinds = chance_.whole(1, 7);
    for (int i = chance_.whole(1, 15); i > 0; --i) {
      const double own = size * chance_.power_of_two(-8, -1);
      const double inside = chance_.one_in(5) ? -1 : 1;
      const Vec3d here = near(at, size);
      if ((kinds & 1) != 0) add_triangle(scene, near(here, own), near(here, own), near(here, own));
      if ((kinds & 1) != 0 && chance_.one_in(4)) add_triangle(scene, here, here, here); // which nothing hits
      if ((kinds & 2) != 0) scene.add(sphere_of<Stored>(here, inside * own));
      if ((kinds & 4) != 0)
        add_cone(scene, near(here, own), inside * own * chance_.one_of({0.1, 0.5, 1.0}), near(here, own),
                 inside * own * chance_.one_of({0.0, 0.1, 0.5}));
    }
    return scene;
  }
  TestScene<Stored> mixture() { return mixed(at_, scale_); }
  // One primitive.
  TestScene<Stored> single() {
    TestScene<Stored> scene = mixture();
    const auto keep = [](auto& primitives, std::size_t most) {
      while (primitives.size() > most)
        primitives.pop_back();
      return most - primitives.size();
    };
    keep(scene.cones, keep(scene.spheres, keep(scene.triangles, 1)));
    return scene;
  }
  TestScene<Stored> clustered() {
    TestScene<Stored> scene = mixture();
    scene.add(mixed(near(at_, scale_), scale_ * chance_.power_of_two(-16, -4)));
    return scene;
  }
  // Every primitive twice or more, so that hits are ties.
  TestScene<Stored> doubled() {
    TestScene<Stored> scene = mixture();
    repeat_primitives(scene, chance_.whole(1, 3));
    return scene;
  }
  // Overlapping triangles in a few parallel, axis-aligned planes.
  TestScene<Stored> coplanar() {
    TestScene<Stored> scene;
    const int axis = chance_.whole(0, 2);
    for (int plane = chance_.whole(1, 3); plane > 0; --plane)
      add_in_plane(scene, axis, at_[axis] + chance_.uniform(-scale_, scale_), 8);
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
  // Corners on a coarse raster that spans the bounds: most lie on faces of divisions by 2, 4 or 8.
  TestScene<Stored> on_a_raster() {
    TestScene<Stored> scene;
    const double unit = std::exp2(std::round(std::log2(scale_)) - 2);
    const auto corner = [&] {
      return Vec3d{unit * chance_.whole(-4, 4), unit * chance_.whole(-4, 4), unit * chance_.whole(-4, 4)};
    };
    for (int i = chance_.whole(2, 20); i > 0; --i) {
      add_triangle(scene, corner(), corner(), corner());
      if (chance_.one_in(3)) scene.add(sphere_of<Stored>(corner() * 0.5, unit * chance_.whole(1, 2)));
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
    const auto number = [&](int x, int y) {
      return static_cast<std::size_t>(y) * static_cast<std::size_t>(side + 1) + static_cast<std::size_t>(x);
    };
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

template <class Real>
std::string described(const TestScene<Real>& scene) {
  std::string text;
  for_each_primitive(scene, [&](const auto& primitive) {
    if (text.size() < 4000) text += described(primitive) + '\n';
  });
  return text;
}

} // namespace masu
