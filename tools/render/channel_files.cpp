#include "tools/render/channel_files.h"

#include "libscene/base/error.h"
#include "libscene/base/stopwatch.h"
#include "libscene/file/output_file.h"
#include "tools/common/number_list.h"
#include "tools/common/progress.h"
#include "tools/draw/value_picture.h"
#include "tools/lists/npy.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <type_traits>

namespace masu {
namespace {

// Calls act(values, NumPy's type, numbers a value).
template <class Act>
void with_values(const Channels& channels, Channel channel, const Act& act) {
  if (channel == Channel::depth) return act(std::span(channels.depth), "'<f4'", 1);
  if (channel == Channel::normal) return act(std::span(channels.normal), "'<f4'", 3);
  if (channel == Channel::object) return act(std::span(channels.object), "'<i4'", 1);
  if (channel == Channel::primitive) return act(std::span(channels.primitive), "'<i4'", 1);
  if (channel == Channel::cells) return act(std::span(channels.cells), "'<u4'", 1);
  if (channel == Channel::tests) return act(std::span(channels.tests), "'<u4'", 1);
  act(std::span(channels.idle), "'<f4'", 1);
}

void write_values(const Channels& channels, Channel channel, ChannelFormat format, const std::string& path) {
  OutputFile file(path);
  with_values(channels, channel, [&](const auto& values, const char* type, int numbers) {
    using Value = std::decay_t<decltype(values[0])>;
    const bool is_npy = format == ChannelFormat::npy;
    const std::string header = // -1: little-endian
        is_npy
            ? npy_header(type, fmt::format("{}, {}, {}", channels.rows, channels.columns,
                                           numbers > 1 ? fmt::format("{}, ", numbers) : ""))
            : fmt::format("{}\n{} {}\n-1.0\n", numbers == 3 ? "PF" : "Pf", channels.columns, channels.rows);
    file.write(header.data(), header.size());
    if (is_npy) return file.write(values.data(), values.size_bytes());
    const auto columns = static_cast<std::size_t>(channels.columns);
    std::vector<float> rounded(columns);
    for (std::int32_t row = channels.rows; row-- > 0;) { // from the bottom up
      const auto line = values.subspan(static_cast<std::size_t>(row) * columns, columns);
      if constexpr (std::is_arithmetic_v<Value>) {
        std::ranges::transform(line, rounded.begin(), [](Value v) { return static_cast<float>(v); });
        file.write(rounded.data(), rounded.size() * sizeof(float));
      } else {
        file.write(line.data(), line.size_bytes());
      }
    }
  });
  file.commit();
}

Drawing picture_of(const Channels& channels, Channel channel, bool all_rays, double high) {
  const std::string cost = all_rays ? "the camera ray and all rays that it spawns" : "the camera ray";
  const auto map = [&]<class T, class Memory>(const std::vector<T, Memory>& values) {
    return ValueMap<T>{channels.columns, channels.rows, values};
  };
  const auto value_map = [&](const auto& values, const Caption& caption) {
    const std::vector<double> numbers(values.begin(), values.end());
    return value_picture(map(numbers), caption);
  };
  const char* const without = "nothing is hit";
  switch (channel) {
  case Channel::depth:
    return value_map(channels.depth, {"depth: distance to the nearest hit", "scene units", without});
  case Channel::normal:
    return normal_picture(map(channels.normal), {"normal: of the front of the surface hit", "", without});
  case Channel::object:
    return name_picture(map(channels.object), {"object: which object is hit", "objects", without});
  case Channel::primitive:
    return name_picture(map(channels.primitive),
                        {"primitive: which primitive is hit", "primitives", without});
  case Channel::cells:
    return value_map(channels.cells,
                     {"cells: grid cells visited by " + cost, "cells", "", Caption::Values::counts, high});
  case Channel::tests:
    return value_map(channels.tests,
                     {"tests: primitives tested for " + cost, "tests", "", Caption::Values::counts, high});
  case Channel::idle: {
    const std::string mean =
        channels.warps.turns > 0
            ? fmt::format("; {:.1f} of {} are under way", channels.warps.mean_busy(), lanes_per_warp)
            : "";
    return value_map(channels.idle, {"idle: lanes of the warp that idle" + mean, "lanes", "",
                                     Caption::Values::counts, lanes_per_warp});
  }
  }
  return {};
}

} // namespace

std::vector<Channel> parse_channels(const std::string& names) {
  const auto fail = [](const std::string& why) { throw Error(ErrorCode::usage, "--channels", why); };
  std::vector<std::string> words = split(names);
  if (words.back().empty()) words.pop_back();
  std::vector<Channel> channels;
  for (const std::string& word : words) {
    const auto* const found =
        std::ranges::find_if(all_channels, [&](Channel channel) { return word == name_of(channel); });
    if (found == std::end(all_channels))
      fail(fmt::format("'{}' isn't one of depth, normal, object, primitive, cells, tests, idle", word));
    if (std::ranges::count(channels, *found) > 0) fail(fmt::format("'{}' is there twice", word));
    channels.push_back(*found);
  }
  if (channels.empty() || names.ends_with(',')) fail(fmt::format("'{}' isn't a list of channels", names));
  return channels;
}

ChannelFiles channel_files(const std::string& picture, Channel channel, ChannelFormat format) {
  std::string base = picture;
  for (const std::string_view ending : {".png", ".jpg", ".jpeg", ".pfm"})
    if (picture.ends_with(ending)) base.resize(picture.size() - ending.size());
  base += std::string(".") + name_of(channel);
  return {base + (format == ChannelFormat::npy ? ".npy" : ".pfm"), base + ".png"};
}

TracingReport write_channels(const ResidentTracer& tracer, const ChannelsJob& job, bool quiet) {
  Progress progress("tracing channels", quiet);
  const Stopwatch watch;
  TracingReport report;
  report.views = job.views.size();
  const auto views = static_cast<double>(job.views.size());
  for (std::size_t i = 0; i < job.views.size(); ++i) {
    ChannelsRequest request = job.request;
    request.frame.camera = job.views[i].camera;
    request.frame.progress = [&](double share) { progress((static_cast<double>(i) + share) / views); };
    const Channels channels = trace_channels(tracer, request);
    report.warps += channels.warps;
    report.totals.rays +=
        static_cast<std::uint64_t>(channels.columns) * static_cast<std::uint64_t>(channels.rows);
    for (const Channel channel : request.channels) {
      const ChannelFiles files = channel_files(job.pictures[i], channel, job.format);
      write_values(channels, channel, job.format, files.values);
      write_png(picture_of(channels, channel, request.all_rays, job.high), files.picture, job.texts);
    }
    progress((static_cast<double>(i) + 1) / views);
  }
  report.elapsed_seconds = watch.seconds();
  return report;
}

} // namespace masu
