// The C interface, and that of C++ over it: right answers on the CPU, and an error for whatever is wrong,
// never a fault.
#include "libscene/geometry/vector.h"
#include "tests/stability/random_seed.h"
#include "tests/temporary_folder.h"

#include <masu/masu.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <iterator>
#include <limits>
#include <random>
#include <span>
#include <string>
#include <thread>
#include <vector>

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity(),
                not_a_number = std::numeric_limits<float>::quiet_NaN();

#define ASSERT_DONE(call) ASSERT_EQ(call, MASU_OK) << masu_error()

struct Mesh {
  std::vector<float> vertices;
  std::vector<std::uint32_t> indices;

  masu_mesh view() const {
    masu_mesh mesh{};
    mesh.vertices = vertices.data();
    mesh.vertex_count = vertices.size() / 3;
    mesh.indices = indices.data();
    mesh.triangle_count = indices.size() / 3;
    return mesh;
  }
};

template <class Engine>
float coordinate(Engine& engine) {
  return std::uniform_real_distribution<float>(-1, 1)(engine);
}

template <class Engine>
Mesh random_mesh(Engine& engine, std::uint32_t triangles) {
  Mesh mesh;
  for (std::uint32_t i = 0; i < 3 * triangles; ++i) {
    const float center[3]{coordinate(engine), coordinate(engine), coordinate(engine)};
    for (const float c : center)
      mesh.vertices.push_back(c + 0.1F * coordinate(engine));
    mesh.indices.push_back(i);
  }
  return mesh;
}

template <class Engine>
std::vector<masu_ray> random_rays(Engine& engine, std::size_t count) {
  std::vector<masu_ray> rays(count);
  for (masu_ray& ray : rays) {
    for (int axis = 0; axis < 3; ++axis) {
      ray.origin[axis] = 2 * coordinate(engine);
      ray.direction[axis] = coordinate(engine);
    }
    ray.tmin = std::max(coordinate(engine), 0.0F);
    ray.tmax = engine() % 2 == 0 ? infinity : 1 + coordinate(engine);
  }
  return rays;
}

class Library : public testing::Test {
protected:
  std::string file(const char* name) const { return folder_.file(name); }

  // Of a mesh and an irregular grid.
  void prepare(const Mesh& mesh) {
    const masu_mesh view = mesh.view();
    ASSERT_DONE(masu_write_scene(file("scene").c_str(), &view, 1, MASU_STORE_AUTO, nullptr));
    ASSERT_DONE(masu_build_grid(file("scene").c_str(), file("grid").c_str(), nullptr));
  }

  // Of what is prepared, on the CPU; open until the test's end.
  masu_tracer* opened() {
    masu_tracer* tracer = nullptr;
    EXPECT_EQ(masu_open(file("scene").c_str(), file("grid").c_str(), MASU_CPU, &tracer), MASU_OK)
        << masu_error();
    return opened_.emplace_back(tracer);
  }
  ~Library() override { std::ranges::for_each(opened_, masu_close); }

  const masu::TemporaryFolder folder_;
  const masu::RandomSeed seed_;
  std::mt19937_64 engine_ = seed_.engine();

private:
  const testing::ScopedTrace trace_{__FILE__, __LINE__, seed_.trace()};
  std::vector<masu_tracer*> opened_;
};

struct Found {
  std::vector<float> t, uv, normal;
  std::vector<std::uint32_t> primitive, object, face;
  std::vector<std::uint8_t> occluded;

  explicit Found(std::size_t n)
      : t(n), uv(2 * n), normal(3 * n), primitive(n), object(n), face(n), occluded(n) {}
  masu_hits hits() {
    return {t.data(), primitive.data(), object.data(), uv.data(), normal.data(), face.data()};
  }
  friend bool operator==(const Found& a, const Found& b) {
    return a.t == b.t && a.uv == b.uv && a.normal == b.normal && a.primitive == b.primitive &&
           a.object == b.object && a.face == b.face && a.occluded == b.occluded;
  }
};

Found found_by(const masu_tracer* tracer, const std::vector<masu_ray>& rays, masu_query query = {}) {
  Found found(rays.size());
  const masu_hits hits = found.hits();
  EXPECT_EQ(masu_nearest(tracer, rays.data(), rays.size(), &query, &hits), MASU_OK) << masu_error();
  EXPECT_EQ(masu_occluded(tracer, rays.data(), rays.size(), &query, found.occluded.data()), MASU_OK)
      << masu_error();
  return found;
}

// Möller & Trumbore in double: t of a triangle, or infinity.
double expected_t(const Mesh& mesh, std::size_t triangle, const masu_ray& ray) {
  const auto vector = [](const float* v) { return masu::cast<double>(masu::Vec3f{v[0], v[1], v[2]}); };
  const float* const corners = mesh.vertices.data() + 9 * triangle;
  const masu::Vec3d a = vector(corners), e = vector(corners + 3) - a, f = vector(corners + 6) - a,
                    s = vector(ray.origin) - a, d = vector(ray.direction), p = cross(d, f), q = cross(s, e);
  const double determinant = dot(e, p), u = dot(s, p) / determinant, v = dot(d, q) / determinant,
               t = dot(f, q) / determinant;
  const bool is_hit = u >= 0 && v >= 0 && u + v <= 1 && t > static_cast<double>(ray.tmin) &&
                      t < static_cast<double>(ray.tmax);
  return is_hit ? t : std::numeric_limits<double>::infinity();
}

TEST_F(Library, FindsWhatBruteForceFinds) {
  const Mesh mesh = random_mesh(engine_, 200);
  prepare(mesh);
  masu_tracer* const tracer = opened();
  const std::vector<masu_ray> rays = random_rays(engine_, 5000);
  const Found found = found_by(tracer, rays);
  int hits = 0, unsure = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t triangle = 0; triangle < 200; ++triangle)
      nearest = std::min(nearest, expected_t(mesh, triangle, rays[i]));
    const bool hit = std::isfinite(nearest);
    hits += hit ? 1 : 0;
    EXPECT_EQ(found.occluded[i] != 0, found.primitive[i] != MASU_NONE) << i;
    if (hit != (found.primitive[i] != MASU_NONE)) { // by an edge, tmin or tmax
      ++unsure;
      continue;
    }
    if (!hit) {
      EXPECT_EQ(found.t[i], infinity);
      EXPECT_EQ(found.object[i], MASU_NONE);
      continue;
    }
    if (std::abs(static_cast<double>(found.t[i]) - nearest) > 1e-4 * nearest + 1e-4) {
      ++unsure;
      continue;
    }
    EXPECT_EQ(found.object[i], 0U);
    // The barycentric coordinates lead to the point of the ray, the normal is across the edges.
    const std::size_t first = 9 * std::size_t{found.primitive[i]};
    const float u = found.uv[2 * i], v = found.uv[2 * i + 1];
    float along1 = 0, along2 = 0, square = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const float a = mesh.vertices[first + axis], b = mesh.vertices[first + 3 + axis],
                  c = mesh.vertices[first + 6 + axis];
      EXPECT_NEAR((1 - u - v) * a + u * b + v * c,
                  rays[i].origin[axis] + found.t[i] * rays[i].direction[axis], 1e-4)
          << i;
      const float n = found.normal[3 * i + axis];
      along1 += n * (b - a);
      along2 += n * (c - a);
      square += n * n;
    }
    EXPECT_NEAR(along1, 0, 1e-5);
    EXPECT_NEAR(along2, 0, 1e-5);
    EXPECT_NEAR(square, 1, 1e-5);
  }
  EXPECT_GT(hits, 100);
  EXPECT_LT(unsure, 10);
}

TEST_F(Library, ResultsAreTheSameByBruteForceAndByEveryFormat) {
  prepare(random_mesh(engine_, 300));
  masu_tracer *const tracer = opened(), *brute_force = nullptr;
  ASSERT_DONE(masu_open_brute_force(file("scene").c_str(), nullptr, 0, &brute_force));
  masu_description description{};
  ASSERT_DONE(masu_describe(brute_force, &description));
  EXPECT_EQ(description.grid_bytes, 0U);
  std::vector<masu_ray> rays = random_rays(engine_, 2000);
  EXPECT_TRUE(found_by(tracer, rays) == found_by(brute_force, rays));
  // Six numbers each, floats and doubles.
  std::vector<float> floats;
  std::vector<double> doubles, doubles8;
  for (masu_ray& ray : rays) {
    ray.tmin = 0;
    ray.tmax = infinity;
    floats.insert(floats.end(), ray.origin, ray.origin + 3);
    floats.insert(floats.end(), ray.direction, ray.direction + 3);
    doubles8.insert(doubles8.end(), ray.origin, ray.origin + 4);
    doubles8.insert(doubles8.end(), ray.direction, ray.direction + 4);
  }
  doubles.assign(floats.begin(), floats.end());
  const Found all = found_by(tracer, rays);
  const auto same = [&](const void* data, masu_ray_format format) {
    Found found(rays.size());
    const masu_hits hits = found.hits();
    masu_query query{};
    query.format = format;
    EXPECT_EQ(masu_nearest(tracer, data, rays.size(), &query, &hits), MASU_OK) << masu_error();
    found.occluded = all.occluded;
    return found == all;
  };
  EXPECT_TRUE(same(floats.data(), MASU_RAYS_FLOAT32_6));
  EXPECT_TRUE(same(doubles.data(), MASU_RAYS_FLOAT64_6));
  EXPECT_TRUE(same(doubles8.data(), MASU_RAYS_FLOAT64));
  // Whatever is left out, the rest is the same.
  Found some(rays.size());
  const masu_hits only{nullptr, nullptr, some.object.data(), nullptr, some.normal.data(), some.face.data()};
  ASSERT_DONE(masu_nearest(tracer, rays.data(), rays.size(), nullptr, &only));
  EXPECT_EQ(some.object, all.object);
  EXPECT_EQ(some.normal, all.normal);
  masu_close(brute_force);
}

// No file is left, nor written.
TEST_F(Library, WithoutAGridOneIsBuiltInMemory) {
  prepare(random_mesh(engine_, 300));
  masu_grid_options options;
  masu_default_grid_options(&options);
  options.kind = MASU_GRID_FASTEST;
  options.for_cpu = 1;
  ASSERT_DONE(masu_build_grid(file("scene").c_str(), file("grid").c_str(), &options));
  const auto files = [&] {
    const std::filesystem::directory_iterator all(file("."));
    return std::distance(begin(all), end(all));
  };
  const auto before = files();
  masu_tracer *const with_file = opened(), *without = nullptr;
  ASSERT_DONE(masu_open(file("scene").c_str(), nullptr, MASU_CPU, &without));
  EXPECT_EQ(files(), before);
  masu_description expected{}, description{};
  ASSERT_DONE(masu_describe(with_file, &expected));
  ASSERT_DONE(masu_describe(without, &description));
  EXPECT_GT(description.grid_bytes, 0U);
  EXPECT_EQ(description.grid_bytes, expected.grid_bytes);
  const std::vector<masu_ray> rays = random_rays(engine_, 2000);
  EXPECT_TRUE(found_by(with_file, rays) == found_by(without, rays));
  masu_close(without);
}

// A ray is what its type says, and nothing else is taken for one.
TEST_F(Library, InCppTypesDecideTheFormat) {
  prepare(random_mesh(engine_, 300));
  const masu::Tracer tracer(file("scene"), file("grid"));
  const auto check = [&](const auto& rays, masu_ray_format format) {
    masu_query query{};
    query.format = format;
    Found expected(rays.size());
    const masu_hits hits = expected.hits();
    ASSERT_DONE(masu_nearest(tracer.get(), rays.data(), rays.size(), &query, &hits));
    ASSERT_DONE(masu_occluded(tracer.get(), rays.data(), rays.size(), &query, expected.occluded.data()));
    EXPECT_EQ(tracer.nearest(rays).primitive, expected.primitive);
    EXPECT_EQ(tracer.nearest(std::span(rays), {.coherent = true}).t, expected.t);
    EXPECT_EQ(tracer.occluded(rays), expected.occluded);
    Found found(rays.size());
    tracer.nearest(rays.data(), rays.size(), found.hits());
    tracer.occluded(rays.data(), rays.size(), found.occluded.data());
    EXPECT_TRUE(found == expected);
  };
  const std::vector<masu_ray> rays = random_rays(engine_, 1000);
  std::vector<masu_ray64> doubles;
  std::vector<std::array<float, 6>> six;
  std::vector<std::array<double, 6>> six_doubles;
  for (const masu_ray& ray : rays) {
    const auto [x, y, z] = ray.origin;
    const auto [dx, dy, dz] = ray.direction;
    doubles.push_back({{x + 1e-9, y, z}, ray.tmin, {dx, dy, dz}, ray.tmax});
    six.push_back({x, y, z, dx, dy, dz});
    six_doubles.push_back({x, y, z, dx, dy, dz + 1e-9});
  }
  check(rays, MASU_RAYS_FLOAT32);
  check(doubles, MASU_RAYS_FLOAT64);
  check(six, MASU_RAYS_FLOAT32_6);
  check(six_doubles, MASU_RAYS_FLOAT64_6);
  EXPECT_GT(std::ranges::count_if(tracer.occluded(rays), [](int occluded) { return occluded != 0; }), 10);

  struct Larger : masu_ray {
    int more;
  };
  static_assert(!masu::Ray<Larger> && !masu::Ray<float> && !masu::RayRange<std::vector<double>>);
  EXPECT_TRUE(tracer.nearest(std::vector<masu_ray>()).t.empty());
  EXPECT_EQ(masu::Tracer::brute_force(file("scene")).nearest(rays).t, tracer.nearest(rays).t);
  EXPECT_EQ(masu::Tracer(file("scene")).nearest(rays).t, tracer.nearest(rays).t);
  try {
    FAIL() << masu::Tracer(file("missing")).describe().triangles;
  } catch (const masu::Exception& error) {
    EXPECT_EQ(error.status, MASU_ERROR_INPUT);
    EXPECT_NE(std::string(error.what()).find("missing"), std::string::npos);
  }
}

TEST_F(Library, AnswersThreadsAtTheSameTime) {
  prepare(random_mesh(engine_, 500));
  masu_tracer* const tracers[]{opened(), opened()};
  const std::vector<masu_ray> rays = random_rays(engine_, 20000);
  const Found expected = found_by(tracers[0], rays);
  std::vector<std::thread> threads;
  std::vector<int> right(8);
  for (std::size_t k = 0; k < right.size(); ++k) {
    threads.emplace_back([&, k] {
      for (int round = 0; round < 5; ++round) {
        right[k] += found_by(tracers[k % 2], rays) == expected ? 1 : 0;
        masu_hits none{};
        EXPECT_EQ(masu_nearest(tracers[k % 2], nullptr, 1, nullptr, &none), MASU_ERROR_USAGE);
        EXPECT_STREQ(masu_error(), "rays: is a null pointer");
      }
    });
  }
  for (std::thread& thread : threads)
    thread.join();
  for (const int r : right)
    EXPECT_EQ(r, 5);
}

TEST_F(Library, NoGpusAreTheCpu) {
  prepare(random_mesh(engine_, 10));
  masu_tracer* tracer = nullptr;
  ASSERT_DONE(masu_open_devices(file("scene").c_str(), file("grid").c_str(), nullptr, 0, &tracer));
  masu_description description{};
  ASSERT_DONE(masu_describe(tracer, &description));
  EXPECT_EQ(description.device, MASU_CPU);
  masu_close(tracer);
  int count = 0;
  ASSERT_DONE(masu_gpu_count(&count));
  const int cpu = MASU_CPU;
  EXPECT_EQ(masu_open_devices(file("scene").c_str(), nullptr, &count, 1, &tracer), MASU_ERROR_DEVICE);
  EXPECT_EQ(masu_open_devices(file("scene").c_str(), nullptr, &cpu, 1, &tracer), MASU_ERROR_DEVICE);
  EXPECT_EQ(masu_open_devices(file("scene").c_str(), nullptr, nullptr, 1, &tracer), MASU_ERROR_USAGE);
}

TEST_F(Library, RaysThatArentValidHitNothing) {
  prepare(random_mesh(engine_, 50));
  masu_tracer* const tracer = opened();
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
    masu_query query{};
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
  const Mesh mesh{{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 5, 1, 0, 5, 0, 1, 5},
                  {0, 1, 2, /* without area */ 0, 0, 0, 0, 1, 1, /* again */ 3, 4, 5}};
  masu_mesh meshes[2]{mesh.view(), mesh.view()};
  meshes[1].triangle_count = 1;
  const float color[3]{0.25F, 0.5F, 1};
  meshes[1].color = color;
  ASSERT_DONE(masu_write_scene(file("scene").c_str(), meshes, 2, MASU_STORE_AUTO, nullptr));
  ASSERT_DONE(masu_build_grid(file("scene").c_str(), file("grid").c_str(), nullptr));
  masu_tracer* const tracer = opened();
  masu_description description{};
  ASSERT_DONE(masu_describe(tracer, &description));
  EXPECT_EQ(description.triangles, 5U);
  EXPECT_EQ(description.is_float64, 0);
  EXPECT_EQ(description.device, MASU_CPU);
  EXPECT_EQ(description.bounds_max[2], 5);
  const Found found = found_by(
      tracer, {{{0.2F, 0.2F, 9}, 0, {0, 0, -1}, infinity}, {{0.2F, 0.2F, 3}, 0, {0, 0, -1}, infinity}});
  EXPECT_EQ(found.primitive[0], 3U);
  EXPECT_EQ(found.t[0], 4);
  EXPECT_EQ(found.primitive[1], 0U); // of equal ones the first
  EXPECT_EQ(found.face, found.primitive);
  masu_primitive primitive{};
  ASSERT_DONE(masu_describe_primitive(tracer, 4, &primitive));
  EXPECT_EQ(primitive.kind, MASU_TRIANGLE);
  EXPECT_EQ(primitive.object, 1U);
  EXPECT_EQ(primitive.color[1], 0.5F);
  EXPECT_EQ(masu_describe_primitive(tracer, 5, &primitive), MASU_ERROR_USAGE);
}

TEST_F(Library, WrongArgumentsAreErrorsNotFaults) {
  const Mesh mesh = random_mesh(engine_, 10);
  prepare(mesh);
  const std::string scene = file("scene"), grid = file("grid");
  masu_tracer* tracer = nullptr;
  EXPECT_EQ(masu_open(nullptr, nullptr, MASU_CPU, &tracer), MASU_ERROR_USAGE);
  EXPECT_EQ(masu_open(scene.c_str(), nullptr, MASU_CPU, nullptr), MASU_ERROR_USAGE);
  EXPECT_EQ(masu_open_brute_force(nullptr, nullptr, 0, &tracer), MASU_ERROR_USAGE);
  EXPECT_EQ(masu_open_brute_force(scene.c_str(), nullptr, 0, nullptr), MASU_ERROR_USAGE);
  EXPECT_EQ(masu_open_brute_force(scene.c_str(), nullptr, 1, &tracer), MASU_ERROR_USAGE);
  EXPECT_EQ(masu_open_brute_force(grid.c_str(), nullptr, 0, &tracer), MASU_ERROR_INPUT);
  EXPECT_EQ(masu_open(grid.c_str(), nullptr, MASU_CPU, &tracer), MASU_ERROR_INPUT);
  EXPECT_EQ(masu_open(file("missing").c_str(), nullptr, MASU_CPU, &tracer), MASU_ERROR_INPUT);
  EXPECT_EQ(tracer, nullptr);
  EXPECT_NE(std::string(masu_error()).find("missing"), std::string::npos);
  EXPECT_EQ(masu_open(grid.c_str(), grid.c_str(), MASU_CPU, &tracer), MASU_ERROR_INPUT);
  EXPECT_EQ(masu_open(scene.c_str(), scene.c_str(), MASU_CPU, &tracer), MASU_ERROR_INPUT);
  EXPECT_EQ(masu_open(scene.c_str(), grid.c_str(), -2, &tracer), MASU_ERROR_DEVICE);
  EXPECT_EQ(masu_open(scene.c_str(), grid.c_str(), 1000, &tracer), MASU_ERROR_DEVICE);
  const Mesh other = random_mesh(engine_, 10);
  const masu_mesh other_view = other.view();
  ASSERT_DONE(masu_write_scene(file("other").c_str(), &other_view, 1, MASU_STORE_AUTO, nullptr));
  EXPECT_EQ(masu_open(file("other").c_str(), grid.c_str(), MASU_CPU, &tracer), MASU_ERROR_INPUT);

  ASSERT_DONE(masu_open(scene.c_str(), grid.c_str(), MASU_CPU, &tracer));
  const std::vector<masu_ray> rays = random_rays(engine_, 4);
  Found found(rays.size());
  const masu_hits hits = found.hits(), nothing{};
  masu_query query{};
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
    query = {};
    std::memcpy(&query.format, &wrong, sizeof wrong);
    EXPECT_EQ(masu_nearest(tracer, rays.data(), 4, &query, &hits), MASU_ERROR_USAGE);
    query = {};
    std::memcpy(&query.precision, &wrong, sizeof wrong);
    EXPECT_EQ(masu_nearest(tracer, rays.data(), 4, &query, &hits), MASU_ERROR_USAGE);
  }
  ASSERT_DONE(masu_nearest(tracer, rays.data(), 4, nullptr, &nothing));
  ASSERT_DONE(masu_nearest(tracer, nullptr, 0, nullptr, &nothing));
  masu_close(tracer);
  masu_close(nullptr);

  const std::string out = file("out");
  const auto written_with = [&](const auto& change) {
    masu_mesh bad = mesh.view();
    change(bad);
    return masu_write_scene(out.c_str(), &bad, 1, MASU_STORE_AUTO, nullptr);
  };
  Mesh infinite = mesh;
  infinite.vertices[4] = infinity;
  EXPECT_EQ(written_with([](masu_mesh& bad) { bad.vertex_count -= 1; }), MASU_ERROR_USAGE);
  EXPECT_EQ(written_with([](masu_mesh& bad) { bad.indices = nullptr; }), MASU_ERROR_USAGE);
  EXPECT_EQ(written_with([](masu_mesh& bad) { bad.vertices = nullptr; }), MASU_ERROR_USAGE);
  EXPECT_EQ(written_with([&](masu_mesh& bad) { bad = infinite.view(); }), MASU_ERROR_USAGE);
  const masu_mesh good = mesh.view();
  EXPECT_EQ(masu_write_scene(nullptr, &good, 1, MASU_STORE_AUTO, nullptr), MASU_ERROR_USAGE);
  EXPECT_EQ(masu_write_scene(out.c_str(), nullptr, 1, MASU_STORE_AUTO, nullptr), MASU_ERROR_USAGE);
  EXPECT_EQ(masu_write_scene(file("no/folder").c_str(), &good, 1, MASU_STORE_AUTO, nullptr),
            MASU_ERROR_OUTPUT);

  masu_grid_options options;
  const auto built_with = [&](const auto& change) {
    masu_default_grid_options(&options);
    change();
    return masu_build_grid(scene.c_str(), out.c_str(), &options);
  };
  EXPECT_EQ(built_with([] {}), MASU_OK) << masu_error();
  EXPECT_EQ(built_with([&] { options.division = "0"; }), MASU_ERROR_USAGE);
  EXPECT_EQ(built_with([&] { options.division = "what"; }), MASU_ERROR_USAGE);
  EXPECT_EQ(built_with([&] { options.alpha = std::nan(""); }), MASU_ERROR_USAGE);
  EXPECT_EQ(built_with([&] { options.nested = 16; }), MASU_ERROR_USAGE);
  EXPECT_EQ(built_with([&] { options.threads = -1; }), MASU_ERROR_USAGE);
  EXPECT_EQ(masu_build_grid(file("missing").c_str(), out.c_str(), nullptr), MASU_ERROR_INPUT);
  EXPECT_EQ(masu_build_grid(scene.c_str(), file("no/folder").c_str(), nullptr), MASU_ERROR_OUTPUT);
  int count = -1;
  EXPECT_EQ(masu_gpu_count(nullptr), MASU_ERROR_USAGE);
  EXPECT_EQ(masu_gpu_count(&count), MASU_OK);
  EXPECT_GE(count, 0);
  masu_default_grid_options(nullptr);
}

// Container (tests/scene/container_test.cpp) has each byte and length.
TEST_F(Library, DamagedFilesAreErrors) {
  prepare(random_mesh(engine_, 100));
  for (const std::string name : {"scene", "grid"}) {
    const masu::Bytes whole = masu::read_bytes(file(name.c_str()));
    for (int round = 0; round < 20; ++round) {
      masu::Bytes damaged = whole;
      damaged[engine_() % damaged.size()] ^= static_cast<std::uint8_t>(1U << engine_() % 8);
      if (round % 4 == 0) damaged.resize(engine_() % damaged.size());
      masu::write_bytes(file("damaged"), damaged);
      masu_tracer* tracer = nullptr;
      EXPECT_EQ(masu_open(file(name == "scene" ? "damaged" : "scene").c_str(),
                          file(name == "grid" ? "damaged" : "grid").c_str(), MASU_CPU, &tracer),
                MASU_ERROR_INPUT);
      EXPECT_EQ(tracer, nullptr);
    }
  }
}

} // namespace
