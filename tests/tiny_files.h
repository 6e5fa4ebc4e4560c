// A file of each kind, of what tiny_scene.h has.
#pragma once

#include "tests/tiny_scene.h"

#include <functional>
#include <ostream>

namespace masu {

struct TinyFile {
  const char* name; // of its golden bytes
  FileKind kind;
  std::function<void(const std::string& path, const Hash& geometry_hash)> write;

  void open(const std::string& path) const {
    if (kind.magic == scene_file_kind.magic)
      const SceneFile file(path);
    else
      const StructureFile file(path);
  }
};
inline void PrintTo(const TinyFile& file, std::ostream* out) {
  *out << file.name;
}

inline std::vector<TinyFile> tiny_files() {
  const auto scene = [](const char* name, Store store) -> TinyFile {
    return {name, scene_file_kind,
            [=](const std::string& path, const Hash&) { write_scene(tiny_scene(), store, path); }};
  };
  const auto grid = [](const char* name, Structure (*made)(), const char* merge_rule) -> TinyFile {
    return {name, structure_file_kind, [=](const std::string& path, const Hash& geometry_hash) {
              write_structure(made(), tiny_grid_provenance(geometry_hash, merge_rule), path);
            }};
  };
  return {scene("scene_float32", Store::float32),
          scene("scene_float64", Store::float64),
          grid("grid", tiny_grid, ""),
          grid("grid_of_blocks", tiny_grid_of_blocks, ""),
          grid("merged_grid", tiny_merged_grid, "irregular"),
          grid("hierarchy", tiny_hierarchy, "")};
}

} // namespace masu
