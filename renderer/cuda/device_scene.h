// A scene and a grid on a CUDA device: one copy a section, as they lie in the files. CUDA sources only.
#pragma once

#include "libgrid/file/grid_file.h"
#include "libgrid/trace/trace.h"
#include "libscene/cuda/transfer.h"
#include "libscene/scene_view.h"
#include "renderer/cuda/kernel.h"
#include "renderer/dispatch.h"

#include <optional>
#include <type_traits>

namespace masu {

// Copies records of a file to the device: out of its memory, or where they stay in the file from there.
template <class T, class File, class Section>
DeviceArray<T> uploaded(const File& file, Section section, const T* records, std::uint64_t count,
                        std::size_t room, Transfer& upload) {
  DeviceArray<T> array = upload.room_for<T>(count, room);
  if (records != nullptr)
    upload.to_device(array.data(), records, count * sizeof(T));
  else if (count > 0)
    upload.to_device(array.data(), file.template reader<T>(section));
  return array;
}

template <class Stored>
struct DeviceScene {
  SceneView<Stored> view;
  DeviceArray<Triangle<Stored>> triangles;
  DeviceArray<CornerNormals<Stored>> normals;
  DeviceArray<Sphere<Stored>> spheres;
  DeviceArray<Surface> sphere_surfaces;
  DeviceArray<Cone<Stored>> cones;
  DeviceArray<Surface> cone_surfaces;
  DeviceArray<std::uint32_t> faces;
  DeviceArray<Material> materials;
  DeviceArray<Light<Stored>> lights;

  DeviceScene(const SceneFile& file, Transfer& upload) : view(file.view<Stored>()) {
    using fb::SceneSection;
    const auto moved = [&]<class T>(SceneSection section, const T*& records, std::uint64_t count) {
      DeviceArray<T> array = uploaded(file, section, records, count, 0, upload);
      records = array.data();
      return array;
    };
    triangles = moved(SceneSection::triangles, view.triangles, view.triangle_count);
    normals = moved(SceneSection::corner_normals, view.normals, file.counts().normals);
    spheres = moved(SceneSection::spheres, view.spheres, view.sphere_count);
    sphere_surfaces = moved(SceneSection::sphere_surfaces, view.sphere_surfaces, view.sphere_count);
    cones = moved(SceneSection::cones, view.cones, view.cone_count);
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
      DeviceArray<T> array = uploaded(*grid, section, of, count, room, upload);
      of = array.data();
      return array;
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
    const auto blocks = static_cast<unsigned>((count + leaves_a_block - 1) / leaves_a_block);
    launch(copy_leaves<Stored>, blocks, leaves_a_block, queue.stream, scene.view.triangles,
           grid.references.data(), count, leaves.data());
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
