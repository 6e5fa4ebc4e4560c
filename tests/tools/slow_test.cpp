// Files larger than 4 GiB, which no 32-bit number can address. Each needs some 5 GB of memory and of disk.
#include "libgrid/file/structure_file.h"
#include "libscene/base/available_memory.h"
#include "libscene/file/scene_file.h"
#include "tests/temporary_folder.h"
#include "tests/tiny_scene.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace masu {
namespace {

constexpr std::uint64_t four_gib = std::uint64_t{1} << 32;

class LargeFiles : public testing::Test {
protected:
  void SetUp() override {
    constexpr double needed = 6e9;
    if (available_memory() < needed) GTEST_SKIP() << "needs 6 GB of free memory";
    if (static_cast<double>(std::filesystem::space(folder_.path()).available) < needed)
      GTEST_SKIP() << "needs 6 GB of free disk in the folder of temporary files";
  }
  std::string file(const char* name) const { return folder_.file(name); }

private:
  TemporaryFolder folder_;
};

SceneTriangle triangle_number(std::uint32_t i) {
  const double x = i % 1000, y = i / 1000 % 1000, z = i / 1000000;
  return {{x, y, z}, i, {x + 0.5, y, z}, 0, {x, y + 0.25, z + 0.125}, no_normals};
}

TEST_F(LargeFiles, ScenesAreReadBackAsWritten) {
  constexpr std::uint32_t count = 45'000'000;
  Hash hash;
  {
    Scene scene = tiny_scene();
    scene.triangles.clear();
    scene.triangles.reserve(count);
    for (std::uint32_t i = 0; i < count; ++i)
      scene.triangles.push_back(triangle_number(i));
    scene.objects.polygons = count;
    hash = write_scene(scene, Store::float64, file("scene"));
  }
  ASSERT_GT(std::filesystem::file_size(file("scene")), four_gib);
  const SceneFile read(file("scene"));
  EXPECT_EQ(read.geometry_hash(), hash);
  const SceneView<double> view = read.view<double>();
  ASSERT_EQ(view.triangle_count, count);
  for (std::uint32_t i = 0; i < count; ++i) {
    const Triangle<double>& t = view.triangles[i];
    const SceneTriangle expected = triangle_number(i);
    ASSERT_TRUE(t.a == expected.a && t.b == expected.b && t.c == expected.c && t.object == i) << i;
  }
}

// A million voxels that each list all primitives.
TEST_F(LargeFiles, GridsAreReadBackAsWritten) {
  constexpr std::uint32_t voxels = 1'000'000, each = 1100;
  const auto reference = [](std::uint64_t i) {
    const auto primitive = static_cast<PrimitiveIndex>(i % each);
    return primitive == each - 1 ? primitive | last_bit : primitive;
  };
  {
    Structure grid;
    grid.layout = {{{0, 0, 0}, {1000, 1000, 1}}, {1000, 1000, 1}, 0};
    grid.voxel_map.resize(voxels);
    for (std::uint32_t i = 0; i < voxels; ++i)
      grid.voxel_map[i] = occupied_bit | i * each;
    grid.references.resize(std::uint64_t{voxels} * each);
    for (std::uint64_t i = 0; i < grid.references.size(); ++i)
      grid.references[i] = reference(i);
    StructureProvenance provenance = tiny_grid_provenance({1, 2});
    provenance.primitives = each;
    write_structure(grid, provenance, file("grid"));
  }
  ASSERT_GT(std::filesystem::file_size(file("grid")), four_gib);
  const StructureFile read(file("grid"));
  const auto references = read.references();
  ASSERT_EQ(references.size(), std::uint64_t{voxels} * each);
  for (std::uint64_t i = 0; i < references.size(); ++i)
    ASSERT_EQ(references[i], reference(i)) << i;
  const GridView<double> view = view_of<double>(read.records());
  EXPECT_EQ(look_up(view, {999, 999, 0}).word, occupied_bit | (voxels - 1) * each);
}

} // namespace
} // namespace masu
