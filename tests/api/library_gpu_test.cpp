// The C interface with memory of a GPU: the CPU's bits, on any stream, by threads at the same time.
#include "tests/api/found.h"
#include "tests/seeded_test.h"
#include "tests/temporary_folder.h"

#include <masu/masu.hpp>

#include <gtest/gtest.h>

#include <cuda.h>
#include <cuda_runtime.h>
#include <dlfcn.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <random>
#include <thread>
#include <vector>

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

#define ASSERT_CUDA(call) ASSERT_EQ(call, cudaSuccess)

// Device memory of so many elements.
template <class T>
class Device {
public:
  explicit Device(std::size_t count) { EXPECT_EQ(cudaMalloc(&data_, count * sizeof(T)), cudaSuccess); }
  explicit Device(const std::vector<T>& host) : Device(host.size()) {
    EXPECT_EQ(cudaMemcpy(data_, host.data(), host.size() * sizeof(T), cudaMemcpyHostToDevice), cudaSuccess);
  }
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;
  ~Device() { static_cast<void>(cudaFree(data_)); }
  T* data() const { return data_; }
  std::vector<T> host(std::size_t count) const {
    std::vector<T> copy(count);
    EXPECT_EQ(cudaMemcpy(copy.data(), data_, count * sizeof(T), cudaMemcpyDeviceToHost), cudaSuccess);
    return copy;
  }

private:
  T* data_ = nullptr;
};

class LibraryOnGpu : public masu::SeededTest {
protected:
  void SetUp() override {
    int count = 0;
    ASSERT_DONE(masu_gpu_count(&count));
    if (count == 0) GTEST_SKIP() << "there is no GPU";
    std::uniform_real_distribution<float> coordinate(-1, 1);
    std::vector<float> vertices;
    std::vector<std::uint32_t> indices;
    for (std::uint32_t i = 0; i < 3 * 3000; ++i) {
      if (i % 3 == 0)
        for (float& c : center_)
          c = coordinate(engine_);
      for (const float c : center_)
        vertices.push_back(c + 0.1F * coordinate(engine_));
      indices.push_back(i);
    }
    scene_.emplace(vertices, indices);
    grid_.emplace(*scene_);
    cpu_.emplace(*scene_, *grid_);
    gpu_.emplace(opened({0}));
  }

  masu::Tracer opened(const std::vector<int>& gpus) const { return {*scene_, &*grid_, gpus}; }
  static masu_build_options on_gpu() {
    masu_build_options options = masu::default_build_options();
    options.device = 0;
    return options;
  }

  // far: most of them miss.
  std::vector<masu_ray> rays(std::size_t count, bool far = false) {
    std::uniform_real_distribution<float> coordinate(-1, 1);
    std::vector<masu_ray> rays(count);
    for (masu_ray& ray : rays) {
      for (int axis = 0; axis < 3; ++axis) {
        ray.origin[axis] = (far ? 20.0F : 2.0F) * coordinate(engine_);
        ray.direction[axis] = coordinate(engine_);
      }
      ray.tmin = engine_() % 4 == 0 ? 0.5F : 0;
      ray.tmax = engine_() % 2 == 0 ? infinity : 1 + coordinate(engine_);
      if (engine_() % 100 == 0) ray.direction[engine_() % 3] = std::nanf("");
    }
    return rays;
  }

  // `rays` in device memory; the stream is waited for, and nothing else.
  static Found on_device(const masu::Tracer& tracer, const void* rays, std::size_t n,
                         masu_query query = masu::sized<masu_query>()) {
    FoundIn<Device> found(n);
    found.find(tracer.get(), rays, n, query);
    EXPECT_EQ(cudaStreamSynchronize(static_cast<cudaStream_t>(query.stream)), cudaSuccess);
    Found copy(0);
    copy.t = found.t.host(n);
    copy.uv = found.uv.host(2 * n);
    copy.normal = found.normal.host(3 * n);
    copy.shading = found.shading.host(3 * n);
    copy.position = found.position.host(3 * n);
    copy.primitive = found.primitive.host(n);
    copy.object = found.object.host(n);
    copy.face = found.face.host(n);
    copy.occluded = found.occluded.host(n);
    return copy;
  }

  std::mt19937_64 engine_{seed_.value()};
  float center_[3]{};
  std::optional<masu::Scene> scene_;
  std::optional<masu::Grid> grid_;
  std::optional<masu::Tracer> cpu_, gpu_;
};

masu::Bytes bytes_of(const masu::Grid& grid) {
  const masu::TemporaryFolder folder;
  grid.write(folder.file("grid"));
  return masu::read_bytes(folder.file("grid"));
}

// With excluded primitives, in host memory and in the GPU's.
TEST_F(LibraryOnGpu, ListsTheCpusHits) {
  const std::size_t n = 300'000;
  constexpr std::uint32_t limit = 3;
  const std::vector<masu_ray> list = rays(n);
  std::vector<std::uint32_t> exclude(n);
  for (std::uint32_t& primitive : exclude)
    primitive = static_cast<std::uint32_t>(engine_() % 3001) - 1;
  struct Lists {
    std::vector<double> t;
    std::vector<std::uint32_t> primitive, counts, all;
    std::vector<std::uint8_t> front, inside;
    bool operator==(const Lists&) const = default;
  };
  const auto trace = [&](const masu::Tracer& tracer, const masu_ray* from, const std::uint32_t* excluded,
                         double* t, std::uint32_t* primitive, std::uint8_t* front, std::uint32_t* counts,
                         std::uint32_t* all, std::uint8_t* inside) {
    const masu::QueryOptions options{.exclude = excluded};
    auto hits = masu::sized<masu_hits>();
    hits.t64 = t;
    hits.primitive = primitive;
    hits.front = front;
    tracer.all_hits(from, n, limit, hits, counts, options);
    tracer.count_hits(from, n, all, options);
    tracer.inside(from, n, inside, options);
  };
  const auto in_host = [&](const masu::Tracer& tracer) {
    Lists lists{std::vector<double>(limit * n),       std::vector<std::uint32_t>(limit * n),
                std::vector<std::uint32_t>(n),        std::vector<std::uint32_t>(n),
                std::vector<std::uint8_t>(limit * n), std::vector<std::uint8_t>(n)};
    trace(tracer, list.data(), exclude.data(), lists.t.data(), lists.primitive.data(), lists.front.data(),
          lists.counts.data(), lists.all.data(), lists.inside.data());
    return lists;
  };
  const Lists expected = in_host(*cpu_);
  EXPECT_TRUE(in_host(*gpu_) == expected);
  const Device<masu_ray> on_gpu(list);
  const Device<std::uint32_t> excluded(exclude), primitive(limit * n), counts(n), all(n);
  const Device<double> t(limit * n);
  const Device<std::uint8_t> front(limit * n), inside(n);
  trace(*gpu_, on_gpu.data(), excluded.data(), t.data(), primitive.data(), front.data(), counts.data(),
        all.data(), inside.data());
  EXPECT_EQ(cudaStreamSynchronize(nullptr), cudaSuccess);
  EXPECT_TRUE((Lists{t.host(limit * n), primitive.host(limit * n), counts.host(n), all.host(n),
                     front.host(limit * n), inside.host(n)} == expected));
}

// In host memory, few and more than a piece, and in the GPU's; of floats and doubles, with and without
// filters, through a hierarchy, a grid and neither, and after an update.
TEST_F(LibraryOnGpu, FindsTheCpusClosestPoints) {
  struct Closest {
    std::vector<float> t, uv, normal, shading;
    std::vector<std::uint64_t> t64, position; // bits
    std::vector<std::uint32_t> primitive, object, face;
    bool operator==(const Closest&) const = default;
  };
  const auto find = [](const masu::Tracer& tracer, const void* places, std::size_t n, const masu_query& query,
                       auto& t, auto& uv, auto& normal, auto& shading, auto& t64, auto& position,
                       auto& primitive, auto& object, auto& face) {
    const masu_hits hits{sizeof hits, t.data(),      primitive.data(), object.data(),
                         uv.data(),   normal.data(), face.data(),      reinterpret_cast<double*>(t64.data()),
                         nullptr,     nullptr,       shading.data()};
    EXPECT_EQ(
        masu_closest(tracer.get(), places, n, &query, &hits, reinterpret_cast<double*>(position.data())),
        MASU_OK)
        << masu_error();
  };
  const auto in_host = [&](const masu::Tracer& tracer, const void* places, std::size_t n,
                           const masu_query& query) {
    Closest c{std::vector<float>(n),         std::vector<float>(2 * n),     std::vector<float>(3 * n),
              std::vector<float>(3 * n),     std::vector<std::uint64_t>(n), std::vector<std::uint64_t>(3 * n),
              std::vector<std::uint32_t>(n), std::vector<std::uint32_t>(n), std::vector<std::uint32_t>(n)};
    find(tracer, places, n, query, c.t, c.uv, c.normal, c.shading, c.t64, c.position, c.primitive, c.object,
         c.face);
    return c;
  };
  const auto on_gpu = [&](const masu::Tracer& tracer, const void* places, std::size_t n,
                          const masu_query& query) {
    const Device<float> t(n), uv(2 * n), normal(3 * n), shading(3 * n);
    const Device<std::uint64_t> t64(n), position(3 * n);
    const Device<std::uint32_t> primitive(n), object(n), face(n);
    find(tracer, places, n, query, t, uv, normal, shading, t64, position, primitive, object, face);
    EXPECT_EQ(cudaStreamSynchronize(static_cast<cudaStream_t>(query.stream)), cudaSuccess);
    return Closest{t.host(n),           uv.host(2 * n), normal.host(3 * n),
                   shading.host(3 * n), t64.host(n),    position.host(3 * n),
                   primitive.host(n),   object.host(n), face.host(n)};
  };
  // Away from zero, with spheres and a cone.
  std::uniform_real_distribution<float> coordinate(-1, 1);
  std::vector<float> vertices(9 * 3000), quadrics(4 * 100 + 8);
  for (std::size_t i = 0; i < vertices.size(); ++i)
    vertices[i] = i % 9 < 3 ? 1000 + coordinate(engine_) : vertices[i - 3] + 0.1F * coordinate(engine_);
  for (std::size_t i = 0; i < quadrics.size(); ++i)
    quadrics[i] = i < 400 && i % 4 == 3 ? 0.1F : 1000 + coordinate(engine_);
  quadrics[403] = quadrics[407] = 0.05F;
  std::vector<std::uint32_t> indices(vertices.size() / 3);
  std::iota(indices.begin(), indices.end(), 0U);
  const masu_mesh mesh = masu::mesh(vertices, indices);
  auto spheres = masu::sized<masu_quadrics>(), cone = spheres;
  spheres.values = quadrics.data();
  spheres.count = 100;
  cone.values = quadrics.data() + 400;
  cone.count = 1;
  cudaStream_t stream = nullptr;
  ASSERT_CUDA(cudaStreamCreateWithFlags(&stream, cudaStreamNonBlocking));
  for (const auto store : {MASU_STORE_FLOAT32, MASU_STORE_FLOAT64}) {
    auto geometry = masu::sized<masu_geometry>();
    geometry.meshes = &mesh;
    geometry.mesh_count = 1;
    geometry.spheres = &spheres;
    geometry.sphere_count = 1;
    geometry.cones = &cone;
    geometry.cone_count = 1;
    geometry.store = store;
    const masu::Scene scene(geometry);
    masu::Tracer cpu(scene), gpu(scene, 0);
    masu_build_options grid_options = masu::default_build_options();
    grid_options.structure = MASU_STRUCTURE_GRID;
    const masu::Grid grid(scene, grid_options);
    const int first = 0;
    const masu::Tracer by_grid(scene, grid, 0), brute_force(scene, nullptr, {&first, 1}, true);
    const auto compare = [&](std::size_t n, bool others) {
      std::vector<double> places64;
      std::vector<std::uint32_t> exclude(n), masks(n);
      for (std::size_t i = 0; i < n; ++i) {
        for (int axis = 0; axis < 3; ++axis)
          places64.push_back(static_cast<double>(1000 + 3 * coordinate(engine_)));
        if (engine_() % 50 == 0) places64.back() = std::nan("");
        exclude[i] = static_cast<std::uint32_t>(engine_() % 3200);
        masks[i] = static_cast<std::uint32_t>(engine_() % 8);
      }
      const std::vector<float> places(places64.begin(), places64.end());
      const std::vector<std::uint32_t> object_masks{1, 2, 4};
      const Device<double> device64(places64);
      const Device<float> device(places);
      const Device<std::uint32_t> device_exclude(exclude), device_masks(masks), device_objects(object_masks);
      for (const bool filtered : {false, true}) {
        auto query = masu::sized<masu_query>();
        const auto filter = [&](const auto& excluded, const auto& of_objects, const auto& of_rays) {
          if (!filtered) return;
          query.exclude = excluded.data();
          query.object_masks = of_objects.data();
          query.object_count = 3;
          query.ray_masks = of_rays.data();
        };
        for (const bool is_float64 : {false, true}) {
          const void* const list = is_float64 ? static_cast<const void*>(places64.data()) : places.data();
          query.format = is_float64 ? MASU_RAYS_FLOAT64 : MASU_RAYS_FLOAT32;
          query.stream = nullptr;
          filter(exclude, object_masks, masks);
          const Closest expected = in_host(cpu, list, n, query);
          EXPECT_TRUE(in_host(gpu, list, n, query) == expected);
          if (others) {
            EXPECT_TRUE(in_host(by_grid, list, n, query) == expected);
            EXPECT_TRUE(in_host(brute_force, list, n, query) == expected);
          }
          query.stream = stream;
          filter(device_exclude, device_objects, device_masks);
          EXPECT_TRUE(on_gpu(gpu, is_float64 ? static_cast<const void*>(device64.data()) : device.data(), n,
                             query) == expected);
        }
      }
    };
    for (const std::size_t n : {std::size_t{1}, std::size_t{4096}, std::size_t{20'000}})
      compare(n, true);
    if (store == MASU_STORE_FLOAT32) compare(1'300'000, false);
    for (float& v : vertices)
      v += 0.05F * coordinate(engine_);
    cpu.update(vertices);
    gpu.update(vertices);
    compare(20'000, false);
  }
  ASSERT_CUDA(cudaStreamDestroy(stream));
}

TEST_F(LibraryOnGpu, InterpolatesTheCpusBits) {
  const std::size_t n = 100'000, width = 5, rows = 9000;
  const std::vector<masu_ray> list = rays(n);
  const Found found = found_by(*cpu_, list);
  std::vector<float> values(rows * width);
  for (float& value : values)
    value = std::uniform_real_distribution<float>(-1, 1)(engine_);
  std::vector<std::uint32_t> indices(rows);
  for (std::uint32_t& index : indices)
    index = static_cast<std::uint32_t>(engine_() % (rows + 10)); // some aren't rows
  const Device<float> device_values(values), uv(found.uv), on_gpu(n * width);
  const Device<std::uint32_t> device_indices(indices), primitive(found.primitive);
  for (const int kind : {0, 1, 2}) {
    auto of = masu::sized<masu_values>();
    of.width = width;
    of.count = rows;
    of.triangle_count = 3000;
    of.per_face = kind == 2 ? 1 : 0;
    of.values = values.data();
    of.indices = kind == 0 ? indices.data() : nullptr;
    std::vector<float> expected(n * width);
    ASSERT_DONE(masu_interpolate(&of, found.primitive.data(), found.uv.data(), n, expected.data()));
    of.values = device_values.data();
    EXPECT_EQ(masu_interpolate(&of, primitive.data(), found.uv.data(), n, on_gpu.data()), MASU_ERROR_USAGE);
    of.indices = kind == 0 ? device_indices.data() : nullptr;
    ASSERT_DONE(masu_interpolate(&of, primitive.data(), uv.data(), n, on_gpu.data()));
    EXPECT_TRUE(on_gpu.host(n * width) == expected);
  }
}

// By every loop.
TEST_F(LibraryOnGpu, FindsTheCpusBits) {
  constexpr std::pair<masu_loop, int> schedules[]{{MASU_LOOP_AUTO, 0},
                                                  {MASU_LOOP_AUTO, 1},
                                                  {MASU_LOOP_THREAD_PER_RAY, 0},
                                                  {MASU_LOOP_WARP, 0},
                                                  {MASU_LOOP_WARP_REFILL, 0}};
  for (const std::size_t count : {std::size_t{1}, std::size_t{1000}, std::size_t{1'300'000}}) {
    for (const bool far : {false, true}) {
      const std::vector<masu_ray> list = rays(count, far);
      const Device<masu_ray> device(list);
      for (const auto precision : {MASU_PRECISION_ROBUST, MASU_PRECISION_DOUBLE}) {
        if (count > 1000 && precision == MASU_PRECISION_DOUBLE) continue;
        auto query = masu::sized<masu_query>();
        query.precision = precision;
        const Found expected = found_by(*cpu_, list, query);
        for (const auto& [loop, coherent] : schedules) {
          query.loop = loop;
          query.coherent = coherent;
          expect_same(expected, found_by(*gpu_, list, query));
          expect_same(expected, on_device(*gpu_, device.data(), count, query));
        }
      }
    }
  }
}

TEST_F(LibraryOnGpu, TakesEveryFormatAndAlignmentOfNumbers) {
  const std::size_t count = 5000;
  const std::vector<masu_ray> list = rays(count);
  std::vector<float> floats, shifted(1);
  std::vector<double> doubles;
  for (const masu_ray& ray : list) {
    floats.insert(floats.end(), ray.origin, ray.origin + 3);
    floats.insert(floats.end(), ray.direction, ray.direction + 3);
    shifted.insert(shifted.end(), {ray.origin[0], ray.origin[1], ray.origin[2], ray.tmin, ray.direction[0],
                                   ray.direction[1], ray.direction[2], ray.tmax});
  }
  doubles.assign(shifted.begin() + 1, shifted.end());
  auto query = masu::sized<masu_query>();
  const Device<float> device_floats(floats), device_shifted(shifted);
  const Device<double> device_doubles(doubles);
  const Found expected = found_by(*cpu_, list);
  expect_same(expected, on_device(*gpu_, device_shifted.data() + 1, count, query));
  query.format = MASU_RAYS_FLOAT64;
  expect_same(expected, on_device(*gpu_, device_doubles.data(), count, query));
  query.format = MASU_RAYS_FLOAT32_6;
  expect_same(found_by(cpu_->get(), floats.data(), count, query),
              on_device(*gpu_, device_floats.data(), count, query));
}

// On any GPU, and the caller's current one stays that.
TEST_F(LibraryOnGpu, WithoutAGridBuildsOneForTheDevice) {
  int count = 0, before = 0, after = 0;
  ASSERT_DONE(masu_gpu_count(&count));
  const int last = count - 1;
  ASSERT_CUDA(cudaGetDevice(&before));
  const masu::Tracer cpu(*scene_), gpu(*scene_, last), brute_force(*scene_, nullptr, {&last, 1}, true);
  ASSERT_CUDA(cudaGetDevice(&after));
  EXPECT_EQ(after, before);
  const std::vector<masu_ray> list = rays(10'000);
  const Found expected = found_by(*cpu_, list);
  for (const masu::Tracer* const tracer : {&cpu, &gpu, &brute_force})
    expect_same(expected, found_by(*tracer, list));
  const std::vector<int> twice{last, last};
  expect_same(expected, found_by(masu::Tracer(*scene_, nullptr, twice), list));
  EXPECT_EQ(bytes_of(gpu.grid()), bytes_of(cpu.grid()));
}

TEST_F(LibraryOnGpu, AnswersThreadsTracersAndStreamsAtTheSameTime) {
  const masu::Tracer other = opened({0});
  const std::size_t count = 400'000;
  const std::vector<masu_ray> list = rays(count, true);
  const Device<masu_ray> device(list);
  const Found expected = found_by(*cpu_, list);
  std::vector<std::thread> threads;
  for (int k = 0; k < 6; ++k) {
    threads.emplace_back([&, k] {
      cudaStream_t stream = nullptr;
      ASSERT_CUDA(cudaStreamCreateWithFlags(&stream, cudaStreamNonBlocking));
      auto query = masu::sized<masu_query>();
      query.stream = stream;
      const masu::Tracer& tracer = k % 2 == 0 ? *gpu_ : other;
      for (int round = 0; round < 5; ++round)
        expect_same(expected,
                    k % 3 == 0 ? found_by(tracer, list) : on_device(tracer, device.data(), count, query));
      ASSERT_CUDA(cudaStreamDestroy(stream));
    });
  }
  for (std::thread& thread : threads)
    thread.join();
}

TEST_F(LibraryOnGpu, RefusesMemoryOfTwoKinds) {
  std::vector<masu_ray> list = rays(10);
  const Device<masu_ray> device(list);
  const Device<float> t(10);
  std::vector<float> host_t(10);
  auto hits = masu::sized<masu_hits>();
  hits.t = host_t.data();
  const auto expect_refused = [&](const std::optional<masu::Tracer>& tracer, const void* from) {
    EXPECT_EQ(masu_nearest(tracer->get(), from, 5, nullptr, &hits), MASU_ERROR_USAGE);
  };
  expect_refused(gpu_, device.data());
  hits.t = t.data();
  expect_refused(gpu_, list.data());
  expect_refused(cpu_, device.data());
  hits.t = reinterpret_cast<float*>(reinterpret_cast<char*>(t.data()) + 2);
  expect_refused(gpu_, device.data());
  expect_refused(gpu_, reinterpret_cast<char*>(device.data()) + 1);
  EXPECT_EQ(cudaGetLastError(), cudaSuccess);
}

// In page-locked memory, in more than one piece.
TEST_F(LibraryOnGpu, StreamsListsOfAnyLength) {
  const std::vector<masu_ray> few = rays(100'000);
  std::vector<masu_ray> many;
  for (int i = 0; i < 23; ++i)
    many.insert(many.end(), few.begin(), few.end());
  const Found expected = found_by(*cpu_, few), found = found_by(*gpu_, many);
  masu_ray* locked = nullptr;
  float* t = nullptr;
  ASSERT_CUDA(cudaMallocHost(&locked, many.size() * sizeof(masu_ray)));
  ASSERT_CUDA(cudaMallocHost(&t, many.size() * sizeof(float)));
  std::copy(many.begin(), many.end(), locked);
  auto hits = masu::sized<masu_hits>();
  hits.t = t;
  gpu_->nearest(locked, many.size(), hits);
  for (std::size_t i = 0; i < many.size(); ++i) {
    ASSERT_EQ(found.t[i], expected.t[i % few.size()]) << i;
    ASSERT_EQ(t[i], expected.t[i % few.size()]) << i;
    ASSERT_EQ(found.normal[3 * i + 1], expected.normal[3 * (i % few.size()) + 1]) << i;
  }
  ASSERT_CUDA(cudaFreeHost(locked));
  ASSERT_CUDA(cudaFreeHost(t));
}

// Few are traced where they lie in page-locked memory; one more of them isn't.
TEST_F(LibraryOnGpu, ListsOfFewRaysGiveTheBitsOfTheCpu) {
  const std::vector<masu_ray> all = rays(4097);
  for (const std::size_t count : {std::size_t{1}, std::size_t{33}, all.size() - 1, all.size()}) {
    const std::vector<masu_ray> list(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(count));
    SCOPED_TRACE(count);
    expect_same(found_by(*cpu_, list), found_by(*gpu_, list));
    masu_ray* locked = nullptr;
    ASSERT_CUDA(cudaMallocHost(&locked, count * sizeof(masu_ray)));
    std::copy(list.begin(), list.end(), locked);
    std::vector<std::uint8_t> expected(count), occluded(count);
    cpu_->occluded(list.data(), count, expected.data());
    gpu_->occluded(locked, count, occluded.data());
    EXPECT_EQ(expected, occluded);
    ASSERT_CUDA(cudaFreeHost(locked));
  }
}

TEST_F(LibraryOnGpu, AScenesArraysMayLieOnTheGpu) {
  std::vector<float> vertices(9 * 100);
  for (float& v : vertices)
    v = std::uniform_real_distribution<float>(-1, 1)(engine_);
  std::vector<std::uint32_t> indices(300);
  std::iota(indices.begin(), indices.end(), 0U);
  const Device<float> on_gpu_vertices(vertices);
  const Device<std::uint32_t> on_gpu_indices(indices);
  auto mesh = masu::mesh(vertices, indices);
  const masu::TemporaryFolder folder;
  const auto bytes = [&] {
    masu::Scene({&mesh, 1}).write(folder.file("scene"));
    return masu::read_bytes(folder.file("scene"));
  };
  const masu::Bytes expected = bytes();
  mesh.vertices = on_gpu_vertices.data();
  EXPECT_EQ(bytes(), expected);
  mesh.indices = on_gpu_indices.data();
  EXPECT_EQ(bytes(), expected);
  mesh.triangle_count = std::size_t{1} << 60;
  EXPECT_THROW(bytes(), masu::Exception);
}

// From vertices in host memory and the GPU's, written on a stream that is still busy; also a triangle that
// gets an area, and with it a new hierarchy.
TEST_F(LibraryOnGpu, AnUpdatedTracerFindsTheCpusBits) {
  for (const auto store : {MASU_STORE_FLOAT32, MASU_STORE_FLOAT64}) {
    std::uniform_real_distribution<float> coordinate(-1, 1);
    std::vector<float> vertices(9 * 20'000);
    for (std::size_t i = 0; i < vertices.size(); ++i)
      vertices[i] = i % 9 < 3 ? coordinate(engine_) : vertices[i - 3] + 0.05F * coordinate(engine_);
    std::vector<std::uint32_t> indices(vertices.size() / 3);
    for (std::size_t i = 0; i < indices.size(); ++i)
      indices[i] = static_cast<std::uint32_t>(engine_() % 100 == 0 ? engine_() % indices.size() : i);
    indices[0] = indices[1] = indices[2];
    std::copy_n(vertices.begin() + 9, 3, vertices.begin() + 12); // triangle 1 has no area at first
    indices[3] = 3, indices[4] = 4, indices[5] = 5;
    const auto mesh = masu::mesh(vertices, indices);
    auto geometry = masu::sized<masu_geometry>();
    geometry.meshes = &mesh;
    geometry.mesh_count = 1;
    geometry.store = store;
    const masu::Scene scene(geometry);
    auto options = masu::default_build_options();
    options.structure = MASU_STRUCTURE_BVH;
    options.quality = engine_() % 2 == 0 ? MASU_QUALITY_FAST : MASU_QUALITY_HIGH;
    const masu::Grid grid(scene, options);
    options.device = 0; // which makes the triangles itself
    EXPECT_EQ(bytes_of(masu::Grid(masu::Scene(geometry), options)), bytes_of(grid));
    const bool is_built = engine_() % 2 == 0; // by the tracer, on the GPU
    masu::Tracer cpu(scene, grid), gpu = is_built ? masu::Tracer(scene, 0) : masu::Tracer(scene, grid, 0);
    const masu::Bytes before = is_built ? bytes_of(masu::Tracer(scene).grid()) : bytes_of(grid);
    const std::vector<masu_ray> list = rays(100'000);
    const Device<masu_ray> device(list);
    cudaStream_t stream = nullptr;
    ASSERT_CUDA(cudaStreamCreateWithFlags(&stream, cudaStreamNonBlocking));
    for (int round = 0; round < 6; ++round) {
      for (std::size_t i = 0; i < vertices.size(); ++i)
        if (round == 4 || i < 9 || i >= 15) vertices[i] += 0.02F * coordinate(engine_);
      const std::vector<double> doubles(vertices.begin(), vertices.end());
      cpu.update(vertices);
      if (round % 3 == 0) {
        gpu.update(doubles);
      } else {
        const Device<float> on_gpu(vertices.size());
        ASSERT_CUDA(cudaMemcpyAsync(on_gpu.data(), vertices.data(), vertices.size() * sizeof(float),
                                    cudaMemcpyHostToDevice, stream));
        auto moved = masu::moved_to(vertices);
        moved.values = on_gpu.data();
        moved.stream = stream;
        gpu.update(moved);
      }
      EXPECT_TRUE(round != 0 || bytes_of(gpu.grid()) == before);
      const Found expected = found_by(cpu, list);
      expect_same(expected, found_by(gpu, list));
      expect_same(expected, on_device(gpu, device.data(), list.size()));
      EXPECT_TRUE(gpu.all_hits(list, 3) == cpu.all_hits(list, 3));
      EXPECT_EQ(gpu.count_hits(list), cpu.count_hits(list));
      EXPECT_EQ(gpu.inside(list), cpu.inside(list));
    }
    vertices[17] = std::nanf("");
    EXPECT_THROW(gpu.update(vertices), masu::Exception);
    expect_same(found_by(cpu, list), on_device(gpu, device.data(), list.size()));
    ASSERT_CUDA(cudaStreamDestroy(stream));
  }
}

// While threads query it, from host memory and on streams: each query is of one of the positions.
TEST_F(LibraryOnGpu, IsUpdatedWhileOthersQueryIt) {
  std::vector<float> first(9 * 5000);
  for (float& v : first)
    v = std::uniform_real_distribution<float>(-1, 1)(engine_);
  std::vector<float> second = first;
  for (float& v : second)
    v += 0.25F;
  std::vector<std::uint32_t> indices(first.size() / 3);
  std::iota(indices.begin(), indices.end(), 0U);
  const masu::Scene scene(first, indices);
  auto options = masu::default_build_options();
  options.structure = MASU_STRUCTURE_BVH;
  masu::Tracer tracer(scene, masu::Grid(scene, options), 0);
  const std::vector<masu_ray> list = rays(300'000);
  const Device<masu_ray> device(list);
  const Found of_first = found_by(tracer, list);
  tracer.update(second);
  const Found of_second = found_by(tracer, list);
  std::vector<std::thread> threads;
  for (int k = 0; k < 5; ++k) {
    threads.emplace_back([&, k] {
      cudaStream_t stream = nullptr;
      ASSERT_CUDA(cudaStreamCreateWithFlags(&stream, cudaStreamNonBlocking));
      const Device<float> t(list.size());
      const Device<std::uint32_t> primitive(list.size());
      for (int round = 0; round < 20; ++round) {
        if (k == 0) {
          tracer.update(round % 2 == 0 ? first : second);
          continue;
        }
        auto hits = masu::sized<masu_hits>();
        hits.t = t.data();
        hits.primitive = primitive.data();
        tracer.nearest(device.data(), list.size(), hits, {.stream = stream});
        ASSERT_CUDA(cudaStreamSynchronize(stream));
        const auto found = t.host(list.size());
        EXPECT_TRUE(found == of_first.t || found == of_second.t);
        EXPECT_EQ(primitive.host(list.size()),
                  found == of_first.t ? of_first.primitive : of_second.primitive);
      }
      ASSERT_CUDA(cudaStreamDestroy(stream));
    });
  }
  for (std::thread& thread : threads)
    thread.join();
}

// Of so many that a loop is chosen for them.
TEST_F(LibraryOnGpu, LongListsHaveTheHitsOfShortOnes) {
  const std::size_t count = (std::size_t{1} << 22) + 1;
  const std::vector<masu_ray> few = rays(1 << 16);
  std::vector<masu_ray> many;
  while (many.size() < count)
    many.insert(many.end(), few.begin(), few.end());
  const Found expected = found_by(*cpu_, few);
  std::vector<float> t(count);
  auto hits = masu::sized<masu_hits>();
  hits.t = t.data();
  for (const std::size_t rays_asked : {count - 2, count - 1, count}) {
    std::fill(t.begin(), t.end(), -1.0F);
    gpu_->nearest(many.data(), rays_asked, hits);
    for (std::size_t i = 0; i < rays_asked; ++i)
      ASSERT_EQ(t[i], expected.t[i % few.size()]) << i;
  }
}

// --- A guest in the host program's process

struct PoolState {
  std::uint64_t threshold = 0, reserved = 0, used = 0;
  friend bool operator==(const PoolState&, const PoolState&) = default;
};
PoolState default_pool() {
  cudaMemPool_t pool = nullptr;
  EXPECT_EQ(cudaDeviceGetDefaultMemPool(&pool, 0), cudaSuccess);
  PoolState state;
  EXPECT_EQ(cudaMemPoolGetAttribute(pool, cudaMemPoolAttrReleaseThreshold, &state.threshold), cudaSuccess);
  EXPECT_EQ(cudaMemPoolGetAttribute(pool, cudaMemPoolAttrReservedMemCurrent, &state.reserved), cudaSuccess);
  EXPECT_EQ(cudaMemPoolGetAttribute(pool, cudaMemPoolAttrUsedMemCurrent, &state.used), cudaSuccess);
  return state;
}

TEST_F(LibraryOnGpu, LeavesTheDefaultMemoryPoolAsTheHostProgramSetIt) {
  cudaMemPool_t pool = nullptr;
  ASSERT_CUDA(cudaDeviceGetDefaultMemPool(&pool, 0));
  std::uint64_t threshold = 12'345'678;
  ASSERT_CUDA(cudaMemPoolSetAttribute(pool, cudaMemPoolAttrReleaseThreshold, &threshold));
  const PoolState before = default_pool();
  {
    const masu::Tracer tracer = opened({0});
    found_by(tracer, rays(100'000));
    const masu::Grid grid(*scene_, on_gpu());
    EXPECT_EQ(default_pool(), before);
  }
  EXPECT_EQ(default_pool(), before);
}

TEST_F(LibraryOnGpu, LeavesTheHostProgramsErrorPending) {
  const std::vector<masu_ray> list = rays(1000);
  const Found expected = found_by(*cpu_, list);
  EXPECT_NE(cudaSetDevice(-1), cudaSuccess);
  const cudaError_t pending = cudaPeekAtLastError();
  ASSERT_NE(pending, cudaSuccess);
  {
    const masu::Tracer tracer = opened({0});
    expect_same(expected, found_by(tracer, list));
    const masu::Grid grid(*scene_, on_gpu());
  }
  EXPECT_EQ(cudaGetLastError(), pending);
}

// For one without a context would open one on its own device, which the host program may never use.
TEST_F(LibraryOnGpu, LeavesThreadsWithoutAContextWithoutOne) {
  void* const driver = dlopen("libcuda.so.1", RTLD_NOW | RTLD_NOLOAD);
  ASSERT_NE(driver, nullptr) << dlerror();
  const auto get_current = reinterpret_cast<decltype(&cuCtxGetCurrent)>(dlsym(driver, "cuCtxGetCurrent"));
  ASSERT_NE(get_current, nullptr);
  const auto has_none = [&] {
    CUcontext current = nullptr;
    EXPECT_EQ(get_current(&current), CUDA_SUCCESS);
    return current == nullptr;
  };
  const std::vector<masu_ray> list = rays(3'000'000);
  const Found expected = found_by(*gpu_, list);
  std::thread([&] {
    ASSERT_TRUE(has_none()); // of its own
    int count = 0;
    ASSERT_DONE(masu_gpu_count(&count));
    EXPECT_TRUE(has_none()) << "GPUs are counted";
    std::optional<masu::Tracer> tracer(opened({0}));
    EXPECT_TRUE(has_none()) << "a tracer is opened";
    expect_same(expected, found_by(*tracer, list));
    EXPECT_TRUE(has_none()) << "rays are traced";
    tracer.reset();
    EXPECT_TRUE(has_none()) << "a tracer is closed";
    const masu::Grid grid(*scene_, on_gpu());
    EXPECT_TRUE(has_none()) << "a grid is built";
  }).join();
}

// The first GPU is number 0, whatever the caller's is; contexts are only made where something is traced.
TEST_F(LibraryOnGpu, UsesNoOtherGpuThanTheTracers) {
  int count = 0;
  ASSERT_DONE(masu_gpu_count(&count));
  if (count < 2) GTEST_SKIP() << "one GPU: there is no other";
  ASSERT_CUDA(cudaSetDevice(0));
  bool is_the_same = false;
  for (int attempt = 0; attempt < 30 && !is_the_same; ++attempt) { // other processes may use it meanwhile
    std::size_t before = 0, after = 0, all = 0;
    ASSERT_CUDA(cudaMemGetInfo(&before, &all));
    const masu::Tracer tracer = opened({1});
    found_by(tracer, rays(3'000'000));
    ASSERT_CUDA(cudaMemGetInfo(&after, &all));
    is_the_same = before == after;
  }
  EXPECT_TRUE(is_the_same);
  int current = -1;
  ASSERT_CUDA(cudaGetDevice(&current));
  EXPECT_EQ(current, 0);
}

// Tasks of the host program that ask while a loop is found out by the same threads.
TEST_F(LibraryOnGpu, IsAskedByTasksOfTheHostProgram) {
  const std::vector<masu_ray> list = rays(5000);
  const Found expected = found_by(*cpu_, list);
  for (int round = 0; round < 10; ++round) {
    const masu::Tracer tracer = opened({0});
    tbb::parallel_for(0, 64, [&](int) { expect_same(expected, found_by(tracer, list)); });
  }
}

TEST_F(LibraryOnGpu, FindsTheSameOnSeveralGpus) {
  int count = 0;
  ASSERT_DONE(masu_gpu_count(&count));
  std::vector<int> all(static_cast<std::size_t>(count));
  for (int gpu = 0; gpu < count; ++gpu)
    all[static_cast<std::size_t>(gpu)] = gpu;
  const std::vector<masu_ray> list = rays(2'500'000); // several pieces
  const Found expected = found_by(*gpu_, list);
  for (const std::vector<int>& gpus : {std::vector<int>{0, 0}, all}) {
    const masu::Tracer several = opened(gpus);
    expect_same(expected, found_by(several, list));
    // Rays on any of its GPUs are traced there.
    const std::size_t some = 1000;
    for (const int gpu : gpus) {
      ASSERT_CUDA(cudaSetDevice(gpu));
      const Device<masu_ray> device(std::vector<masu_ray>(list.begin(), list.begin() + some));
      const Device<float> t(some);
      auto hits = masu::sized<masu_hits>();
      hits.t = t.data();
      several.nearest(device.data(), some, hits);
      ASSERT_CUDA(cudaDeviceSynchronize());
      EXPECT_EQ(t.host(some), std::vector<float>(expected.t.begin(), expected.t.begin() + some)) << gpu;
    }
    ASSERT_CUDA(cudaSetDevice(0));
  }
  try {
    opened({0, count});
    FAIL();
  } catch (const masu::Exception& error) {
    EXPECT_EQ(error.status, MASU_ERROR_DEVICE);
  }
}

} // namespace
