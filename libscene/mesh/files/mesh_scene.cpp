#include "libscene/mesh/files/mesh_scene.h"

#include "libscene/base/available_memory.h"
#include "libscene/base/error.h"
#include "libscene/base/parallel.h"
#include "libscene/file/input_file.h"
#include "libscene/material_table.h"
#include "libscene/mesh/triangulate.h"

#include <fmt/format.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numeric>

namespace masu {
namespace {

// Throws where the objects' triangles are too many for a scene or for the memory. Returns their number.
std::uint64_t checked_size(const MeshFile& file, const ImportOptions& options, const std::string& name) {
  std::uint64_t triangles = 0;
  for (const MeshObject& object : file.objects)
    triangles += object.triangles(); // at most 2^32 times 2^64 / 2^32 faces that are in memory
  if (file.objects.size() > max_objects)
    throw Error(ErrorCode::input, name, fmt::format("has more than {} objects: split the file", max_objects));
  if (triangles > options.max_primitives)
    throw Error(ErrorCode::input, name,
                fmt::format("has more than {} triangles: split the file", options.max_primitives));
  const std::uint64_t each = sizeof(SceneTriangle) + sizeof(std::uint32_t) +
                             (options.smooth ? sizeof(CornerNormals<double>) : std::uint64_t{0});
  const double needed = static_cast<double>(triangles) * static_cast<double>(each);
  if (const double available = available_memory_for(needed); needed > available)
    throw Error(ErrorCode::input, name,
                fmt::format("its {} triangles, instances expanded, take {:.1f} GB of memory, and {:.1f} are "
                            "available: split the file",
                            triangles, needed / 1e9, available / 1e9));
  return triangles;
}

// --- Normals at the vertices of an object that has none --------------------------------------------------

// Orders positions, NaN included; equal where the coordinates are.
std::array<std::uint64_t, 3> key_of(const Vec3d& p) {
  // + 0 makes -0 and 0 the same.
  return {std::bit_cast<std::uint64_t>(p.x + 0.0), std::bit_cast<std::uint64_t>(p.y + 0.0),
          std::bit_cast<std::uint64_t>(p.z + 0.0)};
}

// For each vertex the sum of the unit normals of all the object's faces with a corner at its position,
// weighted by the corner's angle, after Thürmer & Wüthrich, "Computing Vertex Normals from Polygonal Facets",
// Journal of Graphics Tools 3(1), 1998. Zero where there is no such face, or none with area.
class VertexNormals {
public:
  // `file` outlives it.
  explicit VertexNormals(const MeshFile& file)
      : file_(file), first_(file.positions.size()), normals_(file.positions.size()) {
    std::vector<std::uint32_t> order(first_.size());
    std::iota(order.begin(), order.end(), 0U);
    tbb::parallel_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
      const auto key_a = key_of(file.positions[a]), key_b = key_of(file.positions[b]);
      return key_a != key_b ? key_a < key_b : a < b;
    });
    for (std::size_t i = 0; i < order.size(); ++i) {
      const bool is_same = i > 0 && key_of(file.positions[order[i]]) == key_of(file.positions[order[i - 1]]);
      first_[order[i]] = is_same ? first_[order[i - 1]] : order[i];
    }
  }

  // Takes that object's faces, in time of their number; before, and again for another one.
  void take(const MeshObject& object) {
    const std::span<const std::uint32_t> all(file_.corners.data() + object.first_corner, object.corners);
    for (const std::uint32_t corner : all)
      normals_[first_[corner]] = {0, 0, 0};
    // Of a face, of equal consecutive ones the first: an angle has two sides.
    std::vector<std::uint32_t> corners;
    std::size_t begin = 0;
    for (std::uint64_t f = object.first_face; f < object.first_face + object.faces; ++f) {
      corners.clear();
      for (const std::uint32_t corner : all.subspan(begin, file_.face_sizes[f]))
        if (corners.empty() || first_[corner] != corners.back()) corners.push_back(first_[corner]);
      begin += file_.face_sizes[f];
      while (corners.size() > 1 && corners.front() == corners.back())
        corners.pop_back();
      if (corners.size() >= 3) add_face(corners);
    }
  }

  Vec3d operator[](std::uint32_t vertex) const { return normals_[first_[vertex]]; }

private:
  void add_face(std::span<const std::uint32_t> corners) {
    const std::size_t n = corners.size();
    const auto corner = [&](std::size_t i) { return file_.positions[corners[i % n]]; };
    Vec3d across{0, 0, 0}; // twice the area
    for (std::size_t i = 1; i + 1 < n; ++i)
      across = across + cross(corner(i) - corner(0), corner(i + 1) - corner(0));
    const auto unit_or_zero = [](const Vec3d& v) { return unit(v).value_or(Vec3d{0, 0, 0}); };
    const Vec3d normal = unit_or_zero(across);
    for (std::size_t i = 0; i < n; ++i) {
      const Vec3d next = unit_or_zero(corner(i + 1) - corner(i));
      const Vec3d previous = unit_or_zero(corner(i + n - 1) - corner(i));
      const double angle = std::atan2(length(cross(next, previous)), dot(next, previous));
      normals_[corners[i]] = normals_[corners[i]] + normal * angle;
    }
  }

  const MeshFile& file_;
  std::vector<std::uint32_t> first_; // of each vertex: the first at its position
  std::vector<Vec3d> normals_;       // of those
};

// --- The scene -------------------------------------------------------------------------------------------

// The state of an import. Vectors are members to reuse their memory.
struct Importing {
  const MeshFile& file;
  bool smooth;
  ImportedScene result{};
  MaterialTable materials{};
  std::optional<VertexNormals> generated{}; // when first needed
  std::vector<Vec3d> corners{}, normals{};  // of a face
  std::vector<std::uint32_t> vertices{};    // the corners' positions
  Triangulation triangulation{};
  std::uint32_t face = 0; // its number
};

// The mean of the corners' colours in steps of 1/63, so that their number is bounded. NaN where one has none.
Vec3f mean_color(const Vec3f& a, const Vec3f& b, const Vec3f& c) {
  const auto mean = [](float x, float y, float z) {
    const float sum = (x + y + z) / 3;
    return std::round(63 * std::clamp(sum, 0.0F, 1.0F)) / 63;
  };
  return {mean(a.x, b.x, c.x), mean(a.y, b.y, c.y), mean(a.z, b.z, c.z)};
}

Material colored(const FileMaterial& of_file, const Vec3f& color) {
  Material material = of_file.material;
  if (is_finite(color)) material.color = of_file.multiplies_vertex_colors ? material.color * color : color;
  return material;
}

// Adds a triangle of the face.
void add_triangle(Importing& state, const SceneTriangle& triangle) {
  state.result.scene.faces.push_back(state.face);
  state.result.scene.triangles.push_back(triangle);
}

// Adds the triangles of the face whose corners, in the scene's coordinates, are state.corners: one that can't
// be hit, where it has no place, or no area and not three distinct corners.
void add_face(Importing& state, const MeshObject& object, std::uint32_t number) {
  Scene& scene = state.result.scene;
  const FileMaterial& material = state.file.materials[object.material];
  const bool has_place = std::all_of(state.corners.begin(), state.corners.end(), is_coordinate);
  if (has_place) triangulate(state.corners, state.triangulation);
  if (has_place && state.corners.size() == 3 && // of a triangle's corners three may be on a line
      has_distinct_corners(state.corners[0], state.corners[1], state.corners[2]))
    state.triangulation.triangles = {{0, 1, 2}};
  if (!has_place || state.triangulation.triangles.empty()) {
    ++(has_place ? scene.warnings.degenerate_polygons : state.result.notes.invalid_faces);
    return add_triangle(state, {{}, number, {}, state.materials.index_of(material.material), {}, no_normals});
  }
  scene.warnings.degenerate_triangles += state.triangulation.slivers;
  if (state.triangulation.crosses_itself) ++scene.warnings.self_crossing_polygons;
  std::uint32_t index = object.has_colors ? 0 : state.materials.index_of(material.material);
  for (const auto& [a, b, c] : state.triangulation.triangles) {
    if (object.has_colors) {
      const auto color = [&](std::uint32_t corner) { return state.file.colors[state.vertices[corner]]; };
      index = state.materials.index_of(colored(material, mean_color(color(a), color(b), color(c))));
    }
    const Vec3d &pa = state.corners[a], &pb = state.corners[b], &pc = state.corners[c];
    std::uint64_t normals = no_normals;
    if (state.smooth) {
      normals = scene.normals.size();
      const Vec3d flat = unit(cross(pb - pa, pc - pa)).value_or(Vec3d{0, 0, 1});
      const auto normal = [&](std::uint32_t corner) { return unit(state.normals[corner]).value_or(flat); };
      scene.normals.push_back({normal(a), normal(b), normal(c)});
    }
    add_triangle(state, {pa, number, pb, index, pc, normals});
  }
}

// The normal of the file's i-th corner; zero where it has none.
Vec3d normal_of(const Importing& state, const MeshObject& object, std::uint64_t i) {
  const MeshFile& file = state.file;
  if (!object.has_normals) return (*state.generated)[file.corners[i]];
  const std::uint32_t normal = file.corner_normals.empty() ? file.corners[i] : file.corner_normals[i];
  return normal != no_index ? file.normals[normal] : Vec3d{0, 0, 0};
}

void add_object(Importing& state, const MeshObject& object, std::uint32_t number) {
  const NormalTransform of_normals = normal_transform(object.transform);
  if (state.smooth && !object.has_normals) {
    if (!state.generated) state.generated.emplace(state.file);
    state.generated->take(object);
  }
  std::uint64_t corner = object.first_corner;
  for (std::uint64_t f = object.first_face; f < object.first_face + object.faces; ++f) {
    state.vertices.clear();
    state.corners.clear();
    state.normals.clear();
    const std::uint64_t size = state.file.face_sizes[f];
    for (std::uint64_t k = 0; k < size; ++k) {
      // Mirroring turns fronts into backs.
      const std::uint64_t i = corner + (of_normals.mirrors ? (size - k) % size : k);
      state.vertices.push_back(state.file.corners[i]);
      state.corners.push_back(
          transformed_point(object.transform, state.file.positions[state.vertices.back()]));
      if (state.smooth)
        state.normals.push_back(transformed_direction(of_normals.cofactors, normal_of(state, object, i)));
    }
    corner += size;
    add_face(state, object, number);
    ++state.face;
  }
  ++(state.smooth ? state.result.scene.objects.patches : state.result.scene.objects.polygons);
  state.result.object_names.push_back(object.name);
}

// Puts the triangles without a surface where others are: in a corner of the first one that has a surface. So
// neither bounds nor the choice of the store depend on them.
void place_points(GrowingArray<SceneTriangle>& triangles) {
  const auto is_surface = [](const Triangle<double>& triangle) { return has_surface(triangle); };
  const SceneTriangle* const first = std::find_if(triangles.begin(), triangles.end(), is_surface);
  const Vec3d place = first != triangles.end() ? first->a : points_without_surface;
  parallel_for(triangles.size(), [&](std::size_t i) {
    SceneTriangle& triangle = triangles[i];
    if (!is_surface(triangle)) triangle.a = triangle.b = triangle.c = place;
  });
}

constexpr std::int32_t default_height = 512;

// Above and to the left of the camera, half its distance each.
Light<double> automatic_light(const Camera& camera) {
  const Vec3d view = camera.at - camera.from;
  const Vec3d forward = direction(view), right = direction(cross(forward, camera.up));
  return {camera.from + (cross(right, forward) - right) * (0.5 * length(view)), {1, 1, 1}};
}

} // namespace

ImportedScene scene_of(const MeshFile& file, const std::string& name, const ImportOptions& options) {
  const std::uint64_t triangles = checked_size(file, options, name);
  if (triangles == 0)
    throw Error(ErrorCode::input, name, "has no face of three corners or more: give a mesh of polygons");
  Importing state{file, options.smooth};
  state.result.notes = file.notes;
  Scene& scene = state.result.scene;
  scene.triangles.reserve(triangles);
  scene.faces.reserve(triangles);
  if (options.smooth) scene.normals.reserve(triangles);
  std::uint32_t number = 0;
  for (const MeshObject& object : file.objects)
    if (object.faces > 0) add_object(state, object, number++);
  place_points(scene.triangles);
  // Each face has a triangle at least: of as many each is its own.
  if (state.face == scene.triangles.size()) scene.faces = {};
  scene.materials = std::move(state.materials.materials);
  return std::move(state.result);
}

void complete_view(const Sphere<double>& whole, const ImportOptions& options, ImportedScene& result) {
  Scene& scene = result.scene;
  if (!scene.has_camera)
    scene.camera =
        automatic_camera(whole, options.up == UpAxis::y, options.width > 0 ? options.width : default_height,
                         options.height > 0 ? options.height : default_height);
  double brightest = 0;
  for (const Light<double>& light : scene.lights)
    brightest = std::max(brightest, largest_magnitude(light.intensity));
  result.notes.has_camera = scene.has_camera;
  result.notes.has_lights = brightest > 0;
  if (brightest == 0) {
    brightest = 1;
    scene.lights = {scene.has_camera ? Light<double>{scene.camera.from, {1, 1, 1}}
                                     : automatic_light(scene.camera)};
  }
  const double n = static_cast<double>(scene.lights.size());
  const double each = std::sqrt(n) / (2 * n);
  for (Light<double>& light : scene.lights)
    light.intensity = light.intensity * (each / brightest);
  scene.ambient = static_cast<float>(each);
  scene.background = {0, 0, 0};
}

MeshFile read_mesh_file(std::span<const std::uint8_t> bytes, MeshFormat format,
                        const std::filesystem::path& folder, const std::string& name,
                        const ImportOptions& options) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  const auto other_file = [&](const std::string& other) -> std::optional<std::string> {
    const std::filesystem::path path = folder / other;
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error)) return {};
    if (options.opened) options.opened(path);
    const HostBytes contents = InputFile(path).contents();
    return std::string(contents.begin(), contents.end());
  };
  MeshFile mesh = parse_mesh_file({text, name, other_file, options.progress}, format);
  if (options.parsed) options.parsed();
  return mesh;
}

ImportedScene viewed_scene_of(const MeshFile& file, const std::string& name, const ImportOptions& options) {
  ImportedScene result = scene_of(file, name, options);
  complete_view(bounding_sphere(result.scene), options, result);
  return result;
}

} // namespace masu
