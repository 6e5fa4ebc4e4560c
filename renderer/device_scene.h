// A scene and a grid on a CUDA device: one copy a section, as they lie in the files. CUDA sources only.
#pragma once

#include "libgrid/file/grid_file.h"
#include "libgrid/trace/trace.h"
#include "libscene/cuda/transfer.h"
#include "libscene/scene_view.h"
#include "renderer/dispatch.h"
#include "renderer/kernel_cuda.h"

#include <optional>
#include <type_traits>

namespace masu {

template <class Stored>
struct DeviceScene {
  SceneView<Stored> view;
  DeviceArray<Triangle<Stored>> triangles;
  DeviceArray<CornerNormals<Stored>> normals;
  DeviceArray<Sphere<Stored>> spheres;
  DeviceArray<Surface> sphere_surfaces;
  DeviceArray<Cone<Stored>> cones;
  DeviceArray<Surface> cone_surfaces;
  DeviceArray<Material> materials;
  DeviceArray<Light<Stored>> lights;

  DeviceScene(const SceneView<Stored>& host, Transfer& upload) : view(host) {
    const auto moved = [&]<class T>(const T*& records, std::uint32_t count) {
      DeviceArray<T> array = upload.array(std::span(records, count));
      records = array.data();
      return array;
    };
    triangles = moved(view.triangles, view.triangle_count);
    normals = moved(view.normals, view.normals_count);
    spheres = moved(view.spheres, view.sphere_count);
    sphere_surfaces = moved(view.sphere_surfaces, view.sphere_count);
    cones = moved(view.cones, view.cone_count);
    cone_surfaces = moved(view.cone_surfaces, view.cone_count);
    materials = moved(view.materials, view.material_count);
    lights = moved(view.lights, view.light_count);
  }
};

struct DeviceGrid {
  DeviceArray<std::uint32_t> voxel_map;
  DeviceArray<MergedCell> cells;
  DeviceArray<PrimitiveIndex> references;
  DeviceArray<HierarchyNode> nodes;

  DeviceGrid(const GridFile* grid, Transfer& upload) {
    if (grid == nullptr) return;
    voxel_map = upload.array(grid->voxel_map());
    cells = upload.array(grid->cells());
    references = upload.array(grid->references(), references_read_ahead);
    nodes = upload.array(grid->nodes());
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
  template <class Real>
  HierarchyView<Real> moved(HierarchyView<Real>) const {
    return {nodes.data(), references.data()};
  }
  NoGrid moved(NoGrid) const { return {}; }
};

inline constexpr int leaves_a_block = 128;

template <class Stored>
__global__ void __launch_bounds__(leaves_a_block)
    copy_leaves(const Triangle<Stored>* const triangles, const PrimitiveIndex* const references,
                const std::size_t count, Triangle<Stored>* const leaves) {
  const std::size_t i = std::size_t{blockIdx.x} * leaves_a_block + threadIdx.x;
  if (i >= count) return;
  Triangle<Stored> leaf = triangles[references[i]];
  leaf.object = references[i];
  leaves[i] = leaf;
}

// A scene and its grid on the device.
template <class Stored>
struct DeviceFilesOf {
  DeviceScene<Stored> scene;
  DeviceGrid grid;
  DeviceArray<Triangle<Stored>> leaves; // of a hierarchy of triangles alone: LeafHierarchyView
  mutable KnownKernels kernels;

  DeviceFilesOf(const SceneView<Stored>& host_scene, const GridFile* host_grid, Transfer& upload)
      : scene(host_scene, upload), grid(host_grid, upload) {}

  // When the files are there and checked.
  void make_leaves(const GridFile* host_grid) {
    const bool has_others = scene.view.sphere_count > 0 || scene.view.cone_count > 0;
    if (host_grid == nullptr || !host_grid->is_hierarchy() || has_others) return;
    const std::size_t count = host_grid->references().size();
    if (count == 0) return;
    leaves = DeviceArray<Triangle<Stored>>(count);
    const auto blocks = static_cast<unsigned>((count + leaves_a_block - 1) / leaves_a_block);
    copy_leaves<<<blocks, leaves_a_block>>>(scene.view.triangles, grid.references.data(), count,
                                            leaves.data());
    check(cudaGetLastError());
    check(cudaStreamSynchronize(nullptr));
  }

  // The accelerator as kernels of a method have it.
  template <class M, class View>
  auto moved(const View& view) const {
    if constexpr (is_hierarchy<View> && M::kinds == with_triangles)
      return LeafHierarchyView<typename M::Real, Stored>{grid.nodes.data(), leaves.data()};
    else
      return grid.moved(view);
  }
};

} // namespace masu
