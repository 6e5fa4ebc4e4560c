// The C interface with memory of a GPU: the CPU's bits, on any stream, by threads at the same time.
#include "tests/api/device_array.h"
#include "tests/api/found.h"
#include "tests/api/random_arrays.h"
#include "tests/temporary_folder.h"

#include <cuda.h>
#include <dlfcn.h>
#include <tbb/parallel_for.h>

#include <cmath>
#include <cstring>
#include <numeric>
#include <optional>
#include <thread>

namespace {

using namespace masu;

class LibraryOnGpu : public RandomArrays {
protected:
  void SetUp() override {
    int count = 0;
    ASSERT_DONE(masu_gpu_count(&count));
    if (count == 0) GTEST_SKIP() << "there is no GPU";
    scene_.emplace(random_mesh(3000, 0.1F).scene());
    grid_.emplace(*scene_);
    cpu_.emplace(*scene_, *grid_);
    gpu_.emplace(opened({0}));
  }

  Tracer opened(const std::vector<int>& gpus) const { return {*scene_, &*grid_, gpus}; }
  static masu_build_options on_gpu() {
    masu_build_options options = default_build_options();
    options.device = 0;
    return options;
  }

  // far: most of them miss.
  std::vector<masu_ray> rays(std::size_t count, bool far = false) {
    std::vector<masu_ray> rays = random_rays(count, far ? 20.0F : 2.0F);
    for (masu_ray& ray : rays)
      if (engine_() % 100 == 0) ray.direction[engine_() % 3] = not_a_number;
    return rays;
  }

  // `rays` in device memory; the stream is waited for, and nothing else.
  static Found on_device(const Tracer& tracer, const void* rays, std::size_t n,
                         masu_query query = sized<masu_query>()) {
    FoundIn<Device> found(n);
    found.find(tracer.get(), rays, n, query);
    EXPECT_EQ(cudaStreamSynchronize(static_cast<cudaStream_t>(query.stream)), cudaSuccess);
    Found copy(0);
    copy.t = found.t.host();
    copy.uv = found.uv.host();
    copy.normal = found.normal.host();
    copy.shading = found.shading.host();
    copy.position = found.position.host();
    copy.primitive = found.primitive.host();
    copy.object = found.object.host();
    copy.face = found.face.host();
    copy.occluded = found.occluded.host();
    return copy;
  }

  std::optional<Scene> scene_;
  std::optional<Grid> grid_;
  std::optional<Tracer> cpu_, gpu_;
};

Bytes bytes_of(const Grid& grid) {
  const TemporaryFolder folder;
  grid.write(folder.file("grid"));
  return read_bytes(folder.file("grid"));
}

template <template <class...> class Array>
struct ListsIn {
  Array<double> t;
  Array<std::uint32_t> primitive, counts, all;
  Array<std::uint8_t> front, inside;

  ListsIn(std::size_t n, std::size_t limit)
      : t(limit * n), primitive(limit * n), counts(n), all(n), front(limit * n), inside(n) {}
  bool operator==(const ListsIn&) const = default;
};

// With excluded primitives, in host memory and in the GPU's.
TEST_F(LibraryOnGpu, ListsTheCpusHits) {
  const std::size_t n = 300'000;
  constexpr std::uint32_t limit = 3;
  const std::vector<masu_ray> list = rays(n);
  std::vector<std::uint32_t> exclude(n);
  for (std::uint32_t& primitive : exclude)
    primitive = static_cast<std::uint32_t>(engine_() % 3001) - 1;
  const Device<masu_ray> on_gpu(list);
  const Device<std::uint32_t> excluded(exclude);
  const auto trace = [&](const Tracer& tracer, const masu_ray* from, const std::uint32_t* without,
                         auto& lists) {
    const QueryOptions options{.exclude = without};
    auto hits = sized<masu_hits>();
    hits.t64 = lists.t.data();
    hits.primitive = lists.primitive.data();
    hits.front = lists.front.data();
    tracer.all_hits(from, n, limit, hits, lists.counts.data(), options);
    tracer.count_hits(from, n, lists.all.data(), options);
    tracer.inside(from, n, lists.inside.data(), options);
  };
  ListsIn<std::vector> expected(n, limit), found(n, limit);
  trace(*cpu_, list.data(), exclude.data(), expected);
  trace(*gpu_, list.data(), exclude.data(), found);
  EXPECT_TRUE(found == expected);
  ListsIn<Device> there(n, limit);
  trace(*gpu_, on_gpu.data(), excluded.data(), there);
  EXPECT_EQ(cudaStreamSynchronize(nullptr), cudaSuccess);
  EXPECT_EQ(there.t.host(), expected.t);
  EXPECT_EQ(there.primitive.host(), expected.primitive);
  EXPECT_EQ(there.counts.host(), expected.counts);
  EXPECT_EQ(there.all.host(), expected.all);
  EXPECT_EQ(there.front.host(), expected.front);
  EXPECT_EQ(there.inside.host(), expected.inside);
}

template <template <class...> class Array>
struct ClosestIn {
  Array<float> t, uv, normal, shading;
  Array<std::uint64_t> t64, position; // bits
  Array<std::uint32_t> primitive, object, face;

  explicit ClosestIn(std::size_t n)
      : t(n), uv(2 * n), normal(3 * n), shading(3 * n), t64(n), position(3 * n), primitive(n), object(n),
        face(n) {}
  masu_hits hits() {
    return {sizeof(masu_hits), t.data(),      primitive.data(), object.data(),
            uv.data(),         normal.data(), face.data(),      reinterpret_cast<double*>(t64.data()),
            nullptr,           nullptr,       shading.data()};
  }
  bool operator==(const ClosestIn&) const = default;
};

// In host memory, few and more than a piece, and in the GPU's; of floats and doubles, with and without
// filters, through a hierarchy, a grid and neither, and after an update.
TEST_F(LibraryOnGpu, FindsTheCpusClosestPoints) {
  const auto find = [](const Tracer& tracer, const void* places, std::size_t n, const masu_query& query,
                       auto& found) {
    const masu_hits hits = found.hits();
    EXPECT_EQ(masu_closest(tracer.get(), places, n, &query, &hits,
                           reinterpret_cast<double*>(found.position.data())),
              MASU_OK)
        << masu_error();
  };
  const auto in_host = [&](const Tracer& tracer, const void* places, std::size_t n, const masu_query& query) {
    ClosestIn<std::vector> found(n);
    find(tracer, places, n, query, found);
    return found;
  };
  const auto on_gpu = [&](const Tracer& tracer, const void* places, std::size_t n, const masu_query& query) {
    ClosestIn<Device> found(n);
    find(tracer, places, n, query, found);
    EXPECT_EQ(cudaStreamSynchronize(static_cast<cudaStream_t>(query.stream)), cudaSuccess);
    ClosestIn<std::vector> copy(0);
    copy.t = found.t.host();
    copy.uv = found.uv.host();
    copy.normal = found.normal.host();
    copy.shading = found.shading.host();
    copy.t64 = found.t64.host();
    copy.position = found.position.host();
    copy.primitive = found.primitive.host();
    copy.object = found.object.host();
    copy.face = found.face.host();
    return copy;
  };
  // Away from zero, with spheres and a cone.
  ArrayMesh arrays = random_mesh(3000, 0.1F);
  for (float& v : arrays.vertices)
    v += 1000;
  std::vector<float> quadrics(4 * 100 + 8);
  for (std::size_t i = 0; i < quadrics.size(); ++i)
    quadrics[i] = i < 400 && i % 4 == 3 ? 0.1F : 1000 + coordinate();
  quadrics[403] = quadrics[407] = 0.05F;
  const std::array meshes{arrays.view()};
  const auto spheres = quadrics_of(quadrics, 100), cone = quadrics_of(std::span(quadrics).subspan(400));
  cudaStream_t stream = nullptr;
  ASSERT_CUDA(cudaStreamCreateWithFlags(&stream, cudaStreamNonBlocking));
  for (const auto store : {MASU_STORE_FLOAT32, MASU_STORE_FLOAT64}) {
    auto geometry = geometry_of(meshes);
    geometry.spheres = &spheres;
    geometry.sphere_count = 1;
    geometry.cones = &cone;
    geometry.cone_count = 1;
    geometry.store = store;
    const Scene scene(geometry);
    Tracer cpu(scene), gpu(scene, 0);
    const Grid grid = built(scene, MASU_STRUCTURE_GRID);
    const int first = 0;
    const Tracer by_grid(scene, grid, 0), brute_force(scene, nullptr, {&first, 1}, true);
    const auto compare = [&](std::size_t n, bool others) {
      std::vector<double> places64;
      std::vector<std::uint32_t> exclude(n), masks(n);
      for (std::size_t i = 0; i < n; ++i) {
        for (int axis = 0; axis < 3; ++axis)
          places64.push_back(static_cast<double>(1000 + 3 * coordinate()));
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
        auto query = sized<masu_query>();
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
          const ClosestIn<std::vector> expected = in_host(cpu, list, n, query);
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
    for (float& v : arrays.vertices)
      v += 0.05F * coordinate();
    cpu.update(arrays.vertices);
    gpu.update(arrays.vertices);
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
    value = coordinate();
  std::vector<std::uint32_t> indices(rows);
  for (std::uint32_t& index : indices)
    index = static_cast<std::uint32_t>(engine_() % (rows + 10)); // some aren't rows
  const Device<float> device_values(values), uv(found.uv), on_gpu(n * width);
  const Device<std::uint32_t> device_indices(indices), primitive(found.primitive);
  for (const int kind : {0, 1, 2}) {
    auto of = sized<masu_values>();
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
    EXPECT_TRUE(on_gpu.host() == expected);
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
        auto query = sized<masu_query>();
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
  std::vector<float> shifted(1 + 8 * count);
  std::memcpy(shifted.data() + 1, list.data(), count * sizeof(masu_ray));
  const Device<float> device_shifted(shifted);
  const Found expected = found_by(*cpu_, list);
  expect_same(expected, on_device(*gpu_, device_shifted.data() + 1, count));
  in_every_format(list, [&](const auto& rays_of_format, masu_ray_format format) {
    auto query = sized<masu_query>();
    query.format = format;
    const Found found = found_by(cpu_->get(), rays_of_format.data(), count, query);
    const Device device(rays_of_format);
    expect_same(found, on_device(*gpu_, device.data(), count, query));
    if (format == MASU_RAYS_FLOAT32 || format == MASU_RAYS_FLOAT64) expect_same(found, expected);
  });
}

// On any GPU, and the caller's current one stays that.
TEST_F(LibraryOnGpu, WithoutAGridBuildsOneForTheDevice) {
  int count = 0, before = 0, after = 0;
  ASSERT_DONE(masu_gpu_count(&count));
  const int last = count - 1;
  ASSERT_CUDA(cudaGetDevice(&before));
  const Tracer cpu(*scene_), gpu(*scene_, last), brute_force(*scene_, nullptr, {&last, 1}, true);
  ASSERT_CUDA(cudaGetDevice(&after));
  EXPECT_EQ(after, before);
  const std::vector<masu_ray> list = rays(10'000);
  const Found expected = found_by(*cpu_, list);
  for (const Tracer* const tracer : {&cpu, &gpu, &brute_force})
    expect_same(expected, found_by(*tracer, list));
  const std::vector<int> twice{last, last};
  expect_same(expected, found_by(Tracer(*scene_, nullptr, twice), list));
  EXPECT_EQ(bytes_of(gpu.grid()), bytes_of(cpu.grid()));
}

TEST_F(LibraryOnGpu, AnswersThreadsTracersAndStreamsAtTheSameTime) {
  const Tracer other = opened({0});
  const std::size_t count = 400'000;
  const std::vector<masu_ray> list = rays(count, true);
  const Device<masu_ray> device(list);
  const Found expected = found_by(*cpu_, list);
  std::vector<std::jthread> threads;
  for (int k = 0; k < 6; ++k) {
    threads.emplace_back([&, k] {
      cudaStream_t stream = nullptr;
      ASSERT_CUDA(cudaStreamCreateWithFlags(&stream, cudaStreamNonBlocking));
      auto query = sized<masu_query>();
      query.stream = stream;
      const Tracer& tracer = k % 2 == 0 ? *gpu_ : other;
      for (int round = 0; round < 5; ++round)
        expect_same(expected,
                    k % 3 == 0 ? found_by(tracer, list) : on_device(tracer, device.data(), count, query));
      ASSERT_CUDA(cudaStreamDestroy(stream));
    });
  }
}

TEST_F(LibraryOnGpu, RefusesMemoryOfTwoKinds) {
  std::vector<masu_ray> list = rays(10);
  const Device<masu_ray> device(list);
  const Device<float> t(10);
  std::vector<float> host_t(10);
  auto hits = sized<masu_hits>();
  hits.t = host_t.data();
  const auto expect_refused = [&](const std::optional<Tracer>& tracer, const void* from) {
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
  auto hits = sized<masu_hits>();
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
  const ArrayMesh arrays = random_mesh(100);
  const Device<float> on_gpu_vertices(arrays.vertices);
  const Device<std::uint32_t> on_gpu_indices(arrays.indices);
  masu_mesh mesh = arrays.view();
  const TemporaryFolder folder;
  const auto bytes = [&] {
    Scene({&mesh, 1}).write(folder.file("scene"));
    return read_bytes(folder.file("scene"));
  };
  const Bytes expected = bytes();
  mesh.vertices = on_gpu_vertices.data();
  EXPECT_EQ(bytes(), expected);
  mesh.indices = on_gpu_indices.data();
  EXPECT_EQ(bytes(), expected);
  mesh.triangle_count = std::size_t{1} << 60;
  EXPECT_THROW(bytes(), Exception);
}

// From vertices in host memory and the GPU's, written on a stream that is still busy; also a triangle that
// gets an area, and with it a new hierarchy.
TEST_F(LibraryOnGpu, AnUpdatedTracerFindsTheCpusBits) {
  for (const auto store : {MASU_STORE_FLOAT32, MASU_STORE_FLOAT64}) {
    ArrayMesh arrays = random_mesh(20'000, 0.05F);
    auto& [vertices, indices] = arrays;
    for (std::size_t i = 0; i < indices.size(); ++i)
      indices[i] = static_cast<std::uint32_t>(engine_() % 100 == 0 ? engine_() % indices.size() : i);
    indices[0] = indices[1] = indices[2];
    std::copy_n(vertices.begin() + 9, 3, vertices.begin() + 12); // triangle 1 has no area at first
    indices[3] = 3, indices[4] = 4, indices[5] = 5;
    const std::array meshes{arrays.view()};
    auto geometry = geometry_of(meshes);
    geometry.store = store;
    const Scene scene(geometry);
    auto options = default_build_options();
    options.structure = MASU_STRUCTURE_BVH;
    options.quality = engine_() % 2 == 0 ? MASU_QUALITY_FAST : MASU_QUALITY_HIGH;
    const Grid grid(scene, options);
    options.device = 0; // which makes the triangles itself
    EXPECT_EQ(bytes_of(Grid(Scene(geometry), options)), bytes_of(grid));
    const bool is_built = engine_() % 2 == 0; // by the tracer, on the GPU
    Tracer cpu(scene, grid), gpu = is_built ? Tracer(scene, 0) : Tracer(scene, grid, 0);
    const Bytes before = is_built ? bytes_of(Tracer(scene).grid()) : bytes_of(grid);
    const std::vector<masu_ray> list = rays(100'000);
    const Device<masu_ray> device(list);
    cudaStream_t stream = nullptr;
    ASSERT_CUDA(cudaStreamCreateWithFlags(&stream, cudaStreamNonBlocking));
    for (int round = 0; round < 6; ++round) {
      for (std::size_t i = 0; i < vertices.size(); ++i)
        if (round == 4 || i < 9 || i >= 15) vertices[i] += 0.02F * coordinate();
      const std::vector<double> doubles(vertices.begin(), vertices.end());
      cpu.update(vertices);
      if (round % 3 == 0) {
        gpu.update(doubles);
      } else {
        const Device<float> on_gpu(vertices.size());
        ASSERT_CUDA(cudaMemcpyAsync(on_gpu.data(), vertices.data(), vertices.size() * sizeof(float),
                                    cudaMemcpyHostToDevice, stream));
        auto moved = moved_to(vertices);
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
    EXPECT_THROW(gpu.update(vertices), Exception);
    expect_same(found_by(cpu, list), on_device(gpu, device.data(), list.size()));
    ASSERT_CUDA(cudaStreamDestroy(stream));
  }
}

// While threads query it, from host memory and on streams: each query is of one of the positions.
TEST_F(LibraryOnGpu, IsUpdatedWhileOthersQueryIt) {
  const ArrayMesh arrays = random_mesh(5000);
  const std::vector<float>& first = arrays.vertices;
  std::vector<float> second = first;
  for (float& v : second)
    v += 0.25F;
  const Scene scene = arrays.scene();
  Tracer tracer(scene, hierarchy_of(scene), 0);
  const std::vector<masu_ray> list = rays(300'000);
  const Device<masu_ray> device(list);
  const Found of_first = found_by(tracer, list);
  tracer.update(second);
  const Found of_second = found_by(tracer, list);
  std::vector<std::jthread> threads;
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
        auto hits = sized<masu_hits>();
        hits.t = t.data();
        hits.primitive = primitive.data();
        tracer.nearest(device.data(), list.size(), hits, {.stream = stream});
        ASSERT_CUDA(cudaStreamSynchronize(stream));
        const auto found = t.host();
        EXPECT_TRUE(found == of_first.t || found == of_second.t);
        EXPECT_EQ(primitive.host(), found == of_first.t ? of_first.primitive : of_second.primitive);
      }
      ASSERT_CUDA(cudaStreamDestroy(stream));
    });
  }
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
  auto hits = sized<masu_hits>();
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
    const Tracer tracer = opened({0});
    found_by(tracer, rays(100'000));
    const Grid grid(*scene_, on_gpu());
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
    const Tracer tracer = opened({0});
    expect_same(expected, found_by(tracer, list));
    const Grid grid(*scene_, on_gpu());
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
    std::optional<Tracer> tracer(opened({0}));
    EXPECT_TRUE(has_none()) << "a tracer is opened";
    expect_same(expected, found_by(*tracer, list));
    EXPECT_TRUE(has_none()) << "rays are traced";
    tracer.reset();
    EXPECT_TRUE(has_none()) << "a tracer is closed";
    const Grid grid(*scene_, on_gpu());
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
    const Tracer tracer = opened({1});
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
    const Tracer tracer = opened({0});
    tbb::parallel_for(0, 64, [&](int) { expect_same(expected, found_by(tracer, list)); });
  }
}

TEST_F(LibraryOnGpu, FindsTheSameOnSeveralGpus) {
  int count = 0;
  ASSERT_DONE(masu_gpu_count(&count));
  std::vector<int> all(static_cast<std::size_t>(count));
  std::iota(all.begin(), all.end(), 0);
  const std::vector<masu_ray> list = rays(2'500'000); // several pieces
  const Found expected = found_by(*gpu_, list);
  for (const std::vector<int>& gpus : {std::vector<int>{0, 0}, all}) {
    const Tracer several = opened(gpus);
    expect_same(expected, found_by(several, list));
    // Rays on any of its GPUs are traced there.
    const std::size_t some = 1000;
    for (const int gpu : gpus) {
      ASSERT_CUDA(cudaSetDevice(gpu));
      const Device<masu_ray> device(std::vector<masu_ray>(list.begin(), list.begin() + some));
      const Device<float> t(some);
      auto hits = sized<masu_hits>();
      hits.t = t.data();
      several.nearest(device.data(), some, hits);
      ASSERT_CUDA(cudaDeviceSynchronize());
      EXPECT_EQ(t.host(), std::vector<float>(expected.t.begin(), expected.t.begin() + some)) << gpu;
    }
    ASSERT_CUDA(cudaSetDevice(0));
  }
  refused([&] { opened({0, count}); }, MASU_ERROR_DEVICE);
}

} // namespace
