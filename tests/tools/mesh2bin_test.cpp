// End-to-end runs of mesh2bin.
#include "tests/tools/run_tool.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>

#include <chrono>
#include <csignal>
#include <set>
#include <thread>

namespace masu {
namespace {

class Mesh2bin : public ToolTest {
protected:
  std::string mesh(const std::string& name, std::string_view text) const {
    write_text(file(name), text);
    return file(name);
  }
};

constexpr std::string_view polygons_obj = "v -1.5 -1.25 0\nv 1.5 -1.5 0.25\nv 0.25 0 0\nv 1.5 1.75 -0.25\nv "
                                          "-1.25 1.5 0\nv 0 0 1\nv 1 0 1.5\nv 0 1 1\n"
                                          "f 1 2 3 4 5\nf 6 7 8\n";

TEST_F(Mesh2bin, WarnsOfWhatItLeavesOut) {
  const std::string obj = mesh("a.obj", std::string(polygons_obj) + "l 1 2\n");
  const ToolResult result = run("mesh2bin", {obj, "-o", file("a.scene")});
  EXPECT_EQ(result.code, 0);
  EXPECT_EQ(result.err, "mesh2bin: " + obj + ": warning: 1 point(s) and line(s) left out\n");
}

TEST_F(Mesh2bin, WarnsOfWhatItPassesOver) {
  const std::string obj = mesh("a.obj", "mtllib none.mtl\n" + std::string(polygons_obj) + "surf 1\n");
  EXPECT_EQ(run("mesh2bin", {obj, "-o", file("a.scene")}).err,
            "mesh2bin: " + obj +
                ": warning: 1 line(s) left out that are no polygons, groups or materials of an OBJ\n" +
                "mesh2bin: " + obj + ": warning: 1 material file(s) not found: what they describe is grey\n");
  std::string facet(84 + 50, '\0');
  facet[80] = 1;
  facet[84 + 27] = facet[84 + 43] = 1; // parts of two coordinates
  facet[84 + 26] = facet[84 + 42] = 1;
  const std::string stl = mesh("a.stl", facet + "\n");
  EXPECT_NE(run("mesh2bin", {stl, "-o", file("a.scene")}).err.find("1 byte(s) after the last face"),
            std::string::npos);
}

TEST_F(Mesh2bin, RepeatsLittleOfWhatItReadsAndNothingOfOtherFiles) {
  const std::string secret = "password";
  mesh("a.mtl", "newmtl m\nKd " + secret + "\n");
  const std::string obj = mesh("a.obj", "mtllib a.mtl\n" + std::string(polygons_obj));
  const ToolResult refused = run("mesh2bin", {obj, "-o", file("a.scene")});
  EXPECT_TRUE(failed(refused, 2, "mesh2bin", "a.mtl:2"));
  EXPECT_EQ(refused.err.find(secret), std::string::npos) << refused.err;
  const std::string line(1 << 20, 'y');
  for (const std::string& path :
       {mesh("b.gltf", R"({"asset":{"version":")" + line + "\"}}"), mesh("b.stl", "solid\n" + line)}) {
    const ToolResult result = run("mesh2bin", {path, "-o", file("a.scene")});
    EXPECT_EQ(result.code, 2);
    EXPECT_LT(result.err.size(), path.size() + 300) << result.err.substr(0, 400);
  }
}

// Its lines count as a file where they are held back.
TEST_F(Mesh2bin, EndsWithALineWhereNoFileMayBeWritten) {
  const std::string obj = mesh("a.obj", "v 0 0 x\n");
  const ToolResult result =
      run("/bin/sh", {"-c", "(ulimit -f 0; \"$0\" \"$@\" 2>&1) | cat",
                      std::string(MASU_BIN_DIR) + "/mesh2bin", obj, "-o", file("a.scene")});
  EXPECT_EQ(result.out, "mesh2bin: " + obj + ":1: 'x' where a coordinate is expected: correct it\n");
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
  EXPECT_TRUE(fails(2, "mesh2bin", {file("none.ply"), "-o", file("a.scene")}, file("none.ply"), "opened"));
  const std::string text = mesh("a.text", "not a mesh");
  EXPECT_TRUE(fails(2, "mesh2bin", {text, "-o", file("a.scene")}, text, "No suitable reader"));
  EXPECT_TRUE(fails(1, "mesh2bin", {text, "-o", text}, text, "input"));
  EXPECT_TRUE(fails(1, "mesh2bin", {text, "-o", file("a.scene"), "--size", "0x3"}, "--size"));
  EXPECT_EQ(folder_.listing(), std::vector<std::string>{"a.text"});
}

// --- Digits ---------------------------------------------------------------------------------------------

// Squares of 0.3 at the place of a town in UTM coordinates.
TEST_F(Mesh2bin, KeepsATownsDigits) {
  std::string text;
  for (int j = 0; j <= 20; ++j)
    for (int i = 0; i <= 20; ++i)
      text +=
          fmt::format("v {:.1f} {:.1f} {:.1f}\n", 500000 + 0.3 * i, 5400000 + 0.3 * j, 200 + 0.1 * (i % 3));
  for (int j = 0; j < 20; ++j)
    for (int i = 0; i < 20; ++i)
      text +=
          fmt::format("f {} {} {} {}\n", 21 * j + i + 1, 21 * j + i + 2, 21 * j + i + 23, 21 * j + i + 22);
  const std::string obj = mesh("a.obj", text);
  for (const std::string store : {"float32", "float64"}) {
    const ToolResult made =
        run("mesh2bin", {obj, "-o", file("a.scene"), "--store", store, "--info", "--json"});
    EXPECT_EQ(made.err, "");
    const auto box = nlohmann::json::parse(made.out)["bounds"];
    const std::vector<double> expected{500000, 5400000, 200, 500006, 5400006, 200.2};
    for (std::size_t i = 0; i < 6; ++i)
      EXPECT_NEAR(box[i < 3 ? "min" : "max"][i % 3].get<double>(), expected[i], 1e-5);
  }
}

// Of a format without a reader of our own.
TEST_F(Mesh2bin, WarnsWhereFloat32IsTooCoarse) {
  const std::string far_away = mesh("a.raw", "5400000 0 0 5400001 0 0 5400000 1 0\n"),
                    near = mesh("b.raw", "54 0 0 55 0 0 54 1 0\n");
  EXPECT_EQ(run("mesh2bin", {far_away, "-o", file("a.scene")}).err,
            "mesh2bin: " + far_away +
                ": warning: Assimp reads this format in float32: coordinates are off by up to 0.32; convert "
                "it to PLY "
                "or OBJ, which are read with all digits\n");
  EXPECT_EQ(run("mesh2bin", {near, "-o", file("b.scene")}).err, "");
}

// --- Numbers of faces -------------------------------------------------------------------------------------

// Two faces side by side in each of two objects, seen from above; before, between and after them faces
// without area. Of triangles, or of squares.
std::string faces_obj(bool squares) {
  std::string text = "v 0 0 0\nv 1 1 1\nv 2 2 2\n";
  for (int x = 0; x < 8; x += 2)
    text += fmt::format("v {0} 0 0\nv {1} 0 0\nv {1} 1 0\nv {0} 1 0\n", x, x + 1);
  const auto face = [&](int first) {
    return squares ? fmt::format("f {} {} {} {}\n", first, first + 1, first + 2, first + 3)
                   : fmt::format("f {} {} {}\n", first, first + 1, first + 2);
  };
  const std::string no_area = "f 1 2 1\n";
  return text + "o first\n" + no_area + face(4) + no_area + face(8) + "l 1 2\no second\n" + no_area +
         face(12) + face(16) + no_area;
}

TEST_F(Mesh2bin, HitsNameTheFilesFaces) {
  const std::vector<std::int32_t> faces{1, 3, 5, 6}, objects{0, 0, 1, 1};
  std::vector<float> list;
  for (int x = 0; x < 4; ++x)
    list.insert(list.end(), {static_cast<float>(2 * x) + 0.75F, 0.25F, 5, 0, 0, -1});
  list.insert(list.end(), {0, 9, 5, 0, 0, -1}); // hits nothing
  write_records(file("rays"), list);
  for (const bool squares : {false, true}) {
    SCOPED_TRACE(squares ? "squares" : "triangles");
    const std::string obj = mesh("a.obj", faces_obj(squares)), scene = file("a.scene");
    const ToolResult made = run("mesh2bin", {obj, "-o", scene, "--info", "--json"});
    ASSERT_EQ(made.code, 0) << made.err;
    const auto info = nlohmann::json::parse(made.out);
    EXPECT_EQ(info["primitives"]["triangles"], squares ? 12 : 8);
    EXPECT_EQ(info["face_numbers"], squares ? 12 : 0); // which are stored where they aren't the triangles'
    const std::string divided = grid("a.grid", scene);
    const auto traced = [&](const std::string& tool, const Arguments& more) {
      expect_run(tool, joined({scene, divided, "--backend", "cpu"}, more));
      return read_records<std::int32_t>(file("hits"));
    };
    const auto both = traced("gridtrace", words("~/rays -o ~/hits --write face,object"));
    const auto named = traced("gridtrace", words("~/rays -o ~/hits --hit-name face")); // t, face
    const auto primitives = traced("gridtrace", words("~/rays -o ~/hits --write primitive"));
    ASSERT_EQ(both.size(), 10U);
    ASSERT_EQ(named.size(), 10U);
    for (std::size_t i = 0; i < faces.size(); ++i) {
      EXPECT_EQ(both[2 * i], faces[i]);
      EXPECT_EQ(both[2 * i + 1], objects[i]);
      EXPECT_EQ(named[2 * i + 1], faces[i]);
      EXPECT_TRUE(squares || primitives[i] == faces[i]);
    }
    EXPECT_EQ(both[8], -1);
    EXPECT_EQ(named[9], -1);
    // A picture's hits.
    const Arguments view = words("--hits ~/hits --from 3.5,0.5,9 --at 3.5,0.5,0 --up 0,1,0 --size 64x64");
    const auto seen = traced("gridrender", joined(view, {"--hit-name", "face"})),
               of_object = traced("gridrender", view);
    ASSERT_EQ(seen.size(), of_object.size());
    std::set<std::int32_t> all;
    for (std::size_t i = 1; i < seen.size(); i += 2) {
      all.insert(seen[i]);
      EXPECT_EQ(of_object[i], seen[i] < 0 ? -1 : seen[i] < 5 ? 0 : 1);
    }
    EXPECT_EQ(all, (std::set<std::int32_t>{-1, 1, 3, 5, 6}));
  }
}

// --- Files that a mesh refers to --------------------------------------------------------------------------

TEST_F(Mesh2bin, WritesOverNothingThatItsMeshRefersTo) {
  const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n", materials = "newmtl m\nKd 1 0 0\n";
  const std::string obj = mesh("a.obj", "mtllib a.mtl\n" + triangle + "usemtl m\nf 1 2 3\n"),
                    mtl = mesh("a.mtl", materials), link = file("link");
  ASSERT_EQ(symlink("a.mtl", link.c_str()), 0);
  std::string buffer(36, '\0');
  buffer[14] = buffer[30] = '\x80'; // 1.0 at 12 and 28
  buffer[15] = buffer[31] = '\x3f';
  const std::string bin = mesh("g.bin", buffer);
  const std::string gltf =
      mesh("g.gltf",
           R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],)"
           R"("meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],)"
           R"("accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}],)"
           R"("bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{"uri":"g.bin","byteLength":36}]})");
  ASSERT_EQ(run("mesh2bin", {gltf, "-o", file("g.scene")}).code, 0); // it is valid
  const auto refused = [&](const Arguments& arguments, const std::string& output, const std::string& input) {
    return failed(run("mesh2bin", arguments), 1, "mesh2bin", output, "is the input " + input);
  };
  EXPECT_TRUE(refused({obj, "-o", mtl}, mtl, mtl));
  EXPECT_TRUE(refused({obj, "-o", link}, link, mtl));
  EXPECT_TRUE(refused({obj, "-o", file("a.scene"), "--objects", mtl}, mtl, mtl));
  EXPECT_TRUE(refused({gltf, "-o", bin}, bin, bin));
  EXPECT_EQ(read_text(mtl), materials);
  EXPECT_EQ(read_text(bin), buffer);
  EXPECT_EQ(folder_.listing(),
            (std::vector<std::string>{"a.mtl", "a.obj", "g.bin", "g.gltf", "g.scene", "link"}));
}

TEST_F(Mesh2bin, DoesntWaitForPipesThatItsMeshRefersTo) {
  const std::string obj = mesh("a.obj", "mtllib pipe.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  ASSERT_EQ(mkfifo(file("pipe.mtl").c_str(), 0600), 0);
  EXPECT_EQ(
      run("/usr/bin/timeout", {"20", std::string(MASU_BIN_DIR) + "/mesh2bin", obj, "-o", file("a.scene")})
          .code,
      0);
}

// --- What Assimp takes ------------------------------------------------------------------------------------

// A text that takes any release of Assimp many seconds: each of its 100,000 textures is looked for among
// those before.
std::string slow_raw() {
  std::string text;
  for (int i = 0; i < 100'000; ++i)
    text += fmt::format("0 0 0 1 0 0 0 1 0 t{}\n", i);
  return text;
}

TEST_F(Mesh2bin, EndsWhatTakesTooLong) {
  const std::string raw = mesh("a.raw", slow_raw());
  EXPECT_TRUE(fails(2, "mesh2bin", {raw, "-o", file("a.scene"), "--time-limit", "1"}, raw, "longer"));
  EXPECT_EQ(folder_.listing(), std::vector<std::string>{"a.raw"});
}

TEST_F(Mesh2bin, GivesLittleMemoryToASmallFile) {
  for (const auto& [format, line] : {std::pair{"binary_little_endian", ""}, {"ascii", ":11"}}) {
    const std::string ply =
        mesh("a.ply", std::string("ply\nformat ") + format +
                          " 1.0\nelement vertex 536870912\nproperty float x\nproperty float y\n"
                          "property float z\nelement face 1\nproperty list uchar int vertex_indices\n"
                          "end_header\n0 0 0\n0 0 0\n");
    EXPECT_TRUE(fails(2, "mesh2bin", {ply, "-o", file("a.scene")}, ply + line));
    rusage usage{};
    getrusage(RUSAGE_CHILDREN, &usage);
    EXPECT_LT(usage.ru_maxrss, 3 << 20); // KiB: of all children so far
  }
}

// A 3MF package that names a model which isn't in it: an assertion of Assimp's prints a line of its own.
TEST_F(Mesh2bin, PrintsOneLineWhateverAssimpPrints) {
  using namespace std::string_literals;
  const std::string
      name = "_rels/.rels",
      text = "<Relationships><Relationship Target=\"/n\" Id=\"r\" "
             "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>",
      // Date, checksum, both sizes and the name's length: of the archive's one file.
      entry = "!\0IB\xfc"s + "f\x85\0\0\0\x85\0\0\0\x0b\0\0\0"s;
  const std::string package =
      mesh("a.3mf", "PK\3\4\x14\0\0\0\0\0\0\0"s + entry + name + text + "PK\1\2\x14\0\x14\0\0\0\0\0\0\0"s +
                        entry + "\0\0\0\0\0\0\0\0\x80\1\0\0\0\0"s + name +
                        "PK\5\6\0\0\0\0\1\0\1\0\x39\0\0\0\xae\0\0\0\0\0"s);
  EXPECT_TRUE(fails(2, "mesh2bin", {package, "-o", file("a.scene")}, package));
}

// Where the loader can't even load the program, it says so with 127.
TEST_F(Mesh2bin, EndsWithALineWhereThereIsLittleMemory) {
  const std::string obj = mesh("a.obj", polygons_obj);
  for (int kilobytes = 18000; kilobytes < 60000; kilobytes += kilobytes < 30000 ? 250 : 2000) {
    const auto limited = [&](const Arguments& arguments) {
      return run("/bin/sh",
                 joined({"-c", fmt::format("ulimit -t 1; ulimit -v {}; exec \"$0\" \"$@\"", kilobytes),
                         std::string(MASU_BIN_DIR) + "/mesh2bin"},
                        arguments));
    };
    // Some releases of oneTBB crash before main() where they find too little memory; and wait for ever, using
    // the processor, of which they get 1 s here, where there is no memory to throw an exception with.
    if (limited({"--version"}).code < 0) continue;
    const ToolResult result = limited({obj, "-o", file("a.scene"), "--time-limit", "1"});
    SCOPED_TRACE(testing::Message() << kilobytes << " KiB: " << result.err);
    EXPECT_TRUE(result.code == 0 || result.code == 2 || result.code == 127) << result.code;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), result.code == 0 ? 0 : 1);
  }
}

TEST_F(Mesh2bin, IsEndedBySignalsWithTheProcessThatReads) {
  const std::string raw = mesh("a.raw", slow_raw());
  for (const int signal : {SIGTERM, SIGINT, SIGHUP, SIGKILL}) {
    const pid_t process = start("mesh2bin", {raw, "-o", file("a.scene"), "--time-limit", "60"});
    ASSERT_GT(process, 0);
    const std::string list =
        "/proc/" + std::to_string(process) + "/task/" + std::to_string(process) + "/children";
    std::string child;
    for (int i = 0; i < 2000 && child.empty(); ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
      child = read_text(list);
    }
    ASSERT_FALSE(child.empty()) << "no child process";
    kill(process, signal);
    int status = 0;
    ASSERT_EQ(waitpid(process, &status, 0), process);
    EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == signal) << signal;
    // Of a parent that was killed, the child ends a moment later.
    const std::string state = "/proc/" + std::to_string(std::stoi(child)) + "/stat";
    const auto runs = [&] {
      std::error_code gone;
      if (!std::filesystem::exists(state, gone)) return false;
      const std::string text = read_text(state);
      return !text.empty() && text.find(") Z ") == std::string::npos;
    };
    for (int i = 0; i < 2000 && runs(); ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    EXPECT_FALSE(runs()) << signal;
  }
  EXPECT_EQ(folder_.listing(), std::vector<std::string>{"a.raw"});
}

// Nodes nested this deep overflow Assimp's stack.
TEST_F(Mesh2bin, ReportsThatAssimpCrashed) {
  std::string gltf = R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[)";
  constexpr int depth = 200000;
  for (int i = 1; i < depth; ++i)
    gltf += "{\"children\":[" + std::to_string(i) + "]},";
  const std::string path = mesh("a.gltf", gltf + "{}]}");
  EXPECT_TRUE(fails(2, "mesh2bin", {path, "-o", file("a.scene")}, path, "crashed"));
  EXPECT_EQ(folder_.listing(), std::vector<std::string>{"a.gltf"});
}

} // namespace
} // namespace masu
