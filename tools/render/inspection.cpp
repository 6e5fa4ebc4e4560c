#include "tools/render/inspection.h"

#include "libscene/base/error.h"
#include "libscene/file/output_file.h"
#include "renderer/walk_report.h"
#include "tools/common/number_list.h"
#include "tools/common/printable.h"
#include "tools/common/provenance.h"
#include "tools/render/difference.h"
#include "tools/report/walk_text.h"

#include <array>
#include <unordered_set>

namespace masu {
namespace {

// Of a walk that is printed: all of it, or an error. A ray's own walk is no larger than the grid and its
// lists, but rays may double in number with each depth.
constexpr std::size_t most_walk_rays = 32768;

// To standard output, or to the file of --json=FILE.
void write_text(const std::string& text, const std::string& path) {
  OutputFile file(path);
  file.write(text.data(), text.size());
  file.commit();
}

} // namespace

void Inspection::add_to(CLI::App& app) {
  app.add_option("--channels", channels,
                 "for each camera ray, files of values and of pictures beside that of -o: a list of depth, "
                 "normal, object, primitive, cells, tests");
  add_choice(app, "--channel-format", channel_format,
             {{"pfm", ChannelFormat::pfm}, {"npy", ChannelFormat::npy}},
             "format of the channels' values: .pfm, or .npy, a NumPy array");
  app.add_flag("--all-rays", all_rays,
               "count cells and tests of --channels, or report --walk, for a camera ray and all rays that it "
               "spawns, shadow rays too");
  app.add_flag("--no-picture", no_picture, "write the channels' files alone, and no picture to -o");
  auto* const pixel = app.add_option(
      "--walk", walk, "X,Y: print the way of this camera ray, counted from the top left, cell by cell");
  app.add_option("--walk-ray", walk_ray, "X,Y,Z,DX,DY,DZ: print the way of this ray")->excludes(pixel);
  app.add_flag("--json{-}", json, "print --walk or --difference as JSON; --json=FILE writes it to a file");
  app.add_option("--difference", difference,
                 "compare two pictures or channels (PNG, PFM, .npy); -o draws the differences")
      ->expected(2);
}

void Inspection::check(const std::string& output) const {
  const auto fail = [](const char* option, const char* why) { throw Error(ErrorCode::usage, option, why); };
  if (!channels.empty()) {
    static_cast<void>(parse_channels(channels));
    if (output.empty()) fail("--channels", "needs -o, which names the channels' files too");
    if (is_standard_output(output))
      fail("--channels", "needs a file name for -o, which names the channels' files too");
  } else if (no_picture) {
    fail("--no-picture", "is for --channels");
  }
  if (all_rays && channels.empty() && !has_walk()) fail("--all-rays", "is for --channels and --walk");
  if (!json.empty() && !has_walk() && difference.empty()) fail("--json", "is for --walk and --difference");
  if (!difference.empty() && (!channels.empty() || has_walk()))
    fail("--difference", "compares files and traces nothing: leave out --channels and --walk");
  const bool prints = json.empty() || is_standard_output(json);
  if (has_walk() && is_standard_output(output) && prints)
    fail("-o", "is standard output, where --walk prints: name a file");
  if (!difference.empty() && is_standard_output(output) && prints)
    fail("-o", "is standard output, where --difference prints: name a file");
  if (!walk.empty()) static_cast<void>(parse_numbers<std::int32_t, 2>("--walk", walk, "X,Y"));
  if (!walk_ray.empty())
    static_cast<void>(parse_numbers<double, 6>("--walk-ray", walk_ray, "X,Y,Z,DX,DY,DZ"));
}

void Inspection::check_channel_files(const std::vector<std::string>& pictures,
                                     const std::vector<std::string>& inputs,
                                     const std::vector<std::string>& outputs) const {
  if (channels.empty()) return;
  std::unordered_set<std::string> names(pictures.begin(), pictures.end());
  for (const std::string& picture : pictures) {
    std::vector<std::string> written = outputs;
    for (const Channel channel : parse_channels(channels)) {
      const ChannelFiles files = channel_files(picture, channel, channel_format);
      for (const std::string& file : {files.values, files.picture}) {
        if (!names.insert(file).second)
          throw Error(ErrorCode::usage, file, "would be written twice: give the pictures other names");
        written.push_back(file);
      }
    }
    check_files(inputs, written);
  }
}

ChannelsRequest Inspection::channels_request(const FrameRequest& frame) const {
  return {parse_channels(channels), frame, all_rays};
}

void print_walk(const Inspection& inspection, const Tracer& tracer, const FrameRequest& request) {
  WalkRequest walk{request.tracing};
  if (!inspection.walk.empty()) {
    const auto pixel = parse_numbers<std::int32_t, 2>("--walk", inspection.walk, "X,Y");
    walk = camera_walk(tracer, request, pixel[0], pixel[1]);
  } else {
    const auto n = parse_numbers<double, 6>("--walk-ray", inspection.walk_ray, "X,Y,Z,DX,DY,DZ");
    walk.ray = unbounded_ray<double>({n[0], n[1], n[2]}, {n[3], n[4], n[5]});
  }
  walk.all_rays = inspection.all_rays;
  walk.rules = request.rules;
  walk.limits.rays = most_walk_rays;
  walk.limits.counted = 0;
  const WalkReport report = trace_walk(tracer, walk);
  if (report.more_rays > 0)
    throw Error(ErrorCode::usage, "--all-rays",
                fmt::format("finds more than {} rays: give a smaller --depth", most_walk_rays));
  if (inspection.json.empty()) return write_text(walk_table(report), "-");
  nlohmann::ordered_json json = provenance();
  json["scene_hash"] = to_hex(tracer.scene().hash());
  json["grid_hash"] = tracer.grid() != nullptr ? nlohmann::ordered_json(to_hex(tracer.grid()->hash()))
                                               : nlohmann::ordered_json();
  json.update(walk_json(report));
  write_text(json_text(json) + "\n", inspection.json);
}

void print_difference(const Inspection& inspection, const std::string& output) {
  inspection.check(output);
  check_files(inspection.difference, {output, inspection.json});
  if (!output.empty() && !is_standard_output(output) && !output.ends_with(".png"))
    throw Error(ErrorCode::usage, output, "must end in .png: differences are drawn as PNG");
  const FloatPicture a = read_picture(inspection.difference[0]), b = read_picture(inspection.difference[1]);
  const Difference difference = difference_of(a, b, inspection.difference[1]);
  if (!output.empty()) write_png(difference_picture(difference), output, {{"Software", program_name()}});
  if (inspection.json.empty()) {
    std::string text =
        fmt::format("RMSE {:.6g}, largest difference {:.6g}", difference.rmse, difference.largest);
    if (difference.largest > 0) text += fmt::format(" at pixel {},{}", difference.x, difference.y);
    text += fmt::format("; {} of {} pixels differ", difference.different_pixels, difference.pixels.size());
    if (difference.incomparable_pixels > 0)
      text += fmt::format(", {} of them by a number that is infinite or NaN in one only",
                          difference.incomparable_pixels);
    return write_text(text + "\n", "-");
  }
  nlohmann::ordered_json json = provenance();
  json.update({{"width", difference.width},
               {"height", difference.height},
               {"rmse", difference.rmse},
               {"largest", difference.largest},
               {"largest_at", nlohmann::ordered_json::array({difference.x, difference.y})},
               {"different_pixels", difference.different_pixels},
               {"incomparable_pixels", difference.incomparable_pixels}});
  if (!(difference.largest > 0)) json["largest_at"] = nullptr;
  write_text(json_text(json) + "\n", inspection.json);
}

} // namespace masu
