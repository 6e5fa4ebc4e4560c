// End-to-end runs of mesh2bin.
#include "tests/run_tool.h"

#include <cstring>

namespace masu {
namespace {

class Mesh2bin : public ToolTest {
protected:
  std::string mesh(const std::string& name, std::string_view text) const {
    write_text(file(name), text);
    return file(name);
  }
  // The t of the hits of a list of rays; the records also hold the object.
  std::vector<float> distances(const std::string& name, const std::string& scene) const {
    const std::string rays = file("rays"), hits = file("hits");
    std::vector<float> list;
    for (int i = 0; i < 32; ++i)
      for (int j = 0; j < 32; ++j)
        list.insert(list.end(),
                    {static_cast<float>(i) / 8 - 2, static_cast<float>(j) / 8 - 2, 5, 0.125F, 0.25F, -1});
    write_bytes(rays, {reinterpret_cast<const std::uint8_t*>(list.data()), 4 * list.size()});
    EXPECT_TRUE(succeeded(
        run("gridrender", {scene, grid(name, scene), "--backend", "cpu", "--rays", rays, "--hits", hits})));
    const Bytes bytes = read_bytes(hits);
    std::vector<float> result(bytes.size() / 8);
    for (std::size_t i = 0; i < result.size(); ++i)
      std::memcpy(&result[i], bytes.data() + 8 * i, sizeof(float));
    return result;
  }
};

constexpr std::string_view polygons_nff =
    "p 5\n-1.5 -1.25 0\n1.5 -1.5 0.25\n0.25 0 0\n1.5 1.75 -0.25\n-1.25 1.5 0\np 3\n0 0 1\n1 0 1.5\n0 1 1\n";
constexpr std::string_view polygons_obj = "v -1.5 -1.25 0\nv 1.5 -1.5 0.25\nv 0.25 0 0\nv 1.5 1.75 -0.25\nv "
                                          "-1.25 1.5 0\nv 0 0 1\nv 1 0 1.5\nv 0 1 1\n"
                                          "f 1 2 3 4 5\nf 6 7 8\n";

TEST_F(Mesh2bin, AnObjHasTheSameHitsAsTheSamePolygonsInNff) {
  const std::string obj = mesh("a.obj", polygons_obj), converted = file("obj.scene");
  ASSERT_TRUE(succeeded(run("mesh2bin", {obj, "-o", converted})));
  const std::vector<float> expected = distances("nff.grid", scene("nff.scene", nff("a.nff", polygons_nff)));
  EXPECT_EQ(distances("obj.grid", converted), expected);
  EXPECT_EQ(expected.size(), 1024U);
}

TEST_F(Mesh2bin, WarnsOfWhatItLeavesOut) {
  const std::string obj = mesh("a.obj", std::string(polygons_obj) + "l 1 2\n");
  const ToolResult result = run("mesh2bin", {obj, "-o", file("a.scene")});
  EXPECT_EQ(result.code, 0);
  EXPECT_EQ(result.err, "mesh2bin: " + obj + ": warning: 1 point(s) and line(s) left out\n");
}

TEST_F(Mesh2bin, ReportsAndNamesTheObjects) {
  const std::string obj = mesh("a.obj", "o first\n" + std::string(polygons_obj) + "o second\nf 1 2 3\n");
  const ToolResult info = run("mesh2bin", {obj, "-o", file("a.scene"), "--info", "--objects", file("names")});
  EXPECT_TRUE(succeeded(info));
  EXPECT_NE(info.out.find("objects      2: polygons 2,"), std::string::npos) << info.out;
  EXPECT_EQ(read_text(file("names")), "first\nsecond\n");
  EXPECT_EQ(run("mesh2bin", {obj, "--objects", "-"}).out, "first\nsecond\n");
}

TEST_F(Mesh2bin, RefusesWhatAssimpCantReadWithItsMessage) {
  EXPECT_TRUE(failed(run("mesh2bin", {file("none.ply"), "-o", file("a.scene")}), 2, "mesh2bin",
                     file("none.ply"), "opened"));
  const std::string text = mesh("a.text", "not a mesh");
  EXPECT_TRUE(
      failed(run("mesh2bin", {text, "-o", file("a.scene")}), 2, "mesh2bin", text, "No suitable reader"));
  EXPECT_TRUE(failed(run("mesh2bin", {text, "-o", text}), 1, "mesh2bin", text, "input"));
  EXPECT_TRUE(
      failed(run("mesh2bin", {text, "-o", file("a.scene"), "--size", "0x3"}), 1, "mesh2bin", "--size"));
  EXPECT_EQ(folder_.listing(), std::vector<std::string>{"a.text"});
}

// Nodes nested this deep overflow Assimp's stack.
TEST_F(Mesh2bin, ReportsThatAssimpCrashed) {
  std::string gltf = R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[)";
  constexpr int depth = 200000;
  for (int i = 1; i < depth; ++i)
    gltf += "{\"children\":[" + std::to_string(i) + "]},";
  const std::string path = mesh("a.gltf", gltf + "{}]}");
  EXPECT_TRUE(failed(run("mesh2bin", {path, "-o", file("a.scene")}), 2, "mesh2bin", path));
  EXPECT_EQ(folder_.listing(), std::vector<std::string>{"a.gltf"});
}

} // namespace
} // namespace masu
