// Hierarchies with correct hashes and invalid contents are refused with an error; none leads traversal out of
// its arrays or into an endless loop.
#include "tests/random_test.h"
#include "tests/unchecked_grid.h"

#include <cmath>
#include <limits>

namespace masu {
namespace {

using fb::StructureSection;

class HostileHierarchy : public testing::TestWithParam<WrongGrid> {};

TEST_P(HostileHierarchy, IsRefused) {
  expect_grid_refused(tiny_hierarchy(), "", GetParam());
}

WrongGrid node(const char* name, std::size_t i, const std::function<void(HierarchyNode&)>& change) {
  return {name, [=](GridParts& p) { p.section(StructureSection::nodes).edit<HierarchyNode>(i, change); }};
}
WrongGrid slot(const char* name, std::size_t i, int slot, std::uint32_t value) {
  return node(name, i, [=](HierarchyNode& n) {
    const int shift = slot % 4 * 8;
    n.slots[slot / 4] = (n.slots[slot / 4] & ~(0xffU << shift)) | value << shift;
  });
}
WrongGrid origin(const char* name, int axis, float value) {
  return node(name, 1, [=](HierarchyNode& n) { n.origin[axis] = value; });
}
WrongGrid first_node(const char* name, std::size_t i, std::uint32_t value) {
  return node(name, i, [=](HierarchyNode& n) { n.first_node = value; });
}
WrongGrid first_reference(const char* name, std::size_t i, std::uint32_t value) {
  return node(name, i, [=](HierarchyNode& n) { n.first_reference = value; });
}
WrongGrid with_section(const char* name, StructureSection kind, std::uint32_t record_bytes) {
  return {name, [=](GridParts& p) {
            p.sections.push_back({static_cast<std::uint32_t>(kind), record_bytes, Bytes(record_bytes)});
            std::ranges::sort(p.sections, {}, &SectionBytes::kind);
          }};
}

constexpr float nan = std::numeric_limits<float>::quiet_NaN(),
                infinity = std::numeric_limits<float>::infinity();

// See tiny_scene.h: slot 1 of the root holds two references, slot 6 a node, whose slots 0 and 5 hold a
// reference each.
INSTANTIATE_TEST_SUITE_P(
    Nodes, HostileHierarchy,
    testing::Values(origin("OriginNaN", 0, nan), origin("OriginInfinite", 1, infinity),
                    origin("OriginMinusInfinite", 2, -infinity), first_node("NodeOfItself", 0, 0),
                    first_node("NodeBeyond", 0, 2), first_node("NodeFarBeyond", 0, 0xffffffff),
                    node("ACycle", 1,
                         [](HierarchyNode& n) {
                           n.exponents |= 1U << 24;
                           n.slots[0] = node_slot;
                           n.first_node = 0;
                         }),
                    node("ANodeTwice", 1,
                         [](HierarchyNode& n) {
                           n.exponents |= 1U << 24;
                           n.slots[0] = node_slot;
                           n.first_node = 1;
                         }),
                    node("OneMoreNode", 0,
                         [](HierarchyNode& n) {
                           n.exponents |= 1U << 31;
                           n.slots[1] |= (node_slot | 7) << 24;
                         }),
                    node("NodeOnlyInTheMask", 0, [](HierarchyNode& n) { n.exponents |= 1U << 24; }),
                    node("NodeOnlyInTheSlot", 0, [](HierarchyNode& n) { n.exponents &= 0xffffff; }),
                    node("NodeUnreached", 0,
                         [](HierarchyNode& n) {
                           n.exponents &= 0xffffff;
                           n.slots[1] = 0;
                         }),
                    slot("SlotOfAnother", 0, 6, node_slot | 5), slot("NodeWithTwoBits", 0, 6, 0x78 | 6),
                    slot("NodeWithoutItsBit", 0, 6, 0x18 | 6), slot("ReferencesAsANode", 0, 1, 0x38 | 1),
                    without("None", StructureSection::nodes),
                    with_section("AVoxelMap", StructureSection::voxel_map, 4),
                    with_section("Cells", StructureSection::cells, 16), division("Divided", 2, 1, 1),
                    resized("OneNodeTooMany", StructureSection::nodes, 3 * sizeof(HierarchyNode)),
                    resized("OneNodeTooFew", StructureSection::nodes, sizeof(HierarchyNode)),
                    structured_as("OfAUniformGrid", 0), merged_as("OfAnIrregularGrid", 3),
                    merged_as("MergedInNoKnownWay", 4), structured_as("OfNoKnownStructure", 2),
                    set("OfNoKnownQuality", &GridParts::quality, static_cast<fb::Quality>(2))),
    by_name);

INSTANTIATE_TEST_SUITE_P(
    References, HostileHierarchy,
    testing::Values(first_reference("Beyond", 1, 3), first_reference("FarBeyond", 1, 0xffffffff),
                    first_reference("NearlyWrapping", 0, 0xfffffffe), slot("OneMore", 1, 5, 3 << 5 | 1),
                    slot("ThirdAlone", 1, 5, 4 << 5 | 1), slot("AtTheLastBit", 1, 5, 1 << 5 | 23),
                    slot("AtTheNodesBits", 1, 5, 7 << 5 | 22), slot("BeyondTheNodesBits", 1, 5, 7 << 5 | 23),
                    slot("BeyondAllBits", 1, 5, 1 << 5 | 31), slot("OfNoneAmongTheNodes", 1, 5, 24),
                    in_lists("PrimitiveBeyond", 1, 4), in_lists("WithAListsEnd", 3, 3 | last_bit),
                    without("Missing", StructureSection::references),
                    set("OfASceneWithFewerPrimitives", &GridParts::primitives, 3)),
    by_name);

// A chain of nodes, each in a slot of the one before.
Structure chain(int depth) {
  Structure grid = tiny_hierarchy();
  HierarchyNode link = grid.nodes[0];
  link.slots[0] = 0;
  link.first_reference = 2;
  grid.nodes.assign(static_cast<std::size_t>(depth), link);
  for (std::uint32_t i = 0; i < grid.nodes.size(); ++i)
    grid.nodes[i].first_node = i + 1;
  grid.nodes.back() = tiny_hierarchy().nodes[1];
  return grid;
}

TEST(HostileHierarchyDepth, IsRefusedBeyondTheWalksStack) {
  const TemporaryFolder folder;
  const std::string path = folder.file("deep.grid");
  write_structure(chain(max_hierarchy_depth), tiny_grid_provenance({1, 2}), path);
  EXPECT_NO_THROW(const StructureFile file(path));
  for (const int depth : {max_hierarchy_depth + 1, 1000, 100'000}) {
    write_structure(chain(depth), tiny_grid_provenance({1, 2}), path);
    EXPECT_TRUE(is_refused_as<StructureFile>(path)) << depth;
  }
}

using DamagedHierarchy = RandomTest;

TEST_F(DamagedHierarchy, AnyFlippedBitIsRefusedOrHarmless) {
  const auto [opened, refused] = with_any_flipped_bit(tiny_hierarchy(), "");
  EXPECT_GT(opened, 500); // planes may be anything
  EXPECT_GT(refused, 200);
}

Scene scene_of_spheres(Chance& chance) {
  Scene scene = tiny_scene();
  scene.spheres.clear();
  for (std::size_t i = 0; i < 400; ++i)
    scene.spheres.push_back({chance.in_cube(2), 0.1});
  scene.sphere_surfaces.assign(scene.spheres.size(), {2, 2});
  return scene;
}

// Several levels of nodes, each with anything for an exponent, a plane, a slot or a number.
TEST_F(DamagedHierarchy, OfManyNodesIsRefusedOrHarmless) {
  auto random = seed_.engine();
  const TemporaryFolder folder;
  const std::string scene_path = folder.file("scene"), path = folder.file("grid");
  write_scene(scene_of_spheres(chance_), Store::float32, scene_path);
  const SceneFile scene(scene_path);
  build_a_little(scene, Overlap::exact, StructureKind::hierarchy, path);
  const GridParts parts(path);
  const StructureFile whole(path);
  OpenedAndRefused count;
  ASSERT_GT(whole.nodes().size(), 20U);
  const auto numbers = static_cast<std::uint32_t>(whole.nodes().size() + whole.references().size());
  for (std::int64_t i = cases(400); i > 0; --i) {
    GridParts spoilt = parts;
    SectionBytes& nodes = spoilt.section(StructureSection::nodes);
    for (std::uint64_t changes = 1 + random() % 3; changes > 0; --changes) {
      nodes.edit<HierarchyNode>(random() % whole.nodes().size(), [&](HierarchyNode& n) {
        const auto bits = static_cast<std::uint32_t>(random());
        switch (random() % 8) {
        case 0: // the finest or the coarsest unit, or none at all
          n.exponents = (n.exponents & 0xff000000U) | (random() % 2 == 0 ? bits & 0xffffff
                                                       : bits % 2 == 0   ? 0xffffffU
                                                                         : 0U);
          break;
        case 1:
          n.origin[bits % 3] = std::ldexp(1.0F, static_cast<int>(bits >> 8) % 128);
          break;
        case 2:
          n.low[bits % 3][bits >> 8 & 1] = static_cast<std::uint32_t>(random());
          break;
        case 3:
          n.high[bits % 3][bits >> 8 & 1] = static_cast<std::uint32_t>(random());
          break;
        case 4:
          n.first_node = bits % numbers;
          break;
        case 5:
          n.first_reference = bits % numbers;
          break;
        case 6:
          n.slots[bits % 2] ^= 1U << (bits >> 8) % 32;
          break;
        default:
          n.exponents ^= 1U << (24 + bits % 8);
        }
      });
    }
    open_and_trace(spoilt, scene, path, count);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(count.opened, cases(25));
  EXPECT_GT(count.refused, cases(25));
}

} // namespace
} // namespace masu
