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
#include <regex>
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
  expect_refused(2, R"(
nff2bin ~/missing.nff -o ~/a.scene > ~/missing.nff: No such file
nff2bin ~ -o ~/a.scene             > ~: is a directory
nff2bin - -o ~/a.scene             > stdin: no NFF entity
)");
}

// By themselves, by the origin, or by a cone that loses its length.
TEST_F(ToolErrors, CoordinatesThatTheStoreCannotHoldAreRefused) {
  nff("wide.nff", "s 1e13 0 0 1\n");
  nff("flat.nff", "c 100000000.25 0 0 1 100000001.25 0 0 1\nc 100000000 0 0 1 100000800 0 0 1\n");
  expect_refused(2, R"(
nff2bin ~/wide.nff -o ~/a.scene --store float32 --origin none     > ~/a.scene: float64
nff2bin ~/wide.nff -o ~/a.scene --store float32 --origin 1e99,0,0 > ~/a.scene: relative to the origin
nff2bin ~/flat.nff -o ~/a.scene --store float32 --origin none     > ~/a.scene: float64
)");
}

TEST_F(ToolErrors, Float32ArithmeticOnFloat64CoordinatesIsRefused) {
  scene("a.scene", nff("a.nff", small_nff), {"--store", "float64"});
  expect_refused(1, "gridrender ~/a.scene --brute-force -o ~/a.png --backend cpu --precision [fast|robust]"
                    " > precision: double");
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
  // Whether gridtrace refuses a list of that name and content.
  testing::AssertionResult refuses(const std::string& name, std::string_view content,
                                   const std::string& says = "", const std::string& at = "",
                                   const Arguments& more = {}) const {
    write_text(file(name), content);
    return fails(2, "gridtrace", joined({scene_, grid_, file(name), "-o", file("hits")}, more),
                 file(name) + at, says);
  }
};

// tests/scene/container_test.cpp has each byte changed, and each length.
TEST_F(BadFiles, AreRefusedByEveryToolThatReadsThem) {
  nff("empty", "");
  for (const std::string kind : {"scene", "grid"}) {
    Bytes bytes = read_bytes(file("a." + kind));
    bytes.back() ^= 1;
    write_bytes(file("flipped." + kind), bytes);
    bytes.pop_back();
    write_bytes(file("cut." + kind), bytes);
  }
  const struct {
    std::string kind, other, readers;
  } kinds[] = {{"scene", "grid", R"(
gridbuild FILE -o ~/new.grid                           > FILE: SAYS
gridrender FILE [~/a.grid|--brute-force] -o ~/new.png  > FILE: SAYS
gridstat --occupancy FILE                              > FILE: SAYS
)"},
               {"grid", "scene", R"(
gridrender ~/a.scene FILE -o ~/new.png                 > FILE: SAYS
gridstat FILE [|--slice z=0 -o ~/new.png]              > FILE: SAYS
)"}};
  for (const auto& [kind, other, readers] : kinds) {
    const std::string none = "isn't a " + kind + " file";
    for (const auto& [path, says] : {std::pair<std::string, std::string>{"~/missing", "No such file"},
                                     {"~", "is a directory"},
                                     {"~/empty", none},
                                     {"~/a.nff", none},
                                     {"~/a." + other, none},
                                     {"~/cut." + kind, "truncated"},
                                     {"~/flipped." + kind, "hash"}})
      expect_refused(2, std::regex_replace(std::regex_replace(readers, std::regex("FILE"), path),
                                           std::regex("SAYS"), says));
  }
  expect_refused(2, "nff2bin ~/flipped.scene --info > ~/flipped.scene: hash");
}

TEST_F(BadFiles, AGridOfAnotherGeometryIsRefused) {
  scene("other.scene", nff("b.nff", other_nff));
  scene("wide.scene", text_, {"--store", "float64"});
  std::string moved(small_nff);
  moved.at(moved.find("-2 -2 0") + 6) = '1'; // its z
  scene("moved.scene", nff("moved.nff", moved));
  expect_refused(2, R"(
gridrender ~/[other|wide|moved].scene ~/a.grid -o ~/new.png                               > ~/a.grid: another geometry
gridbench oracle ~/[other|wide|moved].scene ~/a.grid                                      > ~/a.grid: another geometry
gridstat ~/a.grid --slice z=0 --outline ~/[other|wide|moved].scene -o ~/new.png           > ~/a.grid
)");
}

TEST_F(BadFiles, ListsThatHoldNoWholeNumberOfRaysAreRefused) {
  for (const auto& [bytes, more] : {std::pair{20, Arguments{}},
                                    {28, {}},
                                    {1, {}},
                                    {48, {"--ray-numbers", "8"}},
                                    {24, {"--ray-store", "float64"}}})
    EXPECT_TRUE(refuses("rays", std::string(static_cast<std::size_t>(bytes), '\1'),
                        "not a whole number of rays", "", more))
        << bytes;
  expect_refused(2, "gridtrace ~/a.scene ~/a.grid ~/missing -o ~/hits > ~/missing: No such file");
}

// Though 24 bytes of it would be a ray.
TEST_F(BadFiles, ListsThatAreNotWhatTheirNamesSayAreRefused) {
  const std::string line = "1,2,3,4,5,6\n", text = "ox,oy,oz,dx,dy,dz\n" + line, zeros(48, '\0');
  const Arguments piped{scene_, grid_, "-", "-o", file("hits")};
  const auto both_refuse = [&](const std::string& content) {
    EXPECT_TRUE(refuses("rays", content, "is a text"));
    EXPECT_TRUE(fails(2, "gridtrace", piped, "stdin", "is a text", {file("rays"), {}, {}}));
  };
  for (const std::size_t size : {24UL, 30UL, 1UL})
    both_refuse(text.substr(0, size));
  std::string long_text = text;
  while (long_text.size() < 24 * 500)
    long_text += line;
  long_text.resize(24 * 500);
  both_refuse(long_text);
  for (const char* const name : {"rays.f32", "rays.f64", "rays.txt"})
    EXPECT_TRUE(refuses(name, long_text, "is a text"));
  EXPECT_TRUE(refuses("rays.npy", text, "isn't a NumPy array"));
  EXPECT_TRUE(refuses("rays.npy", zeros, "isn't a NumPy array"));
  EXPECT_TRUE(refuses("rays.f64", zeros.substr(0, 24), "not a whole number of rays"));
  EXPECT_TRUE(refuses("rays.csv", "", "has no line of columns' names"));
  EXPECT_TRUE(refuses("rays.csv", text + "1,2,x,4,5,6\n", "'x' isn't a number", ":3:5"));
  EXPECT_TRUE(refuses("rays.csv", zeros, "isn't one of the columns", ":1:1"));
  expect_refused(2, "gridtrace ~/a.scene ~/a.grid /dev/null -o ~/hits > /dev/null: is a device");
}

TEST_F(BadFiles, NumPyArraysThatArentRaysAreRefused) {
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
    EXPECT_TRUE(refuses("rays.npy", npy_head(dictionary) + std::string(48, '\0'))) << dictionary;
  EXPECT_TRUE(refuses("rays.npy", "\x93NUMPY"));
}

// --- Output ---------------------------------------------------------------------------------------------

TEST_F(BadFiles, UnwritableOutputsAreOutputErrors) {
  std::filesystem::create_directory(file("folder.png"));
  for (const char* const name : {"full.csv", "full.ply"}) // takes nothing
    std::filesystem::create_symlink("/dev/full", file(name));
  expect_refused(3, R"(
nffgen tetra --size 3 -o [~/no/folder/new|~|/dev/full]                           > @
nff2bin ~/a.nff -o [~/no/folder/new|~|/dev/full]                                 > @
gridbuild ~/a.scene -o [~/no/folder/new|~|/dev/full]                             > @
gridrender ~/a.scene ~/a.grid [--hits|--stats] [~/no/folder/new|~|/dev/full]     > @
gridrender ~/a.scene ~/a.grid -o ~/no/folder/new[.png|.pfm]                      > @: No such file
gridrender ~/a.scene ~/a.grid -o ~/folder.png                                    > @: is a directory
gridstat ~/a.grid --slice z=0 -o ~/folder.png                                    > @: is a directory
gridstat ~/a.grid --cells ~/full[.csv|.ply]                                      > @
)");
}

// Also of subcommands that print row by row.
TEST_F(BadFiles, AClosedOrFullStandardOutputIsAnOutputError) {
  const std::string tools = std::regex_replace(MASU_TOOLS, std::regex(" "), "|");
  const std::string printing = "[" + tools + "] [--help|--version] > standard output" + R"(
nffgen tetra --size 2                                                                 > standard output
nff2bin [~/a.scene|~/a.nff] --info [|--json]                                          > standard output
gridbuild ~/a.scene -o ~/a.grid                                                       > standard output
gridstat ~/a.grid [|--json]                                                           > standard output
gridbench rays ~/a.scene ~/a.grid --random 100 --repeat 1 --warm-up 0 --size 16x12 [|--json] > standard output
gridbench frame ~/a.scene ~/a.grid --repeat 1 --warm-up 0 --size 16x12 [|--json]      > standard output
gridbench stability --sweep tip --count 10 [|--json]                                  > standard output
)";
  expect_refused(3, printing, {.output = "/dev/full"});
  expect_refused(3, printing, {.closed = {1}});
  write_records(file("rays"), std::vector<float>{0, 0, 5, 0, 0, -1});
  constexpr std::string_view named = R"(
nffgen tetra --size 2 -o OUT                                  > standard output
nff2bin ~/a.nff -o OUT                                        > standard output
gridbuild ~/a.scene -o OUT                                    > standard output
gridrender ~/a.scene ~/a.grid -q [-o|--stats] OUT             > standard output
gridtrace ~/a.scene ~/a.grid -q ~/rays -o OUT                 > standard output
gridtrace ~/a.scene ~/a.grid --pixel 1,1 --json=OUT           > standard output
)";
  expect_refused(
      3,
      std::regex_replace(std::string(named), std::regex("OUT"), "[-|/dev/stdout|/dev/fd/1|/proc/self/fd/1]"),
      {.closed = {1}});
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
    expect_spared(input, "gridrender", {scene_, grid_}, "--hits");
  }
  for (const char* const ending : {".png", ".svg", ".json"}) {
    expect_spared(grid_, "gridstat", {grid_, "--slice", "z=0"}, "-o", ending);
    expect_spared(scene_, "gridstat", {grid_, "--slice", "z=0", "--outline", scene_}, "-o", ending);
  }
  for (const char* const ending : {".csv", ".ply"})
    expect_spared(grid_, "gridstat", {grid_}, "--cells", ending);
}

TEST_F(Inputs, ThatAreLoopsOfLinksCannotBeRead) {
  for (const char* const next : {"loop", "other"}) {
    std::filesystem::remove(file("loop"));
    std::filesystem::create_symlink(next, file("loop"));
    if (!std::filesystem::is_symlink(file("other"))) std::filesystem::create_symlink("loop", file("other"));
    expect_refused(2, R"(
nff2bin ~/loop -o ~/new                                            > ~/loop: symbolic links
gridbuild ~/loop -o ~/new                                          > ~/loop: symbolic links
gridstat ~/loop                                                    > ~/loop: symbolic links
gridstat ~/a.grid --slice z=0 --outline ~/loop -o ~/new.png        > ~/loop: symbolic links
gridrender [~/loop ~/a.grid|~/a.scene ~/loop] -o ~/new.png         > ~/loop: symbolic links
gridrender ~/a.scene ~/a.grid --views ~/loop -o ~/{index}.png      > ~/loop: symbolic links
gridtrace ~/a.scene ~/a.grid ~/loop -o ~/new                       > ~/loop: symbolic links
)");
    expect_refused(3, "gridbuild ~/a.scene -o ~/loop > ~/loop: symbolic links");
  }
}

TEST_F(Inputs, FromStandardInputAreNeverOutputs) {
  const Bytes before = read_bytes(text_);
  expect_refused(1, "nff2bin - -o ~/a.nff > ~/a.nff: itself", {.input = text_});
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
  std::filesystem::create_symlink("new", file("link"));
  expect_refused(1, R"(
gridrender ~/a.scene ~/a.grid --stats ~/new --hits [~/new|~/./new|~/link] > ~/new: written twice
gridrender ~/a.scene ~/a.grid -o ~/new.png --hits ~/new.png               > ~/new.png: written twice
)");
  expect_run("gridrender", {scene_, grid_, "--stats", "/dev/null", "--hits", "/dev/null"});
}

// --- Command lines --------------------------------------------------------------------------------------

// The message points to the help that lists the options.
TEST_F(BadFiles, OrOptionsOfASubcommandPointToItsHelp) {
  const auto points_to = [&](const Arguments& arguments, const std::string& command,
                             const std::string& place = "command line") {
    return fails(1, "gridbench", arguments, place, ": see " + command + " --help\n");
  };
  for (const char* const name :
       {"rays", "frame", "tradeoff", "stability", "oracle", "crossings", "difference"}) {
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
  constexpr std::string_view commands = R"(
gridrender ~/a.scene ~/a.grid -o ~/new.png [--backend cuda|--devices all|--devices 0|--devices 0,1] > cuda: --backend cpu
gridbench rays ~/a.scene ~/a.grid --backend cuda                                                    > cuda: --backend cpu
gridbuild ~/a.scene -o ~/new.grid --device cuda                                                     > cuda: --device cpu
)";
  expect_refused(4, commands, no_device);
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

TEST_F(ToolErrors, ControlCharactersOfTextsAreEscaped) {
  const std::string in = nff("a.nff", std::string("v\nfrom 1\x1b[2J\x00\xff", 14) + " 0 0\n");
  EXPECT_TRUE(fails(2, "nff2bin", {in, "-o", file("new")}, in + ":2:6", "'1\\x1b[2J\\x00\\xff'"));
  write_text(file("a.csv"), std::string("ox,oy,oz,dx,dy,dz\n0,0,0,0,\x1b[2J\x00,1\n", 34));
  const std::string made = scene("a.scene", nff("small.nff", small_nff));
  EXPECT_TRUE(fails(2, "gridtrace", {made, "--brute-force", file("a.csv"), "-o", file("new")},
                    file("a.csv") + ":2:9", "'\\x1b[2J\\x00'"));
}

// Results may have been found on a CPU for want of a GPU: that is said with them, and not before an error.
TEST_F(ToolErrors, AreLinesAlone) {
  const bool has_view = std::string_view(MASU_TOOLS).find("gridview") != std::string_view::npos;
  expect_refused(2, "gridbench [crossings|rays|frame] ~/none.scene ~/none.grid > ~/none.scene");
  if (has_view) expect_refused(2, "gridview ~/none.scene ~/none.grid > ~/none.scene");
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
