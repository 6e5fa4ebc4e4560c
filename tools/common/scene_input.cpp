#include "tools/common/scene_input.h"

#include "libscene/base/error.h"
#include "libscene/file/scene_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string_view>

namespace masu {

void check_scene_input(const std::string& path) {
  constexpr std::string_view meshes[] = {".3ds", ".3mf", ".blend", ".dae", ".fbx", ".glb", ".gltf", ".lwo",
                                         ".obj", ".off", ".ply",   ".stl", ".x3d", ".ase", ".dxf",  ".ms3d"};
  const std::filesystem::path file(path);
  std::string ending = file.extension().string();
  std::ranges::transform(ending, ending.begin(),
                         [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  const bool is_mesh = std::ranges::find(meshes, ending) != std::end(meshes);
  std::error_code failed;
  if ((!is_mesh && ending != ".nff") || !std::filesystem::is_regular_file(file, failed)) return;
  std::ifstream stream(path, std::ios::binary);
  auto magic = scene_file_kind.magic;
  if (!stream.is_open() || (stream.read(magic.data(), static_cast<std::streamsize>(magic.size())) &&
                            magic == scene_file_kind.magic))
    return;
  throw Error(ErrorCode::input, path,
              fmt::format("isn't a scene file but {}: convert it first: {} {} -o {}",
                          is_mesh ? "a mesh" : "NFF text", is_mesh ? "mesh2bin" : "nff2bin", path,
                          std::filesystem::path(file).replace_extension(".scene").string()));
}

} // namespace masu
