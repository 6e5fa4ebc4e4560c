// What hierarchies cost to build and to refit where the scene was bent, and what rays take through them.
#include "libgrid/grid/division.h"
#include "libgrid/structure/builder.h"
#include "libgrid/structure/sampled_costs.h"
#include "libscene/base/stopwatch.h"
#include "tests/stability/test_scene.h"
#include "tools/bench/bench.h"
#include "tools/bench/command.h"
#include "tools/common/repeated.h"

#include <numbers>
#include <vector>

namespace masu {
namespace {

using Json = nlohmann::ordered_json;

struct Settings {
  std::string scene;
  Backend backend = Backend::automatic;
  std::vector<double> bends{1, 10, 50};
  int repeat = 5;
};

template <class Stored>
TestScene<Stored> copied(const SceneView<Stored>& view) {
  TestScene<Stored> scene;
  scene.triangles.assign(view.triangles, view.triangles + view.triangle_count);
  for (Triangle<Stored>& triangle : scene.triangles)
    triangle.normals = no_normals;
  scene.spheres.assign(view.spheres, view.spheres + view.sphere_count);
  scene.cones.assign(view.cones, view.cones + view.cone_count);
  return scene;
}

// Points move by up to so much of the longest side, across it, by a sine along it.
template <class Stored>
TestScene<Stored> bent(TestScene<Stored> scene, double share) {
  const Boxd box = scene.bounds();
  const Vec3d size = box.max - box.min;
  const int along = size.x >= std::max(size.y, size.z) ? 0 : size.y >= size.z ? 1 : 2;
  for_each_points(scene, [&](auto&... points) {
    const auto moved = [&](Vec3<Stored>& point) {
      const double place = (static_cast<double>(point[along]) - box.min[along]) / size[along];
      const double by = share * size[along] * std::sin(2 * std::numbers::pi * place);
      const int across = (along + 1) % 3;
      point.set(across, static_cast<Stored>(static_cast<double>(point[across]) + by));
    };
    (moved(points), ...);
  });
  return scene;
}

// The median of what act() takes; on a GPU without copies.
template <class Stored, class Act>
double seconds_of(const StructureBuilder<Stored>& builder, bool on_gpu, int repeat, const Act& act) {
  std::vector<double> seconds;
  for (int i = 0; i < repeat; ++i) {
    const double before = builder.device_seconds().build;
    const Stopwatch watch;
    act();
    seconds.push_back(on_gpu ? builder.device_seconds().build - before : watch.seconds());
  }
  return median(std::move(seconds));
}

template <class Stored>
void measure(const Settings& settings, bool cuda, const SceneFile& file, Json& rows) {
  TestScene<Stored> scene = copied(file.view<Stored>());
  const auto builder_of = [&](TestScene<Stored>& of) {
    return cuda ? cuda_builder(of.view()) : cpu_builder(of.view());
  };
  for (const HierarchyQuality quality : {HierarchyQuality::high, HierarchyQuality::fast}) {
    const bool on_gpu = cuda && quality == HierarchyQuality::fast;
    StructureOptions options{StructureKind::hierarchy};
    options.quality = quality;
    const auto build = [&](StructureBuilder<Stored>& builder, const TestScene<Stored>& of) {
      return builder.build(layout_in<Stored>(of.bounds(), {1, 1, 1}), Overlap::exact, options);
    };
    const Structure unbent = build(*builder_of(scene), scene);
    for (const double bend : settings.bends) {
      TestScene<Stored> moved = bent(scene, bend / 100);
      const auto builder = builder_of(moved);
      Structure built, refitted = unbent;
      const double build_seconds =
          seconds_of(*builder, on_gpu, settings.repeat, [&] { built = build(*builder, moved); });
      const double refit_seconds = seconds_of(*builder, cuda, settings.repeat, [&] {
        if (!builder->refit(layout_in<Stored>(moved.bounds(), {1, 1, 1}), refitted))
          throw Error(ErrorCode::input, settings.scene, "has faces that get an area by bending");
      });
      const auto time_of = [&](const Structure& grid) {
        return expected_time(sampled_costs(moved.view(), grid), StructureKind::hierarchy,
                             cuda ? Processor::gpu : Processor::cpu);
      };
      rows.push_back({{"quality", quality == HierarchyQuality::high ? "high" : "fast"},
                      {"bend_percent", bend},
                      {"build_seconds", build_seconds},
                      {"refit_seconds", refit_seconds},
                      {"expected_rate", time_of(built) / time_of(refitted)}});
    }
  }
}

void bench_refit(const Settings& settings, Output& output) {
  const bool cuda = output.on_cuda(settings.backend);
  const SceneFile file(settings.scene);
  if (file.primitive_count() == 0) throw Error(ErrorCode::input, settings.scene, "holds no primitives");
  Json rows = Json::array();
  file.is_float64() ? measure<double>(settings, cuda, file, rows)
                    : measure<float>(settings, cuda, file, rows);
  output.print("{} primitives, {}, median of {}\n\n{:<8} {:>7} {:>10} {:>10} {:>22}\n",
               file.primitive_count(), output.device, settings.repeat, "quality", "bend", "build ms",
               "refit ms", "rate, over a new one");
  for (const Json& row : rows)
    output.print("{:<8} {:>6g}% {:>10.2f} {:>10.2f} {:>22.2f}\n", row["quality"].get<std::string>(),
                 row["bend_percent"].get<double>(), row["build_seconds"].get<double>() * 1e3,
                 row["refit_seconds"].get<double>() * 1e3, row["expected_rate"].get<double>());
  output.json = {
      {"scene", settings.scene}, {"primitives", file.primitive_count()}, {"rows", std::move(rows)}};
}

void add_options(const CommandLine& command, Settings& settings) {
  add_scene(command, settings.scene);
  command
      .add_option("--bends", settings.bends, "how far points move across the longest side, in percent of it")
      .comma_separated()
      .range(0.0, 1000.0)
      .type_name("LIST")
      .default_text("1,10,50");
  add_backend(command, settings.backend);
  add_repeat(command, settings.repeat, "timed runs; the median counts");
}

} // namespace

void add_refit(const CommandLine& command) {
  add_command(
      command, "refit",
      "Building a hierarchy, and refitting it to the scene bent, with the rates that a sample of rays "
      "is expected to have through it, over those through a new one",
      "teapot.scene", add_options, bench_refit);
}

} // namespace masu
