// Channels as colours: numbers by the perceptually uniform map, names by colours that neighbours don't share.
#pragma once

#include "renderer/channels.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace masu {

// What a picture shows: the shaded picture, or a channel; of cells and tests the camera ray's alone, or the
// sum over all rays of a pixel.
struct PictureChannel {
  std::optional<Channel> channel{}; // none: shaded
  bool all_rays = false;
};

// As the page calls them: shaded, depth, …, "all cells".
std::vector<std::string> picture_channel_names();
// Throws Error(usage, "channel", …).
PictureChannel parse_picture_channel(const std::string& name);

// The values that the ends of the colour map stand for.
using ValueRange = std::array<double, 2>;

// Of channels whose colours stand for numbers: depth, cells, tests.
bool has_range(const PictureChannel& channel);

// Of depth: its least and greatest value; of cells and tests: 0 and the 99.9 % quantile, as in pictures that
// gridrender writes, so that a few extreme pixels don't take all colours. None where there are no such
// values.
std::optional<ValueRange> value_range(const Channels& channels, Channel channel);

// 8 bits a channel, rows from the top; what missed is white. `range`: needed for depth, cells and tests.
std::vector<std::uint8_t> channel_bytes(const Channels& channels, Channel channel, const ValueRange& range);

} // namespace masu
