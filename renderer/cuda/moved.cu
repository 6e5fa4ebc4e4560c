// A tracer's files on a device, moved to other vertices.
#include "libscene/mesh/move_passes.h"
#include "renderer/cuda/device_files.h"

namespace masu {

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
