// Channels of gridrender, ways of gridtrace and differences of gridbench: files agree with --hits and
// --stats, and damaged options and files are refused.
#include "tests/decoded_image.h"
#include "tests/tools/run_tool.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <numeric>
#include <sstream>

namespace masu {
namespace {

struct NamedHit {
  float t;
  std::int32_t name;
};

class Inspection : public SmallSceneTest {
protected:
  Inspection() : SmallSceneTest("5") {}

  std::vector<float> pfm(const std::string& name, std::size_t width, std::size_t height) const {
    std::vector<float> values = decoded_pfm(file(name), width, height, 1);
    EXPECT_EQ(values.size(), width * height) << name;
    values.resize(width * height);
    return values;
  }
  template <class T>
  std::vector<T> npy(const std::string& name, const std::string& header) const {
    const Npy array = read_npy(file(name));
    EXPECT_NE(array.head.find(header), std::string::npos) << name;
    std::vector<T> values(array.values.size() / sizeof(T));
    std::memcpy(values.data(), array.values.data(), values.size() * sizeof(T));
    return values;
  }
  static double sum(const std::vector<float>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0);
  }
  static double tests_of(const nlohmann::json& stats) {
    const auto& tests = stats["intersection_tests"];
    return tests["triangle"].get<double>() + tests["sphere"].get<double>() + tests["cone"].get<double>();
  }
};

// --- Channels ---------------------------------------------------------------------------------------------

TEST_F(Inspection, ChannelsAreTheHitsAndSumUpToTheStatistics) {
  struct Rays {
    Arguments options;
    std::size_t width, height;
  };
  for (const auto& [options, width, height] : {Rays{{"--sampling", "corners"}, 17, 13},
                                               {{"--sampling", "centers"}, 16, 12},
                                               {{"--crop", "3,2,5,4"}, 6, 5}}) {
    render(joined(
        words(
            "-o ~/p.pfm --hits ~/hits --channels depth,object,normal,cells,tests --all-rays --stats ~/stats"),
        options));
    const auto stats = json_in("stats");
    EXPECT_EQ(sum(pfm("p.cells.pfm", width, height)), stats["cells_visited"].get<double>());
    EXPECT_EQ(sum(pfm("p.tests.pfm", width, height)), tests_of(stats));
    const auto records = read_records<NamedHit>(file("hits"));
    const auto depth = pfm("p.depth.pfm", width, height), object = pfm("p.object.pfm", width, height);
    ASSERT_EQ(records.size(), depth.size());
    for (std::size_t i = 0; i < records.size(); ++i) {
      EXPECT_EQ(std::memcmp(&records[i].t, &depth[i], sizeof(float)), 0);
      EXPECT_EQ(static_cast<float>(records[i].name), object[i]);
    }
  }
}

TEST_F(Inspection, ArraysHaveTheValuesAndTheirTypes) {
  render({"-o", file("p.png"), "--channels", "depth,normal,object,primitive,cells,tests,idle"});
  const std::string shape = "(13, 17, )";
  render({"-o", file("q.png"), "--channels", "depth,normal,object,primitive,cells,tests,idle",
          "--channel-format", "npy", "--no-picture"});
  EXPECT_FALSE(std::filesystem::exists(file("q.png")));
  EXPECT_TRUE(read_bytes(file("p.tests.png")) == read_bytes(file("q.tests.png")));
  const auto compare = [&](const std::string& channel, const auto& values) {
    const auto floats = pfm("p." + channel + ".pfm", 17, 13);
    ASSERT_EQ(values.size(), floats.size());
    for (std::size_t i = 0; i < floats.size(); ++i)
      EXPECT_EQ(static_cast<float>(values[i]), floats[i]);
  };
  compare("depth", npy<float>("q.depth.npy", "'<f4', 'fortran_order': False, 'shape': " + shape));
  compare("idle", npy<float>("q.idle.npy", "'<f4'"));
  compare("object", npy<std::int32_t>("q.object.npy", "'<i4', 'fortran_order': False, 'shape': " + shape));
  compare("primitive", npy<std::int32_t>("q.primitive.npy", "'<i4'"));
  compare("cells", npy<std::uint32_t>("q.cells.npy", "'<u4'"));
  compare("tests", npy<std::uint32_t>("q.tests.npy", "'<u4'"));
  EXPECT_EQ(npy<float>("q.normal.npy", "(13, 17, 3, )").size(), 3U * 13 * 17);
}

TEST_F(Inspection, PicturesOfCountsEndTheirScaleWhereAsked) {
  render({"-o", file("p.png"), "--channels", "depth,tests", "--no-picture"});
  render({"-o", file("q.png"), "--channels", "depth,tests", "--no-picture", "--channel-high", "1000"});
  EXPECT_TRUE(read_bytes(file("p.tests.pfm")) == read_bytes(file("q.tests.pfm")));
  EXPECT_FALSE(read_bytes(file("p.tests.png")) == read_bytes(file("q.tests.png")));
  EXPECT_TRUE(read_bytes(file("p.depth.png")) == read_bytes(file("q.depth.png")));
}

TEST_F(Inspection, ChannelsOfViewsHaveTheNamesOfTheirPictures) {
  write_text(file("list"),
             "{\"name\": \"one\"}\n{\"name\": \"two\", \"from\": [1, 4, 3], \"size\": [8, 6]}\n");
  render({"--views", file("list"), "-o", file("p-{name}-{index}.png"), "--channels", "depth"});
  EXPECT_TRUE(std::filesystem::exists(file("p-one-0.png")));
  static_cast<void>(pfm("p-one-0.depth.pfm", 17, 13));
  static_cast<void>(pfm("p-two-1.depth.pfm", 9, 7));
  EXPECT_TRUE(std::filesystem::exists(file("p-two-1.depth.png")));
  // A view named as another one's channel.
  write_text(file("list"), "{\"name\": \"a\"}\n{\"name\": \"a.depth\"}\n");
  EXPECT_TRUE(fails(1, "gridrender",
                    on_cpu({"--views", file("list"), "-o", file("{name}.png"), "--channels", "depth"}),
                    file("a.depth.png"), "twice"));
}

TEST_F(Inspection, FilesDoNotDependOnGridAndThreads) {
  expect_runs(R"(
gridrender ~/a.scene ~/a.grid --backend cpu --channels depth,normal,object,primitive -o ~/p.png
gridrender ~/a.scene --brute-force --backend cpu --threads 1 --channels depth,normal,object,primitive -o ~/q.png
)");
  for (const std::string channel : {"depth", "normal", "object", "primitive"})
    for (const std::string ending : {".pfm", ".png"})
      EXPECT_TRUE(read_bytes(file("p." + channel + ending)) == read_bytes(file("q." + channel + ending)));
}

TEST_F(Inspection, ChannelsAreNotWrittenOverTheScene) {
  const std::string source = scene("b.depth.png", text_);
  EXPECT_TRUE(fails(1, "gridrender", {source, grid_, "-o", file("b.png"), "--channels", "depth"}, source,
                    "is the input"));
}

// --- Walks ------------------------------------------------------------------------------------------------

TEST_F(Inspection, AWalksHitAndCountsAreTheChannels) {
  render({"-o", file("p.png"), "--channels", "depth,primitive,cells,tests", "--no-picture"});
  const auto depth = pfm("p.depth.pfm", 17, 13), primitive = pfm("p.primitive.pfm", 17, 13),
             cells = pfm("p.cells.pfm", 17, 13), tests = pfm("p.tests.pfm", 17, 13);
  std::size_t hits = 0;
  for (std::size_t i = 0; i < depth.size(); i += 7) {
    trace({"--pixel", fmt::format("{},{}", i % 17, i / 17), "--json=" + file("walk")});
    const auto rays = json_in("walk")["rays"];
    ASSERT_EQ(rays.size(), 1U);
    const auto& ray = rays[0];
    EXPECT_EQ(ray["kind"], "camera");
    EXPECT_EQ(ray["hit"].is_null(), std::isinf(depth[i]));
    if (!ray["hit"].is_null()) {
      ++hits;
      EXPECT_EQ(ray["hit"]["t"].get<float>(), depth[i]);
      EXPECT_EQ(ray["hit"]["primitive"].get<float>(), primitive[i]);
    }
    EXPECT_EQ(ray["cells"].get<float>(), cells[i]);
    EXPECT_EQ(ray["tests"].get<float>(), tests[i]);
    EXPECT_EQ(ray["steps"].size(), ray["cells"].get<std::size_t>());
  }
  EXPECT_GT(hits, 3U);
}

TEST_F(Inspection, WalksGoToStandardOutputAsTablesOrJson) {
  const ToolResult table = run("gridtrace", on_cpu({"--pixel", "8,6", "--all-rays"}));
  EXPECT_EQ(table.code, 0);
  EXPECT_NE(table.out.find("ray 0: camera"), std::string::npos);
  EXPECT_NE(table.out.find("shadow, spawned by ray 0"), std::string::npos);
  std::istringstream lines(table.out);
  for (std::string line; std::getline(lines, line);)
    EXPECT_LE(line.size(), 80U) << line;
  const auto walk = json_of("gridtrace", on_cpu({"--ray", "3,-4,2,-3,4,-2"}));
  EXPECT_EQ(walk["rays"][0]["origin"], nlohmann::json({3.0, -4.0, 2.0}));
  EXPECT_FALSE(walk["rays"][0]["hit"].is_null());
}

// All of a walk is printed, or nothing.
TEST_F(Inspection, AWalkOfTooManyRaysIsRefused) {
  std::string text = "v\nfrom 0 -4 0.3\nat 0 0 0\nup 0 0 1\nangle 45\nhither 0.01\nresolution 64 64\n"
                     "f 1 1 1 0 0.5 9 0.5 1.5\n";
  for (int i = 0; i < 30; ++i)
    text += fmt::format("s 0 0 0 {}\n", 1 - 0.03 * i);
  const std::string glass = scene("glass", nff("glass.nff", text));
  const auto walk = [&, glass_grid = grid("glass.grid", glass)](const char* depth) {
    return run("gridtrace",
               {glass, glass_grid, "--pixel", "32,32", "--all-rays", "--depth", depth, "--json"});
  };
  const ToolResult some = walk("8"), too_many = walk("32");
  ASSERT_EQ(some.code, 0);
  EXPECT_GT(nlohmann::json::parse(some.out)["rays"].size(), 20U);
  EXPECT_TRUE(failed(too_many, 1, "gridtrace", "--all-rays", "smaller --depth"));
  EXPECT_EQ(too_many.out, "");
}

// --- Differences ------------------------------------------------------------------------------------------

TEST_F(Inspection, DifferencesAreMeasuredAndDrawn) {
  render({"-o", file("a.pfm"), "--channels", "depth", "--sampling", "centers"});
  render({"-o", file("b.pfm"), "--channels", "depth", "--sampling", "centers", "--from", "3,-4,2.5"});
  const auto difference = [&](const std::string& a, const std::string& b, const Arguments& more = {}) {
    return json_of("gridbench", joined({"difference", file(a), file(b)}, more));
  };
  const auto none = difference("a.pfm", "a.pfm");
  EXPECT_EQ(none["rmse"], 0.0);
  EXPECT_EQ(none["different_pixels"], 0);
  EXPECT_TRUE(none["largest_at"].is_null());
  // Infinities in the same places are equal, others can't be compared.
  EXPECT_EQ(difference("a.depth.pfm", "a.depth.pfm")["different_pixels"], 0);
  const auto a = pfm("a.depth.pfm", 16, 12), b = pfm("b.depth.pfm", 16, 12);
  double squares = 0, largest = 0;
  std::size_t compared = 0, incomparable = 0, different = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    different += a[i] != b[i];
    if (std::isinf(a[i]) != std::isinf(b[i])) ++incomparable;
    const double d = a[i] == b[i] ? 0 : std::abs(static_cast<double>(a[i]) - static_cast<double>(b[i]));
    if (std::isinf(d)) continue;
    ++compared;
    squares += d * d;
    largest = std::max(largest, d);
  }
  const auto depth = difference("a.depth.pfm", "b.depth.pfm", {"-o", file("d.png")});
  EXPECT_NEAR(depth["rmse"].get<double>(), std::sqrt(squares / static_cast<double>(compared)), 1e-12);
  EXPECT_EQ(depth["largest"], largest);
  EXPECT_EQ(depth["different_pixels"], different);
  EXPECT_EQ(depth["incomparable_pixels"], incomparable);
  EXPECT_TRUE(std::filesystem::exists(file("d.png")));
  EXPECT_GT(difference("a.pfm", "b.pfm")["rmse"], 0.0);
}

TEST_F(Inspection, DifferencesReadEveryFormat) {
  render({"-o", file("a.png"), "--channels", "normal", "--sampling", "centers"});
  render({"-o", file("b.png"), "--channels", "normal", "--channel-format", "npy", "--sampling", "centers"});
  const auto same = [&](const std::string& a, const std::string& b) {
    const ToolResult result = run("gridbench", {"difference", file(a), file(b)});
    EXPECT_EQ(result.code, 0) << result.err;
    return result.out == "RMSE 0, largest difference 0; 0 of 192 pixels differ\n";
  };
  EXPECT_TRUE(same("a.png", "b.png"));
  EXPECT_TRUE(same("a.normal.pfm", "b.normal.npy"));
  // By the PFM's scale: here big-endian.
  write_text(file("big"),
             std::string("PF\n1 1\n1.0\n", 11) + std::string("\x3f\x80\0\0\0\0\0\0\x3f\0\0\0", 12));
  write_text(file("little"),
             std::string("PF\n1 1\n-1.0\n", 12) + std::string("\0\0\x80\x3f\0\0\0\0\0\0\0\x3f", 12));
  EXPECT_EQ(run("gridbench", {"difference", file("big"), file("little")}).out,
            "RMSE 0, largest difference 0; 0 of 1 pixels differ\n");
}

TEST_F(Inspection, DamagedPicturesAreRefused) {
  render({"-o", file("a.png"), "--channels", "depth", "--channel-format", "npy"});
  render({"-o", file("b.pfm")});
  const auto refused_as = [&](const std::string& name) {
    return fails(2, "gridbench", {"difference", file(name), file(name)}, file(name));
  };
  for (const std::string name : {"a.png", "a.depth.npy", "b.pfm"}) {
    const std::string whole = read_text(file(name));
    for (std::size_t length = 0; length < whole.size(); length += 1 + whole.size() / 25) {
      write_text(file("cut"), whole.substr(0, length));
      EXPECT_TRUE(refused_as("cut")) << name << " cut to " << length;
    }
  }
  for (const char* const text :
       {"PF\n4000000000 4000000000\n-1.0\n", "PF\n1000000 1000000\n-1.0\n", "hello"}) {
    write_text(file("cut"), text);
    EXPECT_TRUE(refused_as("cut")) << text;
  }
  expect_refused(2, R"(
gridbench difference ~/none ~/a.png         > ~/none
gridbench difference ~/a.png ~/a.depth.npy  > ~/a.depth.npy: one size
)");
  expect_refused(1, R"(
gridbench difference ~/a.png ~/a.png -o ~/d.pfm > ~/d.pfm: .png
gridbench difference ~/a.png ~/b.pfm -o ~/a.png > ~/a.png: is the input
gridbench difference ~/a.png ~/b.pfm -o -       > -o: standard output
gridbench difference ~/a.png
)");
}

} // namespace
} // namespace masu
