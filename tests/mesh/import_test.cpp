// Meshes of any format: the same triangles as from NFF, transforms, materials, cameras, lights, normals.
#include "libscene/file/scene_file.h"
#include "libscene/mesh/import/import.h"
#include "libscene/nff/nff.h"
#include "tests/mesh/mesh_texts.h"
#include "tests/random_test.h"
#include "tests/refused.h"
#include "tests/temporary_folder.h"

#include <map>
#include <numbers>

namespace masu {
namespace {

using namespace texts;

using Import = RandomTest;

using Polygon = std::vector<Vec3d>;

// Of a file that errors call t.
ImportedScene parse(std::string_view text, const std::string& extension, const ImportOptions& options = {}) {
  const TemporaryFolder folder;
  const std::string path = folder.file(extension.empty() ? "t" : "t." + extension);
  write_text(path, text);
  try {
    return read_mesh(path, options);
  } catch (const Error& error) {
    throw Error(error.code(), "t" + error.place().substr(path.size()), error.message());
  }
}

// --- Polygons in several formats ------------------------------------------------------------------------

// A star-shaped polygon, convex or not, in a random plane. Multiples of 1/64, which every format holds
// exactly.
Polygon random_polygon(Chance& chance, int vertices) {
  const auto raster = [](double x) { return std::round(64 * x) / 64; };
  const Vec3d center = chance.in_cube(4), slope = chance.in_cube(0.5);
  Polygon polygon;
  for (int i = 0; i < vertices; ++i) {
    const double angle = 2 * std::numbers::pi * i / vertices, r = chance.uniform(0.25, 2);
    const double x = raster(r * std::cos(angle)), y = raster(r * std::sin(angle));
    polygon.push_back(
        {raster(center.x) + x, raster(center.y) + y, raster(center.z + slope.x * x + slope.y * y)});
  }
  return polygon;
}

std::vector<Polygon> random_polygons(Chance& chance, int max_vertices) {
  std::vector<Polygon> polygons;
  for (int i = 0; i < 20; ++i)
    polygons.push_back(random_polygon(chance, chance.whole(3, max_vertices)));
  polygons.push_back({{1, 1, 1}, {2, 2, 2}, {1, 1, 1}}); // without area
  return polygons;
}

std::string nff_of(const std::vector<Polygon>& polygons) {
  std::string text;
  for (const Polygon& polygon : polygons) {
    text += fmt::format("p {}\n", polygon.size());
    for (const Vec3d& p : polygon)
      text += numbers_of(p) + "\n";
  }
  return text;
}

// Each polygon has vertices of its own.
PolygonMesh mesh_of(const std::vector<Polygon>& polygons) {
  PolygonMesh mesh;
  for (const Polygon& polygon : polygons) {
    auto& face = mesh.faces.emplace_back();
    for (const Vec3d& p : polygon) {
      face.push_back(static_cast<std::uint32_t>(mesh.vertices.size()));
      mesh.vertices.push_back(p);
    }
  }
  return mesh;
}

// Binary glTF: one mesh of the triangles, whose primitive has material 0 if `more` lists materials.
// `nodes`: JSON objects, the first of which is the scene's root.
std::string glb_of(const std::vector<Polygon>& triangles, const std::string& nodes = R"({"mesh":0})",
                   const std::string& more = "", const std::string& primitive = "") {
  std::string body;
  for (const Polygon& triangle : triangles)
    for (const Vec3d& p : triangle)
      append_point<float>(body, p);
  std::string json =
      fmt::format(R"({{"asset":{{"version":"2.0"}},"scene":0,"scenes":[{{"nodes":[0]}}],"nodes":[{}],)"
                  R"("meshes":[{{"name":"m","primitives":[{{"attributes":{{"POSITION":0}}{}}}]}}],)"
                  R"("accessors":[{{"bufferView":0,"componentType":5126,"count":{},"type":"VEC3"}}],)"
                  R"("bufferViews":[{{"buffer":0,"byteLength":{}}}],"buffers":[{{"byteLength":{}}}]{}}})",
                  nodes, primitive, 3 * triangles.size(), body.size(), body.size(), more);
  json.resize((json.size() + 3) / 4 * 4, ' ');
  std::string bytes = "glTF";
  append(bytes, std::uint32_t{2});
  append(bytes, static_cast<std::uint32_t>(12 + 8 + json.size() + 8 + body.size()));
  append(bytes, static_cast<std::uint32_t>(json.size()));
  bytes += "JSON" + json;
  append(bytes, static_cast<std::uint32_t>(body.size()));
  bytes += std::string("BIN\0", 4) + body;
  return bytes;
}

// But for those that keep the numbers of faces without area, which NFF leaves out.
void expect_same_triangles(const Scene& scene, const Scene& expected) {
  std::vector<Triangle<double>> surfaces;
  for (const Triangle<double> t : scene.triangles)
    if (has_surface(t)) surfaces.push_back(t);
  ASSERT_EQ(surfaces.size(), expected.triangles.size());
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    const Triangle<double>&t = surfaces[i], &e = expected.triangles[i];
    EXPECT_TRUE(t.a == e.a && t.b == e.b && t.c == e.c) << "triangle " << i;
  }
  EXPECT_EQ(scene.warnings.degenerate_polygons, expected.warnings.degenerate_polygons);
  EXPECT_EQ(scene.warnings.degenerate_triangles, expected.warnings.degenerate_triangles);
  EXPECT_EQ(scene.warnings.self_crossing_polygons, expected.warnings.self_crossing_polygons);
}

TEST_F(Import, PolygonsAreTheSameTrianglesAsFromNff) {
  for (int i = 0; i < 40; ++i) {
    const int max_vertices = i % 2 == 0 ? 9 : 3;
    const std::vector<Polygon> polygons = random_polygons(chance_, max_vertices);
    const Scene nff = parse_nff(nff_of(polygons), "t");
    EXPECT_EQ(nff.warnings.degenerate_polygons, 1U);
    const PolygonMesh mesh = mesh_of(polygons);
    expect_same_triangles(parse(obj_of(mesh), "obj").scene, nff);
    expect_same_triangles(parse(ply_of(mesh), "ply").scene, nff);
    expect_same_triangles(parse(binary_ply_of<float>(mesh, false), "ply").scene, nff);
    if (max_vertices > 3) continue;
    expect_same_triangles(parse(binary_stl_of(mesh), "stl").scene, nff);
    expect_same_triangles(parse(glb_of(polygons), "glb").scene, nff);
  }
}

// --- Numbers of faces ------------------------------------------------------------------------------------

// Points and lines are no faces.
TEST_F(Import, TrianglesHaveTheNumbersOfTheirFaces) {
  const std::string vertices =
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv nan 0 0\nv 1e9 1e9 1e9\nv 2e9 2e9 2e9\nv 3e9 3e9 3e9\nv inf 0 0\n";
  const ImportedScene imported =
      parse(vertices + "f 5 6 5\nf 1 2 3\nl 1 2\nf 2 2 3\nf 1 2 4\nf 3 2 1\no more\nf 1 1 8\np 3\nf 2 3 1\n",
            "obj");
  const Scene& scene = imported.scene;
  EXPECT_TRUE(scene.faces.empty()); // each triangle is its own face
  ASSERT_EQ(scene.triangles.size(), 7U);
  for (const std::size_t i : {0U, 2U, 3U, 5U})
    EXPECT_FALSE(has_surface(Triangle<double>(scene.triangles[i]))) << i;
  EXPECT_TRUE(scene.triangles[1].a == (Vec3d{0, 0, 0}));
  EXPECT_TRUE(scene.triangles[4].a == (Vec3d{0, 1, 0}));
  EXPECT_TRUE(scene.triangles[6].a == (Vec3d{1, 0, 0}));
  EXPECT_EQ(scene.triangles[4].object, 0U);
  EXPECT_EQ(scene.triangles[5].object, 1U);
  EXPECT_EQ(scene.warnings.degenerate_polygons, 2U);
  EXPECT_EQ(imported.notes.invalid_faces, 2U);
  EXPECT_EQ(imported.notes.points_and_lines, 2U);
  EXPECT_TRUE(bounds(scene).max == (Vec3d{1, 1, 0})); // those of what can be hit
}

TEST_F(Import, TrianglesOfPolygonsSayTheirFaces) {
  for (int i = 0; i < 20; ++i) {
    std::vector<Polygon> polygons = random_polygons(chance_, 9);
    polygons.push_back({{1, 1, 1}, {2, 2, 2}, {3, 3, 3}, {2, 2, 2}}); // without area
    std::shuffle(polygons.begin(), polygons.end(), chance_.engine());
    const PolygonMesh mesh = mesh_of(polygons);
    for (const auto& [extension, text] : {std::pair{"ply", ply_of(mesh)}, {"obj", obj_of(mesh)}}) {
      const Scene scene = parse(text, extension).scene;
      ASSERT_EQ(scene.faces.size(), scene.triangles.size());
      std::vector<int> triangles(polygons.size());
      for (std::size_t k = 0; k < scene.triangles.size(); ++k) {
        const Triangle<double> t = scene.triangles[k];
        const Polygon& face = polygons.at(scene.faces[k]);
        ++triangles[scene.faces[k]];
        const auto has_corner = [&](const Vec3d& p) {
          return std::any_of(face.begin(), face.end(),
                             [&](const Vec3d& q) { return largest_magnitude(p - q) < 1e-6; });
        };
        EXPECT_TRUE(!has_surface(t) || (has_corner(t.a) && has_corner(t.b) && has_corner(t.c)));
      }
      EXPECT_TRUE(std::all_of(triangles.begin(), triangles.end(), [](int count) { return count > 0; }));
      EXPECT_TRUE(std::is_sorted(scene.faces.begin(), scene.faces.end()));
    }
  }
}

// --- Objects and transforms -----------------------------------------------------------------------------

const std::vector<Polygon> one_triangle{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};

TEST_F(Import, EachInstanceOfAMeshIsAnObject) {
  const ImportedScene imported = parse(
      glb_of(
          {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 0, 1}, {1, 0, 1}, {0, 1, 1}}},
          R"({"name":"root","children":[1,2],"translation":[10,0,0]},{"name":"a","mesh":0,"scale":[2,2,2]},)"
          R"({"name":"b","mesh":0,"translation":[0,0,5]})"),
      "glb");
  const Scene& scene = imported.scene;
  EXPECT_EQ(imported.object_names, (std::vector<std::string>{"a/m", "b/m"}));
  EXPECT_EQ(scene.objects.polygons, 2U);
  ASSERT_EQ(scene.triangles.size(), 4U);
  EXPECT_EQ(scene.triangles[0].object, 0U);
  EXPECT_EQ(scene.triangles[1].object, 0U);
  EXPECT_EQ(scene.triangles[2].object, 1U);
  EXPECT_TRUE(scene.triangles[1].b == (Vec3d{12, 0, 2}));
  EXPECT_TRUE(scene.triangles[3].b == (Vec3d{11, 0, 6}));
}

TEST_F(Import, FrontsStayOutsideWhereANodeMirrors) {
  for (const bool smooth : {false, true}) {
    const Scene scene = parse(glb_of(one_triangle, R"({"mesh":0,"scale":[-1,1,1]})"), "glb", {smooth}).scene;
    ASSERT_EQ(scene.triangles.size(), 1U);
    const Triangle<double>& t = scene.triangles[0];
    EXPECT_GT(cross(t.b - t.a, t.c - t.a).z, 0);
    if (smooth) {
      ASSERT_EQ(scene.normals.size(), 1U);
      EXPECT_GT(scene.normals[0].a.z, 0.999);
    }
  }
}

// --- Materials ------------------------------------------------------------------------------------------

Material material_of(const std::string& json) {
  const Scene scene =
      parse(glb_of(one_triangle, R"({"mesh":0})",
                   R"(,"extensionsUsed":["KHR_materials_transmission"],"materials":[)" + json + "]",
                   R"(,"material":0)"),
            "glb")
          .scene;
  EXPECT_EQ(scene.materials.size(), 1U);
  return scene.materials.at(0);
}

TEST_F(Import, MetalnessAndRoughnessBecomeDiffuseAndSpecular) {
  const Material matte = material_of(
      R"({"pbrMetallicRoughness":{"baseColorFactor":[0.5,0.25,0.125,1],"metallicFactor":0,"roughnessFactor":1}})");
  EXPECT_EQ(matte.color, (Vec3f{0.5F, 0.25F, 0.125F}));
  EXPECT_EQ(matte.diffuse, 1);
  EXPECT_EQ(matte.specular, 0);
  EXPECT_EQ(matte.transmittance, 0);
  const Material mirror = material_of(R"({"pbrMetallicRoughness":{"metallicFactor":1,"roughnessFactor":0}})");
  EXPECT_EQ(mirror.diffuse, 0);
  EXPECT_EQ(mirror.specular, 1);
  EXPECT_TRUE(std::isfinite(mirror.shine));
  const Material veil = material_of(
      R"({"pbrMetallicRoughness":{"baseColorFactor":[1,1,1,0.25],"metallicFactor":0},"alphaMode":"BLEND"})");
  EXPECT_EQ(veil.transmittance, 0.75F);
  EXPECT_EQ(veil.diffuse, 0.25F);
  EXPECT_EQ(veil.refraction_index, 1);
  const Material opaque =
      material_of(R"({"pbrMetallicRoughness":{"baseColorFactor":[1,1,1,0.25],"metallicFactor":0}})");
  EXPECT_EQ(opaque.transmittance, 0);
}

TEST_F(Import, VertexColorsAreTheTrianglesColors) {
  const ImportedScene imported =
      parse("ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
            "property uchar red\nproperty uchar green\nproperty uchar blue\nelement face 2\n"
            "property list uchar int vertex_indices\nend_header\n"
            "0 0 0 255 0 0\n1 0 0 255 0 0\n0 1 0 255 0 0\n1 1 0 255 255 255\n3 0 1 2\n3 1 3 2\n",
            "ply");
  const Scene& scene = imported.scene;
  ASSERT_EQ(scene.triangles.size(), 2U);
  ASSERT_EQ(scene.materials.size(), 2U);
  EXPECT_EQ(scene.materials[0].color, (Vec3f{1, 0, 0}));
  EXPECT_EQ(scene.materials[1].color.x, 1);
  EXPECT_NEAR(scene.materials[1].color.y, 1.0 / 3, 1.0 / 126);
}

// --- Normals --------------------------------------------------------------------------------------------

// A sphere of radius 2 as an OBJ, each face with vertices of its own.
std::string sphere_obj(int rings) {
  std::vector<Polygon> polygons;
  const auto at = [&](int i, int j) {
    const double latitude = std::numbers::pi * i / rings,
                 longitude = std::numbers::pi * (j % (2 * rings)) / rings;
    const auto rounded = [](double x) { return std::round(1e6 * x) / 1e6; }; // the poles are one point each
    return Vec3d{rounded(2 * std::sin(latitude) * std::cos(longitude)),
                 rounded(2 * std::sin(latitude) * std::sin(longitude)), rounded(2 * std::cos(latitude))};
  };
  for (int i = 0; i < rings; ++i)
    for (int j = 0; j < 2 * rings; ++j)
      polygons.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
  return obj_of(mesh_of(polygons));
}

TEST_F(Import, GeneratedNormalsOfASphereAreRadial) {
  const Scene scene = parse(sphere_obj(32), "obj", {.smooth = true}).scene;
  ASSERT_EQ(scene.normals.size(), scene.triangles.size());
  std::map<std::array<double, 3>, Vec3d> at; // one normal for each position
  for (const SceneTriangle& t : scene.triangles) {
    const CornerNormals<double>& n = scene.normals[t.normals];
    for (const auto& [p, normal] : {std::pair{t.a, n.a}, {t.b, n.b}, {t.c, n.c}}) {
      EXPECT_GT(dot(normal, p) / 2, 0.998);
      EXPECT_TRUE(at.try_emplace({p.x, p.y, p.z}, normal).first->second == normal);
    }
  }
}

TEST_F(Import, TheFilesNormalsAreUsedOnlyWhereAskedFor) {
  const std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 3 0 4\nf 1//1 2//1 3//1\n";
  EXPECT_EQ(parse(obj, "obj").scene.triangles[0].normals, no_normals);
  const Scene scene = parse(obj, "obj", {.smooth = true}).scene;
  ASSERT_EQ(scene.normals.size(), 1U);
  EXPECT_NEAR(scene.normals[0].b.x, 0.6, 1e-6);
  EXPECT_NEAR(scene.normals[0].b.z, 0.8, 1e-6);
  EXPECT_EQ(scene.objects.patches, 1U);
}

// --- Camera and lights ----------------------------------------------------------------------------------

constexpr const char* camera_and_light =
    R"(,"extensionsUsed":["KHR_lights_punctual"],"cameras":[{"type":"perspective","perspective":)"
    R"({"yfov":0.5,"znear":0.25,"aspectRatio":2}}],"extensions":{"KHR_lights_punctual":{"lights":[)"
    R"({"type":"point","color":[1,0.5,0.25],"intensity":40},{"type":"directional","intensity":10}]}})";

TEST_F(Import, TheFilesCameraAndLightsAreUsed) {
  const ImportedScene imported =
      parse(glb_of(one_triangle,
                   R"({"mesh":0,"children":[1,2,3]},{"name":"c","camera":0,"translation":[0,0,5]},)"
                   R"({"name":"l","translation":[1,2,3],"extensions":{"KHR_lights_punctual":{"light":0}}},)"
                   R"({"name":"d","extensions":{"KHR_lights_punctual":{"light":1}}})",
                   camera_and_light),
            "glb");
  const Scene& scene = imported.scene;
  EXPECT_TRUE(scene.has_camera);
  EXPECT_TRUE(imported.notes.has_lights);
  EXPECT_TRUE(scene.camera.from == (Vec3d{0, 0, 5}));
  EXPECT_LT(normalized(scene.camera.at - scene.camera.from).z, -0.999);
  EXPECT_NEAR(scene.camera.angle, 0.5 * 180 / std::numbers::pi, 1e-4);
  EXPECT_EQ(scene.camera.width, 1024);
  EXPECT_EQ(scene.camera.height, 512);
  ASSERT_EQ(scene.lights.size(), 2U);
  const double each = std::sqrt(2.0) / 4;
  EXPECT_TRUE(scene.lights[0].position == (Vec3d{1, 2, 3}));
  EXPECT_NEAR(scene.lights[0].intensity.x, each, 1e-6);
  EXPECT_NEAR(scene.lights[0].intensity.z, each / 4, 1e-6);
  EXPECT_GT(scene.lights[1].position.z, 10); // shines along -z
  EXPECT_NEAR(scene.lights[1].intensity.x, each / 4, 1e-6);
}

// Whether every corner is inside the picture.
bool is_framed(const Scene& scene) {
  const Camera& camera = scene.camera;
  const Vec3d forward = normalized(camera.at - camera.from), right = normalized(cross(forward, camera.up)),
              up = cross(right, forward);
  const double top = std::tan(camera.angle / 2 * std::numbers::pi / 180);
  const double side = top * camera.width / camera.height;
  for (const SceneTriangle& t : scene.triangles)
    for (const Vec3d& p : {t.a, t.b, t.c}) {
      const Vec3d v = p - camera.from;
      const double depth = dot(v, forward);
      if (!(depth > 0) || std::abs(dot(v, right)) > side * depth || std::abs(dot(v, up)) > top * depth)
        return false;
    }
  return true;
}

TEST_F(Import, TheAutomaticCameraFramesTheSceneWithItsUpAxis) {
  for (int i = 0; i < 20; ++i) {
    const std::string obj = obj_of(mesh_of(random_polygons(chance_, 9)));
    for (const UpAxis up : {UpAxis::y, UpAxis::z}) {
      ImportOptions options;
      options.up = up;
      options.width = chance_.whole(1, 1000);
      options.height = chance_.whole(1, 1000);
      const ImportedScene imported = parse(obj, "obj", options);
      EXPECT_FALSE(imported.scene.has_camera);
      EXPECT_TRUE(imported.scene.camera.up == (up == UpAxis::y ? Vec3d{0, 1, 0} : Vec3d{0, 0, 1}));
      EXPECT_EQ(imported.scene.camera.width, options.width);
      EXPECT_EQ(imported.scene.camera.height, options.height);
      EXPECT_TRUE(is_framed(imported.scene));
      EXPECT_EQ(imported.scene.lights.size(), 1U);
    }
  }
}

// --- Invalid files --------------------------------------------------------------------------------------

testing::AssertionResult refused(const std::string& text, const std::string& extension,
                                 const std::string& place, const std::string& says = "",
                                 const ImportOptions& options = {}) {
  return is_refused([&](const std::string&) { parse(text, extension, options); }, place, says);
}

TEST_F(Import, InvalidFilesAreRefusedInOneLine) {
  EXPECT_TRUE(refused("", "ply", "t:1"));
  EXPECT_TRUE(refused("no mesh at all", "obj", "t", "no face"));
  EXPECT_TRUE(refused("v 0 0 0\nv 1 1 1\nl 1 2\n# and nothing else\n", "obj", "t", "no face"));
  EXPECT_TRUE(refused("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
                      "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
                      "0 0 0\n3 0 1 2\n",
                      "ply", "t:11", "vertex 1 of 1"));
  EXPECT_TRUE(refused(glb_of(one_triangle, R"({"children":[1]},{"mesh":0,"children":[0]})"), "glb", "t",
                      "recursive"));
  EXPECT_TRUE(refused("v 0 0 0\nv 1 1 x\n", "", "t:2")); // of no name: by the content
  EXPECT_TRUE(is_refused([](const std::string& path) { read_mesh(path); }, "/nonexistent/a.ply", "opened"));
  EXPECT_TRUE(is_refused([](const std::string& path) { read_mesh(path); }, "/nonexistent/a.glb", "opened"));
}

// Of a glTF file what it requires must be understood: Assimp reads on.
TEST_F(Import, UnknownExtensionsThatAreRequiredAreRefused) {
  const auto requires_extension = [](const std::string& extension) {
    return glb_of(one_triangle, R"({"mesh":0})", R"(,"extensionsRequired":[")" + extension + "\"]");
  };
  const std::string json = R"({"asset":{"version":"2.0","extensionsRequired":["A_b"]},"extensionsRequired":)";
  for (const std::string extension : {"KHR_mesh_quantization", "KHR_draco_mesh_compression", "A_b"}) {
    EXPECT_TRUE(refused(requires_extension(extension), "glb", "t", extension));
    EXPECT_TRUE(refused(json + "[\"" + extension + "\"]}", "gltf", "t", extension));
  }
  EXPECT_TRUE(refused(requires_extension("KHR_mesh_quantization"), "glb", "t", "gltfpack -noq"));
  EXPECT_EQ(parse(requires_extension("KHR_lights_punctual"), "glb").scene.triangles.size(), 1U);
  // What is merely used may lack.
  const std::string used = R"(,"extensionsUsed":["A_b"],"extras":{"extensionsRequired":["A_b"]})";
  EXPECT_EQ(parse(glb_of(one_triangle, R"({"mesh":0})", used), "glb").scene.triangles.size(), 1U);
  const std::string long_name(1 << 20, 'x');
  try {
    parse(requires_extension(long_name), "glb");
    ADD_FAILURE() << "was taken";
  } catch (const Error& error) {
    EXPECT_LT(error.text().size(), 300U);
  }
}

TEST_F(Import, MoreTrianglesThanAreAllowedAreRefused) {
  const std::vector<Polygon> polygons = random_polygons(chance_, 8);
  std::uint64_t all = 0;
  for (const Polygon& polygon : polygons)
    all += polygon.size() - 2;
  const auto is_too_many = [](const std::string& text, const std::string& extension, std::uint64_t most) {
    ImportOptions options;
    options.max_primitives = most;
    return refused(text, extension, "t", fmt::format("has more than {} triangles: split the file", most),
                   options);
  };
  const PolygonMesh mesh = mesh_of(polygons);
  for (const auto& [extension, text] :
       {std::pair{"ply", binary_ply_of<float>(mesh, false)}, {"obj", obj_of(mesh)}}) {
    EXPECT_TRUE(is_too_many(text, extension, all - 1)) << extension;
    EXPECT_FALSE(is_too_many(text, extension, all)) << extension;
  }
  // Each instance has its own.
  const std::string twice = glb_of(one_triangle, R"({"children":[1,2]},{"mesh":0},{"mesh":0})");
  EXPECT_TRUE(is_too_many(twice, "glb", 1));
  EXPECT_FALSE(is_too_many(twice, "glb", 2));
  EXPECT_EQ(ImportOptions{}.max_primitives, 0x7fffffffU);
}

TEST_F(Import, DamagedFilesAreReadOrRefused) {
  const PolygonMesh mesh = mesh_of(random_polygons(chance_, 5));
  const std::string ply = binary_ply_of<float>(mesh, false), obj = obj_of(mesh), glb = glb_of(one_triangle);
  const auto take = [](const std::string& text, const std::string& extension) {
    try {
      parse(text, extension);
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::input);
      EXPECT_EQ(error.message().find('\n'), std::string::npos);
    }
  };
  for (int i = 0; i < 100; ++i)
    for (const auto& [text, extension] : {std::pair{ply, "ply"}, {obj, "obj"}, {glb, "glb"}})
      take(text.substr(0, chance_.index(text.size() + 1)), extension);
  // Of which Assimp 5.2 makes a node of nodes that aren't there.
  take(" 0 0 01 0 0 0 1 1 0 0 0 1 5 5 5 0 1 0\n, 0 0 1 5 5 5 5 5 5 0 1 0\n 0 0 1 5 5 5 0 1 0\n", "raw");
}

} // namespace
} // namespace masu
