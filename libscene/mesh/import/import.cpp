#include "libscene/mesh/import/import.h"

#include "libscene/base/available_memory.h"
#include "libscene/base/error.h"
#include "libscene/file/input_file.h"
#include "libscene/material_table.h"
#include "libscene/mesh/import/import_material.h"
#include "libscene/mesh/import/import_normals.h"
#include "libscene/mesh/import/import_ply.h"
#include "libscene/mesh/import/import_transform.h"
#include "libscene/mesh/import/import_view.h"
#include "libscene/mesh/points.h"
#include "libscene/mesh/triangulate.h"

#include <assimp/DefaultIOSystem.h>
#include <assimp/config.h>
#include <assimp/scene.h>

#include <assimp/Importer.hpp>
#include <assimp/ProgressHandler.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <memory>
#include <numeric>
#include <optional>
#include <string_view>

namespace masu {
namespace {

using import::ImportedMaterial;
using import::Transform;

// A node that names a mesh.
struct Instance {
  const aiNode* node;
  unsigned mesh;
  Transform transform;
};

// Without recursion, for trees may be deep. Nodes of a file can be shared, and so more than its bytes: Assimp
// has copied each.
std::vector<Instance> instances_of(const aiScene& file, const std::string& name) {
  std::vector<Instance> instances;
  struct Step {
    const aiNode* node;
    Transform transform; // of its parent
  };
  std::vector<Step> pending{{file.mRootNode, {}}};
  while (!pending.empty()) {
    const auto [node, parent] = pending.back();
    pending.pop_back();
    const Transform transform = parent * import::transform_of(node->mTransformation);
    for (unsigned i = 0; i < node->mNumMeshes; ++i) {
      if (node->mMeshes[i] >= file.mNumMeshes)
        throw Error(
            ErrorCode::input, name,
            fmt::format("node {} names a mesh that doesn't exist: repair the file", node->mName.C_Str()));
      if (file.mMeshes[node->mMeshes[i]]->mNumFaces > 0)
        instances.push_back({node, node->mMeshes[i], transform});
    }
    for (unsigned i = node->mNumChildren; i > 0; --i)
      pending.push_back({node->mChildren[i - 1], transform});
  }
  return instances;
}

// Throws where a face's corner isn't among its mesh's vertices. Returns the number of triangles of its faces.
std::uint64_t count_triangles(const aiMesh& mesh, const std::string& name) {
  std::uint64_t triangles = 0;
  for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
    const aiFace& face = mesh.mFaces[f];
    for (unsigned i = 0; i < face.mNumIndices; ++i)
      if (face.mIndices[i] >= mesh.mNumVertices)
        throw Error(ErrorCode::input, name,
                    fmt::format("face {} of mesh '{}' has vertex {} of {}: repair the file", f,
                                mesh.mName.C_Str(), face.mIndices[i], mesh.mNumVertices));
    if (face.mNumIndices >= 3) triangles += face.mNumIndices - 2;
  }
  return triangles;
}

// Throws where the instances' triangles are too many for a scene or for the memory. Returns their number.
std::uint64_t checked_size(const aiScene& file, const std::vector<Instance>& instances,
                           const ImportOptions& options, const std::string& name) {
  std::vector<std::uint64_t> of_mesh(file.mNumMeshes);
  for (unsigned i = 0; i < file.mNumMeshes; ++i)
    of_mesh[i] = count_triangles(*file.mMeshes[i], name);
  std::uint64_t triangles = 0;
  for (const Instance& instance : instances)
    triangles += of_mesh[instance.mesh]; // at most 2^32 times 2^64 / 2^32 faces that are in memory
  if (instances.size() > max_objects)
    throw Error(ErrorCode::input, name, fmt::format("has more than {} objects: split the file", max_objects));
  if (triangles > options.max_primitives)
    throw Error(ErrorCode::input, name,
                fmt::format("has more than {} triangles: split the file", options.max_primitives));
  const std::uint64_t each = sizeof(SceneTriangle) + sizeof(std::uint32_t) +
                             (options.smooth ? sizeof(CornerNormals<double>) : std::uint64_t{0});
  const double needed = static_cast<double>(triangles) * static_cast<double>(each);
  if (const double available = available_memory(); needed > available)
    throw Error(ErrorCode::input, name,
                fmt::format("its {} triangles, instances expanded, take {:.1f} GB of memory, and {:.1f} are "
                            "available: split the file",
                            triangles, needed / 1e9, available / 1e9));
  return triangles;
}

// The state of an import. Vectors are members to reuse their memory.
struct Importing {
  const aiScene& file;
  bool smooth;
  ImportedScene result;
  MaterialTable materials;
  std::vector<ImportedMaterial> of_file;
  std::vector<std::vector<Vec3d>> generated_normals; // of each mesh, when first needed
  std::vector<Vec3d> corners, normals;               // of a face
  std::vector<unsigned> vertices;                    // the corners' indices
  Triangulation triangulation;
  std::uint32_t face = 0; // its number
};

// The vertices' normals in the mesh's coordinates.
class NormalsOfMesh {
public:
  // STL has the normals of its facets only: they wouldn't smooth anything.
  NormalsOfMesh(Importing& state, unsigned index)
      : mesh_(*state.file.mMeshes[index]), generated_(state.generated_normals[index]) {
    has_own_ = mesh_.HasNormals() && !import::is_format(state.file, "(STL)");
    if (!has_own_ && generated_.empty()) generated_ = import::vertex_normals(mesh_);
  }
  Vec3d operator[](unsigned vertex) const {
    return has_own_ ? import::vector_of(mesh_.mNormals[vertex]) : generated_[vertex];
  }

private:
  const aiMesh& mesh_;
  std::vector<Vec3d>& generated_;
  bool has_own_;
};

// The mean of the corners' colours in steps of 1/63, so that their number is bounded.
Vec3f mean_color(const aiColor4D& a, const aiColor4D& b, const aiColor4D& c) {
  const auto mean = [](float x, float y, float z) {
    const float sum = (x + y + z) / 3;
    return std::round(63 * (sum > 0 ? std::min(sum, 1.0F) : 0.0F)) / 63; // NaN: 0
  };
  return {mean(a.r, b.r, c.r), mean(a.g, b.g, c.g), mean(a.b, b.b, c.b)};
}

Material colored(const ImportedMaterial& of_file, const Vec3f& color) {
  Material material = of_file.material;
  material.color = of_file.multiplies_vertex_colors ? material.color * color : color;
  return material;
}

// Adds a triangle of the face. Numbers of faces are stored once one isn't its triangle's own.
void add_triangle(Importing& state, const SceneTriangle& triangle) {
  Scene& scene = state.result.scene;
  const std::size_t number = scene.triangles.size();
  if (scene.faces.empty() && state.face != number) {
    const std::span<std::uint32_t> before = scene.faces.extend(number);
    std::iota(before.begin(), before.end(), 0U);
  }
  if (state.face != number || !scene.faces.empty()) scene.faces.push_back(state.face);
  scene.triangles.push_back(triangle);
}

// Adds the triangles of the face whose corners, in the scene's coordinates, are state.corners: one that can't
// be hit, where it has no area or no place.
void add_face(Importing& state, const aiMesh& mesh, std::uint32_t object) {
  Scene& scene = state.result.scene;
  const bool has_place = std::all_of(state.corners.begin(), state.corners.end(), is_coordinate);
  if (has_place) triangulate(state.corners, state.triangulation);
  if (!has_place || state.triangulation.triangles.empty()) {
    ++(has_place ? scene.warnings.degenerate_polygons : state.result.notes.invalid_faces);
    const Material& material = state.of_file[mesh.mMaterialIndex].material;
    return add_triangle(state, {{}, object, {}, state.materials.index_of(material), {}, no_normals});
  }
  scene.warnings.degenerate_triangles += state.triangulation.slivers;
  if (state.triangulation.crosses_itself) ++scene.warnings.self_crossing_polygons;
  const ImportedMaterial& material = state.of_file[mesh.mMaterialIndex];
  const aiColor4D* const colors = mesh.mColors[0];
  std::uint32_t index = colors == nullptr ? state.materials.index_of(material.material) : 0;
  for (const auto& [a, b, c] : state.triangulation.triangles) {
    if (colors != nullptr) {
      const auto& v = state.vertices;
      index =
          state.materials.index_of(colored(material, mean_color(colors[v[a]], colors[v[b]], colors[v[c]])));
    }
    const Vec3d &pa = state.corners[a], &pb = state.corners[b], &pc = state.corners[c];
    std::uint64_t normals = no_normals;
    if (state.smooth) {
      normals = scene.normals.size();
      const Vec3d flat = import::unit(cross(pb - pa, pc - pa)).value_or(Vec3d{0, 0, 1});
      const auto normal = [&](std::uint32_t corner) {
        return import::unit(state.normals[corner]).value_or(flat);
      };
      scene.normals.push_back({normal(a), normal(b), normal(c)});
    }
    add_triangle(state, {pa, object, pb, index, pc, normals});
  }
}

void add_instance(Importing& state, const Instance& instance, std::uint32_t object) {
  const aiMesh& mesh = *state.file.mMeshes[instance.mesh];
  const import::NormalTransform of_normals = import::normal_transform(instance.transform);
  std::optional<NormalsOfMesh> normals;
  if (state.smooth) normals.emplace(state, instance.mesh);
  for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
    const aiFace& face = mesh.mFaces[f];
    if (face.mNumIndices < 3) {
      ++state.result.notes.points_and_lines;
      continue;
    }
    state.vertices.assign(face.mIndices, face.mIndices + face.mNumIndices);
    // Mirroring turns fronts into backs.
    if (of_normals.mirrors) std::reverse(state.vertices.begin() + 1, state.vertices.end());
    state.corners.clear();
    for (const unsigned vertex : state.vertices)
      state.corners.push_back(
          import::transformed_point(instance.transform, import::vector_of(mesh.mVertices[vertex])));
    state.normals.clear();
    if (normals)
      for (const unsigned vertex : state.vertices)
        state.normals.push_back(import::transformed_direction(of_normals.cofactors, (*normals)[vertex]));
    add_face(state, mesh, object);
    ++state.face;
  }
  ++(state.smooth ? state.result.scene.objects.patches : state.result.scene.objects.polygons);
  const std::string_view node = instance.node->mName.C_Str(), own = mesh.mName.C_Str();
  state.result.object_names.push_back(own.empty() || own == node ? std::string(node)
                                                                 : fmt::format("{}/{}", node, own));
}

void read_materials(Importing& state, const std::string& name) {
  for (unsigned i = 0; i < state.file.mNumMaterials; ++i) {
    state.of_file.push_back(import::imported_material(*state.file.mMaterials[i]));
    state.result.notes.textured_materials += state.of_file.back().has_textures ? 1 : 0;
  }
  for (unsigned i = 0; i < state.file.mNumMeshes; ++i)
    if (state.file.mMeshes[i]->mMaterialIndex >= state.file.mNumMaterials)
      throw Error(ErrorCode::input, name,
                  fmt::format("mesh '{}' has a material that doesn't exist: repair the file",
                              state.file.mMeshes[i]->mName.C_Str()));
}

ImportedScene imported(const aiScene& file, const std::string& name, const ImportOptions& options) {
  const std::vector<Instance> instances =
      file.mRootNode != nullptr ? instances_of(file, name) : std::vector<Instance>{};
  const std::uint64_t triangles = checked_size(file, instances, options, name);
  if (triangles == 0)
    throw Error(ErrorCode::input, name, "has no face of three corners or more: give a mesh of polygons");
  Importing state{file, options.smooth, {}, {}, {}, {}, {}, {}, {}, {}};
  read_materials(state, name);
  state.generated_normals.resize(file.mNumMeshes);
  Scene& scene = state.result.scene;
  scene.triangles.reserve(triangles);
  if (options.smooth) scene.normals.reserve(triangles);
  for (std::size_t i = 0; i < instances.size(); ++i)
    add_instance(state, instances[i], static_cast<std::uint32_t>(i));
  place_points(scene.triangles);
  scene.materials = std::move(state.materials.materials);
  import::import_view(file, options, state.result);
  return std::move(state.result);
}

// Without any of Assimp's processing steps: it would triangulate, join and reorder differently.
constexpr unsigned no_steps = 0;

std::string_view text_of(std::span<const std::uint8_t> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

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
  explicit RegularFiles(const std::function<void(const std::string&)>& opened) : opened_(opened) {}
  bool Exists(const char* path) const override {
    std::error_code unknown;
    return std::filesystem::is_regular_file(path, unknown);
  }
  Assimp::IOStream* Open(const char* path, const char* mode) override {
    if (!Exists(path)) return nullptr;
    if (opened_) opened_(path);
    return DefaultIOSystem::Open(path, mode);
  }

private:
  const std::function<void(const std::string&)>& opened_;
};

void set_up(Assimp::Importer& importer, const ImportOptions& options) {
  importer.SetIOHandler(std::make_unique<RegularFiles>(options.opened).release()); // owned by it
  importer.SetPropertyBool(AI_CONFIG_IMPORT_NO_SKELETON_MESHES, true);
  if (options.progress)
    importer.SetProgressHandler(std::make_unique<Progress>(options.progress).release()); // owned by it
}

// Assimp's message as one line.
[[noreturn]] void fail(const Assimp::Importer& importer, const std::string& name) {
  std::string message = importer.GetErrorString();
  if (message == "std::bad_alloc")
    message = "reading it needs more memory than it may take: repair or split the file";
  for (char& c : message)
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  while (!message.empty() && message.back() == ' ')
    message.pop_back();
  if (message.empty()) message = "can't be read: give a mesh in a format that Assimp reads";
  throw Error(ErrorCode::input, name, message);
}

// What `read` makes of the importer, as a scene.
template <class Read>
ImportedScene imported_by(const std::string& name, const ImportOptions& options, const Read& read) {
  Assimp::Importer importer;
  set_up(importer, options);
  const aiScene* const file = read(importer);
  if (options.parsed) options.parsed();
  if (file == nullptr) fail(importer, name);
  return imported(*file, name, options);
}

} // namespace

ImportedScene read_mesh(const std::string& path, const ImportOptions& options) {
  import::check_ply_header(text_of(InputFile(path).contents().bytes()), path);
  return imported_by(path, options,
                     [&](Assimp::Importer& importer) { return importer.ReadFile(path, no_steps); });
}

ImportedScene parse_mesh(std::span<const std::uint8_t> bytes, const std::string& extension,
                         const std::string& name, const ImportOptions& options) {
  import::check_ply_header(text_of(bytes), name);
  return imported_by(name, options, [&](Assimp::Importer& importer) {
    return importer.ReadFileFromMemory(bytes.data(), bytes.size(), no_steps, extension.c_str());
  });
}

} // namespace masu
