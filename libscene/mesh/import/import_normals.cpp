#include "libscene/mesh/import/import_normals.h"

#include "libscene/mesh/import/import_transform.h"

#include <tbb/parallel_sort.h>

#include <array>
#include <bit>
#include <cmath>
#include <numeric>

namespace masu::import {
namespace {

// Orders positions, NaN included; equal where the coordinates are.
std::array<std::uint32_t, 3> key_of(const aiVector3D& p) {
  // + 0 makes -0 and 0 the same.
  return {std::bit_cast<std::uint32_t>(p.x + 0.0F), std::bit_cast<std::uint32_t>(p.y + 0.0F),
          std::bit_cast<std::uint32_t>(p.z + 0.0F)};
}

// For each vertex the first one at its position.
std::vector<std::uint32_t> joined_vertices(const aiMesh& mesh) {
  std::vector<std::uint32_t> order(mesh.mNumVertices), first(mesh.mNumVertices);
  std::iota(order.begin(), order.end(), 0U);
  tbb::parallel_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    const auto key_a = key_of(mesh.mVertices[a]), key_b = key_of(mesh.mVertices[b]);
    return key_a != key_b ? key_a < key_b : a < b;
  });
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool is_same = i > 0 && key_of(mesh.mVertices[order[i]]) == key_of(mesh.mVertices[order[i - 1]]);
    first[order[i]] = is_same ? first[order[i - 1]] : order[i];
  }
  return first;
}

// v with a length of 1, or 0.
Vec3d unit_or_zero(const Vec3d& v) {
  const double size = length(v); // of products of floats: in the range of a double
  return size > 0 && std::isfinite(size) ? v * (1 / size) : Vec3d{0, 0, 0};
}

} // namespace

std::vector<Vec3d> vertex_normals(const aiMesh& mesh) {
  const std::vector<std::uint32_t> first = joined_vertices(mesh);
  std::vector<Vec3d> normals(mesh.mNumVertices, Vec3d{0, 0, 0});
  std::vector<std::uint32_t>
      corners; // of a face, of equal consecutive ones the first: an angle has two sides
  for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
    const aiFace& face = mesh.mFaces[f];
    corners.clear();
    for (unsigned i = 0; i < face.mNumIndices; ++i)
      if (corners.empty() || first[face.mIndices[i]] != corners.back())
        corners.push_back(first[face.mIndices[i]]);
    while (corners.size() > 1 && corners.front() == corners.back())
      corners.pop_back();
    const std::size_t n = corners.size();
    if (n < 3) continue;
    const auto corner = [&](std::size_t i) { return vector_of(mesh.mVertices[corners[i % n]]); };
    Vec3d across{0, 0, 0}; // twice the area
    for (std::size_t i = 1; i + 1 < n; ++i)
      across = across + cross(corner(i) - corner(0), corner(i + 1) - corner(0));
    const Vec3d normal = unit_or_zero(across);
    for (std::size_t i = 0; i < n; ++i) {
      const Vec3d next = unit_or_zero(corner(i + 1) - corner(i));
      const Vec3d previous = unit_or_zero(corner(i + n - 1) - corner(i));
      const double angle = std::atan2(length(cross(next, previous)), dot(next, previous));
      normals[corners[i]] = normals[corners[i]] + normal * angle;
    }
  }
  for (std::size_t i = 0; i < normals.size(); ++i)
    normals[i] = normals[first[i]];
  return normals;
}

} // namespace masu::import
