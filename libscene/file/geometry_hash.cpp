#include "libscene/file/scene_file.h"

namespace masu {

Hash geometry_hash(std::span<const fb::Section> sections, const fb::Box& bounds, const fb::Vec3& origin) {
  using fb::SceneSection;
  struct Entry {
    std::uint32_t kind = 0, record_bytes = 0;
    std::uint64_t count = 0;
    fb::Hash hash;
  };
  static_assert(sizeof(fb::Box) == 48 && sizeof(Entry) == 32); // without gaps
  std::vector<std::uint8_t> bytes;
  const auto append = [&](const auto& record) {
    const auto* const begin = reinterpret_cast<const std::uint8_t*>(&record);
    bytes.insert(bytes.end(), begin, begin + sizeof record);
  };
  append(bounds);
  if (!(vector_of(origin) == Vec3d{0, 0, 0})) append(origin);
  for (const fb::Section& s : sections) {
    const auto kind = static_cast<SceneSection>(s.kind());
    if (kind == SceneSection::triangles || kind == SceneSection::spheres || kind == SceneSection::cones)
      append(Entry{s.kind(), s.record_bytes(), s.count(), s.hash()});
  }
  return hash_of(bytes);
}

} // namespace masu
