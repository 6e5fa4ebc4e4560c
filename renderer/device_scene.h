// A scene and a grid on a CUDA device: one copy a section, as they lie in the files. CUDA sources only.
#pragma once

#include "libgrid/grid_file.h"
#include "libgrid/trace.h"
#include "libscene/scene_view.h"
#include "libscene/stopwatch.h"
#include "renderer/device_memory.h"

namespace masu {

template <class Stored>
struct DeviceScene {
  SceneView<Stored> view;
  DeviceArray<Triangle<Stored>> triangles{view.triangles, view.triangle_count};
  DeviceArray<CornerNormals<Stored>> normals{view.normals, view.normals_count};
  DeviceArray<Sphere<Stored>> spheres{view.spheres, view.sphere_count};
  DeviceArray<Surface> sphere_surfaces{view.sphere_surfaces, view.sphere_count};
  DeviceArray<Cone<Stored>> cones{view.cones, view.cone_count};
  DeviceArray<Surface> cone_surfaces{view.cone_surfaces, view.cone_count};
  DeviceArray<Material> materials{view.materials, view.material_count};
  DeviceArray<Light<Stored>> lights{view.lights, view.light_count};

  explicit DeviceScene(const SceneView<Stored>& host) : view(host) {
    view.triangles = triangles.data();
    view.normals = normals.data();
    view.spheres = spheres.data();
    view.sphere_surfaces = sphere_surfaces.data();
    view.cones = cones.data();
    view.cone_surfaces = cone_surfaces.data();
    view.materials = materials.data();
    view.lights = lights.data();
  }
};

struct DeviceGrid {
  DeviceArray<std::uint32_t> voxel_map;
  DeviceArray<MergedCell> cells;
  DeviceArray<PrimitiveIndex> references;

  explicit DeviceGrid(const GridFile* grid) {
    if (grid == nullptr) return;
    voxel_map = DeviceArray<std::uint32_t>(grid->voxel_map());
    cells = DeviceArray<MergedCell>(grid->cells());
    references = DeviceArray<PrimitiveIndex>(grid->references());
  }
  template <class Real>
  GridView<Real> moved(GridView<Real> view) const {
    view.voxel_map = voxel_map.data();
    view.references = references.data();
    return view;
  }
  template <class Real>
  MergedGridView<Real> moved(MergedGridView<Real> view) const {
    view.voxel_map = voxel_map.data();
    view.cells = cells.data();
    view.references = references.data();
    return view;
  }
  NoGrid moved(NoGrid) const { return {}; }
};

// What is traced, on the device, and how many seconds getting it there took.
template <class Stored>
struct Uploaded {
  Stopwatch watch;
  DeviceScene<Stored> scene;
  DeviceGrid grid;
  double seconds;

  Uploaded(const SceneView<Stored>& host_scene, const GridFile* host_grid)
      : scene(host_scene), grid(host_grid) {
    check(cudaDeviceSynchronize());
    seconds = watch.seconds();
  }
};

} // namespace masu
