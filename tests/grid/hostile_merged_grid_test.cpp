// Merged grids with correct hashes and invalid contents are refused with an error; none leads traversal out
// of its arrays or into an endless loop.
#include "tests/unchecked_grid.h"

namespace masu {
namespace {

using fb::StructureSection;

constexpr const char* merge_rule = "irregular";

class HostileMergedGrid : public testing::TestWithParam<WrongGrid> {};

TEST_P(HostileMergedGrid, IsRefused) {
  expect_grid_refused(tiny_merged_grid(), merge_rule, GetParam());
}

TEST(UncheckedGrid, IsRefusedByTheCpuBeforeTracing) {
  EXPECT_TRUE(is_refused_by_tracer(Device::cpu));
}

WrongGrid map_of(const char* name, std::size_t words) {
  return resized(name, StructureSection::voxel_map, 4 * words);
}
// axis 3: the list of references.
WrongGrid cell(const char* name, std::size_t i, std::size_t axis, std::uint32_t value) {
  return word(name, StructureSection::cells, 4 * i + axis, value);
}
std::uint32_t range(std::uint32_t first, std::uint32_t end) {
  return first | end << 16;
}
WrongGrid nested(const char* name, std::uint32_t log2) {
  return set(name, &GridParts::nested_log2, log2);
}

// See tiny_scene.h: words 0 and 1 are the top level, 8 to 15 divide the first cube, 16 to 23 divide the first
// of its parts.
INSTANTIATE_TEST_SUITE_P(
    Map, HostileMergedGrid,
    testing::Values(
        in_map("CellBeyond", 1, occupied_bit | 6), in_map("CellFarBeyond", 1, 0xffffffff),
        in_map("NestedCellBeyond", 20, occupied_bit | 6), in_map("CellElsewhere", 1, occupied_bit | 0),
        in_map("CellOfPartOfTheCube", 0, occupied_bit | 3),
        in_map("CellOfTheNextVoxel", 16, occupied_bit | 1),
        in_map("CellOfPartOfANestedCube", 8, occupied_bit | 0), in_map("MapBeyond", 0, divided(24, 1)),
        in_map("MapFarBeyond", 0, (occupied_bit - 64) | divided(0, 1)),
        in_map("NestedMapBeyond", 8, divided(24, 1)), in_map("SideZero", 0, divided(8, 0)),
        in_map("NoWord", 0, 0), in_map("NestedSideZero", 8, divided(16, 0)),
        in_map("SideTooLong", 0, divided(8, 3)), in_map("NestedSideTooLong", 8, divided(16, 2)),
        in_map("LongestSide", 0, divided(8, 3)), in_map("MapOfItself", 8, divided(8, 1)),
        in_map("MapOfTheTop", 8, divided(0, 1)), in_map("MapForASingleVoxel", 16, divided(8, 1)),
        in_map("MapOfItselfForASingleVoxel", 16, divided(16, 1)), in_map("TheSameMapTwice", 1, divided(8, 1)),
        map_of("OneWordTooFew", 23), map_of("NothingNested", 8), map_of("FewerWordsThanCubes", 1),
        without("Missing", StructureSection::voxel_map), nested("NotNested", 0), nested("NestedLess", 1),
        nested("NestedMore", 3), nested("NestedTooMuch", 15), nested("NestedBeyondNumbers", 16),
        nested("NestedBy31Bits", 31), nested("NestedBy32Bits", 32), nested("NestedByAllBits", 0xffffffff),
        division("OneCubeMore", 3, 1, 1), division("OneCubeLess", 1, 1, 1), division("OtherAxes", 1, 2, 1),
        division("TooFineWhenNested", 65535, 1, 1), division("Zero", 0, 1, 1),
        division("Overflowing", 65535, 65535, 65535), blocks("InBlocksTooLarge", 6)),
    by_name);

INSTANTIATE_TEST_SUITE_P(
    Cells, HostileMergedGrid,
    testing::Values(cell("ListBeyond", 0, 3, 5), cell("ListFarBeyond", 1, 3, 0x7fffffff),
                    cell("ListNearlyNone", 1, 3, empty_list - 1), cell("BoxOfNothing", 0, 0, range(0, 0)),
                    cell("BoxUpsideDown", 2, 1, range(2, 0)), cell("BoxBeforeTheVoxels", 5, 0, range(0, 4)),
                    cell("BoxBehindTheVoxels", 0, 2, range(2, 4)),
                    cell("BoxThatBeginsLate", 3, 1, range(3, 4)), cell("BoxThatEndsEarly", 3, 1, range(2, 3)),
                    cell("BoxBeyondTheSpace", 5, 0, range(4, 9)),
                    cell("BoxFarBeyondTheSpace", 5, 2, range(0, 0xffff)),
                    cell("BoxThatBeginsBeyond", 5, 2, range(0xffff, 4)),
                    without("None", StructureSection::cells),
                    resized("OneTooFew", StructureSection::cells, 5 * 16), merged_as("OfAUniformGrid", 0),
                    structured_as("OfAHierarchy", 1), merged_as("MergedInNoKnownWay", 4),
                    merged_as("MergedInTheLastWay", 255)),
    by_name);

INSTANTIATE_TEST_SUITE_P(
    Lists, HostileMergedGrid,
    testing::Values(in_lists("LastWithoutEnd", 4, 2), word("SharedByCells", StructureSection::cells, 3, 1),
                    in_lists("ReferenceBeyond", 1, 4), in_lists("LastReferenceBeyond", 2, 4 | last_bit),
                    in_lists("OneMoreWithoutEnd", 5, 0), without("None", StructureSection::references),
                    set("OfASceneWithFewerPrimitives", &GridParts::primitives, 3)),
    by_name);

// A small file of a million voxels, or cells, that share one list of 100,000 references.
TEST(HostileLists, SharedByAllCellsAreRefusedQuickly) {
  const TemporaryFolder folder;
  const std::string path = folder.file("hostile.grid");
  constexpr std::int32_t side = 100;
  Structure uniform = tiny_grid();
  uniform.layout.division = {side, side, side};
  uniform.references.assign(100000, 0);
  uniform.references.back() |= last_bit;
  for (const std::uint32_t step : {0U, 1U}) { // the whole list, or all of its ends
    uniform.voxel_map.clear();
    for (std::uint32_t i = 0; i < side * side * side; ++i)
      uniform.voxel_map.push_back(occupied_bit | step * (i % 1000));
    write_structure(uniform, tiny_grid_provenance({1, 2}), path);
    EXPECT_TRUE(is_refused_as<StructureFile>(path));
    Structure merged = tiny_merged_grid();
    merged.layout.division = {side, side, side};
    merged.nested_log2 = 0;
    merged.references = uniform.references;
    merged.voxel_map.clear();
    merged.cells.clear();
    for (std::uint32_t i = 0; i < side * side * side; ++i) {
      const std::uint32_t x = i % side, y = i / side % side, z = i / side / side;
      merged.voxel_map.push_back(occupied_bit | i);
      merged.cells.push_back({range(x, x + 1), range(y, y + 1), range(z, z + 1), step * (i % 1000)});
    }
    write_structure(merged, tiny_grid_provenance({1, 2}, merge_rule), path);
    EXPECT_TRUE(is_refused_as<StructureFile>(path));
  }
}

// Few words that divide the space 15 times, all eight of each level by the same next one: 8^15 paths.
TEST(HostileNestedMap, SharedByCubesIsRefusedQuickly) {
  const TemporaryFolder folder;
  const std::string path = folder.file("hostile.grid");
  constexpr std::uint32_t depth = 15, side = 1U << depth;
  Structure grid = tiny_merged_grid();
  grid.layout.division = {1, 1, 1};
  grid.nested_log2 = depth;
  grid.cells = {{range(0, side), range(0, side), range(0, side), 0}};
  grid.voxel_map.assign(8 * (depth + 1), 0);
  grid.voxel_map[0] = divided(8, 1);
  for (std::uint32_t level = 1; level <= depth; ++level)
    std::fill_n(grid.voxel_map.begin() + 8 * level, 8,
                level < depth ? divided(static_cast<std::uint32_t>(8 * (level + 1)), 1) : occupied_bit | 0);
  write_structure(grid, tiny_grid_provenance({1, 2}, merge_rule), path);
  EXPECT_TRUE(is_refused_as<StructureFile>(path));
}

// Traversal of any that still opens ends.
TEST(HostileMergedGridBits, AnyFlippedBitIsRefusedOrHarmless) {
  const auto [opened, refused] = with_any_flipped_bit(tiny_merged_grid(), merge_rule);
  EXPECT_GT(opened, 0);
  EXPECT_GT(refused, 500);
}

} // namespace
} // namespace masu
