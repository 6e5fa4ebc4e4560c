// gridrender: reads a scene and its grid, and writes pictures of it, channels and the camera rays' hits.
#include "libscene/file/input_file.h"
#include "libscene/file/output_file.h"
#include "renderer/image/image.h"
#include "renderer/image/jpeg_file.h"
#include "tools/common/cli.h"
#include "tools/common/version.h"
#include "tools/jobs/parted_file.h"
#include "tools/jobs/tracing_tool.h"
#include "tools/render/channel_files.h"
#include "tools/render/frame_options.h"
#include "tools/render/render_views.h"
#include "tools/render/views.h"

#include <unordered_set>

namespace masu {
namespace {

enum class Format { automatic, png, jpeg, pfm };

struct Settings {
  TracingOptions tracing;
  FrameOptions frame;
  std::string output, hits, views, crop, channels;
  int turntable = 0; // views; 0: none
  Format format = Format::automatic;
  int quality = 90; // of a JPEG
  HitName hit_name = HitName::object;
  ChannelFormat channel_format = ChannelFormat::pfm;
  std::uint32_t channel_high = 0; // 0: of each picture's own values
  bool srgb = false, all_rays = false, no_picture = false;
};

// Of the picture, by --format or else by the name's end; PNG on standard output. Throws Error(usage).
ImageFormat format_of(const Settings& settings) {
  if (settings.format == Format::pfm) return ImageFormat::pfm;
  if (settings.format == Format::jpeg) return ImageFormat::jpeg;
  if (settings.format == Format::png || is_standard_output(settings.output)) return ImageFormat::png;
  return image_format(settings.output);
}

bool writes_jpeg(const Settings& settings) {
  return !settings.output.empty() && !settings.no_picture && format_of(settings) == ImageFormat::jpeg;
}

// Whether anything but channels is to be traced.
bool wants_picture(const Settings& settings) {
  return (!settings.output.empty() && !settings.no_picture) || !settings.hits.empty() ||
         !settings.tracing.report().empty();
}

void check(const Settings& settings, const Ranks& ranks) {
  const auto fail = [](const char* option, const char* why) { throw Error(ErrorCode::usage, option, why); };
  settings.tracing.check("gridrender");
  if (!settings.channels.empty()) {
    static_cast<void>(parse_channels(settings.channels));
    if (settings.output.empty()) fail("--channels", "needs -o, which names the channels' files too");
    if (is_standard_output(settings.output))
      fail("--channels", "needs a file name for -o, which names the channels' files too");
  }
  if (settings.output.empty() && !wants_picture(settings)) fail("-o", "is missing: nothing would be written");
  if (settings.tracing.resume && (settings.output.empty() || settings.no_picture) && settings.hits.empty())
    fail("--resume", "needs a picture or --hits: nothing else is kept");
  check_hits_name("--hits", settings.hits);
  if (!settings.output.empty()) static_cast<void>(format_of(settings));
  if (writes_jpeg(settings) && !has_libjpeg())
    fail("--format", "JPEG needs libjpeg-turbo, which wasn't found at build: write a PNG");
  if (ranks.count() > 1 && settings.views == "-") fail("--views", "must name a file, for several ranks");
  const TracingOptions& tracing = settings.tracing;
  check_files({tracing.scene, tracing.grid, settings.views},
              {settings.output, settings.hits, tracing.stats, tracing.times});
}

// --- Views ------------------------------------------------------------------------------------------------

// Throws Error(usage, option, …) for a camera that can't see, Error(input) for a list with such a one.
std::vector<View> views_of(const Settings& settings, const SceneFile& scene) {
  const Camera camera = settings.frame.camera(scene);
  // The lines of a list may give what is missing yet.
  if (const std::string& path = settings.views; !path.empty())
    return parse_views(read_text_input(path), path == "-" ? "stdin" : path, camera, camera_places(scene));
  settings.frame.check(camera, scene);
  return settings.turntable > 0 ? turntable(camera, settings.turntable) : std::vector<View>{{"0", camera}};
}

// Throws Error(usage) where a file is an input or would be written twice.
std::vector<ViewFiles> files_of(const Settings& settings, const std::vector<View>& views,
                                const Ranks& ranks) {
  const TracingOptions& tracing = settings.tracing;
  const auto pictures = file_names(settings.output, views), hits = file_names(settings.hits, views);
  const auto channels =
      settings.channels.empty() ? std::vector<Channel>{} : parse_channels(settings.channels);
  std::unordered_set<std::string> names(pictures.begin(), pictures.end()); // and of channels' files
  std::vector<ViewFiles> files;
  for (std::size_t i = 0; i < views.size(); ++i) {
    files.push_back({settings.no_picture ? "" : pictures[i], hits[i]});
    std::vector<std::string> written{pictures[i], hits[i], tracing.stats, tracing.times};
    for (const Channel channel : channels) {
      const ChannelFiles of_channel = channel_files(pictures[i], channel, settings.channel_format);
      for (const std::string& file : {of_channel.values, of_channel.picture}) {
        if (!names.insert(file).second)
          throw Error(ErrorCode::usage, file, "would be written twice: give the pictures other names");
        written.push_back(file);
      }
    }
    check_files({tracing.scene, tracing.grid, settings.views}, written);
    if (ranks.count() == 1 && !tracing.resume) continue;
    for (const std::string& name : {files[i].picture, files[i].hits})
      if (!name.empty()) check_is_file(name);
  }
  return files;
}

// What a picture's bytes depend on besides its view. Neither the grid nor the device is among it.
PictureTexts picture_texts(const Settings& settings, const SceneFile& scene) {
  const FrameOptions& frame = settings.frame;
  const TracingRules& rules = settings.tracing.rules;
  std::string options = fmt::format("--precision {} --sampling {} --depth {}", name_of(rules.precision),
                                    frame.sampling == Sampling::corners ? "corners" : "centers", frame.depth);
  if (rules.stop == StopRule::first_cell) options += " --first-cell-hit";
  if (frame.spd_rules) options += " --spd-rules";
  if (frame.hither) options += " --hither";
  if (settings.srgb) options += " --srgb";
  if (writes_jpeg(settings)) options += fmt::format(" --quality {}", settings.quality);
  return {{"Software", program_name()}, {"Source", "scene " + to_hex(scene.hash())}, {"Options", options}};
}

ViewsRequest views_request(const Settings& settings, const OpenedScene& opened, const Ranks& ranks) {
  const SceneFile& scene = opened.scene;
  ViewsRequest request;
  request.frame = settings.frame.frame(settings.tracing.tracing());
  request.frame.rules.hit_name = settings.hit_name;
  request.frame.hits = !settings.hits.empty();
  request.views = views_of(settings, scene);
  request.files = files_of(settings, request.views, ranks);
  request.hit_fields = hit_fields(usual_fields(settings.hit_name));
  if (!settings.crop.empty())
    for (const View& view : request.views)
      request.frame.window = cropped("--crop", settings.crop, view.camera, settings.frame.sampling);
  if (!settings.output.empty() && !settings.no_picture)
    request.image = {format_of(settings), settings.frame.sampling, settings.srgb,
                     picture_texts(settings, scene), settings.quality};
  request.repeat = settings.tracing.repeat;
  request.resume = resume_of(settings.tracing, opened);
  return request;
}

// --- The tool's run ---------------------------------------------------------------------------------------

// Options that would have no effect are errors.
void refuse_useless(const CommandLine& command, const Settings& settings) {
  const bool has_picture = !settings.output.empty() && !settings.no_picture;
  const auto channels =
      settings.channels.empty() ? std::vector<Channel>{} : parse_channels(settings.channels);
  const bool has_costs =
      std::ranges::count(channels, Channel::cells) + std::ranges::count(channels, Channel::tests) > 0;
  command.refuse(
      {{"--hit-name", settings.hits.empty(), "is for --hits"},
       {"--format", !has_picture, "is for a picture: give -o"},
       {"--srgb", !has_picture || format_of(settings) == ImageFormat::pfm, "is for pictures in PNG or JPEG"},
       {"--quality", !writes_jpeg(settings), "is for pictures in JPEG"},
       {"--no-picture", channels.empty(), "is for --channels"},
       {"--all-rays", channels.empty(), "is for --channels"},
       {"--channel-format", channels.empty(), "is for --channels"},
       {"--channel-high", channels.empty(), "is for --channels"},
       {"--channel-high", !channels.empty() && !has_costs, "is for the channels cells and tests"}});
}

void render(const Settings& settings, Ranks& ranks) {
  check(settings, ranks);
  const bool quiet = settings.tracing.quiet || ranks.rank() > 0;
  const OpenedScene opened("gridrender", settings.tracing, gpus_of(settings.tracing, ranks));
  const ViewsRequest views = views_request(settings, opened, ranks);
  TracingReport report;
  if (wants_picture(settings)) report = render_views(opened.tracer, views, ranks, quiet);
  if (ranks.rank() > 0) return;
  if (!settings.channels.empty()) {
    const TracingReport channels =
        write_channels(opened.tracer,
                       {{parse_channels(settings.channels), views.frame, settings.all_rays},
                        views.views,
                        file_names(settings.output, views.views),
                        settings.channel_format,
                        settings.channel_high,
                        picture_texts(settings, opened.scene)},
                       settings.tracing.quiet);
    if (channels.warps.turns > 0 && !quiet)
      print_note("gridrender: {:.1f} of {} lanes of a warp under way, on average over its turns\n",
                 channels.warps.mean_busy(), lanes_per_warp);
    if (!wants_picture(settings)) report = channels;
  }
  write_reports("gridrender", settings.tracing, opened, ranks, report, quiet);
}

void add_options(const CommandLine& command, Settings& settings) {
  command.footer("Example:\n  gridrender balls.scene balls.grid -o balls.png --size 1024x768");
  settings.tracing.add_files(command);
  command.group("Output");
  command.add_file("-o,--output", settings.output,
                   "picture: .png, .jpg, or .pfm for linear floats; - is standard output; of several views "
                   "with {index} or {name} in it");
  command.add_choice(
      "--format", settings.format,
      {{"auto", Format::automatic}, {"png", Format::png}, {"jpg", Format::jpeg}, {"pfm", Format::pfm}},
      "the picture's format; auto: by the name's end, PNG on standard output");
  command.add_number("--quality", settings.quality, 1, 100, "of a JPEG: 100 is best");
  command.add_flag("--srgb", settings.srgb,
                   "encode PNG and JPEG values as sRGB; without it they are stored as they are");
  command.add_file(
      "--hits", settings.hits,
      "write a record for each camera ray: float t (infinity for a miss), int32 object (-1 for a "
      "miss); .npy: a NumPy array; .csv: text; - is standard output");
  add_hit_name(command, settings.hit_name, "what --hits identifies");
  command.group("Camera");
  settings.frame.add_camera(command);
  command.add_option("--crop", settings.crop, "render only these pixels of the picture", "X,Y,W,H");
  const Option views =
      command.add_file("--views", settings.views,
                       "render the views of a list, a JSON object per line: name, from, at, up, angle, size; "
                       "- is standard input");
  command.add_option("--turntable", settings.turntable, "render N views around the point looked at")
      .range(1, 1000000)
      .excludes({views});
  command.group("Rays");
  settings.frame.add_sampling(command);
  settings.frame.add_secondary(command);
  command.group("Channels");
  command.add_option(
      "--channels", settings.channels,
      "for each camera ray, files of values and of pictures beside that of -o: a list of depth, "
      "normal, object, primitive, cells, tests, idle",
      "LIST");
  command.add_choice("--channel-format", settings.channel_format,
                     {{"pfm", ChannelFormat::pfm}, {"npy", ChannelFormat::npy}},
                     "format of the channels' values: .pfm, or .npy, a NumPy array");
  command
      .add_option(
          "--channel-high", settings.channel_high,
          "upper end of the scale in pictures of cells and tests, so that they can be compared; default: "
          "of each picture's own values")
      .range(1, 1 << 30);
  command.add_flag("--all-rays", settings.all_rays,
                   "count cells and tests of a camera ray and all rays that it spawns, shadow rays too");
  command.add_flag("--no-picture", settings.no_picture,
                   "write the channels' files alone, and no picture to -o");
  settings.tracing.add_to(command);
}

} // namespace
} // namespace masu

int main(int argc, char** argv) {
  using namespace masu;
  Ranks ranks;
  return ranks.ended(run_tool("gridrender", "Renders pictures of a scene through its grid.", argc, argv,
                              [&](const CommandLine& command, const auto& parse) {
                                Settings settings;
                                add_options(command, settings);
                                parse();
                                ranks.start();
                                const auto limit = limit_threads(settings.tracing, ranks);
                                refuse_useless(command, settings);
                                render(settings, ranks);
                              },
                              {Ranks::prints_help, [&] { return ranks.is_first_to_fail(); }}));
}
