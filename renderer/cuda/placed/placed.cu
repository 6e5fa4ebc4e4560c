// Placed meshes put on a device, and moved there.
#include "renderer/cuda/placed/placed.h"

#include "renderer/cuda/device_files.h"
#include "renderer/tracer/placed_tracer.h"

#include <cstring>

namespace masu {
namespace {

// Of the files without placements, or with others.
template <class Stored>
DeviceFilesOf<Stored> with_placements(const DeviceFilesOf<Stored>& from, const PlacedParts<Stored>& parts,
                                      const SharedArrays& parts_memory, DeviceArray<Transform> transforms) {
  CudaExecutor executor(from.memory.pool);
  PlacedArrays<CudaExecutor, Stored> arrays = placed(executor, parts, transforms.data());
  DeviceFilesOf<Stored> files = from;
  files.scene.view = arrays.scene();
  files.placements = std::make_shared<const PlacedOnDevice<Stored>>(
      PlacedOnDevice<Stored>{parts_memory, std::move(transforms), std::move(arrays)});
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
  DeviceArray<Transform> transforms = upload.room_for<Transform>(host.transforms.size());
  upload.to_device(transforms.data(), host.transforms.data(), host.transforms.size() * sizeof(Transform));
  const PlacedParts<Stored> parts =
      parts_of(scene, *host.meshes, beside.scene.view, host.arrays.parts.is_brute_force, add);
  upload.run();
  to.emplace(with_placements(beside, parts, memory, std::move(transforms)));
}

// The transforms with those that have moved. Of a placement that is there twice the last one counts: so all
// look first which that is.
template <class Number>
DeviceArray<Transform> replaced(const DeviceArray<Transform>& before, const PlacementMoves& moves,
                                const Number* given, const StreamMemory& memory) {
  CudaExecutor executor(memory.pool);
  const std::uint64_t count = before.size(), moving = moves.count;
  // Of each placement the number of its last, from 1 on; and what is wrong.
  auto last = executor.zeros<std::uint32_t>(moves.indices != nullptr ? count + 1 : 0);
  auto after = executor.array<Transform>(count);
  std::uint32_t* const last_of = last.data();
  const std::uint32_t* const indices = moves.indices;
  executor.for_each(indices != nullptr ? moving : 0, [=] __device__(std::uint64_t i) {
    if (indices[i] < count)
      atomicMax(last_of + indices[i], static_cast<std::uint32_t>(i) + 1);
    else
      atomicMax(last_of + count, indices[i]);
  });
  if (indices != nullptr)
    if (const std::uint32_t wrong = executor.value(last, count); wrong != 0)
      throw Error(ErrorCode::usage, "indices", std::to_string(wrong) + " isn't a placement's");
  const Transform* const from = before.data();
  Transform* const to = after.data();
  const std::uint64_t numbers = moves.are_square ? 16 : 12;
  executor.for_each(count * 12, [=] __device__(std::uint64_t i) {
    const std::uint64_t placement = i / 12, k = i % 12;
    const std::uint64_t number = indices != nullptr ? std::uint64_t{last_of[placement]} : placement + 1;
    (&to[placement].rows[0][0])[k] = number != 0 ? static_cast<double>(given[(number - 1) * numbers + k])
                                                 : (&from[placement].rows[0][0])[k];
  });
  return after;
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
  const std::size_t numbers = moves.count * (moves.are_square ? 16 : 12);
  DeviceArray<std::uint32_t> index_copy;
  PlacementMoves here = moves;
  here.indices = on_device(moves.indices, moves.indices != nullptr ? moves.count : 0, memory, index_copy);
  const auto move = [&]<class Stored, class Number>(const DeviceFilesOf<Stored>& from,
                                                    std::optional<DeviceFilesOf<Stored>>& to,
                                                    const Number* given) {
    DeviceArray<Number> copy;
    const PlacedOnDevice<Stored>& before = *from.placements;
    to.emplace(with_placements(
        from, before.arrays.parts, before.parts_memory,
        replaced(before.transforms, here, on_device(given, numbers, memory, copy), from.memory)));
  };
  const auto move_to = [&](const auto& from, auto& to) {
    moves.floats != nullptr ? move(*from, to, moves.floats) : move(*from, to, moves.doubles);
  };
  files.float64 ? move_to(files.float64, moved->float64) : move_to(files.float32, moved->float32);
  return moved;
}

} // namespace masu
