// One source for both stores: lambdas of passes that are the same for both must not be compiled twice.
#include "libgrid/grid/merge_passes.h"
#include "libgrid/hierarchy/binary/spatial_split_passes.h"
#include "libgrid/hierarchy/binary/top_down_passes.h"
#include "libgrid/hierarchy/device_hierarchy.h"
#include "libgrid/hierarchy/hierarchy_builder.h"
#include "libgrid/hierarchy/leaf_passes.h"
#include "libgrid/hierarchy/refit_passes.h"
#include "libgrid/structure/builder.h"
#include "libscene/base/stopwatch.h"
#include "libscene/cuda/cuda_device.h"
#include "libscene/cuda/transfer.h"
#include "libscene/geometry/margin.h"
#include "libscene/mesh/device_triangles.h"
#include "libscene/mesh/move_passes.h"
#include "libscene/passes/cuda_executor.h"

#include <chrono>
#include <future>
#include <vector>

namespace masu {
namespace {

// A scene whose primitives are on the device, and nothing else of it; triangles of `unmade` where that isn't
// null.
template <class Stored>
struct UploadedScene {
  SceneView<Stored> view;
  Transfer upload;
  DeviceArray<Triangle<Stored>> triangles;
  DeviceArray<Sphere<Stored>> spheres;
  DeviceArray<Cone<Stored>> cones;

  UploadedScene(const SceneView<Stored>& host, cudaMemPool_t pool, const UnmadeTriangles* unmade = nullptr)
      : view(host), upload(pool),
        triangles(unmade != nullptr ? made_on_device<Stored>(*unmade->meshes, unmade->origin, upload)
                                    : uploaded(view.triangles, view.triangle_count, upload)),
        spheres(uploaded(view.spheres, view.sphere_count, upload)),
        cones(uploaded(view.cones, view.cone_count, upload)) {
    upload.run();
    view.triangles = triangles.data();
  }
};

// Calls act(), whose device is the GPU whatever the caller's is; where the caller hasn't yet looked at an
// error of its own, which CUB would take for act's, in another thread. The caller reports while it waits.
template <class Act>
auto on_gpu(int gpu, const ProgressMonitor* progress, const Act& act) {
  const DeviceScope scope(gpu);
  if (cudaPeekAtLastError() == cudaSuccess) return act();
  auto end = std::async(std::launch::async, [&] {
    check(cudaSetDevice(gpu));
    return act();
  });
  while (end.wait_for(std::chrono::milliseconds(50)) != std::future_status::ready)
    check_progress(progress);
  return end.get();
}

template <class Stored>
ExecutorStructure<CudaExecutor> hierarchy(CudaExecutor& executor, const SceneView<Stored>& scene,
                                          const GridLayout& layout, HierarchyQuality quality) {
  auto made = hierarchy_leaves(executor, scene, layout);
  return collapsed_hierarchy(
      executor, layout,
      quality == HierarchyQuality::fast
          ? top_down_hierarchy(executor, std::move(made), triangles_of(scene), layout.space)
          : spatial_split_hierarchy(executor, scene, layout.margin, std::move(made.leaves)));
}

template <class Stored>
class CudaBuilder final : public StructureBuilder<Stored> {
public:
  CudaBuilder(const SceneView<Stored>& scene, int gpu, std::function<void(double)> progress, bool is_timed,
              const UnmadeTriangles* unmade)
      : StructureBuilder<Stored>(scene, std::move(progress)), gpu_(gpu) {
    std::string why;
    if (!cuda_available(why)) throw Error(ErrorCode::device, "cuda", why + ": build on the CPU");
    on_gpu(gpu_, &this->progress(), [&] {
      const Stopwatch watch;
      pool_ = std::make_unique<MemoryPool>();
      executor_ = std::make_unique<CudaExecutor>(*pool_, &this->progress());
      if (is_timed) warm_up();
      seconds_.set_up = watch.seconds();
      device_ = std::make_unique<UploadedScene<Stored>>(scene, *pool_, unmade);
      seconds_.upload = watch.seconds() - seconds_.set_up;
    });
  }
  ~CudaBuilder() override {
    on_device_if_possible(gpu_, [&] {
      executor_.reset();
      device_.reset();
    });
  }
  CudaBuilder(const CudaBuilder&) = delete;
  CudaBuilder& operator=(const CudaBuilder&) = delete;

  Structure try_build(const GridLayout& layout, Overlap overlap, const StructureOptions& options) override {
    return on_gpu(gpu_, &this->progress(), [&] {
      if (options.kind == StructureKind::hierarchy)
        check_hierarchy(this->scene().primitive_count(), layout.space);
      const SceneView<Stored>& scene = device_->view;
      const DeviceTimer timer;
      const ExecutorStructure<CudaExecutor> grid =
          options.kind == StructureKind::hierarchy ? hierarchy(*executor_, scene, layout, options.quality)
          : options.kind == StructureKind::uniform
              ? uniform_grid(*executor_, scene, layout, overlap, options.max_references,
                             options.max_map_words)
              : merged_grid(*executor_, scene, layout, overlap, options);
      seconds_.build += timer.seconds();
      return downloaded(grid);
    });
  }

  DeviceSeconds device_seconds() const override { return seconds_; }

private:
  // Code is brought to the device when it is first called: this isn't timed.
  void warm_up() {
    // One that is worth dividing, among so many that their hierarchy's root is more than a chunk.
    const auto triangle = [](Stored at, Stored size) {
      return Triangle<Stored>{{at, at, at}, 0, {at + size, at, at}, 0, {at, at + size, at + size},
                              no_normals};
    };
    std::vector<Triangle<Stored>> triangles{triangle(0, 1)};
    constexpr auto small = Stored{1} / most_in_chunk;
    for (std::uint32_t i = 0; i < most_in_chunk; ++i)
      triangles.push_back(triangle(static_cast<Stored>(i) * small, small));
    SceneView<Stored> scene{};
    scene.triangles = triangles.data();
    scene.triangle_count = static_cast<std::uint32_t>(triangles.size());
    const UploadedScene<Stored> uploaded(scene, *pool_);
    const GridLayout layout{{{0, 0, 0}, {1, 1, 1}}, {2, 2, 2}, 0};
    uniform_grid(*executor_, uploaded.view, layout, Overlap::exact);
    merged_grid(*executor_, uploaded.view, layout, Overlap::exact, {StructureKind::irregular});
    for (const HierarchyQuality quality : {HierarchyQuality::high, HierarchyQuality::fast})
      hierarchy(*executor_, uploaded.view, layout, quality);
    check(cudaDeviceSynchronize());
  }

  Structure downloaded(const ExecutorStructure<CudaExecutor>& grid) {
    const Stopwatch watch;
    Structure copy{grid.layout, grid.kind, grid.block_log2, grid.nested_log2, {}, {},
                   {},          {},        grid.detail,     grid.exceeded};
    if (copy.exceeded != nullptr) return copy;
    Transfer& transfer = device_->upload;
    const auto fetch = [&](const auto& from, auto& to) {
      to.resize(from.size());
      transfer.to_host(to.data(), from.data(), from.size() * sizeof(to[0]));
    };
    fetch(grid.voxel_map, copy.voxel_map);
    fetch(grid.cells, copy.cells);
    fetch(grid.references, copy.references);
    fetch(grid.nodes, copy.nodes);
    transfer.run();
    seconds_.download += watch.seconds();
    return copy;
  }

  int gpu_;
  std::unique_ptr<MemoryPool> pool_;
  std::unique_ptr<UploadedScene<Stored>> device_;
  std::unique_ptr<CudaExecutor> executor_;
  DeviceSeconds seconds_;
};

} // namespace

template <class Stored>
StructureIn<CudaMemory> fast_hierarchy(const SceneView<Stored>& scene, const GridLayout& layout,
                                       cudaMemPool_t pool, int gpu, const ProgressMonitor* progress) {
  check_hierarchy(scene.primitive_count(), layout.space);
  return on_gpu(gpu, progress, [&] {
    CudaExecutor executor(pool, progress);
    ExecutorStructure<CudaExecutor> built = hierarchy(executor, scene, layout, HierarchyQuality::fast);
    check(cudaStreamSynchronize(nullptr));
    return built;
  });
}
template StructureIn<CudaMemory> fast_hierarchy(const SceneView<float>&, const GridLayout&, cudaMemPool_t,
                                                int, const ProgressMonitor*);
template StructureIn<CudaMemory> fast_hierarchy(const SceneView<double>&, const GridLayout&, cudaMemPool_t,
                                                int, const ProgressMonitor*);

template <class Stored, class Number>
MovedHierarchy<Stored> moved_hierarchy(const SceneView<Stored>& scene, const StructureRecords& hierarchy,
                                       const WorldVertices<Number>& vertices, cudaMemPool_t pool, int gpu) {
  return on_gpu(gpu, nullptr, [&] {
    CudaExecutor executor(pool);
    auto moved = moved_triangles(executor, scene, vertices, hierarchy.references, hierarchy.reference_count,
                                 max_hierarchy_reach);
    MovedHierarchy<Stored> found{std::move(moved.triangles), {}, moved.bounds};
    if (moved.is_missing) return found;
    found.nodes = executor.template array<HierarchyNode>(hierarchy.node_count);
    check(cudaMemcpyAsync(found.nodes.data(), hierarchy.nodes, hierarchy.node_count * sizeof(HierarchyNode),
                          cudaMemcpyDeviceToDevice, nullptr));
    SceneView<Stored> view = scene;
    view.triangles = found.triangles.data();
    refit(executor, view, is_empty(moved.bounds) ? 0 : rounding_margin<Stored>(moved.bounds), found.nodes,
          hierarchy.references, hierarchy.reference_count);
    check(cudaStreamSynchronize(nullptr));
    return found;
  });
}
template MovedHierarchy<float> moved_hierarchy(const SceneView<float>&, const StructureRecords&,
                                               const WorldVertices<float>&, cudaMemPool_t, int);
template MovedHierarchy<float> moved_hierarchy(const SceneView<float>&, const StructureRecords&,
                                               const WorldVertices<double>&, cudaMemPool_t, int);
template MovedHierarchy<double> moved_hierarchy(const SceneView<double>&, const StructureRecords&,
                                                const WorldVertices<float>&, cudaMemPool_t, int);
template MovedHierarchy<double> moved_hierarchy(const SceneView<double>&, const StructureRecords&,
                                                const WorldVertices<double>&, cudaMemPool_t, int);

template <class Stored>
std::unique_ptr<StructureBuilder<Stored>> cuda_builder(const SceneView<Stored>& scene, int device,
                                                       std::function<void(double)> progress, bool is_timed,
                                                       const UnmadeTriangles* unmade) {
  return std::make_unique<CudaBuilder<Stored>>(scene, device, std::move(progress), is_timed, unmade);
}
template std::unique_ptr<StructureBuilder<float>>
cuda_builder(const SceneView<float>&, int, std::function<void(double)>, bool, const UnmadeTriangles*);
template std::unique_ptr<StructureBuilder<double>>
cuda_builder(const SceneView<double>&, int, std::function<void(double)>, bool, const UnmadeTriangles*);

} // namespace masu
