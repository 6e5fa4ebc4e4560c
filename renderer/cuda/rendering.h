// Pictures on a CUDA device: the kernels, and how they are launched. CUDA sources only.
//
// Kernels of float32 and of double arithmetic are compiled in a source each (render_*.cu), which instantiates
// render_on_device(): so they are compiled at the same time.
#pragma once

#include "libscene/base/stopwatch.h"
#include "renderer/cuda/ray_batch.h"
#include "renderer/render_pixel.h"

namespace masu {

template <class M, class Stored, class Structure, class C>
__global__ void __launch_bounds__(tile_side* tile_side, resident_threads_wanted<M> / (tile_side * tile_side))
    render_kernel(const SceneView<Stored> scene, const Lighting<Stored> lighting, const Structure structure,
                  const CameraRays<typename M::Real> rays, const RenderRules rules, Vec3f* const colors,
                  HitRecord* const hits, Counts* const total, const RayCosts costs,
                  const std::int32_t counted_rows) {
  const auto column = static_cast<std::int32_t>(blockIdx.x * tile_side + threadIdx.x);
  const auto row = static_cast<std::int32_t>(blockIdx.y * tile_side + threadIdx.y);
  if (column >= rays.columns || row >= rays.rows) return;
  C counts;
  HitRecord hit{};
  const std::size_t index = static_cast<std::size_t>(row) * static_cast<std::size_t>(rays.columns) +
                            static_cast<std::size_t>(column);
  const Vec3f light =
      radiance<M>(scene, lighting, structure, rules, camera_ray(rays, column, row), hit, counts);
  if (colors != nullptr) colors[index] = light;
  if (hits != nullptr) hits[index] = hit;
  write_costs(costs, index, counts);
  if (row < counted_rows) add(total, counts);
}

// Of camera rays that were traced.
template <class Real, class Stored>
void launch_attributes(const SceneView<Stored>& scene, const CameraRays<Real>& rays,
                       const DeviceArray<HitRecord>& found, const RayResults& results, cudaStream_t stream) {
  const HitRecord* const hits = found.data();
  for_each_on_device(found.size(), stream, [=] __device__(std::uint64_t i) {
    const auto columns = static_cast<std::uint64_t>(rays.columns);
    const Ray<Real> ray =
        camera_ray(rays, static_cast<std::int32_t>(i % columns), static_cast<std::int32_t>(i / columns));
    write_attributes(scene, NoStructure{}, ray, {hits[i].t, static_cast<PrimitiveIndex>(hits[i].name)},
                     results, i);
  });
}
// Traces a picture with rays of this arithmetic. Throws Error(device).
template <class TestRay, class Stored>
void render_on_device(const DeviceFiles& device_files, const FrameRequest& request, FrameBuffers& buffers,
                      Frame& frame) {
  const DeviceFilesOf<Stored>& files = device_files.of<Stored>();
  const cudaStream_t stream = buffers.stream;
  const StreamMemory memory{stream, files.memory.pool};
  const std::size_t ray_count =
      static_cast<std::size_t>(frame.columns) * static_cast<std::size_t>(frame.rows);
  const DeviceArray<Vec3f> colors(request.shaded ? ray_count : 0, memory);
  const DeviceArray<std::uint8_t> rgb(frame.rgb.size(), memory);
  const DeviceArray<HitRecord> hits(frame.hits.size(), memory);
  const DeviceArray<std::int32_t> objects(frame.objects.size(), memory);
  const DeviceArray<Vec3f> normals(frame.normals.size(), memory);
  const DeviceArray<std::uint32_t> cells(frame.cells.size(), memory), tests(frame.tests.size(), memory);
  const DeviceArray<Counts> total(&frame.counts, is_counted(files.structure.records, request.tracing) ? 1 : 0,
                                  memory);
  with_method<TestRay, Stored>(
      files.structure.records, request.tracing, [&]<class M, class C>(const auto& view, M, C) {
        const auto structure = files.on_device(view);
        const auto rays =
            camera_rays<typename M::Real>(request.camera, request.sampling, request.hither, request.window);
        const auto tiles = [](std::int32_t side) {
          return static_cast<unsigned>((side + tile_side - 1) / tile_side);
        };
        auto* const kernel = render_kernel<OnDevice<M>, Stored, std::decay_t<decltype(structure)>, C>;
        frame.kernel = load(kernel);
        const DeviceTimer timer(stream);
        launch(kernel, dim3(tiles(frame.columns), tiles(frame.rows)), dim3(tile_side, tile_side), stream,
               files.scene.view, files.scene.lighting, structure, rays, request.rules, colors.data(),
               hits.data(), total.data(), RayCosts{cells.data(), tests.data()},
               frame.rows - (request.count_last_row ? 0 : 1));
        if (request.rgb) launch_bytes(colors.data(), frame.columns, request.sampling, rgb, stream);
        if (request.attributes)
          launch_attributes(files.scene.view, rays, hits, attribute_results(objects.data(), normals.data()),
                            stream);
        frame.seconds.trace = timer.seconds();
      });
  const Stopwatch watch;
  const auto download = [&](const auto& array, auto& to) {
    const std::size_t bytes = array.size() * sizeof(*array.data());
    if (bytes == 0) return;
    std::uint8_t* const staging = buffers.staging.of(bytes);
    check(cudaMemcpyAsync(staging, array.data(), bytes, cudaMemcpyDeviceToHost, stream));
    check(cudaStreamSynchronize(stream));
    copy_in_parallel(to.data(), staging, bytes);
  };
  if (request.rgb)
    download(rgb, frame.rgb);
  else
    download(colors, frame.radiance);
  download(hits, frame.hits);
  download(objects, frame.objects);
  download(normals, frame.normals);
  download(cells, frame.cells);
  download(tests, frame.tests);
  total.download(&frame.counts);
  frame.seconds.download = watch.seconds();
}

} // namespace masu
