// A tracer's files on a device, with a hierarchy that is built there, or fitted to vertices that have moved.
#include "libgrid/structure/structure.h"
#include "libscene/mesh/move_passes.h"
#include "renderer/cuda/device_files.h"

namespace masu {

std::shared_ptr<const DeviceFiles> built_files_cuda(const SceneFile& scene, int device,
                                                    const ProgressMonitor* progress) {
  return files_on(device, scene, nullptr, [&]<class Stored>(DeviceFilesOf<Stored>& files, Transfer&) {
    const unsigned kinds = checked_kinds(files, scene);
    const auto layout = layout_in<Stored>(scene.bounds(), {1, 1, 1}, SpaceRule::tight);
    // What is kept would lie scattered among what building took, where that is more than a block of a pool. A
    // pool of its own takes some .5 ms, one for both up to 32 MB more.
    constexpr std::uint32_t most_in_block = 100'000, most_in_pool = 1'000'000;
    const std::uint64_t count = files.scene.view.primitive_count();
    std::optional<MemoryPool> temporary;
    if (count > most_in_pool) temporary.emplace();
    auto built = fast_hierarchy(files.scene.view, layout, temporary ? *temporary : files.memory.pool, device,
                                progress);
    if (count > most_in_block) built = files.copied(std::move(built));
    files.take(std::move(built));
    files.rearrange_leaves(scene);
    return kinds;
  });
}

Structure built_hierarchy_cuda(const DeviceFiles& files) {
  const DeviceScope scope(files.memory->device);
  return files.with_store([](const auto& stored) {
    const StructureRecords& records = *stored.structure.records;
    Structure built;
    built.layout = records.layout;
    built.kind = StructureKind::hierarchy;
    built.nodes.resize(records.node_count);
    built.references.resize(records.reference_count);
    const auto references = stored.references();
    Transfer download(stored.memory.pool);
    download.to_host(built.nodes.data(), records.nodes, records.node_count * sizeof(HierarchyNode));
    download.to_host(built.references.data(), references.data(), references.size() * sizeof(PrimitiveIndex));
    download.run();
    return built;
  });
}

std::shared_ptr<const DeviceFiles> moved_files_cuda(const DeviceFiles& files, const Vec3d& origin,
                                                    const Vertices& vertices) {
  DeviceMemory& memory = *files.memory;
  const DeviceScope scope(memory.device);
  if (memory.indices.size() == 0)
    on_device(vertices.indices.data(), vertices.indices.size(), memory, memory.indices);
  auto moved_files = std::make_shared<DeviceFiles>(files.memory);
  moved_files->kinds = files.kinds;
  const auto move = [&]<class Stored, class Number>(const DeviceFilesOf<Stored>& from,
                                                    std::optional<DeviceFilesOf<Stored>>& to,
                                                    const Number* numbers) {
    DeviceArray<Number> copy;
    const WorldVertices<Number> on_gpu{on_device(numbers, 3 * vertices.count, memory, copy),
                                       memory.indices.data(), origin};
    const DeviceArray<PrimitiveIndex> references = from.references();
    StructureRecords hierarchy = *from.structure.records;
    hierarchy.references = references.data();
    MovedHierarchy<Stored> moved =
        moved_hierarchy(from.scene.view, hierarchy, on_gpu, memory.pool, memory.device);
    if (moved.nodes.size() == 0) return false;
    to.emplace(from, std::move(moved));
    return true;
  };
  const auto move_to = [&](const auto& from, auto& to) {
    return vertices.floats != nullptr ? move(*from, to, vertices.floats) : move(*from, to, vertices.doubles);
  };
  const bool is_moved = files.float64 ? move_to(files.float64, moved_files->float64)
                                      : move_to(files.float32, moved_files->float32);
  return is_moved ? moved_files : nullptr;
}

} // namespace masu
