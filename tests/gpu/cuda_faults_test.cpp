// Whatever call of the CUDA driver fails: a tool's output is the old one or the new one, there is one line
// and exit code 4, and no other file is left; the library returns a status, and its next calls are right.
#include "tests/faults/cuda_faults.h"
#include "tests/tools/failing_calls.h"

#include <masu/masu.h>

#include <optional>
#include <utility>

namespace masu {
namespace {

bool has_gpu() {
  int count = 0;
  return masu_gpu_count(&count) == MASU_OK && count > 0;
}

class CudaFaults : public FailingCalls {
protected:
  void SetUp() override {
    if (!has_gpu()) GTEST_SKIP() << "no GPU, no call was made to fail";
  }

  ToolResult run_failing(const std::string& fault, const std::string& tool,
                         const Arguments& arguments) const {
    return run_with({std::string("LD_PRELOAD=") + MASU_CUDA_FAULTS, "MASU_CUDA_FAULT=" + fault,
                     "MASU_CUDA_FAULT_COUNT=" + counts_.file("count")},
                    tool, arguments);
  }

  // Each call, or so many at random: alone, and with all after it.
  void expect_survived(const std::string& tool, const Arguments& arguments,
                       const std::vector<std::string>& written) {
    SCOPED_TRACE(tool);
    const ToolResult good = run_failing("0", tool, arguments);
    ASSERT_EQ(good.code, 0) << good.err;
    const std::uint64_t all = counted();
    ASSERT_GT(all, 10U) << "the driver's functions aren't replaced";
    const Outputs outputs = outputs_of(written);
    for (const std::uint64_t n : some_of(all, cases(40))) {
      for (const char* const more : {"", "+"}) {
        outputs.write_old();
        const std::string fault = std::to_string(n) + more;
        const ToolResult result = run_failing(fault, tool, arguments);
        SCOPED_TRACE("call " + described(fault, all, result));
        if (result.code == 0)
          EXPECT_EQ(result.err, ""); // there is a way without
        else
          EXPECT_TRUE(failed(result, 4, tool, "cuda"));
        expect_old_or_new(outputs, result);
      }
    }
  }
};

TEST_F(CudaFaults, GridrenderOfPictures) {
  expect_survived("gridrender",
                  {scene_, grid_, "-o", file("out.png"), "--hits", file("hits"), "-q", "--backend", "cuda"},
                  {file("out.png"), file("hits")});
}

TEST_F(CudaFaults, GridtraceOfRays) {
  write_records(file("rays"), std::vector<float>{0, 0, 5, 0, 0, -1, 1, 1, 5, 0, 0, -1});
  expect_survived("gridtrace", {scene_, grid_, file("rays"), "-o", file("hits"), "-q", "--backend", "cuda"},
                  {file("hits")});
}

// Enough to be copied through page-locked memory, by several threads.
TEST_F(CudaFaults, GridrenderWithALargeGrid) {
  const std::string in = scene("b.scene", spd("b.nff", "balls", 3)),
                    divided = grid("b.grid", in, "160", {"--merge", "none"});
  ASSERT_GT(std::filesystem::file_size(divided), std::uintmax_t{8} << 20);
  expect_survived("gridrender", {in, divided, "-o", file("out.pfm"), "-q", "--backend", "cuda"},
                  {file("out.pfm")});
}

TEST_F(CudaFaults, Gridbuild) {
  const std::string in = scene("b.scene", spd("b.nff", "balls", 2));
  expect_survived("gridbuild", {in, "-o", file("out"), "-q", "--merge", "irregular", "--device", "cuda"},
                  {file("out")});
}

// --- The library, in this process

class CudaFaultsOfLibrary : public FailingCalls {
protected:
  void SetUp() override {
    if (!has_gpu()) GTEST_SKIP() << "no GPU, no call was made to fail";
    std::uniform_real_distribution<float> coordinate(-1, 1);
    std::vector<float> vertices(9 * 500);
    for (float& v : vertices)
      v = coordinate(random_);
    std::vector<std::uint32_t> indices(vertices.size() / 3);
    std::iota(indices.begin(), indices.end(), 0U);
    masu_mesh mesh{};
    mesh.size = sizeof mesh;
    mesh.vertices = vertices.data();
    mesh.vertex_count = indices.size();
    mesh.indices = indices.data();
    mesh.triangle_count = indices.size() / 3;
    masu_geometry geometry{};
    geometry.size = sizeof geometry;
    geometry.meshes = &mesh;
    geometry.mesh_count = 1;
    ASSERT_EQ(masu_scene_create(&geometry, &made_), MASU_OK) << masu_error();
    rays_.resize(1000);
    for (masu_ray& ray : rays_) {
      for (int axis = 0; axis < 3; ++axis) {
        ray.origin[axis] = 2 * coordinate(random_);
        ray.direction[axis] = coordinate(random_);
      }
      ray.tmin = 0;
      ray.tmax = 100;
    }
  }
  void TearDown() override {
    fail_cuda_call(0, false);
    masu_scene_free(made_);
  }

  struct Found {
    std::vector<float> t, normal;
    std::vector<std::uint32_t> primitive;
    std::vector<std::uint8_t> occluded;
    bool operator==(const Found&) const = default;
  };

  // Opens, asks and closes; a query that fails is repeated by the same tracer while nothing fails. The first
  // status that isn't MASU_OK, and nothing where the tracer can't be opened.
  std::pair<masu_status, std::optional<Found>> traced(const masu_grid* grid) const {
    masu_tracer* tracer = nullptr;
    constexpr int gpu = 0;
    masu_tracer_options options{};
    options.size = sizeof options;
    options.gpus = &gpu;
    options.gpu_count = 1;
    masu_status first = masu_tracer_create(made_, grid, &options, &tracer);
    EXPECT_EQ(first == MASU_OK, tracer != nullptr);
    if (first != MASU_OK) return {first, {}};
    Found found{std::vector<float>(rays_.size()), std::vector<float>(3 * rays_.size()),
                std::vector<std::uint32_t>(rays_.size()), std::vector<std::uint8_t>(rays_.size())};
    masu_hits hits{};
    hits.size = sizeof hits;
    hits.t = found.t.data();
    hits.primitive = found.primitive.data();
    hits.normal = found.normal.data();
    const auto query = [&](const auto& ask) {
      const masu_status status = ask();
      if (status == MASU_OK) return;
      if (first == MASU_OK) first = status;
      fail_cuda_call(0, false);
      EXPECT_EQ(ask(), MASU_OK) << "after an error: " << masu_error();
    };
    query([&] { return masu_nearest(tracer, rays_.data(), rays_.size(), nullptr, &hits); });
    query([&] { return masu_occluded(tracer, rays_.data(), rays_.size(), nullptr, found.occluded.data()); });
    masu_tracer_free(tracer);
    return {first, found};
  }

  // Calls act() with each of its calls of the driver failing, or so many at random.
  template <class Act>
  void with_each_failing(const Act& act) {
    fail_cuda_call(0, false);
    act(std::uint64_t{0});
    const std::uint64_t all = cuda_calls();
    ASSERT_GT(all, 10U) << "the driver's functions aren't replaced";
    for (const std::uint64_t n : some_of(all, cases(200))) {
      for (const bool all_after : {false, true}) {
        SCOPED_TRACE("call " + std::to_string(n) + " of " + std::to_string(all) +
                     (all_after ? " and all after it" : ""));
        fail_cuda_call(n, all_after);
        act(n);
        fail_cuda_call(0, false);
        act(0); // nothing fails any more
        if (HasFatalFailure()) return;
      }
    }
  }

  static void expect_a_line(masu_status status) {
    EXPECT_EQ(status, MASU_ERROR_DEVICE);
    const std::string_view line = masu_error();
    EXPECT_TRUE(line.starts_with("cuda: ") && line.find('\n') == line.npos) << line;
  }

  masu_scene* made_ = nullptr;
  std::vector<masu_ray> rays_;
};

masu_build_options options_of(masu_structure structure, masu_merge merge) {
  masu_build_options options{};
  options.size = sizeof options;
  EXPECT_EQ(masu_default_build_options(&options), MASU_OK);
  options.structure = structure;
  options.merge = merge;
  return options;
}

// Through given structures, and through what the tracer builds on the GPU.
TEST_F(CudaFaultsOfLibrary, Queries) {
  const auto expect_survived = [&](const masu_grid* grid) {
    const auto [good, right] = traced(grid);
    ASSERT_EQ(good, MASU_OK) << masu_error();
    with_each_failing([&, &right = right](std::uint64_t failing) {
      const auto [status, found] = traced(grid);
      EXPECT_TRUE(!found || found == right);
      if (status == MASU_OK) return;
      if (failing == 0) FAIL() << masu_error();
      expect_a_line(status);
    });
  };
  for (const auto& [structure, merge] : {std::pair{MASU_STRUCTURE_GRID, MASU_MERGE_NONE},
                                         {MASU_STRUCTURE_GRID, MASU_MERGE_IRREGULAR},
                                         {MASU_STRUCTURE_BVH, MASU_MERGE_AUTO}}) {
    SCOPED_TRACE("merge " + std::to_string(merge));
    const masu_build_options options = options_of(structure, merge);
    masu_grid* grid = nullptr;
    ASSERT_EQ(masu_grid_build(made_, &options, &grid), MASU_OK) << masu_error();
    expect_survived(grid);
    masu_grid_free(grid);
  }
  expect_survived(nullptr);
}

TEST_F(CudaFaultsOfLibrary, Builds) {
  masu_build_options options = options_of(MASU_STRUCTURE_GRID, MASU_MERGE_IRREGULAR);
  options.device = 0;
  const std::string path = file("built");
  const auto built = [&](Bytes& bytes) {
    masu_grid* grid = nullptr;
    const masu_status status = masu_grid_build(made_, &options, &grid);
    EXPECT_EQ(status == MASU_OK, grid != nullptr);
    if (status != MASU_OK) return status;
    EXPECT_EQ(masu_grid_write(grid, path.c_str()), MASU_OK) << masu_error();
    masu_grid_free(grid);
    bytes = read_bytes(path);
    return status;
  };
  Bytes right, bytes;
  ASSERT_EQ(built(right), MASU_OK) << masu_error();
  with_each_failing([&](std::uint64_t failing) {
    const masu_status status = built(bytes);
    if (status == MASU_OK) {
      EXPECT_TRUE(bytes == right);
      return;
    }
    if (failing == 0) FAIL() << masu_error();
    expect_a_line(status);
  });
}

} // namespace
} // namespace masu
