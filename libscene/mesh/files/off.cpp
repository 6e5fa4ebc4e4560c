// OFF, Geomview's object file format, as text: [ST][C][N][4]OFF, a vertex and a face a line.
#include "libscene/mesh/files/file_material.h"
#include "libscene/mesh/files/mesh_file.h"
#include "libscene/mesh/files/text_lines.h"

#include <fmt/format.h>

#include <algorithm>

namespace masu {
namespace {

struct Kind {
  bool has_colors = false, has_normals = false, is_homogeneous = false;
};

std::optional<Kind> kind_of(std::string_view word) {
  Kind kind;
  const auto take = [&](std::string_view prefix) {
    const bool has = word.starts_with(prefix);
    if (has) word.remove_prefix(prefix.size());
    return has;
  };
  take("ST"); // texture coordinates, which aren't used
  kind.has_colors = take("C");
  kind.has_normals = take("N");
  kind.is_homogeneous = take("4");
  return word == "OFF" ? std::optional(kind) : std::nullopt;
}

// The header's word may lack, and stand in the line of the counts.
Kind read_kind(TextLines& lines) {
  constexpr const char* refused =
      "isn't an OFF file of three dimensions as text: its first word isn't OFF, COFF, "
      "NOFF, STOFF or 4OFF: convert it";
  if (!lines.next()) lines.fail(refused);
  const std::string_view word = lines.peek();
  if (word.front() >= '0' && word.front() <= '9' && !kind_of(word)) return {};
  const std::optional<Kind> kind = kind_of(word);
  if (!kind) lines.fail(refused);
  lines.word();
  if (lines.is_at_end()) lines.need_line("the number of vertices");
  if (lines.peek() == "BINARY") lines.fail("is a binary OFF file, which isn't read: convert it to text");
  return *kind;
}

std::uint64_t read_count(TextLines& lines, const char* what) {
  if (lines.is_at_end()) lines.need_line(what);
  const std::int64_t count = lines.whole(what);
  if (count < 0 || count > no_index) lines.fail(fmt::format("{} isn't from 0 to 2^32 - 1: correct it", what));
  return static_cast<std::uint64_t>(count);
}

Vec3d read_vector(TextLines& lines, const char* what) {
  return {lines.number(what), lines.number(what), lines.number(what)};
}

void read_vertex(TextLines& lines, const Kind& kind, MeshFile& file) {
  Vec3d position = read_vector(lines, "a coordinate");
  if (kind.is_homogeneous) {
    const double w = lines.number("a coordinate");
    if (w == 0) lines.fail("the fourth coordinate of a vertex is 0: it has no place: correct it");
    position = {position.x / w, position.y / w, position.z / w};
  }
  file.positions.push_back(position);
  if (kind.has_normals) file.normals.push_back(read_vector(lines, "a component of a normal"));
  if (kind.has_colors) {
    const Vec3d color = read_vector(lines, "a component of a colour");
    file.colors.push_back(
        {static_cast<float>(color.x), static_cast<float>(color.y), static_cast<float>(color.z)});
  }
}

// What follows the vertices is its colour, which isn't used.
void read_face(TextLines& lines, std::uint64_t vertices, std::vector<std::uint32_t>& corners) {
  corners.clear();
  for (std::uint64_t left = read_count(lines, "a number of corners"); left > 0; --left) {
    const std::int64_t vertex = lines.whole("a vertex's number");
    if (vertex < 0 || static_cast<std::uint64_t>(vertex) >= vertices)
      lines.fail(fmt::format("has vertex {} of {}, which are numbered from 0: correct it", vertex, vertices));
    corners.push_back(static_cast<std::uint32_t>(vertex));
  }
}

// They are whole numbers up to 255, or up to 1: which, the file doesn't say.
void scale_colors(MeshFile& file) {
  float largest = 0;
  for (const Vec3f& c : file.colors)
    largest = std::max({largest, c.x, c.y, c.z});
  if (largest > 1)
    for (Vec3f& color : file.colors)
      color = color * (1.0F / 255);
}

} // namespace

MeshFile parse_off(const MeshText& text) {
  TextLines lines(text.bytes, text.name, '#', text.progress);
  const Kind kind = read_kind(lines);
  const std::uint64_t vertices = read_count(lines, "the number of vertices");
  const std::uint64_t faces = read_count(lines, "the number of faces");
  if (!lines.is_at_end()) read_count(lines, "the number of edges"); // which some leave out
  MeshFile file;
  file.materials.push_back({phong_material({.color = {0.6F, 0.6F, 0.6F}})});
  begin_object(file, "<OFFRoot>", 0);
  file.positions.reserve(std::min<std::uint64_t>(vertices, lines.bytes_left() / 2));
  for (std::uint64_t i = 0; i < vertices; ++i) {
    if (!lines.next()) lines.fail_at_end(fmt::format("vertex {} of {}", i, vertices));
    read_vertex(lines, kind, file);
  }
  std::vector<std::uint32_t> corners;
  for (std::uint64_t i = 0; i < faces; ++i) {
    if (!lines.next()) lines.fail_at_end(fmt::format("face {} of {}", i, faces));
    read_face(lines, vertices, corners);
    add_face(file, corners);
  }
  if (lines.next()) lines.fail("is after the last face that the header promises: correct its counts");
  scale_colors(file);
  file.objects[0].has_normals = kind.has_normals;
  file.objects[0].has_colors = kind.has_colors;
  return file;
}

} // namespace masu
