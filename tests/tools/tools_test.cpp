// End-to-end runs of the tools: pictures, hits, statistics and files.
#include "tests/decoded_image.h"
#include "tests/tools/run_tool.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <set>
#include <sstream>

namespace masu {
namespace {

struct WrittenHit {
  float t;
  std::int32_t object;
};
std::vector<WrittenHit> hits_in(const std::string& path) {
  return read_records<WrittenHit>(path);
}

class Tools : public SmallSceneTest {
protected:
  // What gridtrace finds for rays of six numbers each.
  std::vector<WrittenHit> hits_of(const std::vector<float>& rays) const {
    write_records(file("rays"), rays);
    trace({file("rays"), "-o", file("hits")});
    std::vector<WrittenHit> hits = hits_in(file("hits"));
    EXPECT_EQ(hits.size(), rays.size() / 6);
    hits.resize(rays.size() / 6);
    return hits;
  }
  nlohmann::json info_of(const std::string& path, const Arguments& more = {}) const {
    return json_of("nff2bin", joined({path, "--info"}, more));
  }
};

// --- Pictures -------------------------------------------------------------------------------------------

std::uint8_t stored(float value) {
  return static_cast<std::uint8_t>(std::clamp(value, 0.0F, 1.0F) * 255 + 0.5F);
}
std::uint8_t encoded(float value) {
  const float v = std::clamp(value, 0.0F, 1.0F);
  return stored(v <= 0.0031308F ? 12.92F * v : 1.055F * std::pow(v, 1 / 2.4F) - 0.055F);
}

TEST_F(Tools, PngsHoldThePfmsValuesInEightBits) {
  for (const std::size_t width : {16U, 31U}) { // as the scene says, and as the option does
    const Arguments size = width == 16 ? Arguments{} : Arguments{"--size", "31x12"};
    const auto made = [&](const char* name, const Arguments& more) {
      render(joined(joined({"-o", file(name)}, size), more));
      return file(name);
    };
    const std::vector<float> values = decoded_pfm(made("a.pfm", {}), width, 12);
    const DecodedPng plain = decoded_png(made("stored.png", {})),
                     srgb = decoded_png(made("a.png", {"--srgb"}));
    EXPECT_EQ(plain.width, width);
    EXPECT_EQ(plain.height, 12U);
    ASSERT_EQ(values.size(), width * 12 * 3);
    ASSERT_EQ(plain.rgb.size(), values.size());
    ASSERT_EQ(srgb.rgb.size(), values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
      EXPECT_TRUE(std::isfinite(values[i]));
      EXPECT_EQ(plain.rgb[i], stored(values[i]));
      EXPECT_NEAR(srgb.rgb[i], encoded(values[i]), 1);
    }
  }
}

TEST_F(Tools, AnEmptySceneIsAllBackground) {
  for (const char* const text :
       {"b 0.25 0.5 0.75\n", "v\nfrom 0 0 5\nat 0 0 0\nup 0 1 0\nangle 45\nhither 1\n"
                             "resolution 4 4\nb 0.25 0.5 0.75\nl 1 1 1\nf 1 1 1 1 1 1 1 1\n"}) {
    const std::string nothing = scene("nothing.scene", nff("nothing.nff", text));
    for (const char* const division : {"auto", "5", "cleary:3"}) {
      const std::string path = grid("nothing.grid", nothing, division);
      expect_run("gridrender", {nothing, path, "-o", file("a.pfm"), "--size", "4x4"});
      const std::vector<float> values = decoded_pfm(file("a.pfm"), 4, 4);
      ASSERT_EQ(values.size(), 48U);
      for (std::size_t i = 0; i < values.size(); ++i)
        EXPECT_EQ(values[i], (std::array{0.25F, 0.5F, 0.75F})[i % 3]);
    }
  }
}

TEST_F(Tools, DepthOneHasNoReflectionRays) {
  EXPECT_EQ(stats_of({"--depth", "1"})["reflection_rays"], 0);
  EXPECT_GT(stats_of({})["reflection_rays"], 0);
}

// --- Hits and rays --------------------------------------------------------------------------------------

TEST_F(Tools, ListedRaysHitWhatCameraRaysHit) {
  std::vector<double> rays;
  for (const int row : {0, 3, 6, 9, 12})
    for (const int column : {0, 4, 8, 12, 16}) {
      const auto ray =
          json_of("gridtrace", on_cpu({"--pixel", fmt::format("{},{}", column, row)}))["rays"][0];
      for (const char* const name : {"origin", "direction"})
        for (const double coordinate : ray[name])
          rays.push_back(name[0] == 'o' ? coordinate : 8 * coordinate); // t counts in its lengths
    }
  write_records(file("rays.f64"), rays);
  render({"--hits", file("camera")});
  trace({file("rays.f64"), "-o", file("listed")});
  expect_run("gridtrace", {scene_, "--brute-force", file("rays.f64"), "-o", file("brute-force")});
  EXPECT_TRUE(read_bytes(file("listed")) == read_bytes(file("brute-force")));
  const std::vector<WrittenHit> camera = hits_in(file("camera")), listed = hits_in(file("listed"));
  ASSERT_EQ(camera.size(), 17U * 13);
  ASSERT_EQ(listed.size(), 25U);
  std::set<std::int32_t> objects;
  for (std::size_t i = 0; i < listed.size(); ++i) {
    const WrittenHit& expected = camera[17 * 3 * (i / 5) + 4 * (i % 5)];
    EXPECT_EQ(listed[i].object, expected.object) << "ray " << i;
    objects.insert(expected.object);
    if (std::isfinite(expected.t))
      EXPECT_NEAR(8 * listed[i].t, expected.t, 1e-4 * expected.t);
    else
      EXPECT_EQ(listed[i].t, expected.t);
  }
  EXPECT_EQ(objects, (std::set<std::int32_t>{-1, 0, 1})); // background, floor, sphere
}

TEST_F(Tools, FirstCellHitMissesCloserHitsOfLaterCells) {
  // In one voxel the first hit is the closest. In two, the floor lies in both and is hit in the first,
  // although a sphere of the second is closer.
  const std::string before = scene(
      "b.scene", nff("b.nff", "v\nfrom -9 0 2\nat 9 0 -2\nup 0 0 1\nangle 10\nhither 1\nresolution 9 9\n"
                              "f 1 1 1 1 0 0 0 1\np 4\n-9 -9 -1\n9 -9 -1\n9 9 -1\n-9 9 -1\ns 3 0 0 0.9\n"));
  const auto objects = [&](const char* division, const Arguments& options) {
    expect_run("gridrender",
               joined({before, grid("b.grid", before, division), "--backend", "cpu", "--hits", file("hits")},
                      options));
    std::vector<std::int32_t> found;
    for (const WrittenHit& hit : hits_in(file("hits")))
      found.push_back(hit.object);
    return found;
  };
  const auto right = objects("2x1x1", {}), wrong = objects("2x1x1", {"--first-cell-hit"});
  EXPECT_EQ(objects("1", {"--first-cell-hit"}), right);
  ASSERT_EQ(wrong.size(), right.size());
  int missed = 0;
  for (std::size_t i = 0; i < right.size(); ++i) {
    missed += right[i] == 1 && wrong[i] == 0 ? 1 : 0;
    EXPECT_TRUE(right[i] == wrong[i] || (right[i] == 1 && wrong[i] == 0)) << "ray " << i;
  }
  EXPECT_GT(missed, 0);
}

TEST_F(Tools, ListedRaysMayBeFloat64) {
  // Where float32 numbers are 2 apart: a sphere of radius 1, hit by every other ray.
  const std::string far = scene("far.scene", nff("far.nff", "f 1 1 1 1 0 0 0 1\ns 20000000.25 0 0 1\n"));
  const std::string far_grid = grid("far.grid", far);
  std::vector<double> rays;
  for (const double aside : {0.0, 1.5, -0.5, -1.125, 1.2, 1.3})
    rays.insert(rays.end(), {20000000 + aside, -3, 0, 0, 1, 0});
  write_records(file("rays"), rays);
  expect_run("gridtrace", {far, far_grid, file("rays"), "--ray-store", "float64", "-o", file("hits")});
  const std::vector<WrittenHit> hits = hits_in(file("hits"));
  ASSERT_EQ(hits.size(), 6U);
  const std::array<bool, 6> hit{true, false, true, false, true, false};
  for (std::size_t i = 0; i < hit.size(); ++i)
    EXPECT_EQ(hits[i].object, hit[i] ? 0 : -1) << "ray " << i;
  EXPECT_NEAR(hits[0].t, 3 - std::sqrt(1 - 0.0625), 1e-6);
}

TEST_F(Tools, ListedRaysMayHaveAnyOriginAndLength) {
  const struct {
    std::array<float, 6> ray;
    std::int32_t object;
    float distance;
  } cases[] = {
      {{0, 0, 5, 0, 0, -1}, 1, 4},          // down onto the sphere
      {{0, 0, 5, 0, 0, -1e-15F}, 1, 4e15F}, // the same, with a short direction
      {{0, 0, 5, 0, 0, -1e15F}, 1, 4e-15F}, // the same, with a long direction
      {{0, 0, 0.5F, 0, 0, 1}, 1, 0.5F},     // from inside
      {{0, 0, 5, 0, 0, 1}, -1, 0},          // away from the scene
      {{1, 1, 1e9F, 0, 0, -1}, 0, 1e9F},    // from afar onto the floor
      {{1e15F, 0, 0, 0, 1, 0}, -1, 0},      // past everything
  };
  std::vector<float> rays;
  for (const auto& [ray, object, distance] : cases)
    rays.insert(rays.end(), ray.begin(), ray.end());
  const std::vector<WrittenHit> hits = hits_of(rays);
  for (std::size_t i = 0; i < hits.size(); ++i) {
    EXPECT_EQ(hits[i].object, cases[i].object) << "ray " << i;
    if (cases[i].object < 0) continue;
    EXPECT_NEAR(hits[i].t / cases[i].distance, 1, 1e-5) << "ray " << i;
  }
}

TEST_F(Tools, AnEmptyListOfRaysHasNoHits) {
  EXPECT_TRUE(hits_of({}).empty());
}

// tests/api/library_test.cpp has all that is wrong with a ray.
TEST_F(Tools, RaysThatArentValidHitNothingAndAreCounted) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  write_records(file("rays"), std::vector<float>{0, 0, 5, 0, 0, -1, 0, nan, 5, 0, 0, -1, 0, 0, 5, 0, 0, 0});
  const ToolResult result = run("gridtrace", on_cpu({file("rays"), "-o", file("hits")}));
  EXPECT_EQ(result.code, 0);
  EXPECT_NE(result.err.find("2 of 3 rays aren't valid"), std::string::npos) << result.err;
  const std::vector<WrittenHit> hits = hits_in(file("hits"));
  ASSERT_EQ(hits.size(), 3U);
  for (std::size_t i = 0; i < hits.size(); ++i)
    EXPECT_EQ(hits[i].object, i == 0 ? 1 : -1) << "ray " << i;
}

TEST_F(Tools, HitsLieBetweenTminAndTmax) {
  // Down onto the sphere, of which the ray meets the top at t = 4, the bottom at 5, and the floor there.
  const float infinity = std::numeric_limits<float>::infinity();
  const struct {
    float t_min, t_max;
    bool hit;
  } cases[] = {{0, infinity, true}, {-1, 4.5F, true},     {0, 3.9F, false},    {4.1F, 4.9F, false},
               {4.1F, 5.5F, true},  {6, infinity, false}, {4.5F, 4.5F, false}, {5, 3, false}};
  std::vector<float> rays;
  for (const auto& c : cases)
    rays.insert(rays.end(), {0, 0, 5, c.t_min, 0, 0, -1, c.t_max});
  write_records(file("rays"), rays);
  trace({file("rays"), "--ray-numbers", "8", "-o", file("hits")});
  trace({file("rays"), "--ray-numbers", "8", "--any-hit", "-o", file("occluded")});
  const std::vector<WrittenHit> hits = hits_in(file("hits"));
  const auto occluded = read_bytes(file("occluded"));
  ASSERT_EQ(hits.size(), std::size(cases));
  ASSERT_EQ(occluded.size(), std::size(cases));
  for (std::size_t i = 0; i < std::size(cases); ++i) {
    EXPECT_EQ(hits[i].object >= 0, cases[i].hit) << i;
    EXPECT_EQ(occluded[i] != 0, cases[i].hit) << i;
    if (!cases[i].hit) continue;
    EXPECT_GE(hits[i].t, cases[i].t_min);
    EXPECT_LE(hits[i].t, cases[i].t_max);
  }
  EXPECT_NEAR(hits[4].t, 5, 1e-6);
}

TEST_F(Tools, HitsHaveTheFieldsThatAreAskedFor) {
  // Down onto the floor's two triangles and onto the sphere, off its pole; and past everything.
  const std::vector<float> rays{1,    0.5F, 5, 0, 0, -1, -1, 0.5F, 5, 0, 0, -1,
                                0.3F, 0,    5, 0, 0, -1, 9,  9,    9, 0, 0, 1};
  write_records(file("rays"), rays);
  trace({file("rays"), "--write", "normal,t,uv,primitive,object", "-o", file("hits")});
  struct Record {
    float normal[3], t, uv[2];
    std::int32_t primitive, object;
  };
  const auto records = read_records<Record>(file("hits"));
  ASSERT_EQ(records.size(), 4U);
  std::set<std::int32_t> floor;
  for (const std::size_t i : {0U, 1U}) {
    EXPECT_EQ(records[i].object, 0);
    EXPECT_EQ(records[i].t, 5);
    EXPECT_EQ(records[i].normal[2], 1);
    EXPECT_GE(records[i].uv[0], 0);
    EXPECT_GE(records[i].uv[1], 0);
    EXPECT_LE(records[i].uv[0] + records[i].uv[1], 1);
    floor.insert(records[i].primitive);
  }
  EXPECT_EQ(floor, (std::set<std::int32_t>{0, 1}));
  EXPECT_EQ(records[2].object, 1);
  EXPECT_NEAR(records[2].normal[0], 0.6, 1e-6);
  EXPECT_NEAR(records[2].normal[2], 0.8, 1e-6);
  EXPECT_EQ(records[3].object, -1);
  EXPECT_EQ(records[3].primitive, -1);
  EXPECT_EQ(records[3].t, std::numeric_limits<float>::infinity());
}

TEST_F(Tools, RaysAndHitsMayBeNumPyArraysAndPipes) {
  const std::vector<float> rays = random_rays(5000, 2);
  const std::string_view raw{reinterpret_cast<const char*>(rays.data()), 4 * rays.size()};
  write_text(file("rays"), raw);
  const std::string head_of_rays =
      npy_head("{'descr': '<f4', 'fortran_order': False, 'shape': (5000, 6), }\n");
  write_text(file("rays.npy"), head_of_rays + std::string(raw));
  trace({file("rays"), "-o", file("hits")});
  trace({file("rays.npy"), "-o", file("from npy")});
  EXPECT_TRUE(read_bytes(file("hits")) == read_bytes(file("from npy")));
  const ToolResult piped = run("gridtrace", {scene_, grid_, "-", "-o", "-", "--backend", "cpu"},
                               {file("rays"), file("piped"), ""});
  EXPECT_EQ(piped.code, 0) << piped.err;
  EXPECT_TRUE(read_bytes(file("hits")) == read_bytes(file("piped")));
  // The array's header, and after it the same records.
  trace({file("rays"), "-o", file("hits.npy")});
  const auto [head, records] = read_npy(file("hits.npy"));
  EXPECT_TRUE(records == read_bytes(file("hits")));
  EXPECT_NE(head.find("'descr': [('t', '<f4'), ('object', '<i4'), ]"), std::string::npos) << head;
  EXPECT_NE(head.find("'shape': (5000 "), std::string::npos) << head;
}

// As raw numbers of both sizes, as text, with limits, and with the numbers of an array that are the columns.
TEST_F(Tools, ListsAreReadAsTheEndOfTheirNameSays) {
  const std::vector<float> rays = random_rays(3000, 2);
  const std::vector<double> wide(rays.begin(), rays.end());
  std::string text = "ox,oy,oz,dx,dy,dz\n", turned = "tmax,dz,dy,dx,oz,oy,ox\n";
  for (auto ray = rays.begin(); ray != rays.end(); ray += 6) {
    text += fmt::format("{}\n", fmt::join(ray, ray + 6, ","));
    turned +=
        fmt::format("inf,{}\n", fmt::join(std::reverse_iterator(ray + 6), std::reverse_iterator(ray), ","));
  }
  write_records(file("rays"), rays);
  write_records(file("rays.f32"), rays);
  write_records(file("rays.f64"), wide);
  write_text(file("rays.csv"), text);
  write_text(file("turned.csv"), turned);
  trace({file("rays"), "-o", file("expected")});
  const Bytes expected = read_bytes(file("expected"));
  for (const char* const name : {"rays.f32", "rays.f64", "rays.csv", "turned.csv"}) {
    trace({file(name), "-o", file("hits")});
    EXPECT_TRUE(read_bytes(file("hits")) == expected) << name;
  }
  // What is said is what counts, as for --format.
  write_records(file("wide.f32"), wide);
  trace({file("wide.f32"), "--ray-store", "float64", "-o", file("hits")});
  EXPECT_TRUE(read_bytes(file("hits")) == expected);
}

// Of a file with such columns: numbers that read back the same.
using HitRows = std::vector<std::vector<float>>;
HitRows rows_of_csv(const std::string& path, const std::string& names) {
  Csv<float> csv = read_csv<float>(path);
  EXPECT_EQ(csv.names, names);
  return csv.rows;
}

TEST_F(Tools, HitsAreWrittenAsTheEndOfTheirNameSays) {
  const std::vector<float> rays = random_rays(40'000, 2); // text of several tasks
  write_records(file("rays"), rays);
  struct Record {
    float numbers[6];
    std::int32_t object, primitive;
  };
  for (const char* const name : {"raw", "raw.f32", "text.csv"})
    trace({file("rays"), "--write", "t,uv,normal,object,primitive", "-o", file(name)});
  const Bytes raw = read_bytes(file("raw"));
  EXPECT_TRUE(read_bytes(file("raw.f32")) == raw);
  const auto records = read_records<Record>(file("raw"));
  const std::string text = read_text(file("text.csv"));
  const auto rows = rows_of_csv(file("text.csv"), "t,u,v,nx,ny,nz,object,primitive");
  ASSERT_EQ(rows.size(), 40'000U);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    ASSERT_EQ(rows[i].size(), 8U);
    ASSERT_TRUE(std::equal(rows[i].begin(), rows[i].begin() + 6, records[i].numbers)) << i;
    ASSERT_EQ(rows[i][6], static_cast<float>(records[i].object));
    ASSERT_EQ(rows[i][7], static_cast<float>(records[i].primitive));
  }
  EXPECT_NE(text.find("\ninf,0,0,0,0,0,-1,-1\n"), std::string::npos); // a miss
  trace({file("rays"), "--any-hit", "-o", file("occluded.csv")});
  const auto occluded = rows_of_csv(file("occluded.csv"), "occluded");
  ASSERT_EQ(occluded.size(), records.size());
  for (std::size_t i = 0; i < occluded.size(); ++i)
    ASSERT_EQ(occluded[i][0], records[i].object >= 0 ? 1.0F : 0.0F);
}

TEST_F(Tools, AllHitsAreListedCountedAndFiltered) {
  // Down through the sphere and onto the floor, whose diagonal it meets; beside the sphere; from inside it;
  // beside everything.
  const std::vector<float> rays{0, 0, 5,    0, 0, -1, 1, 1, 5, 0, 0, -1, //
                                0, 0, 0.5F, 0, 0, 1,  9, 9, 5, 0, 0, -1};
  write_records(file("rays"), rays);
  const auto csv = [&](const Arguments& options, const char* columns) {
    trace(joined({file("rays"), "-o", file("hits.csv")}, options));
    return rows_of_csv(file("hits.csv"), columns);
  };
  const float miss = std::numeric_limits<float>::infinity();
  // A line for each hit.
  for (const std::string most : {"3", "65536"})
    EXPECT_EQ(
        csv({"--all-hits", most}, "ray,hit,t,object,front"),
        (HitRows{{0, 0, 4, 1, 1}, {0, 1, 5, 0, 1}, {0, 2, 5, 1, 0}, {1, 0, 5, 0, 1}, {2, 0, 0.5F, 1, 0}}));
  EXPECT_EQ(csv({"--all-hits", "2", "--write", "front,t64"}, "ray,hit,front,t64"),
            (HitRows{{0, 0, 1, 4}, {0, 1, 1, 5}, {1, 0, 1, 5}, {2, 0, 0, 0.5F}}));
  EXPECT_EQ(csv({"--all-hits", "2", "--write", "normal", "--objects", "0"}, "ray,hit,nx,ny,nz"),
            (HitRows{{0, 0, 0, 0, 1}, {1, 0, 0, 0, 1}}));
  EXPECT_EQ(csv({"--count-hits", "--write", "count,inside"}, "count,inside"),
            (HitRows{{3, 2}, {1, 2}, {1, 1}, {0, 0}})); // the floor isn't closed
  EXPECT_EQ(csv({"--faces", "back", "--write", "t64,object"}, "t64,object"),
            (HitRows{{5, 1}, {miss, -1}, {0.5F, 1}, {miss, -1}}));
  write_records(file("none"), std::vector<std::int32_t>{2, -1, 2, -1}); // the sphere
  EXPECT_EQ(csv({"--exclude", file("none")}, "t,object"), (HitRows{{5, 0}, {5, 0}, {miss, -1}, {miss, -1}}));
  EXPECT_EQ(csv({"--objects", "0"}, "t,object"), (HitRows{{5, 0}, {5, 0}, {miss, -1}, {miss, -1}}));
  EXPECT_EQ(csv({"--objects", "1,0-1", "--count-hits"}, "count"), (HitRows{{3}, {1}, {1}, {0}}));
  expect_runs(R"(
gridtrace ~/a.scene ~/a.grid ~/rays --all-hits 20 -o ~/records --backend cpu
gridtrace ~/a.scene ~/a.grid ~/rays --all-hits 20 -o ~/one --backend cpu --threads 1
gridtrace ~/a.scene ~/rays --all-hits 20 -o ~/brute --backend cpu --brute-force
)");
  const Bytes records = read_bytes(file("records"));
  EXPECT_EQ(records.size(), 4U * (4 + 20 * 9));
  EXPECT_TRUE(read_bytes(file("one")) == records);
  EXPECT_TRUE(read_bytes(file("brute")) == records);
}

TEST_F(Tools, HitsOfPicturesAreWrittenAsTheEndOfTheirNameSaysToo) {
  for (const std::string kind : {"object", "primitive"}) {
    const auto hits = [&](const std::string& name) { // of two bands
      render({"--hits", file(name), "--hit-name", kind, "--size", "1333x1300", "--depth", "1"});
      return read_bytes(file(name));
    };
    const Bytes raw = hits("raw");
    hits("a.npy");
    const auto [head, records_of_array] = read_npy(file("a.npy"));
    EXPECT_TRUE(records_of_array == raw);
    EXPECT_EQ(head.size(), 128U);
    EXPECT_NE(head.find("'descr': [('t', '<f4'), ('" + kind + "', '<i4'), ]"), std::string::npos) << head;
    EXPECT_NE(head.find("'shape': (1735534 "), std::string::npos) << head;
    hits("a.csv");
    const auto rows = rows_of_csv(file("a.csv"), "t," + kind);
    const std::vector<WrittenHit> records = hits_in(file("raw"));
    ASSERT_EQ(rows.size(), records.size());
    // The floor is two triangles, before the sphere.
    EXPECT_EQ(std::ranges::max(records, {}, &WrittenHit::object).object, kind == "object" ? 1 : 2);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      ASSERT_EQ(rows[i][0], records[i].t);
      ASSERT_EQ(rows[i][1], static_cast<float>(records[i].object));
    }
  }
}

// --- Numbers --------------------------------------------------------------------------------------------

std::set<std::string> keys(const nlohmann::json& json) {
  std::set<std::string> names;
  for (const auto& [name, value] : json.items())
    names.insert(name);
  return names;
}

TEST_F(Tools, StatsHaveExactlyTheDocumentedKeys) {
  const auto stats = stats_of({});
  const auto expect_keys = [](const nlohmann::json& json, const std::string& names) {
    std::istringstream all(names);
    EXPECT_EQ(keys(json), (std::set<std::string>{std::istream_iterator<std::string>(all), {}}));
  };
  expect_keys(stats, "version commit command backend device scene_hash grid_hash views eye_rays eye_hits "
                     "reflection_rays refraction_rays shadow_rays shadow_hits secondary_hits "
                     "intersection_tests cells_visited empty_cells_visited voxels_skipped seconds precision "
                     "precision_reason double_views");
  expect_keys(stats["intersection_tests"], "triangle sphere cone");
  expect_keys(stats["seconds"], "map validate upload trace download write");
  EXPECT_EQ(stats["backend"], "cpu");
  EXPECT_EQ(stats["views"], 1);
  EXPECT_EQ(info_of(scene_)["geometry_hash"], json_of("gridstat", {grid_})["geometry_hash"]);
  EXPECT_EQ(stats["command"][1], scene_);
}

TEST_F(Tools, StatsAddUp) {
  const auto stats = stats_of({});
  render({"--hits", file("hits")});
  const std::vector<WrittenHit> hits = hits_in(file("hits"));
  EXPECT_EQ(stats["eye_rays"], hits.size());
  EXPECT_EQ(stats["eye_hits"],
            hits.size() - static_cast<std::size_t>(std::ranges::count(hits, -1, &WrittenHit::object)));
  EXPECT_LE(stats["shadow_hits"], stats["shadow_rays"]);
  EXPECT_LE(stats["secondary_hits"],
            stats["reflection_rays"].get<int>() + stats["refraction_rays"].get<int>());
  EXPECT_LE(stats["empty_cells_visited"], stats["cells_visited"]);
  EXPECT_GT(stats["intersection_tests"]["triangle"], 0);
  EXPECT_GT(stats["intersection_tests"]["sphere"], 0);
  EXPECT_EQ(stats["intersection_tests"]["cone"], 0);
  for (const auto& [name, seconds] : stats["seconds"].items())
    EXPECT_GE(seconds.get<double>(), 0) << name;
}

TEST_F(Tools, StatsCountTheSameForAnyNumberOfThreads) {
  auto one = stats_of({"--threads", "1"}), two = stats_of({"--threads", "2"});
  for (const char* const name : {"seconds", "command", "device"})
    one[name] = two[name];
  EXPECT_EQ(one, two);
}

TEST_F(Tools, InfoIsTheSameForTextAndSceneFile) {
  auto text = info_of(text_);
  auto made = info_of(scene_);
  EXPECT_EQ(text["objects"]["polygons"], 1);
  EXPECT_EQ(text["objects"]["spheres"], 1);
  EXPECT_EQ(text["objects"]["total"], 2);
  EXPECT_EQ(text["primitives"]["total"], 3);
  EXPECT_EQ(text["materials"]["total"], 2);
  EXPECT_EQ(text["lights"], 1);
  EXPECT_EQ(text["resolution"], (std::vector<int>{16, 12}));
  EXPECT_EQ(text["store"], "float32");
  EXPECT_EQ(made["bytes"]["file"], std::filesystem::file_size(scene_));
  for (const char* const name :
       {"objects", "primitives", "materials", "lights", "resolution", "store", "bounds"})
    EXPECT_EQ(text[name], made[name]) << name;
}

TEST_F(Tools, TessellationKeepsTheObjectCounts) {
  const std::string made = scene("t.scene", text_, {"--tessellate", "12"});
  auto info = info_of(made);
  const auto curved = info_of(scene_);
  EXPECT_EQ(info["objects"], curved["objects"]);
  EXPECT_EQ(info["store"], "float32");
  EXPECT_EQ(info["primitives"]["triangles"], 2 + 108);
  EXPECT_EQ(info["primitives"]["spheres"], 0);
  EXPECT_EQ(info["smooth_triangles"], 108);
  auto text = json_of("nff2bin", {text_, "--tessellate", "12", "--info"});
  for (const char* const name : {"objects", "primitives", "smooth_triangles", "store"})
    EXPECT_EQ(info[name], text[name]) << name;
}

TEST_F(Tools, GridbuildAndGridstatAgree) {
  const auto built =
      json_of("gridbuild", words("~/a.scene -o ~/b.grid --division 5x4x3 --merge none --space cube"));
  const auto info = json_of("gridstat", {file("b.grid")});
  EXPECT_EQ(built["division"], (std::vector<int>{5, 4, 3}));
  EXPECT_EQ(info["division"], built["division"]);
  EXPECT_EQ(info["voxels"], 60);
  EXPECT_EQ(info["references"], built["references"]);
  EXPECT_EQ(info["occupied_cells"], built["occupied_cells"]);
  EXPECT_EQ(info["occupied_voxels"].get<int>() + info["empty_voxels"].get<int>(), 60);
  EXPECT_EQ(info["space_rule"], "cube");
  EXPECT_EQ(info["overlap"], "exact");
  EXPECT_EQ(info["division_rule"], "5x4x3");
  EXPECT_EQ(info["bytes"]["file"], std::filesystem::file_size(file("b.grid")));
  EXPECT_TRUE(info["build_seconds"].is_null());
}

TEST_F(Tools, AGivenDivisionIsNotMerged) {
  for (const char* const merge : {"auto", "none"})
    grid(merge, scene_, "700x700x700", {"--merge", merge});
  EXPECT_TRUE(read_bytes(file("auto")) == read_bytes(file("none")));
}

// However fine a division would still save some of the expected cost.
TEST_F(Tools, TrianglesThatLieOnEachOtherAreBuiltInBoundedMemory) {
  constexpr std::size_t count = 30'000;
  std::string text;
  for (std::size_t i = 0; i < count; ++i)
    text += "p 3 -1 -1 0  1 -1 0  0 1 0\n";
  const std::string in = scene("same.scene", nff("same.nff", text));
  const auto built = json_of("gridbuild", {in, "-o", file("same.grid")});
  EXPECT_LE(built["references"].get<double>(), 0x1p25 + 256.0 * count);
}

// CSV of several grids can be joined: the columns don't depend on the kind of grid.
TEST_F(Tools, GridstatsCsvHasTheSameColumnsForEveryGrid) {
  std::set<std::string> headers;
  const std::string uniform = grid("uniform.grid", scene_, "5", {"--merge", "none"});
  for (const char* const merge : {"none", "x", "balance", "irregular"}) {
    const std::string path = grid("b.grid", scene_, "6", {"--merge", merge});
    const ToolResult result = run("gridstat", {path, "--csv"});
    EXPECT_TRUE(succeeded(result));
    const std::size_t end = result.out.find('\n') + 1;
    headers.insert(result.out.substr(0, end));
    const std::string values = result.out.substr(end);
    EXPECT_EQ(std::ranges::count(values, '\n'), 1);
    EXPECT_EQ(std::ranges::count(values, ','), std::ranges::count(*headers.begin(), ',')) << values;
    EXPECT_EQ(values.find("null"), std::string::npos) << values;
    EXPECT_EQ(keys(json_of("gridstat", {path})), keys(json_of("gridstat", {uniform})));
  }
  EXPECT_EQ(headers.size(), 1U);
}

// --- Files ----------------------------------------------------------------------------------------------

TEST_F(Tools, StandardInputAndAFileGiveTheSameScene) {
  expect_run("nff2bin", {"-", "-o", file("piped.scene")}, {.input = text_});
  EXPECT_TRUE(read_bytes(file("piped.scene")) == read_bytes(scene_));
}

TEST_F(Tools, Float64IsStoredWhereFloat32IsTooCoarse) {
  const struct {
    const char *text, *store, *reason;
  } scenes[] = {{"s 0.1 0 0 1\n", "float32", "precise"},
                {"s 1000 0 0 16\n", "float32", "precise"},
                {"s 0.123456789012 0 0 1\n", "float32", "precise"},
                {"s 1e20 0 0 1\n", "float64", "out_of_range"},
                {"s 1000000 0 0 1\n", "float64", "far_from_origin"},
                {"s 0 0 0 1024\ns 0 0 1024 0.0001220703125\n", "float64", "small_parts"},
                {"c 1 0 0 1 1.000000001 0 0 2\n", "float64", "moved_cones"}};
  for (const auto& [text, store, reason] : scenes) {
    const nlohmann::json info = info_of(nff("digits.nff", text), {"--origin", "none"});
    EXPECT_EQ(info["store"], store) << text;
    EXPECT_EQ(info["store_reason"], reason) << text;
  }
}

TEST_F(Tools, InfoTellsTheOriginAndWhatItGains) {
  const std::string text = nff("far.nff", "s 1000000 0 0 1\ns 1000000 6 0 1\n");
  const std::string path = scene("far.scene", text, {});
  for (const nlohmann::json& json : {info_of(text), info_of(path)}) {
    EXPECT_EQ(json["store"], "float32");
    EXPECT_EQ(json["origin"], (nlohmann::json{1000000, 3, 0}));
    EXPECT_EQ(json["bounds"]["max"], (nlohmann::json{1000001, 7, 1}));
    EXPECT_EQ(json["error_bound"], 4.0 * 128 / (1 << 24));
    EXPECT_EQ(json["error_bound_without_origin"], 1000001.0 * 128 / (1 << 24));
  }
  const nlohmann::json given = info_of(text, {"--origin", "999999,-1,0"});
  EXPECT_EQ(given["origin"], (nlohmann::json{999999, -1, 0}));
}

TEST_F(Tools, InfoTellsTheStoreAndWhatFloat32Rounds) {
  const std::string text = nff("thirds.nff", "s 0 0 0 3.75\np 3 0.3333333333333 0 0 1 0 0 0 1 0\n");
  const double rounding = std::abs(0.3333333333333 - static_cast<double>(0.3333333333333F));
  for (const std::string store : {"auto", "float32", "float64"}) {
    const std::string path = scene("thirds.scene", text, {"--store", store});
    const std::string stored = store == "float64" ? "float64" : "float32";
    const std::string reason = store == "float64" ? "asked" : "precise";
    for (const bool is_text : {true, false}) {
      const nlohmann::json json =
          is_text ? json_of("nff2bin", {text, "--store", store, "--info", "-o", path}) : info_of(path);
      EXPECT_EQ(json["store"], stored);
      EXPECT_EQ(json["store_reason"], reason);
      EXPECT_TRUE(json["float32"]["suffices"]);
      EXPECT_EQ(json["float32"]["error_bound"], 3.75 * 128 / (1 << 24));
      if (is_text || store == "float64")
        EXPECT_EQ(json["float32"]["rounding"], rounding);
      else
        EXPECT_TRUE(json["float32"]["rounding"].is_null());
      EXPECT_EQ(json["geometry_hash"].get<std::string>().size(), 32U);
    }
    const ToolResult table = run("nff2bin", {text, "--store", store, "--info"});
    EXPECT_TRUE(succeeded(table));
    EXPECT_NE(table.out.find(stored + (store == "float64" ? ": asked for" : ": precise enough")),
              std::string::npos)
        << table.out;
    EXPECT_NE(table.out.find("of the error bound 2.9e-05"), std::string::npos) << table.out;
  }
}

// As fast as another trace: nothing is built again.
TEST_F(Tools, AGridIsUsedForAnyViewLightsAndMaterialsOfItsGeometry) {
  std::string changed(small_nff);
  const auto replace = [&](std::string_view from, std::string_view to) {
    changed.replace(changed.find(from), from.size(), to);
  };
  replace("from 3 -4 2", "from -2 -3 4");
  replace("at 0 0 0.5", "at 0.25 0 0");
  replace("angle 45", "angle 60");
  replace("resolution 16 12", "resolution 23 17");
  replace("b 0.1 0.2 0.3", "b 0.5 0.25 0");
  replace("l 5 -5 9", "l -3 1 7 1 0.5 0.5\nl 0 0 30");
  replace("f 1 0.5 0.25 0.7 0.3 10 0 1", "f 0.25 1 0.5 0.5 0 0 0.5 1.5");
  replace("f 0.2 0.4 0.9 0.6 0.4 30 0 1", "f 1 1 1 1 0 0 0 1");
  const std::string other = scene("view.scene", nff("view.nff", changed));
  const auto geometry = [&](const std::string& path) { return info_of(path)["geometry_hash"]; };
  EXPECT_EQ(geometry(other), geometry(scene_));
  EXPECT_NE(geometry(scene("b.scene", nff("b.nff", other_nff))), geometry(scene_));
  for (const std::string kind : {"none", "x", "balance", "irregular", "bvh", "fastest"}) {
    SCOPED_TRACE(kind);
    const Arguments built{kind == "bvh" || kind == "fastest" ? "--structure" : "--merge", kind};
    const std::string division = kind == "bvh" ? "auto" : "6";
    const std::string old = grid("old.grid", scene_, division, built);
    EXPECT_EQ(json_of("gridstat", {old})["geometry_hash"], geometry(scene_));
    const auto hits = [&](const Arguments& through, const std::string& name) {
      expect_run(
          "gridrender",
          joined({other, "--backend", "cpu", "--hits", file(name), "-o", file(name + ".pfm")}, through));
      return std::pair(read_bytes(file(name)), read_bytes(file(name + ".pfm")));
    };
    const auto found = hits({old}, "old.hits");
    EXPECT_FALSE(found.first.empty());
    EXPECT_TRUE(found == hits({"--brute-force"}, "brute.hits"));
    EXPECT_TRUE(found == hits({grid("new.grid", other, division, built)}, "new.hits"));
    EXPECT_TRUE(read_bytes(old) == read_bytes(file("new.grid")));
  }
}

TEST_F(Tools, EqualBuildsAreEqualFilesUnlessSecondsAreRecorded) {
  EXPECT_TRUE(read_bytes(grid_) == read_bytes(grid("b.grid", scene_)));
  grid("c.grid", scene_, "auto", {"--record-seconds"});
  EXPECT_GE(json_of("gridstat", {file("c.grid")})["build_seconds"].get<double>(), 0);
}

// The scene of small_nff and a cone, scaled.
std::string scaled_text(double scale) {
  const auto number = [&](double value) { return fmt::format(" {:.6g}", value * scale); };
  const auto all = [&](std::initializer_list<double> values) {
    std::string text;
    for (const double value : values)
      text += number(value);
    return text + "\n";
  };
  return "v\nfrom" + all({3, -4, 2}) + "at" + all({0, 0, 0.5}) + "up 0 0 1\nangle 45\nhither" + all({0.1}) +
         "resolution 48 48\nb 0.1 0.2 0.3\nl" + all({5, -5, 9}) + "f 1 0.5 0.25 0.7 0.3 10 0 1\np 4\n" +
         all({-2, -2, 0}) + all({2, -2, 0}) + all({2, 2, 0}) + all({-2, 2, 0}) +
         "f 0.2 0.4 0.9 0.6 0.4 30 0 1\ns" + all({0, 0, 0.5, 0.5}) + "c" + all({1, 1, 0, 0.3, 1, 1, 1, 0.1});
}

// A scaled scene gives the same picture, or is refused beyond the range of numbers.
TEST_F(Tools, PicturesAreIndependentOfTheScenesScale) {
  const auto rendered = [&](int exponent) {
    const std::string text = nff("scaled.nff", scaled_text(std::pow(10, exponent)));
    const ToolResult made = run("nff2bin", {text, "-o", file("scaled.scene")});
    if (std::abs(exponent) > 30 && made.code == 2) return nlohmann::json{};
    EXPECT_TRUE(succeeded(made));
    const std::string scaled_grid = grid("scaled.grid", file("scaled.scene"));
    expect_run("gridrender", {file("scaled.scene"), scaled_grid, "-o", file("grid.pfm"), "--backend", "cpu",
                              "--stats", file("stats.json")});
    expect_run("gridrender",
               {file("scaled.scene"), "--brute-force", "-o", file("none.pfm"), "--backend", "cpu"});
    EXPECT_TRUE(read_bytes(file("grid.pfm")) == read_bytes(file("none.pfm")))
        << "the picture depends on the grid";
    return json_in("stats.json");
  };
  const auto expected = rendered(0);
  for (const int exponent :
       {-97, -70, -40, -29, -26, -20, -15, -11, -9, -6, -3, 3, 6, 9, 10, 11, 12, 15, 30, 60, 75, 80, 98}) {
    SCOPED_TRACE(fmt::format("times 1e{}", exponent));
    const auto counts = rendered(exponent);
    if (counts.is_null()) continue;
    for (const char* const name : {"eye_hits", "reflection_rays", "shadow_rays", "shadow_hits"})
      EXPECT_NEAR(counts[name].get<double>(), expected[name].get<double>(), 8) << name;
  }
}

TEST_F(Tools, BenchStabilityReportsFailuresOfFastOnly) {
  const auto rows = json_of(
      "gridbench", {"stability", "--sweep", "closed-ball,leaving-scaled", "--count", "200", "--seed", "7"});
  std::set<std::string> sweeps, failing;
  for (const auto& row : rows) {
    sweeps.insert(row["sweep"]);
    // Embree's, where it is there, and the rays that it finds other hits for.
    if (!row.contains("mode") || row["mode"].get<std::string>().starts_with("embree")) continue;
    if (row["missed"].get<int>() + row["false"].get<int>() > 0) failing.insert(row["mode"]);
  }
  EXPECT_EQ(sweeps, (std::set<std::string>{"closed-ball", "leaving-scaled"}));
  EXPECT_EQ(failing, std::set<std::string>{"fast"});
}

TEST_F(Tools, LinesCrossClosedMeshesAsOftenInwardsAsOutwards) {
  const std::string spheres =
      "v\nfrom 9 0 0\nat 0 0 0\nup 0 0 1\nangle 45\nhither 0.1\nresolution 8 8\nb 0 0 0\n"
      "f 1 1 1 1 0 1 0 1\ns 0 0 0 1\ns 0.3 0.2 0 0.5\ns 1 1 1 0.75\n";
  for (const std::string& text : {spd("tetra.nff", "tetra", 3), nff("spheres.nff", spheres)}) {
    const std::string closed = scene("closed.scene", text, {"--tessellate", "16"});
    for (const char* const precision : {"robust", "double"}) {
      const auto rows = json_of("gridbench", {"crossings", closed, grid("closed.grid", closed), "--count",
                                              "20000", "--backend", "cpu", "--precision", precision});
      EXPECT_EQ(rows[0]["wrong"], 0) << text;
      EXPECT_GT(rows[0]["crossing"], 10000) << text;
    }
  }
  EXPECT_TRUE(fails(2, "gridbench", {"crossings", scene_, grid_}, scene_, "closed"));
}

TEST_F(Tools, BenchOracleFindsNoFailuresOfRobustAndDouble) {
  const auto rows =
      json_of("gridbench", {"oracle", scene_, grid_, "--count", "2000", "--precision", "fast,robust,double"});
  ASSERT_EQ(rows.size(), 3U);
  for (const auto& row : rows) {
    EXPECT_EQ(row["rays"], 2000);
    EXPECT_LT(row["unsure"].get<int>(), 200);
    for (const char* const failure : {"missed", "false", "wrong", "misplaced"})
      EXPECT_TRUE(row["precision"] == "fast" || row[failure] == 0) << failure;
  }
}

} // namespace
} // namespace masu
