// Throughput of sets of rays (closest hit and any hit), and the tests and cells per ray.
#include "libscene/file/output_file.h"
#include "renderer/rays/automatic_loop.h"
#include "stability/ray_sets.h"
#include "tools/bench/command.h"
#include "tools/common/repeated.h"

#include <algorithm>
#include <map>
#include <vector>

namespace masu {
namespace {

struct Settings {
  std::string scene, size = "1024x1024", save;
  std::vector<std::string> grids, sets{"primary", "diffuse", "random", "shadow", "ambient"};
  Backend backend = Backend::automatic;
  TracingRules tracing;
  RayOrder order = RayOrder::tiles;
  std::size_t random = std::size_t{1} << 22;
  std::uint64_t seed = 1;
  std::vector<std::string> loops{"auto"}, precisions{"auto"};
  int warm_up = 5, repeat = 25;
};

struct RaySet {
  std::string name;
  Query query;
  std::vector<Ray<double>> rays;
};

const std::map<std::string, RayLoop> all_loops{{"thread_per_ray", RayLoop::thread_per_ray},
                                               {"warp", RayLoop::warp},
                                               {"warp_refill", RayLoop::warp_refill},
                                               {"on_device", RayLoop::automatic}};

// The loop's name, with `auto` resolved.
std::string loop_for(const std::string& wanted, const RaySet& set, const ResidentTracer& tracer) {
  if (set.query == Query::closest_point) return "thread_per_ray";
  if (wanted != "auto") return wanted;
  const RayLoop usual = automatic_loop(tracer, set.rays, set.query, Precision::automatic);
  return std::ranges::find(all_loops, usual, [](const auto& loop) { return loop.second; })->first;
}

// All grids are measured by the same rays. Sets that begin at hit points are generated through the first
// grid.
std::vector<RaySet> ray_sets(const Settings& settings, const SceneFile& scene, const StructureFile& grid) {
  const std::vector<Ray<double>> primary =
      primary_rays(scene, resized(scene.camera(), settings.size), settings.order);
  std::vector<RaySet> sets;
  for (const std::string& name : settings.sets) {
    if (name == "primary") sets.push_back({name, Query::nearest_hit, primary});
    if (name == "diffuse")
      sets.push_back({name, Query::nearest_hit, diffuse_rays(scene, grid, primary, settings.seed)});
    if (name == "random")
      sets.push_back({name, Query::nearest_hit, random_rays(scene, settings.random, settings.seed)});
    if (name == "shadow") sets.push_back({name, Query::occlusion, shadow_rays(scene, grid, primary)});
    if (name == "ambient")
      sets.push_back({name, Query::occlusion, ambient_rays(scene, grid, primary, settings.seed)});
    if (name == "places")
      sets.push_back({name, Query::closest_point, random_places(scene, settings.random, settings.seed)});
  }
  return sets;
}

Json measure(const Settings& settings, const ResidentTracer& tracer, const RaySet& set,
             const std::string& precision, const std::string& loop) {
  const StructureFile& grid = *tracer.structure();
  const bool cuda = tracer.device() == Device::cuda;
  RaysRequest request{settings.tracing, set.query, all_loops.at(loop)};
  request.tracing.precision = resolved(all_precisions.at(precision), tracer.scene());
  const ResidentRays rays = tracer.upload(set.rays, request.tracing.precision);
  request.tracing.count = true;
  const Counts counts = tracer.trace(rays, request).counts;
  request.tracing.count = false;
  const QueryReport timed =
      repeated(settings.warm_up, settings.repeat, [&] { return tracer.trace(rays, request); });
  const double seconds = timed.seconds.trace;
  const auto number = static_cast<double>(set.rays.size());
  const auto a_ray = [&](std::uint64_t total) {
    return number > 0 ? static_cast<double>(total) / number : 0.0;
  };
  return {{"grid", grid.path()},
          {"grid_bytes", grid.bytes()},
          {"grid_hash", to_hex(grid.hash())},
          {"rays", set.name},
          {"query", set.query == Query::nearest_hit ? "closest_hit"
                    : set.query == Query::occlusion ? "any_hit"
                                                    : "closest_point"},
          {"count", set.rays.size()},
          {"backend", cuda ? "cuda" : "cpu"},
          {"precision", name_of(request.tracing.precision)},
          {"loop", cuda ? loop : "thread_per_ray"},
          {"median_seconds", seconds},
          {"mrays_per_second", seconds > 0 ? number / seconds * 1e-6 : 0.0},
          {"kernel", {{"registers", timed.kernel.registers}, {"local_bytes", timed.kernel.local_bytes}}},
          {"hits_a_ray", a_ray(counts.camera_hits + counts.shadow_hits)},
          {"tests_a_ray", a_ray(counts.triangle_tests + counts.sphere_tests + counts.cone_tests)},
          {"cells_a_ray", a_ray(counts.cells_visited)},
          {"empty_cells_a_ray", a_ray(counts.empty_cells_visited)}};
}

void bench_rays(const Settings& settings, Output& output) {
  const bool cuda = output.on_cuda(settings.backend);
  const SceneFile scene(settings.scene);
  std::vector<StructureFile> grids;
  for (const std::string& path : settings.grids) {
    grids.emplace_back(path);
    grids.back().check_geometry(scene.geometry_hash(), scene.primitive_count());
  }
  const std::vector<RaySet> sets = ray_sets(settings, scene, grids.front());
  for (const RaySet& set : sets) {
    if (settings.save.empty()) break;
    OutputFile file(settings.save + set.name + ".f64");
    file.write(set.rays.data(), set.rays.size() * sizeof(Ray<double>));
    file.commit();
  }
  output.print(
      "{}, median of {} after {}, {} order\n\n{:<8} {:<6} {:<14} {:>11} {:>8} {:>5} {:>7} {:>6} {:>6}\n",
      cuda ? "cuda" : "cpu", settings.repeat, settings.warm_up,
      settings.order == RayOrder::tiles ? "tile" : "row", "rays", "prec.", "loop", "count", "Mray/s", "hit %",
      "tests", "cells", "empty");
  for (const StructureFile& grid : grids) {
    const ResidentTracer tracer(scene, &grid, cuda ? Device::cuda : Device::cpu);
    output.print("{}\n", printable(grid.path()));
    for (const RaySet& set : sets) {
      for (const std::string& precision : settings.precisions) {
        for (const std::string& loop : settings.loops) {
          const Json& row = output.json.emplace_back(
              measure(settings, tracer, set, precision, loop_for(loop, set, tracer)));
          const auto number = [&](const char* name) { return row[name].get<double>(); };
          output.print("{:<8} {:<6} {:<14} {:>11} {:>8.1f} {:>5.1f} {:>7.2f} {:>6.2f} {:>6.2f}\n", set.name,
                       row["precision"].get<std::string>(), row["loop"].get<std::string>(),
                       grouped(set.rays.size()), number("mrays_per_second"), 100 * number("hits_a_ray"),
                       number("tests_a_ray"), number("cells_a_ray"), number("empty_cells_a_ray"));
        }
      }
    }
  }
}

void add_options(const CommandLine& command, Settings& settings) {
  add_scene(command, settings.scene);
  add_grids(command, settings.grids);
  add_names(
      command, "--sets", settings.sets, {"primary", "diffuse", "random", "shadow", "ambient", "places"},
      "sets of rays: primary, diffuse, random (closest hit), shadow, ambient (any hit); default: these. "
      "places: closest points to random origins in the scene's bounds, through a hierarchy");
  add_backend(command, settings.backend);
  command.add_choice("--order", settings.order, {{"rows", RayOrder::rows}, {"tiles", RayOrder::tiles}},
                     "order of primary rays: rows, or tiles of 8x4");
  add_names(command, "--loop", settings.loops, {"thread_per_ray", "warp", "warp_refill", "on_device", "auto"},
            "tracing loop of the GPU: thread_per_ray, warp (the 32 threads share their rays' intersection "
            "tests), warp_refill (warp, and idle threads fetch the next ray), on_device (through a hierarchy "
            "one of these, by a look at some rays there), or auto (that, or through a grid by what a sample "
            "of the rays costs)");
  add_names(command, "--precision", settings.precisions, {"auto", "fast", "robust", "double"},
            "auto, fast, robust, double (see gridrender --help)");
  add_first_cell_hit(command, settings.tracing.stop);
  add_general(command, settings.tracing);
  add_picture_size(command, settings.size, "number of primary rays");
  add_count(command, "--random", settings.random, "number of random rays, and of places", 28);
  add_seed(command, settings.seed, "seed of diffuse and random rays and places");
  add_warm_up(command, settings.warm_up);
  add_repeat(command, settings.repeat);
  command
      .add_option("--save", settings.save,
                  "write the sets, too: 8 float64 numbers per ray (origin, tmin, direction, tmax), relative "
                  "to the scene's local origin, to PREFIX and the set's name and .f64")
      .type_name("PREFIX");
}

} // namespace

void add_rays(const CommandLine& command) {
  add_command(command, "rays", "Throughput of sets of rays, with intersection tests and cells per ray",
              "balls.scene balls.grid --sets primary,diffuse", add_options, bench_rays);
}

} // namespace masu
