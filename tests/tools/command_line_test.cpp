// What every tool does with its command line and its standard streams.
#include "tests/tools/run_tool.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <regex>
#include <sstream>

namespace masu {
namespace {

std::vector<std::string> words_of(const std::string& text) {
  std::istringstream words(text);
  return {std::istream_iterator<std::string>(words), {}};
}

std::vector<std::string> all_tools() {
  return words_of(MASU_TOOLS);
}

bool has_tool(const std::string& name) {
  const std::vector<std::string> tools = all_tools();
  return std::ranges::find(tools, name) != tools.end();
}

// --- Empty values ----------------------------------------------------------------------------------------

// The names at the beginning of the lines of the parts of --help with such headings.
std::vector<std::string> names_in_help(const std::string& help, const std::regex& heading,
                                       const std::regex& name) {
  std::vector<std::string> names;
  std::istringstream lines(help);
  bool is_part = false;
  for (std::string line; std::getline(lines, line);) {
    if (!line.empty() && !line.starts_with(' ')) is_part = std::regex_match(line, heading);
    const std::string begin = line.substr(0, 24);
    if (!is_part || !std::regex_search(begin, std::regex("^ {1,4}[-a-z]"))) continue;
    for (std::sregex_iterator found(begin.begin(), begin.end(), name), end; found != end; ++found)
      names.push_back(found->str(1));
  }
  return names;
}

// The tool itself, and its subcommands.
std::vector<Arguments> commands_of(const std::string& tool) {
  std::vector<Arguments> commands{{}};
  for (const std::string& name :
       names_in_help(run(tool, {"--help"}).out, std::regex("Subcommands:"), std::regex("^ *([a-z]+)")))
    commands.push_back({name});
  EXPECT_EQ(commands.size() > 1, tool == "gridbench");
  return commands;
}

TEST(EmptyValues, OfEveryOptionOfEveryToolAreUsageErrors) {
  const std::regex groups("(?!Subcommands|Positionals|Example).*:"),
      option("(?:^ *|, *)(--?[a-zA-Z][a-z0-9-]*)");
  std::size_t options = 0;
  for (const std::string& tool : all_tools()) {
    for (const Arguments& command : commands_of(tool)) {
      const auto is_refused = [&](const Arguments& more) {
        return failed(run(tool, joined(command, more)), 1, tool, "command line", "is empty");
      };
      EXPECT_TRUE(is_refused({""})) << tool;
      for (const std::string& name :
           names_in_help(run(tool, joined(command, {"--help"})).out, groups, option)) {
        EXPECT_TRUE(is_refused({name, ""})) << tool << " " << name;
        if (name.starts_with("--")) {
          EXPECT_TRUE(is_refused({name + "="})) << tool << " " << name;
        }
        ++options;
      }
    }
  }
  EXPECT_GT(options, 150U);
}

// --- Help and unknown options ------------------------------------------------------------------------------

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);)
    lines.push_back(line);
  return lines;
}

TEST(HelpText, IsAsWideAsTheTerminalAndBreaksNoWords) {
  for (const std::string& tool : all_tools()) {
    const std::string usual = run(tool, {"--help"}).out;
    const std::vector<std::string> words = words_of(usual);
    EXPECT_EQ(run(tool, {"--help"}, {.environment = "COLUMNS=80"}).out, usual) << tool;
    for (const std::string& line : lines_of(usual))
      EXPECT_LE(line.size(), 80U) << tool << ": " << line;
    const std::string narrow = run(tool, {"--help"}, {.environment = "COLUMNS=50"}).out,
                      wide = run(tool, {"--help"}, {.environment = "COLUMNS=120"}).out;
    EXPECT_EQ(words_of(narrow), words) << tool;
    EXPECT_EQ(words_of(wide), words) << tool;
    EXPECT_GT(lines_of(narrow).size(), lines_of(usual).size()) << tool;
  }
}

TEST(HelpText, HasAnExampleAndNamesTheManPage) {
  for (const std::string& tool : all_tools()) {
    for (const Arguments& command : commands_of(tool)) {
      const ToolResult help = run(tool, joined(command, {"--help"}));
      EXPECT_TRUE(succeeded(help));
      const std::vector<std::string> lines = lines_of(help.out);
      const auto example = std::ranges::find(lines, "Example:");
      ASSERT_TRUE(lines.end() - example > 1) << tool;
      const std::string own = "  " + tool + " " + (command.empty() ? "" : command[0] + " ");
      EXPECT_TRUE((example + 1)->starts_with(own)) << *(example + 1);
      EXPECT_EQ(lines.back(), "Man page: " + tool + "(1)");
    }
  }
}

class Tables : public ToolTest {
protected:
  static std::string narrow(const std::string& tool, const Arguments& arguments) {
    const ToolResult result = run(tool, arguments);
    EXPECT_TRUE(succeeded(result));
    for (const std::string& line : lines_of(result.out))
      EXPECT_LE(line.size(), 80U) << tool << ": " << line;
    return result.out;
  }
};

TEST_F(Tables, FitEightyColumnsAndGroupDigits) {
  const std::string scene = this->scene("a.scene", spd("a.nff", "teapot", 20));
  const auto expect_narrow = [](const std::string& tool, const Arguments& arguments) {
    const std::string out = narrow(tool, arguments);
    EXPECT_TRUE(std::regex_search(out, std::regex("[0-9],[0-9]{3}"))) << out;
    EXPECT_FALSE(std::regex_search(out, std::regex("[ (][0-9]{5,}[,.) \n]"))) << out;
  };
  for (const Arguments& kind :
       {Arguments{}, {"--merge", "none"}, {"--merge", "balance"}, {"--structure", "bvh"}}) {
    expect_narrow("gridbuild", joined({scene, "-o", file("a.grid")}, kind));
    expect_narrow("gridstat", {file("a.grid"), "--histogram"});
  }
  expect_narrow("gridstat", {"--occupancy", scene});
  expect_narrow("nff2bin", {file("a.nff"), "--info"});
}

TEST_F(Tables, OfGridbenchFitEightyColumns) {
  grid("a.grid", scene("a.scene", spd("a.nff", "tetra", 2)));
  for (const char* const arguments :
       {"rays ~/a.scene ~/a.grid --size 16x16 --repeat 1 --random 1000",
        "frame ~/a.scene ~/a.grid --size 16x16 --repeat 1", "oracle ~/a.scene ~/a.grid --count 100",
        "crossings ~/a.scene ~/a.grid --count 100",
        "stability --sweep start-triangles,leaving-contrast,axis-ray --count 20",
        "stability --pictures --sweep needles"})
    static_cast<void>(narrow("gridbench", words(arguments)));
}

TEST(Version, GoesToStandardOutput) {
  for (const std::string& tool : all_tools()) {
    const ToolResult result = run(tool, {"--version"});
    EXPECT_TRUE(succeeded(result)) << tool;
    EXPECT_TRUE(result.out.starts_with(tool + ", Masu ")) << result.out;
  }
}

TEST(UnknownOptions, AreAnsweredByTheNearestOne) {
  const auto meant = [](const std::string& tool, const Arguments& arguments, const std::string& given,
                        const std::string& nearest) {
    return failed(run(tool, arguments), 1, tool, given, "unknown option: did you mean " + nearest + "?");
  };
  EXPECT_TRUE(meant("gridrender", {"a", "b", "--thread", "4"}, "--thread", "--threads"));
  EXPECT_TRUE(meant("gridrender", {"--turntabel=3", "--colour=1"}, "--turntabel", "--turntable"));
  EXPECT_TRUE(meant("gridtrace", {"a", "b", "c", "--anyhit"}, "--anyhit", "--any-hit"));
  EXPECT_TRUE(meant("gridbuild", {"--divison=4"}, "--divison", "--division"));
  EXPECT_TRUE(meant("gridbench", {"rays", "a", "b", "--repaet", "3"}, "--repaet", "--repeat"));
  // Options that moved to another tool are unknown, too.
  for (const char* const option : {"--rays", "--walk", "--walk-ray", "--difference"})
    EXPECT_TRUE(
        failed(run("gridrender", {"a", "b", option, "c"}), 1, "gridrender", option, "unknown option"));
}

using CommandLine = SmallSceneTest;

// --- Files of other kinds ----------------------------------------------------------------------------------

TEST_F(CommandLine, WithAMeshOrNffForASceneSaysWhatConvertsIt) {
  write_text(file("a.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  write_text(file("a.GLB"), "glTF");
  for (const auto& [input, converter] :
       {std::pair(text_, "nff2bin "), {file("a.obj"), "mesh2bin "}, {file("a.GLB"), "mesh2bin "}}) {
    const std::string command = converter + input + " -o " + scene_;
    for (const auto& [tool, more] : {std::pair("gridrender", Arguments{}),
                                     {"gridrender", {grid_, "-o", file("a.png")}},
                                     {"gridtrace", {}},
                                     {"gridbuild", {"-o", file("out")}}})
      EXPECT_TRUE(fails(2, tool, joined({input}, more), input, command));
  }
  // By content, a scene file is one.
  std::filesystem::copy_file(scene_, file("b.nff"));
  expect_run("gridrender", {file("b.nff"), grid_, "-o", file("a.png")});
}

// --- Standard streams --------------------------------------------------------------------------------------

struct Writing {
  std::string tool;
  Arguments arguments; // also its output
  std::string output;
  bool is_reproducible = true;
};

class StandardStreams : public CommandLine {
protected:
  StandardStreams() {
    write_text(file("a.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    write_records(file("rays"), std::vector<float>{0, 0, 5, 0, 0, -1});
  }

  static bool is_written(const Writing& writing, const Bytes& expected) {
    const Bytes bytes = read_bytes(writing.output);
    return writing.is_reproducible ? bytes == expected : !bytes.empty();
  }

  // Commands that print nothing on standard output.
  std::vector<Writing> quiet_writings() const {
    std::vector<Writing> all{
        {"nffgen", {"tetra", "--size", "2", "-o", file("out.nff")}, file("out.nff")},
        {"nff2bin", {text_, "-o", file("out.scene")}, file("out.scene")},
        {"gridbuild", {scene_, "-o", file("out.grid"), "-q"}, file("out.grid")},
        {"gridstat", {grid_, "--slice", "z=0", "-o", file("out.svg")}, file("out.svg")},
        {"gridstat", {grid_, "--cells", file("out.csv")}, file("out.csv")},
        {"gridrender", {scene_, grid_, "-o", file("out.png"), "--backend", "cpu"}, file("out.png")},
        {"gridtrace", {scene_, grid_, file("rays"), "-o", file("hits")}, file("hits")},
    };
    if (has_tool("mesh2bin"))
      all.push_back({"mesh2bin", {file("a.obj"), "-o", file("b.scene")}, file("b.scene")});
    if (has_tool("gridview"))
      all.push_back({"gridview",
                     {scene_, grid_, "--export", file("out.html"), "--views", "1", "--size", "8x8",
                      "--slices", "y,0.5"},
                     file("out.html"),
                     false}); // it shows seconds
    return all;
  }
};

TEST_F(StandardStreams, FilesAreTheSameWhicheverAreClosedAndWhereStandardErrorIsFull) {
  std::vector<Surroundings> all{{.error = "/dev/full"}};
  for (unsigned set = 1; set < 8; ++set) {
    all.emplace_back();
    for (const int stream : {0, 1, 2})
      if ((set >> stream & 1) != 0) all.back().closed.push_back(stream);
  }
  for (const Writing& writing : quiet_writings()) {
    ASSERT_EQ(run(writing.tool, writing.arguments).code, 0) << writing.tool;
    const Bytes expected = read_bytes(writing.output);
    // gridview takes seconds: the first one, and the last, where all are closed.
    const std::size_t step = writing.tool == "gridview" ? all.size() - 1 : 1;
    for (std::size_t i = 0; i < all.size(); i += step) {
      std::filesystem::remove(writing.output);
      EXPECT_EQ(run(writing.tool, writing.arguments, all[i]).code, 0) << writing.tool << " " << i;
      EXPECT_TRUE(is_written(writing, expected)) << writing.tool << " " << i;
    }
  }
  const Surroundings& full = all[0];
  const std::string crossing = nff("b.nff", "p 4\n0 0 0\n2 2 0\n2 0 0\n0 2 0\n"); // which is warned of
  EXPECT_EQ(run("nff2bin", {crossing, "-o", file("b.scene")}, full).code, 0);
  EXPECT_EQ(run("gridbuild", {scene_, "-o", "-"}, full).code, 0); // reports there
  EXPECT_EQ(run("nff2bin", {file("none"), "-o", file("b.scene")}, full).code, 2);
}

TEST_F(StandardStreams, ClosedInputCannotBeRead) {
  const Surroundings closed{.closed = {0}};
  for (const char* const input : {"-", "/dev/stdin"}) {
    EXPECT_EQ(run("nff2bin", {input, "-o", file("out")}, closed).code, 2) << input;
    EXPECT_EQ(run("nff2bin", {input, "--info"}, closed).code, 2) << input;
    EXPECT_EQ(run("gridrender", {scene_, grid_, "--views", input, "-o", file("{index}.png")}, closed).code, 2)
        << input;
    EXPECT_EQ(run("gridtrace", {scene_, grid_, input, "-o", file("out")}, closed).code, 2) << input;
  }
}

// By whatever name: reports go to standard error, and what was in the file before stays.
TEST_F(StandardStreams, OutputMayBeNamed) {
  expect_runs(R"(
gridrender ~/a.scene ~/a.grid -o ~/b.png --hits ~/hits
nffgen tetra --size 2 -o ~/b.nff
)");
  EXPECT_TRUE(run("nffgen", {"tetra", "--size", "2"}).out == read_text(file("b.nff")));
  const auto expect_written = [&](const std::string& tool, const Arguments& arguments,
                                  const std::string& expected) {
    ASSERT_EQ(run(tool, arguments, {.output = file("out")}).code, 0) << tool;
    EXPECT_TRUE(read_bytes(file("out")) == read_bytes(expected)) << tool << " into a file";
    std::string command = std::string(MASU_BIN_DIR) + "/" + tool; // no name has a space
    for (const std::string& argument : arguments)
      command += " " + argument;
    ASSERT_EQ(run("/bin/sh", {"-c", "echo head > $0; (" + command + ") >> $0", file("out")}).code, 0) << tool;
    EXPECT_EQ(read_text(file("out")), "head\n" + read_text(expected)) << tool << " at a file's end";
    const ToolResult piped = run("/bin/sh", {"-c", command + " | cat"});
    EXPECT_EQ(piped.out, read_text(expected)) << tool << " into a pipe";
  };
  for (const char* const output : {"-", "/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"}) {
    SCOPED_TRACE(output);
    expect_written("nffgen", {"tetra", "--size", "2", "-o", output}, file("b.nff"));
    expect_written("nff2bin", {text_, "-o", output}, scene_);
    expect_written("gridbuild", {scene_, "-o", output}, grid_);
    expect_written("gridrender", {scene_, grid_, "-o", output}, file("b.png"));
    expect_written("gridrender", {scene_, grid_, "--hits", output}, file("hits"));
    EXPECT_TRUE(fails(1, "gridrender", {scene_, grid_, "-o", output, "--stats", "-"}, "-", "written twice"));
    EXPECT_TRUE(fails(1, "nff2bin", {text_, "-o", output, "--info"}, "--info", "mixed"));
  }
}

} // namespace
} // namespace masu
