// The C interface, and that of C++ over it: right answers on the CPU, and an error for whatever is wrong,
// never a fault.
#include "libscene/geometry/vector.h"
#include "tests/api/found.h"
#include "tests/api/random_arrays.h"
#include "tests/temporary_folder.h"

#include <array>
#include <cmath>
#include <cstring>
#include <optional>
#include <thread>

namespace {

using namespace masu;

class Library : public RandomArrays {
protected:
  std::string file(const char* name) const { return folder_.file(name); }

  // Of a mesh and the default grid.
  void prepare(const ArrayMesh& mesh) {
    const masu_mesh view = mesh.view();
    prepare({&view, 1});
  }
  void prepare(std::span<const masu_mesh> meshes) {
    scene_.emplace(meshes);
    grid_.emplace(*scene_);
  }
  const masu_scene* scene() const { return scene_->get(); }
  const masu_grid* grid() const { return grid_->get(); }
  // On the CPU.
  Tracer opened() const { return {*scene_, *grid_}; }

  std::optional<Scene> scene_;
  std::optional<Grid> grid_;
  const TemporaryFolder folder_;
};

TEST_F(Library, ARefittedHierarchyGivesTheHitsOfTheMovedScene) {
  for (const masu_quality quality : {MASU_QUALITY_HIGH, MASU_QUALITY_FAST}) {
    ArrayMesh mesh = random_mesh(500);
    const auto corners = mesh.vertices.begin() + 9 * 7; // of a triangle that is a point
    std::copy_n(corners, 3, corners + 3);
    std::copy_n(corners, 3, corners + 6);
    Grid grid = hierarchy_of(mesh.scene(), quality);
    for (const float most : {0.01F, 0.3F, 5.0F, 0.0F}) {
      for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
        mesh.vertices[i] += i / 9 == 7 ? most : most * coordinate();
      if (most == 0) corners[3] += 0.5F, corners[7] += 0.5F; // it has got an area
      const Scene moved = mesh.scene();
      grid = grid.refitted(moved);
      EXPECT_EQ(grid.describe().structure, MASU_STRUCTURE_BVH);
      const std::vector<masu_ray> rays = random_rays(2000);
      EXPECT_TRUE(found_by(Tracer(moved, grid), rays) == found_by(brute_force(moved), rays));
    }
    const ArrayMesh other = random_mesh(499);
    EXPECT_THROW(static_cast<void>(grid.refitted(other.scene())), Exception);
  }
}

// A scene's triangles share vertices; some have none, or get one.
TEST_F(Library, AnUpdatedTracerGivesTheHitsOfANewScene) {
  for (int round = 0; round < 8; ++round) {
    const bool is_float64 = engine_() % 2 == 0;
    std::vector<ArrayMesh> meshes(1 + engine_() % 3);
    std::vector<masu_mesh> views;
    std::vector<double> vertices; // of all
    const double far = engine_() % 3 == 0 ? 1e5 : 0;
    for (ArrayMesh& mesh : meshes) {
      mesh = random_mesh(200);
      for (std::uint32_t& index : mesh.indices)
        if (engine_() % 3 == 0) index = static_cast<std::uint32_t>(engine_() % 600);
      for (float& v : mesh.vertices)
        vertices.push_back(static_cast<double>(v) + far);
    }
    const double* next = vertices.data();
    for (const ArrayMesh& mesh : meshes) {
      views.push_back(mesh.view());
      views.back().vertices = nullptr;
      views.back().vertices64 = next;
      next += mesh.vertices.size();
    }
    const std::array<float, 8> sphere_and_cone{0, 0, 0, 0.5F, 1, 1, 0, 0.2F};
    const masu_quadrics sphere = quadrics_of(sphere_and_cone), cone = sphere;
    auto geometry = geometry_of(views);
    geometry.store = is_float64 ? MASU_STORE_FLOAT64 : MASU_STORE_FLOAT32;
    if (far == 0 && engine_() % 2 == 0) {
      geometry.spheres = &sphere;
      geometry.cones = &cone;
      geometry.sphere_count = geometry.cone_count = 1;
    }
    const Scene scene(geometry);
    Tracer tracer(scene, hierarchy_of(scene, engine_() % 2 == 0 ? MASU_QUALITY_FAST : MASU_QUALITY_HIGH));
    const auto description = scene.describe();
    geometry.origin = description.origin;
    std::vector<masu_ray> rays = random_rays(1000);
    auto query = sized<masu_query>();
    query.relative = 1;
    const QueryOptions relative{.relative = true};
    for (const double most : {0.01, 0.5, 20.0, 0.0}) {
      for (double& v : vertices)
        v = most == 0 ? far : v + most * static_cast<double>(coordinate()); // all points at last
      if (engine_() % 2 == 0) std::copy_n(vertices.begin(), 3, vertices.begin() + 3);
      tracer.update(vertices);
      const Tracer expected = brute_force(Scene(geometry));
      EXPECT_TRUE(found_by(tracer, rays, query) == found_by(expected, rays, query)) << most;
      EXPECT_TRUE(tracer.all_hits(rays, 3, relative) == expected.all_hits(rays, 3, relative)) << most;
      EXPECT_EQ(tracer.count_hits(rays, relative), expected.count_hits(rays, relative)) << most;
      EXPECT_EQ(tracer.inside(rays, relative), expected.inside(rays, relative)) << most;
    }
  }
}

// As where a scene is made.
TEST_F(Library, VerticesOfNoTriangleAreNotRead) {
  ArrayMesh mesh = random_mesh(50);
  mesh.vertices.insert(mesh.vertices.end(), {not_a_number, infinity, 1e30F});
  const Scene scene = mesh.scene();
  Tracer tracer(scene, hierarchy_of(scene));
  const std::vector<masu_ray> rays = random_rays(500);
  const Found before = found_by(tracer, rays);
  tracer.update(mesh.vertices);
  EXPECT_TRUE(found_by(tracer, rays) == before);
}

TEST_F(Library, AnUpdateThatIsRefusedChangesNothing) {
  const ArrayMesh mesh = random_mesh(100);
  const std::array<masu_mesh, 1> meshes{mesh.view()};
  auto geometry = geometry_of(meshes);
  geometry.store = engine_() % 2 == 0 ? MASU_STORE_FLOAT32 : MASU_STORE_FLOAT64;
  const Scene scene(geometry);
  Tracer tracer(scene, hierarchy_of(scene));
  const std::vector<masu_ray> rays = random_rays(1000);
  Found before = found_by(tracer, rays);
  const auto expect_refused = [&](const std::vector<float>& vertices, const char* place) {
    EXPECT_EQ(refused([&] { tracer.update(vertices); }).rfind(place, 0), 0U) << place;
    EXPECT_TRUE(found_by(tracer, rays) == before);
  };
  for (const float wrong : {not_a_number, infinity}) {
    std::vector<float> vertices = mesh.vertices;
    vertices[engine_() % vertices.size()] = wrong;
    expect_refused(vertices, "vertices: triangle");
  }
  std::vector<float> large = mesh.vertices;
  for (float& v : large)
    v *= 1e16F; // float64 holds it, the hierarchy's boxes don't
  expect_refused(large, "vertices: reach");
  expect_refused({mesh.vertices.begin(), mesh.vertices.end() - 3}, "vertices: are 299");
  auto moved = moved_to(mesh.vertices);
  EXPECT_EQ(masu_tracer_update(nullptr, &moved), MASU_ERROR_USAGE);
  EXPECT_EQ(masu_tracer_update(tracer.get(), nullptr), MASU_ERROR_USAGE);
  moved.values = nullptr;
  EXPECT_EQ(masu_tracer_update(tracer.get(), &moved), MASU_ERROR_USAGE);
  tracer = Tracer(scene, built(scene, MASU_STRUCTURE_GRID)); // isn't refitted
  expect_refused(mesh.vertices, "grid: isn't a hierarchy");
  tracer = brute_force(scene);
  expect_refused(mesh.vertices, "grid: isn't a hierarchy");
  const std::array<float, 4> values{0, 0, 0, 0.5F};
  const masu_quadrics sphere = quadrics_of(values);
  geometry = geometry_of({});
  geometry.spheres = &sphere;
  geometry.sphere_count = 1;
  const Scene spheres(geometry);
  tracer = Tracer(spheres, hierarchy_of(spheres));
  before = found_by(tracer, rays);
  expect_refused({}, "scene: has no triangles");
}

// Each query is of one of the positions, whole.
TEST_F(Library, ATracerIsUpdatedWhileOthersQueryIt) {
  const ArrayMesh mesh = random_mesh(300);
  std::vector<float> shifted = mesh.vertices;
  for (float& v : shifted)
    v += 0.3F;
  const Scene scene = mesh.scene();
  Tracer tracer(scene, hierarchy_of(scene));
  const std::vector<masu_ray> rays = random_rays(500);
  const Found first = found_by(tracer, rays);
  tracer.update(shifted);
  const Found second = found_by(tracer, rays);
  std::vector<std::jthread> threads;
  for (int k = 0; k < 4; ++k) {
    threads.emplace_back([&, k] {
      for (int i = 0; i < 30; ++i) {
        if (k == 0) tracer.update(i % 2 == 0 ? mesh.vertices : shifted);
        Found found(rays.size());
        const masu_hits hits = found.hits();
        EXPECT_EQ(masu_nearest(tracer.get(), rays.data(), rays.size(), nullptr, &hits), MASU_OK);
        found.occluded = found.t == first.t ? first.occluded : second.occluded;
        EXPECT_TRUE(found == first || found == second);
      }
    });
  }
}

Vec3d vector_of(const float* numbers) {
  return cast<double>(Vec3f{numbers[0], numbers[1], numbers[2]});
}

// Möller & Trumbore in double: t of a triangle, or infinity.
double expected_t(const float* corners, const masu_ray& ray) {
  const Vec3d a = vector_of(corners), e = vector_of(corners + 3) - a, f = vector_of(corners + 6) - a,
              s = vector_of(ray.origin) - a, d = vector_of(ray.direction), p = cross(d, f), q = cross(s, e);
  const double determinant = dot(e, p), u = dot(s, p) / determinant, v = dot(d, q) / determinant,
               t = dot(f, q) / determinant;
  const bool is_hit = u >= 0 && v >= 0 && u + v <= 1 && t > static_cast<double>(ray.tmin) &&
                      t < static_cast<double>(ray.tmax);
  return is_hit ? t : std::numeric_limits<double>::infinity();
}

TEST_F(Library, FindsWhatBruteForceFinds) {
  const ArrayMesh mesh = random_mesh(200);
  prepare(mesh);
  const Tracer tracer = opened();
  const std::vector<masu_ray> rays = random_rays(5000);
  const Found found = found_by(tracer, rays);
  int hits = 0, unsure = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    SCOPED_TRACE(i);
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t first = 0; first < mesh.vertices.size(); first += 9)
      nearest = std::min(nearest, expected_t(&mesh.vertices[first], rays[i]));
    const bool hit = std::isfinite(nearest);
    const auto t = static_cast<double>(found.t[i]);
    hits += hit ? 1 : 0;
    EXPECT_EQ(found.occluded[i] != 0, found.primitive[i] != MASU_NONE);
    if (hit != (found.primitive[i] != MASU_NONE) || // by an edge, tmin or tmax
        (hit && std::abs(t - nearest) > 1e-4 * nearest + 1e-4)) {
      ++unsure;
      continue;
    }
    if (!hit) {
      EXPECT_EQ(found.t[i], infinity);
      EXPECT_EQ(found.object[i], MASU_NONE);
      continue;
    }
    EXPECT_EQ(found.object[i], 0U);
    // The barycentric coordinates lead to the point of the ray, the normal is across the edges.
    const float* const corners = &mesh.vertices[9 * std::size_t{found.primitive[i]}];
    const Vec3d a = vector_of(corners), e = vector_of(corners + 3) - a, f = vector_of(corners + 6) - a,
                n = vector_of(&found.normal[3 * i]);
    const double u = static_cast<double>(found.uv[2 * i]), v = static_cast<double>(found.uv[2 * i + 1]);
    EXPECT_LE(
        largest_magnitude(a + e * u + f * v - (vector_of(rays[i].origin) + vector_of(rays[i].direction) * t)),
        1e-4);
    EXPECT_NEAR(dot(n, e), 0, 1e-5);
    EXPECT_NEAR(dot(n, f), 0, 1e-5);
    EXPECT_NEAR(dot(n, n), 1, 1e-5);
  }
  EXPECT_GT(hits, 100);
  EXPECT_LT(unsure, 10);
}

TEST_F(Library, ResultsAreTheSameByBruteForceAndByEveryFormat) {
  prepare(random_mesh(300));
  const Tracer tracer = opened();
  std::vector<masu_ray> rays = random_rays(2000);
  EXPECT_TRUE(found_by(tracer, rays) == found_by(brute_force(*scene_), rays));
  for (masu_ray& ray : rays)
    ray.tmin = 0, ray.tmax = infinity;
  const Found all = found_by(tracer, rays);
  in_every_format(rays, [&](const auto& list, masu_ray_format format) {
    auto query = sized<masu_query>();
    query.format = format;
    EXPECT_TRUE(found_by(tracer.get(), list.data(), list.size(), query) == all) << format;
  });
  // Whatever is left out, the rest is the same.
  Found some(rays.size());
  masu_hits only = sized<masu_hits>();
  only.object = some.object.data();
  only.normal = some.normal.data();
  only.face = some.face.data();
  tracer.nearest(rays.data(), rays.size(), only);
  EXPECT_EQ(some.object, all.object);
  EXPECT_EQ(some.normal, all.normal);
}

// Whichever way the handles are freed.
TEST_F(Library, ATracerKeepsWhatItUses) {
  const ArrayMesh mesh = random_mesh(300);
  prepare(mesh);
  const std::vector<masu_ray> rays = random_rays(500);
  const Found expected = found_by(opened(), rays);
  std::optional<Scene> scene(std::in_place, mesh.vertices, mesh.indices);
  std::optional<Grid> grid(*scene);
  const Tracer tracer(*scene, *grid);
  scene.reset();
  EXPECT_TRUE(found_by(tracer, rays) == expected);
  grid.reset();
  EXPECT_TRUE(found_by(tracer, rays) == expected);
}

TEST_F(Library, FilesHaveTheBytesOfWhatIsInMemory) {
  prepare(random_mesh(300));
  scene_->write(file("scene"));
  grid_->write(file("grid"));
  const Scene scene_again = Scene::read(file("scene"));
  const Grid grid_again = Grid::read(file("grid"));
  EXPECT_EQ(scene_again.describe().bytes, read_bytes(file("scene")).size());
  EXPECT_EQ(grid_again.describe().bytes, read_bytes(file("grid")).size());
  scene_again.write(file("scene2"));
  grid_again.write(file("grid2"));
  Grid(scene_again).write(file("grid3"));
  EXPECT_EQ(read_bytes(file("scene")), read_bytes(file("scene2")));
  EXPECT_EQ(read_bytes(file("grid")), read_bytes(file("grid2")));
  EXPECT_EQ(read_bytes(file("grid")), read_bytes(file("grid3")));
  const std::vector<masu_ray> rays = random_rays(500);
  EXPECT_TRUE(found_by(opened(), rays) == found_by(Tracer(scene_again, grid_again), rays));
  // The pair of what is written and what isn't fits.
  EXPECT_NO_THROW(Tracer(*scene_, grid_again));
}

// Vertices in a row, and in double, are the same scene; spheres and cones are numbered after triangles.
TEST_F(Library, ArraysOfEveryKindMakeTheSameScene) {
  const ArrayMesh mesh = random_mesh(50);
  const std::vector<double> doubles(mesh.vertices.begin(), mesh.vertices.end());
  const std::vector<float> spheres{0, 0, 5, 1, 0, 0, 8, 1}, cones{5, 0, 0, 1, 5, 0, 2, 0.5F};
  const std::vector<double> spheres64(spheres.begin(), spheres.end());
  auto row = mesh.view();
  row.indices = nullptr;
  const auto bytes_of = [&](const masu_mesh& view, bool in_double) {
    masu_quadrics sphere = quadrics_of(spheres, 2);
    if (in_double) sphere.values = nullptr, sphere.values64 = spheres64.data();
    const masu_quadrics cone = quadrics_of(cones);
    masu_geometry geometry = geometry_of({&view, 1});
    geometry.spheres = &sphere;
    geometry.cones = &cone;
    geometry.sphere_count = geometry.cone_count = 1;
    Scene(geometry).write(file("scene"));
    return read_bytes(file("scene"));
  };
  const Bytes expected = bytes_of(mesh.view(), false);
  EXPECT_EQ(bytes_of(row, true), expected);
  EXPECT_EQ(bytes_of(masu::mesh(doubles, mesh.indices), false), expected);
  const Scene scene = Scene::read(file("scene"));
  EXPECT_EQ(scene.describe().objects, 3U);
  EXPECT_EQ(scene.primitive(51).kind, MASU_SPHERE);
  EXPECT_EQ(scene.primitive(51).object, 1U);
  EXPECT_EQ(scene.primitive(52).kind, MASU_CONE);
  EXPECT_EQ(scene.primitive(52).object, 2U);
  const std::vector<masu_ray> rays{{{0, 0, 20}, 0, {0, 0, -1}, infinity},
                                   {{9, 0, 1}, 0, {-1, 0, 0}, infinity}};
  const Found found = found_by(Tracer(scene), rays);
  EXPECT_EQ(found.primitive[0], 51U);
  EXPECT_EQ(found.t[0], 11);
  EXPECT_EQ(found.primitive[1], 52U);
  EXPECT_EQ(found.t[1], 3.25F);
}

// Without a grid what answers soonest is built: a fast hierarchy, or a grid where no hierarchy holds the
// scene. A build without options doesn't know what will trace, and is a hierarchy of high quality.
TEST_F(Library, WithoutAGridWhatAnswersSoonestIsBuilt) {
  prepare(random_mesh(500));
  const Grid none = Tracer(*scene_).grid(), fast = built(*scene_, MASU_STRUCTURE_BVH, MASU_QUALITY_FAST);
  none.write(file("none.grid"));
  fast.write(file("fast.grid"));
  EXPECT_TRUE(read_bytes(file("none.grid")) == read_bytes(file("fast.grid")));
  Grid(*scene_).write(file("usual.grid"));
  built(*scene_, MASU_STRUCTURE_BVH).write(file("high.grid"));
  EXPECT_TRUE(read_bytes(file("usual.grid")) == read_bytes(file("high.grid")));
  auto options = default_build_options();
  options.division = "4";
  EXPECT_EQ(Grid(*scene_, options).describe().structure, MASU_STRUCTURE_GRID);

  const std::array<float, 9> far{0, 0, 0, 1e18F, 0, 0, 0, 1e18F, 0};
  const Tracer tracer(Scene(far, std::array<std::uint32_t, 3>{0, 1, 2}));
  EXPECT_EQ(tracer.grid().describe().structure, MASU_STRUCTURE_GRID);
  const std::vector<masu_ray> rays{{{1e17F, 1e17F, 1e18F}, 0, {0, 0, -1}, infinity}};
  EXPECT_EQ(found_by(tracer, rays).primitive[0], 0U);

  masu_grid* grid = nullptr;
  const Tracer brute_force(*scene_, nullptr, {}, true);
  EXPECT_THROW(static_cast<void>(brute_force.grid()), Exception);
  EXPECT_EQ(masu_tracer_grid(nullptr, &grid), MASU_ERROR_USAGE);
}

// A program of an older or a newer version works as far as both know, or meets an error.
TEST_F(Library, StructuresOfOtherSizesWorkOrAreErrors) {
  prepare(random_mesh(50));
  const Tracer tracer = opened();
  const std::vector<masu_ray> rays = random_rays(100);
  struct Newer {
    masu_query known;
    std::uint64_t more;
  } query{sized<masu_query>(), 0};
  query.known.size = sizeof query;
  Found found(rays.size());
  const masu_hits hits = found.hits();
  const auto nearest = [&] {
    return masu_nearest(tracer.get(), rays.data(), rays.size(), &query.known, &hits);
  };
  EXPECT_EQ(nearest(), MASU_OK) << masu_error();
  EXPECT_EQ(found.t, found_by(tracer, rays).t);
  query.more = 1;
  EXPECT_EQ(nearest(), MASU_ERROR_USAGE);
  query.more = 0;
  for (const std::size_t wrong : {std::size_t{0}, std::size_t{8}, sizeof query + 1, std::size_t{1} << 40}) {
    query.known.size = wrong;
    EXPECT_EQ(nearest(), MASU_ERROR_USAGE) << wrong;
  }
  struct NewerDescription {
    masu_scene_description known;
    std::uint64_t more;
  } description{{}, 7};
  description.known.size = sizeof description;
  ASSERT_DONE(masu_scene_describe(scene(), &description.known));
  EXPECT_EQ(description.known.triangles, 50U);
  EXPECT_EQ(description.more, 0U);
  description.known.size = 16;
  EXPECT_EQ(masu_scene_describe(scene(), &description.known), MASU_ERROR_USAGE);
}

// Whatever it repeats.
TEST_F(Library, AnErrorIsALine) {
  prepare(random_mesh(5));
  auto options = default_build_options();
  options.division = "8\n\x1b[2J\xff";
  masu_grid* grid = nullptr;
  EXPECT_EQ(masu_grid_build(scene(), &options, &grid), MASU_ERROR_USAGE);
  EXPECT_EQ(std::string(masu_error()).rfind("division: '8\\x0a\\x1b[2J\\xff' isn't a division: ", 0), 0U)
      << masu_error();
  masu_scene* none = nullptr;
  EXPECT_EQ(masu_scene_read("/none/a\rb", &none), MASU_ERROR_INPUT);
  EXPECT_EQ(std::string(masu_error()).rfind("/none/a\\x0db: ", 0), 0U) << masu_error();
}

TEST_F(Library, ThreadsMayBeLimited) {
  prepare(random_mesh(200));
  const std::vector<masu_ray> rays = random_rays(3000);
  const Tracer tracer = opened();
  const Found expected = found_by(tracer, rays);
  auto query = sized<masu_query>();
  for (const int threads : {1, 2, 5}) {
    query.threads = threads;
    EXPECT_TRUE(found_by(tracer, rays, query) == expected);
  }
  query.threads = -1;
  EXPECT_EQ(masu_occluded(tracer.get(), rays.data(), 1, &query, Found(1).occluded.data()), MASU_ERROR_USAGE);
}

// A ray is what its type says, and nothing else is taken for one.
TEST_F(Library, InCppTypesDecideTheFormat) {
  const ArrayMesh mesh = random_mesh(300);
  const Scene of_mesh = mesh.scene();
  const Tracer tracer(of_mesh, Grid(of_mesh));
  const auto check = [&](const auto& rays, masu_ray_format format) {
    auto query = sized<masu_query>();
    query.format = format;
    const Found expected = found_by(tracer.get(), rays.data(), rays.size(), query);
    EXPECT_EQ(tracer.nearest(rays).primitive, expected.primitive);
    EXPECT_EQ(tracer.nearest(std::span(rays), {.coherent = true}).t, expected.t);
    EXPECT_EQ(tracer.occluded(rays), expected.occluded);
    Found found(rays.size());
    tracer.nearest(rays.data(), rays.size(), found.hits());
    tracer.occluded(rays.data(), rays.size(), found.occluded.data());
    EXPECT_TRUE(found == expected);
  };
  const std::vector<masu_ray> rays = random_rays(1000);
  in_every_format(rays, check, 1e-9);
  EXPECT_GT(std::ranges::count_if(tracer.occluded(rays), [](int occluded) { return occluded != 0; }), 10);

  struct Larger : masu_ray {
    int more;
  };
  static_assert(!Ray<Larger> && !Ray<float> && !RayRange<std::vector<double>>);
  EXPECT_TRUE(tracer.nearest(std::vector<masu_ray>()).t.empty());
  EXPECT_EQ(brute_force(of_mesh).nearest(rays).t, tracer.nearest(rays).t);
  EXPECT_EQ(Tracer(of_mesh).nearest(rays).t, tracer.nearest(rays).t);
  EXPECT_NE(refused([&] { Scene::read(file("missing")); }, MASU_ERROR_INPUT).find("missing"),
            std::string::npos);
}

// A box of -1 to 1 with a hollow of -0.5 to 0.5, whose fronts are in the hollow: it is a box mirrored.
ArrayMesh hollow_box() {
  ArrayMesh mesh;
  for (const float size : {1.0F, -0.5F}) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size() / 3);
    for (unsigned i = 0; i < 8; ++i)
      mesh.vertices.insert(mesh.vertices.end(), {(i & 1) != 0 ? size : -size, (i & 2) != 0 ? size : -size,
                                                 (i & 4) != 0 ? size : -size});
    for (const auto& [a, b, c, d] :
         {std::array{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}})
      for (const int corner : {a, b, c, a, c, d})
        mesh.indices.push_back(first + static_cast<std::uint32_t>(corner));
  }
  return mesh;
}

// Of rays on a lattice, which meet edges and corners exactly.
TEST_F(Library, ListsAndCountsTheHitsOfClosedMeshes) {
  const ArrayMesh mesh = hollow_box();
  const Scene of_mesh = mesh.scene();
  const Tracer tracer(of_mesh, Grid(of_mesh)), without_grid = brute_force(of_mesh);
  std::vector<std::array<double, 6>> rays;
  const auto whole = [&](int most) {
    return static_cast<double>(static_cast<int>(engine_() % (2U * most + 1)) - most);
  };
  while (rays.size() < 3000) {
    const std::array<double, 6> ray{
        whole(7) / 4 + 0.125, whole(7) / 4 + 0.125, whole(7) / 4 + 0.125, whole(2), whole(2), whole(2)};
    if (ray[3] != 0 || ray[4] != 0 || ray[5] != 0) rays.push_back(ray);
  }
  const auto is_inside = [](const std::array<double, 6>& ray) {
    const double farthest = std::max({std::abs(ray[0]), std::abs(ray[1]), std::abs(ray[2])});
    return farthest > 0.5 && farthest < 1 ? 1U : 0U;
  };
  for (const masu_precision precision : {MASU_PRECISION_ROBUST, MASU_PRECISION_DOUBLE}) {
    const HitLists lists = tracer.all_hits(rays, 4, {.precision = precision});
    EXPECT_TRUE(lists == without_grid.all_hits(rays, 4, {.precision = precision}));
    EXPECT_EQ(tracer.count_hits(rays, {.precision = precision}), lists.counts); // never more than 4
    const std::vector<std::uint8_t> inside = tracer.inside(rays, {.precision = precision});
    const std::vector<std::uint32_t> fronts =
        tracer.count_hits(rays, {.precision = precision, .faces = MASU_FACES_FRONT});
    for (std::size_t i = 0; i < rays.size(); ++i) {
      EXPECT_EQ(2 * fronts[i] + is_inside(rays[i]), lists.counts[i]) << i;
      EXPECT_EQ(inside[i], is_inside(rays[i])) << i;
      const std::uint32_t count = lists.counts[i];
      for (std::uint32_t k = 0; k < 4; ++k) {
        const std::size_t at = 4 * i + k;
        EXPECT_EQ(lists.primitive[at] != MASU_NONE, k < count);
        EXPECT_TRUE(k == 0 || lists.t[at - 1] <= lists.t[at]);
      }
    }
  }
  // Without the first hit the second is the nearest.
  std::vector<std::array<double, 6>> inwards{{0.1, 0.2, 5, 0, 0, -1}, {0.1, 0.2, -5, 0, 0, 1}};
  const HitLists lists = tracer.all_hits(inwards, 4);
  const std::uint32_t first[2]{lists.primitive[0], lists.primitive[4]};
  const Hits next = tracer.nearest(inwards, {.exclude = first});
  EXPECT_EQ(next.primitive, (std::vector<std::uint32_t>{lists.primitive[1], lists.primitive[5]}));
  EXPECT_EQ(tracer.nearest(inwards, {.faces = MASU_FACES_BACK}).t, (std::vector<float>{4.5F, 4.5F}));
  EXPECT_EQ(lists.t, (std::vector<double>{4, 4.5, 5.5, 6, 4, 4.5, 5.5, 6}));
  EXPECT_EQ(lists.front, (std::vector<std::uint8_t>{1, 0, 1, 0, 1, 0, 1, 0}));

  refused([&] { tracer.all_hits(rays, 0); });
  refused([&] { tracer.count_hits(rays, {.precision = MASU_PRECISION_FAST}); });
  refused([&] { tracer.inside(rays, {.faces = MASU_FACES_BACK}); });
  refused([&] { tracer.nearest(rays, {.faces = static_cast<masu_faces>(3)}); });
  auto hits = sized<masu_hits>();
  std::vector<double> t(rays.size() + 1);
  hits.t64 = reinterpret_cast<double*>(reinterpret_cast<char*>(t.data()) + 4);
  refused([&] { tracer.nearest(rays.data(), rays.size(), hits); });
}

// The first hit of an object that they see.
TEST_F(Library, RaysHitTheObjectsOfTheirMasks) {
  const ArrayMesh parts[]{random_mesh(200), random_mesh(200), random_mesh(200)};
  const Scene scene(std::array{parts[0].view(), parts[1].view(), parts[2].view()});
  const Tracer tracer(scene, Grid(scene));
  const std::vector<masu_ray> rays = random_rays(1000);
  constexpr std::uint32_t limit = 600; // all
  const HitLists all = tracer.all_hits(rays, limit);
  std::vector<std::uint32_t> ray_masks(rays.size());
  const auto expect_hits = [&](std::span<const std::uint32_t> masks, const std::uint32_t* masks_of_rays) {
    Hits nearest{std::vector<float>(rays.size(), infinity),
                 std::vector<std::uint32_t>(rays.size(), MASU_NONE)};
    std::vector<std::uint32_t> counts(rays.size());
    std::vector<std::uint8_t> occluded(rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const std::uint32_t ray_mask = masks_of_rays != nullptr ? masks_of_rays[i] : 0xffffffffU;
      for (std::size_t k = i * limit; k < i * limit + all.counts[i]; ++k) {
        if ((masks[all.primitive[k] / 200] & ray_mask) == 0 || counts[i]++ > 0) continue;
        nearest.t[i] = static_cast<float>(all.t[k]);
        nearest.primitive[i] = all.primitive[k];
        occluded[i] = 1;
      }
    }
    const QueryOptions options{.object_masks = masks, .ray_masks = masks_of_rays};
    EXPECT_EQ(tracer.nearest(rays, options).t, nearest.t);
    EXPECT_EQ(tracer.nearest(rays, options).primitive, nearest.primitive);
    EXPECT_EQ(tracer.occluded(rays, options), occluded);
    EXPECT_EQ(tracer.count_hits(rays, options), counts);
  };
  for (std::uint32_t chosen = 0; chosen < 8; ++chosen)
    expect_hits(std::array{chosen & 1, chosen & 2, chosen & 4}, nullptr);
  for (std::uint32_t& mask : ray_masks)
    mask = static_cast<std::uint32_t>(engine_());
  const std::array<std::uint32_t, 3> masks{1, 0x80000002, 0xffff0000};
  expect_hits(masks, ray_masks.data());
  EXPECT_THROW(tracer.nearest(rays, {.object_masks = std::span(masks).first(2)}), Exception);
  EXPECT_THROW(tracer.nearest(rays, {.ray_masks = ray_masks.data()}), Exception);
}

// Of every structure, in places of either type, in the world.
TEST_F(Library, FindsClosestPoints) {
  std::vector<ArrayMesh> parts{random_mesh(300), random_mesh(300)};
  for (ArrayMesh& part : parts) {
    for (float& c : part.vertices) // few digits: all are kept relative to the bounds' centre
      c = std::round(c * 4096) / 4096;
    for (std::size_t i = 0; i < part.vertices.size(); i += 3)
      part.vertices[i] += 1024; // so that the scene has an origin of its own
  }
  const std::array meshes{parts[0].view(), parts[1].view()};
  const Scene scene(meshes);
  std::vector<std::array<float, 3>> places(1000);
  for (auto& place : places)
    place = {1024 + 3 * coordinate(), 3 * coordinate(), 3 * coordinate()};
  places.push_back({std::numeric_limits<float>::quiet_NaN(), 0, 0});
  std::vector<std::array<double, 3>> places64;
  for (const auto& [x, y, z] : places)
    places64.push_back({x, y, z});
  const ClosestPoints expected = brute_force(scene).closest(places);
  for (std::size_t i = 0; i + 1 < places.size(); ++i) {
    const auto& [x, y, z] = expected.point[i];
    EXPECT_NEAR(std::hypot(places64[i][0] - x, places64[i][1] - y, places64[i][2] - z), expected.distance[i],
                1e-12);
  }
  EXPECT_EQ(expected.primitive.back(), MASU_NONE);
  EXPECT_EQ(expected.distance.back(), infinity);
  const auto expect_same = [&](const ClosestPoints& found) {
    EXPECT_EQ(found.primitive, expected.primitive);
    EXPECT_EQ(found.distance, expected.distance);
    EXPECT_TRUE(std::equal(found.point.begin(), found.point.end() - 1, expected.point.begin()));
  };
  for (const auto& [structure, quality] :
       {std::pair(MASU_STRUCTURE_BVH, MASU_QUALITY_HIGH), std::pair(MASU_STRUCTURE_BVH, MASU_QUALITY_FAST),
        std::pair(MASU_STRUCTURE_GRID, MASU_QUALITY_HIGH)}) {
    const Tracer tracer(scene, built(scene, structure, quality));
    expect_same(tracer.closest(places));
    expect_same(tracer.closest(places64, {.threads = 1}));
  }
  const Tracer tracer(scene);
  // Without the closest, and of one mesh alone.
  const ClosestPoints next = tracer.closest(places, {.exclude = expected.primitive.data()});
  const std::array<std::uint32_t, 2> second{0, 1};
  const ClosestPoints of_second = tracer.closest(places, {.object_masks = second});
  for (std::size_t i = 0; i + 1 < places.size(); ++i) {
    EXPECT_NE(next.primitive[i], expected.primitive[i]);
    EXPECT_GE(next.distance[i], expected.distance[i]);
    EXPECT_GE(of_second.primitive[i], 300U);
    EXPECT_GE(of_second.distance[i], expected.distance[i]);
    if (expected.primitive[i] >= 300) {
      EXPECT_EQ(of_second.distance[i], expected.distance[i]);
    }
  }
  // At a corner of a triangle every field that a closest point has.
  const std::array<float, 3> corner{parts[0].vertices[3], parts[0].vertices[4], parts[0].vertices[5]};
  auto hits = sized<masu_hits>();
  float t = -1, uv[2], normal[3];
  std::uint32_t object = 5, face = 5;
  hits.t = &t;
  hits.uv = uv;
  hits.normal = normal;
  hits.object = &object;
  hits.face = &face;
  tracer.closest(&corner, 1, hits, nullptr);
  EXPECT_EQ(t, 0);
  EXPECT_EQ(uv[0], 1);
  EXPECT_EQ(uv[1], 0);
  EXPECT_EQ(object, 0U);
  EXPECT_EQ(face, 0U);
  EXPECT_NEAR(std::hypot(normal[0], normal[1], normal[2]), 1, 1e-6);
  std::uint8_t front = 0;
  hits.front = &front;
  EXPECT_THROW(tracer.closest(&corner, 1, hits, nullptr), Exception);
  EXPECT_THROW(tracer.closest(places, {.faces = MASU_FACES_BACK}), Exception);
  auto query = sized<masu_query>();
  query.format = MASU_RAYS_FLOAT32_6;
  EXPECT_EQ(masu_closest(tracer.get(), places.data(), 1, &query, nullptr, nullptr), MASU_ERROR_USAGE);
  EXPECT_EQ(masu_closest(tracer.get(), nullptr, 1, nullptr, nullptr, nullptr), MASU_ERROR_USAGE);
  EXPECT_EQ(masu_closest(tracer.get(), nullptr, 0, nullptr, nullptr, nullptr), MASU_OK);
}

TEST_F(Library, AnswersThreadsAtTheSameTime) {
  prepare(random_mesh(500));
  const Tracer tracers[]{opened(), opened()};
  const std::vector<masu_ray> rays = random_rays(20000);
  const Found expected = found_by(tracers[0], rays);
  std::vector<std::jthread> threads;
  for (std::size_t k = 0; k < 8; ++k) {
    threads.emplace_back([&, k] {
      for (int round = 0; round < 5; ++round) {
        EXPECT_TRUE(found_by(tracers[k % 2], rays) == expected);
        const auto none = sized<masu_hits>();
        EXPECT_EQ(masu_nearest(tracers[k % 2].get(), nullptr, 1, nullptr, &none), MASU_ERROR_USAGE);
        EXPECT_STREQ(masu_error(), "rays: is a null pointer");
      }
    });
  }
}

TEST_F(Library, NoGpusAreTheCpu) {
  prepare(random_mesh(10));
  masu_tracer* tracer = nullptr;
  auto options = sized<masu_tracer_options>();
  const auto create = [&](const int* gpus, std::size_t count) {
    options.gpus = gpus;
    options.gpu_count = count;
    return masu_tracer_create(scene(), nullptr, &options, &tracer);
  };
  ASSERT_DONE(create(nullptr, 0));
  masu_tracer_free(tracer);
  int count = 0;
  ASSERT_DONE(masu_gpu_count(&count));
  for (const int wrong : {count, MASU_CPU, -2, 1000})
    EXPECT_EQ(create(&wrong, 1), MASU_ERROR_DEVICE) << wrong;
  EXPECT_EQ(create(nullptr, 1), MASU_ERROR_USAGE);
  EXPECT_EQ(tracer, nullptr);
}

TEST_F(Library, RaysThatArentValidHitNothing) {
  prepare(random_mesh(50));
  const Tracer tracer = opened();
  std::vector<masu_ray> rays;
  const masu_ray good{{0, 0, 0}, 0, {1, 0, 0}, infinity};
  for (int number = 0; number < 8; ++number) {
    for (const float bad : {not_a_number, infinity, -infinity, 3e38F}) {
      if (number == 3 && bad < 0) continue; // counts as 0
      if (number == 7 && bad > 0) continue; // any distance
      masu_ray ray = good;
      float numbers[8];
      std::memcpy(numbers, &ray, sizeof ray);
      numbers[number] = bad;
      std::memcpy(&ray, numbers, sizeof ray);
      rays.push_back(ray);
    }
  }
  rays.push_back({{0, 0, 0}, 0, {0, 0, 0}, infinity});
  rays.push_back({{0, 0, 0}, 1, {1, 0, 0}, 1});
  for (const auto precision : {MASU_PRECISION_FAST, MASU_PRECISION_ROBUST, MASU_PRECISION_DOUBLE}) {
    auto query = sized<masu_query>();
    query.precision = precision;
    const Found found = found_by(tracer, rays, query);
    for (std::size_t i = 0; i < rays.size(); ++i) {
      if (precision == MASU_PRECISION_DOUBLE && std::abs(rays[i].origin[0]) > 1e30F) continue; // valid there
      EXPECT_EQ(found.primitive[i], MASU_NONE) << i;
      EXPECT_EQ(found.occluded[i], 0) << i;
    }
  }
}

TEST_F(Library, PrimitivesAreTrianglesInOrderDegenerateOnesToo) {
  const ArrayMesh mesh{{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 5, 1, 0, 5, 0, 1, 5},
                       {0, 1, 2, /* without area */ 0, 0, 0, 0, 1, 1, /* again */ 3, 4, 5}};
  masu_mesh meshes[2]{mesh.view(), mesh.view()};
  meshes[1].triangle_count = 1;
  const float color[3]{0.25F, 0.5F, 1};
  meshes[1].color = color;
  prepare(meshes);
  const masu_scene_description description = scene_->describe();
  EXPECT_EQ(description.triangles, 5U);
  EXPECT_EQ(description.is_float64, 0);
  EXPECT_EQ(description.bounds_max[2], 5);
  const Found found = found_by(
      opened(), {{{0.2F, 0.2F, 9}, 0, {0, 0, -1}, infinity}, {{0.2F, 0.2F, 3}, 0, {0, 0, -1}, infinity}});
  EXPECT_EQ(found.primitive[0], 3U);
  EXPECT_EQ(found.t[0], 4);
  EXPECT_EQ(found.primitive[1], 0U); // of equal ones the first
  EXPECT_EQ(found.face, found.primitive);
  masu_primitive primitive = scene_->primitive(4);
  EXPECT_EQ(primitive.kind, MASU_TRIANGLE);
  EXPECT_EQ(primitive.object, 1U);
  EXPECT_EQ(primitive.color[1], 0.5F);
  EXPECT_EQ(masu_scene_primitive(scene(), 5, &primitive), MASU_ERROR_USAGE);
}

// Two triangles of a square, the second turned, one of them twice, and one that is a line.
TEST_F(Library, ChecksMeshes) {
  const std::vector<float> vertices{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
  const std::vector<std::uint32_t> indices{0, 1, 2, 0, 3, 2, 2, 1, 0, 3, 3, 1};
  const masu_mesh_check found = Scene(vertices, indices).check();
  EXPECT_EQ(found.points, 4U);
  EXPECT_EQ(found.edges, 5U);
  ASSERT_EQ(found.open_edges.count, 3U); // of the three at the diagonal, two of the second
  EXPECT_EQ(found.open_edges.primitives[0], 0U);
  EXPECT_EQ(found.open_edges.corners[0], 2U);
  EXPECT_EQ(found.open_edges.primitives[2], 1U);
  EXPECT_EQ(found.open_edges.corners[2], 1U);
  EXPECT_EQ(found.inconsistent_edges.count, 0U);
  ASSERT_EQ(found.nonmanifold_edges.count, 1U);
  ASSERT_EQ(found.faces_without_area.count, 1U);
  EXPECT_EQ(found.faces_without_area.primitives[0], 3U);
  ASSERT_EQ(found.duplicate_faces.count, 1U);
  EXPECT_EQ(found.duplicate_faces.primitives[0], 2U);
  EXPECT_EQ(masu_scene_check(nullptr, nullptr), MASU_ERROR_USAGE);
  masu_mesh_check unsized{};
  EXPECT_EQ(masu_scene_check(Scene(vertices, indices).get(), &unsized), MASU_ERROR_USAGE);
}

TEST_F(Library, WrongArgumentsAreErrorsNotFaults) {
  const ArrayMesh mesh = random_mesh(10);
  prepare(mesh);
  masu_scene* read = nullptr;
  masu_grid* made = nullptr;
  masu_tracer* tracer = nullptr;
  EXPECT_EQ(masu_tracer_create(nullptr, grid(), nullptr, &tracer), MASU_ERROR_USAGE);
  EXPECT_EQ(masu_tracer_create(scene(), grid(), nullptr, nullptr), MASU_ERROR_USAGE);
  auto brute_force = sized<masu_tracer_options>();
  brute_force.brute_force = 1;
  EXPECT_EQ(masu_tracer_create(scene(), grid(), &brute_force, &tracer), MASU_ERROR_USAGE);
  const Scene other(random_mesh(10).vertices, mesh.indices);
  EXPECT_EQ(masu_tracer_create(other.get(), grid(), nullptr, &tracer), MASU_ERROR_INPUT);
  EXPECT_EQ(tracer, nullptr);
  scene_->write(file("scene"));
  grid_->write(file("grid"));
  EXPECT_EQ(masu_scene_read(file("grid").c_str(), &read), MASU_ERROR_INPUT);
  EXPECT_EQ(masu_grid_read(file("scene").c_str(), &made), MASU_ERROR_INPUT);
  EXPECT_EQ(masu_scene_read(nullptr, &read), MASU_ERROR_USAGE);
  EXPECT_EQ(masu_scene_read(file("scene").c_str(), nullptr), MASU_ERROR_USAGE);
  EXPECT_EQ(masu_scene_read(file("missing").c_str(), &read), MASU_ERROR_INPUT);
  EXPECT_NE(std::string(masu_error()).find("missing"), std::string::npos);
  EXPECT_EQ(masu_grid_read(file("missing").c_str(), &made), MASU_ERROR_INPUT);
  EXPECT_EQ(masu_scene_write(scene(), file("no/folder").c_str()), MASU_ERROR_OUTPUT);
  EXPECT_EQ(masu_grid_write(grid(), file("no/folder").c_str()), MASU_ERROR_OUTPUT);
  EXPECT_EQ(masu_scene_write(nullptr, file("out").c_str()), MASU_ERROR_USAGE);
  EXPECT_EQ(masu_grid_write(nullptr, file("out").c_str()), MASU_ERROR_USAGE);
  EXPECT_EQ(masu_scene_describe(scene(), nullptr), MASU_ERROR_USAGE);
  EXPECT_EQ(masu_grid_describe(grid(), nullptr), MASU_ERROR_USAGE);

  const Tracer cpu = opened();
  tracer = cpu.get();
  const std::vector<masu_ray> rays = random_rays(4);
  Found found(rays.size());
  const masu_hits hits = found.hits(), nothing = sized<masu_hits>();
  auto query = sized<masu_query>();
  EXPECT_EQ(masu_nearest(nullptr, rays.data(), 4, nullptr, &hits), MASU_ERROR_USAGE);
  EXPECT_EQ(masu_nearest(tracer, nullptr, 4, nullptr, &hits), MASU_ERROR_USAGE);
  EXPECT_EQ(masu_nearest(tracer, rays.data(), 4, nullptr, nullptr), MASU_ERROR_USAGE);
  EXPECT_EQ(masu_occluded(tracer, rays.data(), 4, nullptr, nullptr), MASU_ERROR_USAGE);
  const char* const odd = reinterpret_cast<const char*>(rays.data()) + 1;
  EXPECT_EQ(masu_nearest(tracer, odd, 3, nullptr, &hits), MASU_ERROR_USAGE);
  masu_hits odd_hits = hits;
  odd_hits.t = reinterpret_cast<float*>(reinterpret_cast<char*>(found.t.data()) + 2);
  EXPECT_EQ(masu_nearest(tracer, rays.data(), 3, nullptr, &odd_hits), MASU_ERROR_USAGE);
  for (const int wrong : {-1, 4, 1 << 30}) {
    query = sized<masu_query>();
    std::memcpy(&query.format, &wrong, sizeof wrong);
    EXPECT_EQ(masu_nearest(tracer, rays.data(), 4, &query, &hits), MASU_ERROR_USAGE);
    query = sized<masu_query>();
    std::memcpy(&query.precision, &wrong, sizeof wrong);
    EXPECT_EQ(masu_nearest(tracer, rays.data(), 4, &query, &hits), MASU_ERROR_USAGE);
  }
  ASSERT_DONE(masu_nearest(tracer, rays.data(), 4, nullptr, &nothing));
  ASSERT_DONE(masu_nearest(tracer, nullptr, 0, nullptr, &nothing));
  masu_tracer_free(nullptr);
  masu_scene_free(nullptr);
  masu_grid_free(nullptr);

  const auto created_with = [&](const auto& change) {
    masu_mesh bad = mesh.view();
    change(bad);
    const masu_geometry geometry = geometry_of({&bad, 1});
    return masu_scene_create(&geometry, &read);
  };
  ArrayMesh infinite = mesh;
  infinite.vertices[4] = infinity;
  EXPECT_EQ(created_with([](masu_mesh& bad) { bad.vertex_count -= 1; }), MASU_ERROR_USAGE);
  EXPECT_EQ(created_with([](masu_mesh& bad) { bad.indices = nullptr, bad.triangle_count += 1; }),
            MASU_ERROR_USAGE);
  EXPECT_EQ(created_with([](masu_mesh& bad) { bad.vertices = nullptr; }), MASU_ERROR_USAGE);
  EXPECT_EQ(created_with([](masu_mesh& bad) { bad.size = 0; }), MASU_ERROR_USAGE);
  EXPECT_EQ(created_with([](masu_mesh& bad) { bad.triangle_count = std::size_t{1} << 60; }),
            MASU_ERROR_USAGE);
  EXPECT_EQ(created_with([&](masu_mesh& bad) { bad = infinite.view(); }), MASU_ERROR_USAGE);
  EXPECT_EQ(masu_scene_create(nullptr, &read), MASU_ERROR_USAGE);
  auto missing = sized<masu_geometry>();
  missing.mesh_count = 1;
  EXPECT_EQ(masu_scene_create(&missing, &read), MASU_ERROR_USAGE);
  for (const std::array<float, 8> cone : {std::array<float, 8>{0, 0, 0, 1, 0, 0, 0, 1},
                                          {0, 0, 0, 0, 0, 0, 1, 0},
                                          {0, 0, 0, 1, 0, 0, 1, -1},
                                          {0, 0, 0, 1, 0, not_a_number, 1, 1}}) {
    const masu_quadrics cones = quadrics_of(cone);
    auto geometry = sized<masu_geometry>();
    geometry.cones = &cones;
    geometry.cone_count = 1;
    EXPECT_EQ(masu_scene_create(&geometry, &read), MASU_ERROR_USAGE);
  }
  EXPECT_EQ(read, nullptr);

  auto options = default_build_options();
  const auto built_with = [&](const auto& change) {
    options = default_build_options();
    change();
    return masu_grid_build(scene(), &options, &made);
  };
  EXPECT_EQ(built_with([] {}), MASU_OK) << masu_error();
  masu_grid_free(made);
  EXPECT_EQ(built_with([&] { options.division = "0"; }), MASU_ERROR_USAGE);
  EXPECT_EQ(built_with([&] { options.division = "what"; }), MASU_ERROR_USAGE);
  EXPECT_EQ(built_with([&] { options.alpha = std::nan(""); }), MASU_ERROR_USAGE);
  EXPECT_EQ(built_with([&] { options.nested = 16; }), MASU_ERROR_USAGE);
  EXPECT_EQ(built_with([&] { options.threads = -1; }), MASU_ERROR_USAGE);
  EXPECT_EQ(built_with([&] { options.device = 1000; }), MASU_ERROR_DEVICE);
  EXPECT_EQ(built_with([&] { options.device = -2; }), MASU_ERROR_USAGE);
  EXPECT_EQ(built_with([&] {
              options.structure = MASU_STRUCTURE_BVH;
              options.merge = MASU_MERGE_X;
            }),
            MASU_ERROR_USAGE);
  EXPECT_EQ(masu_grid_build(nullptr, nullptr, &made), MASU_ERROR_USAGE);
  EXPECT_EQ(masu_grid_refit(nullptr, scene(), &made), MASU_ERROR_USAGE);
  EXPECT_EQ(masu_grid_refit(grid(), nullptr, &made), MASU_ERROR_USAGE);
  const Grid grid_of_voxels = built(mesh.scene(), MASU_STRUCTURE_GRID);
  EXPECT_EQ(masu_grid_refit(grid_of_voxels.get(), scene(), &made), MASU_ERROR_USAGE);
  EXPECT_EQ(masu_grid_build(scene(), nullptr, nullptr), MASU_ERROR_USAGE);
  EXPECT_EQ(made, nullptr);
  int count = -1;
  EXPECT_EQ(masu_gpu_count(nullptr), MASU_ERROR_USAGE);
  EXPECT_EQ(masu_gpu_count(&count), MASU_OK);
  EXPECT_GE(count, 0);
  EXPECT_EQ(masu_default_build_options(nullptr), MASU_ERROR_USAGE);
}

// Container (tests/scene/container_test.cpp) has each byte and length.
TEST_F(Library, DamagedFilesAreErrors) {
  prepare(random_mesh(100));
  scene_->write(file("scene"));
  grid_->write(file("grid"));
  for (const char* const name : {"scene", "grid"}) {
    const Bytes whole = read_bytes(file(name));
    for (int round = 0; round < 20; ++round) {
      Bytes damaged = whole;
      damaged[engine_() % damaged.size()] ^= static_cast<std::uint8_t>(1U << engine_() % 8);
      if (round % 4 == 0) damaged.resize(engine_() % damaged.size());
      write_bytes(file("damaged"), damaged);
      masu_scene* scene = nullptr;
      masu_grid* grid = nullptr;
      EXPECT_EQ(*name == 's' ? masu_scene_read(file("damaged").c_str(), &scene)
                             : masu_grid_read(file("damaged").c_str(), &grid),
                MASU_ERROR_INPUT);
      EXPECT_TRUE(scene == nullptr && grid == nullptr);
    }
  }
}

} // namespace
