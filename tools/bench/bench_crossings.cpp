// Rays through a closed mesh, at its corners, along its edges and in the planes of its faces: each line
// crosses it as often inwards as outwards.
#include "libscene/base/parallel.h"
#include "stability/closed_mesh.h"
#include "tools/bench/command.h"

#include <algorithm>
#include <vector>

namespace masu {
namespace {

struct Settings {
  std::string scene, grid;
  std::uint64_t count = 1'000'000;
  std::uint64_t seed = 1;
  Backend backend = Backend::automatic;
  Precision precision = Precision::automatic;
};

struct Crossings {
  std::uint64_t rays = 0, crossing = 0, hits = 0, wrong = 0;
};

constexpr std::uint64_t rays_per_batch = std::uint64_t{1} << 20, rays_per_task = 1 << 12;

template <class Stored>
Crossings count_crossings(const Settings& settings, const ResidentTracer& tracer,
                          const SceneView<Stored>& scene) {
  const std::span<const Triangle<Stored>> triangles(scene.triangles, scene.triangle_count);
  if (triangles.empty() || scene.cone_count > 0 || !is_closed(triangles))
    throw Error(ErrorCode::input, settings.scene,
                "isn't a closed mesh: an edge is run through more often in one direction than in the other");
  const double size = largest_magnitude(tracer.scene().bounds());
  Crossings all;
  std::vector<Ray<double>> rays;
  std::vector<std::uint32_t> hits, fronts;
  for (; all.rays < settings.count; all.rays += rays.size()) {
    rays.resize(std::min(settings.count - all.rays, rays_per_batch));
    hits.resize(rays.size());
    fronts.resize(rays.size());
    const std::uint64_t first_task = all.rays / rays_per_task;
    parallel_for((rays.size() + rays_per_task - 1) / rays_per_task, [&](std::uint64_t task) {
      Chance chance(RandomSeed(settings.seed * 0x9e3779b97f4a7c15U + first_task + task));
      const std::size_t end = std::min<std::size_t>((task + 1) * rays_per_task, rays.size());
      for (std::size_t i = task * rays_per_task; i < end; ++i)
        rays[i] = crossing_ray<double>(chance, triangles, size);
    });
    const auto count = [&](Faces faces, std::vector<std::uint32_t>& counts) {
      tracer.trace(relative(RayList(rays)), {.count = counts.data()},
                   {.tracing = {settings.precision}, .query = Query::count_hits, .faces = faces});
    };
    count(Faces::both, hits);
    count(Faces::front, fronts);
    for (std::size_t i = 0; i < rays.size(); ++i) {
      all.crossing += hits[i] > 0 ? 1 : 0;
      all.hits += hits[i];
      all.wrong += hits[i] != 2 * fronts[i] ? 1 : 0;
    }
  }
  return all;
}

void bench_crossings(const Settings& settings, Output& output) {
  const bool cuda = output.on_cuda(settings.backend);
  const SceneFile scene(settings.scene);
  const StructureFile grid(settings.grid);
  const ResidentTracer tracer(scene, &grid, cuda ? Device::cuda : Device::cpu);
  const Crossings all =
      scene.with_view([&](const auto& view) { return count_crossings(settings, tracer, view); });
  output.json.push_back(
      {{"rays", all.rays}, {"crossing", all.crossing}, {"hits", all.hits}, {"wrong", all.wrong}});
  output.print("{:>12} {:>12} {:>12} {:>12}\n{:>12} {:>12} {:>12} {:>12}\n", "rays", "crossing", "hits",
               "wrong", all.rays, all.crossing, all.hits, all.wrong);
}

void add_options(const CommandLine& command, Settings& settings) {
  command.add_option("SCENE", settings.scene, "scene file of closed meshes, their fronts outside").required();
  add_grid(command, settings.grid);
  add_count(command, "--count", settings.count, "number of rays", 40);
  add_seed(command, settings.seed);
  add_backend(command, settings.backend);
  command.add_choice(
      "--precision", settings.precision,
      {{"auto", Precision::automatic}, {"robust", Precision::robust}, {"double", Precision::doubled}},
      "arithmetic: robust, double, or auto, what the scene's store asks for");
}

} // namespace

void add_crossings(const CommandLine& command) {
  add_command(command, "crossings", "How often rays through corners, edges and faces cross a closed mesh",
              "teapot.scene teapot.grid", add_options, bench_crossings);
}

} // namespace masu
