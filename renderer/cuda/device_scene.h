// A scene and a grid on a CUDA device: one copy a section, as they lie in the files. CUDA sources only.
#pragma once

#include "libgrid/file/grid_file.h"
#include "libgrid/trace/trace.h"
#include "libscene/cuda/device_primitives.h"
#include "libscene/scene_view.h"
#include "renderer/cuda/kernel.h"
#include "renderer/dispatch.h"

#include <optional>
#include <type_traits>

namespace masu {

template <class Stored>
struct DeviceScene {
  SceneView<Stored> view;
  DevicePrimitives<Stored> primitives;
  DeviceArray<CornerNormals<Stored>> normals;
  DeviceArray<Surface> sphere_surfaces;
  DeviceArray<Surface> cone_surfaces;
  DeviceArray<std::uint32_t> faces;
  DeviceArray<Material> materials;
  DeviceArray<Light<Stored>> lights;

  DeviceScene(const SceneFile& file, Transfer& upload)
      : view(file.view<Stored>()), primitives(view, file, upload) {
    using fb::SceneSection;
    const auto moved = [&]<class T>(SceneSection section, const T*& records, std::uint64_t count) {
      return uploaded(file, section, records, count, upload);
    };
    normals = moved(SceneSection::corner_normals, view.normals, file.counts().normals);
    sphere_surfaces = moved(SceneSection::sphere_surfaces, view.sphere_surfaces, view.sphere_count);
    cone_surfaces = moved(SceneSection::cone_surfaces, view.cone_surfaces, view.cone_count);
    faces = moved(SceneSection::faces, view.faces, file.has_faces() ? view.triangle_count : 0);
    materials = moved(SceneSection::materials, view.materials, file.counts().materials);
    lights = moved(SceneSection::lights, view.lights, view.light_count);
  }
};

struct DeviceGrid {
  DeviceArray<std::uint32_t> voxel_map;
  DeviceArray<MergedCell> cells;
  DeviceArray<PrimitiveIndex> references;
  DeviceArray<HierarchyNode> nodes;
  GridRecords records{}; // in the device's memory

  DeviceGrid(const GridFile* grid, Transfer& upload) {
    if (grid == nullptr) return;
    using fb::GridSection;
    records = grid->records();
    const auto moved = [&]<class T>(GridSection section, const T*& of, std::uint64_t count,
                                    std::size_t room = 0) {
      return uploaded(*grid, section, of, count, upload, room);
    };
    voxel_map = moved(GridSection::voxel_map, records.voxel_map, records.words);
    cells = moved(GridSection::cells, records.cells, records.cell_count);
    references =
        moved(GridSection::references, records.references, records.reference_count, references_read_ahead);
    nodes = moved(GridSection::nodes, records.nodes, records.node_count);
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
  template <class Real>
  AnyStructure<Real> moved(const AnyStructure<Real>& any) const {
    return {any.structure, any.stop, moved(any.uniform), moved(any.merged), moved(any.hierarchy)};
  }
};

// A scene and its grid on the device.
template <class Stored>
struct DeviceFilesOf {
  Queue queue; // null stream, own pool
  DeviceScene<Stored> scene;
  DeviceGrid grid;
  DeviceArray<Triangle<Stored>> leaves; // of a hierarchy of triangles alone: LeafHierarchyView
  mutable KernelCache kernels;

  DeviceFilesOf(const SceneFile& host_scene, const GridFile* host_grid, cudaMemPool_t pool, Transfer& upload)
      : queue{nullptr, pool}, scene(host_scene, upload), grid(host_grid, upload) {}

  // When the files are there and checked. (No kernel of doubles takes triangles from a hierarchy's leaves.)
  void make_leaves(const GridFile* host_grid) {
    const bool has_others = scene.view.sphere_count > 0 || scene.view.cone_count > 0;
    const std::size_t count = grid.records.reference_count;
    if (!std::is_same_v<Stored, float> || host_grid == nullptr || !host_grid->is_hierarchy() || has_others ||
        count == 0)
      return;
    leaves = DeviceArray<Triangle<Stored>>(count, queue);
    const Triangle<Stored>* const triangles = scene.view.triangles;
    const PrimitiveIndex* const references = grid.references.data();
    Triangle<Stored>* const leaf = leaves.data();
    for_each_on_device(count, queue.stream, [=] __device__(std::uint64_t i) {
      Triangle<Stored> copy = triangles[references[i]];
      copy.object = references[i];
      leaf[i] = copy;
    });
    check(cudaStreamSynchronize(queue.stream));
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
