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
  if (has(Channel::idle)) {
    IdleLanes lanes = idle_lanes(traced.cells, traced.columns, traced.rows);
    channels.idle = std::move(lanes.idle);
    channels.warps = lanes.all;
  }
  if (has(Channel::cells)) channels.cells = std::move(traced.cells);
  if (has(Channel::tests)) channels.tests = std::move(traced.tests);
  return channels;
}

} // namespace masu
