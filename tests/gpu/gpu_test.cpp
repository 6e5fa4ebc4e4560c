// The CPU's and the GPU's answers, bit for bit. Skipped, and said so, where there is no CUDA device.
#include "libgrid/build/builder.h"
#include "libgrid/file/grid_file.h"
#include "libscene/file/scene_file.h"
#include "libscene/nff/nff.h"
#include "libscene/spd/spd.h"
#include "renderer/channels.h"
#include "renderer/image/image.h"
#include "renderer/tracer.h"
#include "renderer/walk_report.h"
#include "tests/rendering.h"
#include "tests/stability/random_seed.h"
#include "tests/stability/ray_sets.h"
#include "tests/unchecked_grid.h"
#include "tools/bench/screen_division/screen_division.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <numeric>
#include <random>
#include <span>

namespace masu {
namespace {

struct Built {
  SceneFile scene;
  GridFile grid;
};

template <class Stored>
void build_grid(const SceneFile& scene, const std::string& division, const GridOptions& options,
                const std::string& path) {
  const SceneView<Stored> view = scene.view<Stored>();
  const GridLayout layout = make_grid_layout<Stored>(scene.bounds(), SpaceRule::tight,
                                                     parse_division(division), division_statistics(view));
  write_grid(build_grid(view, layout, Overlap::exact, options),
             {scene.geometry_hash(), scene.primitive_count(), scene.origin(), SpaceRule::tight,
              Overlap::exact, division, ""},
             path);
}

GridOptions options_of(GridKind kind) {
  GridOptions options;
  options.kind = kind;
  return options;
}

class CpuAndGpu : public testing::TestWithParam<SpdInfo> {
protected:
  void SetUp() override {
    std::string why;
    if (!cuda_available(why)) GTEST_SKIP() << "no GPU, nothing was compared: " << why;
  }

  Built build(Store store, int size, const std::string& division, const GridOptions& options = {}) {
    const std::string nff = folder_.file("s.nff"), scene_path = folder_.file("s.scene"),
                      grid_path = folder_.file("s.grid");
    {
      std::FILE* const file = std::fopen(nff.c_str(), "wb");
      write_spd({GetParam().scene, size, true}, file, nff);
      std::fclose(file);
    }
    Scene read = read_nff(nff);
    for (std::uint32_t i = 0; i < read.triangles.size(); ++i)
      read.faces.push_back(i / 3); // as of polygons
    write_scene(read, store, scene_path);
    const SceneFile scene(scene_path);
    store == Store::float64 ? build_grid<double>(scene, division, options, grid_path)
                            : build_grid<float>(scene, division, options, grid_path);
    return {SceneFile(scene_path), GridFile(grid_path)};
  }

  FrameRequest request(const SceneFile& scene, std::int32_t pixels) const {
    FrameRequest request;
    request.camera = scene.camera();
    request.camera.width = request.camera.height = pixels;
    request.rules.hit_name = HitName::primitive;
    request.hits = true;
    return request;
  }

  const RandomSeed seed_;
  const testing::ScopedTrace trace_{__FILE__, __LINE__, seed_.trace()};
  TemporaryFolder folder_;
};

void expect_same_hits(std::span<const HitRecord> cpu, std::span<const HitRecord> gpu) {
  ASSERT_EQ(cpu.size(), gpu.size());
  std::size_t different = 0;
  for (std::size_t i = 0; i < cpu.size(); ++i) {
    if (std::memcmp(&cpu[i], &gpu[i], sizeof(HitRecord)) == 0) continue;
    if (++different == 1) {
      ADD_FAILURE() << "ray " << i << ": cpu t " << cpu[i].t << " primitive " << cpu[i].name << ", gpu t "
                    << gpu[i].t << " primitive " << gpu[i].name;
    }
  }
  EXPECT_EQ(different, 0U) << "of " << cpu.size() << " rays";
}

// The highlight's power is the only function that may round differently.
void expect_same_picture(const Frame& cpu, const Frame& gpu) {
  ASSERT_EQ(cpu.radiance.size(), gpu.radiance.size());
  float worst = 0;
  for (std::size_t i = 0; i < cpu.radiance.size(); ++i)
    worst = std::max(worst, largest_magnitude(cpu.radiance[i] - gpu.radiance[i]));
  EXPECT_LE(worst, 1e-5F);
}

void expect_same_counts(const Counts& cpu, const Counts& gpu) {
  int field = 0;
  for_each_count(cpu, gpu, [&](std::uint64_t on_cpu, std::uint64_t on_gpu) {
    EXPECT_EQ(on_cpu, on_gpu) << "count " << field++;
  });
}

Frame render(Device device, const Built& built, const FrameRequest& request, bool with_grid = true) {
  return Tracer(built.scene, with_grid ? &built.grid : nullptr, device).render(request);
}
RayHits trace(Device device, const Built& built, std::span<const Ray<double>> rays,
              const RaysRequest& request) {
  return Tracer(built.scene, &built.grid, device).hits(rays, request, HitName::primitive);
}

TEST_P(CpuAndGpu, SeeTheSameHitsAndPicture) {
  const Built built = build(Store::float32, GetParam().standard, "auto");
  const FrameRequest wanted = request(built.scene, 512);
  const Frame cpu = render(Device::cpu, built, wanted), gpu = render(Device::cuda, built, wanted);
  expect_same_hits(cpu.hits, gpu.hits);
  expect_same_picture(cpu, gpu);
}

// Of a window, in memory that another frame has used.
TEST_P(CpuAndGpu, ReportPixelsAsTheyAreMadeOfRadiance) {
  const Built built = build(Store::float32, GetParam().min_size + 1, "auto");
  for (const Sampling sampling : {Sampling::corners, Sampling::centers}) {
    FrameRequest wanted = request(built.scene, 203);
    wanted.sampling = sampling;
    wanted.window = {5, 7, 150, 93};
    const Frame radiance = render(Device::cuda, built, wanted);
    wanted.rgb = true;
    const Tracer gpu(built.scene, &built.grid, Device::cuda);
    const Frame frame = gpu.render(wanted, 0, used_memory(1000));
    EXPECT_TRUE(frame.radiance.empty());
    EXPECT_FALSE(frame.rgb.empty());
    EXPECT_TRUE(rgb_rows(frame, sampling, false) == rgb_rows(radiance, sampling, false));
    const Frame cpu = render(Device::cpu, built, wanted);
    EXPECT_TRUE(cpu.rgb.empty());
    EXPECT_EQ(cpu.radiance.size(), radiance.radiance.size());
  }
}

TEST_P(CpuAndGpu, NameTheSameFaces) {
  const Built built = build(Store::float32, GetParam().min_size + 1, "auto");
  const auto triangles = static_cast<std::int32_t>(built.scene.view<float>().triangle_count);
  FrameRequest wanted = request(built.scene, 128);
  const Frame primitives = render(Device::cuda, built, wanted);
  wanted.rules.hit_name = HitName::face;
  const Frame cpu = render(Device::cpu, built, wanted), gpu = render(Device::cuda, built, wanted);
  expect_same_hits(cpu.hits, gpu.hits);
  for (std::size_t i = 0; i < gpu.hits.size(); ++i) {
    const std::int32_t primitive = primitives.hits[i].name;
    EXPECT_EQ(gpu.hits[i].name, primitive >= 0 && primitive < triangles ? primitive / 3 : primitive);
  }
  const std::vector<Ray<double>> rays = random_rays(built.scene, 20'000, 1);
  const auto faces = [&](Device device) {
    return Tracer(built.scene, &built.grid, device).hits(rays, {}, HitName::face).hits;
  };
  expect_same_hits(faces(Device::cpu), faces(Device::cuda));
}

TEST_P(CpuAndGpu, SeeTheSameInDouble) {
  const Built built = build(Store::float64, GetParam().standard, "64");
  const FrameRequest wanted = request(built.scene, 256);
  const Frame cpu = render(Device::cpu, built, wanted), gpu = render(Device::cuda, built, wanted);
  expect_same_hits(cpu.hits, gpu.hits);
  expect_same_picture(cpu, gpu);
}

TEST_P(CpuAndGpu, FindTheSameForAMillionRandomRays) {
  auto engine = seed_.engine();
  const Built built = build(Store::float32, GetParam().standard, "auto");
  const Boxf box = built.scene.view<float>().clip;
  const Vec3f center = (box.min + box.max) * 0.5F;
  const float radius = length(box.max - center);
  std::normal_distribution<float> gauss;
  const auto on_sphere = [&] {
    return normalized(Vec3f{gauss(engine), gauss(engine), gauss(engine)}) * radius + center;
  };
  std::vector<Ray<double>> rays(1'000'000);
  for (Ray<double>& ray : rays) {
    const Vec3f from = on_sphere();
    ray = unbounded_ray(cast<double>(from), cast<double>(on_sphere() - from));
  }
  RaysRequest wanted;
  expect_same_hits(trace(Device::cpu, built, rays, wanted).hits,
                   trace(Device::cuda, built, rays, wanted).hits);
}

// Of few rays and of many, through cells that list next to nothing and through such as list nearly all.
TEST_P(CpuAndGpu, FindTheSameByEveryLoop) {
  for (const auto& [division, kind] :
       {std::pair{"2", GridKind::uniform}, std::pair{"auto", GridKind::uniform},
        std::pair{"4", GridKind::irregular}, std::pair{"1", GridKind::hierarchy}}) {
    SCOPED_TRACE(std::string(division) + (kind == GridKind::uniform     ? ""
                                          : kind == GridKind::irregular ? " irregular"
                                                                        : " bvh"));
    const Built built = build(Store::float32, GetParam().min_size + 1, division, options_of(kind));
    std::vector<Ray<double>> rays = random_rays(built.scene, 4000, seed_.engine()());
    const std::vector<Ray<double>> eye =
        primary_rays(built.scene, request(built.scene, 64).camera, RayOrder::tiles);
    rays.insert(rays.end(), eye.begin(), eye.end());
    for (std::size_t i = 0; i < 600; ++i) { // along the axes, from up to 1e15 away
      const int axis = static_cast<int>(i % 3);
      Vec3d from = fma(rays[i].direction, 0.5, rays[i].origin), along{};
      from.set(axis, -std::pow(10.0, static_cast<double>(i) / 40));
      along.set(axis, 1);
      rays.push_back(unbounded_ray(from, along));
    }
    for (const std::size_t count : {std::size_t{1}, std::size_t{33}, rays.size()}) {
      SCOPED_TRACE(count);
      for (const Query query : {Query::nearest_hit, Query::occlusion}) {
        for (const Precision precision : {Precision::robust, Precision::doubled}) {
          const std::span<const Ray<double>> some = std::span(rays).last(count);
          RaysRequest wanted;
          wanted.tracing.precision = precision;
          wanted.query = query;
          const RayHits cpu = trace(Device::cpu, built, some, wanted);
          for (const RayLoop loop : {RayLoop::thread_per_ray, RayLoop::warp, RayLoop::warp_refill}) {
            SCOPED_TRACE(static_cast<int>(loop));
            wanted.loop = loop;
            expect_same_hits(cpu.hits, trace(Device::cuda, built, some, wanted).hits);
          }
        }
      }
    }
  }
}

// Nearly all warps have next to nothing to do while a few have long ways: those rays are left to the kernel
// that finishes. The many miss the bounds, or cut a corner of them.
TEST_P(CpuAndGpu, FindTheSameWhereFewRaysTakeLong) {
  const Built built = build(Store::float32, GetParam().min_size + 1, "300");
  const Box<double> box = cast<double>(built.scene.view<float>().clip);
  const Vec3<double> away = box.max - box.min;
  const std::vector<Ray<double>> crossing = random_rays(built.scene, 1000, seed_.engine()());
  const Vec3<double> corner_from = box.max + away * Vec3<double>{0.05, -0.06, -0.01},
                     corner_to = box.max + away * Vec3<double>{-0.06, 0.05, -0.01};
  for (const Ray<double>& brief :
       {unbounded_ray(box.max + away, away), unbounded_ray(corner_from, corner_to - corner_from)}) {
    std::vector<Ray<double>> rays(60'000, brief);
    for (const std::size_t at : {std::size_t{0}, rays.size() / 2, rays.size()})
      rays.insert(rays.begin() + static_cast<std::ptrdiff_t>(at), crossing.begin(), crossing.end());
    for (const Query query : {Query::nearest_hit, Query::occlusion}) {
      for (const Precision precision : {Precision::robust, Precision::doubled}) {
        RaysRequest wanted;
        wanted.tracing.precision = precision;
        wanted.query = query;
        expect_same_hits(trace(Device::cpu, built, rays, wanted).hits,
                         trace(Device::cuda, built, rays, wanted).hits);
      }
    }
  }
}

TEST_P(CpuAndGpu, FindTheSameRaysOccluded) {
  const Built built = build(Store::float32, GetParam().standard, "auto");
  std::vector<Ray<double>> rays = random_rays(built.scene, 300'000, 1);
  for (Ray<double>& ray : rays)
    ray.t_max = 1;
  RaysRequest wanted;
  wanted.query = Query::occlusion;
  const RayHits nearest = trace(Device::cpu, built, rays, {});
  const RayHits cpu = trace(Device::cpu, built, rays, wanted), gpu = trace(Device::cuda, built, rays, wanted);
  expect_same_hits(cpu.hits, gpu.hits);
  for (std::size_t i = 0; i < rays.size(); ++i)
    ASSERT_EQ(nearest.hits[i].name >= 0, cpu.hits[i].name >= 0) << i;
}

// All results of queries for hits in their order: of one side and of chosen objects, without excluded
// primitives, listed and counted.
struct HitLists {
  std::vector<float> t;
  std::vector<double> t64;
  std::vector<std::uint32_t> primitive, object, face, count;
  std::vector<std::array<float, 2>> uv;
  std::vector<std::array<float, 3>> normal;
  std::vector<std::uint8_t> front, inside, occluded;
  bool operator==(const HitLists&) const = default;

  HitLists(const Tracer& tracer, RayList rays, const RayFilters& filters, const RaysRequest& request) {
    const std::size_t n = rays.count, row = n * hit_rules(request).row();
    const bool lists = request.query == Query::nearest_hit || request.query == Query::all_hits;
    rays.filters = filters;
    RayResults results;
    const auto room = [](auto& array, std::size_t size) {
      array.resize(size);
      return array.data();
    };
    if (lists) {
      results.t = room(t, row);
      results.t64 = room(t64, row);
      results.primitive = room(primitive, row);
      results.object = room(object, row);
      results.face = room(face, row);
      results.uv = reinterpret_cast<float(*)[2]>(room(uv, row));
      results.normal = reinterpret_cast<float(*)[3]>(room(normal, row));
      results.front = room(front, row);
    }
    results.count = room(count, n);
    results.inside = room(inside, n);
    results.occluded = room(occluded, n);
    tracer.trace(rays, results, request);
  }
};

TEST_P(CpuAndGpu, ListTheSameHits) {
  std::mt19937_64 engine = seed_.engine();
  for (const Store store : {Store::float32, Store::float64}) {
    GridOptions options = options_of(engine() % 2 == 0 ? GridKind::irregular : GridKind::uniform);
    const Built built = build(store, GetParam().min_size + 1, "auto", options);
    const std::vector<Ray<double>> rays = random_rays(built.scene, 70'000, engine());
    std::vector<PrimitiveIndex> excluded(rays.size());
    for (PrimitiveIndex& primitive : excluded)
      primitive = static_cast<PrimitiveIndex>(engine() % (built.scene.primitive_count() + 1)) - 1;
    std::vector<std::uint32_t> ray_masks(rays.size()), object_masks(built.scene.counts().objects);
    for (auto* const masks : {&ray_masks, &object_masks})
      for (std::uint32_t& mask : *masks)
        mask = static_cast<std::uint32_t>(engine() & engine());
    const RayFilters exclusion{excluded.data()},
        chosen{excluded.data(), ray_masks.data(), object_masks.data(), object_masks.size()};
    for (const bool with_grid : {true, false}) {
      const GridFile* const grid = with_grid ? &built.grid : nullptr;
      const Tracer cpu(built.scene, grid, Device::cpu), gpu(built.scene, grid, Device::cuda);
      const std::size_t few = with_grid ? rays.size() : 2000; // brute force takes long
      for (const Query query : {Query::nearest_hit, Query::occlusion, Query::all_hits, Query::count_hits}) {
        RaysRequest request;
        request.query = query;
        request.limit = engine() % 2 == 0 ? 3 : 37;
        request.faces = std::array{Faces::both, Faces::front, Faces::back}[engine() % 3];
        if (store == Store::float32 && engine() % 2 == 0) request.tracing.precision = Precision::doubled;
        const RayList list(std::span<const Ray<double>>(rays).first(few));
        const RayFilters& filters = engine() % 2 == 0 ? chosen : exclusion;
        EXPECT_TRUE(HitLists(cpu, list, filters, request) == HitLists(gpu, list, filters, request))
            << "query " << static_cast<int>(query) << ", faces " << static_cast<int>(request.faces);
      }
    }
  }
}

TEST_P(CpuAndGpu, CountTheSame) {
  const Built built = build(Store::float32, GetParam().min_size + 1, "33x20x5");
  FrameRequest wanted = request(built.scene, 128);
  wanted.tracing.count = true;
  const Frame cpu = render(Device::cpu, built, wanted), gpu = render(Device::cuda, built, wanted);
  expect_same_counts(cpu.counts, gpu.counts);
}

TEST_P(CpuAndGpu, TraceTheSameChannels) {
  for (const GridKind kind : {GridKind::uniform, GridKind::x, GridKind::balance, GridKind::irregular}) {
    for (const auto& [store, precision] : {std::pair{Store::float32, Precision::robust},
                                           {Store::float32, Precision::doubled},
                                           {Store::float64, Precision::doubled}}) {
      SCOPED_TRACE(testing::Message()
                   << "kind " << static_cast<int>(kind) << " precision " << name_of(precision));
      const Built built = build(store, GetParam().min_size + 1,
                                kind == GridKind::irregular ? "5x4x3" : "33x20x5", options_of(kind));
      ChannelsRequest wanted;
      wanted.channels.assign(std::begin(all_channels), std::end(all_channels));
      wanted.frame = request(built.scene, 96);
      wanted.frame.tracing.precision = precision;
      for (const GridFile* const grid : {&built.grid, static_cast<const GridFile*>(nullptr)}) {
        if (grid == nullptr && kind != GridKind::uniform) continue;
        const Tracer cpu_tracer(built.scene, grid, Device::cpu), gpu_tracer(built.scene, grid, Device::cuda);
        for (const bool all_rays : {false, true}) {
          SCOPED_TRACE(all_rays ? "all rays" : "camera rays");
          wanted.all_rays = all_rays;
          const Channels cpu = trace_channels(cpu_tracer, wanted), gpu = trace_channels(gpu_tracer, wanted);
          const auto same = [](const auto& a, const auto& b) {
            return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(a[0])) == 0;
          };
          EXPECT_TRUE(same(cpu.depth, gpu.depth));
          EXPECT_TRUE(same(cpu.normal, gpu.normal));
          EXPECT_TRUE(same(cpu.object, gpu.object));
          EXPECT_TRUE(same(cpu.primitive, gpu.primitive));
          EXPECT_TRUE(same(cpu.cells, gpu.cells));
          EXPECT_TRUE(same(cpu.tests, gpu.tests));
          EXPECT_TRUE(same(cpu.idle, gpu.idle));
          expect_same_counts(cpu.counts, gpu.counts);
        }
      }
    }
  }
}

// Bands of more rays than a piece of a list.
TEST_P(CpuAndGpu, TraceTheSameChannelsOfALargePicture) {
  const Built built = build(Store::float32, GetParam().min_size + 1, "33x20x5");
  ChannelsRequest wanted;
  wanted.channels = {Channel::depth, Channel::primitive, Channel::cells, Channel::tests};
  wanted.frame = request(built.scene, 2100);
  const Channels cpu = trace_channels(Tracer(built.scene, &built.grid, Device::cpu), wanted),
                 gpu = trace_channels(Tracer(built.scene, &built.grid, Device::cuda), wanted);
  EXPECT_TRUE(cpu.depth == gpu.depth);
  EXPECT_TRUE(cpu.primitive == gpu.primitive);
  EXPECT_TRUE(cpu.cells == gpu.cells);
  EXPECT_TRUE(cpu.tests == gpu.tests);
}

// A walk is recorded on the CPU, of a GPU's tracer too.
TEST_P(CpuAndGpu, WalksHaveTheHitsAndCountsOfAGpusChannels) {
  const Built built =
      build(Store::float32, GetParam().min_size + 1, "5x4x3", options_of(GridKind::irregular));
  ChannelsRequest wanted;
  wanted.channels = {Channel::depth, Channel::primitive, Channel::cells, Channel::tests};
  wanted.frame = request(built.scene, 40);
  const Tracer tracer(built.scene, &built.grid, Device::cuda);
  for (const bool all_rays : {false, true}) {
    wanted.all_rays = all_rays;
    const Channels channels = trace_channels(tracer, wanted);
    for (std::int32_t row = 0; row < channels.rows; row += 7) {
      for (std::int32_t column = 0; column < channels.columns; column += 5) {
        const auto i = static_cast<std::size_t>(row * channels.columns + column);
        WalkRequest walk = camera_walk(tracer, wanted.frame, column, row);
        walk.all_rays = all_rays;
        const WalkReport report = trace_walk(tracer, walk);
        std::uint64_t cells = 0, tests = 0;
        for (const WalkRay& ray : report.rays) {
          cells += ray.cells;
          tests += ray.tests;
        }
        EXPECT_EQ(report.rays[0].t, channels.depth[i]);
        EXPECT_EQ(static_cast<std::int32_t>(report.rays[0].primitive), channels.primitive[i]);
        EXPECT_EQ(cells, channels.cells[i]);
        EXPECT_EQ(tests, channels.tests[i]);
      }
    }
  }
}

TEST_P(CpuAndGpu, SeeTheSameWithoutAGridAndWithATwoLevelMap) {
  const Built built = build(Store::float32, GetParam().min_size + 1, "260");
  const FrameRequest wanted = request(built.scene, 64);
  const Frame grid = render(Device::cuda, built, wanted), none = render(Device::cuda, built, wanted, false);
  const Frame cpu = render(Device::cpu, built, wanted);
  expect_same_hits(cpu.hits, grid.hits);
  expect_same_hits(grid.hits, none.hits);
  EXPECT_EQ(std::memcmp(grid.radiance.data(), none.radiance.data(), grid.radiance.size() * sizeof(Vec3f)), 0);
}

TEST_P(CpuAndGpu, SeeTheSameThroughMergedGrids) {
  for (const GridKind kind : {GridKind::x, GridKind::balance, GridKind::irregular, GridKind::hierarchy}) {
    SCOPED_TRACE(static_cast<int>(kind));
    for (const Store store : {Store::float32, Store::float64}) {
      const Built built = build(store, GetParam().min_size + 1,
                                kind == GridKind::irregular ? "5x4x3" : "33x20x5", options_of(kind));
      FrameRequest wanted = request(built.scene, 64);
      const Frame none = render(Device::cuda, built, wanted, false),
                  gpu = render(Device::cuda, built, wanted), cpu = render(Device::cpu, built, wanted);
      expect_same_hits(cpu.hits, gpu.hits);
      expect_same_hits(none.hits, gpu.hits);
      EXPECT_EQ(std::memcmp(none.radiance.data(), gpu.radiance.data(), gpu.radiance.size() * sizeof(Vec3f)),
                0);
      wanted.tracing.count = true;
      const Frame cpu_counted = render(Device::cpu, built, wanted),
                  gpu_counted = render(Device::cuda, built, wanted);
      expect_same_counts(cpu_counted.counts, gpu_counted.counts);
    }
  }
}

TEST_P(CpuAndGpu, FindTheSameForRandomRaysThroughAnIrregularGrid) {
  const Built built =
      build(Store::float32, GetParam().standard, "cleary:0.05", options_of(GridKind::irregular));
  const std::vector<Ray<double>> rays = random_rays(built.scene, 300'000, 1);
  for (const Query query : {Query::nearest_hit, Query::occlusion}) {
    RaysRequest wanted;
    wanted.query = query;
    expect_same_hits(trace(Device::cpu, built, rays, wanted).hits,
                     trace(Device::cuda, built, rays, wanted).hits);
  }
}

TEST_P(CpuAndGpu, RenderTheSameHoweverThePictureIsDivided) {
  const Built built = build(Store::float32, GetParam().min_size + 1, "auto");
  FrameRequest wanted = request(built.scene, 65);
  wanted.hits = false;
  const Frame expected = render(Device::cuda, built, wanted);
  for (const ScreenDivision division :
       {ScreenDivision::block, ScreenDivision::cyclic, ScreenDivision::persistent}) {
    const DividedFrame divided = render_divided_cuda(built.scene, built.grid, wanted, division, 0);
    EXPECT_EQ(divided.frame.radiance, expected.radiance) << static_cast<int>(division);
  }
}

// The first GPU twice, and all that there are.
std::vector<std::vector<int>> several_gpus() {
  std::vector<int> all(static_cast<std::size_t>(cuda_device_count()));
  std::iota(all.begin(), all.end(), 0);
  return {{0, 0}, all, {cuda_device_count() - 1}};
}

TEST_P(CpuAndGpu, RenderAndTraceTheSameOnSeveralGpus) {
  const Built built = build(Store::float32, GetParam().min_size + 1, "auto");
  FrameRequest wanted = request(built.scene, 1300); // more than a million rays: several bands
  FrameRequest band = wanted;
  band.window = {0, 100, 1301, 200};
  band.count_last_row = false;
  wanted.tracing.count = band.tracing.count = true;
  const Tracer one(built.scene, &built.grid, Device::cuda), cpu(built.scene, &built.grid, Device::cpu);
  const std::vector<Ray<double>> rays = random_rays(built.scene, 2'300'000, 1);
  const RayHits expected_hits = one.hits(rays, {}, HitName::primitive);
  const Frame expected = one.render(wanted);
  for (const std::vector<int>& gpus : several_gpus()) {
    SCOPED_TRACE(testing::Message() << gpus.size() << " GPUs, the last one is " << gpus.back());
    const Tracer several(built.scene, &built.grid, Device::cuda, gpus);
    ASSERT_EQ(several.device_count(), gpus.size());
    expect_same_hits(expected_hits.hits, several.hits(rays, {}, HitName::primitive).hits);
    const Frame frame = several.render(wanted);
    EXPECT_EQ(frame.radiance, expected.radiance);
    expect_same_hits(expected.hits, frame.hits);
    expect_same_counts(expected.counts, frame.counts);
    for (std::size_t index = 0; index < gpus.size(); ++index) {
      const Frame in_used_memory = several.render(band, index, used_memory(1000));
      expect_same_counts(cpu.render(band).counts, in_used_memory.counts);
      expect_same_frames(one.render(band, 0), in_used_memory);
    }
    RaysRequest counted;
    counted.tracing.count = true;
    const auto counts = [&](const Tracer& tracer) { // of rays in the memory of its first GPU
      return tracer.trace(tracer.upload(rays, Precision::automatic), counted).counts;
    };
    expect_same_counts(counts(one), counts(several));
  }
}

// The rows of bands that share rays are counted once.
TEST_P(CpuAndGpu, CountBandsAsTheWhole) {
  const Built built = build(Store::float32, GetParam().min_size + 1, "auto");
  FrameRequest wanted = request(built.scene, 90);
  wanted.tracing.count = true;
  for (const Device device : {Device::cpu, Device::cuda}) {
    const Tracer tracer(built.scene, &built.grid, device);
    Counts sum;
    for (const std::int32_t row : {0, 20, 40, 60, 80}) {
      FrameRequest band = wanted;
      band.window = {0, row, 91, std::min(21, 91 - row)};
      band.count_last_row = row == 80;
      sum += tracer.render(band).counts;
    }
    expect_same_counts(tracer.render(wanted).counts, sum);
  }
}

TEST(UncheckedGrid, IsRefusedByTheGpuBeforeAnythingIsTraced) {
  std::string why;
  if (!cuda_available(why)) GTEST_SKIP() << "no GPU, nothing was refused: " << why;
  EXPECT_TRUE(is_refused_by_tracer(Device::cuda));
}

INSTANTIATE_TEST_SUITE_P(Spd, CpuAndGpu, testing::ValuesIn(spd_scenes().begin(), spd_scenes().end()),
                         [](const auto& scene) { return std::string(scene.param.name); });

} // namespace
} // namespace masu
