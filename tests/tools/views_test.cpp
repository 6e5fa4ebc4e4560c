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

// A part of rows of records, of some numbers each; (x, y) from the rows' first.
template <class Number>
std::vector<Number> part(const std::vector<Number>& rows, std::size_t row_records, std::size_t numbers,
                         std::size_t x, std::size_t y, std::size_t width, std::size_t height) {
  std::vector<Number> some;
  for (std::size_t row = y; row < y + height; ++row) {
    const auto run = std::span(rows).subspan((row * row_records + x) * numbers, width * numbers);
    some.insert(some.end(), run.begin(), run.end());
  }
  return some;
}

class Views : public SmallSceneTest {
protected:
  ToolResult try_render(const Arguments& more, const Surroundings& surroundings = {}) const {
    return run("gridrender", on_cpu(more), surroundings);
  }
  testing::AssertionResult refused(int code, const Arguments& more, const std::string& place,
                                   const std::string& says = "") const {
    return fails(code, "gridrender", on_cpu(more), place, says);
  }
  std::string list(const std::string& lines) const {
    write_text(file("list"), lines);
    return file("list");
  }
};

// --- Cameras ----------------------------------------------------------------------------------------------

TEST_F(Views, OptionsReplaceTheScenesCamera) {
  std::string text(small_nff);
  text.replace(text.find("from 3 -4 2"), 11, "from 1.5 4 3");
  text.replace(text.find("at 0 0 0.5"), 10, "at 0.25 -0 1");
  text.replace(text.find("up 0 0 1"), 8, "up 1 0 0");
  text.replace(text.find("angle 45"), 8, "angle 60");
  const std::string moved = scene("b.scene", nff("b.nff", text));
  expect_run("gridrender",
             {moved, "--brute-force", "--backend", "cpu", "-o", file("b.pfm"), "--hits", file("b.hits")});
  render({"-o", file("a.pfm"), "--hits", file("a.hits"), "--from", "1.5,4,3", "--at", "0.25,-0,1", "--up",
          "1,0,0", "--angle", "60"});
  EXPECT_TRUE(read_bytes(file("a.pfm")) == read_bytes(file("b.pfm")));
  EXPECT_TRUE(read_bytes(file("a.hits")) == read_bytes(file("b.hits")));
  // What is left out stays the scene's.
  render({"-o", file("c.pfm")});
  render({"-o", file("d.pfm"), "--from", "3,-4,2", "--angle", "45"});
  EXPECT_TRUE(read_bytes(file("c.pfm")) == read_bytes(file("d.pfm")));
}

// --- Crops ------------------------------------------------------------------------------------------------

TEST_F(Views, ACropIsTheSameBitsAsInTheWhole) {
  auto random = seed_.engine();
  constexpr std::size_t width = 61, height = 47;
  for (const bool corners : {true, false}) {
    const std::size_t more = corners ? 1 : 0;
    const Arguments common{"--size", fmt::format("{}x{}", width, height), "--sampling",
                           corners ? "corners" : "centers"};
    const auto made = [&](const char* picture, const Arguments& crop) {
      render(joined(joined({"-o", file(picture), "--hits", file("hits")}, common), crop));
    };
    made("whole.png", {});
    made("whole.pfm", {});
    const Bytes hits = read_bytes(file("hits"));
    const std::vector<float> floats = decoded_pfm(file("whole.pfm"), width, height);
    const DecodedPng whole = decoded_png(file("whole.png"));
    for (int i = 0; i < 12; ++i) {
      const std::size_t x = random() % width, y = random() % height, w = 1 + random() % (width - x),
                        h = 1 + random() % (height - y);
      const std::string crop = fmt::format("{},{},{},{}", x, y, w, h);
      SCOPED_TRACE(crop);
      made("crop.png", {"--crop", crop});
      made("crop.pfm", {"--crop", crop});
      const DecodedPng cropped = decoded_png(file("crop.png"));
      EXPECT_EQ(cropped.width, w);
      EXPECT_EQ(cropped.height, h);
      EXPECT_TRUE(cropped.rgb == part(whole.rgb, width, 3, x, y, w, h));
      EXPECT_TRUE(decoded_pfm(file("crop.pfm"), w, h) == part(floats, width, 3, x, y, w, h));
      EXPECT_TRUE(read_bytes(file("hits")) == part(hits, width + more, 8, x, y, w + more, h + more));
    }
  }
}

// --- Many views -------------------------------------------------------------------------------------------

TEST_F(Views, AListsPicturesAreThoseOfSingleRuns) {
  const std::string views =
      list("{\"name\": \"front\"}\n"
           "\n"
           "{\"name\": \"ä b\", \"from\": [0, -5, 1], \"angle\": 30, \"size\": [9, 7]}\n"
           "{\"at\": [0.5, 0, 0.5], \"up\": [0, 1, 1]}\r\n");
  for (const char* const ending : {"png", "pfm"}) {
    render({"--views", views, "-o", file(fmt::format("v-{{name}}.{}", ending)), "--hits",
            file("v-{index}.hits"), "--size", "20x10"});
    const std::vector<std::pair<std::string, Arguments>> singles{
        {"front", {}},
        {"ä b", {"--from", "0,-5,1", "--angle", "30", "--size", "9x7"}},
        {"2", {"--at", "0.5,0,0.5", "--up", "0,1,1"}}};
    for (std::size_t i = 0; i < singles.size(); ++i) {
      const auto& [name, camera] = singles[i];
      const std::string single = file(fmt::format("single.{}", ending));
      const Arguments size = i == 1 ? Arguments{} : Arguments{"--size", "20x10"};
      render(joined(joined({"-o", single, "--hits", file("single.hits")}, size), camera));
      EXPECT_TRUE(read_bytes(single) == read_bytes(file(fmt::format("v-{}.{}", name, ending)))) << name;
      EXPECT_TRUE(read_bytes(file("single.hits")) == read_bytes(file(fmt::format("v-{}.hits", i)))) << name;
    }
  }
}

TEST_F(Views, AListMayComeFromStandardInput) {
  const std::string views = list("{\"angle\": 20}\n{\"angle\": 30}");
  EXPECT_TRUE(succeeded(try_render({"--views", "-", "-o", file("{index}.png")}, {views, {}, {}})));
  render({"-o", file("single.png"), "--angle", "30"});
  EXPECT_TRUE(read_bytes(file("single.png")) == read_bytes(file("1.png")));
}

TEST_F(Views, FilesAreIndependentOfTheNumberOfThreads) {
  const auto rendered = [&](const char* threads, const std::string& structure) {
    expect_run("gridrender",
               {scene_, structure, "--backend", "cpu", "--turntable", "12", "--size", "40x30", "-o",
                file("{index}.png"), "--hits", file("{index}.hits"), "--threads", threads});
    std::vector<Bytes> all;
    for (int i = 0; i < 12; ++i) {
      all.push_back(read_bytes(file(fmt::format("{:02}.png", i))));
      all.push_back(read_bytes(file(fmt::format("{:02}.hits", i))));
    }
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
    const Arguments common{"--size", "1333x2500",  "--depth",
                           "1",      "--sampling", corners ? "corners" : "centers"};
    const auto made = [&](const char* picture, const Arguments& options) {
      return stats_of(joined(joined({"-o", file(picture), "--hits", file("hits")}, common), options));
    };
    made("whole.png", {});
    const auto stats = made("whole.pfm", {});
    EXPECT_EQ(stats["eye_rays"], (width + more) * (height + more));
    const Bytes hits = read_bytes(file("hits"));
    const std::vector<float> floats = decoded_pfm(file("whole.pfm"), width, height);
    ASSERT_EQ(hits.size(), 8 * (width + more) * (height + more));
    std::size_t met = 0;
    for (std::size_t i = 0; i < hits.size(); i += 8) {
      std::int32_t name = 0;
      std::memcpy(&name, hits.data() + i + 4, 4);
      met += name >= 0 ? 1 : 0;
    }
    EXPECT_EQ(stats["eye_hits"], met);
    const DecodedPng whole = decoded_png(file("whole.png"));
    for (const std::size_t y : {std::size_t{0}, band - 20, 2 * band - 20, height - 40}) {
      const std::string crop = fmt::format("0,{},{},40", y, width);
      made("crop.png", {"--crop", crop});
      made("crop.pfm", {"--crop", crop});
      EXPECT_TRUE(decoded_png(file("crop.png")).rgb == part(whole.rgb, width, 3, 0, y, width, 40));
      EXPECT_TRUE(decoded_pfm(file("crop.pfm"), width, 40) == part(floats, width, 3, 0, y, width, 40));
      EXPECT_TRUE(read_bytes(file("hits")) == part(hits, width + more, 8, 0, y, width + more, 40 + more));
    }
    // To a pipe, in order.
    for (const char* const format : {"png", "pfm"}) {
      EXPECT_TRUE(succeeded(
          try_render(joined({"-o", "-", "--format", format}, common), {"/dev/null", file("piped"), {}})));
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
