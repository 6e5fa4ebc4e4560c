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

struct DeviceStructure {
  TracedRecords records;
  std::shared_ptr<const void> nodes;
  SharedArrays others;

  DeviceStructure(const StructureFile* file, Transfer& upload) : records(records_of(file)) {
    if (file == nullptr) return;
    using fb::StructureSection;
    const auto add = [&]<class T>(StructureSection section, const T*& of, std::uint64_t count,
                                  std::size_t room = 0) {
      others.push_back(shared(uploaded(*file, section, of, count, upload, room)));
    };
    add(StructureSection::voxel_map, records->voxel_map, records->words);
    add(StructureSection::cells, records->cells, records->cell_count);
    add(StructureSection::references, records->references, records->reference_count, references_read_ahead);
    nodes = shared(uploaded(*file, StructureSection::nodes, records->nodes, records->node_count, upload));
  }
};

// A scene and its structure on the device.
template <class Stored>
struct DeviceFilesOf {
  StreamMemory memory; // null stream, own pool
  DeviceScene<Stored> scene;
  DeviceStructure structure;
  DeviceArray<Leaf<Stored>> leaves; // of LeafHierarchyView
  std::shared_ptr<KernelCache> kernels = std::make_shared<KernelCache>();

  DeviceFilesOf(const SceneFile& host_scene, const StructureFile* host_structure, cudaMemPool_t pool,
                Transfer& upload)
      : memory{nullptr, pool}, scene(host_scene, upload), structure(host_structure, upload) {}

  // The same scene with its triangles and the hierarchy's nodes displaced; without leaves.
  DeviceFilesOf(const DeviceFilesOf& before, MovedHierarchy<Stored> displaced)
      : memory(before.memory), scene(before.scene), structure(before.structure), kernels(before.kernels) {
    scene.view.triangles = displaced.triangles.data();
    scene.view.clip = cast<Stored>(padded_bounds<Stored>(displaced.bounds));
    scene.triangles = shared(std::move(displaced.triangles));
    structure.records->nodes = displaced.nodes.data();
    structure.nodes = shared(std::move(displaced.nodes));
  }

  // When the files are there and checked. Scenes of doubles are traced through the hierarchy's references.
  void make_leaves() {
    if (!std::is_same_v<Stored, float> || !structure.records || !structure.records->is_hierarchy) return;
    const std::size_t count = structure.records->reference_count;
    if (count == 0) return;
    leaves = DeviceArray<Leaf<Stored>>(count, memory);
    const SceneView<Stored> primitives = scene.view;
    const PrimitiveIndex* const references = structure.records->references;
    Leaf<Stored>* const leaf = leaves.data();
    for_each_on_device(count, memory.stream,
                       [=] __device__(std::uint64_t i) { leaf[i] = leaf_of(primitives, references[i]); });
    check(cudaStreamSynchronize(memory.stream));
  }

  // A view of the records as kernels have it: through a hierarchy with leaves.
  template <class View>
  const View& on_device(const View& view) const {
    return view;
  }
  template <class Real>
  LeafHierarchyView<Real, Stored> on_device(const HierarchyView<Real>& view) const {
    return {view.nodes, leaves.data()};
  }
};

} // namespace masu
