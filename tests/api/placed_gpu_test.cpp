// Placed meshes on a GPU: the CPU's bits, of rays and transforms in either memory.
#include "tests/api/device_array.h"
#include "tests/api/placed_scene.h"
#include "tests/seeded_test.h"

namespace {

using namespace masu;

class PlacedOnGpu : public SeededTest {
protected:
  void SetUp() override {
    if (gpu_count() == 0) GTEST_SKIP() << "there is no GPU";
  }

  std::mt19937_64 engine_ = seed_.engine();
};

const auto ray_count = static_cast<std::size_t>(cases(6000));

// Of each warp nearly its first ray: they begin as a packet.
std::vector<masu_ray64> alike(std::vector<masu_ray64> rays, std::mt19937_64& engine) {
  std::uniform_real_distribution<double> factor(0.98, 1.02);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    rays[i] = rays[i / 32 * 32];
    for (double& along : rays[i].direction)
      along *= factor(engine);
  }
  return rays;
}

TEST_F(PlacedOnGpu, FindsTheCpusBits) {
  for (const PlacedKind& kind : placed_kinds()) {
    PlacedScenes scenes(engine_, kind);
    const Scene scene = scenes.placed();
    const auto rays = scenes.rays(ray_count);
    const auto places = scenes.places(100);
    for (const masu_precision precision : {MASU_PRECISION_AUTO, MASU_PRECISION_DOUBLE}) {
      SCOPED_TRACE(testing::Message() << "extent " << kind.extent << ", stretch " << kind.stretch
                                      << ", precision " << precision);
      QueryOptions options;
      options.precision = precision;
      const Tracer on_cpu(scene), on_gpu(scene, 0);
      const PlacedFound expected = found_by(on_cpu, rays, places, options, nullptr);
      expect_same(found_by(on_gpu, rays, places, options, nullptr), expected);
      QueryOptions as_packets = options;
      as_packets.loop = MASU_LOOP_THREAD_PER_RAY;
      const auto near = alike(rays, engine_);
      expect_same(found_by(on_gpu, near, {}, as_packets, nullptr),
                  found_by(on_cpu, near, {}, options, nullptr));
      if (kind.placements < 100) {
        const int gpu = 0;
        expect_same(found_by(Tracer(scene, nullptr, {&gpu, 1}, true), rays, places, options, nullptr),
                    expected);
      }
    }
  }
}

TEST_F(PlacedOnGpu, MovedOnesAreThoseOfTheCpu) {
  for (const PlacedKind& kind : placed_kinds()) {
    PlacedScenes scenes(engine_, kind);
    const Scene scene = scenes.placed();
    Tracer cpu(scene), gpu(scene, 0);
    for (const bool from_device : {false, true}) {
      const auto expect_same_found = [&] {
        const auto rays = scenes.rays(ray_count);
        const auto places = scenes.places(100);
        expect_same(found_by(gpu, rays, places, {}, nullptr), found_by(cpu, rays, places, {}, nullptr));
      };
      scenes.move();
      cpu.place(std::span<const Matrix>(scenes.transforms));
      const Device<Matrix> copy(scenes.transforms);
      auto moves = sized<masu_transforms>();
      moves.values64 = from_device ? copy.data()->data() : scenes.transforms.front().data();
      moves.count = scenes.transforms.size();
      gpu.place(moves);
      expect_same_found();
      // Some of them in float32, one of them twice: the last one counts.
      scenes.move();
      const std::vector<std::uint32_t> indices{2, 0, 2};
      std::vector<std::array<float, 12>> some(3);
      for (std::size_t i = 0; i < some.size(); ++i)
        std::ranges::copy(scenes.transforms[i], some[i].begin());
      cpu.place(std::span<const std::array<float, 12>>(some), indices);
      const Device<std::array<float, 12>> some_copy(some);
      const Device<std::uint32_t> index_copy(indices);
      moves = sized<masu_transforms>();
      moves.values = from_device ? some_copy.data()->data() : some.front().data();
      moves.indices = from_device ? index_copy.data() : indices.data();
      moves.count = some.size();
      gpu.place(moves);
      expect_same_found();
    }
  }
}

TEST_F(PlacedOnGpu, MasksWorldsAndExclusionsAreThoseOfTheCpu) {
  PlacedKind kind;
  kind.worlds = 5;
  kind.extent = 3;
  kind.are_quadrics_beside = true;
  kind.placements = 60;
  PlacedScenes scenes(engine_, kind);
  const Scene scene = scenes.placed();
  const Tracer cpu(scene), gpu(scene, 0);
  const auto rays = scenes.rays(ray_count);
  const auto worlds = scenes.numbers(ray_count, 6), ray_masks = scenes.numbers(ray_count, 8),
             object_masks = scenes.numbers(scenes.object_count(), 8),
             primitives = scenes.numbers(ray_count, scenes.triangles()),
             objects = scenes.numbers(ray_count, scenes.object_count());
  const auto places = scenes.places(ray_count);
  for (int with = 0; with < 8; ++with) {
    QueryOptions options;
    options.worlds = worlds.data();
    if ((with & 1) != 0) options.ray_masks = ray_masks.data();
    if ((with & 2) != 0) options.object_masks = object_masks;
    if ((with & 4) != 0) {
      options.exclude = primitives.data();
      options.exclude_objects = objects.data();
    }
    expect_same(found_by(gpu, rays, places, options, nullptr), found_by(cpu, rays, places, options, nullptr));
  }
}

TEST_F(PlacedOnGpu, TracesRaysWhereTheyLie) {
  PlacedKind kind;
  kind.worlds = 3;
  kind.extent = 3;
  PlacedScenes scenes(engine_, kind);
  const Tracer tracer(scenes.placed(), 0);
  const auto rays = scenes.rays(ray_count);
  const auto worlds = scenes.numbers(ray_count, 3);
  QueryOptions options;
  options.worlds = worlds.data();
  std::vector<float> t(ray_count);
  std::vector<std::uint32_t> primitive(ray_count), object(ray_count);
  auto hits = sized<masu_hits>();
  hits.t = t.data();
  hits.primitive = primitive.data();
  hits.object = object.data();
  tracer.nearest(rays.data(), ray_count, hits, options);
  const Device<masu_ray64> there(rays);
  const Device<std::uint32_t> worlds_there(worlds);
  const Device<float> found_t(std::vector<float>(ray_count, -1.0F));
  const Device<std::uint32_t> found_primitive(primitive),
      found_object(std::vector<std::uint32_t>(ray_count, 7));
  options.worlds = worlds_there.data();
  hits.t = found_t.data();
  hits.primitive = nullptr;
  hits.object = found_object.data();
  tracer.nearest(there.data(), ray_count, hits, options);
  EXPECT_EQ(cudaDeviceSynchronize(), cudaSuccess);
  EXPECT_EQ(found_t.host(), t);
  EXPECT_EQ(found_object.host(), object);
  hits.primitive = found_primitive.data();
  hits.object = nullptr;
  tracer.nearest(there.data(), ray_count, hits, options);
  EXPECT_EQ(cudaDeviceSynchronize(), cudaSuccess);
  EXPECT_EQ(found_primitive.host(), primitive);
}

TEST_F(PlacedOnGpu, WhatCantBePlacedIsAnErrorAndNothingMoves) {
  PlacedScenes scenes(engine_, {});
  Tracer tracer(scenes.placed(), 0);
  const auto rays = scenes.rays(500);
  const PlacedFound before = found_by(tracer, rays, {}, {}, nullptr);
  for (const double wrong : {0.0, std::nan(""), static_cast<double>(INFINITY), 1e300, 1e20}) {
    std::vector<Matrix> moved = scenes.transforms;
    moved[5] = {wrong, 0, 0, wrong, 0, 1, 0, 0, 0, 0, 1, 0};
    const Device<Matrix> copy(moved);
    auto moves = sized<masu_transforms>();
    moves.values64 = copy.data()->data();
    moves.count = moved.size();
    EXPECT_THROW(tracer.place(moves), Exception);
    moves.count = 3;
    EXPECT_THROW(tracer.place(moves), Exception);
  }
  const std::vector<std::uint32_t> far{1000};
  const Device<std::uint32_t> far_there(far);
  const Device<Matrix> one(std::vector<Matrix>(1, scenes.transforms[0]));
  auto moves = sized<masu_transforms>();
  moves.values64 = one.data()->data();
  moves.count = 1;
  moves.indices = far_there.data();
  EXPECT_THROW(tracer.place(moves), Exception);
  expect_same(found_by(tracer, rays, {}, {}, nullptr), before);
}

} // namespace
