#include "stability/oracle/backends.h"

#include "libgrid/grid/division.h"
#include "libgrid/hierarchy/hierarchy_builder.h"
#include "libgrid/structure/builder.h"
#include "libscene/file/scene_file.h"
#include "stability/same_bits.h"

namespace masu::stability {
namespace {

// The scene as the parser would return it.
template <class Stored>
Scene scene_of(const TestScene<Stored>& trial) {
  Scene scene{};
  scene.camera = {{0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 45, 0.01, 8, 8};
  scene.has_camera = true;
  scene.materials = {trial.material};
  for (const auto& triangle : trial.triangles)
    scene.triangles.push_back(widened(triangle));
  for (const auto& sphere : trial.spheres)
    scene.spheres.push_back(widened(sphere));
  for (const auto& cone : trial.cones)
    scene.cones.push_back(widened(cone));
  scene.sphere_surfaces.assign(scene.spheres.size(), {});
  scene.cone_surfaces.assign(scene.cones.size(), {});
  scene.objects.polygons = 1; // one object for all primitives
  return scene;
}

template <class Stored>
StructureFile built(const SceneFile& scene, const StructureWanted& wanted) {
  const SceneView<Stored> view = scene.view<Stored>();
  const auto layout = layout_in<Stored>(scene.bounds(), wanted.division);
  StructureOptions options{wanted.kind};
  return structure_in_memory(build_structure(view, layout, Overlap::exact, options),
                             {scene.geometry_hash(), scene.primitive_count(), scene.origin(),
                              SpaceRule::tight, Overlap::exact, "stability", ""});
}

std::uint64_t differing(const SceneFile& scene, const StructureFile& grid, std::span<const Ray<double>> rays,
                        Precision precision) {
  RaysRequest request{{precision}};
  const RayHits cpu = ResidentTracer(scene, &grid, Device::cpu).hits(rays, request, HitName::primitive);
  const ResidentTracer on_gpu(scene, &grid, Device::cuda);
  std::uint64_t different = 0;
  for (const RayLoop loop : {RayLoop::thread_per_ray, RayLoop::warp, RayLoop::warp_refill}) {
    request.loop = loop;
    const RayHits gpu = on_gpu.hits(rays, request, HitName::primitive);
    for (std::size_t i = 0; i < rays.size(); ++i)
      different += same_bits(cpu.hits[i], gpu.hits[i]) ? 0 : 1;
  }
  return different;
}

template <class Stored>
void compare_step(const Sweep& sweep, const Trial<Stored>& trial, double step,
                  const std::function<void(const Difference&)>& report) {
  constexpr bool float64 = std::is_same_v<Stored, double>;
  const SceneFile scene = scene_in_memory(scene_of(trial.scene), float64 ? Store::float64 : Store::float32,
                                          Vec3d{0, 0, 0}); // what the sweeps vary
  for (const Mode& mode : float64 ? std::vector<Mode>{doubled} : std::vector<Mode>{fast, robust, doubled}) {
    Difference difference{sweep.name, step, mode, float64, trial.rays.size(), 0};
    for (const StructureWanted& wanted : trial.grids) {
      if (wanted.kind == StructureKind::hierarchy &&
          !fits_hierarchy(space_of<Stored>(scene.bounds(), SpaceRule::tight)))
        continue;
      difference.differing += differing(scene, built<Stored>(scene, wanted), trial.rays, mode.precision);
    }
    report(difference);
  }
}

} // namespace

void compare_backends(const Sweep& sweep, const RunSettings& settings,
                      const std::function<void(const Difference&)>& report) {
  for_each_trial(sweep, settings.rays, settings.seed,
                 [&](const auto& trial, double step) { compare_step(sweep, trial, step, report); });
}

} // namespace masu::stability
