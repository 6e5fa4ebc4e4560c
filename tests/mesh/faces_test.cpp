// Faces of meshes: those of which two corners coincide keep their numbers and are never hit, through any grid
// and by any arithmetic; those whose corners are on a line close a mesh; and hits are named by the faces that
// triangles are of.
#include "libgrid/hierarchy/hierarchy_builder.h"
#include "libscene/mesh/indexed_mesh.h"
#include "tests/random_grid.h"
#include "tests/random_scene.h"
#include "tests/random_test.h"
#include "tests/rendering.h"
#include "tests/same_grid.h"
#include "tests/scene_builder.h"
#include "tests/tiny_scene.h"

namespace masu {
namespace {

using FaceNumbers = RandomTest;
using FacesWithoutArea = RandomTest;
using Fillers = RandomTest;

constexpr std::array all_kinds{StructureKind::uniform, StructureKind::x, StructureKind::balance,
                               StructureKind::irregular, StructureKind::hierarchy};

// --- Points ---------------------------------------------------------------------------------------------

template <class Stored>
Structure grid_of(const SceneView<Stored>& scene, StructureKind kind, const GridLayout& layout,
                  Overlap overlap) {
  return kind == StructureKind::hierarchy ? build_hierarchy(scene, layout)
                                          : build_structure(scene, layout, overlap, StructureOptions{kind});
}

// Triangles of a scene with points among them; `numbers` are the others' numbers then.
template <class Stored>
TestScene<Stored> with_points(Chance& chance, const TestScene<Stored>& scene,
                              std::vector<PrimitiveIndex>& numbers) {
  TestScene<Stored> result;
  const Boxd bounds = scene.bounds();
  const auto add_points = [&](int most) {
    for (int i = chance.whole(0, most); i > 0; --i) {
      const Vec3<Stored> at = scene.triangles[chance.index(scene.triangles.size())].a;
      result.triangles.push_back(triangle_of<Stored>(at, at, at));
    }
  };
  for (const Triangle<Stored>& triangle : scene.triangles) {
    add_points(chance.one_in(20) ? 100 : 1);
    numbers.push_back(static_cast<PrimitiveIndex>(result.triangles.size()));
    result.triangles.push_back(triangle);
  }
  add_points(3);
  EXPECT_TRUE(result.bounds().min == bounds.min && result.bounds().max == bounds.max);
  return result;
}

template <class Stored>
class Points : public RandomTest {};
TYPED_TEST_SUITE(Points, Reals);

TYPED_TEST(Points, AreInNoGridWhichIsAsWithoutThem) {
  using Stored = TypeParam;
  Chance& chance = this->chance_;
  for (std::int64_t s = cases(60); s > 0; --s) {
    TestScene<Stored> scene;
    for (int i = chance.whole(1, 200); i > 0; --i)
      add_triangles(scene, chance, 1, chance.power_of_two(-8, 0));
    std::vector<PrimitiveIndex> numbers;
    TestScene<Stored> more = with_points(chance, scene, numbers);
    GridLayout layout = random_layout<Stored>(chance, scene.bounds());
    for (const StructureKind kind : all_kinds) {
      SCOPED_TRACE(testing::Message() << "kind " << static_cast<int>(kind));
      if (kind == StructureKind::irregular) layout.division = {3, 2, 4};
      const Overlap overlap = any_overlap(chance);
      Structure without = grid_of(scene.view(), kind, layout, overlap);
      const Structure with = grid_of(more.view(), kind, layout, overlap);
      for (PrimitiveIndex& reference : without.references)
        reference = numbers.at(reference & ~last_bit) | (reference & last_bit);
      expect_same(with, without);
    }
  }
}

TEST_F(FacesWithoutArea, ManyOfThemTakeNoSpaceInGrids) {
  Scene scene = empty_scene({0, 0, 5}, {0, 0, 0});
  add_triangle(scene, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, matte({1, 1, 1}));
  for (int i = 0; i < 100000; ++i)
    scene.triangles.push_back({{0, 0, 0}, 0, {0, 0, 0}, 0, {0, 0, 0}, no_normals});
  for (const StructureKind kind : all_kinds)
    EXPECT_LE(Rendering(scene, Store::float32, "4", StructureOptions{kind}).grid().references().size(),
              4096U);
  const Rendering rendering(scene, Store::float32);
  EXPECT_EQ(division_statistics(rendering.scene().view<float>()).all.primitives, 1U);
}

// --- Faces without area ---------------------------------------------------------------------------------

struct ArrayMesh {
  std::vector<Vec3d> vertices;
  std::vector<std::uint32_t> indices;

  void add(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
    for (const Vec3d& v : {a, b, c}) {
      indices.push_back(static_cast<std::uint32_t>(vertices.size()));
      vertices.push_back(v);
    }
  }
  IndexedMesh view() const {
    return {vertices.size(), indices.size() / 3, nullptr, &vertices[0].x, indices.data()};
  }
};

// Calls check(hits of the rays) for grids of all kinds and none, and those of the precisions that a store,
// drawn at random, has.
template <class Check>
void for_each_way(Chance& chance, const ArrayMesh& mesh, const std::vector<Ray<double>>& rays,
                  std::initializer_list<Precision> precisions, const Check& check) {
  const std::array meshes{mesh.view()};
  const Store store = chance.one_in(3) ? Store::float64 : Store::float32;
  for (const StructureKind kind : all_kinds) {
    const Rendering rendering(scene_of(meshes), store, "8", StructureOptions{kind});
    ASSERT_EQ(rendering.scene().primitive_count(), mesh.indices.size() / 3);
    for (const bool with_grid : {true, false}) {
      const ResidentTracer tracer = rendering.tracer(Device::cpu, with_grid);
      for (const Precision precision : precisions) {
        if (store == Store::float64 && precision != Precision::doubled) continue;
        SCOPED_TRACE(testing::Message() << "precision " << name_of(precision) << ", kind "
                                        << static_cast<int>(kind) << ", with a grid " << with_grid);
        RaysRequest request;
        request.tracing.precision = precision;
        check(tracer.hits(rays, request, HitName::primitive).hits);
        if (testing::Test::HasFatalFailure()) return;
      }
    }
  }
}

// A triangle whose corners are one, or two.
std::array<Vec3d, 3> needle(Chance& chance) {
  const Vec3d a = chance.in_cube(1), c = chance.in_cube(1);
  std::array<Vec3d, 3> corners = chance.one_in(4) ? std::array{a, a, a} : std::array{a, c, c};
  std::shuffle(corners.begin(), corners.end(), chance.engine());
  return corners;
}

TEST_F(FacesWithoutArea, AreNeverHit) {
  std::size_t hits = 0;
  for (std::int64_t s = cases(6); s > 0; --s) {
    ArrayMesh mesh;
    std::vector<bool> is_surface;
    std::vector<Ray<double>> rays;
    for (int i = 0; i < 300; ++i) {
      is_surface.push_back(chance_.one_in(10));
      if (is_surface.back()) {
        const Vec3d at = chance_.in_cube(1);
        mesh.add(at, at + chance_.in_cube(0.3), at + chance_.in_cube(0.3));
        continue;
      }
      const auto [a, b, c] = needle(chance_);
      mesh.add(a, b, c);
      for (int k = 0; k < 40; ++k) {
        const Vec3d at = fma(c - a, chance_.uniform(0, 1), a), from = chance_.in_cube(2);
        rays.push_back({from, 0, at - from, INFINITY});
      }
    }
    for_each_way(chance_, mesh, rays, {Precision::fast, Precision::robust, Precision::doubled},
                 [&](const auto& found) {
                   for (const HitRecord& hit : found) {
                     hits += hit.name >= 0;
                     ASSERT_TRUE(hit.name < 0 || is_surface[static_cast<std::size_t>(hit.name)]) << hit.name;
                   }
                 });
  }
  EXPECT_GT(hits, static_cast<std::uint64_t>(cases(1000)));
}

// However far away they are.
TEST_F(FacesWithoutArea, ChangeNeitherBoundsNorTheStore) {
  ArrayMesh mesh;
  mesh.add({1, 0, 0}, {2, 0, 0}, {1, 1, 0});
  const std::array plain{mesh.view()};
  const ArrayScene expected = scene_of(plain);
  mesh.add({1e9, 1e9, 1e9}, {2e9, 2e9, 2e9}, {1e9, 1e9, 1e9});
  mesh.add({5, 5, 5}, {5, 5, 5}, {5, 5, 5 + 1e-30});
  const std::array meshes{mesh.view()};
  const ArrayScene scene = scene_of(meshes);
  ASSERT_EQ(scene.triangles.size(), 3U);
  EXPECT_TRUE(bounds(scene).min == bounds(expected).min && bounds(scene).max == bounds(expected).max);
  EXPECT_TRUE(float32_precision(scene).suffices());
  EXPECT_TRUE(scene.camera.from == expected.camera.from);
}

TEST_F(FacesWithoutArea, MakeASceneInWhichNothingIsHitWhereThereAreNoOthers) {
  ArrayMesh mesh;
  mesh.add({0, 0, 0}, {1, 1, 1}, {1, 1, 1});
  mesh.add({0, 0, 0}, {0, 0, 0}, {0, 0, 0});
  const std::array meshes{mesh.view()};
  for (const StructureKind kind : all_kinds) {
    const Rendering rendering(scene_of(meshes), Store::automatic, "auto", StructureOptions{kind});
    EXPECT_FALSE(rendering.scene().is_float64());
    EXPECT_EQ(rendering.scene().primitive_count(), 2U);
    EXPECT_EQ(rendering.grid().references().size(), 0U);
    const std::vector<Ray<double>> rays{{{0, 0, 0}, 0, {1, 1, 1}, INFINITY},
                                        {{1, 1, 5}, 0, {0, 0, -1}, INFINITY}};
    for (const HitRecord& hit : rendering.tracer().hits(rays, {}, HitName::primitive).hits)
      EXPECT_EQ(hit.name, -1);
  }
}

// --- Fillers --------------------------------------------------------------------------------------------

// A box whose sides are triangles, with edges split on one side alone and faces without area that fill the
// gaps, as tessellators write them.
ArrayMesh box_with_fillers(Chance& chance) {
  const Vec3d size{chance.uniform(0.2, 1), chance.uniform(0.2, 1), chance.uniform(0.2, 1)},
      turn = chance.in_cube(0.1), along = chance.in_cube(0.1);
  const auto corner = [&](int i) {
    const Vec3d p = Vec3d{i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0} * size;
    return p + cross(turn, p) + along * p.x;
  };
  std::vector<std::array<Vec3d, 3>> faces;
  constexpr int sides[6][4]{{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                            {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (const auto& [a, b, c, d] : sides) {
    faces.push_back({corner(a), corner(b), corner(c)});
    faces.push_back({corner(a), corner(c), corner(d)});
  }
  for (int splits = chance.whole(1, 12); splits > 0; --splits) {
    auto& face = faces[chance.index(faces.size())];
    const auto [a, b, c] = face;
    const Vec3d middle = fma(b - a, chance.one_of({0.5, chance.uniform(0.01, 0.99)}), a);
    if (!has_area(a, b, c) || middle == a || middle == b) continue;
    face = {a, middle, c};
    faces.push_back({middle, b, c});
    faces.push_back({a, b, middle});
  }
  ArrayMesh mesh;
  for (const auto& [a, b, c] : faces)
    mesh.add(a, b, c);
  return mesh;
}

TEST_F(Fillers, LetNoRayOut) {
  for (std::int64_t s = cases(20); s > 0; --s) {
    const ArrayMesh mesh = box_with_fillers(chance_);
    const std::size_t faces = mesh.indices.size() / 3;
    std::vector<Ray<double>> rays;
    for (int i = 0; i < 5000; ++i) { // from inside at points of edges
      const std::size_t face = 3 * chance_.index(faces),
                        corner = static_cast<std::size_t>(chance_.whole(0, 2));
      const Vec3d p = mesh.vertices[face + corner], q = mesh.vertices[face + (corner + 1) % 3],
                  from = chance_.in_cube(0.1);
      rays.push_back({from, 0, fma(q - p, chance_.uniform(0, 1), p) - from, INFINITY});
    }
    for_each_way(chance_, mesh, rays, {Precision::robust, Precision::doubled}, [](const auto& found) {
      ASSERT_EQ(std::ranges::count_if(found, [](const HitRecord& hit) { return hit.name < 0; }), 0);
    });
  }
}

// --- Numbers of faces -----------------------------------------------------------------------------------

// A scene of every kind of primitive, whose triangles are of faces.
Scene scene_with_faces(Chance& chance) {
  Scene scene = empty_scene({0, 0, 4}, {0, 0, 0});
  scene.camera.width = scene.camera.height = 40;
  for (int i = 0; i < 30; ++i) {
    const Vec3d at = chance.in_cube(1);
    add_triangle(scene, at, at + chance.in_cube(1), at + chance.in_cube(1), matte({1, 1, 1}));
    scene.faces.push_back(static_cast<std::uint32_t>(chance.one_in(10) ? 0x7ffffffe : chance.whole(0, 100)));
  }
  add_sphere(scene, chance.in_cube(1), 0.2, matte({1, 1, 1}));
  add_cone(scene, {chance.in_cube(1), 0.2, chance.in_cube(1), 0.1}, matte({1, 1, 1}));
  return scene;
}

TEST_F(FaceNumbers, AreReadBackAsWritten) {
  const TemporaryFolder folder;
  const Scene scene = scene_with_faces(chance_), plain = tiny_scene();
  for (const Store store : {Store::float32, Store::float64}) {
    write_scene(scene, store, folder.file("scene"));
    const SceneFile file(folder.file("scene"));
    const auto expect_faces = [&](const auto& view) {
      ASSERT_NE(view.faces, nullptr);
      EXPECT_TRUE(std::equal(scene.faces.begin(), scene.faces.end(), view.faces));
    };
    store == Store::float64 ? expect_faces(file.view<double>()) : expect_faces(file.view<float>());
  }
  write_scene(plain, Store::float32, folder.file("scene"));
  EXPECT_EQ(SceneFile(folder.file("scene")).view<float>().faces, nullptr);
}

TEST_F(FaceNumbers, NameHits) {
  std::size_t hits = 0;
  for (std::int64_t s = cases(5); s > 0; --s) {
    for (const bool has_faces : {true, false}) {
      Scene scene = scene_with_faces(chance_);
      if (!has_faces) scene.faces.clear();
      const Rendering rendering(scene, Store::float32);
      const ResidentTracer tracer = rendering.tracer();
      std::vector<Ray<double>> rays;
      for (int i = 0; i < 1003; ++i)
        rays.push_back({chance_.in_cube(2), 0, chance_.direction(), INFINITY});
      const auto check = [&](const auto& by_primitive, const auto& by_face) {
        for (std::size_t i = 0; i < by_primitive.size(); ++i) {
          const std::int32_t primitive = by_primitive[i].name;
          const bool of_face =
              has_faces && primitive >= 0 && static_cast<std::size_t>(primitive) < scene.triangles.size();
          hits += of_face;
          EXPECT_EQ(by_face[i].name,
                    of_face ? static_cast<std::int32_t>(scene.faces[static_cast<std::size_t>(primitive)])
                            : primitive);
        }
      };
      check(tracer.hits(rays, {}, HitName::primitive).hits, tracer.hits(rays, {}, HitName::face).hits);
      FrameRequest request = rendering.request();
      request.rules.hit_name = HitName::primitive;
      const Frame by_primitive = tracer.render(request);
      request.rules.hit_name = HitName::face;
      check(by_primitive.hits, tracer.render(request).hits);
    }
  }
  EXPECT_GT(hits, static_cast<std::uint64_t>(cases(200)));
}

} // namespace
} // namespace masu
