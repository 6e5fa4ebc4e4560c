// nffgen: writes a scene of the Standard Procedural Databases as NFF text.
#include "libscene/file/output_file.h"
#include "libscene/spd/spd.h"
#include "tools/common/cli.h"
#include "tools/common/progress.h"

#include <optional>

namespace masu {
namespace {

struct Settings {
  std::string scene, output = "-";
  std::optional<int> size;
  bool no_background = false, quiet = false;
};

void add_options(const CommandLine& command, Settings& settings) {
  std::string sizes = "Sizes (standard, largest):";
  for (const SpdInfo& info : spd_scenes())
    sizes += fmt::format("\n  {:<7} {:>2} {:>5}", info.name, info.standard, info.max_size);
  command.footer(sizes + "\n\nExample:\n  nffgen teapot --size 10 -o teapot.nff");
  command.add_option("scene", settings.scene, "balls, gears, mount, nurbs, rings, teapot, tetra or tree")
      .required();
  command.add_option("--size", settings.size, "subdivision level (default: the standard size)");
  command.add_file("-o,--output", settings.output, "NFF file to write; - is standard output").shows_default();
  command.add_flag("--no-background", settings.no_background,
                   "leave out floors, walls, grounds, and the mountain's spheres");
  command.add_quiet(settings.quiet, "no progress on standard error");
}

void run(const Settings& settings) {
  const SpdInfo& info = spd_info(settings.scene);
  const int size = settings.size.value_or(info.standard);
  check_spd_size(info.scene, size); // before a file is opened
  Progress progress("writing", settings.quiet);
  OutputFile file(settings.output);
  write_spd({info.scene, size, !settings.no_background}, file.stream(), file.path(), std::ref(progress));
  file.commit();
}

} // namespace
} // namespace masu

int main(int argc, char** argv) {
  using namespace masu;
  return run_tool("nffgen", "Writes a scene of the Standard Procedural Databases (SPD) as NFF text.", argc,
                  argv, add_options, run);
}
