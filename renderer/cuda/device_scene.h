// A scene and a grid on a CUDA device: one copy a section, as they lie in the files. CUDA sources only.
#pragma once

#include "libgrid/file/structure_file.h"
#include "libgrid/hierarchy/moved_hierarchy.h"
#include "libgrid/trace/trace.h"
#include "libscene/cuda/device_primitives.h"
#include "libscene/geometry/margin.h"
#include "libscene/scene_view.h"
#include "renderer/cuda/kernel.h"
#include "renderer/dispatch.h"

#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace masu {

// Device arrays that copies of a scene or grid share. What moves has owners of its own.
using SharedArrays = std::vector<std::shared_ptr<const void>>;
template <class T>
std::shared_ptr<const void> shared(DeviceArray<T> array) {
  return std::make_shared<const DeviceArray<T>>(std::move(array));
}

template <class Stored>
struct DeviceScene {
  SceneView<Stored> view;
  std::shared_ptr<const void> triangles;
  SharedArrays others;

  DeviceScene(const SceneFile& file, Transfer& upload) : view(file.view<Stored>()) {
    using fb::SceneSection;
    DevicePrimitives<Stored> primitives(view, file, upload);
    triangles = shared(std::move(primitives.triangles));
    others = {shared(std::move(primitives.spheres)), shared(std::move(primitives.cones))};
    const auto add = [&]<class T>(SceneSection section, const T*& records, std::uint64_t count) {
      others.push_back(shared(uploaded(file, section, records, count, upload)));
    };
    add(SceneSection::corner_normals, view.normals, file.counts().normals);
    add(SceneSection::sphere_surfaces, view.sphere_surfaces, view.sphere_count);
    add(SceneSection::cone_surfaces, view.cone_surfaces, view.cone_count);
    add(SceneSection::faces, view.faces, file.has_faces() ? view.triangle_count : 0);
    add(SceneSection::materials, view.materials, file.counts().materials);
    add(SceneSection::lights, view.lights, view.light_count);
  }
};

struct DeviceGrid {
  StructureRecords records{}; // in the device's memory
  std::shared_ptr<const void> nodes;
  SharedArrays others;

  DeviceGrid(const StructureFile* grid, Transfer& upload) {
    if (grid == nullptr) return;
    using fb::StructureSection;
    records = grid->records();
    const auto add = [&]<class T>(StructureSection section, const T*& of, std::uint64_t count,
                                  std::size_t room = 0) {
      others.push_back(shared(uploaded(*grid, section, of, count, upload, room)));
    };
    add(StructureSection::voxel_map, records.voxel_map, records.words);
    add(StructureSection::cells, records.cells, records.cell_count);
    add(StructureSection::references, records.references, records.reference_count, references_read_ahead);
    nodes = shared(uploaded(*grid, StructureSection::nodes, records.nodes, records.node_count, upload));
  }
  // The same view of them.
  template <class Real>
  GridView<Real> moved(const GridView<Real>&) const {
    return view_of<Real>(records);
  }
  template <class Real>
  MergedGridView<Real> moved(const MergedGridView<Real>&) const {
    return merged_view_of<Real>(records);
  }
  template <class Real>
  AnyStructure<Real> moved(const AnyStructure<Real>& any) const {
    if (any.form == StructureForm::none) return any;
    AnyStructure<Real> moved = any_structure<Real>(records);
    moved.stop = any.stop;
    return moved;
  }
};

// A scene and its grid on the device.
template <class Stored>
struct DeviceFilesOf {
  Queue queue; // null stream, own pool
  DeviceScene<Stored> scene;
  DeviceGrid grid;
  DeviceArray<Leaf<Stored>> leaves; // of LeafHierarchyView
  std::shared_ptr<KernelCache> kernels = std::make_shared<KernelCache>();

  DeviceFilesOf(const SceneFile& host_scene, const StructureFile* host_grid, cudaMemPool_t pool,
                Transfer& upload)
      : queue{nullptr, pool}, scene(host_scene, upload), grid(host_grid, upload) {}

  // The same scene with its triangles and the hierarchy's nodes moved; without leaves.
  DeviceFilesOf(const DeviceFilesOf& before, MovedHierarchy<Stored> moved)
      : queue(before.queue), scene(before.scene), grid(before.grid), kernels(before.kernels) {
    scene.view.triangles = moved.triangles.data();
    scene.view.clip = cast<Stored>(padded_bounds<Stored>(moved.bounds));
    scene.triangles = shared(std::move(moved.triangles));
    grid.records.nodes = moved.nodes.data();
    grid.nodes = shared(std::move(moved.nodes));
  }

  // When the files are there and checked. Scenes of doubles are traced through the hierarchy's references.
  void make_leaves() {
    const std::size_t count = grid.records.reference_count;
    if (!std::is_same_v<Stored, float> || !grid.records.is_hierarchy || count == 0) return;
    leaves = DeviceArray<Leaf<Stored>>(count, queue);
    const SceneView<Stored> primitives = scene.view;
    const PrimitiveIndex* const references = grid.records.references;
    Leaf<Stored>* const leaf = leaves.data();
    for_each_on_device(count, queue.stream,
                       [=] __device__(std::uint64_t i) { leaf[i] = leaf_of(primitives, references[i]); });
    check(cudaStreamSynchronize(queue.stream));
  }

  // The accelerator as kernels have it.
  template <class View>
  auto moved(const View& view) const {
    return grid.moved(view);
  }
  template <class Real>
  LeafHierarchyView<Real, Stored> moved(const HierarchyView<Real>&) const {
    return {grid.records.nodes, leaves.data()};
  }
};

} // namespace masu
