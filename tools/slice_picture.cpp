#include "tools/slice_picture.h"

#include "libgrid/map_statistics.h"
#include "libgrid/statistics.h"
#include "libscene/error.h"
#include "renderer/png_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace masu {
namespace {

// White: empty. Light yellow to red to black: 1 to 256 references and more, logarithmic.
std::array<double, 3> color_of(std::uint32_t references) {
  if (references == 0) return {1, 1, 1};
  const double step = std::min(1.0, std::log2(static_cast<double>(references)) / 8);
  const auto channel = [](double value) { return std::clamp(value, 0.0, 1.0); };
  return {channel(1.9 - 1.9 * step), channel(0.85 - 1.6 * step), channel(0.45 - 1.6 * step)};
}

// Voxels of the layer along the picture's two axes: from `first` up to, not including, `end`.
struct Rectangle {
  std::array<std::int32_t, 2> first, end;
};

// Voxels of a small layer are squares of pixels; in a large layer a pixel is several voxels and shows the
// largest number of references among them.
class Canvas {
public:
  explicit Canvas(const std::array<std::int32_t, 2>& voxels) {
    constexpr std::int32_t wanted = 768, most = 4096;
    const std::int32_t longest = std::max(voxels[0], voxels[1]);
    square_ = std::max(1, wanted / longest);
    share_ = (longest + most - 1) / most;
    for (std::size_t i = 0; i < 2; ++i)
      size_[i] = pixel_end(voxels[i]);
    pixels_.resize(static_cast<std::size_t>(size_[0]) * static_cast<std::size_t>(size_[1]));
  }

  void fill(const Rectangle& r, std::uint32_t references) {
    for (std::int32_t v = pixel(r.first[1]); v < pixel_end(r.end[1]); ++v) {
      for (std::int32_t u = pixel(r.first[0]); u < pixel_end(r.end[0]); ++u)
        at(u, v).references = std::max(at(u, v).references, references);
    }
  }

  // Lines on the first pixels of the rectangle and on the first ones beyond it, so that neighbours share a
  // line. None where they would leave fewer than `room` pixels.
  void outline(const Rectangle& r) {
    constexpr std::int32_t room = 4;
    for (std::size_t along = 0; along < 2; ++along) {
      const std::size_t across = 1 - along;
      if (pixel(r.end[along]) - pixel(r.first[along]) < room) continue;
      for (const std::int32_t line : {pixel(r.first[along]), pixel(r.end[along])}) {
        if (line == size_[along]) continue;
        for (std::int32_t i = pixel(r.first[across]); i < pixel_end(r.end[across]); ++i)
          (along == 0 ? at(line, i) : at(i, line)).line = true;
      }
    }
  }

  void write(const std::string& path) const {
    std::vector<std::uint8_t> rgb;
    rgb.reserve(pixels_.size() * 3);
    for (std::int32_t v = size_[1] - 1; v >= 0; --v) {
      for (std::int32_t u = 0; u < size_[0]; ++u) {
        const Pixel& pixel = pixels_[index(u, v)];
        for (const double channel : color_of(pixel.references))
          rgb.push_back(static_cast<std::uint8_t>(255 * channel * (pixel.line ? 0.6 : 1)));
      }
    }
    write_png(rgb, size_[0], size_[1], path);
  }

private:
  struct Pixel {
    std::uint32_t references = 0;
    bool line = false;
  };

  std::int32_t pixel(std::int32_t voxel) const { return voxel / share_ * square_; }
  std::int32_t pixel_end(std::int32_t voxel) const { return (voxel + share_ - 1) / share_ * square_; }
  std::size_t index(std::int32_t u, std::int32_t v) const {
    return static_cast<std::size_t>(v) * static_cast<std::size_t>(size_[0]) + static_cast<std::size_t>(u);
  }
  Pixel& at(std::int32_t u, std::int32_t v) { return pixels_[index(u, v)]; }

  std::int32_t square_, share_; // pixels a voxel, voxels a pixel: one of them is 1
  std::array<std::int32_t, 2> size_{};
  std::vector<Pixel> pixels_;
};

// The picture's axes: to the right, and up.
std::array<int, 2> axes_of(const Slice& slice) {
  return {slice.axis == 0 ? 1 : 0, slice.axis == 2 ? 1 : 2};
}

Canvas canvas_for(const Vec3i& division, const Slice& slice) {
  const std::array<int, 2> axes = axes_of(slice);
  return Canvas({division[axes[0]], division[axes[1]]});
}

Canvas drawn(const GridView<double>& grid, const Slice& slice) {
  Canvas canvas = canvas_for(grid.division, slice);
  const std::array<int, 2> axes = axes_of(slice);
  Vec3i voxel{};
  voxel.set(slice.axis, slice.at);
  for (std::int32_t v = 0; v < grid.division[axes[1]]; ++v) {
    for (std::int32_t u = 0; u < grid.division[axes[0]]; ++u) {
      voxel.set(axes[0], u);
      voxel.set(axes[1], v);
      canvas.fill({{u, v}, {u + 1, v + 1}}, references_in(grid, voxel));
    }
  }
  return canvas;
}

Canvas drawn(const MergedGridView<double>& grid, std::span<const MergedCell> cells, const Slice& slice) {
  Canvas canvas = canvas_for(grid.division, slice);
  const std::array<int, 2> axes = axes_of(slice);
  const std::vector<OwnVoxels> own = own_voxels(grid, cells);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const VoxelBox& box = own[i].box;
    if (own[i].voxels == 0 || slice.at < box.first[slice.axis] || slice.at >= box.end[slice.axis]) continue;
    const Rectangle rectangle{{box.first[axes[0]], box.first[axes[1]]}, {box.end[axes[0]], box.end[axes[1]]}};
    canvas.fill(rectangle, references_of(grid.references, cells[i].list));
    canvas.outline(rectangle);
  }
  return canvas;
}

} // namespace

Slice parse_slice(const std::string& text, const Vec3i& division) {
  const auto fail = [&](const std::string& why) {
    throw Error(ErrorCode::usage, "--slice", fmt::format("'{}' {}", text, why));
  };
  char axis = 0;
  int at = 0, end = 0;
  double percent = 0;
  const auto reads_all = [&] { return static_cast<std::size_t>(end) == text.size(); };
  const bool is_number = std::sscanf(text.c_str(), "%c=%d%n", &axis, &at, &end) == 2 && reads_all();
  const bool is_percentage =
      !is_number && std::sscanf(text.c_str(), "%c=%lf%%%n", &axis, &percent, &end) == 2 && reads_all();
  if ((!is_number && !is_percentage) || axis < 'x' || axis > 'z')
    fail("isn't AXIS=K or AXIS=P% with axis x, y or z");
  const int number = axis - 'x';
  const std::int32_t voxels = division[number];
  if (is_percentage) {
    if (!(percent >= 0 && percent <= 100)) fail("lies outside: give 0% to 100%");
    at = std::min(static_cast<std::int32_t>(percent / 100 * voxels), voxels - 1);
  }
  if (at < 0 || at >= voxels)
    fail(fmt::format("lies outside: the grid has {} voxels along {}", voxels, axis));
  return {number, at};
}

void draw_slice(const GridFile& file, const Slice& slice, const std::string& path) {
  const Canvas canvas = file.is_merged() ? drawn(file.merged_view<double>(), file.cells(), slice)
                                         : drawn(file.view<double>(), slice);
  canvas.write(path);
}

} // namespace masu
