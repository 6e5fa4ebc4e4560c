// M. Newell's teapot (1975) on a checkerboard: 32 bicubic Bezier patches, each of n x n quadrilaterals in two
// triangles with normals. The body is four quarters of a solid of revolution, handle and spout two halves
// each.
#include "libscene/spd/scenes.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace masu::spd {

namespace {

using Cubic = std::array<Vec3d, 4>;
using Patch = std::array<Cubic, 4>; // [row along the profile][column about the axis]

// A control point of a profile: its distance from the axis, its height, and the distance along the tangent to
// the next control point about the axis.
struct ProfilePoint {
  double radius, height, tangent;
};
using Profile = std::array<ProfilePoint, 4>;

constexpr double circle = 0.56; // Newell's tangent length for a circle of radius 1

constexpr ProfilePoint circular(double radius, double height) {
  return {radius, height, circle * radius};
}

constexpr Profile rim = {
    {circular(1.4, 2.4), circular(1.3375, 2.53125), circular(1.4375, 2.53125), circular(1.5, 2.4)}};
constexpr Profile upper_body = {
    {circular(1.5, 2.4), circular(1.75, 1.875), circular(2, 1.35), circular(2, 0.9)}};
constexpr Profile lower_body = {
    {circular(2, 0.9), circular(2, 0.45), circular(1.5, 0.225), circular(1.5, 0.15)}};
constexpr Profile knob = {{{0, 3.15, 0}, {0.8, 3.15, 0.45}, {0, 2.85, 0}, circular(0.2, 2.7)}};
constexpr Profile lid = {{circular(0.2, 2.7), circular(0.4, 2.55), circular(1.3, 2.55), circular(1.3, 2.4)}};
constexpr Profile bottom = {{{0, 0, 0}, circular(1.425, 0), circular(1.5, 0.075), circular(1.5, 0.15)}};

// A cross-section of half the handle or spout: its ends in the plane y = 0, and its bulge from that plane.
struct Section {
  double first_x, first_z, last_x, last_z, bulge;
};
using Tube = std::array<Section, 4>;

constexpr Tube upper_handle = {{{-1.6, 2.025, -1.5, 2.25, 0.3},
                                {-2.3, 2.025, -2.5, 2.25, 0.3},
                                {-2.7, 2.025, -3, 2.25, 0.3},
                                {-2.7, 1.8, -3, 1.8, 0.3}}};
constexpr Tube lower_handle = {{{-2.7, 1.8, -3, 1.8, 0.3},
                                {-2.7, 1.575, -3, 1.35, 0.3},
                                {-2.5, 1.125, -2.65, 0.9375, 0.3},
                                {-2, 0.9, -1.9, 0.6, 0.3}}};
constexpr Tube lower_spout = {{{1.7, 1.425, 1.7, 0.6, 0.66},
                               {2.6, 1.425, 3.1, 0.825, 0.66},
                               {2.3, 2.1, 2.4, 2.025, 0.25},
                               {2.7, 2.4, 3.3, 2.4, 0.25}}};
constexpr Tube upper_spout = {{{2.7, 2.4, 3.3, 2.4, 0.25},
                               {2.8, 2.475, 3.525, 2.49375, 0.25},
                               {2.9, 2.475, 3.45, 2.5125, 0.15},
                               {2.8, 2.4, 3.2, 2.4, 0.15}}};

// The sense of the columns of a solid of revolution, seen from above.
constexpr double clockwise = -1, counterclockwise = 1;

// The quarter that starts at +x.
Patch quarter(const Profile& profile, double sense) {
  Patch patch{};
  for (std::size_t row = 0; row < 4; ++row) {
    const auto [radius, height, tangent] = profile[row];
    patch[row] = {{{radius, 0, height},
                   {radius, sense * tangent, height},
                   {tangent, sense * radius, height},
                   {0, sense * radius, height}}};
  }
  return patch;
}

// The half on the side of -y.
Patch half(const Tube& tube) {
  Patch patch{};
  for (std::size_t row = 0; row < 4; ++row) {
    const auto [x0, z0, x3, z3, bulge] = tube[row];
    patch[row] = {{{x0, 0, z0}, {x0, -bulge, z0}, {x3, -bulge, z3}, {x3, 0, z3}}};
  }
  return patch;
}

Patch rotated_by_quarter(Patch patch, double sense) {
  for (Cubic& row : patch)
    for (Vec3d& v : row)
      v = {sense * -v.y, sense * v.x, v.z};
  return patch;
}

// The other half of a tube, mirrored at y = 0, its columns in the reverse order.
Patch other_half(Patch patch) {
  for (Cubic& row : patch) {
    std::ranges::reverse(row);
    for (Vec3d& v : row)
      v.y = -v.y;
  }
  return patch;
}

Vec3d point(const Cubic& c, double t) {
  const double s = 1 - t;
  return c[0] * (s * s * s) + c[1] * (3 * s * s * t) + c[2] * (3 * s * t * t) + c[3] * (t * t * t);
}

Vec3d derivative(const Cubic& c, double t) {
  const double s = 1 - t;
  return ((c[1] - c[0]) * (s * s) + (c[2] - c[1]) * (2 * s * t) + (c[3] - c[2]) * (t * t)) * 3.0;
}

// u runs along the profile, v about the axis. At a pole the derivative by v is zero, and the normal's limit
// is computed with its derivative by u.
Corner corner_at(const Patch& patch, double u, double v) {
  Cubic profile{}, change{};
  for (std::size_t row = 0; row < 4; ++row) {
    profile[row] = point(patch[row], v);
    change[row] = derivative(patch[row], v);
  }
  Vec3d around = point(change, u);
  if (around == Vec3d{0, 0, 0}) around = derivative(change, u);
  return {point(profile, u), normalized(cross(around, derivative(profile, u)))};
}

using Row = std::vector<Corner>;

Row corners_along(const Patch& patch, double u, int size) {
  Row row;
  for (int column = 0; column <= size; ++column)
    row.push_back(corner_at(patch, u, static_cast<double>(column) / size));
  return row;
}

// A quadrilateral for each pair of neighbouring corners of the two rows.
void put_strip(NffWriter& nff, const Row& upper, const Row& lower, bool upper_is_pole) {
  for (std::size_t i = 0; i + 1 < upper.size(); ++i) {
    if (!upper_is_pole) put_triangle(nff, upper[i], upper[i + 1], lower[i + 1]);
    put_triangle(nff, lower[i + 1], lower[i], upper[i]);
  }
}

void put_patch(NffWriter& nff, const Patch& patch, int size) {
  const bool starts_at_pole = patch[0].front() == patch[0].back();
  Row upper = corners_along(patch, 0, size);
  for (int i = 1; i <= size; ++i) {
    Row lower = corners_along(patch, static_cast<double>(i) / size, size);
    put_strip(nff, upper, lower, starts_at_pole && i == 1);
    upper = std::move(lower);
  }
}

void put_quarters(NffWriter& nff, const Profile& profile, double sense, int size) {
  Patch patch = quarter(profile, sense);
  for (int i = 0; i < 4; ++i) {
    put_patch(nff, patch, size);
    patch = rotated_by_quarter(patch, sense);
  }
}

void put_halves(NffWriter& nff, const Tube& tube, int size) {
  const Patch patch = half(tube);
  put_patch(nff, patch, size);
  put_patch(nff, other_half(patch), size);
}

// The squares of the board whose sum of column and row is odd, or even.
void put_squares(NffWriter& nff, int size, bool odd) {
  const auto line = [size](int i) { return 8.0 * i / size - 4; };
  for (int column = 0; column < size; ++column)
    for (int row = 0; row < size; ++row) {
      if (((column + row) % 2 == 1) != odd) continue;
      const double left = line(column), right = line(column + 1), low = line(row), high = line(row + 1);
      put_polygon(nff, {{left, low, 0}, {right, low, 0}, {right, high, 0}, {left, high, 0}});
    }
}

} // namespace

void write_teapot(NffWriter& nff, int size, bool) {
  put_view(nff, {{4.86, 7.2, 5.4}, {0, 0, 0}, z_axis, 1});
  put_lights(nff, {{-3.1, 9.8, 12.1}, {11.3, 5.1, 8.8}});
  put_material(nff, {1, 1, 1, 0.5, 0.5, 4.81884, 0, 0});
  put_squares(nff, size, true);
  put_material(nff, {0.5, 0.5, 0.5, 0.5, 0.5, 4.81884, 0, 0});
  put_squares(nff, size, false);
  put_material(nff, {1, 0.5, 0.1, 0.75, 0.25, 3.0827, 0, 0});
  for (const Profile& profile : {rim, upper_body, lower_body})
    put_quarters(nff, profile, clockwise, size);
  for (const Tube& tube : {upper_handle, lower_handle, lower_spout, upper_spout})
    put_halves(nff, tube, size);
  for (const Profile& profile : {knob, lid})
    put_quarters(nff, profile, clockwise, size);
  put_quarters(nff, bottom, counterclockwise, size); // faces down
}

} // namespace masu::spd
