// A tracer's files on a CUDA device, and what its queries share there. CUDA sources only.
#pragma once

#include "renderer/backend.h"
#include "renderer/cuda/device_scene.h"
#include "renderer/cuda/host_rays.h"

#include <memory>
#include <mutex>
#include <optional>
#include <type_traits>
#include <vector>

namespace masu {

// What queries borrow and give back, for the next one. For threads at the same time.
template <class T>
class Pool {
public:
  // Given back at the end of its life.
  auto borrow() {
    auto give_back = [this](T* taken) {
      const std::lock_guard lock(mutex_);
      free_.emplace_back(taken);
    };
    const std::lock_guard lock(mutex_);
    if (free_.empty()) {
      free_.reserve(++made_); // so that giving back can't fail
      free_.push_back(std::make_unique<T>());
    }
    std::unique_ptr<T, decltype(give_back)> taken(free_.back().release(), give_back);
    free_.pop_back();
    return taken;
  }

  // None is borrowed.
  void clear() { free_.clear(); }

private:
  std::mutex mutex_;
  std::vector<std::unique_ptr<T>> free_;
  std::size_t made_ = 0;
};

// What a tracer has on a device besides, whatever becomes of its scene.
struct DeviceMemory {
  int device;
  MemoryPool pool; // of all that is allocated there: destroyed last
  Pool<HostRayBuffers> buffers;
  Pool<FrameBuffers> frames;
  DeviceArray<std::uint32_t> indices; // of moved vertices (ResidentTracer::moved)

  explicit DeviceMemory(int current_device) : device(current_device) {}
  DeviceMemory(const DeviceMemory&) = delete;
  DeviceMemory& operator=(const DeviceMemory&) = delete;
  ~DeviceMemory() {
    on_device_if_possible(device, [&] {
      buffers.clear();
      frames.clear();
      indices = {};
    });
  }
};

// An array on the device: where it lies, or copied there.
template <class T>
const T* on_device(const T* array, std::size_t count, const DeviceMemory& memory, DeviceArray<T>& copy) {
  if (count == 0) return array;
  const int place = device_of(array);
  if (place == memory.device) return array;
  Transfer upload(memory.pool);
  DeviceArray<T> made = upload.room_for<T>(count);
  if (place == host_memory)
    upload.to_device(made.data(), array, count * sizeof(T));
  else
    check(cudaMemcpyPeer(made.data(), memory.device, array, place, count * sizeof(T)));
  upload.run();
  copy = std::move(made); // whole, or not at all
  return copy.data();
}

// A scene and its structure, of either store: one of them.
struct DeviceFiles {
  std::shared_ptr<DeviceMemory> memory;
  unsigned kinds = with_all_kinds; // of primitives in the scene
  std::optional<DeviceFilesOf<float>> float32;
  std::optional<DeviceFilesOf<double>> float64;

  explicit DeviceFiles(std::shared_ptr<DeviceMemory> of_device) : memory(std::move(of_device)) {}
  DeviceFiles(const DeviceFiles&) = delete;
  DeviceFiles& operator=(const DeviceFiles&) = delete;
  // Waits for queries that are still queued.
  ~DeviceFiles() {
    on_device_if_possible(memory->device, [&] {
      static_cast<void>(cudaDeviceSynchronize());
      float32.reset();
      float64.reset();
    });
  }

  // Returns act(DeviceFilesOf) of the one that is there.
  template <class Act>
  auto with_store(const Act& act) const {
    return float32 ? act(*float32) : act(*float64);
  }
  template <class Stored>
  const DeviceFilesOf<Stored>& of() const {
    if constexpr (std::is_same_v<Stored, float>)
      return *float32;
    else
      return *float64;
  }
  bool are_counted(const TracingRules& rules) const {
    return with_store([&](const auto& files) {
      return files.placements == nullptr && is_counted(files.structure.records, rules);
    });
  }
};

// A function for each arithmetic and store that are compiled: `precision` is resolved.
template <class Function>
struct ByArithmetic {
  Function *fast, *robust, *doubled, *float64;

  Function* of(const DeviceFiles& files, Precision precision) const {
    return files.float64                     ? float64
           : precision == Precision::fast    ? fast
           : precision == Precision::doubled ? doubled
                                             : robust;
  }
};

// Checks what the host hasn't of a scene that is there (backend.cu); returns the kinds of its primitives.
template <class Stored>
unsigned checked_kinds(const DeviceFilesOf<Stored>& files, const SceneFile& scene);

// A scene and its structure, or none yet, brought to a device, where complete(DeviceFilesOf, Transfer) checks
// them and makes what is traced; returns the kinds of primitives. What it takes meanwhile is given back.
template <class Complete>
std::shared_ptr<const DeviceFiles> files_on(int device, const SceneFile& scene,
                                            const StructureFile* structure, const Complete& complete) {
  const DeviceScope scope(device);
  const auto memory = std::make_shared<DeviceMemory>(device);
  auto files = std::make_shared<DeviceFiles>(memory);
  const auto make = [&]<class Stored>(std::optional<DeviceFilesOf<Stored>>& stored) {
    Transfer upload(memory->pool);
    stored.emplace(scene, structure, memory->pool, upload);
    upload.run();
    files->kinds = complete(*stored, upload);
  };
  scene.is_float64() ? make(files->float64) : make(files->float32);
  memory->pool.trim();
  return files;
}

} // namespace masu
