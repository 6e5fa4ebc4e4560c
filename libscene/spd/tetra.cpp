// Sierpinski's tetrahedron in the cube of side 2 centred on the origin.
#include "libscene/spd/scenes.h"

#include <array>

namespace masu::spd {

namespace {

// Alternate corners of the cube from -1 to 1: those whose coordinates have the product 1.
constexpr std::array<Vec3d, 4> corners = {{{-1, -1, 1}, {-1, 1, -1}, {1, -1, -1}, {1, 1, 1}}};

// The faces, counter-clockwise seen from outside.
constexpr std::array<std::array<std::size_t, 3>, 4> faces = {{{0, 1, 2}, {3, 2, 1}, {2, 3, 0}, {1, 0, 3}}};

// half: half the side of the tetrahedron's bounding cube.
void put_tetrahedron(NffWriter& nff, const Vec3d& center, double half) {
  for (const auto [a, b, c] : faces)
    put_polygon(nff, {center + corners[a] * half, center + corners[b] * half, center + corners[c] * half});
}

void put_pyramid(NffWriter& nff, const Vec3d& center, double half, int depth) {
  if (depth == 1) return put_tetrahedron(nff, center, half);
  for (const Vec3d& corner : corners)
    put_pyramid(nff, center + corner * (half / 2), half / 2, depth - 1);
}

} // namespace

void write_tetra(NffWriter& nff, int size, bool) {
  put_view(
      nff,
      {{1.02285, -3.17715, -2.17451}, {-0.004103, -0.004103, 0.216539}, {-0.816497, -0.816497, 0.816497}, 1});
  put_lights(nff, {{2, -18, -5}});
  put_material(nff, {1, 0.2, 0.2, 1, 0, 100000, 0, 0});
  put_pyramid(nff, {0, 0, 0}, 1, size);
}

} // namespace masu::spd
