// Errors: one line on stderr, the exit code of the error, and no files left behind.
#include "tests/tools/run_tool.h"

#include <fcntl.h>
#include <nlohmann/json.hpp>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <future>
#include <thread>

namespace masu {
namespace {

class ToolErrors : public ToolTest {};

// --- NFF ------------------------------------------------------------------------------------------------

// tests/scene/nff_test.cpp has all that can be wrong with a text.
TEST_F(ToolErrors, InvalidNffIsRefusedWithLineAndColumn) {
  const struct {
    const char *text, *at, *says;
  } cases[] = {{"s 0 0 0 1\n\n  sphere 1 2 3\n", ":3:3", "'sphere'"},
               {"s 0 0 0", ":1:8", "the text ends"},
               {"# nothing\n", "", "no NFF entity"}};
  for (const auto& [text, at, says] : cases) {
    const std::string path = nff("bad.nff", text), out = file("a.scene");
    EXPECT_TRUE(fails(2, "nff2bin", {path, "-o", out}, path + at, says));
    EXPECT_TRUE(fails(2, "nff2bin", {path, "--info"}, path + at, says));
    EXPECT_TRUE(fails(2, "nff2bin", {"-", "-o", out}, std::string("stdin") + at, says, {path, {}, {}}));
  }
}

TEST_F(ToolErrors, NffThatCannotBeReadIsRefused) {
  EXPECT_TRUE(
      fails(2, "nff2bin", {file("missing.nff"), "-o", file("a.scene")}, file("missing.nff"), "No such file"));
  EXPECT_TRUE(fails(2, "nff2bin", {folder_.path().string(), "-o", file("a.scene")}, folder_.path().string(),
                    "is a directory"));
  EXPECT_TRUE(fails(2, "nff2bin", {"-", "-o", file("a.scene")}, "stdin", "no NFF entity"));
}

TEST_F(ToolErrors, ASceneTooWideForItsStoreIsRefused) {
  const std::string path = nff("wide.nff", "s 1e13 0 0 1\n");
  EXPECT_TRUE(fails(2, "nff2bin", {path, "-o", file("a.scene"), "--store", "float32", "--origin", "none"},
                    file("a.scene"), "float64"));
  // One that the origin makes too wide.
  EXPECT_TRUE(fails(2, "nff2bin", {path, "-o", file("a.scene"), "--store", "float32", "--origin", "1e99,0,0"},
                    file("a.scene"), "relative to the origin"));
}

TEST_F(ToolErrors, AnOriginThatIsNoPointIsRefused) {
  const std::string path = nff("a.nff", small_nff);
  for (const char* const origin : {"nan,0,0", "0,inf,0", "0,0,1e300", "1,2", "1,2,3,4", "here"})
    EXPECT_TRUE(fails(1, "nff2bin", {path, "-o", file("a.scene"), "--origin", origin}, "--origin"));
}

TEST_F(ToolErrors, Float32ArithmeticOnFloat64CoordinatesIsRefused) {
  const std::string path = scene("a.scene", nff("a.nff", small_nff), {"--store", "float64"});
  for (const char* const precision : {"fast", "robust"}) {
    EXPECT_TRUE(
        fails(1, "gridrender",
              {path, "--brute-force", "-o", file("a.png"), "--backend", "cpu", "--precision", precision},
              "precision", "double"));
  }
}

TEST_F(ToolErrors, AConeThatLosesItsLengthInItsStoreIsRefused) {
  const std::string path =
      nff("flat.nff", "c 100000000.25 0 0 1 100000001.25 0 0 1\nc 100000000 0 0 1 100000800 0 0 1\n");
  EXPECT_TRUE(fails(2, "nff2bin", {path, "-o", file("a.scene"), "--store", "float32", "--origin", "none"},
                    file("a.scene"), "float64"));
}

// Where --store float32 is too coarse, the scene is written, and a warning recommends float64.
TEST_F(ToolErrors, Float32ThatIsTooCoarseForTheSceneIsWarnedOf) {
  const auto warned = [&](const std::string& text, const Arguments& more, const std::string& of) {
    const std::string path = nff("far.nff", text);
    const ToolResult result = run("nff2bin", joined({path, "-o", file("far.scene")}, more));
    if (of.empty()) return succeeded(result);
    const bool good = result.code == 0 && result.err.starts_with("nff2bin: " + path + ": warning: ") &&
                      result.err.find(of) != std::string::npos &&
                      std::count(result.err.begin(), result.err.end(), '\n') == 1;
    return good ? testing::AssertionSuccess()
                : testing::AssertionFailure() << "exit code " << result.code << ", stderr: " << result.err;
  };
  const std::string far = "s 1000000 0 0 1\ns 1000004 0 0 1\n", small = "s 0 0 0 1000\ns 0 0 1000 0.0001\n",
                    digits = "s 0.123456789012 0 0 1\n";
  EXPECT_TRUE(warned(far, {"--store", "float32", "--origin", "none"}, "6 across"));
  EXPECT_TRUE(warned(far, {"--store", "float32"}, ""));
  EXPECT_TRUE(warned(far, {"--origin", "none"}, "")); // stored as float64, here and below
  EXPECT_TRUE(warned(small, {"--store", "float32"}, "1 part(s)"));
  EXPECT_TRUE(warned(small, {}, ""));
  EXPECT_TRUE(warned(digits, {"--store", "float32"}, ""));
  EXPECT_TRUE(warned(digits, {}, ""));
}

// --- Scene and grid files -------------------------------------------------------------------------------

class BadFiles : public SmallSceneTest {
protected:
  // All tools that read such a file must refuse this one.
  void expect_scene_refused(const std::string& path, const std::string& says = "") const {
    EXPECT_TRUE(fails(2, "gridbuild", {path, "-o", file("new.grid")}, path, says));
    EXPECT_TRUE(fails(2, "gridrender", {path, grid_, "-o", file("new.png")}, path, says));
    EXPECT_TRUE(fails(2, "gridrender", {path, "--brute-force", "-o", file("new.png")}, path, says));
    EXPECT_TRUE(fails(2, "gridstat", {"--occupancy", path}, path, says));
  }
  void expect_grid_refused(const std::string& path, const std::string& says = "") const {
    EXPECT_TRUE(fails(2, "gridrender", {scene_, path, "-o", file("new.png")}, path, says));
    EXPECT_TRUE(fails(2, "gridstat", {path}, path, says));
    EXPECT_TRUE(fails(2, "gridstat", {path, "--slice", "z=0", "-o", file("new.png")}, path, says));
  }
};

// tests/scene/container_test.cpp has each byte changed, and each length.
TEST_F(BadFiles, AreRefusedByEveryToolThatReadsThem) {
  const auto damaged = [&](const std::string& path, const char* name, bool is_cut) {
    Bytes bytes = read_bytes(path);
    bytes.back() ^= 1;
    if (is_cut) bytes.pop_back();
    write_bytes(file(name), bytes);
    return file(name);
  };
  const std::string folder = folder_.path().string(), empty = nff("empty", "");
  const struct {
    std::string path, says;
  } scenes[] = {{file("missing"), "No such file"},
                {folder, "is a directory"},
                {empty, "isn't a scene file"},
                {text_, "isn't a scene file"},
                {grid_, "isn't a scene file"},
                {damaged(scene_, "cut.scene", true), "truncated"},
                {damaged(scene_, "flipped.scene", false), "hash"}},
    grids[] = {{file("missing"), "No such file"},
               {folder, "is a directory"},
               {empty, "isn't a grid file"},
               {text_, "isn't a grid file"},
               {scene_, "isn't a grid file"},
               {damaged(grid_, "cut.grid", true), "truncated"},
               {damaged(grid_, "flipped.grid", false), "hash"}};
  for (const auto& [path, says] : scenes)
    expect_scene_refused(path, says);
  for (const auto& [path, says] : grids)
    expect_grid_refused(path, says);
}

TEST_F(BadFiles, AGridOfAnotherGeometryIsRefused) {
  const auto refuse = [&](const std::string& scene) {
    EXPECT_TRUE(fails(2, "gridrender", {scene, grid_, "-o", file("new.png")}, grid_, "another geometry"));
    EXPECT_TRUE(fails(2, "gridbench", {"oracle", scene, grid_}, grid_, "another geometry"));
  };
  refuse(scene("b.scene", nff("b.nff", other_nff)));
  refuse(scene("wide.scene", text_, {"--store", "float64"}));
  std::string moved(small_nff);
  moved.replace(moved.find("-2 -2 0"), 7, "-2 -2 1");
  refuse(scene("moved.scene", nff("moved.nff", moved)));
}

TEST_F(BadFiles, Nff2binRecognisesSceneFiles) {
  EXPECT_TRUE(fails(1, "nff2bin", {scene_, "-o", file("new.scene")}, scene_, "scene file already"));
  Bytes bytes = read_bytes(scene_);
  bytes.back() ^= 1;
  write_bytes(file("flipped"), bytes);
  EXPECT_TRUE(fails(2, "nff2bin", {file("flipped"), "--info"}, file("flipped"), "hash"));
}

TEST_F(BadFiles, ListsThatHoldNoWholeNumberOfRaysAreRefused) {
  const auto list = [&](std::size_t floats, const Arguments& more) {
    write_records(file("rays"), std::vector<float>(floats, 1));
    return fails(2, "gridtrace", joined({scene_, grid_, file("rays"), "-o", file("hits")}, more),
                 file("rays"), "not a whole number of rays");
  };
  EXPECT_TRUE(list(5, {}));
  EXPECT_TRUE(list(7, {}));
  EXPECT_TRUE(list(12, {"--ray-numbers", "8"}));
  EXPECT_TRUE(list(6, {"--ray-store", "float64"}));
  write_bytes(file("rays"), Bytes{1});
  EXPECT_TRUE(fails(2, "gridtrace", {scene_, grid_, file("rays"), "-o", file("hits")}, file("rays"),
                    "not a whole number of rays"));
  EXPECT_TRUE(fails(2, "gridtrace", {scene_, grid_, file("missing"), "-o", file("hits")}, file("missing"),
                    "No such file"));
}

// Though 24 bytes of it would be a ray.
TEST_F(BadFiles, ListsThatAreNotWhatTheirNamesSayAreRefused) {
  const auto list = [&](const std::string& name, std::string_view text, const std::string& says) {
    write_text(file(name), text);
    Arguments arguments{scene_, grid_, file(name), "-o", file("hits")};
    const auto result = fails(2, "gridtrace", arguments, file(name), says);
    if (!result) return result;
    arguments[2] = "-";
    if (name != "rays") return result;
    return fails(2, "gridtrace", arguments, "stdin", says, {file(name), {}, {}});
  };
  const std::string text = "ox,oy,oz,dx,dy,dz\n1,2,3,4,5,6\n";
  for (const std::size_t size : {24UL, 30UL, 1UL})
    EXPECT_TRUE(list("rays", text.substr(0, size), "is a text"));
  std::string long_text = text;
  while (long_text.size() < 24 * 500)
    long_text += "1,2,3,4,5,6\n";
  for (const char* const name : {"rays", "rays.f32", "rays.f64", "rays.txt"})
    EXPECT_TRUE(list(name, long_text.substr(0, 24 * 500), "is a text"));
  EXPECT_TRUE(list("rays.npy", text, "isn't a NumPy array"));
  EXPECT_TRUE(list("rays.npy", std::string(48, '\0'), "isn't a NumPy array"));
  EXPECT_TRUE(list("rays.f64", std::string(24, '\0'), "not a whole number of rays"));
  const auto csv = [&](const std::string& content, const std::string& at, const std::string& says) {
    write_text(file("rays.csv"), content);
    return fails(2, "gridtrace", {scene_, grid_, file("rays.csv"), "-o", file("hits")}, file("rays.csv") + at,
                 says);
  };
  EXPECT_TRUE(csv("", "", "has no line of columns' names"));
  EXPECT_TRUE(csv(text + "1,2,x,4,5,6\n", ":3:5", "'x' isn't a number"));
  EXPECT_TRUE(csv(std::string(48, '\0'), ":1:1", "isn't one of the columns"));
  EXPECT_TRUE(
      fails(2, "gridtrace", {scene_, grid_, "/dev/null", "-o", file("hits")}, "/dev/null", "is a device"));
}

TEST_F(BadFiles, NumPyArraysThatArentRaysAreRefused) {
  const auto fails_with = [&](const std::string& dictionary, std::size_t floats) {
    std::string text = "\x93NUMPY\x01";
    text += '\0';
    text += static_cast<char>(dictionary.size());
    text += '\0';
    write_text(file("rays.npy"), text + dictionary + std::string(4 * floats, '\0'));
    return fails(2, "gridtrace", {scene_, grid_, file("rays.npy"), "-o", file("hits")}, file("rays.npy"));
  };
  for (const char* const dictionary :
       {"", "{", "{'descr': '<f4', 'fortran_order': False, 'shape': (2, 6",
        "{'descr': '<f4', 'fortran_order': True, 'shape': (2, 6), }",
        "{'descr': '<i4', 'fortran_order': False, 'shape': (2, 6), }",
        "{'descr': '<f4', 'fortran_order': False, 'shape': (12,), }",
        "{'descr': '<f4', 'fortran_order': False, 'shape': (4, 3), }",
        "{'descr': '<f4', 'fortran_order': False, 'shape': (-2, 6), }",
        "{'descr': '<f4', 'fortran_order': False, 'shape': (2, 99999999999999999999), }",
        "{'descr': '<f4', 'fortran_order': False, 'shape': (1, 6), }",  // less than there is
        "{'descr': '<f4', 'fortran_order': False, 'shape': (3, 6), }"}) // more
    EXPECT_TRUE(fails_with(dictionary, 12)) << dictionary;
  write_text(file("rays.npy"), "\x93NUMPY");
  EXPECT_TRUE(fails(2, "gridtrace", {scene_, grid_, file("rays.npy"), "-o", file("hits")}, file("rays.npy")));
}

// --- Output ---------------------------------------------------------------------------------------------

TEST_F(BadFiles, UnwritableOutputsAreOutputErrors) {
  for (const std::string& place :
       {file("no/folder/new"), folder_.path().string(), std::string("/dev/full")}) {
    EXPECT_TRUE(fails(3, "nffgen", {"tetra", "--size", "3", "-o", place}, place));
    EXPECT_TRUE(fails(3, "nff2bin", {text_, "-o", place}, place));
    EXPECT_TRUE(fails(3, "gridbuild", {scene_, "-o", place}, place));
    EXPECT_TRUE(fails(3, "gridrender", {scene_, grid_, "--hits", place}, place));
    EXPECT_TRUE(fails(3, "gridrender", {scene_, grid_, "--stats", place}, place));
  }
  for (const std::string& place : {file("no/folder/new.png"), file("no/folder/new.pfm")})
    EXPECT_TRUE(fails(3, "gridrender", {scene_, grid_, "-o", place}, place, "No such file"));
  const std::string folder = file("folder.png");
  std::filesystem::create_directory(folder);
  EXPECT_TRUE(fails(3, "gridrender", {scene_, grid_, "-o", folder}, folder, "is a directory"));
  EXPECT_TRUE(fails(3, "gridstat", {grid_, "--slice", "z=0", "-o", folder}, folder, "is a directory"));
  // /dev/full takes nothing.
  for (const char* const name : {"full.csv", "full.ply"}) {
    std::filesystem::create_symlink("/dev/full", file(name));
    EXPECT_TRUE(fails(3, "gridstat", {grid_, "--cells", file(name)}, file(name)));
  }
}

TEST_F(BadFiles, AFullStandardOutputIsAnOutputError) {
  const Surroundings full{"/dev/null", "/dev/full", {}};
  const std::string place = "standard output";
  EXPECT_TRUE(fails(3, "nffgen", {"tetra"}, place, "", full));
  EXPECT_TRUE(fails(3, "nff2bin", {scene_, "--info"}, place, "", full));
  EXPECT_TRUE(fails(3, "nff2bin", {text_, "--info", "--json"}, place, "", full));
  EXPECT_TRUE(fails(3, "gridstat", {grid_}, place, "", full));
  EXPECT_TRUE(fails(3, "gridstat", {grid_, "--json"}, place, "", full));
  EXPECT_TRUE(failed(run("gridbuild", {scene_, "-o", file("new.grid")}, full), 3, "gridbuild", place));
  // Subcommands that print row by row.
  const Arguments quick{"--repeat", "1", "--warm-up", "0", "--size", "16x12"};
  for (const Arguments& more : {Arguments{}, Arguments{"--json"}}) {
    const auto with = [&](const Arguments& arguments, const Arguments& options) {
      return joined(joined(arguments, options), more);
    };
    EXPECT_TRUE(
        fails(3, "gridbench", with({"rays", scene_, grid_, "--random", "100"}, quick), place, "", full));
    EXPECT_TRUE(fails(3, "gridbench", with({"frame", scene_, grid_}, quick), place, "", full));
    EXPECT_TRUE(
        fails(3, "gridbench", with({"stability", "--sweep", "tip", "--count", "10"}, {}), place, "", full));
    EXPECT_TRUE(fails(3, "gridbench", with({"load", scene_, grid_, "--repeat", "1"}, {}), place, "", full));
  }
}

// The list's pipe stays open until the tool has ended, or for a minute.
TEST_F(BadFiles, AWriteErrorDoesntWaitForTheRestOfAList) {
  const std::string pipe = file("pipe");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  static_cast<void>(std::signal(SIGPIPE, SIG_IGN));
  for (const bool is_named : {false, true}) {
    std::promise<void> ended;
    bool ended_first = false;
    std::thread writer([&] {
      const int to = open(pipe.c_str(), O_WRONLY | O_CLOEXEC);
      const Bytes rays(24 * ((std::size_t{1} << 20) + 10)); // a chunk, and some of the next
      for (std::size_t done = 0; done < rays.size();) {
        const ssize_t written = write(to, rays.data() + done, rays.size() - done);
        if (written <= 0) break;
        done += static_cast<std::size_t>(written);
      }
      ended_first = ended.get_future().wait_for(std::chrono::minutes(1)) == std::future_status::ready;
      close(to);
    });
    EXPECT_TRUE(fails(3, "gridtrace",
                      {scene_, grid_, "--backend", "cpu", is_named ? pipe : "-", "-o", "/dev/full"},
                      "/dev/full", "", {is_named ? "/dev/null" : pipe, {}, {}}));
    ended.set_value();
    writer.join();
    EXPECT_TRUE(ended_first);
  }
  static_cast<void>(std::signal(SIGPIPE, SIG_DFL));
}

TEST_F(ToolErrors, AClosedPipeIsAnOutputError) {
  const std::string pipe = file("pipe");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  std::thread reader([&] {
    char first = 0;
    std::ifstream(pipe).get(first);
    EXPECT_NE(first, 0);
  });
  EXPECT_TRUE(fails(3, "nffgen", {"balls"}, "standard output", "", {"/dev/null", pipe, {}}));
  reader.join();
}

// --- Inputs are never written ---------------------------------------------------------------------------

class Inputs : public BadFiles {
protected:
  Inputs() {
    write_records(rays_, std::vector<float>{0, 0, 5, 0, 0, -1});
    std::filesystem::create_directory(file("sub"));
  }

  // Other names of the same file.
  std::vector<std::string> names_of(const std::string& input) const {
    namespace fs = std::filesystem;
    const std::string soft = input + ".soft", hard = input + ".hard";
    if (!fs::is_symlink(soft)) fs::create_symlink(input, soft);
    if (!fs::exists(hard)) fs::create_hard_link(input, hard);
    const std::string name = fs::path(input).filename().string();
    return {input, file("./" + name), file("sub/../" + name), fs::relative(input).string(), soft, hard};
  }

  // The tool must refuse to write to this input by any of its names. Where outputs need a file name
  // extension, they are symbolic links with `ending`.
  void expect_spared(const std::string& input, const std::string& tool, const Arguments& arguments,
                     const std::string& option, const std::string& ending = "") const {
    const Bytes before = read_bytes(input);
    for (const std::string& name : names_of(input)) {
      std::string output = name;
      if (!ending.empty()) {
        output = file("link" + ending);
        std::filesystem::remove(output);
        std::filesystem::create_symlink(std::filesystem::absolute(name), output);
      }
      EXPECT_TRUE(fails(1, tool, joined(arguments, {option, output}), output, "itself"))
          << input << " as " << output;
      EXPECT_TRUE(read_bytes(input) == before) << input << " as " << output;
    }
  }

  const std::string rays_ = file("rays");
};

TEST_F(Inputs, AreNeverOutputs) {
  expect_spared(text_, "nff2bin", {text_}, "-o");
  expect_spared(scene_, "gridbuild", {scene_}, "-o");
  for (const std::string& input : {scene_, grid_, rays_}) {
    for (const char* const option : {"--stats", "--times", "-o"})
      expect_spared(input, "gridtrace", {scene_, grid_, rays_}, option);
  }
  for (const std::string& input : {scene_, grid_}) {
    for (const char* const ending : {".png", ".pfm"})
      expect_spared(input, "gridrender", {scene_, grid_}, "-o", ending);
    expect_spared(input, "gridrender", {scene_, grid_, "--brute-force"}, "--hits");
  }
  for (const char* const ending : {".png", ".svg", ".json"}) {
    expect_spared(grid_, "gridstat", {grid_, "--slice", "z=0"}, "-o", ending);
    expect_spared(scene_, "gridstat", {grid_, "--slice", "z=0", "--outline", scene_}, "-o", ending);
  }
  for (const char* const ending : {".csv", ".ply"})
    expect_spared(grid_, "gridstat", {grid_}, "--cells", ending);
}

TEST_F(Inputs, ThatAreLoopsOfLinksCannotBeRead) {
  std::filesystem::create_symlink("loop", file("loop"));
  std::filesystem::create_symlink("b", file("a"));
  std::filesystem::create_symlink("a", file("b"));
  for (const std::string& loop : {file("loop"), file("a")}) {
    const auto unread = [&](const std::string& tool, const Arguments& arguments) {
      return fails(2, tool, arguments, loop, "symbolic links");
    };
    EXPECT_TRUE(unread("nff2bin", {loop, "-o", file("new")}));
    EXPECT_TRUE(unread("gridbuild", {loop, "-o", file("new")}));
    EXPECT_TRUE(unread("gridstat", {loop}));
    EXPECT_TRUE(unread("gridstat", {grid_, "--slice", "z=0", "--outline", loop, "-o", file("new.png")}));
    EXPECT_TRUE(unread("gridrender", {loop, grid_, "-o", file("new.png")}));
    EXPECT_TRUE(unread("gridrender", {scene_, loop, "-o", file("new.png")}));
    EXPECT_TRUE(unread("gridrender", {scene_, grid_, "--views", loop, "-o", file("{index}.png")}));
    EXPECT_TRUE(unread("gridtrace", {scene_, grid_, loop, "-o", file("new")}));
    EXPECT_TRUE(fails(3, "gridbuild", {scene_, "-o", loop}, loop, "symbolic links"));
  }
}

TEST_F(Inputs, FromStandardInputAreNeverOutputs) {
  const Bytes before = read_bytes(text_);
  EXPECT_TRUE(failed(run("nff2bin", {"-", "-o", text_}, {text_, {}, {}}), 1, "nff2bin", text_, "itself"));
  EXPECT_TRUE(read_bytes(text_) == before);
}

TEST_F(Inputs, OfTheTradeoffAreNeverOutputs) {
  for (const char* const name : {"tradeoff.csv", "charts.csv", "chart.svg", "chart.png", "division.svg"}) {
    const std::string path = file(name);
    std::filesystem::copy_file(scene_, path);
    const std::string other = file("chart.scene"); // whose chart may have that name
    if (!std::filesystem::exists(other)) std::filesystem::copy_file(scene_, other);
    const Bytes before = read_bytes(path);
    const bool is_own_name = std::string_view(name).starts_with("chart.");
    const Arguments scenes = is_own_name ? Arguments{path} : Arguments{other, path};
    const ToolResult result = run("gridbench", joined({"tradeoff", "-o", folder_.path().string()}, scenes));
    EXPECT_EQ(result.code, 1) << name << ": " << result.err;
    EXPECT_TRUE(read_bytes(path) == before) << name;
    std::filesystem::remove(path);
  }
}

TEST_F(Inputs, OutputsOfOneRunAreDistinctFiles) {
  const std::string a = file("new");
  std::filesystem::create_symlink("new", file("link"));
  for (const std::string& other : {a, file("./new"), file("link")}) {
    EXPECT_TRUE(fails(1, "gridrender", {scene_, grid_, "--stats", a, "--hits", other}, a, "written twice"))
        << other;
  }
  const std::string picture = file("new.png");
  EXPECT_TRUE(
      fails(1, "gridrender", {scene_, grid_, "-o", picture, "--hits", picture}, picture, "written twice"));
  expect_run("gridrender", {scene_, grid_, "--stats", "/dev/null", "--hits", "/dev/null"});
}

// --- Command lines --------------------------------------------------------------------------------------

class BadCommand : public BadFiles {
protected:
  testing::AssertionResult refused(const std::string& tool, const Arguments& arguments,
                                   const std::string& place = "command line") const {
    return fails(1, tool, arguments, place);
  }
};

TEST_F(BadCommand, OfEveryToolIsAUsageError) {
  for (const char* const tool : {"nffgen", "nff2bin", "gridbuild", "gridrender", "gridtrace"}) {
    EXPECT_TRUE(refused(tool, {})) << tool;
    EXPECT_TRUE(refused(tool, {"--no-such-option"}, "--no-such-option")) << tool;
    EXPECT_TRUE(refused(tool, {"a", "b", "c", "d"})) << tool;
  }
  EXPECT_TRUE(refused("gridstat", {}, "GRID"));
  EXPECT_TRUE(refused("gridstat", {"--no-such-option"}, "--no-such-option"));
  EXPECT_TRUE(refused("gridstat", {"a", "b"}));
}

TEST_F(BadCommand, OfNffgenIsAUsageError) {
  EXPECT_TRUE(refused("nffgen", {"cube"}, "cube"));
  EXPECT_TRUE(refused("nffgen", {"balls", "--size", "0"}, "size 0"));
  EXPECT_TRUE(refused("nffgen", {"balls", "--size", "-1"}, "size -1"));
  EXPECT_TRUE(refused("nffgen", {"balls", "--size", "10", "-o", file("new")}, "size 10"));
  EXPECT_TRUE(refused("nffgen", {"balls", "--size", "two"}));
}

TEST_F(BadCommand, OfNff2binIsAUsageError) {
  const std::string text = text_;
  EXPECT_TRUE(refused("nff2bin", {text}));
  EXPECT_TRUE(refused("nff2bin", {text, "-o", file("new"), "--json"}));
  EXPECT_TRUE(refused("nff2bin", {text, "-o", file("new"), "--store", "float16"}));
  EXPECT_TRUE(refused("nff2bin", {text, "-o", text}, text));
  EXPECT_TRUE(refused("nff2bin", {text, "-o", file("new"), "--threads", "-1"}));
  for (const char* const facets : {"", "0", "-4", "3", "6", "1028", "12.0", "x", "99999999999999999999"})
    EXPECT_TRUE(refused("nff2bin", {text, "-o", file("new"), "--tessellate", facets})) << facets;
  EXPECT_TRUE(refused("nff2bin", {scene_, "--info", "--tessellate", "12"}, scene_));
}

TEST_F(BadCommand, OfGridbuildIsAUsageError) {
  EXPECT_TRUE(refused("gridbuild", {scene_}));
  for (const char* const division : {"0",           "-1",         "x",
                                     "4x4",         "4x4x0",      "4x4x4x4",
                                     "65536",       "1e3",        "4.5",
                                     "cleary",      "cleary:",    "cleary:0",
                                     "cleary:-1",   "cleary:nan", "cleary:inf",
                                     "cleary:1e30", "woo:1e9",    "cube-root:1e30",
                                     "cubic:1",     "auto:2",     "99999999999999999999"}) {
    EXPECT_TRUE(refused("gridbuild", {scene_, "-o", file("new"), "--division", division}, "--division"))
        << division;
  }
  // More voxels than fit in memory.
  EXPECT_TRUE(refused("gridbuild", {scene_, "-o", file("new"), "--division", "65535"}, "--division"));
  for (const char* const option : {"--space", "--overlap", "--merge", "--threads"})
    EXPECT_TRUE(refused("gridbuild", {scene_, "-o", file("new"), option, "what"})) << option;
}

TEST_F(BadCommand, OfGridrenderIsAUsageError) {
  const auto with = [&](const Arguments& more, const std::string& place = "command line") {
    return refused("gridrender", joined({scene_, grid_}, more), place);
  };
  const std::string picture = file("new.png");
  EXPECT_TRUE(with({}, "-o"));
  EXPECT_TRUE(refused("gridrender", {scene_, "-o", picture}, "GRID"));
  for (const char* const size : {"8", "8x", "x8", "0x8", "8x0", "-8x8", "8x8x8", "65537x1", "8X8", "8x8 "})
    EXPECT_TRUE(with({"-o", picture, "--size", size}, "--size")) << size;
  for (const char* const depth : {"0", "-1", "33", "x"})
    EXPECT_TRUE(with({"-o", picture, "--depth", depth})) << depth;
  for (const char* const option : {"--backend", "--sampling", "--threads"})
    EXPECT_TRUE(with({"-o", picture, option, "what"})) << option;
  for (const char* const name : {"new.bmp", "new", "png", "new.PNG"})
    EXPECT_TRUE(with({"-o", file(name)}, file(name)));
  EXPECT_TRUE(with({"-o", file("new"), "--format", "jpg"}));
  for (const char* const option : {"--write", "--any-hit"})
    EXPECT_TRUE(with({"-o", picture, option}, option));
}

TEST_F(BadCommand, OfGridtraceIsAUsageError) {
  const auto with = [&](const Arguments& more, const std::string& place = "command line") {
    return refused("gridtrace", joined({scene_, grid_}, more), place);
  };
  const std::string rays = file("rays"), hits = file("hits");
  EXPECT_TRUE(with({"-o", hits}, "RAYS"));
  EXPECT_TRUE(with({rays}, "-o"));
  EXPECT_TRUE(refused("gridtrace", {scene_, "-o", hits}, "GRID"));
  EXPECT_TRUE(refused("gridtrace", {scene_, "--brute-force", "-o", hits}, "RAYS"));
  EXPECT_TRUE(with({rays, "-o", hits, "--turntable", "2"}, "--turntable"));
  EXPECT_TRUE(with({rays, "-o", hits, "-o", file("other")}));
  for (const char* const fields : {"T", "t,", ",t", "t,t", "t;object", "occluded"})
    EXPECT_TRUE(with({rays, "-o", hits, "--write", fields}, "--write")) << fields;
  EXPECT_TRUE(with({rays, "-o", hits, "--any-hit", "--write", "t"}, "--write"));
  EXPECT_TRUE(with({rays, "-o", hits, "--ray-numbers", "7"}));
  EXPECT_TRUE(with({rays, "-o", file("hits.f64")}, "-o"));
  // Options without an effect.
  EXPECT_TRUE(with({rays, "-o", hits, "--json"}, "--json"));
  EXPECT_TRUE(with({rays, "-o", hits, "--depth", "3"}, "--depth"));
  EXPECT_TRUE(with({rays, "-o", hits, "--size", "8x8"}));
  EXPECT_TRUE(with({"--ray", "0,0,5,0,0,-1", "--size", "8x8"}));
  EXPECT_TRUE(with({rays, "--pixel", "1,1"}, "RAYS"));
  EXPECT_TRUE(with({"--pixel", "1,1", "-o", hits}, "--output"));
  EXPECT_TRUE(with({"--pixel", "1,1", "--stats", file("stats")}, "--stats"));
  EXPECT_TRUE(with({"--pixel", "1,1", "--resume"}, "--resume"));
}

TEST_F(BadCommand, OfGridstatIsAUsageError) {
  for (const char* const slice : {"z", "z=", "w=0", "z=-1", "z=99999", "=0", "z=0x"})
    EXPECT_TRUE(refused("gridstat", {grid_, "--slice", slice, "-o", file("new.png")}, "--slice")) << slice;
  for (const char* const slice :
       {"z@", "z@x", "z@nan", "z@1e99", "z@1 ", "zz=1", "z=1.5", "z=1e1", "z=101%", "z=-1%", "z=nan%", "z=%",
        "z=99999999999999999999", "z=0x1", "z= 1", "x@0x1p0"})
    EXPECT_TRUE(refused("gridstat", {grid_, "--slice", slice, "-o", file("new.png")}, "--slice")) << slice;
  const auto with_slice = [&](const Arguments& more, const std::string& place = "command line") {
    return refused("gridstat", joined({grid_, "--slice", "z=0", "-o", file("new.svg")}, more), place);
  };
  for (const char* const window : {"1", "0,0,1", "0,0,1,1,", "0,0,1,1,1", "1,1,0,0", "0,0,0,1", "nan,0,1,1",
                                   "0,0,inf,1", "100,100,101,101", "0;0;1;1", "0,0,1,1 "})
    EXPECT_TRUE(with_slice({std::string("--window=") + window}, "--window")) << window;
  for (const char* const size : {"0", "63", "4097", "-1", "x", "1e9"})
    EXPECT_TRUE(with_slice({"--size", size})) << size;
  EXPECT_TRUE(with_slice({"--color", "red"}));
  for (const char* const depth : {"-1", "49", "x"})
    EXPECT_TRUE(with_slice({"--depth", depth})) << depth;
  EXPECT_TRUE(with_slice({"--cells", file("new.csv")}));
  EXPECT_TRUE(with_slice({"--json"}));
  EXPECT_TRUE(with_slice({"--occupied"}));
  for (const Arguments& alone : {Arguments{"--lines"},
                                 {"--color", "depth"},
                                 {"--depth", "1"},
                                 {"--window", "0,0,1,1"},
                                 {"--outline", scene_},
                                 {"--title", "a"},
                                 {"--size", "99"},
                                 {"--occupied"},
                                 {"--within", "0,0,0,1,1,1"},
                                 {"--expanded"},
                                 {"--wireframe"}})
    EXPECT_TRUE(refused("gridstat", joined({grid_}, alone))) << alone.front();
  const auto with_cells = [&](const char* name, const Arguments& more, const std::string& place) {
    return refused("gridstat", joined({grid_, "--cells", file(name)}, more), place);
  };
  for (const char* const name : {"new.obj", "new", "new.PLY", "new.csv.gz"})
    EXPECT_TRUE(with_cells(name, {}, file(name))) << name;
  for (const char* const within : {"1", "0,0,0,1,1", "a,b,c,d,e,f"})
    EXPECT_TRUE(with_cells("new.csv", {std::string("--within=") + within}, "command line")) << within;
  for (const char* const within : {"1,1,1,0,0,0", "nan,0,0,1,1,1", "0,0,0,1,1,inf"})
    EXPECT_TRUE(with_cells("new.csv", {std::string("--within=") + within}, "--within")) << within;
  EXPECT_TRUE(with_cells("new.csv", {"--expanded"}, "--expanded"));
  EXPECT_TRUE(with_cells("new.csv", {"--wireframe"}, "--wireframe"));
  EXPECT_TRUE(refused("gridstat", {grid_, "--slice", "z=0"}, "--slice"));
  EXPECT_TRUE(refused("gridstat", {grid_, "-o", file("new.png")})); // without --slice
  for (const char* const name : {"new.jpg", "new.pfm", "new", "new.PNG", "-"})
    EXPECT_TRUE(refused("gridstat", {grid_, "--slice", "z=0", "-o", name}, name));
  EXPECT_TRUE(refused("gridstat", {grid_, "--csv", "--histogram"}));
  EXPECT_TRUE(refused("gridstat", {grid_, "--json", "--csv"}));
  EXPECT_TRUE(refused("gridstat", {grid_, "--occupancy", scene_}));
  EXPECT_TRUE(refused("gridstat", {grid_, "--divisions", "4"}));
  EXPECT_TRUE(refused("gridstat", {"--occupancy", scene_, "--divisions", "0"}, "--divisions"));
  EXPECT_TRUE(refused("gridstat", {"--occupancy", scene_, "--divisions", "4,100000"}, "--divisions"));
}

// The message points to the help that lists the options.
TEST_F(BadCommand, OfASubcommandPointsToItsHelp) {
  const auto points_to = [&](const Arguments& arguments, const std::string& command,
                             const std::string& place = "command line") {
    return fails(1, "gridbench", arguments, place, ": see " + command + " --help\n");
  };
  for (const char* const name :
       {"rays", "frame", "load", "tradeoff", "stability", "oracle", "crossings", "difference"}) {
    EXPECT_TRUE(points_to({name, "--no-such-option"}, std::string("gridbench ") + name, "--no-such-option"));
    EXPECT_NE(run("gridbench", {name, "--help"}).out.find("--json"), std::string::npos) << name;
  }
  EXPECT_TRUE(points_to({"rays", scene_, grid_, "--sets", "what"}, "gridbench rays"));
  EXPECT_TRUE(points_to({}, "gridbench"));
  EXPECT_TRUE(points_to({"what"}, "gridbench"));
}

TEST_F(BadFiles, CudaWithoutADeviceIsADeviceError) {
  // Hides all devices.
  const Surroundings no_device{"/dev/null", {}, "CUDA_VISIBLE_DEVICES=-1"};
  EXPECT_TRUE(fails(4, "gridrender", {scene_, grid_, "-o", file("new.png"), "--backend", "cuda"}, "cuda",
                    "--backend cpu", no_device));
  for (const char* const devices : {"all", "0", "0,1"})
    EXPECT_TRUE(fails(4, "gridrender", {scene_, grid_, "-o", file("new.png"), "--devices", devices}, "cuda",
                      "--backend cpu", no_device));
  EXPECT_TRUE(fails(4, "gridbench", {"load", scene_, grid_, "--backend", "cuda"}, "cuda", "--backend cpu",
                    no_device));
  EXPECT_TRUE(fails(4, "gridbuild", {scene_, "-o", file("new.grid"), "--device", "cuda"}, "cuda",
                    "--device cpu", no_device));
  expect_run("gridrender", {scene_, grid_, "-o", file("new.png")}, no_device);
}

// --- Names ----------------------------------------------------------------------------------------------

TEST_F(ToolErrors, ControlCharactersOfNamesAreEscaped) {
  const std::string name = "a\nb\x1b[2J\xff.nff", shown = "a\\x0ab\\x1b[2J\\xff.nff";
  EXPECT_TRUE(fails(2, "nff2bin", {file(name), "-o", file("a.scene")}, file(shown), "No such file"));
  EXPECT_TRUE(fails(2, "gridrender", {file(name), file(name), "-o", file("a.png")}, file(shown)));
  EXPECT_TRUE(fails(1, "gridstat", {file("a.grid"), "--\x1b[2J"}, "--\\x1b[2J", "unknown option"));
  const std::string crossing = nff(name, "p 4\n0 0 0\n2 2 0\n2 0 0\n0 2 0\n");
  const ToolResult warned = run("nff2bin", {crossing, "-o", file("a.scene")});
  EXPECT_EQ(warned.code, 0);
  EXPECT_TRUE(warned.err.starts_with("nff2bin: " + file(shown) + ": warning: ")) << warned.err;
}

// Not even by a zero byte.
TEST_F(ToolErrors, AreShownWhole) {
  const std::string in = scene("a.scene", nff("a.nff", small_nff));
  write_text(file("views"), R"({"na\u0000me": "a"})");
  EXPECT_TRUE(fails(2, "gridrender",
                    {in, "--brute-force", "--views", file("views"), "-o", file("{index}.png")},
                    file("views") + ":1", "'na\\x00me' isn't one of name, from, at, up, angle, size"));
}

TEST_F(ToolErrors, JsonOfInvalidUtf8IsValid) {
  const std::string in = scene("\xff.scene", nff("a.nff", small_nff));
  const ToolResult built = run("gridbuild", {in, "-o", file("\xff.grid"), "--json"});
  ASSERT_EQ(built.code, 0) << built.err;
  EXPECT_NE(nlohmann::json::parse(built.out)["command"].dump().find("\xef\xbf\xbd.scene"), std::string::npos);
}

} // namespace
} // namespace masu
