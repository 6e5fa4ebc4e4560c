// Scenes of meshes are those of their triangles, made when somebody first reads them.
#include "libscene/base/on_threads.h"
#include "libscene/file/scene_file.h"
#include "tests/random_meshes.h"
#include "tests/random_test.h"
#include "tests/refused.h"
#include "tests/temporary_folder.h"

namespace masu {
namespace {

using SceneOfMeshes = RandomTest;

TEST_F(SceneOfMeshes, IsTheFileOfItsTrianglesWrittenOut) {
  const TemporaryFolder folder;
  for (std::int64_t i = cases(300); i > 0; --i) {
    std::vector<MeshArrays> meshes = random_meshes(chance_, chance_.one_of({3, 30, 3000}));
    const Store store = chance_.one_of({Store::automatic, Store::float32, Store::float64});
    const SphereArray sphere{chance_.index(2), [&](std::size_t) {
                               return Sphere<double>{chance_.in_cube(3), chance_.uniform(0.5, 1)};
                             }};
    const ArrayScene scene = scene_of(views_of(meshes), {&sphere, 1});
    const SceneFile expected = scene_in_memory(written_out(meshes, scene), store),
                    file = scene_in_memory(scene, store);
    for (MeshArrays& mesh : meshes) // they aren't the caller's
      mesh = {};
    ASSERT_EQ(file.primitive_count(), expected.primitive_count());
    ASSERT_EQ(file.unmade_triangles() != nullptr, scene.triangles.size() > 0);
    const auto bytes_of = [&](const SceneFile& of) {
      of.write(folder.file("a.scene"));
      return read_bytes(folder.file("a.scene"));
    };
    if (chance_.one_in(2)) {
      EXPECT_EQ(file.geometry_hash(), expected.geometry_hash());
    }
    ASSERT_EQ(bytes_of(file), bytes_of(expected));
    EXPECT_EQ(file.unmade_triangles(), nullptr);
    EXPECT_EQ(file.hash(), expected.hash());
    SceneFile(folder.file("a.scene")); // is whole
  }
}

TEST_F(SceneOfMeshes, IsReadByThreadsAtOnce) {
  for (std::int64_t i = cases(30); i > 0; --i) {
    const std::vector<MeshArrays> meshes = random_meshes(chance_, 100'000);
    const SceneFile file = scene_in_memory(scene_of(views_of(meshes)), Store::float32);
    std::array<Hash, 8> hashes;
    on_threads(hashes.size(), [&](std::size_t t) {
      const SceneView<float>& view = file.view<float>();
      hashes[t] = hash_of({reinterpret_cast<const std::uint8_t*>(view.triangles),
                           view.triangle_count * sizeof(Triangle<float>)});
    });
    for (const Hash& hash : hashes)
      ASSERT_EQ(hash, hashes[0]);
  }
}

TEST_F(SceneOfMeshes, IsRefusedForAVertexThatIsNone) {
  for (std::int64_t i = cases(100); i > 0; --i) {
    std::vector<MeshArrays> meshes = random_meshes(chance_, 300);
    MeshArrays& mesh = meshes[chance_.index(meshes.size())];
    if (mesh.triangles == 0) continue;
    const std::size_t corner = chance_.index(3 * mesh.triangles);
    if (!mesh.indices.empty() && chance_.one_in(2)) {
      mesh.indices[corner] = static_cast<std::uint32_t>(mesh.vertices() + chance_.index(3));
    } else {
      const std::size_t number =
          3 * (mesh.indices.empty() ? corner : mesh.indices[corner]) + chance_.index(3);
      if (mesh.doubles.empty())
        mesh.floats[number] = chance_.one_of({NAN, INFINITY, -INFINITY});
      else
        mesh.doubles[number] = chance_.one_of<double>({NAN, INFINITY, -2e100});
    }
    EXPECT_TRUE(is_refused_with(
        ErrorCode::usage, "meshes", [&] { scene_of(views_of(meshes)); }, "triangle"));
  }
}

} // namespace
} // namespace masu
