// Files damaged at random, with correct hashes: any that still opens can be built on and traced. With
// sanitizers this shows that no index leads out of the file.
#include "libgrid/statistics/statistics.h"
#include "libscene/base/error.h"
#include "tests/hostile_files.h"
#include "tests/random_test.h"
#include "tests/tiny_scene.h"
#include "tests/tracing_probe.h"

#include <array>
#include <memory>
#include <random>

namespace masu {
namespace {

using DamagedFile = RandomTest;

// Overwrites up to four values, often with limits of some type.
void damage(Bytes& bytes, std::mt19937_64& random) {
  constexpr std::array<std::uint64_t, 16> values{0,
                                                 1,
                                                 0xff,
                                                 0xffff,
                                                 0x7fffffff,
                                                 0x80000000,
                                                 0x80000001,
                                                 0xffffffff,
                                                 0x7f800000,
                                                 0x7fc00000,
                                                 0xff7fffff,
                                                 0x7ff0000000000000,
                                                 0x7ff8000000000000,
                                                 0x7fefffffffffffff,
                                                 0x8000000000000000,
                                                 0xffffffffffffffff};
  if (bytes.empty()) return;
  for (std::uint64_t count = 1 + random() % 4; count > 0; --count) {
    const std::size_t size = std::size_t{1} << (random() % 4);
    if (bytes.size() < size) continue;
    const std::size_t offset = random() % (bytes.size() / size) * size;
    const std::uint64_t value = random() % 3 == 0 ? random() : values[random() % values.size()];
    std::memcpy(bytes.data() + offset, &value, size);
  }
}

// Damages the table, or one of the sections.
template <class Parts>
Parts damaged(Parts parts, std::mt19937_64& random) {
  const std::size_t where = random() % (2 * parts.sections.size());
  if (where < parts.sections.size())
    damage(parts.sections[where].bytes, random);
  else
    parts.damage_table = [&random](Bytes& table) { damage(table, random); };
  return parts;
}

// Opens the file as T; null when it is refused with the right error.
template <class T>
std::unique_ptr<T> opened(const std::string& path) {
  try {
    return std::make_unique<T>(path);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::input) << error.what();
    EXPECT_EQ(error.place(), path);
    return nullptr;
  }
}

void build_and_trace(const SceneFile& scene, Overlap overlap, const std::string& path) {
  for (const StructureKind kind : {StructureKind::uniform, StructureKind::x, StructureKind::balance,
                                   StructureKind::irregular, StructureKind::hierarchy}) {
    try {
      build_a_little(scene, overlap, kind, path);
    } catch (const Error&) { // the space can't be divided
      return;
    }
    const std::unique_ptr<StructureFile> grid = opened<StructureFile>(path);
    if (grid == nullptr) { // the space is too large for its store
      ASSERT_EQ(kind, StructureKind::uniform);
      return;
    }
    trace_a_little(scene, grid.get());
  }
}

TEST_F(DamagedFile, ASceneThatOpensCanBeTraced) {
  auto random = seed_.engine();
  const TemporaryFolder folder;
  const std::string path = folder.file("scene");
  const std::int64_t damages = cases(500);
  for (const Store store : {Store::float32, Store::float64}) {
    write_scene(tiny_scene(), store, path);
    const SceneParts parts(path);
    std::int64_t open = 0;
    for (std::int64_t i = 0; i < damages; ++i) {
      damaged(parts, random).write(path);
      const auto scene = opened<SceneFile>(path);
      if (scene == nullptr) continue;
      ++open;
      trace_a_little(*scene, nullptr);
      build_and_trace(*scene, random() % 2 == 0 ? Overlap::box : Overlap::exact, folder.file("grid"));
    }
    EXPECT_GT(open, damages / 20);
    EXPECT_LT(open, damages);
  }
}

void describe(const StructureFile& file) {
  if (file.is_hierarchy()) return static_cast<void>(hierarchy_statistics(file.nodes()));
  static_cast<void>(grid_statistics(file.cells().size(), file.references()));
}

TEST_F(DamagedFile, AGridThatOpensCanBeTraced) {
  auto random = seed_.engine();
  const TemporaryFolder folder;
  const std::string scene_path = folder.file("scene"), path = folder.file("grid");
  const std::int64_t damages = cases(500);
  for (const Store store : {Store::float32, Store::float64}) {
    write_scene(tiny_scene(), store, scene_path);
    const SceneFile scene(scene_path);
    for (const Structure& made : {tiny_grid(), tiny_grid_of_blocks(), tiny_merged_grid(), tiny_hierarchy()}) {
      write_structure(made, tiny_grid_provenance(scene.geometry_hash()), path);
      const GridParts parts(path);
      std::int64_t open = 0;
      for (std::int64_t i = 0; i < damages; ++i) {
        damaged(parts, random).write(path);
        const auto grid = opened<StructureFile>(path);
        if (grid == nullptr) continue;
        ++open;
        describe(*grid);
        try {
          grid->check_geometry(scene.geometry_hash(), scene.primitive_count());
        } catch (const Error& error) {
          EXPECT_EQ(error.code(), ErrorCode::input);
          continue;
        }
        trace_a_little(scene, grid.get());
      }
      EXPECT_GT(open, damages / 50);
      EXPECT_LT(open, damages);
    }
  }
}

} // namespace
} // namespace masu
