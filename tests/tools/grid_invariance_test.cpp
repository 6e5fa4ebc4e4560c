// Results are independent of the grid: images and hits are the same bytes for every grid, for brute force,
// and for any number of threads; and a grid file is the same bytes for any number of threads.
#include "stability/test_scene.h"
#include "tests/tools/run_tool.h"

#include <fmt/format.h>

#include <array>

namespace masu {
namespace {

struct Case {
  const char* scene;
  int size;          // small: brute force and 1×1×1 voxels try every primitive
  const char* store; // of the scene file, and so the default precision
};

void PrintTo(const Case& c, std::ostream* out) {
  *out << c.scene << " " << c.size << " as " << c.store;
}

class GridInvariance : public ToolTest, public testing::WithParamInterface<Case> {
protected:
  struct Result {
    Bytes picture, hits;
    bool operator==(const Result&) const = default;
  };

  // `arguments`: the grid, or --brute-force, and options.
  Result rendered(const Arguments& arguments) const {
    expect_run("gridrender",
               joined(words("~/a.scene --backend cpu --size 24x24 -o ~/a.pfm --hits ~/hits"), arguments));
    return {read_bytes(file("a.pfm")), read_bytes(file("hits"))};
  }

  // Builds the grid with one thread and with two; both must be the same file.
  std::string built(const std::string& division, const Arguments& rules) const {
    const std::string path = grid("a.grid", scene_, division, joined(rules, {"--threads", "1"})),
                      other = grid("b.grid", scene_, division, joined(rules, {"--threads", "2"}));
    EXPECT_TRUE(read_bytes(path) == read_bytes(other)) << "the grid file depends on the number of threads";
    return path;
  }

  const std::string scene_ =
      scene("a.scene", spd("a.nff", GetParam().scene, GetParam().size), {"--store", GetParam().store});
};

TEST_P(GridInvariance, ResultsAreIndependentOfUniformGrids) {
  const Result expected = rendered({"--brute-force"});
  ASSERT_EQ(expected.picture.size(), std::string_view("PF\n24 24\n-1.0\n").size() + 24 * 24 * 12);
  ASSERT_EQ(expected.hits.size(), 25U * 25 * 8);
  EXPECT_TRUE(rendered({"--brute-force", "--threads", "1"}) == expected);
  Chance chance(seed_);
  for (const char* const division : {"1", "2", "7", "16", "33x20x5", "128", "300x300x100", "auto"}) {
    const auto* const overlap = chance.one_of({"box", "exact"});
    const auto* const space = chance.one_of({"tight", "cube"});
    SCOPED_TRACE(fmt::format("division {}, overlap {}, space {}", division, overlap, space));
    const std::string path = built(division, {"--overlap", overlap, "--space", space});
    EXPECT_TRUE(rendered({path, "--threads", "2"}) == expected);
  }
  // With counters the kernels are other instances.
  EXPECT_TRUE(rendered({grid("c.grid", scene_), "--threads", "1", "--stats", file("stats")}) == expected);
}

TEST_P(GridInvariance, ResultsAreIndependentOfMergedGrids) {
  const Result expected = rendered({"--brute-force"});
  const std::pair<const char*, Arguments> merged[] = {
      {"33x20x5", {"--merge", "x"}},
      {"auto", {"--merge", "x", "--overlap", "box", "--space", "cube"}},
      {"40x30x20", {"--merge", "balance"}},
      {"auto", {"--merge", "balance", "--target", "2", "--overlap", "box"}},
      {"auto", {"--merge", "irregular"}},
      {"5x4x3", {"--merge", "irregular", "--nested", "3", "--step-cost", "0.5", "--overlap", "box"}},
      {"1", {"--merge", "irregular", "--detail", "10", "--alpha", "0.8", "--space", "cube"}},
      {"16", {"--merge", "irregular", "--expand", "0", "--step-cost", "10"}},
      {"auto", {"--structure", "bvh"}},
      {"auto", {"--structure", "bvh", "--quality", "fast"}},
  };
  for (const auto& [division, rules] : merged) {
    SCOPED_TRACE(fmt::format("division {}, {}", division, fmt::join(rules, " ")));
    const std::string path = built(division, rules);
    EXPECT_TRUE(rendered({path, "--threads", "2"}) == expected);
    // With counters the kernels are other instances.
    EXPECT_TRUE(rendered({path, "--stats", file("stats")}) == expected);
  }
}

// The default precision is the store's; double precision on a float32 store must be independent, too.
TEST_P(GridInvariance, ResultsInDoubleAreIndependentOfGrids) {
  const bool is_float32 = std::string_view(GetParam().store) == "float32";
  const std::string uniform = built("16", {"--merge", "none"}),
                    merged = built("auto", {"--merge", "irregular"}),
                    hierarchy = built("auto", {"--structure", "bvh"});
  EXPECT_TRUE(rendered({uniform}) == rendered({uniform, "--precision", is_float32 ? "robust" : "double"}));
  const Result expected = rendered({"--brute-force", "--precision", "double"});
  for (const std::string& path : {uniform, merged, hierarchy})
    EXPECT_TRUE(rendered({path, "--precision", "double"}) == expected);
}

constexpr std::array<Case, 16> scenes{{
    {"balls", 2, "float32"},
    {"balls", 1, "float64"},
    {"gears", 1, "float32"},
    {"gears", 1, "float64"},
    {"mount", 3, "float32"},
    {"mount", 2, "float64"},
    {"nurbs", 1, "float32"},
    {"nurbs", 1, "float64"},
    {"rings", 1, "float32"},
    {"rings", 1, "float64"},
    {"teapot", 2, "float32"},
    {"teapot", 2, "float64"},
    {"tetra", 4, "float32"},
    {"tetra", 3, "float64"},
    {"tree", 4, "float32"},
    {"tree", 3, "float64"},
}};

INSTANTIATE_TEST_SUITE_P(Spd, GridInvariance, testing::ValuesIn(scenes), [](const auto& test) {
  return fmt::format("{}{}", test.param.scene, test.param.store);
});

} // namespace
} // namespace masu
