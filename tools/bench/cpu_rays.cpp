// masu_cpu_rays: closest hits on the CPU, Masu beside Embree (rtcIntersect1; for primary rays rtcIntersect8,
// too), by the same rays in one run.
//
// On one thread the rate is by CPU time, on all cores by wall-clock time. Repetitions of all measurements are
// interleaved at random, so that what disturbs the machine for a while disturbs all alike.
#include "libscene/base/error.h"
#include "libscene/base/parallel.h"
#include "stability/oracle/embree_scene.h"
#include "stability/ray_sets.h"
#include "tools/bench/command.h"
#include "tools/common/cli.h"
#include "tools/common/repeated.h"

#include <benchmark/benchmark.h>

#include <deque>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace masu {
namespace {

constexpr char alike_rays[] = "primary"; // the set whose rays side by side are alike

struct Settings {
  std::string scene, size = "1024x1024";
  std::vector<std::string> grids, sets{"primary", "diffuse", "random"};
  std::size_t random = std::size_t{1} << 20;
  std::uint64_t seed = 1;
  std::vector<int> threads{1, 0};
  int repeat = 9;
};

// What a tracer found for a list of rays.
struct Hits {
  std::vector<float> t; // infinity for a miss
  std::vector<std::uint32_t> primitive;

  explicit Hits(std::size_t count) : t(count), primitive(count) {}
};

// Masu with a grid, or Embree.
struct Contestant {
  std::string name;
  bool for_alike_rays; // not measured by others
  std::function<void(std::span<const Ray<float>>, Hits&)> trace;
};

// One measurement: its repetitions' rates in rays a second, as they come.
struct Measurement {
  std::string set, contestant;
  int threads; // 0: all cores
  std::vector<double> rates;
};

std::map<std::string, std::vector<Ray<float>>> ray_sets(const Settings& settings, const SceneFile& scene,
                                                        const StructureFile& grid) {
  const std::vector<Ray<double>> primary =
      primary_rays(scene, resized(scene.camera(), settings.size), RayOrder::tiles);
  std::map<std::string, std::vector<Ray<float>>> sets;
  for (const std::string& name : settings.sets) {
    const std::vector<Ray<double>> rays = name == "primary" ? primary
                                          : name == "diffuse"
                                              ? diffuse_rays(scene, grid, primary, settings.seed)
                                              : random_rays(scene, settings.random, settings.seed);
    std::vector<Ray<float>>& rounded = sets[name];
    rounded.resize(rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i)
      rounded[i] = loaded<float>(rays.data(), own_format<double>, i);
  }
  return sets;
}

Contestant masu_with(const SceneFile& scene, const StructureFile& grid) {
  const auto tracer = std::make_shared<ResidentTracer>(scene, &grid, Device::cpu);
  return {grid.path(), false, [tracer](std::span<const Ray<float>> rays, Hits& hits) {
            tracer->trace(RayList(rays), {.t = hits.t.data(), .primitive = hits.primitive.data()},
                          {{Precision::robust}});
          }};
}

// One ray at a time, or eight that are alike.
std::vector<Contestant> embree_with(const SceneFile& scene) {
  const auto embree = std::make_shared<EmbreeScene>(scene.view<float>(), EmbreeFlags{true, true});
  const auto by = [&](const std::string& name, bool packets) {
    const auto trace = packets ? &EmbreeScene::trace_packets : &EmbreeScene::trace;
    return Contestant{name, packets, [embree, trace](std::span<const Ray<float>> rays, Hits& hits) {
                        parallel_ranges(rays.size(), 4096, [&](std::size_t begin, std::size_t end) {
                          (*embree.*trace)(rays.subspan(begin, end - begin), hits.t.data() + begin,
                                           hits.primitive.data() + begin);
                        });
                      }};
  };
  return {by(embree_name() + " packets", true), by(embree_name(), false)};
}

// How many hits differ: one tracer hits and the other doesn't, or distances by more than a ten-thousandth.
std::size_t differing(const Hits& a, const Hits& b) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.t.size(); ++i) {
    const bool a_hits = a.primitive[i] != no_primitive, b_hits = b.primitive[i] != no_primitive;
    count += a_hits != b_hits || (a_hits && !(std::abs(a.t[i] - b.t[i]) <= 1e-4F * std::abs(b.t[i])));
  }
  return count;
}

// Throws Error(input) where two grids of one scene give different bits: results are independent of the grid.
void print_agreement(const std::map<std::string, std::vector<Ray<float>>>& sets,
                     const std::vector<Contestant>& contestants, std::size_t grids) {
  fmt::print("{:<8} {:>9} {:>9}  hits that differ from Masu's\n", "rays", "count", "hits");
  for (const auto& [name, rays] : sets) {
    Hits first(rays.size());
    contestants.front().trace(rays, first);
    fmt::print(
        "{:<8} {:>9} {:>9}", name, rays.size(),
        std::ranges::count_if(first.primitive, [](auto primitive) { return primitive != no_primitive; }));
    for (std::size_t i = 1; i < contestants.size(); ++i) {
      if (contestants[i].for_alike_rays && name != alike_rays) continue;
      Hits other(rays.size());
      contestants[i].trace(rays, other);
      if (i >= grids) {
        fmt::print("  {}: {}", contestants[i].name, differing(first, other));
      } else if (other.t != first.t || other.primitive != first.primitive) {
        throw Error(ErrorCode::input, contestants[i].name,
                    "hits differ from those through " + contestants.front().name);
      }
    }
    fmt::print("\n");
  }
  fmt::print("\n");
  flush_standard_output();
}

void measure(benchmark::State& state, const Contestant& contestant, std::span<const Ray<float>> rays,
             int threads) {
  const ThreadLimit limit = limit_threads(threads > 0 ? static_cast<std::size_t>(threads) : all_cores());
  Hits hits(rays.size());
  while (state.KeepRunning())
    contestant.trace(rays, hits);
  state.counters["rays"] =
      benchmark::Counter(static_cast<double>(rays.size()), benchmark::Counter::kIsIterationInvariantRate);
}

// Keeps the rates beside what Google Benchmark's own table shows of them.
class Reporter : public benchmark::BenchmarkReporter {
public:
  std::vector<Measurement> measurements; // by the order in which benchmarks are registered

  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.run_type != Run::RT_Iteration) continue;
      measurements.at(static_cast<std::size_t>(run.family_index)).rates.push_back(run.counters.at("rays"));
    }
  }
};

void print_table(const std::vector<Measurement>& measurements, const std::string& embree) {
  fmt::print("{:<8} {:>7}  {:<32} {:>8} {:>8}\n", "rays", "threads", "", "Mray/s", "/ Embree");
  double reference = 0;
  for (const Measurement& measurement : measurements) {
    if (measurement.rates.empty()) continue; // not among those chosen by --benchmark_filter
    const double rate = median(measurement.rates);
    if (measurement.contestant == embree) reference = rate;
    fmt::print("{:<8} {:>7}  {:<32} {:>8.2f} {:>8}\n", measurement.set,
               measurement.threads == 0 ? "all" : std::to_string(measurement.threads),
               printable(measurement.contestant), rate * 1e-6,
               reference > 0 ? fmt::format("{:.2f}", rate / reference) : "-");
  }
  flush_standard_output();
}

void bench_cpu_rays(const Settings& settings) {
  const SceneFile scene(settings.scene);
  if (scene.is_float64())
    throw Error(ErrorCode::input, settings.scene,
                "holds float64 coordinates, which Embree doesn't: make it with nff2bin --store float32");
  std::deque<StructureFile> grids;
  std::vector<Contestant> contestants;
  for (const std::string& path : settings.grids)
    contestants.push_back(masu_with(scene, grids.emplace_back(path)));
  if (!embree_available) {
    print_note("masu_cpu_rays: built without Embree (libembree-dev): Masu alone is measured\n");
  } else if (scene.view<float>().triangle_count != scene.primitive_count()) {
    throw Error(ErrorCode::input, settings.scene,
                "holds spheres or cones, which Embree would trace as its user's own: make it with nff2bin "
                "--tessellate 12");
  } else {
    for (Contestant& contestant : embree_with(scene))
      contestants.push_back(std::move(contestant));
  }
  const auto sets = ray_sets(settings, scene, grids.front());
  print_agreement(sets, contestants, grids.size());

  Reporter reporter;
  for (const int threads : settings.threads) {
    for (const std::string& set : settings.sets) {
      for (std::size_t i = contestants.size(); i-- > 0;) { // Embree first
        const Contestant& contestant = contestants[i];
        if (contestant.for_alike_rays && set != alike_rays) continue;
        const std::span<const Ray<float>> rays = sets.at(set);
        auto* registered =
            benchmark::RegisterBenchmark(fmt::format("{}/{}/{}", contestant.name, set, threads).c_str(),
                                         measure, contestant, rays, threads);
        registered->Iterations(1)->Repetitions(settings.repeat);
        if (threads != 1) registered->UseRealTime();
        reporter.measurements.push_back({set, contestant.name, threads, {}});
      }
    }
  }
  benchmark::RunSpecifiedBenchmarks(&reporter);
  print_table(reporter.measurements, embree_available ? embree_name() : "");
}

void add_options(const CommandLine& command, Settings& settings) {
  command.add_option("SCENE", settings.scene, "scene file of triangles, from nff2bin or mesh2bin").required();
  add_grids(command, settings.grids);
  add_names(command, "--sets", settings.sets, {"primary", "diffuse", "random"},
            "sets of rays: primary, diffuse, random");
  add_picture_size(command, settings.size, "number of primary rays");
  add_count(command, "--random", settings.random, "number of random rays", 28);
  add_seed(command, settings.seed, "seed of diffuse and random rays");
  command.add_option("--threads", settings.threads, "numbers of threads; 0: all cores")
      .comma_separated()
      .range(0, 4096);
  add_repeat(command, settings.repeat);
  command.footer("--benchmark_… options are Google Benchmark's.");
}

} // namespace
} // namespace masu

int main(int argc, char** argv) {
  using namespace masu;
  std::string interleaving = "--benchmark_enable_random_interleaving=true";
  std::vector<char*> arguments(argv, argv + argc);
  arguments.insert(arguments.begin() + 1, interleaving.data()); // first, so that the others may say otherwise
  int count = argc + 1;
  benchmark::Initialize(&count, arguments.data()); // removes its own
  return run_tool("masu_cpu_rays", "Closest hits on the CPU: Masu beside Embree, by the same rays.", count,
                  arguments.data(), add_options, bench_cpu_rays);
}
