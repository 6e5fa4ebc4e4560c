#include "renderer/channels.h"

#include "renderer/view_precision.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>

namespace masu {
namespace {

constexpr std::int64_t rays_per_band = 1 << 22;

template <class T>
T* part_of(HostArray<T>& values, std::size_t first) {
  return values.empty() ? nullptr : values.data() + first;
}

// The hits and the costs of camera rays alone: as a list of rays, band by band.
template <class Real>
void trace_camera_rays(const Tracer& tracer, const FrameRequest& frame, bool count, Channels& channels) {
  const auto rays = camera_rays<Real>(relative_to(tracer.scene().origin(), frame.camera), frame.sampling,
                                      frame.hither, frame.window);
  const auto columns = static_cast<std::size_t>(rays.columns);
  const auto band_rows =
      static_cast<std::int32_t>(std::clamp<std::int64_t>(rays_per_band / rays.columns, 1, rays.rows));
  HostArray<Ray<Real>> band;
  RaysRequest request;
  request.tracing = frame.tracing;
  request.tracing.count = count;
  request.loop = RayLoop::thread_per_ray;
  for (std::int32_t first_row = 0; first_row < rays.rows; first_row += band_rows) {
    const std::int32_t end_row = std::min(first_row + band_rows, rays.rows);
    band.resize(static_cast<std::size_t>(end_row - first_row) * columns);
    tbb::parallel_for(tbb::blocked_range<std::int32_t>(first_row, end_row), [&](const auto& range) {
      auto ray = band.begin() + static_cast<std::ptrdiff_t>(range.begin() - first_row) * rays.columns;
      for (std::int32_t row = range.begin(); row != range.end(); ++row)
        for (std::int32_t column = 0; column < rays.columns; ++column)
          *ray++ = camera_ray(rays, column, row);
    });
    const std::size_t first = static_cast<std::size_t>(first_row) * columns;
    RayResults results;
    results.t = part_of(channels.depth, first);
    results.primitive = reinterpret_cast<std::uint32_t*>(part_of(channels.primitive, first));
    results.object = reinterpret_cast<std::uint32_t*>(part_of(channels.object, first));
    static_assert(sizeof(Vec3f) == sizeof(float[3]));
    results.normal = reinterpret_cast<float(*)[3]>(part_of(channels.normal, first));
    if (count) results.costs = {part_of(channels.cells, first), part_of(channels.tests, first)};
    const QueryReport report =
        tracer.trace(relative(RayList(std::span<const Ray<Real>>(band))), results, request);
    if (count) channels.counts += report.counts;
    if (frame.progress) frame.progress(static_cast<double>(end_row) / rays.rows);
  }
}

} // namespace

const char* name_of(Channel channel) {
  constexpr std::array names{"depth", "normal", "object", "primitive", "cells", "tests"};
  return names.at(static_cast<std::size_t>(channel));
}

Channels trace_channels(const Tracer& tracer, const ChannelsRequest& request) {
  const FrameRequest& frame = request.frame;
  const auto has = [&](Channel channel) { return std::ranges::count(request.channels, channel) > 0; };
  const auto size_if = [](bool wanted, std::size_t size) { return wanted ? size : 0; };
  const bool costs = has(Channel::cells) || has(Channel::tests);
  const bool hits =
      has(Channel::depth) || has(Channel::normal) || has(Channel::object) || has(Channel::primitive);
  check_request(frame);
  Channels channels;
  const RayWindow window = window_of(frame);
  channels.columns = window.columns;
  channels.rows = window.rows;
  const std::size_t rays = static_cast<std::size_t>(window.columns) * static_cast<std::size_t>(window.rows);
  channels.depth.resize(size_if(has(Channel::depth), rays));
  channels.normal.resize(size_if(has(Channel::normal), rays));
  channels.object.resize(size_if(has(Channel::object), rays));
  channels.primitive.resize(size_if(has(Channel::primitive), rays));
  channels.cells.resize(size_if(has(Channel::cells), rays));
  channels.tests.resize(size_if(has(Channel::tests), rays));
  if (hits || (costs && !request.all_rays)) {
    const bool count = costs && !request.all_rays;
    FrameRequest traced = frame;
    traced.tracing.precision = picture_precision(tracer, frame);
    traced.tracing.precision == Precision::doubled
        ? trace_camera_rays<double>(tracer, traced, count, channels)
        : trace_camera_rays<float>(tracer, traced, count, channels);
  }
  if (costs && request.all_rays) {
    FrameRequest counted = frame;
    counted.hits = false;
    counted.costs = true;
    Frame traced = tracer.render(counted);
    if (has(Channel::cells)) channels.cells = std::move(traced.cells);
    if (has(Channel::tests)) channels.tests = std::move(traced.tests);
    channels.counts = traced.counts;
  }
  return channels;
}

} // namespace masu
