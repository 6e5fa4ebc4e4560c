// Long lists of rays in host memory, compared with plain copies of their bytes to the device and back.
#include "libscene/base/stopwatch.h"
#include "tools/bench/bench.h"
#include "tools/bench/command.h"
#include "tools/bench/host_list.h"
#include "tools/common/repeated.h"

#include <algorithm>
#include <vector>

namespace masu {
namespace {

using Json = nlohmann::ordered_json;

struct Settings {
  std::string scene, grid;
  std::size_t count = 100'000'000;
  std::uint64_t seed = 1;
  int repeat = 5;
};

Json measure(const Settings& settings, const ResidentTracer& tracer, bool page_locked) {
  const std::size_t count = settings.count;
  const HostList list(tracer.scene(), count, settings.seed, page_locked);
  std::vector<double> seconds, copies;
  QueryReport report;
  for (int i = 0; i <= settings.repeat; ++i) {
    const Stopwatch watch;
    report = tracer.trace(list.rays(count), list.results(), {});
    const double traced = watch.seconds();
    const double copied = list.plain_copy_seconds(0, count, 0);
    if (i == 0) continue; // warms up
    seconds.push_back(traced);
    copies.push_back(copied);
  }
  const double traced = median(seconds), copied = median(copies);
  return {{"count", count},
          {"memory", page_locked ? "page_locked" : "pageable"},
          {"median_seconds", traced},
          {"mrays_per_second", static_cast<double>(count) / traced * 1e-6},
          {"kernel_seconds", report.seconds.trace},
          {"plain_copy_seconds", copied},
          {"plain_copy_over_list", copied / traced}};
}

void bench_lists(const Settings& settings, Output& output) {
  static_cast<void>(output.on_cuda(Backend::cuda));
  const SceneFile scene(settings.scene);
  const StructureFile grid(settings.grid);
  const ResidentTracer tracer(scene, &grid, Device::cuda);
  output.print("{} random rays, median of {}\n\n{:<12} {:>9} {:>9} {:>9} {:>12} {:>12}\n", settings.count,
               settings.repeat, "memory", "s", "Mray/s", "kernel s", "plain copy s", "copy / list");
  for (const bool page_locked : {true, false}) {
    const Json& row = output.json.emplace_back(measure(settings, tracer, page_locked));
    output.print("{:<12} {:>9.4f} {:>9.1f} {:>9.4f} {:>12.4f} {:>12.2f}\n", row["memory"].get<std::string>(),
                 row["median_seconds"].get<double>(), row["mrays_per_second"].get<double>(),
                 row["kernel_seconds"].get<double>(), row["plain_copy_seconds"].get<double>(),
                 row["plain_copy_over_list"].get<double>());
  }
}

void add_options(const CommandLine& command, Settings& settings) {
  add_scene(command, settings.scene);
  add_grid(command, settings.grid);
  add_count(command, "--count", settings.count, "number of rays; 40 bytes of memory each", 32);
  add_seed(command, settings.seed);
  add_repeat(command, settings.repeat);
}

} // namespace

void add_lists(const CommandLine& command) {
  add_command(command, "lists",
              "Long lists of rays from host memory through a GPU, compared with plain copies of their bytes",
              "balls.scene balls.grid --count 10000000", add_options, bench_lists);
}

} // namespace masu
