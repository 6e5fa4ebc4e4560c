// A tracer's files on a CUDA device, and queries of rays in its memory. CUDA sources only.
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
  struct Borrowed {
    Pool& pool;
    std::unique_ptr<T> taken;
    T* operator->() const { return taken.get(); }
    T& operator*() const { return *taken; }
    ~Borrowed() { pool.give_back(std::move(taken)); }
  };
  Borrowed borrow() { return {*this, take()}; }

  // None is borrowed.
  void clear() { free_.clear(); }

private:
  std::unique_ptr<T> take() {
    const std::lock_guard lock(mutex_);
    if (free_.empty()) {
      free_.reserve(++made_); // so that giving back can't fail
      return std::make_unique<T>();
    }
    std::unique_ptr<T> taken = std::move(free_.back());
    free_.pop_back();
    return taken;
  }
  void give_back(std::unique_ptr<T> taken) {
    const std::lock_guard lock(mutex_);
    free_.push_back(std::move(taken));
  }

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
  DeviceArray<std::uint32_t> indices; // of moved vertices (Tracer::moved)

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

// A scene and its grid, of either store: one of them.
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

  template <class Stored>
  const DeviceFilesOf<Stored>& of() const {
    if constexpr (std::is_same_v<Stored, float>)
      return *float32;
    else
      return *float64;
  }
};

// A list of rays in device memory, in the arithmetic's numbers, on its way through a stream.
template <class Real>
struct RayBatch {
  const Ray<Real>* rays;
  std::uint64_t count;
  RayResults results; // nearest_hit: t and primitive are there if there are attributes to find
  Counts* counts;     // null: not counted
  Queue queue;
  cudaEvent_t begun; // recorded before the first kernel; may be null

  void begin() const {
    if (begun != nullptr) check(cudaEventRecord(begun, queue.stream));
  }
};

// For each arithmetic and store: render_float.cu, rays_float.cu, …. Throw Error(device).
template <class TestRay, class Stored>
void render_on_device(const DeviceFilesOf<Stored>& files, const SceneView<Stored>& host_scene,
                      const StructureFile* host_grid, const FrameRequest& request, FrameBuffers& buffers,
                      Frame& frame);
// The picture's pixels of the radiance along all its rays.
void queue_bytes(const Vec3f* radiance, std::int32_t columns, Sampling sampling,
                 const DeviceArray<std::uint8_t>& rgb, cudaStream_t stream);
// Of camera rays that were traced.
template <class Real, class Stored>
void queue_attributes(const SceneView<Stored>& scene, const CameraRays<Real>& rays,
                      const DeviceArray<HitRecord>& found, const RayResults& results, cudaStream_t stream);
template <class TestRay, class Stored>
KernelSize queue_batch(const DeviceFilesOf<Stored>& files, const SceneView<Stored>& host_scene,
                       const StructureFile* host_grid, const RaysRequest& request,
                       const RayBatch<typename TestRay::Real>& batch);
// Hits in order (hit_list.h); not by `fast`.
template <class TestRay, class Stored>
KernelSize queue_hits(const DeviceFilesOf<Stored>& files, const StructureFile* host_grid,
                      const HitRules& rules, const RayFilters& filters,
                      const RayBatch<typename TestRay::Real>& batch);
template <class Real, class Stored>
void queue_attributes(const DeviceFilesOf<Stored>& files, const RayBatch<Real>& batch,
                      const RayResults& results);

// Puts a query of rays in the memory of the files' device, the current one, on a stream. Counts are added to
// `counts` there, where that isn't null. `begun`, where it isn't null, is recorded when memory is there and
// the kernels come. Throws Error(device).
KernelSize queue_rays(const DeviceFiles& files, const SceneFile& scene, const StructureFile* grid,
                      const RayList& rays, const RayResults& results, const RaysRequest& request,
                      Counts* counts, cudaStream_t stream, cudaEvent_t begun = nullptr);

} // namespace masu
