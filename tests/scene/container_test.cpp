// Scene and grid files: equal input gives equal bytes, and any damage is detected.
#include "tests/random_test.h"
#include "tests/refused.h"
#include "tests/temporary_folder.h"
#include "tests/tiny_files.h"

#include <fcntl.h>
#include <unistd.h>

#include <set>

namespace masu {
namespace {

using ContainerHash = RandomTest;

std::string written_scene(const TemporaryFolder& folder, const Scene& scene, Store store = Store::automatic) {
  const std::string path = folder.file("written.scene");
  write_scene(scene, store, path);
  return path;
}

class Container : public RandomTest, public testing::WithParamInterface<TinyFile> {
protected:
  void SetUp() override {
    GetParam().write(path_, {1, 2});
    ASSERT_NO_THROW(GetParam().open(path_));
  }

  testing::AssertionResult refused(const std::string& path, const std::string& says = "") const {
    return is_refused([](const std::string& name) { GetParam().open(name); }, path, says);
  }

  // Overwrites one byte of the file in place.
  void set_byte(std::size_t offset, std::uint8_t value) const {
    const int file = open(path_.c_str(), O_WRONLY | O_CLOEXEC);
    ASSERT_GE(file, 0);
    EXPECT_EQ(pwrite(file, &value, 1, static_cast<off_t>(offset)), 1);
    close(file);
  }

  const TemporaryFolder folder_;
  const std::string path_ = folder_.file("small");
};

INSTANTIATE_TEST_SUITE_P(All, Container, testing::ValuesIn(tiny_files()),
                         [](const auto& test) { return std::string(test.param.name); });

// Every bit of the prelude, and one of each byte after it.
TEST_P(Container, AnyChangedByteIsDetected) {
  auto random = seed_.engine();
  const Bytes bytes = read_bytes(path_);
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    const std::uint64_t any = random() % 8;
    for (unsigned bit = 0; bit < 8; ++bit) {
      if (at >= sizeof(Prelude) && bit != any) continue;
      set_byte(at, static_cast<std::uint8_t>(bytes[at] ^ (1U << bit)));
      ASSERT_TRUE(refused(path_)) << "bit " << bit << " of byte " << at << " of " << bytes.size();
    }
    set_byte(at, bytes[at]);
  }
  EXPECT_NO_THROW(GetParam().open(path_));
}

TEST_P(Container, AnyTruncationIsDetected) {
  for (std::size_t size = read_bytes(path_).size(); size-- > 0;) {
    ASSERT_EQ(truncate(path_.c_str(), static_cast<off_t>(size)), 0);
    ASSERT_TRUE(refused(path_)) << "cut down to " << size << " bytes";
  }
}

TEST_P(Container, AnyTrailingBytesAreDetected) {
  const Bytes bytes = read_bytes(path_);
  for (const std::size_t more : {1, 2, 3, 4, 7, 8, 16, 64, 255, 256, 257, 4095, 4096, 65536}) {
    for (const unsigned value : {0x00U, 0x01U, 0xffU}) {
      Bytes longer = bytes;
      longer.resize(bytes.size() + more, static_cast<std::uint8_t>(value));
      write_bytes(path_, longer);
      ASSERT_TRUE(refused(path_)) << more << " bytes of " << value << " more";
    }
  }
}

TEST_P(Container, MissingAndOtherFilesAreRefused) {
  EXPECT_TRUE(refused(folder_.file("missing"), "No such file"));
  EXPECT_TRUE(refused(folder_.path().string(), "is a directory"));
  EXPECT_TRUE(refused("/dev/null", "isn't a regular file"));
  EXPECT_TRUE(refused("", "can't be opened"));
  write_text(path_, "");
  EXPECT_TRUE(refused(path_, std::string("isn't a ") + GetParam().kind.name));
  write_text(path_, "v\nfrom 0 0 5\nat 0 0 0\n");
  EXPECT_TRUE(refused(path_, std::string("isn't a ") + GetParam().kind.name));
}

TEST_P(Container, TheOtherKindIsRefused) {
  for (const TinyFile& other : tiny_files()) {
    if (other.kind.magic == GetParam().kind.magic) continue;
    other.write(path_, {1, 2});
    EXPECT_TRUE(refused(path_, std::string("isn't a ") + GetParam().kind.name)) << other.name;
  }
}

TEST_P(Container, OtherVersionsAreRefusedAndNamed) {
  for (const std::uint32_t version : {0U, 1U, 2U, 3U, 4U, 0xffffffffU}) {
    FileKind kind = GetParam().kind;
    if (kind.version == version) continue;
    kind.version = version;
    const Bytes table(32, 1);
    write_container(path_, kind, table, {}, {});
    EXPECT_TRUE(refused(path_, "version " + std::to_string(version)));
    EXPECT_TRUE(refused(path_, "version " + std::to_string(GetParam().kind.version)));
    EXPECT_TRUE(refused(path_, kind.remake));
  }
}

// A section of several pieces, which are hashed separately.
constexpr std::size_t large_words = 5 * (std::size_t{1} << 19) + 77; // 20 MiB and some

struct LargeFile {
  std::vector<std::uint64_t> words = std::vector<std::uint64_t>(large_words);
  std::array<SectionData, 1> sections{section_data(7, std::span<const std::uint64_t>(words))};

  LargeFile() {
    for (std::size_t i = 0; i < words.size(); ++i)
      words[i] = i * 0x9e3779b97f4a7c15U;
  }
};

TEST_F(ContainerHash, CoversEveryPieceOfALargeSection) {
  auto random = seed_.engine();
  LargeFile large;
  const auto layout = lay_out(large.sections);
  const std::size_t piece_words = std::size_t{1} << 19;
  for (const std::size_t at : {std::size_t{0}, piece_words - 1, piece_words, 3 * piece_words, large_words - 1,
                               static_cast<std::size_t>(random() % large_words)}) {
    const std::uint64_t bit = std::uint64_t{1} << (random() % 64);
    large.words[at] ^= bit;
    EXPECT_NE(lay_out(large.sections)[0].hash().low(), layout[0].hash().low()) << "word " << at;
    large.words[at] ^= bit;
  }
  EXPECT_EQ(lay_out(large.sections)[0].hash().low(), layout[0].hash().low());
}

TEST_F(ContainerHash, IsTheSameForAnyNumberOfThreads) {
  const LargeFile large;
  compare_threads([&] { return lay_out(large.sections)[0].hash(); },
                  [](const fb::Hash& one, const fb::Hash& more) {
                    EXPECT_EQ(one.low(), more.low());
                    EXPECT_EQ(one.high(), more.high());
                  });
}

struct SceneChange {
  const char* what;
  std::function<void(Scene&)> act;
  bool of_geometry = false; // of what a grid is built from
};

const std::vector<SceneChange> scene_changes{
    {"from", [](Scene& s) { s.camera.from.x += 1; }},
    {"at", [](Scene& s) { s.camera.at.y += 1; }},
    {"up", [](Scene& s) { s.camera.up.x += 1; }},
    {"angle", [](Scene& s) { s.camera.angle += 1; }},
    {"hither", [](Scene& s) { s.camera.hither += 1; }},
    {"width", [](Scene& s) { s.camera.width += 1; }},
    {"height", [](Scene& s) { s.camera.height += 1; }},
    {"background", [](Scene& s) { s.background.z += 0.125F; }},
    {"ambient", [](Scene& s) { s.ambient += 0.125F; }},
    {"light's position", [](Scene& s) { s.lights[1].position.x += 1; }},
    {"light's colour", [](Scene& s) { s.lights[1].intensity.z += 1; }},
    {"one light less", [](Scene& s) { s.lights.pop_back(); }},
    {"colour", [](Scene& s) { s.materials[0].color.x = 0.5F; }},
    {"Kd", [](Scene& s) { s.materials[0].diffuse = 0.5F; }},
    {"Ks", [](Scene& s) { s.materials[1].specular = 0.25F; }},
    {"shine", [](Scene& s) { s.materials[1].shine = 9; }},
    {"T", [](Scene& s) { s.materials[2].transmittance = 0.25F; }},
    {"ior", [](Scene& s) { s.materials[2].refraction_index = 1.25F; }},
    {"vertex, by one ulp", [](Scene& s) { s.triangles[0].c.y = std::nextafter(2.0F, 3.0F); }, true},
    {"triangle's material", [](Scene& s) { s.triangles[0].material = 3; }, true},
    {"triangle's object", [](Scene& s) { s.triangles[0].object = 3; }, true},
    {"order of triangles", [](Scene& s) { std::swap(s.triangles[0], s.triangles[1]); }, true},
    {"corner normal", [](Scene& s) { s.normals[0].c.z += 1; }},
    {"flat instead of smooth", [](Scene& s) { s.triangles[1].normals = no_normals; }, true},
    {"centre", [](Scene& s) { s.spheres[0].center.z += 0.125; }, true},
    {"sphere's sign", [](Scene& s) { s.spheres[0].radius *= -1; }, true},
    {"sphere's material", [](Scene& s) { s.sphere_surfaces[0].material = 0; }},
    {"cone's end", [](Scene& s) { s.cones[0].apex.y += 0.125; }, true},
    {"cone's radius", [](Scene& s) { s.cones[0].apex_radius = 0; }, true},
    {"cone's object", [](Scene& s) { s.cone_surfaces[0].object = 0; }},
    {"counted objects", [](Scene& s) { ++s.objects.polygons; }},
    {"one sphere less",
     [](Scene& s) {
       s.spheres.clear();
       s.sphere_surfaces.clear();
     },
     true},
    {"one material more", [](Scene& s) { s.materials.push_back(s.materials[0]); }},
    {"no light", [](Scene& s) { s.lights.clear(); }},
    {"numbers of faces", [](Scene& s) { s.faces.assign(2, 0); }}};

// Of every part, and of the store; that of the geometry, of what a grid is built from alone.
TEST(SceneHashes, DependOnTheScene) {
  const TemporaryFolder folder;
  std::set<std::string> hashes, geometry_hashes;
  for (const Store store : {Store::float32, Store::float64}) {
    const auto hashes_of = [&](const Scene& scene) {
      const SceneFile file(written_scene(folder, scene, store));
      return std::pair(to_hex(file.hash()), to_hex(file.geometry_hash()));
    };
    const auto [whole, unchanged] = hashes_of(tiny_scene());
    EXPECT_TRUE(hashes.insert(whole).second && geometry_hashes.insert(unchanged).second)
        << "the stores' hashes are equal";
    for (const SceneChange& change : scene_changes) {
      Scene scene = tiny_scene();
      change.act(scene);
      const auto [hash, geometry_hash] = hashes_of(scene);
      EXPECT_TRUE(hashes.insert(hash).second) << change.what << ": the hash didn't change";
      if (change.of_geometry)
        EXPECT_TRUE(geometry_hashes.insert(geometry_hash).second)
            << change.what << ": the hash didn't change";
      else
        EXPECT_EQ(geometry_hash, unchanged) << change.what;
    }
  }
}

TEST(GeometryHash, IsReturnedByTheWriter) {
  const TemporaryFolder folder;
  Scene empty{};
  empty.camera = tiny_scene().camera;
  for (const Scene& scene : {tiny_scene(), empty}) {
    for (const Store store : {Store::float32, Store::float64}) {
      const Hash written = write_scene(scene, store, folder.file("a.scene"));
      EXPECT_EQ(written, SceneFile(folder.file("a.scene")).geometry_hash());
    }
  }
}

TEST(SceneStore, AutomaticIsFloat64WhereFloat32DoesNotSuffice) {
  const TemporaryFolder folder;
  Scene scene = tiny_scene();
  EXPECT_FALSE(SceneFile(written_scene(folder, scene)).is_float64());
  scene.spheres[0].center.x += 1e-12; // digits that float32 doesn't hold
  EXPECT_FALSE(SceneFile(written_scene(folder, scene)).is_float64());
  scene.spheres[0].radius = 1e-6;
  EXPECT_TRUE(SceneFile(written_scene(folder, scene)).is_float64());
}

TEST(SceneStore, CoordinatesOutOfRangeAreRefused) {
  const TemporaryFolder folder;
  using Change = std::function<void(Scene&, double far)>;
  const std::vector<std::pair<const char*, Change>> changes{
      {"vertex", [](Scene& s, double far) { s.triangles[0].a.x = -far; }},
      {"sphere's centre", [](Scene& s, double far) { s.spheres[0].center.y = far; }},
      {"sphere's radius", [](Scene& s, double far) { s.spheres[0].radius = -far; }},
      {"sphere's centre and radius",
       [](Scene& s, double far) {
         s.spheres[0] = {{far, far, far}, far};
       }},
      {"cone's end", [](Scene& s, double far) { s.cones[0].apex.z = far; }},
      {"cone's radius", [](Scene& s, double far) { s.cones[0].base_radius = far; }},
      {"cone's ends and radii",
       [](Scene& s, double far) {
         s.cones[0] = {{far, 0, 0}, far, {0, far, 0}, far};
       }},
  };
  for (const auto& [what, change] : changes) {
    // Beyond the store's limit, and beyond the type's range.
    for (const auto& [store, far] :
         {std::pair{Store::float32, 1e13}, {Store::float32, 1e40}, {Store::float64, 1e101}}) {
      Scene scene = tiny_scene();
      change(scene, far);
      const auto write = [&](const std::string& path) { write_scene(scene, store, path); };
      EXPECT_TRUE(is_refused(write, folder.file("far.scene"))) << what << " at " << far;
    }
  }
  EXPECT_TRUE(folder.listing().empty());
}

// Lights may be beyond the store's limit, but must be finite.
TEST(SceneStore, LightsThatAreNotFiniteAreRefused) {
  const TemporaryFolder folder;
  Scene scene = tiny_scene();
  scene.lights[1].position.y = -1e39;
  const auto write = [&](const std::string& path) { write_scene(scene, Store::float32, path); };
  EXPECT_TRUE(is_refused(write, folder.file("far.scene")));
  EXPECT_TRUE(folder.listing().empty());
}

TEST(SceneFile, EmptySceneIsReadBack) {
  const TemporaryFolder folder;
  Scene scene{};
  scene.camera = tiny_scene().camera;
  const SceneFile file(written_scene(folder, scene));
  EXPECT_EQ(file.primitive_count(), 0U);
  EXPECT_TRUE(is_empty(file.bounds()));
  const SceneFile of_doubles(written_scene(folder, scene, Store::float64));
  EXPECT_EQ(of_doubles.primitive_count(), 0U);
  EXPECT_EQ(of_doubles.lighting<double>().light_count, 0U);
}

TEST(StructureFile, OfAnotherGeometryIsRefused) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.grid");
  const Hash hash{11, 22};
  write_structure(tiny_grid(), tiny_grid_provenance(hash), path);
  const StructureFile grid(path);
  EXPECT_NO_THROW(grid.check_geometry(hash, tiny_scene_primitives));
  const auto check = [&](const Hash& geometry_hash, std::uint64_t primitives) {
    return is_refused([&](const std::string&) { grid.check_geometry(geometry_hash, primitives); }, path,
                      "built from another geometry: build it again with gridbuild");
  };
  EXPECT_TRUE(check({12, 22}, tiny_scene_primitives));
  EXPECT_TRUE(check({11, 23}, tiny_scene_primitives));
  EXPECT_TRUE(check({22, 11}, tiny_scene_primitives));
  EXPECT_TRUE(check(hash, tiny_scene_primitives + 1));
  EXPECT_TRUE(check(hash, 0));
}

TEST(StructureFile, RecordsItsProvenance) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.grid");
  write_structure(tiny_grid(),
                  {{3, 4},
                   4,
                   {5, -6, 7e6},
                   SpaceRule::cube,
                   Overlap::box,
                   "cleary:2.5",
                   "balance target 8",
                   HierarchyQuality::fast,
                   1.25},
                  path);
  const StructureFile grid(path);
  EXPECT_EQ(grid.origin(), (Vec3d{5, -6, 7e6}));
  EXPECT_EQ(grid.table().space_rule(), fb::Space::cube);
  EXPECT_EQ(grid.table().overlap(), fb::Overlap::box);
  EXPECT_EQ(grid.table().division_rule()->str(), "cleary:2.5");
  EXPECT_EQ(grid.table().merge_rule()->str(), "balance target 8");
  EXPECT_EQ(grid.quality(), HierarchyQuality::fast);
  EXPECT_EQ(grid.table().build_seconds(), 1.25);
}

} // namespace
} // namespace masu
