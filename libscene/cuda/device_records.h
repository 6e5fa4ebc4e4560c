// Records of a file, or of the host's memory, on a CUDA device. CUDA sources only.
#pragma once

#include "libscene/cuda/transfer.h"

namespace masu {

// Adds the upload of `count` records, which point to the device's from now on; `room` more follow them, all
// zero.
template <class T>
DeviceArray<T> uploaded(const T*& records, std::uint64_t count, Transfer& upload, std::size_t room = 0) {
  DeviceArray<T> array = upload.room_for<T>(count, room);
  upload.to_device(array.data(), records, count * sizeof(T));
  records = array.data();
  return array;
}
// The same of a file's section, which isn't in memory where `records` are null.
template <class T, class File, class Section>
DeviceArray<T> uploaded(const File& file, Section section, const T*& records, std::uint64_t count,
                        Transfer& upload, std::size_t room = 0) {
  if (records != nullptr || count == 0) return uploaded(records, count, upload, room);
  DeviceArray<T> array = upload.room_for<T>(count, room);
  upload.to_device(array.data(), file.template reader<T>(section));
  records = array.data();
  return array;
}

} // namespace masu
