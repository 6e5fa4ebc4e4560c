// nff2bin: converts NFF text to a scene file, and reports the content of either.
#include "libscene/mesh/tessellate.h"
#include "libscene/nff/nff.h"
#include "tools/common/number_list.h"
#include "tools/common/progress.h"
#include "tools/report/scene_report.h"

#include <utility>

namespace masu {
namespace {

struct Settings {
  std::string input;
  SceneOutput output;
  int facets = 0; // --tessellate; 0: spheres and cones are kept
  bool quiet = false;
  Threads threads;
};

// The error message for an N of --tessellate; empty where it is valid.
std::string check_facets(const std::string& text) {
  const auto facets = read_number<int>(text);
  if (facets && *facets % 4 == 0 && *facets >= min_facets && *facets <= max_facets) return {};
  return fmt::format("'{}' isn't a multiple of 4 from {} to {}", text, min_facets, max_facets);
}

void convert(const Settings& settings) {
  Scene scene = [&] {
    Progress progress("reading", settings.quiet);
    return read_nff(settings.input, {.progress = std::ref(progress)});
  }();
  if (settings.facets > 0) scene = tessellated(std::move(scene), settings.facets);
  write_and_report("nff2bin", settings.input == "-" ? "stdin" : settings.input, scene, settings.output);
}

void run(const Settings& settings, const CommandLine& command) {
  settings.output.check();
  const auto limit = settings.threads.limit();
  check_files({settings.input}, {settings.output.path});
  if (settings.input == "-" || !is_scene_file(settings.input)) return convert(settings);
  if (!settings.output.path.empty())
    throw Error(ErrorCode::usage, settings.input,
                "is a scene file already: give an NFF file, or leave out -o");
  if (settings.facets > 0)
    throw Error(ErrorCode::usage, settings.input, "is a scene file already: --tessellate needs an NFF file");
  constexpr const char* is_stored = "is for a scene that is made: IN is a scene file already";
  command.refuse({{"--store", true, is_stored}, {"--origin", true, is_stored}});
  print_report(SceneFile(settings.input), settings.output.json);
}

void add_options(const CommandLine& command, Settings& settings) {
  command.footer("Example:\n  nff2bin balls.nff -o balls.scene");
  command.add_option("IN", settings.input, "NFF file, or - for standard input; with --info also a scene file")
      .required();
  settings.output.add_to(command);
  command
      .add_option("--tessellate", settings.facets,
                  "replace spheres and cones by triangles, N facets around: 2N triangles per cone (N if "
                  "pointed), 12(N/4)^2 per sphere; the SPD uses 12")
      .check(check_facets, fmt::format("{}..{}", min_facets, max_facets))
      .type_name("N");
  command.add_quiet(settings.quiet, "no progress on standard error");
  settings.threads.add_to(command);
}

} // namespace
} // namespace masu

int main(int argc, char** argv) {
  using namespace masu;
  return run_tool("nff2bin", "Converts NFF text to a scene file, and reports the content of either.", argc,
                  argv, add_options, run);
}
