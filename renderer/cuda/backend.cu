#include "renderer/backend.h"

#include "libgrid/file/structure_checks.h"
#include "libscene/cuda/device_checker.h"
#include "libscene/file/scene_checks.h"
#include "renderer/cuda/ray_batch.h"
#include "renderer/image/pixel.h"

namespace masu {

void set_up_cuda(int device) {
  std::string why;
  if (!cuda_available(why)) throw Error(ErrorCode::device, "cuda", why + ": use --backend cpu");
  const DeviceScope scope(device);
  check(cudaFree(nullptr)); // makes a context
}

template <class Stored>
unsigned checked_kinds(const DeviceFilesOf<Stored>& files, const SceneFile& scene) {
  const DeviceChecker checker(files.memory);
  const SceneView<Stored>& view = files.scene.view;
  if (scene.residence() == Residence::file) {
    const char* const fault = fault_of(checker, view, files.scene.lighting, scene.bounds(), scene.counts());
    if (fault != nullptr) throw_damaged(scene.path(), fault);
  }
  const bool has_tapers =
      !checker.all(view.cone_count, [=] __device__(std::uint64_t i) { return !tapers(view.cones[i]); });
  return kinds_in(view, has_tapers);
}
template unsigned checked_kinds(const DeviceFilesOf<float>&, const SceneFile&);
template unsigned checked_kinds(const DeviceFilesOf<double>&, const SceneFile&);

std::shared_ptr<const DeviceFiles> upload_files_cuda(const SceneFile& scene, const StructureFile* structure,
                                                     int device) {
  return files_on(device, scene, structure, [&](auto& files, Transfer& upload) {
    if (structure != nullptr && structure->residence() == Residence::file) {
      const char* const fault = fault_of(DeviceChecker(files.memory), *files.structure.records);
      if (fault != nullptr) throw_damaged(structure->path(), fault);
    }
    if (files.is_hierarchy()) files.upload_leaves(scene, upload);
    return checked_kinds(files, scene);
  });
}

unsigned kinds_on(const DeviceFiles& files) {
  return files.kinds;
}

void render_cuda(const DeviceFiles& files, const FrameRequest& request, Frame& frame) {
  const DeviceScope device(files.memory->device);
  const auto buffers = files.memory->frames.borrow();
  constexpr ByArithmetic render{
      render_on_device<TextbookRay, float>, render_on_device<WatertightRay<float>, float>,
      render_on_device<WatertightRay<double>, float>, render_on_device<WatertightRay<double>, double>};
  render.of(files, request.tracing.precision)(files, request, *buffers, frame);
}

void launch_bytes(const Vec3f* radiance, std::int32_t columns, Sampling sampling,
                  const DeviceArray<std::uint8_t>& rgb, cudaStream_t stream) {
  std::uint8_t* const bytes = rgb.data();
  for_each_on_device(rgb.size() / 3, stream, [=] __device__(std::uint64_t i) {
    const auto width = static_cast<std::uint64_t>(columns - rays_beyond_pixels(sampling));
    const Vec3f* const top = radiance + i / width * static_cast<std::uint64_t>(columns) + i % width;
    const Vec3f pixel = pixel_at(top, columns, sampling);
    for (int channel = 0; channel < 3; ++channel)
      bytes[3 * i + static_cast<std::uint64_t>(channel)] = byte_of<false>(pixel[channel]);
  });
}

} // namespace masu
