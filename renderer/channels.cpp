#include "renderer/channels.h"

#include <algorithm>
#include <array>

namespace masu {
namespace {

template <class T>
HostArray<T> values_of(const HostArray<HitRecord>& hits, T HitRecord::*member) {
  HostArray<T> values(hits.size());
  std::ranges::transform(hits, values.begin(), member);
  return values;
}

// Of each ray's warp (picture_warps.h), and of all; 0 for a warp that has no turn.
void find_idle_lanes(const Frame& traced, Channels& channels) {
  channels.idle.resize(traced.cells.size());
  const auto for_each_ray = [&](std::int32_t first_column, std::int32_t first_row, const auto& act) {
    for (std::int32_t row = first_row; row < std::min(first_row + warp_rows, traced.rows); ++row)
      for (std::int32_t column = first_column; column < std::min(first_column + tile_side, traced.columns);
           ++column)
        act(static_cast<std::size_t>(row) * static_cast<std::size_t>(traced.columns) +
            static_cast<std::size_t>(column));
  };
  for (std::int32_t row = 0; row < traced.rows; row += warp_rows) {
    for (std::int32_t column = 0; column < traced.columns; column += tile_side) {
      WarpTurns warp;
      for_each_ray(column, row, [&](std::size_t ray) {
        warp.turns = std::max<std::uint64_t>(warp.turns, traced.cells[ray]);
        warp.busy_lanes += traced.cells[ray];
      });
      const float idle = warp.turns > 0 ? static_cast<float>(lanes_per_warp - warp.mean_busy()) : 0;
      for_each_ray(column, row, [&](std::size_t ray) { channels.idle[ray] = idle; });
      channels.warps += warp;
    }
  }
}

} // namespace

const char* name_of(Channel channel) {
  constexpr std::array names{"depth", "normal", "object", "primitive", "cells", "tests", "idle"};
  return names.at(static_cast<std::size_t>(channel));
}

Channels trace_channels(const ResidentTracer& tracer, const ChannelsRequest& request) {
  const auto has = [&](Channel channel) { return std::ranges::count(request.channels, channel) > 0; };
  const bool costs = has(Channel::cells) || has(Channel::tests) || has(Channel::idle);
  FrameRequest frame = request.frame;
  frame.rules.hit_name = HitName::primitive;
  frame.shaded = costs && request.all_rays;
  frame.attributes = has(Channel::normal) || has(Channel::object);
  frame.hits = frame.attributes || has(Channel::depth) || has(Channel::primitive);
  frame.costs = costs;
  frame.tracing.count = costs;
  Frame traced = tracer.render(frame);
  Channels channels;
  channels.columns = traced.columns;
  channels.rows = traced.rows;
  channels.counts = traced.counts;
  if (has(Channel::depth)) channels.depth = values_of(traced.hits, &HitRecord::t);
  if (has(Channel::primitive)) channels.primitive = values_of(traced.hits, &HitRecord::name);
  if (has(Channel::object)) channels.object = std::move(traced.objects);
  if (has(Channel::normal)) channels.normal = std::move(traced.normals);
  if (has(Channel::idle)) find_idle_lanes(traced, channels);
  if (has(Channel::cells)) channels.cells = std::move(traced.cells);
  if (has(Channel::tests)) channels.tests = std::move(traced.tests);
  return channels;
}

} // namespace masu
