#include "tools/jobs/tracing_tool.h"

#include "libscene/file/input_file.h"
#include "libscene/file/output_file.h"
#include "tools/common/cli.h"
#include "tools/common/json.h"
#include "tools/common/number_list.h"
#include "tools/common/print.h"
#include "tools/report/counts_report.h"

#include <unistd.h>

#include <algorithm>
#include <numeric>

namespace masu {
namespace {

constexpr const char* devices_option = "--devices";

// 0,2,…
std::vector<int> numbers_in(const std::string& text) {
  std::vector<int> numbers;
  for (const std::string& word : split(text)) {
    const std::optional<int> number = read_number<int>(word);
    if (!number || *number < 0)
      throw Error(ErrorCode::usage, devices_option,
                  fmt::format("'{}' isn't all, cpu or numbers of GPUs such as 0,2", text));
    numbers.push_back(*number);
  }
  return numbers;
}

std::vector<int> numbers_below(int count) {
  std::vector<int> numbers(static_cast<std::size_t>(count));
  std::iota(numbers.begin(), numbers.end(), 0);
  return numbers;
}

std::vector<int> gpus_of_machine(const TracingOptions& options, Ranks& ranks) {
  const std::string& devices = options.devices;
  if (devices.empty()) {
    const bool is_alone = ranks.count() == 1;
    std::uint64_t with_gpu[] = {use_cuda(options.backend, is_alone) ? 1U : 0U};
    if (is_alone) return numbers_below(with_gpu[0] != 0 ? 1 : 0);
    ranks.sum(with_gpu);
    return numbers_below(with_gpu[0] == static_cast<std::uint64_t>(ranks.count()) ? cuda_device_count() : 0);
  }
  const bool on_cpu = devices == "cpu";
  std::vector<int> named = on_cpu || devices == "all" ? std::vector<int>{} : numbers_in(devices);
  if (options.backend != Backend::automatic && on_cpu != (options.backend == Backend::cpu))
    throw Error(ErrorCode::usage, devices_option, "contradicts --backend: leave one of them out");
  if (on_cpu) return {};
  static_cast<void>(use_cuda(Backend::cuda, named == std::vector<int>{0}));
  const int count = cuda_device_count();
  for (const int gpu : named) {
    if (gpu >= count)
      throw Error(ErrorCode::device, devices_option,
                  fmt::format("GPU {} isn't there: the last of {} is {}", gpu, count, count - 1));
  }
  return named.empty() ? numbers_below(count) : named;
}

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
  return options.threads.limit(
      std::clamp<std::size_t>(machine / static_cast<std::size_t>(ranks.local_count()), 1, allowed_threads()));
}

std::vector<int> gpus_of(const TracingOptions& options, Ranks& ranks) {
  std::vector<int> all = gpus_of_machine(options, ranks);
  if (all.empty() || ranks.count() == 1) return all;
  const auto rank = static_cast<std::size_t>(ranks.local_rank()),
             count = static_cast<std::size_t>(ranks.local_count());
  if (rank >= all.size()) return {all[rank % all.size()]};
  std::vector<int> mine;
  for (std::size_t i = rank; i < all.size(); i += count)
    mine.push_back(all[i]);
  return mine;
}

OpenedScene::OpenedScene(const char* tool, const TracingOptions& options, const std::vector<int>& wanted_gpus)
    : faults(tool), gpus(wanted_gpus),
      scene(options.scene, gpus.empty() ? Residence::mapping : Residence::file),
      grid(options.brute_force ? nullptr
                               : std::make_unique<const StructureFile>(
                                     options.grid, gpus.empty() ? Residence::mapping : Residence::file)),
      tracer(scene, grid.get(), gpus.empty() ? Device::cpu : Device::cuda, gpus) {}

Json OpenedScene::hashes() const {
  return {{"scene_hash", to_hex(scene.hash())}, {"grid_hash", grid ? Json(to_hex(grid->hash())) : Json()}};
}

Resume resume_of(const TracingOptions& options, const OpenedScene& opened) {
  if (!options.resume) return Resume::off;
  const std::string path = options.report();
  if (path.empty() || !is_kept(path, {})) return Resume::all;
  const Json report = Json::parse(read_text_input(path), nullptr, false), now = provenance();
  const bool is_same = report.is_object() &&
                       report.value("scene_hash", Json()) == to_hex(opened.scene.hash()) &&
                       words_of(report.value("command", Json())) == words_of(now["command"]);
  return is_same ? Resume::all : Resume::described;
}

void write_reports(const char* tool, const TracingOptions& options, const OpenedScene& opened,
                   const Ranks& ranks, const TracingReport& report, bool quiet) {
  const bool is_kept_whole = report.kept > 0 && report.kept == report.files;
  if (report.kept > 0 && !quiet)
    print_note("{}: --resume: {} of {} files are there and are kept\n", tool, grouped(report.kept),
               grouped(report.files));
  if (is_kept_whole && is_kept(options.report(), {})) return;
  const std::size_t gpus = opened.gpus.size();
  const std::string device = (gpus > 1 ? fmt::format("{} × ", gpus) : "") + device_name(gpus > 0) +
                             (ranks.count() > 1 ? fmt::format(", {} ranks", ranks.count()) : "");
  Json json = provenance();
  json.update({{"backend", gpus == 0 ? "cpu" : "cuda"}, {"device", device}});
  json.update(opened.hashes());
  json["views"] = report.views;
  if (options.resume) json["kept"] = report.kept;
  json.update(precision_json(report, resolved(options.rules.precision, opened.scene)));
  if (!options.stats.empty()) json.update(counts_report(report.totals.counts));
  json["seconds"] = {{"map", opened.load_seconds(&LoadSeconds::map)},
                     {"validate", opened.load_seconds(&LoadSeconds::validate)},
                     {"upload", report.seconds.upload + opened.tracer.upload_seconds()},
                     {"trace", report.seconds.trace},
                     {"download", report.seconds.download},
                     {"write", report.write_seconds}};
  if (!options.report().empty()) write_text_file(options.report(), json_text(json) + "\n");
  if (quiet || is_kept_whole) return;
  const std::string why = options.devices.empty() ? why_no_gpu(options.backend) : "";
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
