// The file formats don't change: files are written as these bytes, and these bytes are read.
#include "tests/grid/golden.h"

#include "tests/grid/golden/grid.h"
#include "tests/grid/golden/grid_of_blocks.h"
#include "tests/grid/golden/hierarchy.h"
#include "tests/grid/golden/merged_grid.h"
#include "tests/grid/golden/scene_float32.h"
#include "tests/grid/golden/scene_float64.h"
#include "tests/refused.h"
#include "tests/tiny_scene.h"

#include <cmath>
#include <cstring>
#include <functional>

namespace masu {
namespace {

constexpr Hash golden_geometry_hash{0x0123456789abcdef, 0xfedcba9876543210};

struct Golden {
  const char* name;
  const char* hex;
  std::function<void(const std::string& path)> write;
};

void PrintTo(const Golden& golden, std::ostream* out) {
  *out << golden.name;
}

class GoldenFile : public testing::TestWithParam<Golden> {};

// To accept a new format: raise the version (scene_file_kind, grid_file_kind), then paste the test's output.
TEST_P(GoldenFile, IsWrittenByteForByte) {
  const TemporaryFolder folder;
  const std::string path = folder.file("file");
  GetParam().write(path);
  const Bytes written = read_bytes(path);
  const Bytes golden = bytes_of_hex_lines(GetParam().hex);
  const auto differ = std::ranges::mismatch(written, golden);
  EXPECT_TRUE(written == golden)
      << "tests/grid/golden/" << GetParam().name << ".h differs from byte " << differ.in1 - written.begin()
      << " on: the format changed.\nA changed format needs a new version number, or old files would be "
         "misread. After raising it, this is the new golden text:\n"
      << hex_lines(written);
}

INSTANTIATE_TEST_SUITE_P(
    All, GoldenFile,
    testing::Values(Golden{"scene_float32", golden_scene_float32,
                           [](const std::string& path) { write_scene(tiny_scene(), Store::float32, path); }},
                    Golden{"scene_float64", golden_scene_float64,
                           [](const std::string& path) { write_scene(tiny_scene(), Store::float64, path); }},
                    Golden{"grid", golden_grid,
                           [](const std::string& path) {
                             write_grid(tiny_grid(), tiny_grid_provenance(golden_geometry_hash), path);
                           }},
                    Golden{"grid_of_blocks", golden_grid_of_blocks,
                           [](const std::string& path) {
                             write_grid(tiny_grid_of_blocks(), tiny_grid_provenance(golden_geometry_hash),
                                        path);
                           }},
                    Golden{"merged_grid", golden_merged_grid,
                           [](const std::string& path) {
                             write_grid(tiny_merged_grid(),
                                        tiny_grid_provenance(golden_geometry_hash, "irregular"), path);
                           }},
                    Golden{"hierarchy", golden_hierarchy,
                           [](const std::string& path) {
                             write_grid(tiny_hierarchy(), tiny_grid_provenance(golden_geometry_hash, "bvh"),
                                        path);
                           }}),
    [](const auto& test) { return std::string(test.param.name); });

std::string written_golden(const TemporaryFolder& folder, const char* hex) {
  const std::string path = folder.file("golden");
  write_bytes(path, bytes_of_hex_lines(hex));
  return path;
}

Vec3d vector_of(const fb::Vec3& v) {
  return {v.x(), v.y(), v.z()};
}

void expect_table_of_tiny_scene(const fb::Scene& table) {
  const Scene scene = tiny_scene();
  const Camera& camera = scene.camera;
  EXPECT_EQ(vector_of(table.camera()->from()), camera.from);
  EXPECT_EQ(vector_of(table.camera()->at()), camera.at);
  EXPECT_EQ(vector_of(table.camera()->up()), camera.up);
  EXPECT_EQ(table.camera()->angle(), camera.angle);
  EXPECT_EQ(table.camera()->hither(), camera.hither);
  EXPECT_EQ(table.camera()->width(), camera.width);
  EXPECT_EQ(table.camera()->height(), camera.height);
  const fb::Color& background = *table.background();
  EXPECT_EQ((Vec3f{background.r(), background.g(), background.b()}), scene.background);
  EXPECT_EQ(table.ambient(), scene.ambient);
  EXPECT_EQ(table.objects()->polygons(), 1U);
  EXPECT_EQ(table.objects()->patches(), 1U);
  EXPECT_EQ(table.objects()->spheres(), 1U);
  EXPECT_EQ(table.objects()->cones(), 1U);
  EXPECT_EQ(vector_of(table.bounds()->min()), (Vec3d{-2, -2, -1}));
  EXPECT_EQ(vector_of(table.bounds()->max()), (Vec3d{2, 2, 0.75}));
  EXPECT_EQ(table.reflective_materials(), 2U);
  EXPECT_EQ(table.transmitting_materials(), 1U);
}

template <class Stored>
void expect_triangles_of_tiny_scene(const SceneView<Stored>& view) {
  const Scene scene = tiny_scene();
  ASSERT_EQ(view.triangle_count, scene.triangles.size());
  for (std::uint32_t i = 0; i < view.triangle_count; ++i) {
    const Triangle<double>& t = scene.triangles[i];
    EXPECT_EQ(cast<double>(view.triangles[i].a), t.a);
    EXPECT_EQ(cast<double>(view.triangles[i].b), t.b);
    EXPECT_EQ(cast<double>(view.triangles[i].c), t.c);
    EXPECT_EQ(view.triangles[i].object, t.object);
    EXPECT_EQ(view.triangles[i].material, t.material);
    EXPECT_EQ(view.triangles[i].normals, t.normals);
  }
  EXPECT_EQ(cast<double>(view.normals[0].a), scene.normals[0].a);
  EXPECT_EQ(cast<double>(view.normals[0].b), scene.normals[0].b);
  EXPECT_EQ(cast<double>(view.normals[0].c), scene.normals[0].c);
}

template <class Stored>
void expect_round_ones_of_tiny_scene(const SceneView<Stored>& view) {
  const Scene scene = tiny_scene();
  ASSERT_EQ(view.sphere_count, 1U);
  EXPECT_EQ(cast<double>(view.spheres[0].center), scene.spheres[0].center);
  EXPECT_EQ(static_cast<double>(view.spheres[0].radius), scene.spheres[0].radius);
  EXPECT_EQ(view.sphere_surfaces[0].object, 2U);
  EXPECT_EQ(view.sphere_surfaces[0].material, 2U);
  ASSERT_EQ(view.cone_count, 1U);
  EXPECT_EQ(cast<double>(view.cones[0].base), scene.cones[0].base);
  EXPECT_EQ(cast<double>(view.cones[0].apex), scene.cones[0].apex);
  EXPECT_EQ(static_cast<double>(view.cones[0].base_radius), scene.cones[0].base_radius);
  EXPECT_EQ(static_cast<double>(view.cones[0].apex_radius), scene.cones[0].apex_radius);
  EXPECT_EQ(view.cone_surfaces[0].object, 3U);
  EXPECT_EQ(view.cone_surfaces[0].material, 3U);
}

template <class Stored>
void expect_lights_and_materials_of_tiny_scene(const SceneView<Stored>& view) {
  const Scene scene = tiny_scene();
  ASSERT_EQ(view.light_count, scene.lights.size());
  for (std::uint32_t i = 0; i < view.light_count; ++i) {
    EXPECT_EQ(cast<double>(view.lights[i].position), scene.lights[i].position);
    EXPECT_EQ(cast<float>(view.lights[i].intensity), cast<float>(scene.lights[i].intensity));
  }
  for (std::size_t i = 0; i < scene.materials.size(); ++i) {
    const Material &read = view.materials[i], &m = scene.materials[i];
    EXPECT_EQ(read.color, m.color);
    EXPECT_EQ(read.diffuse, m.diffuse);
    EXPECT_EQ(read.specular, m.specular);
    EXPECT_EQ(read.shine, m.shine);
    EXPECT_EQ(read.transmittance, m.transmittance);
    EXPECT_EQ(read.refraction_index, m.refraction_index);
  }
}

template <class Stored>
void expect_tiny_scene(const SceneFile& file) {
  expect_table_of_tiny_scene(file.table());
  const SceneView<Stored> view = file.view<Stored>();
  expect_triangles_of_tiny_scene(view);
  EXPECT_EQ(file.counts().normals, 1U);
  EXPECT_EQ(file.counts().materials, tiny_scene().materials.size());
  expect_round_ones_of_tiny_scene(view);
  expect_lights_and_materials_of_tiny_scene(view);
  EXPECT_EQ(view.ambient, tiny_scene().ambient);
  EXPECT_EQ(view.background, tiny_scene().background);
}

TEST(GoldenFileReading, Float32SceneIsRead) {
  const TemporaryFolder folder;
  const SceneFile file(written_golden(folder, golden_scene_float32));
  ASSERT_FALSE(file.is_float64());
  expect_tiny_scene<float>(file);
}

TEST(GoldenFileReading, Float64SceneIsRead) {
  const TemporaryFolder folder;
  const SceneFile file(written_golden(folder, golden_scene_float64));
  ASSERT_TRUE(file.is_float64());
  expect_tiny_scene<double>(file);
}

void expect_grid(const GridFile& file, const Grid& grid) {
  EXPECT_NO_THROW(file.check_geometry(golden_geometry_hash, tiny_scene_primitives));
  EXPECT_EQ(file.table().primitives(), tiny_scene_primitives);
  EXPECT_EQ(file.table().block_log2(), static_cast<std::uint32_t>(grid.block_log2));
  EXPECT_EQ(file.table().space_rule(), fb::Space::tight);
  EXPECT_EQ(file.table().overlap(), fb::Overlap::exact);
  EXPECT_EQ(file.table().nested_log2(), static_cast<std::uint32_t>(grid.nested_log2));
  EXPECT_EQ(file.table().merge(), static_cast<fb::Merge>(grid.kind));
  EXPECT_EQ(file.table().merge_rule()->str(), file.is_merged()      ? "irregular"
                                              : file.is_hierarchy() ? "bvh"
                                                                    : "");
  EXPECT_EQ(file.table().division_rule()->str(), "2x2x1");
  EXPECT_EQ(file.table().build_seconds(), -1);
  EXPECT_EQ(file.layout().division, grid.layout.division);
  EXPECT_EQ(file.layout().space.min, grid.layout.space.min);
  EXPECT_EQ(file.layout().space.max, grid.layout.space.max);
  EXPECT_EQ(file.layout().margin, grid.layout.margin);
  EXPECT_TRUE(std::ranges::equal(file.voxel_map(), grid.voxel_map));
  EXPECT_TRUE(std::ranges::equal(file.cells(), grid.cells, [](const MergedCell& a, const MergedCell& b) {
    return a.x == b.x && a.y == b.y && a.z == b.z && a.list == b.list;
  }));
  EXPECT_TRUE(std::ranges::equal(file.references(), grid.references));
  ASSERT_EQ(file.nodes().size(), grid.nodes.size());
  for (std::size_t i = 0; i < grid.nodes.size(); ++i)
    EXPECT_EQ(std::memcmp(&file.nodes()[i], &grid.nodes[i], sizeof(HierarchyNode)), 0) << i;
}

TEST(GoldenFileReading, GridIsRead) {
  const TemporaryFolder folder;
  expect_grid(GridFile(written_golden(folder, golden_grid)), tiny_grid());
}

TEST(GoldenFileReading, GridOfBlocksIsRead) {
  const TemporaryFolder folder;
  const GridFile file(written_golden(folder, golden_grid_of_blocks));
  expect_grid(file, tiny_grid_of_blocks());
  const GridView<float> view = file.view<float>();
  EXPECT_EQ(look_up(view, {0, 0, 0}).word, occupied_bit | 0);
  EXPECT_EQ(look_up(view, {1, 0, 0}).word, occupied_bit | 1);
  EXPECT_EQ(look_up(view, {2, 0, 0}).word, 0U);
  EXPECT_EQ(look_up(view, {2, 0, 0}).side_log2, 1);
  EXPECT_EQ(look_up(view, {4, 0, 0}).word, occupied_bit | 3);
}

TEST(GoldenFileReading, MergedGridIsRead) {
  const TemporaryFolder folder;
  const GridFile file(written_golden(folder, golden_merged_grid));
  expect_grid(file, tiny_merged_grid());
  const MergedGridView<float> view = file.merged_view<float>();
  EXPECT_EQ(view.division, (Vec3i{8, 4, 4}));
  EXPECT_EQ(view.voxel_size, (Vec3f{0.5F, 1, 0.5F}));
  const auto cell_of = [&](const Vec3i& voxel) { return cell_number(view, voxel) | occupied_bit; };
  EXPECT_EQ(cell_of({0, 1, 1}), occupied_bit | 0);
  EXPECT_EQ(cell_of({1, 0, 1}), occupied_bit | 1);
  EXPECT_EQ(cell_of({3, 1, 3}), occupied_bit | 2);
  EXPECT_EQ(cell_of({1, 2, 0}), occupied_bit | 3);
  EXPECT_EQ(cell_of({1, 1, 2}), occupied_bit | 4);
  EXPECT_EQ(cell_of({4, 0, 0}), occupied_bit | 5);
  const CellView up = cell_at(view, {2, 0, 0}, {0, 0, 0}), down = cell_at(view, {2, 0, 0}, {-1, -1, -1});
  EXPECT_EQ(up.list, 1U);
  EXPECT_EQ(up.far, (Vec3i{8, 2, 4}));
  EXPECT_EQ(down.far, (Vec3i{2, 0, 0}));
}

TEST(GoldenFileReading, HierarchyIsRead) {
  const TemporaryFolder folder;
  const GridFile file(written_golden(folder, golden_hierarchy));
  expect_grid(file, tiny_hierarchy());
  EXPECT_TRUE(file.is_hierarchy());
  EXPECT_FALSE(file.is_merged());
  const HierarchyView<float> view = file.hierarchy_view<float>();
  EXPECT_EQ(node_slots(view.nodes[0]), 1U << 6);
  EXPECT_EQ(references_in(slot_byte(view.nodes[0].slots, 1)), 2U);
  EXPECT_EQ(references_begin(slot_byte(view.nodes[1].slots, 5)), 1U);
}

// Said in one line, with what to do.
TEST(GoldenFileReading, AnOlderVersionIsRefused) {
  const TemporaryFolder folder;
  const std::string path = folder.file("old.grid");
  Bytes bytes = bytes_of_hex_lines(golden_grid);
  bytes[8] = 3;
  write_bytes(path, bytes);
  EXPECT_TRUE(is_refused([](const std::string& name) { const GridFile file(name); }, path,
                         "build it again with gridbuild"));
}

} // namespace
} // namespace masu
