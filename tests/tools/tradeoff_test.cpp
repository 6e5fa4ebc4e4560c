// gridbench tradeoff: measurements, continuing after a stop, Pareto fronts, charts.
#include "stability/random_seed.h"
#include "tests/tools/run_tool.h"
#include "tools/bench/tradeoff/tradeoff.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <random>

namespace masu {
namespace {

// --- The front ------------------------------------------------------------------------------------------

// Whether `a` is at least as good in both, and better in one.
bool dominates(const Merit& a, const Merit& b) {
  return a.speed >= b.speed && a.error <= b.error && (a.speed > b.speed || a.error < b.error);
}

// Few distinct values, so that many are equal.
std::vector<Merit> random_merits(std::mt19937_64& random) {
  std::vector<Merit> merits(random() % 40);
  for (Merit& merit : merits)
    merit = {static_cast<double>(random() % 12), static_cast<double>(random() % 12)};
  return merits;
}

TEST(ParetoFront, HoldsExactlyTheRowsThatNoOtherDominates) {
  const RandomSeed seed;
  SCOPED_TRACE(seed.trace());
  auto random = seed.engine();
  for (int turn = 0; turn < 500; ++turn) {
    const std::vector<Merit> merits = random_merits(random);
    const std::vector<std::size_t> front = pareto_front(merits);
    EXPECT_EQ(front.empty(), merits.empty());
    for (const std::size_t i : front) {
      EXPECT_TRUE(std::ranges::none_of(merits, [&](const Merit& m) { return dominates(m, merits[i]); }));
    }
    for (const Merit& merit : merits) {
      EXPECT_TRUE(std::any_of(front.begin(), front.end(), [&](std::size_t i) {
        return merits[i].speed >= merit.speed && merits[i].error <= merit.error;
      }));
    }
    for (std::size_t i = 1; i < front.size(); ++i) {
      EXPECT_LT(merits[front[i]].speed, merits[front[i - 1]].speed);
      EXPECT_LT(merits[front[i]].error, merits[front[i - 1]].error);
    }
  }
}

// --- The tool -------------------------------------------------------------------------------------------

class Tradeoff : public ToolTest {
protected:
  ToolResult measured(const Arguments& more, const Surroundings& surroundings = {}) const {
    const Arguments common = words("tradeoff ~/small.scene -o ~/charts --backend cpu --size 24x18 --random "
                                   "500 --picture 16x12 --repeat 1");
    return run("gridbench", joined(common, more), surroundings);
  }
  // A few configurations, without gnuplot.
  ToolResult measured_few(const Arguments& more = {}) const {
    return measured(joined(words(few), more), without_gnuplot);
  }

  std::string folder() const { return file("charts"); }
  std::string csv() const { return file("charts/tradeoff.csv"); }
  std::vector<TradeoffRow> rows() const { return read_tradeoff_csv(csv()); }

  static constexpr std::string_view few = "--merges none,irregular --overlaps exact --divisions 3 --curve 2";
  const Surroundings without_gnuplot{"/dev/null", "", "PATH=/nonexistent"};
  const std::string scene_ = scene("small.scene", nff("small.nff", small_nff));
};

TEST_F(Tradeoff, EachConfigurationHasARowAndWhatIsProvenNoWrongHits) {
  EXPECT_EQ(measured({"--divisions", "4,auto", "--curve", "2,auto"}, without_gnuplot).code, 0);
  const std::vector<TradeoffRow> all = rows();
  // Three merge modes with two divisions, and irregular; two overlap tests; four precisions and stop rules.
  // A hierarchy, by two precisions. And division 2 of the curve.
  EXPECT_EQ(all.size(), (3U * 2 + 1) * 2 * 4 + 2 + 1);
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_FALSE(all[i].configuration == all[j].configuration);
    const Measurement& m = all[i].measured;
    EXPECT_EQ(all[i].scene, "small");
    EXPECT_EQ(m.accuracy.rays, 24U * 18 + 500);
    for (const double positive : {m.primary_mrays, m.random_mrays, m.mrays, m.picture_ms})
      EXPECT_TRUE(std::isfinite(positive) && positive > 0);
    EXPECT_GT(m.grid_bytes, 4096U);
    EXPECT_GE(m.accuracy.worst_t, m.accuracy.median_t);
    EXPECT_GE(m.accuracy.largest, m.accuracy.rmse);
  }
  // What is proven has no wrong hits.
  for (const TradeoffRow& row : all) {
    const Configuration& c = row.configuration;
    if (c.stop == StopRule::first_cell) continue;
    SCOPED_TRACE(method_of(c) + ", " + grid_of(c));
    const Accuracy& accuracy = row.measured.accuracy;
    EXPECT_EQ(accuracy.wrong(), 0U);
    EXPECT_LT(accuracy.worst_t, 1e-5);
    if (c.precision != Precision::doubled) continue;
    EXPECT_EQ(accuracy.worst_t, 0); // results are independent of the grid
    EXPECT_EQ(accuracy.largest, 0);
  }
}

TEST_F(Tradeoff, RowsInTheFileAreNotMeasuredAgain) {
  EXPECT_EQ(measured_few().code, 0);
  const std::string first = read_text(csv());
  EXPECT_EQ(measured_few().code, 0);
  EXPECT_TRUE(read_text(csv()) == first);
  // Other configurations are appended.
  EXPECT_EQ(measured_few({"--overlaps", "box"}).code, 0);
  const std::string second = read_text(csv());
  EXPECT_TRUE(second.starts_with(first));
  EXPECT_GT(second.size(), first.size());
}

TEST_F(Tradeoff, AnotherSetupOrSceneIsMeasured) {
  EXPECT_EQ(measured_few().code, 0);
  const std::size_t count = rows().size();
  EXPECT_EQ(measured_few({"--seed", "2"}).code, 0);
  EXPECT_EQ(rows().size(), 2 * count);
  scene("small.scene", nff("small.nff", other_nff)); // another scene in the same file
  EXPECT_EQ(measured_few().code, 0);
  EXPECT_EQ(rows().size(), 3 * count);
}

TEST_F(Tradeoff, AnIncompleteLastLineIsMeasuredAgain) {
  EXPECT_EQ(measured_few().code, 0);
  const std::string whole = read_text(csv());
  const std::size_t count = rows().size();
  const std::string kept = whole.substr(0, whole.rfind('\n', whole.size() - 2) + 1);
  for (const std::size_t cut : {whole.size() - 1, whole.size() - 9, kept.size() + 1}) {
    write_text(csv(), whole.substr(0, cut));
    EXPECT_EQ(rows().size(), count - 1);
    EXPECT_EQ(measured_few().code, 0);
    EXPECT_EQ(rows().size(), count);
    EXPECT_TRUE(read_text(csv()).starts_with(kept));
  }
  write_text(csv(), whole.substr(0, 20)); // less than the header
  EXPECT_EQ(measured_few().code, 0);
  EXPECT_EQ(rows().size(), count);
}

TEST_F(Tradeoff, ForeignAndDamagedFilesAreRefusedAndKept) {
  const auto refused = [&](const std::string& text, const std::string& place, const std::string& says) {
    write_text(csv(), text);
    EXPECT_TRUE(failed(measured_few(), 2, "gridbench", place, says));
    EXPECT_TRUE(fails(2, "gridbench", {"tradeoff", "--charts-only", "-o", folder()}, place, says));
    EXPECT_TRUE(read_text(csv()) == text);
  };
  EXPECT_EQ(measured_few().code, 0);
  const std::string whole = read_text(csv());
  const std::size_t head = whole.find('\n') + 1, next_line = rows().size() + 2;
  refused("name,value\nballs,3\n", csv() + ":1", "isn't the head");
  refused("name,value", csv() + ":1", "isn't the head");
  refused(whole.substr(0, head) + "balls,3\n", csv() + ":2", "is missing");
  refused(whole + whole.substr(head, 30) + "\n", csv() + ":" + std::to_string(next_line), "damaged");
  std::string with_word = whole;
  with_word.replace(whole.find("24x18,500") + 6, 3, "5x0");
  refused(with_word, csv() + ":2", "'5x0'");
  refused(whole.substr(0, whole.size() - 1) + ",1\n", csv() + ":" + std::to_string(next_line - 1), "goes on");
}

TEST_F(Tradeoff, TheTableIsTheParetoFront) {
  const ToolResult result = measured_few({"--json"});
  EXPECT_EQ(result.code, 0);
  const auto table = nlohmann::json::parse(result.out, nullptr, false);
  ASSERT_TRUE(table.is_array());
  ASSERT_FALSE(table.empty());
  std::vector<Merit> front;
  for (const auto& row : table) {
    const double wrong =
        row["missed"].get<double>() + row["false_hits"].get<double>() + row["wrong_primitives"].get<double>();
    front.push_back({row["mrays"], wrong / row["rays_compared"].get<double>()});
  }
  for (const Merit& a : front) {
    EXPECT_TRUE(std::none_of(front.begin(), front.end(), [&](const Merit& b) { return dominates(a, b); }));
  }
  for (const TradeoffRow& row : rows()) {
    if (row.configuration.stop != StopRule::proven) continue; // never on a front
    const Merit merit = merit_of_hits(row);
    EXPECT_TRUE(std::any_of(front.begin(), front.end(), [&](const Merit& best) {
      return best.speed >= merit.speed * (1 - 1e-5) && best.error <= merit.error; // the file has six digits
    }));
  }
}

TEST_F(Tradeoff, WithoutGnuplotThereAreRowsATableAndAHint) {
  const ToolResult result = measured_few();
  EXPECT_EQ(result.code, 0);
  EXPECT_NE(result.err.find("gnuplot-nox"), std::string::npos) << result.err;
  EXPECT_NE(result.out.find("small"), std::string::npos);
  EXPECT_FALSE(rows().empty());
  for (const char* const name : {"charts.csv", "tradeoff.csv"}) // results alone are left
    EXPECT_TRUE(std::filesystem::remove(file(std::string("charts/") + name))) << name;
  EXPECT_TRUE(std::filesystem::is_empty(folder()));
}

TEST_F(Tradeoff, ChartsAreDrawnFromTheFile) {
  if (std::system("command -v gnuplot >/dev/null") != 0) GTEST_SKIP() << "gnuplot isn't installed";
  EXPECT_EQ(measured_few().code, 0);
  for (int turn = 0; turn < 2; ++turn) {
    expect_run("gridbench", {"tradeoff", "--charts-only", "-o", folder()});
    for (const char* const name : {"small", "division"}) {
      const std::string path = folder() + "/" + name;
      EXPECT_NE(read_text(path + ".svg").find("</svg>"), std::string::npos) << path;
      EXPECT_TRUE(read_text(path + ".png").starts_with("\x89PNG")) << path;
      std::filesystem::remove(path + ".svg");
      std::filesystem::remove(path + ".png");
    }
  }
  // With several scenes there is a chart of their mean.
  const std::string other = scene("other.scene", nff("other.nff", other_nff));
  EXPECT_TRUE(succeeded(measured(joined({other}, words(few)))));
  for (const char* const name : {"small", "other", "tradeoff", "division"})
    EXPECT_TRUE(std::filesystem::exists(folder() + "/" + name + ".svg")) << name;
}

TEST_F(Tradeoff, Float64ScenesAreTracedInDoubleOnly) {
  scene("small.scene", nff("small.nff", small_nff), {"--store", "float64"});
  EXPECT_EQ(measured_few().code, 0);
  EXPECT_EQ(rows().size(), 2U * 2 + 1);
  for (const TradeoffRow& row : rows())
    EXPECT_EQ(row.configuration.precision, Precision::doubled);
  EXPECT_TRUE(failed(measured_few({"--precisions", "robust"}), 1, "gridbench", "precision", "float64"));
}

TEST_F(Tradeoff, ChartsOfNoFileAreRefused) {
  expect_refused(2, "gridbench tradeoff -o ~/charts --charts-only > ~/charts/tradeoff.csv");
}

} // namespace
} // namespace masu
