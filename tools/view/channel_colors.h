// Channels for the page: numbers as they are, which it colours; normals, and names by colours that neighbours
// seldom share, as pictures.
#pragma once

#include "renderer/channels.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace masu {

// What a picture shows: the shaded picture, or a channel; of cells and tests the camera ray's alone, or the
// sum over all rays of a pixel. Or what lies behind a plane.
struct PictureChannel {
  std::optional<Channel> channel{}; // none: shaded, or cut
  bool all_rays = false;
  bool is_cut = false;

  bool is_shaded() const { return !channel && !is_cut; }
};
inline constexpr const char* cut_name = "cut";

// As the page calls them: shaded, depth, …, "all cells".
std::vector<std::string> picture_channel_names();
// Throws Error(usage, "channel", …).
PictureChannel parse_picture_channel(const std::string& name);

// Whether the picture is another one for each grid: cells, tests, idle.
bool depends_on_grid(const PictureChannel& channel);

// Of channels that are numbers: depth, and those that depend on the grid.
bool has_values(const PictureChannel& channel);

// Of those, rows from the top: a depth is infinite where nothing is hit.
std::vector<float> channel_values(const Channels& channels, Channel channel);

// By the cosine between the line of sight and the surface, as if the light were at the eye; what missed is
// white.
std::vector<std::uint8_t> lit_bytes(std::span<const Vec3f> normals, std::span<const Ray<double>> rays);

// Of the others, 8 bits a channel, rows from the top; what missed is white.
std::vector<std::uint8_t> channel_bytes(const Channels& channels, Channel channel);

} // namespace masu
