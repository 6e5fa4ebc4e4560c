// Files with correct hashes and invalid contents are refused with an error.
#include "tests/hostile_files.h"
#include "tests/tiny_scene.h"

#include <cmath>
#include <limits>

namespace masu {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

using fb::SceneSection;
using fb::StructureSection;

using G = GridParts;
using P = SceneParts;
using WrongScene = Wrong<SceneParts>;

class HostileScene : public testing::TestWithParam<WrongScene> {};

TEST_P(HostileScene, IsRefused) {
  const TemporaryFolder folder;
  const std::string path = folder.file("hostile.scene");
  write_scene(tiny_scene(), Store::float32, path);
  expect_refused<SceneFile>(path, GetParam());
}

struct CameraFields {
  fb::Vec3 from, at, up;
  double angle, hither;
  std::int32_t width, height;
};
template <class Field>
WrongScene camera(const char* name, Field CameraFields::*field, const std::type_identity_t<Field>& value) {
  return {name, [=](SceneParts& p) {
            const fb::Camera& c = p.camera;
            CameraFields f{c.from(), c.at(), c.up(), c.angle(), c.hither(), c.width(), c.height()};
            f.*field = value;
            p.camera = {f.from, f.at, f.up, f.angle, f.hither, f.width, f.height};
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
WrongScene longer(const char* name, SceneSection kind, std::size_t by) {
  return {name, [=](SceneParts& p) {
            Bytes& bytes = p.section(kind).bytes;
            bytes.resize(bytes.size() + by);
          }};
}

using F = CameraFields; // See tiny_scene.h: it looks from (1, 2, 6) at (0, 0, 0.5).

INSTANTIATE_TEST_SUITE_P(
    Camera, HostileScene,
    testing::Values(camera("AngleZero", &F::angle, 0), camera("AngleNegative", &F::angle, -45),
                    camera("Angle180", &F::angle, 180), camera("AngleNaN", &F::angle, nan),
                    camera("AngleInfinite", &F::angle, infinity), camera("HitherNaN", &F::hither, nan),
                    camera("HitherInfinite", &F::hither, infinity), camera("WidthZero", &F::width, 0),
                    camera("HeightZero", &F::height, 0), camera("WidthNegative", &F::width, -1),
                    camera("HeightSmallest", &F::height, std::numeric_limits<std::int32_t>::min()),
                    camera("WidthTooLarge", &F::width, 65537), camera("FromNaN", &F::from, {nan, 0, 0}),
                    camera("FromInfinite", &F::from, {0, infinity, 0}), camera("AtNaN", &F::at, {0, 0, nan}),
                    camera("UpInfinite", &F::up, {-infinity, 0, 1}), camera("NoDirection", &F::at, {1, 2, 6}),
                    camera("UpZero", &F::up, {0, 0, 0}), camera("UpAlongTheView", &F::up, {-1, -2, -5.5})),
    by_name);

void empty_table(Bytes& bytes) {
  flatbuffers::FlatBufferBuilder builder;
  builder.Finish(flatbuffers::Offset<fb::Scene>(builder.EndTable(builder.StartTable())));
  bytes.assign(builder.GetBufferPointer(), builder.GetBufferPointer() + builder.GetSize());
}

constexpr std::uint64_t one = 1;

INSTANTIATE_TEST_SUITE_P(
    Table, HostileScene,
    testing::Values(
        set("StoreUnknown", &P::store, static_cast<fb::Store>(2)),
        set("StoreOutOfRange", &P::store, static_cast<fb::Store>(255)),
        set("StoreOfTheOtherWidth", &P::store, fb::Store::float64), set("OriginNaN", &P::origin, {0, nan, 0}),
        set("OriginInfinite", &P::origin, {-infinity, 0, 0}), set("OriginTooFar", &P::origin, {0, 0, 1e300}),
        set("BoundsNaN", &P::bounds, {{nan, 0, 0}, {1, 1, 1}}),
        set("BoundsInfinite", &P::bounds, {{0, 0, 0}, {1, infinity, 1}}),
        set("BoundsBeyondFloat32", &P::bounds, {{-1e300, -1e300, -1e300}, {1e300, 1e300, 1e300}}),
        set("BoundsInsideOut", &P::bounds, {{1, -10, -10}, {-1, 10, 10}}),
        set("BoundsTooSmall", &P::bounds, {{0, 0, 0}, {1e-3, 1e-3, 1e-3}}),
        set("NoObjects", &P::objects, {0, 0, 0, 0}), set("FewerObjects", &P::objects, {1, 1, 1, 0}),
        set("ObjectsBeyond31Bits", &P::objects, {one << 31, 1, 1, 1}),
        set("ObjectsThatOverflow", &P::objects, {one << 63, one << 63, 4, 0}),
        table<P>("TableEmpty", [](Bytes& bytes) { bytes.clear(); }),
        table<P>("TableOfOneByte", [](Bytes& bytes) { bytes.resize(1); }),
        table<P>("TableCutShort", [](Bytes& bytes) { bytes.resize(bytes.size() / 2); }),
        table<P>("TableOfZeros", [](Bytes& bytes) { bytes.assign(bytes.size(), 0); }),
        table<P>("TableOfOnes", [](Bytes& bytes) { bytes.assign(bytes.size(), 0xff); }),
        table<P>("TableWithNothingInIt", empty_table)),
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
        longer("OneSurfaceTooMany", SceneSection::sphere_surfaces, 8),
        longer("OneConeTooMany", SceneSection::cones, 32)),
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

fb::Section at_offset(const fb::Section& s, std::uint64_t offset) {
  return {s.kind(), s.record_bytes(), s.count(), offset, s.hash()};
}
fb::Section of_records(const fb::Section& s, std::uint32_t bytes, std::uint64_t count) {
  return {s.kind(), bytes, count, s.offset(), s.hash()};
}
constexpr std::uint64_t far = std::numeric_limits<std::uint64_t>::max();

// Section i of the table's list.
WrongScene one_listed(const char* name, std::size_t i,
                      const std::function<fb::Section(const fb::Section&)>& change) {
  return listed<P>(name, [=](std::vector<fb::Section>& layout) { layout[i] = change(layout[i]); });
}
WrongScene moved(const char* name, std::size_t i, std::uint64_t by) {
  return one_listed(name, i, [=](const fb::Section& s) { return at_offset(s, s.offset() + by); });
}
WrongScene at(const char* name, std::size_t i, std::uint64_t offset) {
  return one_listed(name, i, [=](const fb::Section& s) { return at_offset(s, offset); });
}
WrongScene of(const char* name, std::size_t i, std::uint32_t record_bytes, std::uint64_t records) {
  return one_listed(name, i, [=](const fb::Section& s) { return of_records(s, record_bytes, records); });
}

INSTANTIATE_TEST_SUITE_P(
    Layout, HostileScene,
    testing::Values(
        moved("Misaligned", 1, 4), at("Overlapping", 2, 0), moved("AfterAGap", 7, 256),
        moved("BeyondTheFile", 7, 1 << 20), at("BeyondAllFiles", 7, far - 255), at("OfTheLastOffset", 7, far),
        of("OfNoRecords", 7, 8, 0), of("OfRecordsWithoutSize", 7, 0, 1), of("OfAnotherRecordSize", 7, 4, 2),
        of("OfOneRecordTooMany", 7, 8, 2), of("OfARecordTooFew", 0, 24, 1),
        of("OfASizeThatOverflows", 7, 8, (far >> 3) + 2), of("OfTheLargestSize", 0, 0xffffffff, far),
        one_listed("OfAnotherHash", 3,
                   [](const fb::Section& s) {
                     return fb::Section(s.kind(), s.record_bytes(), s.count(), s.offset(),
                                        {s.hash().low() ^ 1, s.hash().high()});
                   }),
        one_listed("OfAnEarlierKind", 5,
                   [](const fb::Section& s) {
                     return fb::Section(3, s.record_bytes(), s.count(), s.offset(), s.hash());
                   }),
        listed<P>("OutOfOrder", [](std::vector<fb::Section>& l) { std::swap(l[2], l[3]); }),
        listed<P>("SectionTwice", [](std::vector<fb::Section>& l) { l.insert(l.begin() + 4, l[4]); }),
        listed<P>("SectionMissing", [](std::vector<fb::Section>& l) { l.pop_back(); }),
        listed<P>("NoSections", [](std::vector<fb::Section>& l) { l.clear(); })),
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

INSTANTIATE_TEST_SUITE_P(Alignment, HostileScene,
                         testing::Values(table<P>("MisalignedListOfSections", misalign_sections)), by_name);

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
  return set(name, &G::space, box);
}

INSTANTIATE_TEST_SUITE_P(
    Lists, HostileGrid,
    testing::Values(in_lists("LastWithoutEnd", 4, 2), in_map("SharedByVoxels", 0, occupied_bit | 1),
                    without("None", StructureSection::references), in_lists("OneMoreWithoutEnd", 5, 0),
                    in_lists("SeveralMoreWithoutEnd", 9, 0), in_lists("ReferenceBeyond", 1, 4),
                    in_lists("LastReferenceBeyond", 2, 4 | last_bit),
                    in_lists("ReferenceFarBeyond", 1, 0x7fffffff),
                    in_lists("ReferenceToNoPrimitive", 0, no_primitive),
                    set("OfASceneWithFewerPrimitives", &G::primitives, 3),
                    set("OfASceneWithNone", &G::primitives, 0),
                    set("OriginNaN", &G::origin, fb::Vec3(nan, 0, 0)),
                    set("OriginTooFar", &G::origin, fb::Vec3(0, 1e300, 0)), merged_as("OfAMergedGrid", 2),
                    merged_as("OfAnUnknownMerge", 4), structured_as("OfAHierarchy", 1)),
    by_name);

INSTANTIATE_TEST_SUITE_P(
    Map, HostileGrid,
    testing::Values(in_map("ListBeyond", 1, occupied_bit | 5), in_map("ListFarBeyond", 3, 0xffffffff),
                    in_map("EmptyWithANumber", 2, 1), in_map("TooLarge", 4, 0),
                    resized("TooSmall", StructureSection::voxel_map, 12),
                    without("Missing", StructureSection::voxel_map), blocks("InBlocks", 1),
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
        listed<G>("RecordsOfTwoBytes", [](std::vector<fb::Section>& l) { l[0] = of_records(l[0], 2, 8); }),
        listed<G>("RecordsOfEightBytes", [](std::vector<fb::Section>& l) { l[1] = of_records(l[1], 8, 2); }),
        listed<G>("OutOfOrder", [](std::vector<fb::Section>& l) { std::swap(l[0], l[1]); }),
        listed<G>("SectionMissing", [](std::vector<fb::Section>& l) { l.pop_back(); }),
        table<G>("TableEmpty", [](Bytes& bytes) { bytes.clear(); }),
        table<G>("TableOfOnes", [](Bytes& bytes) { bytes.assign(bytes.size(), 0xff); })),
    by_name);

INSTANTIATE_TEST_SUITE_P(
    Map, HostileGridOfBlocks,
    testing::Values(in_map("BlockBeyond", 1, occupied_bit | 2), in_map("BlockFarBeyond", 0, 0xffffffff),
                    in_map("BlocksShared", 1, occupied_bit | 1), in_map("EmptyBlockWithANumber", 1, 1),
                    in_map("ListBeyond", 3, occupied_bit | 5), in_map("EmptyVoxelWithANumber", 5, 2),
                    in_map("OneWordTooMany", 19, 0),
                    resized("OneWordTooFew", StructureSection::voxel_map, 18 * 4),
                    resized("NoBlockMaps", StructureSection::voxel_map, 3 * 4),
                    resized("FewerWordsThanBlocks", StructureSection::voxel_map, 2 * 4),
                    blocks("NotInBlocks", 0), blocks("InLargerBlocks", 2)),
    by_name);

} // namespace
} // namespace masu
