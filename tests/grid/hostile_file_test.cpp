// Files with correct hashes and invalid contents are refused with an error.
#include "tests/hostile_files.h"
#include "tests/tiny_scene.h"

#include <cmath>
#include <limits>

namespace masu {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

using fb::GridSection;
using fb::SceneSection;

using WrongScene = Wrong<SceneParts>;

class HostileScene : public testing::TestWithParam<WrongScene> {};

TEST_P(HostileScene, IsRefused) {
  const TemporaryFolder folder;
  const std::string path = folder.file("hostile.scene");
  write_scene(tiny_scene(), Store::float32, path);
  expect_refused<SceneFile>(path, GetParam());
}

fb::Camera with_from(const fb::Camera& c, const fb::Vec3& from) {
  return {from, c.at(), c.up(), c.angle(), c.hither(), c.width(), c.height()};
}
fb::Camera with_at(const fb::Camera& c, const fb::Vec3& at) {
  return {c.from(), at, c.up(), c.angle(), c.hither(), c.width(), c.height()};
}
fb::Camera with_up(const fb::Camera& c, const fb::Vec3& up) {
  return {c.from(), c.at(), up, c.angle(), c.hither(), c.width(), c.height()};
}
WrongScene angle(const char* name, double value) {
  return {name, [value](SceneParts& p) {
            const fb::Camera& c = p.camera;
            p.camera = {c.from(), c.at(), c.up(), value, c.hither(), c.width(), c.height()};
          }};
}
WrongScene hither(const char* name, double value) {
  return {name, [value](SceneParts& p) {
            const fb::Camera& c = p.camera;
            p.camera = {c.from(), c.at(), c.up(), c.angle(), value, c.width(), c.height()};
          }};
}
WrongScene size(const char* name, std::int32_t width, std::int32_t height) {
  return {name, [=](SceneParts& p) {
            const fb::Camera& c = p.camera;
            p.camera = {c.from(), c.at(), c.up(), c.angle(), c.hither(), width, height};
          }};
}
WrongScene triangle(const char* name, const std::function<void(Triangle<float>&)>& change) {
  return {name,
          [change](SceneParts& p) { p.section(SceneSection::triangles).edit<Triangle<float>>(1, change); }};
}
WrongScene sphere(const char* name, const std::function<void(Sphere<float>&)>& change) {
  return {name, [change](SceneParts& p) { p.section(SceneSection::spheres).edit<Sphere<float>>(0, change); }};
}
WrongScene cone(const char* name, const std::function<void(Cone<float>&)>& change) {
  return {name, [change](SceneParts& p) { p.section(SceneSection::cones).edit<Cone<float>>(0, change); }};
}
WrongScene surface(const char* name, SceneSection kind, const Surface& value) {
  return {name, [=](SceneParts& p) { p.section(kind).edit<Surface>(0, [&](Surface& s) { s = value; }); }};
}
WrongScene lacking(const char* name, SceneSection kind) {
  return {name, [kind](SceneParts& p) { p.drop(kind); }};
}
WrongScene objects(const char* name, const fb::ObjectCounts& counts) {
  return {name, [counts](SceneParts& p) { p.objects = counts; }};
}

INSTANTIATE_TEST_SUITE_P(
    Camera, HostileScene,
    testing::Values(
        angle("AngleZero", 0), angle("AngleNegative", -45), angle("Angle180", 180), angle("AngleNaN", nan),
        angle("AngleInfinite", infinity), hither("HitherNaN", nan), hither("HitherInfinite", infinity),
        size("WidthZero", 0, 6), size("HeightZero", 8, 0), size("WidthNegative", -1, 6),
        size("HeightSmallest", 8, std::numeric_limits<std::int32_t>::min()), size("WidthTooLarge", 65537, 6),
        WrongScene{"FromNaN",
                   [](SceneParts& p) {
                     p.camera = with_from(p.camera, {nan, 0, 0});
                   }},
        WrongScene{"FromInfinite",
                   [](SceneParts& p) {
                     p.camera = with_from(p.camera, {0, infinity, 0});
                   }},
        WrongScene{"AtNaN",
                   [](SceneParts& p) {
                     p.camera = with_at(p.camera, {0, 0, nan});
                   }},
        WrongScene{"UpInfinite",
                   [](SceneParts& p) {
                     p.camera = with_up(p.camera, {-infinity, 0, 1});
                   }},
        WrongScene{"NoDirection", [](SceneParts& p) { p.camera = with_at(p.camera, p.camera.from()); }},
        WrongScene{"UpZero",
                   [](SceneParts& p) {
                     p.camera = with_up(p.camera, {0, 0, 0});
                   }},
        WrongScene{"UpAlongTheView",
                   [](SceneParts& p) {
                     const fb::Vec3 &from = p.camera.from(), &at = p.camera.at();
                     p.camera = with_up(p.camera, {at.x() - from.x(), at.y() - from.y(), at.z() - from.z()});
                   }}),
    by_name);

INSTANTIATE_TEST_SUITE_P(
    Table, HostileScene,
    testing::Values(
        WrongScene{"StoreUnknown", [](SceneParts& p) { p.store = static_cast<fb::Store>(2); }},
        WrongScene{"StoreOutOfRange", [](SceneParts& p) { p.store = static_cast<fb::Store>(255); }},
        WrongScene{"StoreOfTheOtherWidth", [](SceneParts& p) { p.store = fb::Store::float64; }},
        WrongScene{"OriginNaN",
                   [](SceneParts& p) {
                     p.origin = {0, nan, 0};
                   }},
        WrongScene{"OriginInfinite",
                   [](SceneParts& p) {
                     p.origin = {-infinity, 0, 0};
                   }},
        WrongScene{"OriginTooFar",
                   [](SceneParts& p) {
                     p.origin = {0, 0, 1e300};
                   }},
        WrongScene{"BoundsNaN",
                   [](SceneParts& p) {
                     p.bounds = {{nan, 0, 0}, {1, 1, 1}};
                   }},
        WrongScene{"BoundsInfinite",
                   [](SceneParts& p) {
                     p.bounds = {{0, 0, 0}, {1, infinity, 1}};
                   }},
        WrongScene{"BoundsBeyondFloat32",
                   [](SceneParts& p) {
                     p.bounds = {{-1e300, -1e300, -1e300}, {1e300, 1e300, 1e300}};
                   }},
        WrongScene{"BoundsInsideOut",
                   [](SceneParts& p) {
                     p.bounds = {{1, -10, -10}, {-1, 10, 10}};
                   }},
        WrongScene{"BoundsTooSmall",
                   [](SceneParts& p) {
                     p.bounds = {{0, 0, 0}, {1e-3, 1e-3, 1e-3}};
                   }},
        objects("NoObjects", {0, 0, 0, 0}), objects("FewerObjects", {1, 1, 1, 0}),
        objects("ObjectsBeyond31Bits", {std::uint64_t{1} << 31, 1, 1, 1}),
        objects("ObjectsThatOverflow", {std::uint64_t{1} << 63, std::uint64_t{1} << 63, 4, 0}),
        WrongScene{"TableEmpty", [](SceneParts& p) { p.damage_table = [](Bytes& bytes) { bytes.clear(); }; }},
        WrongScene{"TableOfOneByte",
                   [](SceneParts& p) { p.damage_table = [](Bytes& bytes) { bytes.resize(1); }; }},
        WrongScene{
            "TableCutShort",
            [](SceneParts& p) { p.damage_table = [](Bytes& bytes) { bytes.resize(bytes.size() / 2); }; }},
        WrongScene{
            "TableOfZeros",
            [](SceneParts& p) { p.damage_table = [](Bytes& bytes) { bytes.assign(bytes.size(), 0); }; }},
        WrongScene{
            "TableOfOnes",
            [](SceneParts& p) { p.damage_table = [](Bytes& bytes) { bytes.assign(bytes.size(), 0xff); }; }},
        WrongScene{"TableWithNothingInIt",
                   [](SceneParts& p) {
                     p.damage_table = [](Bytes& bytes) {
                       flatbuffers::FlatBufferBuilder builder;
                       builder.Finish(flatbuffers::Offset<fb::Scene>(builder.EndTable(builder.StartTable())));
                       bytes.assign(builder.GetBufferPointer(),
                                    builder.GetBufferPointer() + builder.GetSize());
                     };
                   }}),
    by_name);

INSTANTIATE_TEST_SUITE_P(
    Records, HostileScene,
    testing::Values(
        triangle("TriangleMaterial", [](Triangle<float>& r) { r.material = 4; }),
        triangle("TriangleMaterialLargest", [](Triangle<float>& r) { r.material = 0xffffffff; }),
        triangle("TriangleObject", [](Triangle<float>& r) { r.object = 4; }),
        triangle("TriangleObjectNegative", [](Triangle<float>& r) { r.object = 0xffffffff; }),
        triangle("TriangleNormals", [](Triangle<float>& r) { r.normals = 1; }),
        triangle("TriangleNormalsBeforeNone", [](Triangle<float>& r) { r.normals = no_normals - 1; }),
        surface("SphereMaterial", SceneSection::sphere_surfaces, {2, 4}),
        surface("SphereObject", SceneSection::sphere_surfaces, {4, 2}),
        surface("ConeMaterial", SceneSection::cone_surfaces, {3, 0x80000000}),
        surface("ConeObject", SceneSection::cone_surfaces, {0x80000000, 3}),
        lacking("NoMaterials", SceneSection::materials), lacking("NoNormals", SceneSection::corner_normals),
        lacking("NoSpheres", SceneSection::spheres),
        lacking("NoSphereSurfaces", SceneSection::sphere_surfaces), lacking("NoCones", SceneSection::cones),
        lacking("NoConeSurfaces", SceneSection::cone_surfaces),
        triangle("VertexNaN", [](Triangle<float>& r) { r.b.y = std::nanf(""); }),
        triangle("VertexInfinite", [](Triangle<float>& r) { r.c.z = -HUGE_VALF; }),
        triangle("VertexBeyondTheBounds", [](Triangle<float>& r) { r.a.x = 1e6F; }),
        triangle("VertexFarBeyond", [](Triangle<float>& r) { r.a.x = -3e38F; }),
        sphere("CentreBeyondTheBounds", [](Sphere<float>& s) { s.center.z = 1e6F; }),
        sphere("RadiusBeyondTheBounds", [](Sphere<float>& s) { s.radius = -1e30F; }),
        cone("ConesEndBeyondTheBounds", [](Cone<float>& c) { c.apex.y = 1e6F; }),
        cone("ConesRadiusBeyondTheBounds", [](Cone<float>& c) { c.apex_radius = 1e6F; }),
        cone("ConeWithoutLength", [](Cone<float>& c) { c.apex = c.base; }),
        sphere("CentreNaN", [](Sphere<float>& s) { s.center.x = std::nanf(""); }),
        sphere("CentreInfinite", [](Sphere<float>& s) { s.center.x = HUGE_VALF; }),
        sphere("RadiusNaN", [](Sphere<float>& s) { s.radius = std::nanf(""); }),
        cone("ConesEndNaN", [](Cone<float>& c) { c.apex.y = std::nanf(""); }),
        cone("ConesRadiusInfinite", [](Cone<float>& c) { c.base_radius = HUGE_VALF; }),
        WrongScene{"OneSurfaceTooMany",
                   [](SceneParts& p) {
                     Bytes& bytes = p.section(SceneSection::sphere_surfaces).bytes;
                     bytes.insert(bytes.end(), 8, 0);
                   }},
        WrongScene{"OneConeTooMany",
                   [](SceneParts& p) {
                     Bytes& bytes = p.section(SceneSection::cones).bytes;
                     bytes.insert(bytes.end(), 32, 0);
                   }}),
    by_name);

// With numbers of the faces of both triangles, or of others.
WrongScene faces(const char* name, const std::vector<std::uint32_t>& numbers,
                 std::uint32_t record_bytes = sizeof(std::uint32_t)) {
  return {name, [=](SceneParts& p) {
            Bytes bytes(numbers.size() * sizeof numbers[0]);
            std::memcpy(bytes.data(), numbers.data(), bytes.size());
            p.sections.push_back({static_cast<std::uint32_t>(SceneSection::faces), record_bytes, bytes});
          }};
}

INSTANTIATE_TEST_SUITE_P(Faces, HostileScene,
                         testing::Values(faces("OneTooFew", {0}), faces("OneTooMany", {0, 0, 1}),
                                         faces("Negative", {0, 0xffffffff}),
                                         faces("Beyond31Bits", {0x7fffffff, 0}),
                                         faces("OfAnotherRecordSize", {0, 1}, 2)),
                         by_name);

// Makes the table describe one section falsely.
WrongScene listed(const char* name, std::size_t i,
                  const std::function<fb::Section(const fb::Section&)>& change) {
  return {name, [=](SceneParts& p) {
            p.falsify = [=](std::vector<fb::Section>& layout) { layout[i] = change(layout[i]); };
          }};
}
WrongScene layout(const char* name, const std::function<void(std::vector<fb::Section>&)>& change) {
  return {name, [change](SceneParts& p) { p.falsify = change; }};
}
fb::Section at_offset(const fb::Section& s, std::uint64_t offset) {
  return {s.kind(), s.record_bytes(), s.count(), offset, s.hash()};
}
fb::Section of_records(const fb::Section& s, std::uint32_t bytes, std::uint64_t count) {
  return {s.kind(), bytes, count, s.offset(), s.hash()};
}
constexpr std::uint64_t far = std::numeric_limits<std::uint64_t>::max();

INSTANTIATE_TEST_SUITE_P(
    Layout, HostileScene,
    testing::Values(
        listed("Misaligned", 1, [](const fb::Section& s) { return at_offset(s, s.offset() + 4); }),
        listed("Overlapping", 2, [](const fb::Section& s) { return at_offset(s, 0); }),
        listed("AfterAGap", 7, [](const fb::Section& s) { return at_offset(s, s.offset() + 256); }),
        listed("BeyondTheFile", 7, [](const fb::Section& s) { return at_offset(s, s.offset() + (1 << 20)); }),
        listed("BeyondAllFiles", 7, [](const fb::Section& s) { return at_offset(s, far - 255); }),
        listed("OfTheLastOffset", 7, [](const fb::Section& s) { return at_offset(s, far); }),
        listed("OfNoRecords", 7, [](const fb::Section& s) { return of_records(s, 8, 0); }),
        listed("OfRecordsWithoutSize", 7, [](const fb::Section& s) { return of_records(s, 0, 1); }),
        listed("OfAnotherRecordSize", 7, [](const fb::Section& s) { return of_records(s, 4, 2); }),
        listed("OfOneRecordTooMany", 7, [](const fb::Section& s) { return of_records(s, 8, 2); }),
        listed("OfARecordTooFew", 0, [](const fb::Section& s) { return of_records(s, 24, 1); }),
        listed("OfASizeThatOverflows", 7,
               [](const fb::Section& s) { return of_records(s, 8, (far >> 3) + 2); }),
        listed("OfTheLargestSize", 0, [](const fb::Section& s) { return of_records(s, 0xffffffff, far); }),
        listed("OfAnotherHash", 3,
               [](const fb::Section& s) {
                 return fb::Section(s.kind(), s.record_bytes(), s.count(), s.offset(),
                                    {s.hash().low() ^ 1, s.hash().high()});
               }),
        listed("OfAnEarlierKind", 5,
               [](const fb::Section& s) {
                 return fb::Section(3, s.record_bytes(), s.count(), s.offset(), s.hash());
               }),
        layout("OutOfOrder", [](std::vector<fb::Section>& l) { std::swap(l[2], l[3]); }),
        layout("SectionTwice", [](std::vector<fb::Section>& l) { l.insert(l.begin() + 4, l[4]); }),
        layout("SectionMissing", [](std::vector<fb::Section>& l) { l.pop_back(); }),
        layout("NoSections", [](std::vector<fb::Section>& l) { l.clear(); })),
    by_name);

// A correct list of sections at an offset that isn't aligned for a Section.
void misalign_sections(Bytes& table) {
  const auto* const root = flatbuffers::GetRoot<flatbuffers::Table>(table.data());
  const auto field = static_cast<std::size_t>(root->GetAddressOf(fb::Scene::VT_SECTIONS) - table.data());
  const auto* const sections = fb::GetScene(table.data())->sections();
  const auto* const list = reinterpret_cast<const std::uint8_t*>(sections);
  const Bytes copy(list, list + 4 + sections->size() * sizeof(fb::Section));
  table.resize((table.size() + 7) / 8 * 8); // the list is preceded by its length, four bytes
  const auto offset = static_cast<std::uint32_t>(table.size() - field);
  table.insert(table.end(), copy.begin(), copy.end());
  std::memcpy(table.data() + field, &offset, sizeof offset);
}

TEST(HostileTable, MisalignedListOfSectionsIsRefused) {
  const TemporaryFolder folder;
  const std::string path = folder.file("hostile.scene");
  write_scene(tiny_scene(), Store::float32, path);
  SceneParts parts(path);
  parts.damage_table = misalign_sections;
  parts.write(path);
  EXPECT_TRUE(is_refused_as<SceneFile>(path));
}

TEST(HostileFloat64Scene, IndicesBeyond32BitsAreRefused) {
  const TemporaryFolder folder;
  const std::string path = folder.file("hostile.scene");
  write_scene(tiny_scene(), Store::float64, path);
  const SceneParts parts(path);
  constexpr std::uint64_t high = std::uint64_t{1} << 32;
  const std::vector<std::function<void(Triangle<double>&)>> changes{
      [](auto& t) { t.material |= high; }, [](auto& t) { t.object |= high; },
      [](auto& t) { t.normals |= high; }, [](auto& t) { t.normals = ~std::uint64_t{0}; }};
  for (std::size_t i = 0; i < changes.size(); ++i) {
    SceneParts spoilt = parts;
    spoilt.section(SceneSection::triangles).edit<Triangle<double>>(1, changes[i]);
    spoilt.write(path);
    EXPECT_TRUE(is_refused_as<SceneFile>(path)) << i;
  }
}

class HostileGrid : public testing::TestWithParam<WrongGrid> {};

TEST_P(HostileGrid, IsRefused) {
  expect_grid_refused(tiny_grid(), "", GetParam());
}

class HostileGridOfBlocks : public HostileGrid {};

TEST_P(HostileGridOfBlocks, IsRefused) {
  expect_grid_refused(tiny_grid_of_blocks(), "", GetParam());
}

WrongGrid space(const char* name, const fb::Box& box) {
  return {name, [box](GridParts& p) { p.space = box; }};
}

INSTANTIATE_TEST_SUITE_P(
    Lists, HostileGrid,
    testing::Values(word("LastWithoutEnd", GridSection::references, 4, 2),
                    word("SharedByVoxels", GridSection::voxel_map, 0, occupied_bit | 1),
                    without("None", GridSection::references),
                    word("OneMoreWithoutEnd", GridSection::references, 5, 0),
                    word("SeveralMoreWithoutEnd", GridSection::references, 9, 0),
                    word("ReferenceBeyond", GridSection::references, 1, 4),
                    word("LastReferenceBeyond", GridSection::references, 2, 4 | last_bit),
                    word("ReferenceFarBeyond", GridSection::references, 1, 0x7fffffff),
                    word("ReferenceToNoPrimitive", GridSection::references, 0, no_primitive),
                    WrongGrid{"OfASceneWithFewerPrimitives", [](GridParts& p) { p.primitives = 3; }},
                    WrongGrid{"OfASceneWithNone", [](GridParts& p) { p.primitives = 0; }},
                    WrongGrid{"OriginNaN",
                              [](GridParts& p) {
                                p.origin = {nan, 0, 0};
                              }},
                    WrongGrid{"OriginTooFar",
                              [](GridParts& p) {
                                p.origin = {0, 1e300, 0};
                              }},
                    WrongGrid{"OfAMergedGrid", [](GridParts& p) { p.merge = fb::Merge::balance; }},
                    WrongGrid{"OfAnUnknownMerge", [](GridParts& p) { p.merge = static_cast<fb::Merge>(5); }}),
    by_name);

INSTANTIATE_TEST_SUITE_P(
    Map, HostileGrid,
    testing::Values(word("ListBeyond", GridSection::voxel_map, 1, occupied_bit | 5),
                    word("ListFarBeyond", GridSection::voxel_map, 3, 0xffffffff),
                    word("EmptyWithANumber", GridSection::voxel_map, 2, 1),
                    word("TooLarge", GridSection::voxel_map, 4, 0),
                    WrongGrid{"TooSmall",
                              [](GridParts& p) { p.section(GridSection::voxel_map).bytes.resize(12); }},
                    without("Missing", GridSection::voxel_map), blocks("InBlocks", 1),
                    blocks("InLargeBlocks", 5), blocks("InBlocksTooLarge", 6), blocks("InBlocksOf31Bits", 31),
                    blocks("InBlocksOf32Bits", 32), blocks("InBlocksOfAllBits", 0xffffffff),
                    division("DivisionZero", 0, 2, 2), division("DivisionZeroLast", 2, 2, 0),
                    division("DivisionFiner", 2, 2, 2), division("DivisionCoarser", 2, 1, 1),
                    division("DivisionHuge", 65535, 65535, 65535), division("DivisionBeyond", 65536, 1, 1),
                    division("DivisionThatOverflows", 0x80000000, 2, 0x80000000),
                    division("DivisionNegative", 0xffffffff, 0xffffffff, 4)),
    by_name);

INSTANTIATE_TEST_SUITE_P(Space, HostileGrid,
                         testing::Values(space("NaN", {{nan, 0, 0}, {1, 1, 1}}),
                                         space("NaNAbove", {{0, 0, 0}, {1, 1, nan}}),
                                         space("Infinite", {{0, 0, 0}, {1, infinity, 1}}),
                                         space("InfiniteBelow", {{0, -infinity, 0}, {1, 1, 1}}),
                                         space("UpsideDown", {{0, 0, 1}, {1, 1, 0}}),
                                         space("Flat", {{0, 0, 1}, {1, 1, 1}}),
                                         space("TooThin", {{0, 0, 0}, {1, 1, 5e-324}}),
                                         space("TooWide", {{-1.7e308, 0, 0}, {1.7e308, 1, 1}})),
                         by_name);

INSTANTIATE_TEST_SUITE_P(
    Sections, HostileGrid,
    testing::Values(
        WrongGrid{"RecordsOfTwoBytes",
                  [](GridParts& p) {
                    p.falsify = [](std::vector<fb::Section>& l) { l[0] = of_records(l[0], 2, 8); };
                  }},
        WrongGrid{"RecordsOfEightBytes",
                  [](GridParts& p) {
                    p.falsify = [](std::vector<fb::Section>& l) { l[1] = of_records(l[1], 8, 2); };
                  }},
        WrongGrid{
            "OutOfOrder",
            [](GridParts& p) { p.falsify = [](std::vector<fb::Section>& l) { std::swap(l[0], l[1]); }; }},
        WrongGrid{"SectionMissing",
                  [](GridParts& p) { p.falsify = [](std::vector<fb::Section>& l) { l.pop_back(); }; }},
        WrongGrid{"TableEmpty", [](GridParts& p) { p.damage_table = [](Bytes& bytes) { bytes.clear(); }; }},
        WrongGrid{
            "TableOfOnes",
            [](GridParts& p) { p.damage_table = [](Bytes& bytes) { bytes.assign(bytes.size(), 0xff); }; }}),
    by_name);

INSTANTIATE_TEST_SUITE_P(
    Map, HostileGridOfBlocks,
    testing::Values(word("BlockBeyond", GridSection::voxel_map, 1, occupied_bit | 2),
                    word("BlockFarBeyond", GridSection::voxel_map, 0, 0xffffffff),
                    word("BlocksShared", GridSection::voxel_map, 1, occupied_bit | 1),
                    word("EmptyBlockWithANumber", GridSection::voxel_map, 1, 1),
                    word("ListBeyond", GridSection::voxel_map, 3, occupied_bit | 5),
                    word("EmptyVoxelWithANumber", GridSection::voxel_map, 5, 2),
                    word("OneWordTooMany", GridSection::voxel_map, 19, 0),
                    WrongGrid{"OneWordTooFew",
                              [](GridParts& p) { p.section(GridSection::voxel_map).bytes.resize(18 * 4); }},
                    WrongGrid{"NoBlockMaps",
                              [](GridParts& p) { p.section(GridSection::voxel_map).bytes.resize(3 * 4); }},
                    WrongGrid{"FewerWordsThanBlocks",
                              [](GridParts& p) { p.section(GridSection::voxel_map).bytes.resize(2 * 4); }},
                    blocks("NotInBlocks", 0), blocks("InLargerBlocks", 2)),
    by_name);

} // namespace
} // namespace masu
