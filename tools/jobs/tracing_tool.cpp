#include "tools/jobs/tracing_tool.h"

#include "tools/common/printable.h"
#include "tools/common/provenance.h"
#include "tools/common/scene_input.h"
#include "tools/common/text_file.h"
#include "tools/report/counts_report.h"

#include <initializer_list>
#include <optional>

namespace masu {
namespace {

using Json = nlohmann::ordered_json;

// What Precision::automatic came to.
std::string precision_text(const Outcome& outcome) {
  const std::optional<ViewPrecision>& chosen = outcome.report.precision;
  if (!chosen) return "";
  const std::uint64_t doubled = outcome.report.double_views;
  return doubled == 0 || doubled == outcome.views
             ? ", " + description_of(*chosen)
             : fmt::format(", {} of the views in {}", doubled, description_of(*chosen));
}

Json precision_json(const Outcome& outcome, Precision wanted) {
  const std::optional<ViewPrecision>& chosen = outcome.report.precision;
  if (!chosen) return {{"precision", name_of(wanted)}};
  const std::uint64_t doubled = outcome.report.double_views;
  return {{"precision", doubled == 0               ? "robust"
                        : doubled == outcome.views ? "double"
                                                   : "robust and double"},
          {"double_views", doubled},
          {"precision_reason", description_of(*chosen)}};
}

} // namespace

void TracingOptions::add_files(CLI::App& app) {
  app.add_option("SCENE", scene, "scene file, from nff2bin or mesh2bin");
  app.add_option("GRID", grid, "grid file, from gridbuild; left out with --brute-force");
}

void TracingOptions::add_to(CLI::App& app) {
  group_options(app, "Tracing");
  devices.add_to(app);
  add_precision(app, rules.precision);
  add_first_cell_hit(app, rules.stop);
  app.add_flag("--brute-force", brute_force, "test every ray against every primitive, without a grid");
  app.add_flag("--resume", resume,
               "go on where a run with --resume was interrupted: what it finished isn't done again");
  group_options(app, "Reports");
  auto* const counts =
      app.add_option("--stats", stats, "write ray counts and seconds as JSON; counting slows tracing down")
          ->type_name("FILE");
  app.add_option("--times", times, "write seconds as JSON, without counting")
      ->type_name("FILE")
      ->excludes(counts);
  app.add_option("--repeat", repeat, "trace N times and report the median's seconds")
      ->check(CLI::Range(1, 10000))
      ->excludes(counts);
  add_quiet(app, quiet, "no progress and no summary on standard error");
  threads.add_to(app);
}

void TracingOptions::check(const char* tool) const {
  if (scene.empty())
    throw Error(ErrorCode::usage, "command line", fmt::format("SCENE is required: see {} --help", tool));
  check_scene_input(scene);
  if (grid.empty() && !brute_force)
    throw Error(ErrorCode::usage, "GRID", "is missing: name the grid file, or give --brute-force");
}

TracingRules TracingOptions::tracing() const {
  TracingRules tracing = rules;
  tracing.count = !stats.empty();
  return tracing;
}

OpenedScene::OpenedScene(const char* tool, const TracingOptions& options, const std::vector<int>& gpus)
    : faults_(tool), gpus_(gpus), scene_(options.scene, gpus.empty() ? Residence::mapping : Residence::file),
      grid_(options.brute_force ? nullptr
                                : std::make_unique<const GridFile>(
                                      options.grid, gpus.empty() ? Residence::mapping : Residence::file)),
      tracer_(scene_, grid_.get(), gpus.empty() ? Device::cpu : Device::cuda, gpus) {}

std::string run_description(const OpenedScene& opened, const TracingRules& tracing,
                            const std::string& options) {
  return fmt::format("{}\nscene {}\n{}\n{} counts {}", program_name(), to_hex(opened.scene().hash()), options,
                     opened.gpus().empty() ? "cpu" : "cuda", tracing.count);
}

void write_reports(const char* tool, const TracingOptions& options, const OpenedScene& opened,
                   const Ranks& ranks, const Outcome& outcome, bool quiet) {
  const TracingReport& report = outcome.report;
  const GridFile* const grid = opened.tracer().grid();
  const std::string device =
      devices_name(opened.gpus()) + (ranks.count() > 1 ? fmt::format(", {} ranks", ranks.count()) : "");
  Json head = provenance();
  head.update({{"backend", opened.gpus().empty() ? "cpu" : "cuda"},
               {"device", device},
               {"scene_hash", to_hex(opened.scene().hash())},
               {"grid_hash", grid != nullptr ? Json(to_hex(grid->hash())) : Json()},
               {"views", outcome.views}});
  head.update(precision_json(outcome, resolved(options.rules.precision, opened.scene())));
  const Json times{{"seconds",
                    {{"map", opened.map_seconds()},
                     {"validate", opened.validate_seconds()},
                     {"upload", report.seconds.upload + opened.tracer().upload_seconds()},
                     {"trace", report.seconds.trace},
                     {"download", report.seconds.download},
                     {"write", report.write_seconds}}}};
  const auto merged = [](Json json, const std::initializer_list<Json>& more) {
    for (const Json& part : more)
      json.update(part);
    return json;
  };
  if (!options.stats.empty())
    write_text_file(options.stats,
                    json_text(merged(head, {counts_report(report.totals.counts), times})) + "\n");
  if (!options.times.empty()) write_text_file(options.times, json_text(merged(head, {times})) + "\n");
  if (quiet) return;
  const double seconds = outcome.rays_seconds;
  const std::uint64_t rays = report.totals.rays;
  print_note("{}: traced {}{} rays in {:.3g} s{}, {:.3g} million a second, on {}{}\n", tool,
             outcome.views > 1 ? fmt::format("{} views, ", outcome.views) : "", rays, seconds,
             outcome.besides, seconds > 0 ? static_cast<double>(rays) / seconds * 1e-6 : 0, device,
             precision_text(outcome));
}

int run_ranks_tool(const char* name, const char* description, int argc, char** argv,
                   const RanksToolBody& body) {
  prepare_process();
  std::optional<Ranks> started; // when the command line is whole
  const auto ranks = [&]() -> Ranks& { return started ? *started : started.emplace(&argc, &argv); };
  const int code =
      run_tool(name, description, argc, argv,
               [&](CLI::App& app, const auto& parse) {
                 body(app, [&]() -> Ranks& {
                   parse();
                   return ranks();
                 });
               },
               {[] { return Ranks::launched_as().value_or(0) == 0; },
                [&] { return (!started && !Ranks::launched_as()) || ranks().is_first_to_fail(); }});
  return started ? started->ended(code) : code;
}

} // namespace masu
