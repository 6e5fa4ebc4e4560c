#include "tools/view/channel_colors.h"

#include "libscene/base/error.h"
#include "tools/draw/color_map.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace masu {
namespace {

constexpr Rgb missed{255, 255, 255};
constexpr const char* all_prefix = "all ";

bool counts(Channel channel) {
  return channel == Channel::cells || channel == Channel::tests;
}

// Of the categories that come first; others share them.
class NameColors {
public:
  NameColors() {
    for (std::size_t i = 0; i < colors_.size(); ++i)
      colors_[i] = category_color(i);
  }
  const Rgb& operator()(std::int32_t name) const {
    return name < 0 ? missed : colors_[static_cast<std::size_t>(name) % colors_.size()];
  }

private:
  std::array<Rgb, 1021> colors_{};
};

template <class ColorOf>
std::vector<std::uint8_t> colored(std::size_t pixels, const ColorOf& color_of) {
  std::vector<std::uint8_t> bytes(3 * pixels);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, pixels, 4096), [&](const auto& range) {
    for (std::size_t i = range.begin(); i != range.end(); ++i) {
      const Rgb color = color_of(i);
      bytes[3 * i] = color[0];
      bytes[3 * i + 1] = color[1];
      bytes[3 * i + 2] = color[2];
    }
  });
  return bytes;
}

const HostArray<std::uint32_t>& counts_of(const Channels& channels, Channel channel) {
  return channel == Channel::cells ? channels.cells : channels.tests;
}

} // namespace

std::vector<std::string> picture_channel_names() {
  std::vector<std::string> names{"shaded"};
  for (const Channel channel : all_channels)
    names.emplace_back(name_of(channel));
  for (const Channel channel : {Channel::cells, Channel::tests})
    names.push_back(std::string(all_prefix) + name_of(channel));
  return names;
}

PictureChannel parse_picture_channel(const std::string& name) {
  if (name == "shaded") return {};
  for (const Channel channel : all_channels) {
    if (name == name_of(channel)) return {channel, false};
    if (counts(channel) && name == std::string(all_prefix) + name_of(channel)) return {channel, true};
  }
  throw Error(ErrorCode::usage, "channel", "isn't one that pictures have");
}

bool has_range(const PictureChannel& channel) {
  return channel.channel && (channel.channel == Channel::depth || counts(*channel.channel));
}

std::optional<ValueRange> value_range(const Channels& channels, Channel channel) {
  if (channel == Channel::depth) {
    ValueRange range{INFINITY, -INFINITY};
    for (const float depth : channels.depth) {
      if (!std::isfinite(depth)) continue;
      range[0] = std::min(range[0], static_cast<double>(depth));
      range[1] = std::max(range[1], static_cast<double>(depth));
    }
    if (range[0] <= range[1]) return range;
  } else if (counts(channel)) {
    HostArray<std::uint32_t> values = counts_of(channels, channel);
    if (values.empty()) return {};
    const auto most = values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) * 999 / 1000);
    std::nth_element(values.begin(), most, values.end());
    return ValueRange{0, static_cast<double>(*most)};
  }
  return {};
}

std::vector<std::uint8_t> channel_bytes(const Channels& channels, Channel channel, const ValueRange& range) {
  const std::size_t pixels =
      static_cast<std::size_t>(channels.columns) * static_cast<std::size_t>(channels.rows);
  const ColorMap map;
  const double scale = range[1] > range[0] ? 1 / (range[1] - range[0]) : 0;
  const auto position = [&](double value) { return (value - range[0]) * scale; };
  switch (channel) {
  case Channel::depth:
    return colored(pixels, [&](std::size_t i) {
      const float depth = channels.depth[i];
      return std::isfinite(depth) ? map(position(static_cast<double>(depth))) : missed;
    });
  case Channel::normal:
    return colored(pixels, [&](std::size_t i) {
      const Vec3f& n = channels.normal[i];
      return n == Vec3f{0, 0, 0} ? missed : normal_color(n);
    });
  case Channel::object:
    return colored(pixels, [&, names = NameColors()](std::size_t i) { return names(channels.object[i]); });
  case Channel::primitive:
    return colored(pixels, [&, names = NameColors()](std::size_t i) { return names(channels.primitive[i]); });
  case Channel::cells:
  case Channel::tests:
    break;
  }
  return colored(pixels, [&](std::size_t i) { return map(position(counts_of(channels, channel)[i])); });
}

} // namespace masu
