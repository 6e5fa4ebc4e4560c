// gridrender's options to look at what rays do: --channels, --walk, --difference.
#pragma once

#include "tools/common/cli.h"
#include "tools/render/channel_files.h"

#include <optional>
#include <string>
#include <vector>

namespace masu {

struct Inspection {
  std::string channels, walk, walk_ray;
  std::string json;                    // empty: a table; -: standard output
  std::vector<std::string> difference; // two files, or none
  ChannelFormat channel_format = ChannelFormat::pfm;
  bool all_rays = false, no_picture = false;

  void add_to(CLI::App& app);
  bool has_walk() const { return !walk.empty() || !walk_ray.empty(); }
  // Throws Error(usage) for options that don't go together. `output`: of -o.
  void check(const std::string& output) const;
  // Throws Error(usage) where a file of a channel is an input, a picture or another output.
  void check_channel_files(const std::vector<std::string>& pictures, const std::vector<std::string>& inputs,
                           const std::vector<std::string>& outputs) const;
  ChannelsRequest channels_request(const FrameRequest& frame) const;
};

// Of one view's camera ray, or the given ray. Throws Error(usage, "--walk" or "--walk-ray", …), and
// Error(output).
void print_walk(const Inspection& inspection, const Tracer& tracer, const FrameRequest& request);

// Compares the two pictures; writes a picture of the differences to `output` unless that is empty. Throws
// Error(input), Error(output).
void print_difference(const Inspection& inspection, const std::string& output);

} // namespace masu
