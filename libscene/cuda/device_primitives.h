// A file's records, and a scene's primitives, on a CUDA device. CUDA sources only.
#pragma once

#include "libscene/cuda/transfer.h"
#include "libscene/file/scene_file.h"

#include <type_traits>

namespace masu {

// In a file's place: all records are in the host's memory.
struct InHostMemory {};

// Adds the upload of `count` records: out of the host's memory, or where they stay in the file from there.
// `records` points to the device's from now on; `room` more follow them, all zero.
template <class T, class File, class Section>
DeviceArray<T> uploaded(const File& file, Section section, const T*& records, std::uint64_t count,
                        Transfer& upload, std::size_t room = 0) {
  DeviceArray<T> array = upload.room_for<T>(count, room);
  if (records != nullptr) {
    upload.to_device(array.data(), records, count * sizeof(T));
  } else if constexpr (!std::is_same_v<File, InHostMemory>) {
    if (count > 0) upload.to_device(array.data(), file.template reader<T>(section));
  }
  records = array.data();
  return array;
}

template <class Stored>
struct DevicePrimitives {
  DeviceArray<Triangle<Stored>> triangles;
  DeviceArray<Sphere<Stored>> spheres;
  DeviceArray<Cone<Stored>> cones;

  // Those of a view, which then points to them. File: SceneFile or InHostMemory.
  template <class File>
  DevicePrimitives(SceneView<Stored>& view, const File& file, Transfer& upload)
      : triangles(uploaded(file, fb::SceneSection::triangles, view.triangles, view.triangle_count, upload)),
        spheres(uploaded(file, fb::SceneSection::spheres, view.spheres, view.sphere_count, upload)),
        cones(uploaded(file, fb::SceneSection::cones, view.cones, view.cone_count, upload)) {}
};

} // namespace masu
