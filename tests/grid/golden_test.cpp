// The file formats don't change: files are written as these bytes, and these bytes are read.
#include "libscene/float32_precision.h"
#include "tests/grid/golden.h"

#include "tests/grid/golden/grid.h"
#include "tests/grid/golden/grid_of_blocks.h"
#include "tests/grid/golden/hierarchy.h"
#include "tests/grid/golden/merged_grid.h"
#include "tests/grid/golden/scene_float32.h"
#include "tests/grid/golden/scene_float64.h"
#include "tests/refused.h"
#include "tests/same_values.h"
#include "tests/tiny_files.h"

#include <map>

namespace masu {
namespace {

constexpr Hash golden_geometry_hash{0x0123456789abcdef, 0xfedcba9876543210};

const std::map<std::string_view, const char*> golden_bytes{{"scene_float32", golden_scene_float32},
                                                           {"scene_float64", golden_scene_float64},
                                                           {"grid", golden_grid},
                                                           {"grid_of_blocks", golden_grid_of_blocks},
                                                           {"merged_grid", golden_merged_grid},
                                                           {"hierarchy", golden_hierarchy}};

class GoldenFile : public testing::TestWithParam<TinyFile> {};

// To accept a new format: raise the version (scene_file_kind, structure_file_kind), then paste the test's
// output.
TEST_P(GoldenFile, IsWrittenByteForByte) {
  const TemporaryFolder folder;
  const std::string path = folder.file("file");
  GetParam().write(path, golden_geometry_hash);
  const Bytes written = read_bytes(path);
  const Bytes golden = bytes_of_hex_lines(golden_bytes.at(GetParam().name));
  const auto differ = std::ranges::mismatch(written, golden);
  EXPECT_TRUE(written == golden)
      << "tests/grid/golden/" << GetParam().name << ".h differs from byte " << differ.in1 - written.begin()
      << " on: the format changed.\nA changed format needs a new version number, or old files would be "
         "misread. After raising it, this is the new golden text:\n"
      << hex_lines(written);
}

INSTANTIATE_TEST_SUITE_P(All, GoldenFile, testing::ValuesIn(tiny_files()),
                         [](const auto& test) { return std::string(test.param.name); });

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

template <class T>
CornerNormals<double> widened(const CornerNormals<T>& n) {
  return {cast<double>(n.a), cast<double>(n.b), cast<double>(n.c)};
}
// Of what was read in the file's own numbers, and in double before it was written.
template <class Read, class Expected>
void expect_records(const char* what, std::span<const Read> read, const Expected& expected) {
  std::vector<decltype(widened(read[0]))> wide;
  for (const Read& record : read)
    wide.push_back(widened(record));
  EXPECT_TRUE(same_values(wide, decltype(wide)(expected.begin(), expected.end()))) << what;
}
template <class T>
std::vector<Light<float>> in_float(std::span<const Light<T>> lights) {
  std::vector<Light<float>> floats;
  for (const Light<T>& light : lights)
    floats.push_back({cast<float>(light.position), cast<float>(light.intensity)});
  return floats;
}

template <class Stored>
void expect_tiny_scene(const SceneFile& file) {
  const Scene scene = tiny_scene();
  expect_table_of_tiny_scene(file.table());
  const SceneView<Stored> view = file.view<Stored>();
  const Lighting<Stored> lighting = file.lighting<Stored>();
  const auto spans = spans_of(view, lighting);
  expect_records("triangles", spans.triangles, scene.triangles);
  expect_records("normals", std::span(view.normals, file.counts().normals), scene.normals);
  expect_records("spheres", spans.spheres, scene.spheres);
  expect_records("cones", spans.cones, scene.cones);
  EXPECT_TRUE(same_values(std::span(view.sphere_surfaces, view.sphere_count), scene.sphere_surfaces));
  EXPECT_TRUE(same_values(std::span(view.cone_surfaces, view.cone_count), scene.cone_surfaces));
  EXPECT_TRUE(same_values(in_float(spans.lights), in_float(std::span<const Light<double>>(scene.lights))));
  EXPECT_TRUE(same_values(std::span(view.materials, file.counts().materials), scene.materials));
  EXPECT_EQ(lighting.ambient, scene.ambient);
  EXPECT_EQ(lighting.background, scene.background);
}

class GoldenFileReading : public testing::Test {
protected:
  std::string written(const char* hex) const {
    write_bytes(path_, bytes_of_hex_lines(hex));
    return path_;
  }

  const TemporaryFolder folder_;
  const std::string path_ = folder_.file("golden");
};

TEST_F(GoldenFileReading, Float32SceneIsRead) {
  const SceneFile file(written(golden_scene_float32));
  ASSERT_FALSE(file.is_float64());
  expect_tiny_scene<float>(file);
}

TEST_F(GoldenFileReading, Float64SceneIsRead) {
  const SceneFile file(written(golden_scene_float64));
  ASSERT_TRUE(file.is_float64());
  expect_tiny_scene<double>(file);
}

void expect_grid(const StructureFile& file, const Structure& grid) {
  EXPECT_NO_THROW(file.check_geometry(golden_geometry_hash, tiny_scene_primitives));
  EXPECT_EQ(file.table().primitives(), tiny_scene_primitives);
  EXPECT_EQ(file.table().block_log2(), static_cast<std::uint32_t>(grid.block_log2));
  EXPECT_EQ(file.table().space_rule(), fb::Space::tight);
  EXPECT_EQ(file.table().overlap(), fb::Overlap::exact);
  EXPECT_EQ(file.table().nested_log2(), static_cast<std::uint32_t>(grid.nested_log2));
  EXPECT_EQ(file.is_hierarchy(), grid.kind == StructureKind::hierarchy);
  EXPECT_EQ(file.table().merge(), file.is_hierarchy() ? fb::Merge::none : static_cast<fb::Merge>(grid.kind));
  EXPECT_EQ(file.table().merge_rule()->str(), file.is_merged() ? "irregular" : "");
  EXPECT_EQ(file.quality(), HierarchyQuality::high);
  EXPECT_EQ(file.table().division_rule()->str(), "2x2x1");
  EXPECT_EQ(file.table().build_seconds(), -1);
  EXPECT_EQ(file.layout().division, grid.layout.division);
  EXPECT_EQ(file.layout().space.min, grid.layout.space.min);
  EXPECT_EQ(file.layout().space.max, grid.layout.space.max);
  EXPECT_EQ(file.layout().margin, grid.layout.margin);
  EXPECT_TRUE(same_values(file.voxel_map(), grid.voxel_map));
  EXPECT_TRUE(same_values(file.cells(), grid.cells));
  EXPECT_TRUE(same_values(file.references(), grid.references));
  EXPECT_TRUE(same_values(file.nodes(), grid.nodes));
}

TEST_F(GoldenFileReading, GridIsRead) {
  expect_grid(StructureFile(written(golden_grid)), tiny_grid());
}

TEST_F(GoldenFileReading, GridOfBlocksIsRead) {
  const StructureFile file(written(golden_grid_of_blocks));
  expect_grid(file, tiny_grid_of_blocks());
  const GridView<float> view = view_of<float>(file.records());
  const std::uint32_t words[]{occupied_bit | 0, occupied_bit | 1, 0, 0, occupied_bit | 3};
  for (const std::int32_t x : {0, 1, 2, 4})
    EXPECT_EQ(look_up(view, {x, 0, 0}).word, words[x]) << x;
  EXPECT_EQ(look_up(view, {2, 0, 0}).side_log2, 1);
}

TEST_F(GoldenFileReading, MergedGridIsRead) {
  const StructureFile file(written(golden_merged_grid));
  expect_grid(file, tiny_merged_grid());
  const MergedGridView<float> view = merged_view_of<float>(file.records());
  EXPECT_EQ(view.division, (Vec3i{8, 4, 4}));
  EXPECT_EQ(view.voxel_size, (Vec3f{0.5F, 1, 0.5F}));
  const Vec3i in_cells[]{{0, 1, 1}, {1, 0, 1}, {3, 1, 3}, {1, 2, 0}, {1, 1, 2}, {4, 0, 0}};
  for (std::uint32_t cell = 0; cell < std::size(in_cells); ++cell)
    EXPECT_EQ(cell_number(view, in_cells[cell]), cell);
  const CellView up = cell_at(view, {2, 0, 0}, {0, 0, 0}), down = cell_at(view, {2, 0, 0}, {-1, -1, -1});
  EXPECT_EQ(up.list, 1U);
  EXPECT_EQ(up.far, (Vec3i{8, 2, 4}));
  EXPECT_EQ(down.far, (Vec3i{2, 0, 0}));
}

TEST_F(GoldenFileReading, HierarchyIsRead) {
  const StructureFile file(written(golden_hierarchy));
  expect_grid(file, tiny_hierarchy());
  EXPECT_TRUE(file.is_hierarchy());
  EXPECT_FALSE(file.is_merged());
  const HierarchyView<float> view = hierarchy_view_of<float>(file.records());
  EXPECT_EQ(node_slots(view.nodes[0]), 1U << 6);
  EXPECT_EQ(references_in(slot_byte(view.nodes[0].slots, 1)), 2U);
  EXPECT_EQ(references_begin(slot_byte(view.nodes[1].slots, 5)), 1U);
}

// Said in one line, with what to do.
TEST_F(GoldenFileReading, AnOlderVersionIsRefused) {
  Bytes bytes = bytes_of_hex_lines(golden_grid);
  bytes[8] = 3;
  write_bytes(path_, bytes);
  EXPECT_TRUE(is_refused([](const std::string& name) { const StructureFile file(name); }, path_,
                         "build it again with gridbuild"));
}

} // namespace
} // namespace masu
