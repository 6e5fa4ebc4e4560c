#include "libscene/mesh/import/gltf_extensions.h"

#include "libscene/base/error.h"
#include "libscene/mesh/files/text_lines.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>

namespace masu::import {
namespace {

// The JSON of a binary glTF file, which begins with twelve bytes and a chunk's length and type; else all.
std::string_view json_of(std::string_view file) {
  constexpr std::size_t header = 20;
  if (!file.starts_with("glTF") || file.size() < header) return file;
  std::uint32_t length = 0;
  std::memcpy(&length, file.data() + 12, sizeof length);
  return file.substr(header, length);
}

// Those that Assimp reads, and those of textures, of which none is used.
constexpr std::array understood{"KHR_lights_punctual",
                                "KHR_materials_ior",
                                "KHR_materials_pbrSpecularGlossiness",
                                "KHR_materials_transmission",
                                "KHR_texture_basisu",
                                "KHR_texture_transform",
                                "EXT_texture_webp"};

} // namespace

void check_gltf_extensions(std::string_view file, const std::string& name) {
  const std::string_view text = json_of(file);
  if (!text.substr(std::min(text.find_first_not_of(" \t\r\n\xef\xbb\xbf"), text.size())).starts_with('{'))
    return;
  constexpr const char* required = "extensionsRequired";
  using Json = nlohmann::json;
  // Nothing else is kept: there may be meshes in it.
  const auto is_kept = [&](int depth, Json::parse_event_t event, const Json& value) {
    return depth != 1 || event != Json::parse_event_t::key || value == required;
  };
  const Json json = Json::parse(text, is_kept, false);
  if (!json.is_object() || !json.contains(required) || !json[required].is_array()) return;
  for (const Json& extension : json[required]) {
    if (!extension.is_string()) continue;
    const auto& wanted = extension.get_ref<const std::string&>();
    if (std::ranges::find(understood, wanted) != understood.end()) continue;
    throw Error(
        ErrorCode::input, name,
        fmt::format("requires the glTF extension {}, which isn't read: convert it to a file without{}",
                    excerpt(wanted, 64), wanted == "KHR_mesh_quantization" ? " (gltfpack -noq)" : ""));
  }
}

} // namespace masu::import
