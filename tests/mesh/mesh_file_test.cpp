// Our own readers of OBJ, PLY, OFF and STL: all digits, all ways to write them, and nothing that is cut or
// wrong.
#include "libscene/file/scene_file.h"
#include "libscene/mesh/files/mesh_scene.h"
#include "tests/mesh/mesh_texts.h"
#include "tests/random_test.h"
#include "tests/refused.h"

#include <map>

namespace masu {
namespace {

using namespace texts;

using MeshFiles = RandomTest;

const std::string own_name = "t";

MeshFile parse(std::string_view text, MeshFormat format, const std::string& library = "") {
  const auto other_file = [&](const std::string& other) {
    return other == "m.mtl" ? std::optional(library) : std::nullopt;
  };
  return parse_mesh_file({text, own_name, other_file}, format);
}
Scene scene(std::string_view text, MeshFormat format, const std::string& library = "") {
  return viewed_scene_of(parse(text, format, library), own_name, {}).scene;
}

// Refused with that place: t, or t:line.
testing::AssertionResult refused(std::string_view text, MeshFormat format, const std::string& place,
                                 const std::string& says = "", const std::string& library = "") {
  return is_refused_with(
      ErrorCode::input, place, [&] { scene(text, format, library); }, says);
}

std::string with_changed(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

// --- Corners -----------------------------------------------------------------------------------------------

// The positions of all corners, bit by bit.
std::vector<std::uint64_t> corners_of(const MeshFile& file) {
  std::vector<std::uint64_t> bits;
  for (const std::uint32_t corner : file.corners)
    for (const double x : {file.positions[corner].x, file.positions[corner].y, file.positions[corner].z})
      bits.push_back(std::bit_cast<std::uint64_t>(x));
  return bits;
}
std::vector<std::uint64_t> corners_of(const PolygonMesh& mesh) {
  std::vector<std::uint64_t> bits;
  for (const auto& face : mesh.faces)
    for (const std::uint32_t corner : face)
      for (const double x : {mesh.vertices[corner].x, mesh.vertices[corner].y, mesh.vertices[corner].z})
        bits.push_back(std::bit_cast<std::uint64_t>(x));
  return bits;
}

template <class Coordinate>
PolygonMesh random_mesh(Chance& chance, int corners, const Coordinate& coordinate) {
  PolygonMesh mesh;
  const int vertices = chance.whole(corners, 30);
  for (int i = 0; i < vertices; ++i)
    mesh.vertices.push_back({coordinate(), coordinate(), coordinate()});
  for (int i = chance.whole(1, 20); i > 0; --i) {
    auto& face = mesh.faces.emplace_back();
    for (int k = chance.whole(3, corners); k > 0; --k)
      face.push_back(static_cast<std::uint32_t>(chance.whole(0, vertices - 1)));
  }
  return mesh;
}

// --- Digits ------------------------------------------------------------------------------------------------

TEST_F(MeshFiles, CoordinatesKeepAllDigits) {
  for (int i = 0; i < 100; ++i) {
    const auto any = [&] { return std::ldexp(chance_.uniform(-1, 1), chance_.whole(-300, 300)); };
    const PolygonMesh polygons = random_mesh(chance_, 9, any), triangles = random_mesh(chance_, 3, any);
    const std::vector<std::uint64_t> expected = corners_of(polygons);
    EXPECT_EQ(corners_of(parse(obj_of(polygons), MeshFormat::obj)), expected);
    EXPECT_EQ(corners_of(parse(off_of(polygons), MeshFormat::off)), expected);
    EXPECT_EQ(corners_of(parse(ply_of(polygons), MeshFormat::ply)), expected);
    for (const bool is_big : {false, true})
      EXPECT_EQ(corners_of(parse(binary_ply_of<double>(polygons, is_big), MeshFormat::ply)), expected);
    EXPECT_EQ(corners_of(parse(stl_of(triangles), MeshFormat::stl)), corners_of(triangles));
    const PolygonMesh floats =
        random_mesh(chance_, 3, [&] { return double{static_cast<float>(chance_.uniform(-9, 9))}; });
    for (const bool is_big : {false, true})
      EXPECT_EQ(corners_of(parse(binary_ply_of<float>(floats, is_big), MeshFormat::ply)), corners_of(floats));
    EXPECT_EQ(corners_of(parse(binary_stl_of(floats), MeshFormat::stl)), corners_of(floats));
  }
}

// Cells of 0.3 at the place of a town in UTM coordinates: no square crosses itself, all bounds are right.
TEST_F(MeshFiles, AGridFarFromZeroKeepsItsShape) {
  constexpr int cells = 40;
  PolygonMesh mesh;
  for (int j = 0; j <= cells; ++j)
    for (int i = 0; i <= cells; ++i)
      mesh.vertices.push_back({500000 + 0.3 * i, 5400000 + 0.3 * j, 200 + 0.1 * ((3 * i + j) % 5)});
  for (std::uint32_t j = 0; j < cells; ++j)
    for (std::uint32_t i = 0; i < cells; ++i) {
      const std::uint32_t a = j * (cells + 1) + i;
      mesh.faces.push_back({a, a + 1, a + cells + 2, a + cells + 1});
    }
  for (const auto& [text, format] : {std::pair{obj_of(mesh), MeshFormat::obj},
                                     {off_of(mesh), MeshFormat::off},
                                     {ply_of(mesh), MeshFormat::ply},
                                     {binary_ply_of<double>(mesh, true), MeshFormat::ply}}) {
    const Scene grid = scene(text, format);
    EXPECT_EQ(grid.warnings.self_crossing_polygons, 0U);
    EXPECT_EQ(grid.triangles.size(), 2U * cells * cells);
    EXPECT_TRUE(bounds(grid).min == mesh.vertices.front());
    EXPECT_TRUE(bounds(grid).max == (Vec3d{500000 + 0.3 * cells, 5400000 + 0.3 * cells, 200.4}));
  }
}

// --- OBJ ---------------------------------------------------------------------------------------------------

const PolygonMesh square{{{0, 0, 0}, {2, 0, 0.5}, {2, 2, 0}, {0, 2, 0}}, {{0, 1, 2, 3}}};
const PolygonMesh one_face{{{0, 0, 0}, {2, 0, 0.5}, {2, 2, 0}}, {{0, 1, 2}}};

TEST_F(MeshFiles, ObjIsTheSameHoweverItIsWritten) {
  for (const std::string_view text :
       {"v 0 0 0\nv 2 0 .5\nv 2. +2 0e3\nv 0 2 0\nf 1 2 3 4\n",       // numbers
        " v 0 0 0\n\tv 2  0\t0.5 \nv 2 2 0\n  v 0 2 0\n\n f 1 2 3 4", // blanks, no last end of line
        "\xef\xbb\xbfv 0 0 0\nv 2 0 .5\nv 2 2 0\nv 0 2 0\nf 1 2 3 4\n",
        "# a\\\nv 0 0 0\nv 2 0 .5 # b\nv 2 2 0#c\nv 0 2 0\nf 1 2 3 4 # d\\\n#e\n",
        "v 0 0 0\r\nv 2 0 .5\r\n\r\nv 2 2 0\r\nv 0 2 0\r\nf 1 2 3 4\r\n",
        "v 0 0 0\rv 2 0 .5\rv 2 2 0\rv 0 2 0\rf 1 2 3 4",
        "v 0 0 0\nv 2 0 .5\nv 2 2 0\nv 0 2 0\nf 1 2 \\\n3 \\\r\n 4\n",
        "v 0 0 0 1\nv 4 0 1 2\nv 2 2 0 1 0.5 0\nv 0 2 0 1 1 1 1\nf 1 2 3 4\n", // a fourth coordinate; colours
        "v 0 0 0\nv 2 0 .5\nv 2 2 0\nv 0 2 0\nvn 0 0 1\nvt 0 0\nf 1/1/1 2//1 3/1 4/\n",
        "v 0 0 0\nv 2 0 .5\nv 2 2 0\nv 0 2 0\nf -4 -3/-1 -2 -1\nv 9 9 9\n",
        "f 1 2 3 4\nv 0 0 0\nv 2 0 .5\nv 2 2 0\nv 0 2 0\n"})
    EXPECT_EQ(corners_of(parse(text, MeshFormat::obj)), corners_of(square)) << text;
}

TEST_F(MeshFiles, VerticesOfNoFaceDontCount) {
  for (const auto& [format, text] :
       {std::pair{MeshFormat::obj, "v 0 0 0\nv 2 0 .5\nv 2 2 0\nv 5 5 5\nf 1 2 3\n"},
        {MeshFormat::off, "OFF\n4 1 0\n0 0 0\n2 0 .5\n2 2 0\n5 5 5\n3 0 1 2\n"}}) {
    EXPECT_TRUE(bounds(scene(text, format)).min == (Vec3d{0, 0, 0}));
    EXPECT_TRUE(bounds(scene(text, format)).max == (Vec3d{2, 2, 0.5}));
  }
}

constexpr std::string_view triangle_obj = "v 0 0 0\nv 2 0 .5\nv 2 2 0\n";

TEST_F(MeshFiles, ObjectsAreGroupsOfOneMaterial) {
  const MeshFile file =
      parse(std::string(triangle_obj) + "f 1 2 3\no a b\ng c d\nusemtl x\nf 1 2 3\nf 1 2 3\nusemtl y #1\n"
                                        "f 1 2 3\nusemtl x\nl 1 2 3\ng e\np 1 2\nf 1 2\n",
            MeshFormat::obj);
  std::vector<std::string> names;
  std::vector<std::uint64_t> faces;
  for (const MeshObject& object : file.objects) {
    names.push_back(object.name);
    faces.push_back(object.faces);
  }
  EXPECT_EQ(names, (std::vector<std::string>{"defaultobject", "c d", "c d/y #1", "e"}));
  EXPECT_EQ(faces, (std::vector<std::uint64_t>{1, 2, 1, 0}));
  EXPECT_EQ(file.notes.points_and_lines, 5U);
  EXPECT_EQ(viewed_scene_of(file, own_name, {}).object_names.size(), 3U); // those with faces
}

TEST_F(MeshFiles, ObjMaterialsAreThoseOfItsFile) {
  const std::string library = "Kd 9 9 9\nnewmtl a b\nKd 1 .5 0.25\nKs 1 0.5 0\nNs 30\nillum 3\n"
                              "newmtl glass\nKd .5\nKs 1 1 1\nd 0.25\nNi 1.5\nmap_Kd x.png\n"
                              "newmtl m\nPm 1\nPr 0\nKd spectral x.rfl\n  newmtl tr\nTr .75 # y\n";
  const std::string text = std::string(triangle_obj) +
                           "f 1 2 3\nmtllib m.mtl\nusemtl a b\nf 1 2 3\nusemtl glass\n"
                           "f 1 2 3\nusemtl m\nf 1 2 3\nusemtl tr\nf 1 2 3\n";
  const ImportedScene imported = viewed_scene_of(parse(text, MeshFormat::obj, library), own_name, {});
  const std::vector<Material>& materials = imported.scene.materials;
  ASSERT_EQ(materials.size(), 5U);
  EXPECT_EQ(materials[0], (Material{{0.6F, 0.6F, 0.6F}, 1, 0, 0, 0, 1}));
  EXPECT_EQ(materials[1], (Material{{1, 0.5F, 0.25F}, 1, 0.5F, 30, 0, 1}));
  EXPECT_EQ(materials[2], (Material{{0.5F, 0.5F, 0.5F}, 0.25F, 0, 0, 0.75F, 1.5F}));
  EXPECT_EQ(materials[3].specular, 1);
  EXPECT_EQ(materials[3].diffuse, 0);
  EXPECT_EQ(materials[4].transmittance, 0.75F);
  EXPECT_EQ(imported.notes.textured_materials, 1U);
  EXPECT_EQ(imported.notes.missing_libraries, 0U);
  const auto missing = [](const std::string& names) {
    return parse("mtllib " + names + "\n" + std::string(triangle_obj) + "f 1 2 3\n", MeshFormat::obj)
        .notes.missing_libraries;
  };
  EXPECT_EQ(missing("m.mtl"), 0U);
  EXPECT_EQ(missing("x.mtl m.mtl"), 1U);
  EXPECT_EQ(missing("x.mtl"), 1U);
  // The file of the mesh's name, where there is none of those that it names.
  const auto beside = [&](const std::string& other) {
    return other == "t.mtl" ? std::optional(library) : std::nullopt;
  };
  const std::string path = "a/t.obj",
                    glass = "mtllib x.mtl\n" + std::string(triangle_obj) + "usemtl glass\nf 1 2 3\n";
  const MeshFile found = parse_mesh_file({glass, path, beside}, MeshFormat::obj);
  EXPECT_EQ(found.notes.missing_libraries, 0U);
  EXPECT_EQ(viewed_scene_of(found, own_name, {}).scene.materials.at(0).refraction_index, 1.5F);
}

TEST_F(MeshFiles, VerticesWithoutAColorHaveTheMaterials) {
  const Scene colored =
      scene("v 0 0 0 1 0 0\nv 2 0 0 1 0 0\nv 2 2 0 1 0 0\nv 0 2 0\nf 1 2 3\nf 1 2 4\n", MeshFormat::obj);
  ASSERT_EQ(colored.materials.size(), 2U);
  EXPECT_EQ(colored.materials[0].color, (Vec3f{1, 0, 0}));
  EXPECT_EQ(colored.materials[1].color, (Vec3f{0.6F, 0.6F, 0.6F}));
}

TEST_F(MeshFiles, WhatIsntOfAnObjIsCounted) {
  const std::string text =
      "vp 1 2\nnonsense\ncstype bezier\ns 1\nmg 1 2\nlod 1\n" + std::string(triangle_obj) + "f 1 2 3\n";
  EXPECT_EQ(parse(text, MeshFormat::obj).notes.unknown_lines, 3U);
}

TEST_F(MeshFiles, WrongLinesOfAnObjAreRefused) {
  const std::string vertices(triangle_obj);
  for (const auto& [line, says] :
       std::map<std::string, std::string>{{"v 1 2", "coordinate"},
                                          {"v 1 2 3 4 5", "three coordinates"},
                                          {"v 1 2 3 4 5 6 7 8", "three coordinates"},
                                          {"v 1 2 3 0", "is 0"},
                                          {"v 1 2 x3", "'x3'"},
                                          {"v 1 2 3x", "'3x'"},
                                          {"v 1 2,5 3", "'2,5'"},
                                          {"v 1 2 +-3", "'+-3'"},
                                          {"v 1 2 1e999", "range"},
                                          {"v 1 2 -1e-999", "range"},
                                          {"v 1 2 0x10", "'0x10'"},
                                          {"vn 1 0", "normal"},
                                          {"f", "without vertices"},
                                          {"f 1 2 0", "'0'"},
                                          {"f 1 2 4", "number 4 of 3 vertices"},
                                          {"f 1 2 -4", "number -4 of 3 vertices"},
                                          {"f 1 2 9999999999", "number 9999999999"},
                                          {"f 1 2 99999999999999999999", "corner"},
                                          {"f 1 2 3x", "'3x'"},
                                          {"f 1 2 3.0", "'3.0'"},
                                          {"f 1 2 /1", "'/1'"},
                                          {"f 1 2 3/1/1/1", "'3/1/1/1'"},
                                          {"f 1//1 2//1 3//1", "number 1 of 0 normals"}}) {
    EXPECT_TRUE(refused(vertices + line + "\nf 1 2 3\n", MeshFormat::obj, "t:4", says)) << line;
  }
  // The line that names most of what isn't there.
  EXPECT_TRUE(refused(vertices + "f 1 2 5\nf 1 2 7\nf 1 2 6\nv 1 1 1\n", MeshFormat::obj, "t:5", "7 of 4"));
  for (const std::string_view line : {"Kd 1 x 0", "Ns secret", "illum 1.5", "d"})
    EXPECT_TRUE(refused("mtllib m.mtl\n" + vertices + "f 1 2 3\n", MeshFormat::obj, "m.mtl:2", "expected",
                        "newmtl secret\n" + std::string(line) + "\n"));
}

// --- PLY ---------------------------------------------------------------------------------------------------

struct PlyProperty {
  std::string name, type;
};
struct PlyElement {
  std::string name;
  std::vector<PlyProperty> properties;
  std::size_t count;
};

// One number as text and in both byte orders.
struct Bodies {
  std::string text{}, little{}, big{};

  void add(double value, const std::string& type) {
    text += fmt::format("{} ", value);
    for (const bool is_big : {false, true}) {
      std::string& bytes = is_big ? big : little;
      if (type == "char" || type == "int8") append(bytes, static_cast<std::int8_t>(value), is_big);
      if (type == "uchar" || type == "uint8") append(bytes, static_cast<std::uint8_t>(value), is_big);
      if (type == "short" || type == "int16") append(bytes, static_cast<std::int16_t>(value), is_big);
      if (type == "ushort" || type == "uint16") append(bytes, static_cast<std::uint16_t>(value), is_big);
      if (type == "int" || type == "int32") append(bytes, static_cast<std::int32_t>(value), is_big);
      if (type == "uint" || type == "uint32") append(bytes, static_cast<std::uint32_t>(value), is_big);
      if (type == "int64") append(bytes, static_cast<std::int64_t>(value), is_big);
      if (type == "uint64") append(bytes, static_cast<std::uint64_t>(value), is_big);
      if (type == "float" || type == "float32") append(bytes, static_cast<float>(value), is_big);
      if (type == "double" || type == "float64") append(bytes, value, is_big);
    }
  }
};

TEST_F(MeshFiles, PlyIsTheSameWhateverItsPropertiesAndElements) {
  const std::vector<std::string> whole{"char",   "int8", "uchar", "uint8", "short",  "int16", "ushort",
                                       "uint16", "int",  "int32", "uint",  "uint32", "int64", "uint64"};
  std::vector<std::string> types = whole;
  types.insert(types.end(), {"float", "float32", "double", "float64"});
  const auto of = [&](const std::vector<std::string>& all) { return all[chance_.index(all.size())]; };
  for (int i = 0; i < 200; ++i) {
    const PolygonMesh mesh = random_mesh(chance_, 6, [&] { return double{1.0 * chance_.whole(0, 100)}; });
    std::vector<PlyProperty> vertex{{"x", of(types)}, {"y", of(types)}, {"z", of(types)}};
    for (const char* const other : {"quality", "list a", "nx", "list b"})
      if (chance_.whole(0, 1) == 1) vertex.push_back({other, of(types)});
    std::vector<PlyProperty> face{
        {chance_.whole(0, 1) == 1 ? "list vertex_indices" : "list vertex_index", of(whole)}};
    for (const char* const other : {"flags", "list texcoord"})
      if (chance_.whole(0, 1) == 1) face.push_back({other, of(types)});
    std::ranges::shuffle(vertex, chance_.engine());
    std::ranges::shuffle(face, chance_.engine());
    std::vector<PlyElement> elements{{"vertex", vertex, mesh.vertices.size()},
                                     {"face", face, mesh.faces.size()},
                                     {"edge", {{"a", of(types)}}, 3}};
    std::ranges::shuffle(elements, chance_.engine());

    std::string header;
    Bodies bodies;
    for (const auto& [element, properties, count] : elements) {
      header += fmt::format("element {} {}\ncomment property int no\n", element, count);
      std::vector<std::string> lengths;
      for (const PlyProperty& property : properties) {
        const bool is_list = property.name.starts_with("list ");
        lengths.push_back(of(whole));
        header += is_list ? fmt::format("property list {} {} {}\n", lengths.back(), property.type,
                                        property.name.substr(5))
                          : fmt::format("property {} {}\n", property.type, property.name);
      }
      for (std::size_t k = 0; k < count; ++k) {
        for (std::size_t p = 0; p < properties.size(); ++p) {
          const auto& [property, type] = properties[p];
          const auto add_list = [&](const auto& values) {
            bodies.add(static_cast<double>(values.size()), lengths[p]);
            for (const auto value : values)
              bodies.add(value, type);
          };
          if (property.starts_with("list vertex_ind"))
            add_list(mesh.faces[k]);
          else if (property.starts_with("list "))
            add_list(std::vector<int>(static_cast<std::size_t>(chance_.whole(0, 3)), 7));
          else if (property == "x" || property == "y" || property == "z")
            bodies.add(mesh.vertices[k][property[0] - 'x'], type);
          else
            bodies.add(chance_.whole(0, 100), type);
        }
        bodies.text += chance_.whole(0, 9) == 0 ? "\r\n\n" : "\n";
      }
    }
    const std::string end = chance_.whole(0, 1) == 1 ? "obj_info x\nend_header\r\n" : "end_header\n";
    for (const auto& [format, body] : {std::pair{"ply\nformat ascii 1.0\n", bodies.text},
                                       {"PLY\r\nformat binary_little_endian 1.0\n", bodies.little},
                                       {"ply\ncomment c\nformat binary_big_endian 1.0\n", bodies.big}})
      EXPECT_EQ(corners_of(parse(format + header + end + body, MeshFormat::ply)), corners_of(mesh));
  }
}

TEST_F(MeshFiles, WrongPlyFilesAreRefused) {
  const std::string good = ply_of(one_face); // its header has 8 lines
  EXPECT_EQ(scene(good, MeshFormat::ply).triangles.size(), 1U);
  const auto changed = [&](const std::string& from, const std::string& to) {
    return with_changed(good, from, to);
  };
  const auto is = [](const std::string& text, const std::string& place, const std::string& says) {
    return refused(text, MeshFormat::ply, place, says);
  };
  EXPECT_TRUE(is("", "t:1", "isn't a PLY"));
  EXPECT_TRUE(is("plyx\n", "t:1", "isn't a PLY"));
  EXPECT_TRUE(is(changed("ascii 1.0", "ascii 2.0"), "t:2", "convert"));
  EXPECT_TRUE(is(changed("format ascii 1.0\n", ""), "t:8", "format"));
  EXPECT_TRUE(is(changed("vertex 3", "vertex x"), "t:3", "'x'"));
  EXPECT_TRUE(is(changed("vertex 3", "vertex -3"), "t:3", "element"));
  EXPECT_TRUE(is(changed("property double x", "property quad x"), "t:4", "'quad'"));
  EXPECT_TRUE(is(changed("property double x", "property double"), "t:4", "property"));
  EXPECT_TRUE(is(changed("property double z", "property double w"), "t:9", "lack x, y or z"));
  EXPECT_TRUE(is(changed("element vertex 3\n", ""), "t:3", "no element"));
  EXPECT_TRUE(is(changed("list uchar int", "list float int"), "t:8", "length"));
  EXPECT_TRUE(is(changed("list uchar int", "list uchar float"), "t:8", "whole"));
  EXPECT_TRUE(is(changed("vertex_index", "corners"), "t:9", "vertex_indices"));
  EXPECT_TRUE(is(changed("element face", "element tristrips"), "t:7", "strips"));
  EXPECT_TRUE(is(changed("element face", "element vertex"), "t:7", "second time"));
  EXPECT_TRUE(is(changed("end_header\n", ""), "t:12", "end_header"));
  EXPECT_TRUE(is(changed("vertex 3", "vertex 4"), "t:13", "more numbers"));
  EXPECT_TRUE(is(changed("vertex 3", "vertex 2"), "t:12", "vertex 2 of 2"));
  EXPECT_TRUE(is(changed("face 1", "face 2"), "t:13", "face 1 of 2"));
  EXPECT_TRUE(is(changed("face 1", "face 0"), "t:13", "after the last"));
  EXPECT_TRUE(is(good + "3 0 1 2\n", "t:14", "after the last"));
  EXPECT_TRUE(is(changed("3 0 1 2", "3 0 1 3"), "t:13", "vertex 3 of 3"));
  EXPECT_TRUE(is(changed("3 0 1 2", "3 0 1 -1"), "t:13", "vertex -1 of 3"));
  EXPECT_TRUE(is(changed("3 0 1 2", "3 0 1 1.5"), "t:13", "vertex 1.5 of 3"));
  EXPECT_TRUE(is(changed("3 0 1 2", "3 0 1 nan"), "t:13", "vertex nan of 3"));
  EXPECT_TRUE(is(changed("3 0 1 2", "3 0 1"), "t:13", "ends"));
  EXPECT_TRUE(is(changed("3 0 1 2", "3 0 1 2 2"), "t:13", "more numbers"));
  EXPECT_TRUE(is(changed("3 0 1 2", "-3 0 1 2"), "t:13", "length"));
  EXPECT_TRUE(is(changed("2 2 0", "2 2"), "t:12", "ends"));
  EXPECT_TRUE(is(changed("2 2 0", "2 2 0 0"), "t:12", "more numbers"));
  EXPECT_TRUE(is(changed("2 2 0", "2 2 O"), "t:12", "'O'"));
  std::string binary = binary_ply_of<double>(one_face, false);
  binary[binary.size() - 4] = 3;
  EXPECT_TRUE(is(binary, "t", "vertex 3 of 3"));
  EXPECT_EQ(parse(binary_ply_of<double>(one_face, true) + "ab", MeshFormat::ply).notes.trailing_bytes, 2U);
}

// --- OFF ---------------------------------------------------------------------------------------------------

TEST_F(MeshFiles, OffIsTheSameHoweverItIsWritten) {
  for (const std::string_view text :
       {"OFF\n3 1 0\n0 0 0\n2 0 .5\n2 2 0\n3 0 1 2\n", "OFF 3 1 0\n0 0 0\n2 0 .5\n2 2 0\n3 0 1 2 255 0 0",
        "3 1\n0 0 0\n2 0 .5\n2 2 0\n3 0 1 2 0.5 0.5 0.5 1\n", "OFF\n3\n1 0\n0 0 0\n2 0 .5\n2 2 0\n3 0 1 2\n",
        "OFF # file written by CGAL\n# in four\n\n3 1 0\n\n# 3 vertices\n# ---\n\n0 0 0# a\n2 0 .5\n# b\n2 2 "
        "0\n"
        "\n# 1 facets\n# ---\n#f\n3  0 1 2\n\n# End of OFF #\n",
        "\xef\xbb\xbfOFF\r\n3 1 0\r\n0 0 0\r\n2 0 .5\r\n2 2 0\r\n3 0 1 2\r\n",
        "NOFF\n3 1 0\n0 0 0 0 0 1\n2 0 .5 0 0 1\n2 2 0 0 0 1\n3 0 1 2\n",
        "4OFF\n3 1 0\n0 0 0 1\n4 0 1 2\n1 1 0 .5\n3 0 1 2\n",
        "STCN4OFF\n3 1 0\n0 0 0 1 0 0 1 1 0 0 1 0 0\n4 0 1 2 0 0 1 1 0 0 1 0 0\n2 2 0 1 0 0 1 1 0 0 1 0 0\n3 "
        "0 1 2\n"})
    EXPECT_EQ(corners_of(parse(text, MeshFormat::off)), corners_of(one_face)) << text;
  // Colours up to 1, and up to 255.
  for (const std::string_view text :
       {"COFF\n3 1 0\n0 0 0 1 0 0 1\n2 0 .5 1 0 0 1\n2 2 0 1 0 0 1\n3 0 1 2\n",
        "COFF\n3 1 0\n0 0 0 255 0 0 255\n2 0 .5 255 0 0 9\n2 2 0 255 0 0 9\n3 0 1 2\n"})
    EXPECT_EQ(scene(text, MeshFormat::off).materials.at(0).color, (Vec3f{1, 0, 0}));
  std::string large = "OFF\n12 1 0\n";
  for (int i = 0; i < 12; ++i)
    large += fmt::format("{} {} 0\n", std::cos(0.5 * i), std::sin(0.5 * i));
  EXPECT_EQ(scene(large + "12 0 1 2 3 4 5 6 7 8 9 10 11\n", MeshFormat::off).triangles.size(), 10U);
}

TEST_F(MeshFiles, WrongOffFilesAreRefused) {
  const auto is = [](const std::string& text, const std::string& place, const std::string& says) {
    return refused(text, MeshFormat::off, place, says);
  };
  const std::string vertices = "0 0 0\n2 0 .5\n2 2 0\n";
  EXPECT_TRUE(is("", "t:1", "isn't an OFF"));
  EXPECT_TRUE(is("off\n", "t:1", "isn't an OFF"));
  EXPECT_TRUE(is("nOFF\n4\n", "t:1", "isn't an OFF"));
  EXPECT_TRUE(is("OFF BINARY\n", "t:1", "binary"));
  EXPECT_TRUE(is("OFF\n", "t:1", "number of vertices"));
  EXPECT_TRUE(is("OFF\n3 x 0\n", "t:2", "'x'"));
  EXPECT_TRUE(is("OFF\n-3 1 0\n", "t:2", "2^32"));
  EXPECT_TRUE(is("OFF\n4 1 0\n" + vertices + "3 0 1 2\n", "t:6", "face 0 of 1"));
  EXPECT_TRUE(is("OFF\n3 2 0\n" + vertices + "3 0 1 2\n", "t:6", "face 1 of 2"));
  EXPECT_TRUE(is("OFF\n3 2 0\n" + vertices + "3 0 1 2\n# 3 0 1 2\n", "t:7", "face 1 of 2"));
  EXPECT_TRUE(is("OFF\n3 1 0\n" + vertices + "3 0 1 2\n3 0 1 2\n", "t:7", "after the last"));
  EXPECT_TRUE(is("OFF\n3 1 0\n" + vertices + "3 0 1 3\n", "t:6", "vertex 3 of 3"));
  EXPECT_TRUE(is("OFF\n3 1 0\n" + vertices + "3 0 1 -1\n", "t:6", "vertex -1 of 3"));
  EXPECT_TRUE(is("OFF\n3 1 0\n" + vertices + "3 0 1\n", "t:6", "ends"));
  EXPECT_TRUE(is("OFF\n3 1 0\n0 0\n2 0 0\n2 2 0\n3 0 1 2\n", "t:3", "ends"));
  EXPECT_TRUE(is("4OFF\n1 0 0\n0 0 0 0\n", "t:3", "is 0"));
}

// --- STL ---------------------------------------------------------------------------------------------------

TEST_F(MeshFiles, StlIsTheSameHoweverItIsWritten) {
  std::string upper = stl_of(one_face), one_line = stl_of(one_face).substr(8);
  for (char& c : upper)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 32);
  std::ranges::replace(one_line, '\n', ' ');
  for (const std::string& text :
       {stl_of(one_face), upper, "\n  Solid\n" + one_line, "\xef\xbb\xbf" + stl_of(one_face),
        binary_stl_of(one_face), binary_stl_of(one_face, "solid of a program that writes binary files"),
        binary_stl_of(one_face, "Solid") + "\n", binary_stl_of(one_face) + std::string(51, ' ')})
    EXPECT_EQ(corners_of(parse(text, MeshFormat::stl)), corners_of(one_face)) << text;
  EXPECT_EQ(parse(binary_stl_of(one_face) + std::string(51, ' '), MeshFormat::stl).notes.trailing_bytes, 51U);
  const ImportedScene two = viewed_scene_of(
      parse(stl_of(one_face) + "solid empty\nendsolid\n" + upper, MeshFormat::stl), own_name, {});
  EXPECT_EQ(two.object_names, (std::vector<std::string>{"t", "T"}));
  EXPECT_EQ(two.scene.triangles.size(), 2U);
  EXPECT_EQ(two.scene.triangles[1].object, 1U);
}

TEST_F(MeshFiles, FacetsOfABinaryStlHaveColors) {
  PolygonMesh mesh = one_face;
  mesh.faces.push_back({0, 1, 2});
  for (const bool is_magics : {false, true}) {
    std::string bytes = binary_stl_of(mesh, is_magics ? std::string("COLOR=\xff\x33\x00\xff", 10) : "");
    bytes[bytes.size() - 2] = 31;
    bytes[bytes.size() - 1] = '\x80';
    const Scene colored = scene(bytes, MeshFormat::stl);
    ASSERT_EQ(colored.materials.size(), 2U);
    EXPECT_EQ(colored.materials[1].color, is_magics ? (Vec3f{1, 0, 0}) : (Vec3f{0, 0, 1}));
    EXPECT_NEAR(colored.materials[0].color.x, is_magics ? 1 : 0.6, 1.0 / 126);
  }
}

TEST_F(MeshFiles, WrongStlFilesAreRefused) {
  const std::string good = stl_of(one_face);
  const auto changed = [&](const std::string& from, const std::string& to) {
    return with_changed(good, from, to);
  };
  const auto is = [](const std::string& text, const std::string& place, const std::string& says) {
    return refused(text, MeshFormat::stl, place, says);
  };
  EXPECT_TRUE(is("", "t", "isn't an STL"));
  EXPECT_TRUE(is("not a mesh", "t", "isn't an STL"));
  EXPECT_TRUE(is(changed("endloop", ""), "t:8", "'endfacet' where endloop"));
  EXPECT_TRUE(is(changed(" endloop", "  vertex 1 1 1\n endloop"), "t:7", "'vertex' where endloop"));
  EXPECT_TRUE(is(changed("  vertex 0 0 0\n", ""), "t:6", "'endloop' where vertex"));
  EXPECT_TRUE(is(changed("vertex 2 2 0", "vertex 2 2 0e"), "t:6", "'0e'"));
  EXPECT_TRUE(is(changed("vertex 2 2 0", "vertex 2 2"), "t:7", "'endloop' where a coordinate"));
  EXPECT_TRUE(is(changed("endsolid", "color 1"), "t:9", "'color' where facet or endsolid"));
  EXPECT_TRUE(is(changed("endsolid t\n", ""), "t:8", "ends where facet or endsolid"));
  EXPECT_TRUE(is(good + "rest\n", "t:10", "'rest' where solid"));
  std::string more = binary_stl_of(one_face);
  more[80] = 2;
  EXPECT_TRUE(is(more, "t", "promises 2 facets, and 1 are there"));
}

// --- All formats -------------------------------------------------------------------------------------------

// However little is cut from a file that says how much it holds.
TEST_F(MeshFiles, CutFilesAreRefused) {
  for (const auto& [text, format] :
       {std::pair{off_of(one_face), MeshFormat::off},
        {ply_of(one_face), MeshFormat::ply},
        {binary_ply_of<float>(one_face, false), MeshFormat::ply},
        {binary_ply_of<double>(one_face, true), MeshFormat::ply},
        {stl_of(one_face).substr(0, stl_of(one_face).size() - 3), MeshFormat::stl},
        {binary_stl_of(one_face), MeshFormat::stl}}) {
    EXPECT_EQ(scene(text, format).triangles.size(), 1U);
    const std::size_t last = text.find_last_not_of('\n'); // of text
    for (std::size_t size = 0; size < (text.back() == '\n' ? last : text.size()); ++size) {
      try {
        static_cast<void>(scene(text.substr(0, size), format));
        ADD_FAILURE() << size << " of " << text.size() << " bytes were taken of " << text;
      } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::input);
      }
    }
  }
}

TEST_F(MeshFiles, ErrorsRepeatAWordsBeginningAtMost) {
  const std::string word(1 << 20, 'y'), secret = "root:x:0:0";
  for (const auto& [text, format] :
       {std::pair{"v 0 0 " + word, MeshFormat::obj},
        {"f " + word, MeshFormat::obj},
        {word, MeshFormat::stl},
        {"solid " + word + "\n" + word, MeshFormat::stl},
        {word, MeshFormat::off},
        {"OFF " + word, MeshFormat::off},
        {"ply\nformat " + word + "\n", MeshFormat::ply},
        {"ply\nformat ascii 1.0\nelement " + word + " 3\nproperty int a\nend_header\n", MeshFormat::ply},
        {"mtllib m.mtl\n", MeshFormat::obj}}) {
    try {
      static_cast<void>(scene(text, format, "newmtl " + secret + "\nKd " + secret + "\n"));
      ADD_FAILURE() << "was taken: " << text.substr(0, 40);
    } catch (const Error& error) {
      EXPECT_LT(error.text().size(), 200U);
      EXPECT_EQ(error.text().find(secret), std::string::npos) << error.text();
    }
  }
}

TEST_F(MeshFiles, TheFormatIsThatOfTheNameOrOfTheBeginning) {
  EXPECT_EQ(format_of_name("OBJ"), MeshFormat::obj);
  EXPECT_EQ(format_of_name("Ply"), MeshFormat::ply);
  EXPECT_EQ(format_of_name("gltf"), std::nullopt);
  EXPECT_EQ(format_of_name(""), std::nullopt);
  EXPECT_EQ(format_of_content(ply_of(one_face)), MeshFormat::ply);
  EXPECT_EQ(format_of_content("# a\r\n#\n" + obj_of(one_face)), MeshFormat::obj);
  EXPECT_EQ(format_of_content("\n# a\n" + off_of(one_face)), MeshFormat::off);
  EXPECT_EQ(format_of_content("NOFF\n"), MeshFormat::off);
  EXPECT_EQ(format_of_content(stl_of(one_face)), MeshFormat::stl);
  for (const std::string_view text : {"", "#", "# a\n", "{\"asset\"", "vertex", "<xml>"})
    EXPECT_EQ(format_of_content(text), std::nullopt) << text;
}

} // namespace
} // namespace masu
