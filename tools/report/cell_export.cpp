#include "tools/report/cell_export.h"

#include "libscene/base/error.h"
#include "libscene/file/output_file.h"
#include "tools/common/color_map.h"
#include "tools/common/version.h"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cmath>
#include <iterator>

namespace masu {
namespace {

static_assert(std::endian::native == std::endian::little);

constexpr std::uint64_t corners_per_cell = 8, faces_per_cell = 6, edges_per_cell = 12;
constexpr std::uint64_t most_ply_cells = 0x7fffffff / corners_per_cell; // corners are numbered by 32 bits

using Edge = std::array<std::uint32_t, 2>; // corners

// Corner i has the upper x, y or z where bit 0, 1 or 2 of i is set. Counter-clockwise seen from outside.
constexpr std::array<std::array<std::uint32_t, 4>, faces_per_cell> faces{
    {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
constexpr std::array<Edge, edges_per_cell> edges{
    {{0, 1}, {2, 3}, {4, 5}, {6, 7}, {0, 2}, {1, 3}, {4, 6}, {5, 7}, {0, 4}, {1, 5}, {2, 6}, {3, 7}}};

// Records of a PLY.
struct [[gnu::packed]] Corner {
  double position[3];
  Rgb color;
  float quality;
};
struct [[gnu::packed]] Face {
  std::uint8_t count;
  std::array<std::uint32_t, 4> corners;
};
static_assert(sizeof(Corner) == 31 && sizeof(Face) == 17);

void write_csv(const StructureFile& file, const CellExport& options, OutputFile& out) {
  fmt::memory_buffer text;
  const auto end = std::back_inserter(text);
  const auto flush = [&] {
    out.write(text.data(), text.size());
    text.clear();
  };
  const auto put = [&](const Boxd& box) {
    for (const Vec3d& corner : {box.min, box.max})
      fmt::format_to(end, ",{},{},{}", corner.x, corner.y, corner.z);
  };
  if (file.is_hierarchy())
    fmt::format_to(end, "box,depth,min_x,min_y,min_z,max_x,max_y,max_z,references\n");
  else
    fmt::format_to(end,
                   "cell,min_x,min_y,min_z,max_x,max_y,max_z,expanded_min_x,expanded_min_y,expanded_min_z,"
                   "expanded_max_x,expanded_max_y,expanded_max_z,references,occupied,voxels\n");
  for_each_box(file, options.filter, [&](const StructureBox& cell) {
    fmt::format_to(end, "{}", cell.number);
    if (file.is_hierarchy()) {
      fmt::format_to(end, ",{}", cell.depth);
      put(cell.box);
      fmt::format_to(end, ",{}\n", cell.references);
    } else {
      put(cell.box);
      put(cell.expanded);
      fmt::format_to(end, ",{},{},{}\n", cell.references, cell.references > 0 ? 1 : 0, cell.voxels);
    }
    constexpr std::size_t piece = std::size_t{1} << 16;
    if (text.size() > piece) flush();
  });
  flush();
}

// Corners of all cells stand before all faces, and the head has their numbers: three passes over the cells.
void write_ply(const StructureFile& file, const CellExport& options, OutputFile& out) {
  std::uint64_t cells = 0;
  std::uint32_t most = 1; // references of a cell
  for_each_box(file, options.filter, [&](const StructureBox& cell) {
    ++cells;
    most = std::max(most, cell.references);
  });
  if (cells > most_ply_cells)
    throw Error(ErrorCode::usage, out.path(),
                fmt::format("a PLY can't hold {} cells: give --occupied or --within, or write a CSV", cells));
  const std::string shapes =
      options.wireframe
          ? fmt::format("element edge {}\nproperty int vertex1\nproperty int vertex2\n",
                        cells * edges_per_cell)
          : fmt::format("element face {}\nproperty list uchar int vertex_indices\n", cells * faces_per_cell);
  const std::string head = fmt::format(
      "ply\nformat binary_little_endian 1.0\ncomment Masu {} {}: cells of a grid; quality is the number of "
      "references\nelement vertex {}\nproperty double x\nproperty double y\nproperty double z\nproperty "
      "uchar "
      "red\nproperty uchar green\nproperty uchar blue\nproperty float quality\n{}end_header\n",
      version, commit, cells * corners_per_cell, shapes);
  out.write(head.data(), head.size());

  const ColorMap map = ColorMap::of_lists();
  const double range = std::log(std::max<double>(most, 2));
  for_each_box(file, options.filter, [&](const StructureBox& cell) {
    const Boxd& box = options.expanded ? cell.expanded : cell.box;
    constexpr Rgb empty{230, 230, 230};
    const Rgb color = cell.references == 0 ? empty : map(1 - std::log(cell.references) / range);
    std::array<Corner, corners_per_cell> corners{};
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const auto side = [&](int axis) { return (i >> axis & 1) != 0 ? box.max[axis] : box.min[axis]; };
      corners[i] = {{side(0), side(1), side(2)}, color, static_cast<float>(cell.references)};
    }
    out.write(corners.data(), sizeof corners);
  });
  for (std::uint64_t cell = 0; cell < cells; ++cell) {
    const auto first = static_cast<std::uint32_t>(cell * corners_per_cell);
    std::array<Edge, edges_per_cell> lines = edges;
    std::array<Face, faces_per_cell> quads{};
    for (Edge& line : lines)
      line = {first + line[0], first + line[1]};
    for (std::size_t i = 0; i < quads.size(); ++i)
      quads[i] = {4, {first + faces[i][0], first + faces[i][1], first + faces[i][2], first + faces[i][3]}};
    options.wireframe ? out.write(lines.data(), sizeof lines) : out.write(quads.data(), sizeof quads);
  }
}

} // namespace

void export_cells(const StructureFile& file, const CellExport& options, const std::string& path) {
  OutputFile out(path);
  if (path.ends_with(".csv"))
    write_csv(file, options, out);
  else
    write_ply(file, options, out);
  out.commit();
}

} // namespace masu
