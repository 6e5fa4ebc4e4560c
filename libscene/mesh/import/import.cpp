#include "libscene/mesh/import/import.h"

#include "libscene/base/error.h"
#include "libscene/file/input_file.h"
#include "libscene/file/scene_file.h"
#include "libscene/mesh/files/text_lines.h"
#include "libscene/mesh/import/assimp_scene.h"

#include <assimp/DefaultIOSystem.h>
#include <assimp/config.h>
#include <assimp/scene.h>

#include <assimp/Importer.hpp>
#include <assimp/ProgressHandler.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstring>
#include <filesystem>
#include <memory>
#include <optional>
#include <string_view>

namespace masu {
namespace {

// --- Assimp's scene as a mesh's file ---------------------------------------------------------------------

std::string name_of(const aiNode& node, const aiMesh& mesh) {
  const std::string_view of_node = node.mName.C_Str(), own = mesh.mName.C_Str();
  return own.empty() || own == of_node ? std::string(of_node) : fmt::format("{}/{}", of_node, own);
}

// The mesh's faces, as an object without a place. `normals`, `colors`: whether they are taken of vertices.
// Throws where a face's corner isn't among its vertices.
MeshObject add_mesh(const aiMesh& mesh, bool normals, bool colors, std::uint64_t& points_and_lines,
                    const std::string& name, MeshFile& result) {
  const std::size_t first = result.positions.size();
  if (mesh.mNumVertices > no_index - first)
    throw Error(ErrorCode::input, name, "has more than 2^32 - 1 vertices: split the file");
  MeshObject object{.material = mesh.mMaterialIndex,
                    .has_normals = mesh.HasNormals(),
                    .has_colors = mesh.HasVertexColors(0),
                    .first_face = result.face_sizes.size(),
                    .first_corner = result.corners.size()};
  for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
    result.positions.push_back(import::vector_of(mesh.mVertices[v]));
    if (normals) result.normals.push_back(mesh.HasNormals() ? import::vector_of(mesh.mNormals[v]) : Vec3d{});
    if (!colors) continue;
    const aiColor4D color = mesh.HasVertexColors(0) ? mesh.mColors[0][v] : aiColor4D{};
    result.colors.push_back({color.r, color.g, color.b});
  }
  for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
    const aiFace& face = mesh.mFaces[f];
    const std::span<const unsigned> indices(face.mIndices, face.mNumIndices);
    for (const unsigned index : indices)
      if (index >= mesh.mNumVertices)
        throw Error(ErrorCode::input, name,
                    fmt::format("face {} of mesh '{}' has vertex {} of {}: repair the file", f,
                                excerpt(mesh.mName.C_Str()), index, mesh.mNumVertices));
    if (indices.size() < 3) {
      ++points_and_lines;
      continue;
    }
    for (const unsigned index : indices)
      result.corners.push_back(static_cast<std::uint32_t>(first) + index);
    result.face_sizes.push_back(face.mNumIndices);
  }
  object.faces = result.face_sizes.size() - object.first_face;
  object.corners = result.corners.size() - object.first_corner;
  return object;
}

// Nodes that name meshes, without recursion, for trees may be deep. Nodes of a file can be shared, and so
// more than its bytes: Assimp has copied each.
void add_instances(const aiScene& file, const std::vector<MeshObject>& meshes,
                   const std::vector<std::uint64_t>& points_and_lines, const std::string& name,
                   MeshFile& result) {
  struct Step {
    const aiNode* node;
    Transform transform; // of its parent
  };
  std::vector<Step> pending{{file.mRootNode, {}}};
  while (!pending.empty()) {
    const auto [node, parent] = pending.back();
    pending.pop_back();
    if (node == nullptr) throw Error(ErrorCode::input, name, "has a node that isn't there: repair the file");
    const Transform transform = parent * import::transform_of(node->mTransformation);
    for (unsigned i = 0; i < node->mNumMeshes; ++i) {
      const unsigned mesh = node->mMeshes[i];
      if (mesh >= file.mNumMeshes)
        throw Error(ErrorCode::input, name,
                    fmt::format("node '{}' names a mesh that doesn't exist: repair the file",
                                excerpt(node->mName.C_Str())));
      result.notes.points_and_lines += points_and_lines[mesh];
      if (meshes[mesh].faces == 0) continue;
      MeshObject& object = result.objects.emplace_back(meshes[mesh]);
      object.name = name_of(*node, *file.mMeshes[mesh]);
      object.transform = transform;
    }
    for (unsigned i = node->mNumChildren; i > 0; --i)
      pending.push_back({node->mChildren[i - 1], transform});
  }
}

MeshFile mesh_file_of(const aiScene& file, const std::string& name, bool smooth) {
  MeshFile result;
  bool colors = false;
  for (unsigned i = 0; i < file.mNumMeshes; ++i)
    colors |= file.mMeshes[i]->HasVertexColors(0);
  for (unsigned i = 0; i < file.mNumMaterials; ++i) {
    result.materials.push_back(import::imported_material(*file.mMaterials[i]));
    result.notes.textured_materials += import::has_textures(*file.mMaterials[i]) ? 1 : 0;
  }
  std::vector<MeshObject> meshes;
  std::vector<std::uint64_t> points_and_lines(file.mNumMeshes);
  for (unsigned i = 0; i < file.mNumMeshes; ++i) {
    if (file.mMeshes[i]->mMaterialIndex >= file.mNumMaterials)
      throw Error(ErrorCode::input, name,
                  fmt::format("mesh '{}' has a material that doesn't exist: repair the file",
                              excerpt(file.mMeshes[i]->mName.C_Str())));
    meshes.push_back(add_mesh(*file.mMeshes[i], smooth, colors, points_and_lines[i], name, result));
  }
  if (file.mRootNode != nullptr) add_instances(file, meshes, points_and_lines, name, result);
  return result;
}

// By how much coordinates in that box were rounded to float32, where that is more than 1e-5 of its extent.
double float32_error(const Boxd& box) {
  const double error = largest_magnitude(box) * RealTraits<float>::unit_roundoff;
  return error > 1e-5 * largest_magnitude(box.max - box.min) ? error : 0;
}

// --- Reading through Assimp ------------------------------------------------------------------------------

// Without any of Assimp's processing steps: it would triangulate, join and reorder differently.
constexpr unsigned no_steps = 0;

class Progress final : public Assimp::ProgressHandler {
public:
  explicit Progress(const std::function<void(double)>& progress) : progress_(progress) {}
  bool Update(float share) override {
    if (share >= 0) progress_(static_cast<double>(std::min(share, 1.0F)));
    return true; // goes on
  }

private:
  const std::function<void(double)>& progress_;
};

// A file can name any other, as its materials, say: pipes and devices could be read for ever.
class RegularFiles final : public Assimp::DefaultIOSystem {
public:
  RegularFiles(std::string mesh, const std::function<void(const std::string&)>& opened, bool& opens_others)
      : mesh_(std::move(mesh)), opened_(opened), opens_others_(opens_others) {}
  bool Exists(const char* path) const override {
    std::error_code unknown;
    return std::filesystem::is_regular_file(path, unknown);
  }
  Assimp::IOStream* Open(const char* path, const char* mode) override {
    if (!Exists(path)) return nullptr;
    if (opened_) opened_(path);
    opens_others_ |= path != mesh_;
    return DefaultIOSystem::Open(path, mode);
  }

private:
  std::string mesh_;
  const std::function<void(const std::string&)>& opened_;
  bool& opens_others_;
};

// Assimp's message as one line: its beginning, for it may repeat what was read. Of other files that the mesh
// names nothing is repeated: those may be anybody's. (glTF's have numbers alone, which no message has.)
[[noreturn]] void fail(const Assimp::Importer& importer, bool opens_others, const std::string& name) {
  constexpr std::size_t longest = 200;
  std::string message = importer.GetErrorString();
  if (message == "std::bad_alloc")
    message = "reading it needs more memory than it may take: repair or split the file";
  else if (opens_others && !name.ends_with(".gltf"))
    message = "can't be read, or a file that it names can't: repair them";
  for (char& c : message)
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  while (!message.empty() && message.back() == ' ')
    message.pop_back();
  if (message.empty()) message = "can't be read: give a mesh in a format that Assimp reads";
  throw Error(ErrorCode::input, name, excerpt(message, longest));
}

// What `read` makes of the importer, as a scene.
template <class Read>
ImportedScene imported_by(const std::string& name, const ImportOptions& options, const Read& read) {
  Assimp::Importer importer;
  bool opens_others = false;
  importer.SetIOHandler( // owned by it
      std::make_unique<RegularFiles>(name, options.opened, opens_others).release());
  importer.SetPropertyBool(AI_CONFIG_IMPORT_NO_SKELETON_MESHES, true);
  if (options.progress)
    importer.SetProgressHandler(std::make_unique<Progress>(options.progress).release()); // owned by it
  const aiScene* const file = read(importer);
  if (options.parsed) options.parsed();
  if (file == nullptr) fail(importer, opens_others, name);
  ImportedScene result = scene_of(mesh_file_of(*file, name, options.smooth), name, options);
  // A glTF file has no more digits itself.
  if (!import::is_format(*file, "glTF")) result.notes.float32_error = float32_error(bounds(result.scene));
  import::import_view(*file, options, result);
  return result;
}

// --- What a glTF file can't be read without -----------------------------------------------------------

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

// Throws Error(input, name, …) for a glTF 2.0 file, as text or binary, that requires an extension which isn't
// understood, as the specification (3.12) demands; Assimp reads on, and gets another shape. Files of other
// formats pass, and invalid ones.
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

// --- Our own readers, and Assimp for all else --------------------------------------------------------------

// The mesh, if it isn't one for Assimp.
std::optional<MeshFile> parsed_mesh(const std::string& path, const ImportOptions& options) {
  const std::filesystem::path parts(path);
  const std::string extension = extension_of(parts);
  const HostBytes bytes = InputFile(path).contents();
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  std::optional<MeshFormat> format = format_of_name(extension);
  if (!format && (extension.empty() || !Assimp::Importer().IsExtensionSupported("." + extension)))
    format = format_of_content(text);
  if (format) return read_mesh_file(bytes, *format, parts.parent_path(), path, options);
  check_gltf_extensions(text, path);
  return {};
}

} // namespace

ImportedScene read_mesh(const std::string& path, const ImportOptions& options) {
  if (options.opened) options.opened(path);
  if (const std::optional<MeshFile> mesh = parsed_mesh(path, options))
    return viewed_scene_of(*mesh, path, options);
  return imported_by(path, options,
                     [&](Assimp::Importer& importer) { return importer.ReadFile(path, no_steps); });
}

} // namespace masu
