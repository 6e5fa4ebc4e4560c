// A scene and its structure on a CUDA device: one copy a section, as they lie in the files, but triangles
// that a hierarchy refers to, which lie in its leaves. CUDA sources only.
#pragma once

#include "libgrid/file/structure_file.h"
#include "libgrid/hierarchy/device_hierarchy.h"
#include "libgrid/trace/trace.h"
#include "libscene/base/atomic.h"
#include "libscene/cuda/transfer.h"
#include "libscene/geometry/margin.h"
#include "libscene/mesh/device_triangles.h"
#include "libscene/scene_view.h"
#include "renderer/cuda/kernel.h"
#include "renderer/dispatch.h"

#include <algorithm>
#include <functional>
#include <memory>
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
  Lighting<Stored> lighting;
  std::shared_ptr<const void> triangles;
  SharedArrays others;

  // Triangles in leaf order come later (DeviceFilesOf::make_leaves).
  DeviceScene(const SceneFile& file, bool in_leaf_order, Transfer& upload)
      : view(file.view_but_triangles<Stored>()), lighting(file.lighting<Stored>()) {
    using fb::SceneSection;
    const auto add = [&]<class T>(SceneSection section, const T*& records, std::uint64_t count) {
      others.push_back(shared(uploaded(file, section, records, count, upload)));
    };
    add(SceneSection::spheres, view.spheres, view.sphere_count);
    add(SceneSection::cones, view.cones, view.cone_count);
    add(SceneSection::corner_normals, view.normals, file.counts().normals);
    add(SceneSection::sphere_surfaces, view.sphere_surfaces, view.sphere_count);
    add(SceneSection::cone_surfaces, view.cone_surfaces, view.cone_count);
    add(SceneSection::faces, view.faces, file.has_faces() ? view.triangle_count : 0);
    add(SceneSection::materials, view.materials, file.counts().materials);
    add(SceneSection::lights, lighting.lights, lighting.light_count);
    if (in_leaf_order) return;
    if (const auto unmade = file.unmade_triangles()) {
      auto made = made_on_device<Stored>(*unmade, file.origin(), upload);
      view.triangles = made.data();
      triangles = shared(std::move(made));
      return;
    }
    file.make_whole(); // where another thread is at it
    triangles = shared(uploaded(file, SceneSection::triangles, view.triangles, view.triangle_count, upload));
  }
};

struct DeviceStructure {
  TracedRecords records;
  std::shared_ptr<const void> nodes, references;
  SharedArrays others;

  DeviceStructure(const StructureFile* file, Transfer& upload) : records(records_of(file)) {
    if (file == nullptr) return;
    using fb::StructureSection;
    const auto sent = [&]<class T>(StructureSection section, const T*& of, std::uint64_t count,
                                   std::size_t room = 0) {
      return shared(uploaded(*file, section, of, count, upload, room));
    };
    others = {sent(StructureSection::voxel_map, records->voxel_map, records->words),
              sent(StructureSection::cells, records->cells, records->cell_count)};
    references = sent(StructureSection::references, records->references, records->reference_count,
                      references_read_ahead);
    nodes = sent(StructureSection::nodes, records->nodes, records->node_count);
  }
};

template <class Real, class Stored>
using AnyOnDevice = AnyStructure<Real, LeafHierarchyView<Real, Stored>>;

// Takes a corner of a triangle, as it lies in a file, to the triangle's leaf: parts of an upload don't end
// with triangles.
template <class Stored>
struct CornerToLeaf {
  // With one of the triangle's tags.
  struct Corner {
    Vec3<Stored> at;
    typename Triangle<Stored>::Tag tag;
  };
  static_assert(3 * sizeof(Corner) == sizeof(Triangle<Stored>));

  TrianglePlace* places;
  Triangle<Stored>* leaves;
  std::uint32_t none;              // no triangle's leaf
  const Corner* corners = nullptr; // of the part,
  std::uint64_t first = 0;         // which begins with this one of the scene's

  __device__ void operator()(std::uint64_t i) const {
    const std::uint64_t triangle = (first + i) / 3, which = (first + i) % 3;
    Corner corner = corners[i];
    if (which == 0) {
      places[triangle].object =
          corner.tag < no_primitive ? static_cast<std::uint32_t>(corner.tag) : no_primitive;
      corner.tag = static_cast<std::uint32_t>(triangle);
    }
    const std::uint32_t leaf = places[triangle].leaf;
    if (leaf != none) reinterpret_cast<Corner*>(leaves + leaf)[which] = corner;
  }
};

template <class Stored>
struct PlacedOnDevice; // placed_rays.h

// A scene and its structure on the device.
template <class Stored>
struct DeviceFilesOf {
  StreamMemory memory; // null stream, own pool
  DeviceScene<Stored> scene;
  DeviceStructure structure;
  std::shared_ptr<KernelCache> kernels = std::make_shared<KernelCache>();
  // In the structure's place, where meshes are placed; the scene is what stands beside them.
  std::shared_ptr<const PlacedOnDevice<Stored>> placements;

  // For a hierarchy make_leaves() is to follow.
  DeviceFilesOf(const SceneFile& host_scene, const StructureFile* host_structure, cudaMemPool_t pool,
                Transfer& upload)
      : memory{nullptr, pool},
        scene(host_scene, host_structure != nullptr && host_structure->is_hierarchy(), upload),
        structure(host_structure, upload) {}

  // The same scene with its triangles and the hierarchy's nodes displaced.
  DeviceFilesOf(const DeviceFilesOf& before, MovedHierarchy<Stored> displaced)
      : memory(before.memory), scene(before.scene), structure(before.structure), kernels(before.kernels) {
    scene.view.triangles = displaced.triangles.data();
    scene.view.clip = cast<Stored>(padded_bounds<Stored>(displaced.bounds));
    scene.triangles = shared(std::move(displaced.triangles));
    structure.records->nodes = displaced.nodes.data();
    structure.nodes = shared(std::move(displaced.nodes));
  }

  bool is_hierarchy() const { return structure.records && structure.records->is_hierarchy; }

  // A hierarchy in another pool.
  StructureIn<CudaMemory> copied(StructureIn<CudaMemory> built) const {
    const auto copied = [&]<class T>(const DeviceArray<T>& from) {
      DeviceArray<T> to(from.size(), memory);
      if (from.size() > 0)
        check(cudaMemcpyAsync(to.data(), from.data(), from.size() * sizeof(T), cudaMemcpyDeviceToDevice,
                              memory.stream));
      return to;
    };
    built.nodes = copied(built.nodes);
    built.references = copied(built.references);
    return built;
  }
  // One of the scene, whose triangles are there in their order.
  void take(StructureIn<CudaMemory> built) {
    structure.records = built;
    structure.records->primitives = scene.view.primitive_count();
    structure.nodes = shared(std::move(built.nodes));
    structure.references = shared(std::move(built.references));
  }

  // The scene's primitives into the leaves of the hierarchy, whose records are there and checked: triangles
  // are nowhere else on the device. What a leaf is of stands in it: the references are given up.
  // `place_triangles` has all triangles placed by what it is given, and waits for what isn't on this stream.
  void make_leaves(const SceneFile& file,
                   const std::function<void(const Transfer::Place&)>& place_triangles) {
    SceneView<Stored>& view = scene.view;
    const std::uint64_t count = structure.records->reference_count;
    const PrimitiveIndex* const references = structure.records->references;
    DeviceArray<TrianglePlace> place_array(std::max(view.triangle_count, 1U), memory);
    // One more, a point, in the place of triangles without a surface, which no reference is to.
    DeviceArray<Triangle<Stored>> leaf_array(count + 1, memory);
    TrianglePlace* const places = place_array.data();
    Triangle<Stored>* const leaves = leaf_array.data();
    const auto none = static_cast<std::uint32_t>(count);
    const std::uint32_t triangle_count = view.triangle_count;
    const Vec3<Stored> point = cast<Stored>(file.bounds().min);
    for_each_on_device(std::max(triangle_count, 1U), memory.stream, [=] __device__(std::uint64_t i) {
      if (i < triangle_count) places[i] = {none, no_primitive};
      if (i == 0) leaves[none] = {point, no_primitive, point, 0, point, no_normals};
    });
    for_each_on_device(count, memory.stream, [=] __device__(std::uint64_t i) {
      if (references[i] < triangle_count) lower(places[references[i]].leaf, static_cast<std::uint32_t>(i));
    });
    place_triangles([=](const void* part, std::uint64_t offset, std::size_t bytes, cudaStream_t stream) {
      using Corner = typename CornerToLeaf<Stored>::Corner;
      const auto* const corners = static_cast<const Corner*>(part);
      for_each_on_device(bytes / sizeof(Corner), stream,
                         CornerToLeaf<Stored>{places, leaves, none, corners, offset / sizeof(Corner)});
    });
    view.places = places;
    view.triangles = leaves;
    const SceneView<Stored> placed = view;
    for_each_on_device(count, memory.stream, [=] __device__(std::uint64_t i) {
      if (references[i] >= triangle_count || places[references[i]].leaf != i)
        leaves[i] = leaf_of(placed, references[i]).record;
    });
    check(cudaStreamSynchronize(memory.stream));
    scene.triangles = shared(std::move(leaf_array));
    scene.others.push_back(shared(std::move(place_array)));
    structure.references.reset();
    structure.records->references = nullptr;
  }

  // The same of triangles from the file, and of those that are there in their order.
  void upload_leaves(const SceneFile& file, Transfer& upload) {
    make_leaves(file, [&](const Transfer::Place& place) {
      if (const Triangle<Stored>* const in_host = file.view<Stored>().triangles)
        upload.to_device(nullptr, in_host, scene.view.triangle_count * sizeof(Triangle<Stored>), place);
      else if (scene.view.triangle_count > 0)
        upload.to_device(nullptr, file.reader<Triangle<Stored>>(fb::SceneSection::triangles), place);
      upload.run();
    });
  }
  void rearrange_leaves(const SceneFile& file) {
    make_leaves(file, [&](const Transfer::Place& place) {
      place(scene.view.triangles, 0, scene.view.triangle_count * sizeof(Triangle<Stored>), memory.stream);
    });
  }

  // What a hierarchy refers to.
  DeviceArray<PrimitiveIndex> references() const {
    DeviceArray<PrimitiveIndex> array(structure.records->reference_count, memory);
    PrimitiveIndex* const reference = array.data();
    const Triangle<Stored>* const leaves = scene.view.triangles;
    for_each_on_device(array.size(), memory.stream, [=] __device__(std::uint64_t i) {
      reference[i] = static_cast<PrimitiveIndex>(leaves[i].object);
    });
    return array;
  }

  // A view of the records as kernels have it: through a hierarchy with leaves.
  template <class View>
  const View& on_device(const View& view) const {
    return view;
  }
  template <class Real>
  LeafHierarchyView<Real, Stored> on_device(const HierarchyView<Real>& view) const {
    return {view.nodes, reinterpret_cast<const Leaf<Stored>*>(scene.view.triangles)};
  }
  template <class Real>
  AnyOnDevice<Real, Stored> on_device(const AnyStructure<Real>& any) const {
    return {any.form, any.stop, any.uniform, any.merged, on_device(any.hierarchy)};
  }
};

} // namespace masu
