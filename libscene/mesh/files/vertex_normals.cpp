#include "libscene/mesh/files/vertex_normals.h"

#include <tbb/parallel_sort.h>

#include <array>
#include <bit>
#include <cmath>
#include <numeric>

namespace masu {
namespace {

// Orders positions, NaN included; equal where the coordinates are.
std::array<std::uint64_t, 3> key_of(const Vec3d& p) {
  // + 0 makes -0 and 0 the same.
  return {std::bit_cast<std::uint64_t>(p.x + 0.0), std::bit_cast<std::uint64_t>(p.y + 0.0),
          std::bit_cast<std::uint64_t>(p.z + 0.0)};
}

} // namespace

VertexNormals::VertexNormals(const MeshFile& file)
    : file_(file), first_(file.positions.size()), normals_(file.positions.size()) {
  std::vector<std::uint32_t> order(first_.size());
  std::iota(order.begin(), order.end(), 0U);
  tbb::parallel_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    const auto key_a = key_of(file.positions[a]), key_b = key_of(file.positions[b]);
    return key_a != key_b ? key_a < key_b : a < b;
  });
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool is_same = i > 0 && key_of(file.positions[order[i]]) == key_of(file.positions[order[i - 1]]);
    first_[order[i]] = is_same ? first_[order[i - 1]] : order[i];
  }
}

void VertexNormals::take(const MeshObject& object) {
  const std::span<const std::uint32_t> all(file_.corners.data() + object.first_corner, object.corners);
  for (const std::uint32_t corner : all)
    normals_[first_[corner]] = {0, 0, 0};
  std::vector<std::uint32_t>
      corners; // of a face, of equal consecutive ones the first: an angle has two sides
  std::size_t begin = 0;
  for (std::uint64_t f = object.first_face; f < object.first_face + object.faces; ++f) {
    corners.clear();
    for (const std::uint32_t corner : all.subspan(begin, file_.face_sizes[f]))
      if (corners.empty() || first_[corner] != corners.back()) corners.push_back(first_[corner]);
    begin += file_.face_sizes[f];
    while (corners.size() > 1 && corners.front() == corners.back())
      corners.pop_back();
    const std::size_t n = corners.size();
    if (n < 3) continue;
    const auto corner = [&](std::size_t i) { return file_.positions[corners[i % n]]; };
    Vec3d across{0, 0, 0}; // twice the area
    for (std::size_t i = 1; i + 1 < n; ++i)
      across = across + cross(corner(i) - corner(0), corner(i + 1) - corner(0));
    const auto unit_or_zero = [](const Vec3d& v) { return unit(v).value_or(Vec3d{0, 0, 0}); };
    const Vec3d normal = unit_or_zero(across);
    for (std::size_t i = 0; i < n; ++i) {
      const Vec3d next = unit_or_zero(corner(i + 1) - corner(i));
      const Vec3d previous = unit_or_zero(corner(i + n - 1) - corner(i));
      const double angle = std::atan2(length(cross(next, previous)), dot(next, previous));
      normals_[corners[i]] = normals_[corners[i]] + normal * angle;
    }
  }
}

} // namespace masu
