// Calls of the C interface that their program ends: go_on() of masu.h.
#include "tests/api/found.h"
#include "tests/api/random_arrays.h"

#include <thread>

namespace {

// A program's go_on(), which returns 0 when it is called for the last time.
struct Calls {
  int last;
  int count = 0;
  bool are_right = true; // by the thread of the call, and shares of work
  std::thread::id thread = std::this_thread::get_id();

  static int go_on(void* user, double done) {
    Calls& calls = *static_cast<Calls*>(user);
    ++calls.count;
    if (std::this_thread::get_id() != calls.thread || !(done >= 0 && done <= 1)) calls.are_right = false;
    return calls.count < calls.last ? 1 : 0;
  }
};

template <class Options>
Options with(Options options, Calls& calls) {
  options.go_on = Calls::go_on;
  options.user = &calls;
  return options;
}

void expect_ended(masu_status status, const Calls& calls) {
  EXPECT_EQ(status, MASU_ERROR_INTERRUPTED) << masu_error();
  EXPECT_STREQ(masu_error(), "go_on: has ended the call");
  EXPECT_EQ(calls.count, calls.last);
  EXPECT_TRUE(calls.are_right);
}

class Interrupt : public masu::RandomArrays {
protected:
  std::vector<float> random_vertices(std::uint32_t triangles) {
    return random_mesh(triangles, 0.05F).vertices;
  }
  masu_mesh mesh_of(const std::vector<float>& vertices) {
    auto mesh = masu::mesh(vertices, std::array<std::uint32_t, 0>{});
    mesh.indices = nullptr;
    mesh.triangle_count = vertices.size() / 9;
    return mesh;
  }
  masu::Scene scene_of(const std::vector<float>& vertices) {
    return masu::Scene(std::array{mesh_of(vertices)});
  }
  // From between the triangles.
  std::vector<masu_ray> short_rays(std::size_t count) {
    std::vector<masu_ray> rays = random_rays(count, 1);
    for (masu_ray& ray : rays)
      ray.tmin = 0, ray.tmax = 1;
    return rays;
  }
};

// They would take minutes, or an hour.
TEST_F(Interrupt, QueriesByBruteForceEndWhereTheProgramSaysSo) {
  const std::vector<float> vertices = random_vertices(100'000);
  const masu::Scene scene = scene_of(vertices);
  const masu::Tracer tracer(scene, nullptr, {}, true);
  const std::vector<masu_ray> rays = short_rays(std::size_t{1} << 20);
  std::vector<float> t(rays.size());
  std::vector<double> t64(rays.size());
  std::vector<std::uint32_t> counts(rays.size());
  std::vector<std::uint8_t> bytes(rays.size());
  auto hits = masu::sized<masu_hits>(), hits64 = masu::sized<masu_hits>();
  hits.t = t.data();
  hits64.t64 = t64.data();
  const void* const from = rays.data();
  const std::size_t n = rays.size();
  for (const masu_precision precision : {MASU_PRECISION_ROBUST, MASU_PRECISION_DOUBLE}) {
    const auto expect_ended_query = [&](const auto& call) {
      Calls calls{static_cast<int>(1 + engine_() % 2)};
      auto query = with(masu::sized<masu_query>(), calls);
      query.precision = precision;
      query.threads = static_cast<int>(engine_() % 2);
      expect_ended(call(&query), calls);
    };
    masu_tracer* const by = tracer.get();
    expect_ended_query([&](const masu_query* q) { return masu_nearest(by, from, n, q, &hits); });
    expect_ended_query([&](const masu_query* q) { return masu_nearest(by, from, n, q, &hits64); });
    expect_ended_query([&](const masu_query* q) { return masu_all_hits(by, from, n, q, 1, &hits, nullptr); });
    expect_ended_query([&](const masu_query* q) { return masu_count_hits(by, from, n, q, counts.data()); });
    expect_ended_query([&](const masu_query* q) { return masu_inside(by, from, n, q, bytes.data()); });
    expect_ended_query([&](const masu_query* q) { return masu_closest(by, from, n, q, &hits64, nullptr); });
    expect_ended_query(
        [&](const masu_query* q) { return masu_winding(by, from, n, q, 0, t64.data(), nullptr); });
  }
  const std::vector<masu_ray> few(rays.begin(), rays.begin() + 50);
  EXPECT_TRUE(found_by(tracer, few) == found_by(masu::Tracer(scene), few));
}

// go_on() is called a tenth of a second after a call began: what a machine does sooner is tried with twice as
// much, `make(copies, calls)`, up to 256 times. It fails, once it has called.
template <class Make>
void expect_ended_once_called(const Make& make) {
  for (std::size_t copies = 1; copies <= 256; copies *= 2) {
    Calls calls{1};
    const masu_status status = make(copies, calls);
    if (calls.count > 0) return expect_ended(status, calls);
    EXPECT_EQ(status, MASU_OK);
  }
  ADD_FAILURE() << "go_on() was never called";
}

TEST_F(Interrupt, BuildsEndWhereTheProgramSaysSo) {
  const std::vector<float> vertices = random_vertices(200'000);
  const std::vector<masu_mesh> meshes(256, mesh_of(vertices));
  const auto scene_of_copies = [&](std::size_t copies) {
    return masu::Scene(std::span(meshes).first(copies));
  };
  for (const masu_structure structure : {MASU_STRUCTURE_FASTEST, MASU_STRUCTURE_GRID, MASU_STRUCTURE_BVH}) {
    expect_ended_once_called([&](std::size_t copies, Calls& calls) {
      auto options = with(masu::default_build_options(), calls);
      options.structure = structure;
      masu_grid* grid = nullptr;
      const masu_status status = masu_grid_build(scene_of_copies(copies).get(), &options, &grid);
      EXPECT_EQ(grid != nullptr, status == MASU_OK);
      masu_grid_free(grid);
      return status;
    });
  }
  expect_ended_once_called([&](std::size_t copies, Calls& calls) {
    const auto options = with(masu::sized<masu_tracer_options>(), calls);
    masu_tracer* tracer = nullptr;
    const masu_status status = masu_tracer_create(scene_of_copies(copies).get(), nullptr, &options, &tracer);
    EXPECT_EQ(tracer != nullptr, status == MASU_OK);
    masu_tracer_free(tracer);
    return status;
  });
  expect_ended_once_called([&](std::size_t copies, Calls& calls) {
    auto geometry = with(masu::sized<masu_geometry>(), calls);
    geometry.meshes = meshes.data();
    geometry.mesh_count = copies;
    masu_scene* scene = nullptr;
    const masu_status status = masu_scene_create(&geometry, &scene);
    EXPECT_EQ(scene != nullptr, status == MASU_OK);
    masu_scene_free(scene);
    return status;
  });
}

// Also if the program traces meanwhile.
TEST_F(Interrupt, ResultsAreTheSameWithAndWithout) {
  const std::vector<float> vertices = random_vertices(20'000);
  const masu::Scene scene = scene_of(vertices);
  const masu::Tracer tracer(scene), brute_force(scene, nullptr, {}, true);
  const std::vector<masu_ray> rays = short_rays(5'000);
  struct Nested {
    const masu::Tracer& tracer;
    const std::vector<masu_ray>& rays;
    int count = 0;

    static int go_on(void* user, double) {
      Nested& nested = *static_cast<Nested*>(user);
      ++nested.count;
      return nested.tracer.nearest(nested.rays).t.size() == nested.rays.size() ? 1 : 0;
    }
  } nested{tracer, rays};
  const masu::QueryOptions options{.go_on = Nested::go_on, .user = &nested};
  const masu::Hits expected = tracer.nearest(rays);
  for (const masu::Tracer* by : {&tracer, &brute_force}) {
    const masu::Hits hits = by->nearest(rays, options);
    EXPECT_EQ(hits.t, expected.t);
    EXPECT_EQ(hits.primitive, expected.primitive);
  }
  EXPECT_GT(nested.count, 0);
}

// As programs have it that were compiled before go_on was there.
TEST_F(Interrupt, StructuresWithoutGoOnWork) {
  const std::vector<float> vertices = random_vertices(100);
  const masu_mesh mesh = mesh_of(vertices);
  Calls calls{1};
  const auto older = [&](auto options, std::size_t size) {
    options.size = size;
    return with(options, calls);
  };
  auto geometry = older(masu::sized<masu_geometry>(), offsetof(masu_geometry, go_on));
  geometry.meshes = &mesh;
  geometry.mesh_count = 1;
  masu_scene* scene = nullptr;
  ASSERT_DONE(masu_scene_create(&geometry, &scene));
  const auto build = older(masu::default_build_options(), offsetof(masu_build_options, go_on));
  masu_grid* grid = nullptr;
  ASSERT_DONE(masu_grid_build(scene, &build, &grid));
  const auto options = older(masu::sized<masu_tracer_options>(), offsetof(masu_tracer_options, go_on));
  masu_tracer* tracer = nullptr;
  ASSERT_DONE(masu_tracer_create(scene, grid, &options, &tracer));
  const std::vector<masu_ray> rays = short_rays(100);
  const auto query = older(masu::sized<masu_query>(), offsetof(masu_query, go_on));
  EXPECT_TRUE(found_by(tracer, rays, query) == found_by(tracer, rays));
  EXPECT_EQ(calls.count, 0);
  masu_tracer_free(tracer);
  masu_grid_free(grid);
  masu_scene_free(scene);
}

} // namespace
