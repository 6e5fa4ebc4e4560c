// What the tools say of a hierarchy: its boxes and histograms, and walks through it.
#include "tests/tools/run_tool.h"
#include "tools/common/json.h"

#include <algorithm>
#include <array>

namespace masu {
namespace {

class HierarchyTool : public ToolTest {
protected:
  // The values of each line but the first.
  std::vector<std::vector<double>> boxes(const Arguments& more = {}) const {
    expect_run("gridstat", joined({hierarchy_, "--cells", file("boxes.csv")}, more));
    const Csv<double> csv = read_csv<double>(file("boxes.csv"));
    EXPECT_EQ(csv.names, "box,depth,min_x,min_y,min_z,max_x,max_y,max_z,references");
    return csv.rows;
  }

  const std::string scene_ = scene("a.scene", spd("a.nff", "tetra", 3)),
                    hierarchy_ = grid("b.grid", scene_, "auto", {"--structure", "bvh"});
};

TEST_F(HierarchyTool, ExportedBoxesAreThoseOfItsStatistics) {
  const Json known = json_of("gridstat", {hierarchy_, "--histogram"});
  const auto all = boxes();
  double references = 0, deepest = 0, of_references = 0, inside = 0;
  for (const auto& row : all) {
    ASSERT_EQ(row.size(), 9U);
    for (std::size_t i = 2; i < 5; ++i)
      EXPECT_LE(row[i], row[i + 3]);
    references += row[8];
    of_references += row[8] > 0;
    deepest = std::max(deepest, row[1]);
    inside += row[2] <= 0.1 && row[5] >= 0 && row[3] <= 0.1 && row[6] >= 0 && row[4] <= 0.1 && row[7] >= 0;
  }
  EXPECT_EQ(all.size(), known["node_boxes"].get<std::size_t>() + known["reference_boxes"].get<std::size_t>());
  EXPECT_EQ(of_references, known["reference_boxes"]);
  EXPECT_EQ(references, known["references"]);
  EXPECT_EQ(deepest + 1, known["depth"]);
  EXPECT_EQ(boxes({"--occupied"}).size(), known["reference_boxes"]);
  EXPECT_EQ(boxes({"--within", "0,0,0,0.1,0.1,0.1"}).size(), inside);
  EXPECT_TRUE(boxes({"--within", "100,100,100,101,101,101"}).empty());

  double counted = 0, held = 0, by_depth = 0;
  for (const auto& [each, number] : known["histogram"].get<std::vector<std::pair<double, double>>>()) {
    counted += number;
    held += each * number;
  }
  for (const auto& [depth, number] :
       known["histogram_by_depth"].get<std::vector<std::pair<double, double>>>())
    by_depth += number;
  EXPECT_EQ(counted, of_references);
  EXPECT_EQ(held, references);
  EXPECT_EQ(by_depth, of_references);
}

// tests/tools/grid_invariance_test.cpp has that both are the same bytes for any number of threads.
TEST_F(HierarchyTool, ItsQualityIsTold) {
  const std::string fast = grid("fast.grid", scene_, "auto", {"--structure", "bvh", "--quality", "fast"});
  EXPECT_EQ(json_of("gridstat", {fast})["quality"], "fast");
  EXPECT_EQ(json_of("gridstat", {hierarchy_})["quality"], "high");
}

TEST_F(HierarchyTool, APlyHasEightCornersOfEachBox) {
  expect_run("gridstat", {hierarchy_, "--cells", file("boxes.ply"), "--wireframe"});
  const std::string head = read_text(file("boxes.ply")).substr(0, 1000);
  EXPECT_NE(head.find("element vertex " + std::to_string(8 * boxes().size()) + "\n"), std::string::npos);
}

TEST_F(HierarchyTool, WhatNeedsCellsIsRefused) {
  expect_refused(1, R"(
gridstat ~/b.grid --slice z=50% --color volume -o ~/a.svg > --color: a hierarchy has none
gridstat ~/b.grid --cells ~/a.ply --expanded              > --expanded: a hierarchy has none
)");
}

// [first u, first v, end u, end v, references, depth, voxels, number] in shares of the space.
TEST_F(HierarchyTool, ASlicesRectanglesAreTheBoxesThatThePlaneCuts) {
  const auto all = boxes();
  for (const std::size_t axis : {0U, 1U, 2U}) {
    const std::size_t u = axis == 0 ? 1 : 0, v = axis == 2 ? 1 : 2;
    for (const std::string depth : {"", "0", "1", "2"}) {
      Arguments arguments{hierarchy_, "--slice", std::string(1, "xyz"[axis]) + "=30%", "-o", file("a.json")};
      if (!depth.empty()) arguments.insert(arguments.end(), {"--depth", depth});
      expect_run("gridstat", arguments);
      const Json slice = json_in("a.json");
      EXPECT_EQ(slice["structure"], "bvh");
      const double at = slice["position"];
      const auto low = slice["space"]["min"].get<std::vector<double>>(),
                 high = slice["space"]["max"].get<std::vector<double>>();
      std::size_t next = 0;
      for (const auto& row : all) {
        const bool meets = row[2 + axis] <= at && at <= row[5 + axis];
        if (!meets || (!depth.empty() && row[1] != std::stod(depth))) continue;
        ASSERT_LT(next, slice["cells"].size());
        const Json& cell = slice["cells"][next++];
        const auto share = [&](double value, std::size_t i) { return (value - low[i]) / (high[i] - low[i]); };
        const std::array corners{row[2 + u], row[2 + v], row[5 + u], row[5 + v]};
        for (std::size_t i = 0; i < 4; ++i)
          EXPECT_NEAR(cell[i].get<double>(), share(corners[i], i % 2), 1e-12);
        EXPECT_EQ(cell[4], row[8]);
        EXPECT_EQ(cell[5], row[1]);
        EXPECT_EQ(cell[7], row[0]);
      }
      EXPECT_EQ(next, slice["cells"].size());
      EXPECT_TRUE(next > 0 || depth == "2"); // the plane lies in a box of the root and of its nodes
    }
  }
}

TEST_F(HierarchyTool, PicturesOfASliceAreWrittenForEachColor) {
  for (const std::string color : {"references", "depth"}) {
    expect_runs("gridstat ~/b.grid --slice z=30% --lines --outline ~/a.scene -o ~/a[.png|.svg] --color " +
                color);
    for (const char* const name : {"a.png", "a.svg"})
      EXPECT_GT(read_bytes(file(name)).size(), 3000U);
  }
  const std::string text = read_text(file("a.svg"));
  EXPECT_NE(text.find("<title>b.grid, z = "), std::string::npos);
  EXPECT_NE(text.find("<desc>hierarchy, "), std::string::npos);
  EXPECT_NE(text.find("Colour: depth of nesting"), std::string::npos);
  EXPECT_EQ(text.find("layer"), std::string::npos); // a hierarchy has none
}

TEST_F(HierarchyTool, AWalkThroughItEndsAtTheGridsHit) {
  const std::string cells = grid("c.grid", scene_);
  int hits = 0;
  for (int i = 0; i < 8; ++i) {
    const std::string pixel = std::to_string(60 * i + 40) + "," + std::to_string(500 - 50 * i);
    const auto ray_through = [&](const std::string& structure) {
      return json_of("gridtrace", {scene_, structure, "--pixel", pixel})["rays"][0];
    };
    const Json ray = ray_through(hierarchy_), other = ray_through(cells);
    EXPECT_EQ(ray["hit"], other["hit"]);
    hits += ray["hit"].is_null() ? 0 : 1;
    std::size_t tests = 0;
    for (const Json& step : ray["steps"]) {
      EXPECT_TRUE(step["voxels"].is_null());
      tests += step["tests"].size();
    }
    EXPECT_EQ(ray["tests"], tests);
    EXPECT_EQ(ray["cells"], ray["steps"].size());
    if (!ray["steps"].empty()) {
      EXPECT_EQ(ray["steps"][0]["node"]["index"], 0);
    }
  }
  EXPECT_GT(hits, 1);
  const ToolResult table = run("gridtrace", {scene_, hierarchy_, "--pixel", "256,256"});
  EXPECT_TRUE(succeeded(table));
  EXPECT_NE(table.out.find("node   depth  met missed beyond"), std::string::npos);
}

} // namespace
} // namespace masu
