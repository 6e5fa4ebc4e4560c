// Placed meshes put on a device, and moved there.
#include "renderer/cuda/placed/placed_rays.h"
#include "renderer/tracer/placed_tracer.h"

#include <cstring>

namespace masu {
namespace {

// Of the files without placements, or with others, which may be `before`.
template <class Stored>
DeviceFilesOf<Stored> with_placements(const DeviceFilesOf<Stored>& from, const PlacedParts<Stored>& parts,
                                      const SharedArrays& parts_memory,
                                      const std::shared_ptr<const CudaExecutor>& executor,
                                      const PlacementMoves& moves, const Transform* before) {
  PlacedArrays<CudaExecutor, Stored> arrays = placed(*executor, parts, moves, before);
  DeviceFilesOf<Stored> files = from;
  files.scene.view = arrays.scene();
  files.placements = std::make_shared<const PlacedOnDevice<Stored>>(
      PlacedOnDevice<Stored>{parts_memory, executor, std::move(arrays)});
  return files;
}

template <class Stored>
void upload_placed(const PlacedOnHost<Stored>& host, DeviceFiles& files,
                   std::optional<DeviceFilesOf<Stored>>& to) {
  const PlacedScene& scene = *host.scene;
  Transfer upload(files.memory->pool);
  const DeviceFilesOf<Stored> beside(*scene.beside, nullptr, files.memory->pool, upload);
  SharedArrays memory;
  const auto add = [&](const auto& from) {
    using T = typename std::decay_t<decltype(from)>::value_type;
    DeviceArray<T> array = upload.room_for<T>(from.size());
    upload.to_device(array.data(), from.data(), from.size() * sizeof(T));
    const T* const data = array.data();
    memory.push_back(shared(std::move(array)));
    return data;
  };
  const auto& transforms = host.arrays.transforms;
  DeviceArray<Transform> copy = upload.room_for<Transform>(transforms.size());
  upload.to_device(copy.data(), transforms.data(), transforms.size() * sizeof(Transform));
  const PlacedParts<Stored> parts =
      parts_of(scene, *host.meshes, beside.scene.view, host.arrays.parts.is_brute_force, add);
  upload.run();
  to.emplace(with_placements(beside, parts, memory, std::make_shared<const CudaExecutor>(files.memory->pool),
                             moves_of(copy), nullptr));
}

} // namespace

std::shared_ptr<const DeviceFiles> upload_placed_cuda(const AnyPlacedOnHost& host, int device) {
  const DeviceScope scope(device);
  auto files = std::make_shared<DeviceFiles>(std::make_shared<DeviceMemory>(device));
  if (const auto* const of_floats = std::get_if<PlacedOnHost<float>>(&host))
    upload_placed(*of_floats, *files, files->float32);
  else
    upload_placed(std::get<PlacedOnHost<double>>(host), *files, files->float64);
  return files;
}

std::shared_ptr<const DeviceFiles> placed_files_cuda(const DeviceFiles& files, const PlacementMoves& moves) {
  const DeviceMemory& memory = *files.memory;
  const DeviceScope scope(memory.device);
  auto moved = std::make_shared<DeviceFiles>(files.memory);
  const std::size_t numbers = moves.count * moves.numbers();
  DeviceArray<std::uint32_t> index_copy;
  DeviceArray<float> float_copy;
  DeviceArray<double> double_copy;
  PlacementMoves here = moves;
  here.indices = on_device(moves.indices, moves.indices != nullptr ? moves.count : 0, memory, index_copy);
  here.floats = on_device(moves.floats, moves.floats != nullptr ? numbers : 0, memory, float_copy);
  here.doubles = on_device(moves.doubles, moves.doubles != nullptr ? numbers : 0, memory, double_copy);
  const auto move = [&](const auto& from, auto& to) {
    const auto& before = *from->placements;
    to.emplace(with_placements(*from, before.arrays.parts, before.parts_memory, before.executor, here,
                               before.arrays.transforms.data()));
  };
  files.float64 ? move(files.float64, moved->float64) : move(files.float32, moved->float32);
  return moved;
}

} // namespace masu
