// Channels of views as files: the values, and pictures of them.
#pragma once

#include "renderer/channels.h"
#include "renderer/image/png_file.h"
#include "tools/jobs/tracing_report.h"
#include "tools/render/views.h"

#include <string>
#include <vector>

namespace masu {

enum class ChannelFormat { pfm, npy };

// Of a list such as "depth,cells". Throws Error(usage, --channels, …).
std::vector<Channel> parse_channels(const std::string& names);

// The files of a channel beside a picture: of p.png or p.jpg and depth, p.depth.pfm or p.depth.npy, and
// p.depth.png.
struct ChannelFiles {
  std::string values, picture;
};
ChannelFiles channel_files(const std::string& picture, Channel channel, ChannelFormat format);

struct ChannelsJob {
  ChannelsRequest request{}; // of every view but for the camera
  std::vector<View> views{};
  std::vector<std::string> pictures{}; // names, one for each view: channel_files() says what is written
  ChannelFormat format = ChannelFormat::pfm;
  std::uint32_t high = 0; // of the scale of cells' and tests' pictures; 0: of their own values
  PictureTexts texts{};
};

// Traces and writes one view after the other. PFM: float32, one channel, of normals three; .npy: shape (rows,
// columns), of normals (rows, columns, 3), float32 for depth, normals and idle, int32 for objects and
// primitives, uint32 for cells and tests. Shows the finished share unless `quiet`. The report has the camera
// rays' number and the seconds of tracing and writing together. Throws as trace_channels() does, and
// Error(output).
TracingReport write_channels(const ResidentTracer& tracer, const ChannelsJob& job, bool quiet);

} // namespace masu
