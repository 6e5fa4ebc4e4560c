#include "libscene/base/error.h"
#include "libscene/base/parallel.h"
#include "tools/common/color_map.h"
#include "tools/view/viewer.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace masu {
namespace {

constexpr Rgb missed{255, 255, 255};

bool counts(Channel channel) {
  return channel == Channel::cells || channel == Channel::tests;
}

template <class ColorOf>
std::vector<std::uint8_t> colored(std::size_t pixels, const ColorOf& color_of) {
  std::vector<std::uint8_t> bytes(3 * pixels);
  parallel_ranges(pixels, 4096, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i != end; ++i) {
      const Rgb color = color_of(i);
      std::ranges::copy(color, &bytes[3 * i]);
    }
  });
  return bytes;
}

} // namespace

std::vector<std::pair<std::string, PictureChannel>> picture_channels() {
  std::vector<std::pair<std::string, PictureChannel>> all{{"shaded", {}}};
  for (const Channel channel : all_channels)
    all.push_back({name_of(channel), {channel}});
  for (const Channel channel : {Channel::cells, Channel::tests})
    all.push_back({std::string("all ") + name_of(channel), {channel, true}});
  all.push_back({"cut", {{}, false, true}});
  return all;
}

bool depends_on_grid(const PictureChannel& channel) {
  return channel.channel && (counts(*channel.channel) || channel.channel == Channel::idle);
}

bool has_values(const PictureChannel& channel) {
  return channel.channel && (channel.channel == Channel::depth || depends_on_grid(channel));
}

std::vector<float> channel_values(const Channels& channels, Channel channel) {
  if (channel == Channel::depth) return {channels.depth.begin(), channels.depth.end()};
  if (channel == Channel::idle) return {channels.idle.begin(), channels.idle.end()};
  const HostArray<std::uint32_t>& counts = channel == Channel::cells ? channels.cells : channels.tests;
  return {counts.begin(), counts.end()};
}

std::vector<std::uint8_t> lit_bytes(std::span<const Vec3f> normals, std::span<const Ray<double>> rays) {
  return colored(normals.size(), [&](std::size_t i) {
    if (normals[i] == Vec3f{0, 0, 0}) return missed;
    const double light = 0.3 + 0.7 * std::abs(dot(cast<double>(normals[i]), rays[i].direction));
    const auto byte = [&](int lightest) { return static_cast<std::uint8_t>(std::lround(light * lightest)); };
    return Rgb{byte(236), byte(229), byte(214)};
  });
}

std::vector<std::uint8_t> channel_bytes(const Channels& channels, Channel channel) {
  const std::size_t pixels =
      static_cast<std::size_t>(channels.columns) * static_cast<std::size_t>(channels.rows);
  if (channel == Channel::normal) {
    return colored(pixels, [&](std::size_t i) {
      const Vec3f& n = channels.normal[i];
      return n == Vec3f{0, 0, 0} ? missed : normal_color(n);
    });
  }
  const HostArray<std::int32_t>& of = channel == Channel::object ? channels.object : channels.primitive;
  std::array<Rgb, 1021> colors{}; // of the categories that come first; others share them
  for (std::size_t i = 0; i < colors.size(); ++i)
    colors[i] = category_color(i);
  return colored(pixels, [&](std::size_t i) {
    return of[i] < 0 ? missed : colors[static_cast<std::size_t>(of[i]) % colors.size()];
  });
}

} // namespace masu
