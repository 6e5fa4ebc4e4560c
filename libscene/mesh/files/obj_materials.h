// The materials of an OBJ, and the files that it takes them from (MTL).
#pragma once

#include "libscene/mesh/files/file_material.h"
#include "libscene/mesh/files/mesh_file.h"

#include <unordered_map>

namespace masu {

class ObjMaterials {
public:
  // The number of the material of that name: a grey one, until a file says more.
  std::uint32_t number_of(const std::string& name);
  // Reads a file of materials. Errors repeat nothing of it: an OBJ may name any file. Throws
  // Error(input, name:line, …).
  void read(std::string_view text, const std::string& name);
  // All, in the order of their numbers; adds those with textures to the notes.
  std::vector<FileMaterial> all(ImportNotes& notes) const;

private:
  // What MTL says. Ke and Ka aren't used: nothing glows, and all have the same ambient light.
  struct Description {
    PhongSurface surface{.color = {0.6F, 0.6F, 0.6F}};
    Vec3f specular{0, 0, 0};
    std::int64_t illumination = 1;
    std::optional<float> metalness{}, roughness{};
    bool has_textures = false;

    Material material() const;
  };
  std::vector<Description> descriptions_;
  std::unordered_map<std::string, std::uint32_t> numbers_;
};

} // namespace masu
