// A fractal mountain by midpoint displacement, under four glass spheres.
// Random numbers depend only on the lattice point: so neighbouring squares agree on their shared edge without
// being stored, and a larger size refines the same mountain.
#include "libscene/geometry/random_rays.h"
#include "libscene/spd/scenes.h"

#include <array>
#include <cstdint>

namespace masu::spd {

namespace {

constexpr double fractal_dimension = 2.2;
constexpr double root_2 = 1.4142136; // with the digits of the scene's definition

// The displacement of a square's midpoints, relative to half its side.
double roughness() {
  const double ratio = 2 / std::exp2(1 / (fractal_dimension - 1));
  return std::sqrt(ratio * ratio - 1);
}

// The scene's definition has random numbers for a lattice of 2^7 steps a side; the finest one here has 2^14.
constexpr int original_bits = 7, finest_bits = 14;
constexpr std::uint32_t finest_steps = 1U << finest_bits;

// A point of the finest lattice.
struct LatticePoint {
  std::uint32_t x, y;
};

constexpr std::uint32_t modulus = 134456; // of the generator below

// The definition's seeds, which suffice up to size 7; hashes between its lattice points.
std::uint32_t seed_at(LatticePoint p) {
  constexpr std::uint32_t spacing = 1U << (finest_bits - original_bits);
  if (p.x % spacing == 0 && p.y % spacing == 0) return 21 + 256 * (p.y / spacing) + p.x / spacing;
  return static_cast<std::uint32_t>(mixed_bits((std::uint64_t{p.y} << 32) + p.x) % modulus);
}

// A normally distributed number: the first of a pair of the polar method, from a linear congruential
// generator of full period.
double gaussian_at(LatticePoint p) {
  std::uint32_t state = seed_at(p);
  const auto draw = [&state] {
    state = (28411 + 8121 * state) % modulus; // no overflow: below 2^31 before the remainder
    return 2.0 * state / modulus - 1;
  };
  while (true) {
    const double a = draw(), b = draw(), square = a * a + b * b;
    if (square < 1 && square > 0) return a * std::sqrt(-2 * std::log(square) / square);
  }
}

// Corners run counter-clockwise from the lower left, as do the quarters.
struct Square {
  LatticePoint corner; // lower left
  std::uint32_t side;  // in steps of the finest lattice
  double displacement; // of its midpoints
  std::array<double, 4> heights;
};

Vec3d on_ground(LatticePoint p) {
  constexpr double step = 2.0 / finest_steps;
  return {p.x * step - 1, p.y * step - 1, 0};
}

// A cell: two triangles.
void put_cell(NffWriter& nff, const Square& square) {
  const auto& [corner, side, displacement, heights] = square;
  const Vec3d low = on_ground(corner), high = on_ground({corner.x + side, corner.y + side});
  const std::array<Vec3d, 4> corners = {{{low.x, low.y, heights[0]},
                                         {high.x, low.y, heights[1]},
                                         {high.x, high.y, heights[2]},
                                         {low.x, high.y, heights[3]}}};
  put_polygon(nff, {corners[0], corners[1], corners[2]});
  put_polygon(nff, {corners[2], corners[3], corners[0]});
}

std::array<Square, 4> quarters(const Square& square) {
  const auto& [corner, side, displacement, heights] = square;
  const auto [h0, h1, h2, h3] = heights;
  const std::uint32_t half = side / 2;
  const LatticePoint center = {corner.x + half, corner.y + half};
  const LatticePoint south = {center.x, corner.y}, east = {corner.x + side, center.y};
  const LatticePoint north = {center.x, corner.y + side}, west = {corner.x, center.y};

  const double s = (h0 + h1) / 2 + displacement * gaussian_at(south);
  const double e = (h1 + h2) / 2 + displacement * gaussian_at(east);
  const double n = (h2 + h3) / 2 + displacement * gaussian_at(north);
  const double w = (h3 + h0) / 2 + displacement * gaussian_at(west);
  const double c = (h0 + h1 + h2 + h3) / 4 + root_2 * displacement * gaussian_at(center);
  const double next = displacement / 2;
  return {{{corner, half, next, {h0, s, c, w}},
           {south, half, next, {s, h1, e, c}},
           {center, half, next, {c, e, h2, n}},
           {west, half, next, {w, c, n, h3}}}};
}

void put_terrain(NffWriter& nff, const Square& square, int depth) {
  if (depth == 0) return put_cell(nff, square);
  for (const Square& quarter : quarters(square))
    put_terrain(nff, quarter, depth - 1);
}

// Four equal spheres that touch, at the corners of a regular tetrahedron.
void put_spheres(NffWriter& nff) {
  const Vec3d center = {-0.8, 0.8, 1.0};
  const double radius = 0.17;
  const Vec3d top = z_axis * (radius * std::sqrt(1.5));
  const double half = std::sqrt(0.5);
  const Vec3d side = rotated(top, {half, half, 0}, std::acos(-1.0 / 3));
  put_material(nff, {1, 1, 1, 0.1, 0.1, 101.148, 0.9, 1.5});
  put_sphere(nff, center + top, radius);
  for (int i = 0; i < 3; ++i)
    put_sphere(nff, center + rotated(side, z_axis, radians(120.0 * i)), radius);
}

} // namespace

void write_mount(NffWriter& nff, int size, bool background) {
  put_view(nff, {{-1.6, 1.6, 1.7}, {0, 0, 0}, z_axis, 0.01});
  put_lights(nff, {{-100, -100, 100}});
  if (background) put_spheres(nff);
  put_material(nff, {0.5, 0.45, 0.35, 1, 0, 100000, 0, 0});
  put_terrain(nff, {{0, 0}, finest_steps, roughness(), {0, 0, 0, 0}}, size); // half the side: 1
}

} // namespace masu::spd
