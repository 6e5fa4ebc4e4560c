#include "tools/jobs/tracing_tool.h"

#include "libscene/file/input_file.h"
#include "libscene/file/output_file.h"
#include "tools/common/cli.h"
#include "tools/common/json.h"
#include "tools/common/print.h"
#include "tools/report/counts_report.h"

#include <sched.h>
#include <unistd.h>

#include <algorithm>

namespace masu {
namespace {

// Of a command line, the words that outputs depend on.
Json words_of(Json command) {
  if (command.is_array())
    std::erase_if(command.get_ref<Json::array_t&>(),
                  [](const Json& word) { return word == "--resume" || word == "-q" || word == "--quiet"; });
  return command;
}

// What Precision::automatic came to.
std::string precision_text(const TracingReport& report) {
  if (!report.precision) return "";
  const std::uint64_t doubled = report.double_views;
  return doubled == 0 || doubled == report.views
             ? ", " + description_of(*report.precision)
             : fmt::format(", {} of the views in {}", doubled, description_of(*report.precision));
}

Json precision_json(const TracingReport& report, Precision wanted) {
  if (!report.precision) return {{"precision", name_of(wanted)}};
  const std::uint64_t doubled = report.double_views;
  return {{"precision", doubled == 0              ? "robust"
                        : doubled == report.views ? "double"
                                                  : "robust and double"},
          {"double_views", doubled},
          {"precision_reason", description_of(*report.precision)}};
}

} // namespace

ThreadLimit limit_threads(const TracingOptions& options, const Ranks& ranks) {
  const auto machine = static_cast<std::size_t>(std::max(1L, sysconf(_SC_NPROCESSORS_ONLN)));
  cpu_set_t allowed;
  CPU_ZERO(&allowed);
  const int count = sched_getaffinity(0, sizeof allowed, &allowed) == 0 ? CPU_COUNT(&allowed) : 0;
  const std::size_t mine = count > 0 ? static_cast<std::size_t>(count) : machine;
  return options.threads.limit(
      std::clamp<std::size_t>(machine / static_cast<std::size_t>(ranks.local_count()), 1, mine));
}

OpenedScene::OpenedScene(const char* tool, const TracingOptions& options, const std::vector<int>& gpus)
    : faults_(tool), gpus_(gpus), scene_(options.scene, gpus.empty() ? Residence::mapping : Residence::file),
      grid_(options.brute_force ? nullptr
                                : std::make_unique<const StructureFile>(
                                      options.grid, gpus.empty() ? Residence::mapping : Residence::file)),
      tracer_(scene_, grid_.get(), gpus.empty() ? Device::cpu : Device::cuda, gpus) {}

Json OpenedScene::hashes() const {
  return {{"scene_hash", to_hex(scene_.hash())}, {"grid_hash", grid_ ? Json(to_hex(grid_->hash())) : Json()}};
}

Resume resume_of(const TracingOptions& options, const OpenedScene& opened) {
  if (!options.resume) return Resume::off;
  const std::string path = options.report();
  if (path.empty() || !is_kept(path, {})) return Resume::all;
  const Json report = Json::parse(read_text_input(path), nullptr, false), now = provenance();
  const auto same = [&](const char* key, const Json& value) {
    return report.is_object() && report.contains(key) && report[key] == value;
  };
  return same("scene_hash", to_hex(opened.scene().hash())) && report.contains("command") &&
                 words_of(report["command"]) == words_of(now["command"])
             ? Resume::all
             : Resume::described;
}

void write_reports(const char* tool, const TracingOptions& options, const OpenedScene& opened,
                   const Ranks& ranks, const TracingReport& report, bool quiet) {
  const bool is_kept_whole = report.kept > 0 && report.kept == report.files;
  if (report.kept > 0 && !quiet)
    print_note("{}: --resume: {} of {} files are there and are kept\n", tool, grouped(report.kept),
               grouped(report.files));
  if (is_kept_whole && is_kept(options.report(), {})) return;
  const std::size_t gpus = opened.gpus().size();
  const std::string device = (gpus > 1 ? fmt::format("{} × ", gpus) : "") + device_name(gpus > 0) +
                             (ranks.count() > 1 ? fmt::format(", {} ranks", ranks.count()) : "");
  Json json = provenance();
  json.update({{"backend", gpus == 0 ? "cpu" : "cuda"}, {"device", device}});
  json.update(opened.hashes());
  json["views"] = report.views;
  if (options.resume) json["kept"] = report.kept;
  json.update(precision_json(report, resolved(options.rules.precision, opened.scene())));
  if (!options.stats.empty()) json.update(counts_report(report.totals.counts));
  json["seconds"] = {{"map", opened.load_seconds(&LoadSeconds::map)},
                     {"validate", opened.load_seconds(&LoadSeconds::validate)},
                     {"upload", report.seconds.upload + opened.tracer().upload_seconds()},
                     {"trace", report.seconds.trace},
                     {"download", report.seconds.download},
                     {"write", report.write_seconds}};
  if (!options.report().empty()) write_text_file(options.report(), json_text(json) + "\n");
  if (quiet || is_kept_whole) return;
  const DeviceChoice& wanted = options.devices;
  const std::string why = wanted.devices.empty() ? why_no_gpu(wanted.backend) : "";
  const double seconds = report.overlaps_writing ? report.elapsed_seconds : report.seconds.trace;
  const char* const besides = !report.overlaps_writing ? ""
                              : report.views == 0      ? " with reading and writing"
                                                       : " with writing";
  const std::uint64_t rays = report.totals.rays;
  print_note("{}: {}{} rays in {:.3g} s{} ({:.3g} M/s) on {}{}{}\n", tool,
             report.views > 1 ? fmt::format("{} views, ", grouped(report.views)) : "", grouped(rays), seconds,
             besides, seconds > 0 ? static_cast<double>(rays) / seconds * 1e-6 : 0, device,
             why.empty() ? "" : fmt::format(" ({})", why), precision_text(report));
}

} // namespace masu
