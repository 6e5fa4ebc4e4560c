// Speed against accuracy of every precision, stop rule and grid: measurements, charts and Pareto fronts.
#include "libscene/file/output_file.h"
#include "tools/bench/command.h"
#include "tools/bench/tradeoff/tradeoff.h"
#include "tools/common/progress.h"
#include "tradeoff_script.h"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <list>
#include <map>
#include <optional>
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
  const auto either = [&]<class Value>(const Value& given, std::type_identity_t<Value> on_gpu,
                                       std::type_identity_t<Value> on_cpu) {
    return given != Value{} ? given : cuda ? on_gpu : on_cpu;
  };
  return {.backend = cuda ? "cuda" : "cpu",
          .threads = cuda ? 0 : allowed_threads(),
          .size = either(settings.size, "1024x1024", "256x256"),
          .random = either(settings.random, 1 << 20, 1 << 16),
          .compared = either(settings.compared, 1 << 20, 1 << 15),
          .picture = either(settings.picture, "512x512", "128x128"),
          .seed = settings.seed,
          .repeat = either(settings.repeat, 15, 3)};
}

bool have_same_grid(const Configuration& a, const Configuration& b) {
  return a.merge == b.merge && a.division == b.division && a.overlap == b.overlap;
}

// All configurations, each once, in the order of the CSV's rows. Scenes stored in float64 have only double
// precision. Throws Error(usage) for an invalid division.
std::vector<Configuration> plan_of(const Settings& settings, bool float64) {
  std::vector<Configuration> plan;
  const auto add = [&](const Configuration& c) {
    static_cast<void>(parse_division(c.division));
    if (float64 && c.precision != Precision::doubled) return;
    if (std::ranges::find(plan, c) == plan.end()) plan.push_back(c);
  };
  for (const std::string& merge : settings.merges) {
    // The top level of an irregular grid always has the automatic division. A hierarchy has no division, no
    // overlap test and no cells.
    const auto kind = named<StructureKind>(merge);
    const bool is_hierarchy = kind == StructureKind::hierarchy;
    const bool own = is_hierarchy || kind == StructureKind::irregular;
    for (const std::string& division : own ? std::vector<std::string>{"auto"} : settings.divisions)
      for (const std::string& overlap : is_hierarchy ? std::vector<std::string>{"exact"} : settings.overlaps)
        for (const std::string& precision : settings.precisions)
          for (const std::string& stop : settings.stops)
            if (!is_hierarchy || stop == "proven")
              add({named<Precision>(precision), named<StopRule>(stop), kind, division,
                   named<Overlap>(overlap)});
  }
  const bool robust = contains(settings.precisions, "robust");
  for (const std::string& division : settings.curve)
    add({float64  ? Precision::doubled
         : robust ? Precision::robust
                  : named<Precision>(settings.precisions.front()),
         StopRule::proven, StructureKind::uniform, division, Overlap::exact});
  return plan;
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
  std::vector<Configuration> plan = plan_of(settings, scene.is_float64());
  if (plan.empty())
    static_cast<void>(resolved(named<Precision>(settings.precisions.front()), scene)); // throws
  std::erase_if(plan, [&](const Configuration& c) {
    return std::ranges::any_of(rows, [&](const TradeoffRow& row) {
      return row.scene == name && row.scene_hash == hash && row.setup == setup && row.configuration == c;
    });
  });
  if (plan.empty()) return;
  Progress progress(name.c_str());
  const TradeoffTask task(scene, setup);
  std::optional<StructureFile> grid; // one at a time
  for (std::size_t i = 0; i < plan.size(); ++i) {
    const Configuration& c = plan[i];
    progress(static_cast<double>(i + 1) / static_cast<double>(plan.size() + 1));
    if (i == 0 || !have_same_grid(c, plan[i - 1])) {
      grid.reset();
      grid.emplace(built_in_memory(
          scene, {.structure = {c.merge}, .division = parse_division(c.division), .overlap = c.overlap}));
    }
    rows.push_back({name, hash, setup, c, measure(task, *grid, c)});
    csv.add(rows.back());
  }
}

// Rows with that setup, and of scenes of the same name those of the scene measured last: rows that can be
// compared.
std::vector<TradeoffRow> comparable(std::vector<TradeoffRow> rows, const TradeoffSetup& setup,
                                    std::map<std::string, std::string> hashes) {
  std::erase_if(rows, [&](const TradeoffRow& row) { return !(row.setup == setup); });
  for (std::size_t i = rows.size(); i-- > 0;)
    hashes.emplace(rows[i].scene, rows[i].scene_hash); // keeps an earlier one
  std::erase_if(rows, [&](const TradeoffRow& row) { return hashes.at(row.scene) != row.scene_hash; });
  return rows;
}

// The rows of each scene, and the mean of all scenes where there are several.
std::vector<std::vector<TradeoffRow>> groups_of(const std::vector<TradeoffRow>& rows) {
  std::vector<std::vector<TradeoffRow>> groups;
  for (const TradeoffRow& row : rows) {
    auto group = std::ranges::find_if(groups, [&](const auto& g) { return g.front().scene == row.scene; });
    if (group == groups.end()) group = groups.insert(groups.end(), std::vector<TradeoffRow>{});
    group->push_back(row);
  }
  std::vector<TradeoffRow> all = over_all_scenes(rows);
  if (groups.size() > 1 && !all.empty()) groups.push_back(std::move(all));
  return groups;
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
      const Configuration& configuration = group[i].configuration;
      const Measurement& m = group[i].measured;
      const Accuracy& a = m.accuracy;
      output.json.push_back(json_of(group[i]));
      // Two lines: what it costs, and below it how accurate it is.
      output.print("{:<22} {:<20} {:>9.2f} {:>9.3f} {:>7.2f} {:>7.2f}\n{:>22} {:>9} {:>10} {:>9.1e} {:>9.1e} "
                   "{:>9.1e}\n",
                   method_of(configuration), grid_of(configuration), m.mrays, m.picture_ms,
                   static_cast<double>(m.grid_bytes) * 1e-6,
                   static_cast<double>(m.grid_bytes + m.scene_bytes) * 1e-6, a.missed, a.false_hits,
                   a.wrong_primitives, a.worst_t, a.median_t, a.rmse);
    }
  }
}

// Runs the script in gnuplot on the folder's charts.csv, whose path it finds in its variable `data`. Of the
// groups' charts it may draw some; it finds where to write them in its variable `outputs`, in pairs: NAME
// PATH NAME PATH … (no spaces in either). They appear in the folder whole or not at all. Throws
// Error(output), also where gnuplot fails.
void draw(const std::vector<std::vector<TradeoffRow>>& groups, const std::string& folder) {
  const std::string path = folder + "/charts.csv";
  write_charts_csv(path, groups);
  if (std::system("command -v gnuplot >/dev/null 2>&1") != 0)
    return print_note(
        "gridbench: gnuplot: isn't on the PATH, so no chart was drawn: install gnuplot (Debian's package is "
        "gnuplot-nox) and run gridbench tradeoff --charts-only -o {}\n",
        printable(folder));
  const auto path_of = [](FILE* file) { return fmt::format("/proc/{}/fd/{}", getpid(), fileno(file)); };
  const std::unique_ptr<FILE, int (*)(FILE*)> rows(std::fopen(path.c_str(), "re"), std::fclose);
  if (rows == nullptr) throw Error(ErrorCode::output, path, "can't be read");
  std::list<OutputFile> charts;
  std::string outputs;
  const auto add = [&](const std::string& scene) {
    for (const char* const kind : {".svg", ".png"}) {
      OutputFile& chart = charts.emplace_back(fmt::format("{}/{}{}", folder, scene, kind));
      outputs += fmt::format("{}{} {} ", scene, kind, path_of(chart.stream()));
    }
  };
  for (const auto& group : groups)
    add(group.front().scene == "all" ? "tradeoff" : group.front().scene);
  add("division");
  // In a UTF-8 locale: in others gnuplot warns of characters that they lack.
  FILE* const gnuplot = popen("LC_ALL=C.UTF-8 exec gnuplot", "we");
  if (gnuplot == nullptr) throw Error(ErrorCode::output, "gnuplot", "can't be started");
  fmt::print(gnuplot, "data = '{}'\noutputs = '{}'\n{}", path_of(rows.get()), outputs, tradeoff_script);
  if (pclose(gnuplot) != 0)
    throw Error(ErrorCode::output, "gnuplot",
                "fails on the data in " + folder + ": see its own message above");
  for (OutputFile& chart : charts) {
    struct stat state {};
    if (fstat(fileno(chart.stream()), &state) == 0 && state.st_size > 0) chart.commit();
  }
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
  const TradeoffSetup setup = setup_of(settings, output.on_cuda(settings.backend));
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
