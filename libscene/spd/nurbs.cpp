// A bicubic B-spline surface over a 5 x 6 net of control points, tessellated into triangles with normals.
#include "libscene/spd/scenes.h"

#include <array>
#include <utility>
#include <vector>

namespace masu::spd {

namespace {

constexpr std::size_t columns = 5, rows = 6;

// The control points' heights. Their ground positions are one unit apart, centred on the origin.
constexpr std::array<std::array<double, columns>, rows> heights = {{{0, 3, -3, 3, 0},
                                                                    {0, 0, 0, 0, 0},
                                                                    {0, 0, 5, 0, 0},
                                                                    {0, 0, 5, 0, 0},
                                                                    {0, 0, 0, 0, 0},
                                                                    {0, -3, 3, -3, 0}}};

// The surface's rotation about y.
constexpr double turn = radians(30);

// Knot i from 0 to count + 3: 0 0 0 0, evenly spaced ones, 1 1 1 1.
double knot(std::size_t i, std::size_t count) {
  if (i < 4) return 0;
  if (i >= count) return 1;
  return static_cast<double>(i - 3) / static_cast<double>(count - 3);
}

// The basis function of a degree that starts at knot i (the Cox–de Boor recursion with 0/0 = 0).
double basis(std::size_t i, int degree, double t, std::size_t count) {
  const double start = knot(i, count), next = knot(i + 1, count);
  if (degree == 0) return start <= t && (t < next || (t == 1 && start < 1 && next == 1)) ? 1 : 0;
  const auto d = static_cast<std::size_t>(degree);
  const double span = knot(i + d, count) - start;
  const double end = knot(i + d + 1, count), next_span = end - next;
  double sum = 0;
  if (span > 0) sum += (t - start) / span * basis(i, degree - 1, t, count);
  if (next_span > 0) sum += (end - t) / next_span * basis(i + 1, degree - 1, t, count);
  return sum;
}

double basis_slope(std::size_t i, double t, std::size_t count) {
  const double span = knot(i + 3, count) - knot(i, count);
  const double next_span = knot(i + 4, count) - knot(i + 1, count);
  double slope = 0;
  if (span > 0) slope += 3 / span * basis(i, 2, t, count);
  if (next_span > 0) slope -= 3 / next_span * basis(i + 1, 2, t, count);
  return slope;
}

// The weights of the control points along one direction, and their derivatives.
struct Weights {
  std::array<double, rows> value, slope; // columns < rows: the last one is unused there
};

// At `steps` + 1 evenly spaced parameters.
std::vector<Weights> weights_along(std::size_t count, int steps) {
  std::vector<Weights> weights;
  for (int step = 0; step <= steps; ++step) {
    const double t = static_cast<double>(step) / steps;
    Weights w{};
    for (std::size_t i = 0; i < count; ++i) {
      w.value[i] = basis(i, 3, t, count);
      w.slope[i] = basis_slope(i, t, count);
    }
    weights.push_back(w);
  }
  return weights;
}

using Net = std::array<std::array<Vec3d, columns>, rows>;

Net control_net() {
  Net net{};
  for (std::size_t row = 0; row < rows; ++row)
    for (std::size_t column = 0; column < columns; ++column) {
      const double x = static_cast<double>(column) - (columns - 1) / 2.0;
      const double z = (rows - 1) / 2.0 - static_cast<double>(row);
      net[row][column] = rotated({x, heights[row][column], z}, y_axis, turn);
    }
  return net;
}

// u runs along the columns, v along the rows.
Corner corner_at(const Net& net, const Weights& u, const Weights& v) {
  Vec3d position{}, along_u{}, along_v{};
  for (std::size_t row = 0; row < rows; ++row)
    for (std::size_t column = 0; column < columns; ++column) {
      const Vec3d& p = net[row][column];
      position = position + p * (v.value[row] * u.value[column]);
      along_u = along_u + p * (v.value[row] * u.slope[column]);
      along_v = along_v + p * (v.slope[row] * u.value[column]);
    }
  return {position, normalized(cross(along_u, along_v))};
}

using Row = std::vector<Corner>;

Row corners_along(const Net& net, const std::vector<Weights>& us, const Weights& v) {
  Row row;
  for (const Weights& u : us)
    row.push_back(corner_at(net, u, v));
  return row;
}

} // namespace

void write_nurbs(NffWriter& nff, int size, bool) {
  put_view(nff, {{0, 5, -10}, {0, 0, 0}, y_axis, 0.001, {0, 0, 0}, 30, 256});
  put_lights(nff, {{0, 50, -10}});
  put_material(nff, {1, 0, 0, 0.7, 0, 45.2776, 0, 1});
  const std::vector<Weights> us = weights_along(columns, static_cast<int>(columns) * size);
  const std::vector<Weights> vs = weights_along(rows, static_cast<int>(rows) * size);
  const Net net = control_net();
  Row upper = corners_along(net, us, vs.front());
  for (std::size_t i = 1; i < vs.size(); ++i) {
    Row lower = corners_along(net, us, vs[i]);
    for (std::size_t j = 0; j + 1 < us.size(); ++j) {
      // The scene's triangles are clockwise seen from above, where their normals point.
      put_triangle(nff, upper[j], lower[j], lower[j + 1]);
      put_triangle(nff, upper[j], lower[j + 1], upper[j + 1]);
    }
    upper = std::move(lower);
  }
}

} // namespace masu::spd
