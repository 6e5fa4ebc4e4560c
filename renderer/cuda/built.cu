// A tracer's files on a device, with a hierarchy that is built there.
#include "libgrid/structure/structure.h"
#include "renderer/cuda/device_files.h"

namespace masu {

std::shared_ptr<const DeviceFiles> built_files_cuda(const SceneFile& scene, int device,
                                                    const ProgressMonitor* progress) {
  const DeviceScope scope(device);
  const auto memory = std::make_shared<DeviceMemory>(device);
  auto files = std::make_shared<DeviceFiles>(memory);
  const auto build_as = [&]<class Stored>(std::optional<DeviceFilesOf<Stored>>& stored) {
    Transfer upload(memory->pool);
    stored.emplace(scene, nullptr, memory->pool, upload);
    upload.run();
    files->kinds = checked_kinds(*stored, scene);
    const auto layout = layout_in<Stored>(scene.bounds(), {1, 1, 1}, SpaceRule::tight);
    const MemoryPool temporary; // what is kept would lie scattered among what building took
    stored->take(fast_hierarchy(stored->scene.view, layout, temporary, device, progress), layout);
    stored->rearrange_leaves(scene);
  };
  scene.is_float64() ? build_as(files->float64) : build_as(files->float32);
  memory->pool.trim(); // of what building took meanwhile
  return files;
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

} // namespace masu
