// nffgen: writes a scene of the Standard Procedural Databases as NFF text.
#include "libscene/file/output_file.h"
#include "libscene/spd/spd.h"
#include "tools/common/cli.h"
#include "tools/common/progress.h"

#include <fmt/format.h>

#include <string>

namespace {

struct Command {
  std::string scene, output = "-";
  int size = 0; // where it is given
  bool no_background = false, quiet = false;
};

void describe(CLI::App& app, Command& command) {
  std::string sizes = "Sizes (standard, largest):";
  for (const masu::SpdInfo& info : masu::spd_scenes())
    sizes += fmt::format("\n  {:<7} {:>2} {:>5}", info.name, info.standard, info.max_size);
  app.footer(sizes + "\n\nExample:\n  nffgen teapot --size 10 -o teapot.nff");
  app.add_option("scene", command.scene, "balls, gears, mount, nurbs, rings, teapot, tetra or tree")
      ->required();
  app.add_option("--size", command.size, "subdivision level (default: the standard size)");
  app.add_option("-o,--output", command.output, "NFF file to write; - is standard output")
      ->type_name("FILE")
      ->capture_default_str();
  app.add_flag("--no-background", command.no_background,
               "leave out floors, walls, grounds, and the mountain's spheres");
  masu::add_quiet(app, command.quiet, "no progress on standard error");
}

void write(const masu::SpdOptions& options, const std::string& output, bool quiet) {
  masu::Progress progress("writing", quiet);
  masu::OutputFile file(output);
  write_spd(options, file.stream(), file.path(), progress.callback());
  file.commit();
}

void run(const CLI::App& app, const Command& command) {
  const masu::SpdInfo& info = masu::spd_info(command.scene);
  const int size = app.count("--size") > 0 ? command.size : info.standard;
  masu::check_spd_size(info.scene, size); // before a file is opened
  write({info.scene, size, !command.no_background}, command.output, command.quiet);
}

} // namespace

int main(int argc, char** argv) {
  return masu::run_tool("nffgen", "Writes a scene of the Standard Procedural Databases (SPD) as NFF text.",
                        argc, argv, [](CLI::App& app, const auto& parse) {
                          Command command;
                          describe(app, command);
                          parse();
                          run(app, command);
                        });
}
