// A tree after M. Aono and T. L. Kunii, "Botanical Tree Image Generation", IEEE CG&A 4(5), 1984: every branch
// ends in a round knot and forks in two.
#include "libscene/spd/scenes.h"

#include <array>

namespace masu::spd {

namespace {

constexpr double taper = 0.67; // the ratio of a branch's radii at its end and its base

struct Branch {
  Vec3d base;
  Frame frame;   // z: from the branch's base to its end
  double radius; // at the base
};

// A child's frame in its parent's: rotated about the parent's x axis, then about its z axis, and scaled.
Frame forked(double tilt_degrees, double turn_degrees, double scale) {
  const auto placed = [&](const Vec3d& axis) {
    return rotated(rotated(axis, x_axis, radians(tilt_degrees)), z_axis, radians(turn_degrees)) * scale;
  };
  return {placed(x_axis), placed(y_axis), placed(z_axis)};
}

using Forks = std::array<Frame, 2>;

void put_branch(NffWriter& nff, const Forks& forks, const Branch& branch, int depth) {
  const auto& [base, frame, radius] = branch;
  const Vec3d end = base + frame.z;
  const double end_radius = radius * taper;
  put_cone(nff, base, radius, end, end_radius);
  put_sphere(nff, end, end_radius);
  if (depth == 0) return;
  for (const Frame& f : forks) {
    const Frame child = {from_frame(frame, f.x), from_frame(frame, f.y), from_frame(frame, f.z)};
    put_branch(nff, forks, {end, child, end_radius}, depth - 1);
  }
}

} // namespace

void write_tree(NffWriter& nff, int size, bool background) {
  put_view(nff, {{4.5, 0.4, 2}, {0, 0, 1.5}, z_axis, 1});
  put_lights(nff, {{-5, 5, 50},
                   {30, -30, 30},
                   {-40, -30, 20},
                   {10, 30, 40},
                   {-30, 40, 10},
                   {50, 25, 20},
                   {-10, -60, 30}});
  if (background) {
    put_material(nff, {0.2, 0.7, 0.2, 1, 0, 100000, 0, 0});
    put_polygon(nff, {{50, 50, 0}, {-50, 50, 0}, {-50, -50, 0}, {50, -50, 0}});
  }
  put_material(nff, {0.55, 0.4, 0.2, 1, 0, 100000, 0, 0});
  const Forks forks = {forked(40, 90, 0.65), forked(25, 230, 0.70)};
  put_branch(nff, forks, {{0, 0, 0}, {x_axis, y_axis, z_axis}, 0.15}, size);
}

} // namespace masu::spd
