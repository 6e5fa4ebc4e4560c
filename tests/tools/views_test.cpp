// gridrender's views: cameras given on the command line and in lists, turntables, crops, many pictures of one
// run.
#include "tests/decoded_image.h"
#include "tests/tools/run_tool.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cstring>
#include <set>
#include <span>

namespace masu {
namespace {

// Of a picture.
struct Window {
  std::size_t x, y, width, height;
};

// A part of rows of records, of some numbers each.
template <class Number>
std::vector<Number> part(const std::vector<Number>& rows, std::size_t row_records, std::size_t numbers,
                         const Window& window) {
  const auto& [x, y, width, height] = window;
  std::vector<Number> some;
  for (std::size_t row = y; row < y + height; ++row) {
    const auto run = std::span(rows).subspan((row * row_records + x) * numbers, width * numbers);
    some.insert(some.end(), run.begin(), run.end());
  }
  return some;
}

class Views : public SmallSceneTest {
protected:
  ToolResult try_render(const Arguments& more) const { return run("gridrender", on_cpu(more)); }
  testing::AssertionResult refused(int code, const Arguments& more, const std::string& place,
                                   const std::string& says = "") const {
    return fails(code, "gridrender", on_cpu(more), place, says);
  }
  std::string list(const std::string& lines) const {
    write_text(file("list"), lines);
    return file("list");
  }

  // A picture in both formats, and its hits.
  struct Made {
    DecodedPng png;
    std::vector<float> floats;
    Bytes hits;
  };
  Made made(const std::string& name, const Arguments& options, std::size_t width, std::size_t height) const {
    for (const char* const ending : {".png", ".pfm"})
      render(joined({"-o", file(name + ending), "--hits", file("hits")}, options));
    return {decoded_png(file(name + ".png")), decoded_pfm(file(name + ".pfm"), width, height),
            read_bytes(file("hits"))};
  }
  // A crop is the same bits as in the whole picture. `more`: rays than pixels in a row, and in a column.
  void expect_part(const Made& whole, const Window& window, std::size_t more, Arguments options) const {
    const auto& [x, y, width, height] = window;
    options.insert(options.end(), {"--crop", fmt::format("{},{},{},{}", x, y, width, height)});
    SCOPED_TRACE(options.back());
    const Made crop = made("crop", options, width, height);
    EXPECT_EQ(crop.png.width, width);
    EXPECT_EQ(crop.png.height, height);
    EXPECT_TRUE(crop.png.rgb == part(whole.png.rgb, whole.png.width, 3, window));
    EXPECT_TRUE(crop.floats == part(whole.floats, whole.png.width, 3, window));
    EXPECT_TRUE(crop.hits ==
                part(whole.hits, whole.png.width + more, 8, {x, y, width + more, height + more}));
  }
};

// --- Cameras ----------------------------------------------------------------------------------------------

TEST_F(Views, OptionsReplaceTheScenesCamera) {
  std::string text(small_nff);
  text.replace(text.find("from 3 -4 2"), 11, "from 1.5 4 3");
  text.replace(text.find("at 0 0 0.5"), 10, "at 0.25 -0 1");
  text.replace(text.find("up 0 0 1"), 8, "up 1 0 0");
  text.replace(text.find("angle 45"), 8, "angle 60");
  scene("b.scene", nff("b.nff", text));
  // What is left out stays the scene's.
  expect_runs(R"(
gridrender ~/b.scene --brute-force --backend cpu -o ~/b.pfm --hits ~/b.hits
gridrender ~/a.scene ~/a.grid --backend cpu -o ~/a.pfm --hits ~/a.hits --from 1.5,4,3 --at 0.25,-0,1 --up 1,0,0 --angle 60
gridrender ~/a.scene ~/a.grid --backend cpu -o ~/c.pfm
gridrender ~/a.scene ~/a.grid --backend cpu -o ~/d.pfm --from 3,-4,2 --angle 45
)");
  EXPECT_TRUE(read_bytes(file("a.pfm")) == read_bytes(file("b.pfm")));
  EXPECT_TRUE(read_bytes(file("a.hits")) == read_bytes(file("b.hits")));
  EXPECT_TRUE(read_bytes(file("c.pfm")) == read_bytes(file("d.pfm")));
}

// --- Crops ------------------------------------------------------------------------------------------------

TEST_F(Views, ACropIsTheSameBitsAsInTheWhole) {
  auto random = seed_.engine();
  constexpr std::size_t width = 61, height = 47;
  for (const bool corners : {true, false}) {
    const Arguments common{"--size", "61x47", "--sampling", corners ? "corners" : "centers"};
    const Made whole = made("whole", common, width, height);
    for (int i = 0; i < 12; ++i) {
      const std::size_t x = random() % width, y = random() % height, w = 1 + random() % (width - x),
                        h = 1 + random() % (height - y);
      expect_part(whole, {x, y, w, h}, corners ? 1 : 0, common);
    }
  }
}

// --- Many views -------------------------------------------------------------------------------------------

TEST_F(Views, AListsPicturesAreThoseOfSingleRuns) {
  list("{\"name\": \"front\"}\n"
       "\n"
       "{\"name\": \"ä b\", \"from\": [0, -5, 1], \"angle\": 30, \"size\": [9, 7]}\n"
       "{\"at\": [0.5, 0, 0.5], \"up\": [0, 1, 1]}\r\n");
  for (const std::string ending : {"png", "pfm"}) {
    render(words("--views ~/list --hits ~/v-{index}.hits --size 20x10 -o ~/v-{name}." + ending));
    const std::vector<std::pair<std::string, Arguments>> singles{
        {"front", {}},
        {"ä b", {"--from", "0,-5,1", "--angle", "30", "--size", "9x7"}},
        {"2", {"--at", "0.5,0,0.5", "--up", "0,1,1"}}};
    for (std::size_t i = 0; i < singles.size(); ++i) {
      const auto& [name, camera] = singles[i];
      const std::string single = file("single." + ending);
      const Arguments size = i == 1 ? Arguments{} : Arguments{"--size", "20x10"};
      render(joined(joined({"-o", single, "--hits", file("single.hits")}, size), camera));
      EXPECT_TRUE(read_bytes(single) == read_bytes(file("v-" + name + "." + ending))) << name;
      EXPECT_TRUE(read_bytes(file("single.hits")) == read_bytes(file(fmt::format("v-{}.hits", i)))) << name;
    }
  }
}

TEST_F(Views, AListMayComeFromStandardInput) {
  expect_run("gridrender", on_cpu({"--views", "-", "-o", file("{index}.png")}),
             {.input = list("{\"angle\": 20}\n{\"angle\": 30}")});
  render({"-o", file("single.png"), "--angle", "30"});
  EXPECT_TRUE(read_bytes(file("single.png")) == read_bytes(file("1.png")));
}

TEST_F(Views, FilesAreIndependentOfTheNumberOfThreads) {
  const Arguments options =
      words("--backend cpu --turntable 12 --size 40x30 -o ~/{index}.png --hits ~/{index}.hits");
  const auto rendered = [&](const char* threads, const std::string& structure) {
    expect_run("gridrender", joined({scene_, structure, "--threads", threads}, options));
    std::vector<Bytes> all;
    for (int i = 0; i < 12; ++i)
      for (const char* const ending : {"png", "hits"})
        all.push_back(read_bytes(file(fmt::format("{:02}.{}", i, ending))));
    return all;
  };
  const auto one = rendered("1", grid_);
  std::set<std::string> distinct;
  for (const Bytes& bytes : one)
    distinct.emplace(bytes.begin(), bytes.end());
  EXPECT_EQ(distinct.size(), one.size());
  EXPECT_TRUE(rendered("2", grid_) == one);
  EXPECT_TRUE(rendered("7", grid_) == one);
  EXPECT_TRUE(rendered("2", "--brute-force") == one) << "a picture tells of the grid";
}

TEST_F(Views, StatsOfSeveralViewsAreSums) {
  const auto first = stats_of({"--angle", "30"}), second = stats_of({"--angle", "50", "--size", "5x5"});
  const auto both = stats_of({"--views", list("{\"angle\": 30}\n{\"angle\": 50, \"size\": [5, 5]}\n")});
  EXPECT_EQ(both["views"], 2);
  for (const char* const name : {"eye_rays", "eye_hits", "shadow_rays", "reflection_rays", "cells_visited"})
    EXPECT_EQ(both[name].get<int>(), first[name].get<int>() + second[name].get<int>()) << name;
}

TEST_F(Views, ATurntableBeginsWithTheCameraAndGoesRoundItsUp) {
  render({"--turntable", "4", "-o", file("{index}.pfm"), "--at", "0,0,0.5", "--from", "3,0,2"});
  const std::vector<std::string> from{"3,0,2", "0,3,2", "-3,0,2", "0,-3,2"};
  for (std::size_t i = 0; i < from.size(); ++i) {
    render({"-o", file("single.pfm"), "--at", "0,0,0.5", "--from=" + from[i]});
    const auto turned = decoded_pfm(file(fmt::format("{}.pfm", i)), 16, 12),
               single = decoded_pfm(file("single.pfm"), 16, 12);
    ASSERT_EQ(turned.size(), 16U * 12 * 3);
    int different = 0; // sines and cosines are rounded: an edge may move over a ray
    for (std::size_t at = 0; at < single.size(); ++at)
      different += std::abs(turned[at] - single[at]) > 1e-3F ? 1 : 0;
    EXPECT_LE(different, i == 0 ? 0 : 12) << i;
  }
}

TEST_F(Views, AFormatIsTakenWhateverTheName) {
  render({"-o", file("a.png")});
  render({"-o", file("named"), "--format", "png"});
  EXPECT_TRUE(read_bytes(file("named")) == read_bytes(file("a.png")));
}

TEST_F(Views, AListIsNotWrittenOverAndOneViewNeedsNoPlaceholder) {
  EXPECT_TRUE(
      refused(1, {"--views", list("{}\n"), "-o", file("list"), "--format", "png"}, file("list"), "itself"));
  render({"--turntable", "1", "-o", file("one.png")});
}

TEST_F(Views, InvalidListsAreRefusedByLine) {
  const auto bad = [&](const std::string& line, const std::string& says) {
    const std::string path = list("{\"name\": \"good\"}\n\n" + line + "\n");
    return refused(2, {"--views", path, "-o", file("{name}.png")}, path + ":3", says);
  };
  EXPECT_TRUE(bad("[1, 2]", "JSON object"));
  EXPECT_TRUE(bad("{\"angle\": 3", "JSON object"));
  EXPECT_TRUE(bad("{\"angle\": 3} {}", "JSON object"));
  EXPECT_TRUE(bad("{\"form\": [1, 2, 3]}", "'form'"));
  EXPECT_TRUE(bad("{\"from\": [1, 2]}", "from"));
  EXPECT_TRUE(bad("{\"from\": [1, 2, \"3\"]}", "from"));
  EXPECT_TRUE(bad("{\"from\": [1e999, 2, 3]}", ""));
  EXPECT_TRUE(bad("{\"from\": [1e13, 2, 3]}", "from"));
  EXPECT_TRUE(bad("{\"from\": [0, 0, 0.5]}", "at"));
  EXPECT_TRUE(bad("{\"up\": [0, 0, 0]}", "up"));
  EXPECT_TRUE(bad("{\"angle\": 180}", "angle"));
  EXPECT_TRUE(bad("{\"angle\": \"45\"}", "angle"));
  for (const char* const size : {"[0, 1]", "[1, 65537]", "[1]", "[1.5, 2]", "\"8x8\"", "[-1, 2]"})
    EXPECT_TRUE(bad(fmt::format("{{\"size\": {}}}", size), "size")) << size;
  for (const char* const name : {"", ".", "..", "a/b", "/", "a\\nb", "\\u0000", "\\u007f"})
    EXPECT_TRUE(bad(fmt::format("{{\"name\": \"{}\"}}", name), "name")) << name;
  EXPECT_TRUE(bad("{\"name\": 7}", "name"));
  EXPECT_TRUE(bad("{\"name\": \"good\"}", ":1"));
  EXPECT_TRUE(refused(2, {"--views", list("\n"), "-o", file("{name}.png")}, file("list"), "no view"));
  EXPECT_TRUE(refused(2, {"--views", file("missing"), "-o", file("{name}.png")}, file("missing")));
  EXPECT_TRUE(
      refused(2, {"--views", folder_.path().string(), "-o", file("{name}.png")}, folder_.path().string()));
  // A crop must lie within every picture.
  const std::string sizes = list("{}\n{\"size\": [4, 4]}\n");
  EXPECT_TRUE(refused(1, {"--views", sizes, "-o", file("{name}.png"), "--crop", "0,0,5,1"}, "--crop"));
}

// --- Devices and bands ------------------------------------------------------------------------------------

TEST_F(Views, TheCpuIsADevice) {
  render({"-o", file("a.png")});
  expect_run("gridrender", {scene_, grid_, "-o", file("b.png"), "--devices", "cpu"});
  EXPECT_TRUE(read_bytes(file("a.png")) == read_bytes(file("b.png")));
}

// Of 1048 rows each: records, floats and pixels around their borders are those of crops, which are one band.
TEST_F(Views, BandsOfLargePicturesAreTheSameBitsAsThePictureUndivided) {
  constexpr std::size_t width = 1333, height = 2500, band = 1048;
  for (const bool corners : {true, false}) {
    const std::size_t more = corners ? 1 : 0;
    const Arguments common = words(std::string("--size 1333x2500 --depth 1 --stats ~/stats --sampling ") +
                                   (corners ? "corners" : "centers"));
    const Made whole = made("whole", common, width, height);
    const auto stats = json_in("stats");
    EXPECT_EQ(stats["eye_rays"], (width + more) * (height + more));
    ASSERT_EQ(whole.hits.size(), 8 * (width + more) * (height + more));
    std::size_t met = 0;
    for (std::size_t i = 0; i < whole.hits.size(); i += 8) {
      std::int32_t name = 0;
      std::memcpy(&name, whole.hits.data() + i + 4, 4);
      met += name >= 0 ? 1 : 0;
    }
    EXPECT_EQ(stats["eye_hits"], met);
    for (const std::size_t y : {std::size_t{0}, band - 20, 2 * band - 20, height - 40})
      expect_part(whole, {0, y, width, 40}, more, common);
    // To a pipe, in order.
    for (const char* const format : {"png", "pfm"}) {
      expect_run("gridrender", on_cpu(joined({"-o", "-", "--format", format}, common)),
                 {.output = file("piped")});
      EXPECT_TRUE(read_bytes(file("piped")) == read_bytes(file(fmt::format("whole.{}", format)))) << format;
    }
  }
}

// --- What is said beside the results ----------------------------------------------------------------------

TEST_F(Views, ASummaryIsOneLineAndQuietSilencesIt) {
  const ToolResult said = try_render({"-o", file("a.png")});
  EXPECT_TRUE(said.err.starts_with("gridrender: 221 rays in ")) << said.err;
  EXPECT_EQ(std::count(said.err.begin(), said.err.end(), '\n'), 1);
  EXPECT_EQ(try_render({"-o", file("a.png"), "-q"}).err, "");
}

TEST_F(Views, PicturesTellTheirSceneAndViewButNotGridOrThreads) {
  render({"-o", file("a.png"), "--threads", "1"});
  const std::string text = read_text(file("a.png"));
  EXPECT_NE(text.find("Source"), std::string::npos);
  EXPECT_NE(text.find("--from 3,-4,2 --at 0,0,0.5 --up 0,0,1 --angle 45 --size 16x12"), std::string::npos);
  expect_run("gridrender", {scene_, grid("b.grid", scene_, "3x2x1"), "--backend", "cpu", "-o", file("b.png"),
                            "--threads", "2", "--stats", file("stats")});
  EXPECT_TRUE(read_bytes(file("b.png")) == read_bytes(file("a.png")));
}

} // namespace
} // namespace masu
