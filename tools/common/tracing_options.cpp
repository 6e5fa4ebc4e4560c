#include "tools/common/tracing_options.h"

#include "libscene/base/error.h"
#include "libscene/file/scene_file.h"

#include <fmt/format.h>

namespace masu {

void TracingOptions::add_files(const CommandLine& command) {
  command.add_option("SCENE", scene, "scene file, from nff2bin or mesh2bin");
  command.add_option("GRID", grid, "grid file, from gridbuild; left out with --brute-force");
}

void TracingOptions::add_to(const CommandLine& command) {
  command.group("Tracing");
  add_backend(command, backend);
  command.add_option(
      "--devices", devices,
      "GPUs that share the work: all, or their numbers, such as 0,2; or cpu. Without it the first GPU, "
      "or what --backend says",
      "LIST");
  add_precision(command, rules.precision);
  add_first_cell_hit(command, rules.stop);
  command.add_flag("--brute-force", brute_force, "test every ray against every primitive, without a grid");
  command.add_flag("--resume", resume,
                   "keep the files that are there, and make those that are missing; a picture is made again "
                   "where its texts name another scene, view or options, a file without texts where the "
                   "report of --stats or --times does; else it is taken for what it is called");
  command.group("Reports");
  const Option counts =
      command.add_file("--stats", stats, "write ray counts and seconds as JSON; counting slows tracing down");
  command.add_file("--times", times, "write seconds as JSON, without counting").excludes({counts});
  command.add_option("--repeat", repeat, "trace N times and report the median's seconds")
      .range(1, 10000)
      .excludes({counts});
  command.add_quiet(quiet, "no progress and no summary on standard error");
  threads.add_to(command);
}

void TracingOptions::check(const char* tool) const {
  if (scene.empty())
    throw Error(ErrorCode::usage, "command line", fmt::format("SCENE is required: see {} --help", tool));
  check_scene_input(scene);
  if (grid.empty() && !brute_force)
    throw Error(ErrorCode::usage, "GRID", "is missing: name the grid file, or give --brute-force");
  if (!grid.empty() && brute_force)
    throw Error(ErrorCode::usage, "GRID", "isn't used by --brute-force: leave one of them out");
  if (rules.stop == StopRule::first_cell && brute_force)
    throw Error(ErrorCode::usage, "--first-cell-hit", "needs a grid: leave out --brute-force");
}

TracingRules TracingOptions::tracing() const {
  TracingRules tracing = rules;
  tracing.count = !stats.empty();
  return tracing;
}

void add_hit_name(const CommandLine& command, HitName& name, const std::string& what) {
  command.add_choice(
      "--hit-name", name,
      {{"object", HitName::object}, {"primitive", HitName::primitive}, {"face", HitName::face}},
      what + ": object (index in the NFF text, or of mesh2bin's objects), primitive (index in the scene "
             "file) or face (number in the mesh's file)");
}

} // namespace masu
