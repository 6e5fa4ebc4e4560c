// A mesh in the formats of meshes.
#pragma once

#include "libscene/geometry/vector.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

namespace masu::texts {

struct PolygonMesh {
  std::vector<Vec3d> vertices;
  std::vector<std::vector<std::uint32_t>> faces;
};

template <class T>
void append(std::string& bytes, T value, bool is_big = false) {
  std::array<char, sizeof(T)> raw{};
  std::memcpy(raw.data(), &value, sizeof value);
  if (is_big) std::ranges::reverse(raw);
  bytes.append(raw.data(), raw.size());
}
template <class Real>
void append_point(std::string& bytes, const Vec3d& p, bool is_big = false) {
  for (const double x : {p.x, p.y, p.z})
    append(bytes, static_cast<Real>(x), is_big);
}

inline std::string numbers_of(const Vec3d& v) {
  return fmt::format("{:.17g} {:.17g} {:.17g}", v.x, v.y, v.z);
}
inline std::string obj_of(const PolygonMesh& mesh) {
  std::string text;
  for (const Vec3d& v : mesh.vertices)
    text += "v " + numbers_of(v) + "\n";
  for (const auto& face : mesh.faces) {
    text += "f";
    for (const std::uint32_t corner : face)
      text += fmt::format(" {}", corner + 1);
    text += "\n";
  }
  return text;
}
inline std::string body_of(const PolygonMesh& mesh) {
  std::string text;
  for (const Vec3d& v : mesh.vertices)
    text += numbers_of(v) + "\n";
  for (const auto& face : mesh.faces) {
    text += std::to_string(face.size());
    for (const std::uint32_t corner : face)
      text += fmt::format(" {}", corner);
    text += "\n";
  }
  return text;
}
inline std::string off_of(const PolygonMesh& mesh) {
  return fmt::format("OFF\n{} {} 0\n", mesh.vertices.size(), mesh.faces.size()) + body_of(mesh);
}
inline std::string ply_header(const PolygonMesh& mesh, const std::string& format, const std::string& type) {
  return fmt::format(
      "ply\nformat {0} 1.0\nelement vertex {1}\nproperty {2} x\nproperty {2} y\nproperty {2} z\n"
      "element face {3}\nproperty list uchar int vertex_index\nend_header\n",
      format, mesh.vertices.size(), type, mesh.faces.size());
}
inline std::string ply_of(const PolygonMesh& mesh) {
  return ply_header(mesh, "ascii", "double") + body_of(mesh);
}
template <class Real>
std::string binary_ply_of(const PolygonMesh& mesh, bool is_big) {
  std::string bytes = ply_header(mesh, is_big ? "binary_big_endian" : "binary_little_endian",
                                 std::is_same_v<Real, float> ? "float" : "double");
  for (const Vec3d& v : mesh.vertices)
    append_point<Real>(bytes, v, is_big);
  for (const auto& face : mesh.faces) {
    append(bytes, static_cast<std::uint8_t>(face.size()));
    for (const std::uint32_t corner : face)
      append(bytes, corner, is_big);
  }
  return bytes;
}
inline std::string stl_of(const PolygonMesh& mesh) {
  std::string text = "solid t\n";
  for (const auto& face : mesh.faces) {
    text += "facet normal 0 0 1\n outer loop\n";
    for (const std::uint32_t corner : face)
      text += "  vertex " + numbers_of(mesh.vertices[corner]) + "\n";
    text += " endloop\nendfacet\n";
  }
  return text + "endsolid t\n";
}
inline std::string binary_stl_of(const PolygonMesh& mesh, std::string header = "") {
  header.resize(80, header.empty() ? '\0' : ' ');
  append(header, static_cast<std::uint32_t>(mesh.faces.size()));
  for (const auto& face : mesh.faces) {
    append_point<float>(header, {0, 0, 0}); // the normal
    for (const std::uint32_t corner : face)
      append_point<float>(header, mesh.vertices[corner]);
    append(header, std::uint16_t{0});
  }
  return header;
}

} // namespace masu::texts
