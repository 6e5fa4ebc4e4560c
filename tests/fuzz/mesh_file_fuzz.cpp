// libFuzzer target: any bytes as an OBJ, PLY, OFF or STL are refused by a short Error, or become a scene. The
// first byte selects the format and smooth normals. An OBJ's file of materials is the same text.
#include "libscene/base/error.h"
#include "libscene/mesh/files/mesh_scene.h"

#include <algorithm>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace masu;
  if (size == 0) return 0;
  const std::string name = "fuzz";
  const std::string_view text(reinterpret_cast<const char*>(data) + 1, size - 1);
  const auto other_file = [&](const std::string&) { return std::optional(std::string(text)); };
  try {
    const MeshFile file = parse_mesh_file({text, name, other_file}, static_cast<MeshFormat>(data[0] / 2 % 4));
    const bool has_places = std::ranges::all_of(
        file.corners, [&](std::uint32_t corner) { return corner < file.positions.size(); });
    if (!has_places) std::abort();
    const ImportedScene imported = viewed_scene_of(file, name, {.smooth = data[0] % 2 != 0});
    if (imported.scene.triangles.size() < file.face_sizes.size()) std::abort(); // one for each at least
  } catch (const Error& error) {
    constexpr std::size_t longest = 300;
    if (error.text().size() > longest || error.message().find('\n') != std::string::npos) std::abort();
  }
  return 0;
}
