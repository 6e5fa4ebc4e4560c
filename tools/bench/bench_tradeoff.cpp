// Speed against accuracy of every precision, stop rule and grid: measurements, charts and Pareto fronts.
#include "tools/bench/bench.h"
#include "tools/bench/command.h"
#include "tools/bench/gnuplot.h"
#include "tools/bench/tradeoff/tradeoff_csv.h"
#include "tools/bench/tradeoff/tradeoff_front.h"
#include "tools/bench/tradeoff/tradeoff_measure.h"
#include "tools/common/progress.h"
#include "tradeoff_script.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>
#include <set>
#include <vector>

namespace masu {
namespace {

struct Settings {
  std::vector<std::string> scenes;
  std::string folder;
  Backend backend = Backend::automatic;
  std::vector<std::string> precisions{"robust", "double"}, stops{"proven", "first-cell-hit"},
      merges{"none", "x", "balance", "irregular", "bvh"}, overlaps{"box", "exact"},
      divisions{"16", "64", "auto"}, curve{"1", "2", "4", "8", "16", "32", "64", "128", "256", "auto"};
  // Empty and 0: defaults of the backend, which take it a few minutes.
  std::string size, picture;
  std::uint64_t random = 0, compared = 0, repeat = 0, seed = 1;
  bool charts_only = false;
};

TradeoffSetup setup_of(const Settings& settings, bool cuda) {
  const auto or_default = [](std::uint64_t given, std::uint64_t otherwise) {
    return given > 0 ? given : otherwise;
  };
  TradeoffSetup setup;
  setup.backend = cuda ? "cuda" : "cpu";
  setup.threads = cuda ? 0 : allowed_threads();
  setup.size = !settings.size.empty() ? settings.size : cuda ? "1024x1024" : "256x256";
  setup.random = or_default(settings.random, cuda ? 1 << 20 : 1 << 16);
  setup.compared = or_default(settings.compared, cuda ? 1 << 20 : 1 << 15);
  setup.picture = !settings.picture.empty() ? settings.picture : cuda ? "512x512" : "128x128";
  setup.seed = settings.seed;
  setup.repeat = or_default(settings.repeat, cuda ? 15 : 3);
  return setup;
}

// The configurations of one grid: precisions and stop rules.
using GridPlan = std::vector<Configuration>;

// All configurations, each once, in the order of the CSV's rows. Scenes stored in float64 have only double
// precision. Throws Error(usage) for an invalid division.
std::vector<GridPlan> plan_of(const Settings& settings, bool float64) {
  std::vector<GridPlan> plan;
  const auto add = [&](const Configuration& c) {
    if (float64 && c.precision != Precision::doubled) return;
    auto grid = std::ranges::find_if(plan, [&](const GridPlan& planned) {
      const Configuration& g = planned.front();
      return g.merge == c.merge && g.division == c.division && g.overlap == c.overlap;
    });
    if (grid == plan.end())
      plan.push_back({c});
    else if (std::ranges::find(*grid, c) == grid->end())
      grid->push_back(c);
  };
  for (const std::string& merge : settings.merges) {
    // A hierarchy has no division, no overlap test and no cells.
    if (named<StructureKind>(merge) == StructureKind::hierarchy) {
      for (const std::string& precision : settings.precisions)
        if (contains(settings.stops, "proven"))
          add({named<Precision>(precision), StopRule::proven, StructureKind::hierarchy, "auto",
               Overlap::exact});
      continue;
    }
    // The top level of an irregular grid always has the automatic division.
    const bool own = named<StructureKind>(merge) == StructureKind::irregular;
    for (const std::string& division : own ? std::vector<std::string>{"auto"} : settings.divisions) {
      static_cast<void>(parse_division(division));
      for (const std::string& overlap : settings.overlaps)
        for (const std::string& precision : settings.precisions)
          for (const std::string& stop : settings.stops)
            add({named<Precision>(precision), named<StopRule>(stop), named<StructureKind>(merge), division,
                 named<Overlap>(overlap)});
    }
  }
  const bool robust = contains(settings.precisions, "robust");
  for (const std::string& division : settings.curve) {
    static_cast<void>(parse_division(division));
    add({float64  ? Precision::doubled
         : robust ? Precision::robust
                  : named<Precision>(settings.precisions.front()),
         StopRule::proven, StructureKind::uniform, division, Overlap::exact});
  }
  return plan;
}

StructureFile built(const SceneFile& scene, const Configuration& grid) {
  BuildOptions options;
  options.division = parse_division(grid.division);
  options.structure.kind = grid.merge;
  options.overlap = grid.overlap;
  return built_in_memory(scene, options);
}

// A scene's name in charts and tables: its file's name with letters, digits, - . and _ only.
std::string name_of_scene(const std::string& path) {
  std::string name = std::filesystem::path(path).stem().string();
  for (char& c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '-' && c != '.') c = '_';
  }
  return name;
}

// Throws Error(usage) where two charts would have the same name, or an output would replace a scene.
void check_names(const std::vector<std::string>& scenes, const std::string& folder) {
  std::set<std::string> taken{"all", "tradeoff", "division"}; // all: the mean's rows
  for (const std::string& path : scenes) {
    if (!taken.insert(name_of_scene(path)).second)
      throw Error(
          ErrorCode::usage, path,
          fmt::format("'{}' would name two charts: give the scene's file another name", name_of_scene(path)));
  }
  std::vector<std::string> outputs{folder + "/tradeoff.csv", folder + "/charts.csv"};
  for (const std::string& name : taken) {
    for (const char* const kind : {".svg", ".png"})
      outputs.push_back(fmt::format("{}/{}{}", folder, name, kind));
  }
  check_files(scenes, outputs);
}

// Measures configurations that aren't among `rows` yet, and appends them to `rows` and to the file.
void measure_scene(const Settings& settings, const TradeoffSetup& setup, const std::string& path,
                   TradeoffCsv& csv, std::vector<TradeoffRow>& rows) {
  const SceneFile scene(path);
  const std::string name = name_of_scene(path), hash = to_hex(scene.hash());
  std::vector<GridPlan> plan = plan_of(settings, scene.is_float64());
  if (plan.empty())
    static_cast<void>(resolved(named<Precision>(settings.precisions.front()), scene)); // throws
  std::size_t to_do = 0;
  for (GridPlan& grid : plan) {
    std::erase_if(grid, [&](const Configuration& c) {
      return std::ranges::any_of(rows, [&](const TradeoffRow& row) {
        return row.scene == name && row.scene_hash == hash && row.setup == setup && row.configuration == c;
      });
    });
    to_do += grid.size();
  }
  if (to_do == 0) return;
  Progress progress(name.c_str());
  const TradeoffTask task(scene, setup);
  double done = 0;
  const auto step = [&] { progress(++done / static_cast<double>(to_do + 1)); };
  step();
  for (const GridPlan& configurations : plan) {
    if (configurations.empty()) continue;
    const StructureFile grid = built(scene, configurations.front());
    for (const Configuration& configuration : configurations) {
      rows.push_back({name, hash, setup, configuration, measure(task, grid, configuration)});
      csv.add(rows.back());
      step();
    }
  }
}

// Rows with that setup, and of scenes of the same name those of the scene measured last: rows that can be
// compared.
std::vector<TradeoffRow> comparable(const std::vector<TradeoffRow>& rows, const TradeoffSetup& setup,
                                    std::map<std::string, std::string> hashes) {
  for (std::size_t i = rows.size(); i-- > 0;) {
    if (rows[i].setup == setup) hashes.emplace(rows[i].scene, rows[i].scene_hash); // keeps an earlier one
  }
  std::vector<TradeoffRow> kept;
  std::copy_if(rows.begin(), rows.end(), std::back_inserter(kept), [&](const TradeoffRow& row) {
    return row.setup == setup && hashes.at(row.scene) == row.scene_hash;
  });
  return kept;
}

// The rows of each scene, and the mean of all scenes where there are several.
std::vector<std::vector<TradeoffRow>> groups_of(const std::vector<TradeoffRow>& rows) {
  std::vector<std::vector<TradeoffRow>> groups;
  for (const TradeoffRow& row : rows) {
    auto group = std::ranges::find_if(groups, [&](const auto& g) { return g.front().scene == row.scene; });
    if (group == groups.end()) group = groups.insert(groups.end(), std::vector<TradeoffRow>{});
    group->push_back(row);
  }
  if (groups.size() > 1) groups.push_back(over_all_scenes(rows));
  return groups;
}

// Two lines: what it costs, and below it how accurate it is.
void print_row(const Output& output, const TradeoffRow& row) {
  const Measurement& m = row.measured;
  const Accuracy& a = m.accuracy;
  output.print("{:<22} {:<20} {:>9.2f} {:>9.3f} {:>7.2f} {:>7.2f}\n", method_of(row.configuration),
               grid_of(row.configuration), m.mrays, m.picture_ms, static_cast<double>(m.grid_bytes) * 1e-6,
               static_cast<double>(m.grid_bytes + m.scene_bytes) * 1e-6);
  output.print("{:>22} {:>9} {:>10} {:>9.1e} {:>9.1e} {:>9.1e}\n", a.missed, a.false_hits, a.wrong_primitives,
               a.worst_t, a.median_t, a.rmse);
}

// Prints the front of each group, by hits.
void report(const std::vector<std::vector<TradeoffRow>>& groups, Output& output) {
  const TradeoffSetup& setup = groups.front().front().setup;
  output.device = setup.backend; // rows may have been measured elsewhere
  output.print("{}, {} primary and {} random rays, up to {} of each compared\nwith brute force in double, "
               "pictures of {}\nThe Pareto fronts of speed (millions of rays a second) and wrong hits:\n\n"
               "{:<22} {:<20} {:>9} {:>9} {:>7} {:>7}\n{:>22} {:>9} {:>10} {:>9} {:>9} {:>9}\n",
               setup.backend, setup.size, setup.random, setup.compared, setup.picture, "method", "grid",
               "Mray/s", "ms", "grid MB", "all MB", "missed", "false", "wrong", "worst t", "median t",
               "RMSE");
  for (const auto& group : groups) {
    output.print("{}\n", printable(group.front().scene));
    for (const std::size_t i : front_of(group, merit_of_hits)) {
      output.json.push_back(json_of(group[i]));
      print_row(output, group[i]);
    }
  }
}

void draw(const std::vector<std::vector<TradeoffRow>>& groups, const std::string& folder) {
  write_charts_csv(folder + "/charts.csv", groups);
  std::vector<std::string> charts;
  const auto add = [&](const std::string& name) {
    for (const char* const kind : {".svg", ".png"})
      charts.push_back(name + kind);
  };
  for (const auto& group : groups) {
    if (!group.empty()) add(group.front().scene == "all" ? "tradeoff" : group.front().scene);
  }
  add("division");
  if (!draw_charts(tradeoff_script, folder, "charts.csv", charts))
    print_note(
        "gridbench: gnuplot: isn't on the PATH, so no chart was drawn: install gnuplot (Debian's package is "
        "gnuplot-nox) and run gridbench tradeoff --charts-only -o {}\n",
        printable(folder));
}

// Draws what can be compared, and reports it.
void present(const Settings& settings, const std::vector<TradeoffRow>& rows, Output& output) {
  const auto groups = groups_of(rows);
  draw(groups, settings.folder);
  report(groups, output);
}

void bench_tradeoff(const Settings& settings, Output& output) {
  check_names(settings.scenes, settings.folder);
  static_cast<void>(plan_of(settings, false)); // throws for invalid values before anything is read
  const std::string path = settings.folder + "/tradeoff.csv";
  std::vector<TradeoffRow> rows = read_tradeoff_csv(path);
  if (settings.charts_only) {
    if (!settings.scenes.empty())
      throw Error(ErrorCode::usage, "--charts-only",
                  "takes no scenes: it draws the measurements in the folder");
    if (rows.empty())
      throw Error(ErrorCode::input, path, "holds no measurements: run gridbench tradeoff on scenes first");
    return present(settings, comparable(rows, rows.back().setup, {}), output);
  }
  if (settings.scenes.empty())
    throw Error(ErrorCode::usage, "SCENE", "is missing: give one or more scene files");
  const TradeoffSetup setup = setup_of(settings, use_cuda(settings.backend));
  output.why_no_gpu = why_no_gpu(settings.backend);
  std::map<std::string, std::string> hashes;
  for (const std::string& scene : settings.scenes) { // errors first, before the measurements
    const SceneFile file(scene);
    if (!contains(settings.precisions, "double")) // throws where the scene doesn't allow it
      static_cast<void>(resolved(named<Precision>(settings.precisions.front()), file));
    static_cast<void>(resized(file.camera(), setup.size));
    static_cast<void>(resized(file.camera(), setup.picture));
    hashes[name_of_scene(scene)] = to_hex(file.hash());
  }
  std::error_code failed;
  std::filesystem::create_directories(settings.folder, failed);
  if (failed) throw Error(ErrorCode::output, settings.folder, "can't be made: " + failed.message());
  TradeoffCsv csv(path);
  for (const std::string& scene : settings.scenes)
    measure_scene(settings, setup, scene, csv, rows);
  present(settings, comparable(rows, setup, hashes), output);
}

void add_options(const CommandLine& command, Settings& settings) {
  command.add_option("SCENE", settings.scenes, "scene files, from nff2bin or mesh2bin");
  command
      .add_option(
          "-o,--output", settings.folder,
          "folder for tradeoff.csv, charts.csv and charts; rows that it has already aren't measured again")
      .type_name("FOLDER")
      .required();
  add_backend(command, settings.backend);
  const auto add_list = [&](const char* option, std::vector<std::string>& list, const char* help) {
    return command.add_option(option, list, help).type_name("LIST").comma_separated().shows_default();
  };
  const auto add_names = [&](const char* option, std::vector<std::string>& all, const char* help) {
    add_list(option, all, help).among(std::set<std::string>(all.begin(), all.end()));
  };
  add_names("--precisions", settings.precisions, "precisions (see gridrender --help)");
  add_names("--stop-rules", settings.stops,
            "when a ray terminates: proven (no closer hit is possible), first-cell-hit (at the first cell in "
            "which anything is hit)");
  add_names("--merges", settings.merges, "kinds of grid (see gridbuild --help)");
  add_names("--overlaps", settings.overlaps, "overlap tests (see gridbuild --help)");
  add_list("--divisions", settings.divisions,
           "divisions (see gridbuild --help); irregular grids always use auto, bvh has none");
  add_list("--curve", settings.curve,
           "divisions of the chart of time against division (uniform grids, exact overlap, robust)");
  const auto add = [&](const char* option, auto& value, const char* help) {
    return command.add_option(option, value, help);
  };
  add("--size", settings.size, "number of primary rays [256x256; 1024x1024 on a GPU]").type_name("WxH");
  constexpr std::uint64_t most_rays = std::uint64_t{1} << 28;
  add("--random", settings.random, "number of random rays [65536; 1048576 on a GPU]")
      .range(std::uint64_t{1}, most_rays);
  add("--compared", settings.compared,
      "rays of each of the two sets that are compared with brute force, at most [32768; 1048576 on a GPU]")
      .range(std::uint64_t{1}, most_rays);
  add("--picture", settings.picture, "size of the pictures (depth 5) [128x128; 512x512 on a GPU]")
      .type_name("WxH");
  add("--repeat", settings.repeat, "timed runs, of which the median counts [3; 15 on a GPU]").range(1, 1000);
  add_seed(command, settings.seed, "seed of the random rays");
  command.add_flag("--charts-only", settings.charts_only,
                   "measure nothing: draw the charts of the rows with the last row's setup again");
}

} // namespace

void add_tradeoff(const CommandLine& command) {
  add_command(
      command, "tradeoff",
      "Speed against accuracy of every precision, stop rule and grid, compared with brute force in double",
      "balls.scene -o tradeoff", add_options, bench_tradeoff);
}

} // namespace masu
