// gridview: a scene and its grids as a page in the browser, served on the loopback address.
#include "tools/common/backend.h"
#include "tools/common/cli.h"
#include "tools/common/number_list.h"
#include "tools/common/progress.h"
#include "tools/view/http_server.h"
#include "tools/view/viewer.h"

#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <string_view>

namespace masu {
namespace {

constexpr int usual_port = 8765;

struct Settings {
  std::string scene, demo;
  std::vector<std::string> grids;
  Precision precision = Precision::automatic;
  Backend backend = Backend::automatic;
  std::string address = "127.0.0.1";
  int port = -1; // the usual one, or any that is free
  bool token = false, quiet = false;
  std::string size;
  std::vector<std::string> slices{"x,0.25", "x,0.5",  "x,0.75", "y,0.25", "y,0.5",
                                  "y,0.75", "z,0.25", "z,0.5",  "z,0.75"};
  std::vector<std::string> rays;
  ExportSettings exported; // to a file, where it has a path
  Threads threads;
};

HttpServer listening(const Settings& settings, const std::string& token, const HttpHandler& handler) {
  const auto at = [&](int port) { return HttpServer(settings.address, port, token, handler); };
  if (settings.port >= 0) return at(settings.port);
  try {
    return at(usual_port);
  } catch (const Error&) { // taken
    const bool colored = isatty(STDERR_FILENO) != 0 && std::getenv("NO_COLOR") == nullptr;
    if (!settings.quiet)
      print_note(
          "{}gridview: port {} is taken, perhaps by another gridview: links that name this port, as the "
          "lesson's do, open what that one shows. End it, or change the port in them{}\n",
          colored ? "\033[1;33m" : "", usual_port, colored ? "\033[0m" : "");
    return at(0);
  }
}

void print_address(const Settings& settings, int port, const std::string& token, const std::string& device) {
  const std::string host =
      settings.address.find(':') == std::string::npos ? settings.address : "[" + settings.address + "]";
  fmt::print("http://{}:{}/{}\n", host, port, token.empty() ? "" : "?token=" + token);
  flush_standard_output();
  if (settings.quiet) return;
  print_note("gridview: traces on {}; Ctrl+C ends it\n", device);
  if (is_loopback_address(settings.address))
    print_note("gridview: from another machine: ssh -L {0}:{1}:{0} HOST, then open the same address there\n",
               port, host);
  else
    print_note("gridview: anybody who has the token can look, and so can who reads the network: ssh -L and "
               "127.0.0.1 are safer\n");
}

SharePlane parse_slice(const std::string& text) {
  const std::size_t axis = text.substr(0, 2).ends_with(',') ? std::string_view("xyz").find(text[0]) : 3;
  const auto share =
      read_number<double>(std::string_view(text).substr(std::min<std::size_t>(2, text.size())));
  if (axis > 2 || !share || !(*share >= 0 && *share <= 1))
    throw Error(ErrorCode::usage, "--slices", fmt::format("'{}' isn't an axis and a share, as y,0.5", text));
  return {static_cast<int>(axis), *share};
}

void check_export(Settings& settings) {
  for (const std::string& slice : settings.slices)
    settings.exported.slices.push_back(parse_slice(slice));
  for (const std::string& ray : settings.rays) {
    const auto n = parse_numbers<double, 6>("--rays", ray, "X,Y,Z,DX,DY,DZ");
    settings.exported.rays.push_back(unbounded_ray<double>({n[0], n[1], n[2]}, {n[3], n[4], n[5]}));
  }
  if (!settings.exported.path.ends_with(".html"))
    throw Error(ErrorCode::usage, settings.exported.path, "is a page: give a name that ends in .html");
  if (!settings.rays.empty())
    settings.exported.opens_with =
        fmt::format("#view=plane&slice={}&ray={}", settings.slices[0], settings.rays[0]);
  std::vector<std::string> inputs = settings.grids;
  inputs.push_back(settings.scene);
  check_files(inputs, {settings.exported.path});
}

void run(Settings& settings) {
  if (!settings.size.empty()) {
    const Camera camera = resized({}, settings.size);
    if (std::int64_t{camera.width} * camera.height > most_pixels)
      throw Error(ErrorCode::usage, "--size", fmt::format("has more than {} pixels", most_pixels));
    settings.exported.width = camera.width;
    settings.exported.height = camera.height;
  }
  if (settings.scene.empty() && settings.demo.empty())
    throw Error(ErrorCode::usage, "SCENE", "is needed, or --demo instead: gridview --demo teapot");
  const bool is_exported = !settings.exported.path.empty();
  if (is_exported) check_export(settings);
  const auto limit = settings.threads.limit();
  const bool cuda = use_cuda(settings.backend);
  const auto open = [&] {
    return Viewer(viewed_files(settings.scene, settings.grids, settings.demo, settings.quiet),
                  cuda ? Device::cuda : Device::cpu, settings.precision);
  };
  if (is_exported) {
    Progress progress("exporting", settings.quiet);
    return export_page(open(), settings.exported, std::ref(progress));
  }
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) // end it at once, whatever is being traced
    std::signal(signal, [](int) { std::_Exit(0); });
  const Viewer viewer = open();
  const std::string token = settings.token || !is_loopback_address(settings.address) ? random_token() : "";
  HttpServer server =
      listening(settings, token, [&viewer](const HttpRequest& request) { return answer(viewer, request); });
  std::string device = device_name(cuda);
  if (const std::string why = why_no_gpu(settings.backend); !why.empty()) device += fmt::format(" ({})", why);
  print_address(settings, server.port(), token, device);
  server.serve();
}

void add_options(const CommandLine& command, Settings& settings) {
  command.footer(
      "Example:\n  gridview --demo teapot\n  gridview bunny.ply\n  gridview balls.scene balls.grid");
  const Option scene = command.add_option(
      "SCENE", settings.scene,
      "scene file, from nff2bin or mesh2bin; without a GRID also NFF, OBJ, PLY, STL or OFF");
  command
      .add_option(
          "GRID", settings.grids,
          "grid files of the scene, from gridbuild; without one a hierarchy and an irregular grid are "
          "built in memory")
      .values(0, 16);
  command
      .add_option("--demo", settings.demo,
                  "instead of SCENE: a scene that nffgen makes, and in memory a uniform grid, one merged by "
                  "balance, an irregular one and a hierarchy",
                  "NAME")
      .excludes({scene});
  command.group("Server");
  const Option port =
      command
          .add_option(
              "--port", settings.port,
              fmt::format("port to listen on; 0: any that is free; without it {}, or any where that is taken",
                          usual_port))
          .range(0, 65535);
  const Option bind =
      command
          .add_option("--bind", settings.address,
                      "address to listen on; any but loopback's needs the token that is printed", "ADDRESS")
          .shows_default();
  const Option token =
      command.add_flag("--token", settings.token, "ask for a token on the loopback address, too");
  command.group("Instead of a server");
  const Option file = command
                          .add_file("--export", settings.exported.path,
                                    "write the page to this .html instead of serving it: pictures around "
                                    "the scene, channels, slices and statistics in one file")
                          .excludes({port, bind, token});
  command.add_number("--views", settings.exported.views, 1, 360, "of --export: how many, on a circle");
  command.add_option("--size", settings.size, "of --export: pixels instead of 640x480", "WxH");
  command
      .add_option("--slices", settings.slices,
                  "of --export: instead of those at 25, 50 and 75 % of each axis; the fewer, the more rays",
                  "AXIS,SHARE")
      .values(1, 64);
  command
      .add_option("--rays", settings.rays,
                  "of --export: also to be walked, in the slices; the first is shown", "X,Y,Z,DX,DY,DZ")
      .values(1, 64);
  command.add_number("--boxes", settings.exported.most_boxes, 1, 100000,
                     "of --export: at most, of each depth");
  command.group_needs("Instead of a server", file);
  command.group("Tracing");
  add_backend(command, settings.backend);
  add_precision(command, settings.precision);
  command.add_quiet(settings.quiet, "print the address alone");
  settings.threads.add_to(command);
}

} // namespace
} // namespace masu

int main(int argc, char** argv) {
  using namespace masu;
  return run_tool("gridview", "Shows a scene and its grids as a page in the browser.", argc, argv,
                  add_options, run);
}
