// The CPU's and the GPU's answers, bit for bit. Skipped, and said so, where there is no CUDA device.
#include "libscene/geometry/random_rays.h"
#include "libscene/nff/nff.h"
#include "renderer/channels.h"
#include "renderer/image/image.h"
#include "renderer/rays/walk_report.h"
#include "renderer/tracer/tracer.h"
#include "stability/random_seed.h"
#include "stability/ray_sets.h"
#include "tests/rendering.h"
#include "tests/spd_text.h"
#include "tests/unchecked_grid.h"
#include "tools/bench/screen_division/screen_division.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <numeric>
#include <random>
#include <span>

namespace masu {
namespace {

class CpuAndGpu : public testing::TestWithParam<SpdInfo> {
protected:
  void SetUp() override {
    std::string why;
    if (!cuda_available(why)) GTEST_SKIP() << "no GPU, nothing was compared: " << why;
  }

  static Rendering build(Store store, int size, const std::string& division,
                         StructureKind kind = StructureKind::uniform) {
    Scene scene = parse_nff(spd_text({GetParam().scene, size}), "an SPD scene");
    for (std::uint32_t i = 0; i < scene.triangles.size(); ++i)
      scene.faces.push_back(i / 3); // as of polygons
    return {scene, store, division, StructureOptions{kind}};
  }
  static Rendering build(const std::string& division = "auto", StructureKind kind = StructureKind::uniform) {
    return build(Store::float32, GetParam().min_size + 1, division, kind);
  }

  FrameRequest request(const Rendering& built, std::int32_t pixels) const {
    FrameRequest request;
    request.camera = built.scene().camera();
    request.camera.width = request.camera.height = pixels;
    request.rules.hit_name = HitName::primitive;
    request.hits = true;
    return request;
  }

  const RandomSeed seed_;
  const testing::ScopedTrace trace_{__FILE__, __LINE__, seed_.trace()};
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

Frame render(Device device, const Rendering& built, const FrameRequest& request, bool with_grid = true) {
  return built.tracer(device, with_grid).render(request);
}
RayHits trace(Device device, const Rendering& built, std::span<const Ray<double>> rays,
              const RaysRequest& request) {
  return built.tracer(device).hits(rays, request, HitName::primitive);
}
// What the CPU found, too.
RayHits expect_same_traced(const Rendering& built, std::span<const Ray<double>> rays,
                           const RaysRequest& request = {}) {
  RayHits cpu = trace(Device::cpu, built, rays, request);
  expect_same_hits(cpu.hits, trace(Device::cuda, built, rays, request).hits);
  return cpu;
}

TEST_P(CpuAndGpu, SeeTheSameHitsAndPicture) {
  for (const Store store : {Store::float32, Store::float64}) {
    const bool wide = store == Store::float64;
    SCOPED_TRACE(wide ? "float64" : "float32");
    const Rendering built = build(store, GetParam().standard, wide ? "64" : "auto");
    const FrameRequest wanted = request(built, wide ? 256 : 512);
    const Frame cpu = render(Device::cpu, built, wanted), gpu = render(Device::cuda, built, wanted);
    expect_same_hits(cpu.hits, gpu.hits);
    expect_same_picture(cpu, gpu);
  }
}

// Of a window, in memory that another frame has used.
TEST_P(CpuAndGpu, ReportPixelsAsTheyAreMadeOfRadiance) {
  const Rendering built = build();
  for (const Sampling sampling : {Sampling::corners, Sampling::centers}) {
    FrameRequest wanted = request(built, 203);
    wanted.sampling = sampling;
    wanted.window = {5, 7, 150, 93};
    const Frame radiance = render(Device::cuda, built, wanted);
    wanted.rgb = true;
    const Frame frame = built.tracer(Device::cuda).render(wanted, 0, used_memory(1000));
    EXPECT_TRUE(frame.radiance.empty());
    EXPECT_FALSE(frame.rgb.empty());
    EXPECT_TRUE(rgb_rows(frame, sampling, false) == rgb_rows(radiance, sampling, false));
    const Frame cpu = render(Device::cpu, built, wanted);
    EXPECT_TRUE(cpu.rgb.empty());
    EXPECT_EQ(cpu.radiance.size(), radiance.radiance.size());
  }
}

TEST_P(CpuAndGpu, NameTheSameFaces) {
  const Rendering built = build();
  const auto triangles = static_cast<std::int32_t>(built.scene().view<float>().triangle_count);
  FrameRequest wanted = request(built, 128);
  const Frame primitives = render(Device::cuda, built, wanted);
  wanted.rules.hit_name = HitName::face;
  const Frame cpu = render(Device::cpu, built, wanted), gpu = render(Device::cuda, built, wanted);
  expect_same_hits(cpu.hits, gpu.hits);
  for (std::size_t i = 0; i < gpu.hits.size(); ++i) {
    const std::int32_t primitive = primitives.hits[i].name;
    EXPECT_EQ(gpu.hits[i].name, primitive >= 0 && primitive < triangles ? primitive / 3 : primitive);
  }
  const std::vector<Ray<double>> rays = random_rays(built.scene(), 20'000, 1);
  const auto faces = [&](Device device) { return built.tracer(device).hits(rays, {}, HitName::face).hits; };
  expect_same_hits(faces(Device::cpu), faces(Device::cuda));
}

TEST_P(CpuAndGpu, FindTheSameForAMillionRandomRays) {
  const Rendering built = build(Store::float32, GetParam().standard, "auto");
  expect_same_traced(built, random_rays(built.scene(), 1'000'000, seed_.engine()()));
}

// Of few rays and of many, through cells that list next to nothing and through such as list nearly all.
TEST_P(CpuAndGpu, FindTheSameByEveryLoop) {
  for (const auto& [division, kind] :
       {std::pair{"2", StructureKind::uniform}, std::pair{"auto", StructureKind::uniform},
        std::pair{"4", StructureKind::irregular}, std::pair{"1", StructureKind::hierarchy}}) {
    SCOPED_TRACE(std::string(division) + (kind == StructureKind::uniform     ? ""
                                          : kind == StructureKind::irregular ? " irregular"
                                                                             : " bvh"));
    const Rendering built = build(division, kind);
    std::vector<Ray<double>> rays = random_rays(built.scene(), 4000, seed_.engine()());
    const std::vector<Ray<double>> eye =
        primary_rays(built.scene(), request(built, 64).camera, RayOrder::tiles);
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
          RaysRequest wanted{.tracing = {.precision = precision}, .query = query};
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

// Warps' rays begin as packets where they are alike: bundles of 32, narrow and wide, from one point and from
// several, some of the rays short, and in some bundles a few along an axis or backwards.
TEST_P(CpuAndGpu, FindTheSameForBundles) {
  const Rendering built = build(Store::float32, GetParam().standard, "1", StructureKind::hierarchy);
  const std::uint64_t seed = seed_.engine()();
  std::vector<Ray<double>> rays;
  for (const Ray<double>& middle : random_rays(built.scene(), 3000, seed)) {
    RandomSequence random(seed, rays.size());
    const double spread = std::exp2(-20 * random.uniform()), apart = std::exp2(-30 * random.uniform());
    const double size = largest_magnitude(middle.direction);
    const bool alike = random.uniform() < 0.75;
    const auto near = [&](const Vec3d& place, double distance) {
      return fma(random_direction(random), distance * size, place);
    };
    for (int i = 0; i < 32; ++i) {
      Ray<double> ray = middle;
      ray.origin = near(ray.origin, apart);
      ray.direction = near(ray.direction, spread);
      const double kind = random.uniform();
      if (!alike && kind < 0.1) ray.direction.set(i % 3, 0);
      if (!alike && kind > 0.9) ray.direction = ray.direction * -1.0;
      if (kind > 0.5) ray.t_max = 2 * random.uniform();
      rays.push_back(ray);
    }
  }
  for (const Query query : {Query::nearest_hit, Query::occlusion})
    expect_same_traced(built, rays, {.query = query, .loop = RayLoop::thread_per_ray});
}

// Nearly all warps have next to nothing to do while a few have long ways: those rays are left to the kernel
// that finishes. The many miss the bounds, or cut a corner of them.
TEST_P(CpuAndGpu, FindTheSameWhereFewRaysTakeLong) {
  const Rendering built = build("300");
  const Box<double> box = cast<double>(built.scene().view<float>().clip);
  const Vec3<double> away = box.max - box.min;
  const std::vector<Ray<double>> crossing = random_rays(built.scene(), 1000, seed_.engine()());
  const Vec3<double> corner_from = box.max + away * Vec3<double>{0.05, -0.06, -0.01},
                     corner_to = box.max + away * Vec3<double>{-0.06, 0.05, -0.01};
  for (const Ray<double>& brief :
       {unbounded_ray(box.max + away, away), unbounded_ray(corner_from, corner_to - corner_from)}) {
    std::vector<Ray<double>> rays(60'000, brief);
    for (const std::size_t at : {std::size_t{0}, rays.size() / 2, rays.size()})
      rays.insert(rays.begin() + static_cast<std::ptrdiff_t>(at), crossing.begin(), crossing.end());
    for (const Query query : {Query::nearest_hit, Query::occlusion}) {
      for (const Precision precision : {Precision::robust, Precision::doubled}) {
        expect_same_traced(built, rays, {.tracing = {.precision = precision}, .query = query});
      }
    }
  }
}

// Of those between them that meet the scene some take long, until after the list has come to its end. There
// are so many that warps take some in advance.
TEST_P(CpuAndGpu, FindTheSameWhereMostOfTwoMillionRaysMiss) {
  for (const StructureKind kind : {StructureKind::irregular, StructureKind::hierarchy}) {
    const Rendering built = build("1", kind);
    const Box<double> box = cast<double>(built.scene().view<float>().clip);
    const Vec3<double> away = box.max - box.min;
    const std::vector<Ray<double>> crossing = random_rays(built.scene(), 1000, seed_.engine()());
    std::vector<Ray<double>> rays(2'000'000, unbounded_ray(box.max + away, away));
    for (std::size_t i = 0; i < rays.size(); i += 40)
      rays[i] = crossing[i / 40 % crossing.size()];
    RayHits cpu = trace(Device::cpu, built, rays, {});
    for (const RayLoop loop : {RayLoop::warp, RayLoop::warp_refill}) {
      SCOPED_TRACE(static_cast<int>(loop));
      expect_same_hits(cpu.hits, trace(Device::cuda, built, rays, {.loop = loop}).hits);
      // What a ray that is lost leaves of the hits before is another's.
      std::ranges::reverse(rays);
      std::ranges::reverse(cpu.hits);
    }
  }
}

TEST_P(CpuAndGpu, FindTheSameRaysOccluded) {
  const Rendering built = build(Store::float32, GetParam().standard, "auto");
  std::vector<Ray<double>> rays = random_rays(built.scene(), 300'000, 1);
  for (Ray<double>& ray : rays)
    ray.t_max = 1;
  const RayHits nearest = trace(Device::cpu, built, rays, {});
  const RayHits occluded = expect_same_traced(built, rays, {.query = Query::occlusion});
  for (std::size_t i = 0; i < rays.size(); ++i)
    ASSERT_EQ(nearest.hits[i].name >= 0, occluded.hits[i].name >= 0) << i;
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

  HitLists(const ResidentTracer& tracer, RayList rays, const RayFilters& filters,
           const RaysRequest& request) {
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
    const Rendering built = build(store, GetParam().min_size + 1, "auto",
                                  engine() % 2 == 0 ? StructureKind::irregular : StructureKind::uniform);
    const std::vector<Ray<double>> rays = random_rays(built.scene(), 70'000, engine());
    std::vector<PrimitiveIndex> excluded(rays.size());
    for (PrimitiveIndex& primitive : excluded)
      primitive = static_cast<PrimitiveIndex>(engine() % (built.scene().primitive_count() + 1)) - 1;
    std::vector<std::uint32_t> ray_masks(rays.size()), object_masks(built.scene().counts().objects);
    for (auto* const masks : {&ray_masks, &object_masks})
      for (std::uint32_t& mask : *masks)
        mask = static_cast<std::uint32_t>(engine() & engine());
    const RayFilters exclusion{excluded.data()},
        chosen{excluded.data(), ray_masks.data(), object_masks.data(), object_masks.size()};
    for (const bool with_grid : {true, false}) {
      const ResidentTracer cpu = built.tracer(Device::cpu, with_grid),
                           gpu = built.tracer(Device::cuda, with_grid);
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

// Float32 hasn't the digits of these rays.
TEST_P(CpuAndGpu, FindTheSameFromFarAway) {
  std::mt19937_64 engine = seed_.engine();
  const Rendering built = build(Store::float32, GetParam().min_size + 1, "auto");
  std::vector<Ray<double>> rays = random_rays(built.scene(), 30'000, engine());
  for (Ray<double>& ray : rays)
    ray.origin = ray.origin - ray.direction * std::ldexp(1.0, static_cast<int>(engine() % 30));
  for (const RayLoop loop : {RayLoop::thread_per_ray, RayLoop::warp, RayLoop::warp_refill}) {
    const RayHits found = expect_same_traced(built, rays, {.loop = loop});
    EXPECT_TRUE(std::ranges::any_of(found.hits, [](const HitRecord& hit) { return hit.name >= 0; }));
  }
  const ResidentTracer cpu = built.tracer(Device::cpu), gpu = built.tracer(Device::cuda);
  for (const Query query : {Query::nearest_hit, Query::all_hits}) {
    const RaysRequest request{.query = query, .limit = 3};
    EXPECT_TRUE(HitLists(cpu, RayList(rays), {}, request) == HitLists(gpu, RayList(rays), {}, request));
  }
}

TEST_P(CpuAndGpu, CountTheSame) {
  const Rendering built = build("33x20x5");
  FrameRequest wanted = request(built, 128);
  wanted.tracing.count = true;
  const Frame cpu = render(Device::cpu, built, wanted), gpu = render(Device::cuda, built, wanted);
  expect_same_counts(cpu.counts, gpu.counts);
}

TEST_P(CpuAndGpu, TraceTheSameChannels) {
  for (const StructureKind kind :
       {StructureKind::uniform, StructureKind::x, StructureKind::balance, StructureKind::irregular}) {
    for (const auto& [store, precision] : {std::pair{Store::float32, Precision::robust},
                                           {Store::float32, Precision::doubled},
                                           {Store::float64, Precision::doubled}}) {
      SCOPED_TRACE(testing::Message()
                   << "kind " << static_cast<int>(kind) << " precision " << name_of(precision));
      const Rendering built =
          build(store, GetParam().min_size + 1, kind == StructureKind::irregular ? "5x4x3" : "33x20x5", kind);
      ChannelsRequest wanted;
      wanted.channels.assign(std::begin(all_channels), std::end(all_channels));
      wanted.frame = request(built, 96);
      wanted.frame.tracing.precision = precision;
      for (const bool with_grid : {true, false}) {
        if (!with_grid && kind != StructureKind::uniform) continue;
        const ResidentTracer cpu_tracer = built.tracer(Device::cpu, with_grid),
                             gpu_tracer = built.tracer(Device::cuda, with_grid);
        for (const bool all_rays : {false, true}) {
          SCOPED_TRACE(all_rays ? "all rays" : "camera rays");
          wanted.all_rays = all_rays;
          const Channels cpu = trace_channels(cpu_tracer, wanted), gpu = trace_channels(gpu_tracer, wanted);
          EXPECT_TRUE(same_values(cpu.depth, gpu.depth));
          EXPECT_TRUE(same_values(cpu.normal, gpu.normal));
          EXPECT_TRUE(same_values(cpu.object, gpu.object));
          EXPECT_TRUE(same_values(cpu.primitive, gpu.primitive));
          EXPECT_TRUE(same_values(cpu.cells, gpu.cells));
          EXPECT_TRUE(same_values(cpu.tests, gpu.tests));
          EXPECT_TRUE(same_values(cpu.idle, gpu.idle));
          expect_same_counts(cpu.counts, gpu.counts);
        }
      }
    }
  }
}

// Bands of more rays than a piece of a list.
TEST_P(CpuAndGpu, TraceTheSameChannelsOfALargePicture) {
  const Rendering built = build("33x20x5");
  ChannelsRequest wanted;
  wanted.channels = {Channel::depth, Channel::primitive, Channel::cells, Channel::tests};
  wanted.frame = request(built, 2100);
  const Channels cpu = trace_channels(built.tracer(), wanted),
                 gpu = trace_channels(built.tracer(Device::cuda), wanted);
  EXPECT_TRUE(cpu.depth == gpu.depth);
  EXPECT_TRUE(cpu.primitive == gpu.primitive);
  EXPECT_TRUE(cpu.cells == gpu.cells);
  EXPECT_TRUE(cpu.tests == gpu.tests);
}

// A walk is recorded on the CPU, of a GPU's tracer too.
TEST_P(CpuAndGpu, WalksHaveTheHitsAndCountsOfAGpusChannels) {
  const Rendering built = build("5x4x3", StructureKind::irregular);
  ChannelsRequest wanted;
  wanted.channels = {Channel::depth, Channel::primitive, Channel::cells, Channel::tests};
  wanted.frame = request(built, 40);
  const ResidentTracer tracer = built.tracer(Device::cuda);
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
  const Rendering built = build("260");
  const FrameRequest wanted = request(built, 64);
  const Frame grid = render(Device::cuda, built, wanted), none = render(Device::cuda, built, wanted, false);
  const Frame cpu = render(Device::cpu, built, wanted);
  expect_same_hits(cpu.hits, grid.hits);
  expect_same_hits(grid.hits, none.hits);
  EXPECT_TRUE(same_values(grid.radiance, none.radiance));
}

TEST_P(CpuAndGpu, SeeTheSameThroughMergedGrids) {
  for (const StructureKind kind :
       {StructureKind::x, StructureKind::balance, StructureKind::irregular, StructureKind::hierarchy}) {
    SCOPED_TRACE(static_cast<int>(kind));
    for (const Store store : {Store::float32, Store::float64}) {
      const Rendering built =
          build(store, GetParam().min_size + 1, kind == StructureKind::irregular ? "5x4x3" : "33x20x5", kind);
      FrameRequest wanted = request(built, 64);
      const Frame none = render(Device::cuda, built, wanted, false),
                  gpu = render(Device::cuda, built, wanted), cpu = render(Device::cpu, built, wanted);
      expect_same_hits(cpu.hits, gpu.hits);
      expect_same_hits(none.hits, gpu.hits);
      EXPECT_TRUE(same_values(none.radiance, gpu.radiance));
      wanted.tracing.count = true;
      const Frame cpu_counted = render(Device::cpu, built, wanted),
                  gpu_counted = render(Device::cuda, built, wanted);
      expect_same_counts(cpu_counted.counts, gpu_counted.counts);
    }
  }
}

TEST_P(CpuAndGpu, FindTheSameForRandomRaysThroughAnIrregularGrid) {
  const Rendering built = build(Store::float32, GetParam().standard, "cleary:0.05", StructureKind::irregular);
  const std::vector<Ray<double>> rays = random_rays(built.scene(), 300'000, 1);
  for (const Query query : {Query::nearest_hit, Query::occlusion})
    expect_same_traced(built, rays, {.query = query});
}

TEST_P(CpuAndGpu, RenderTheSameHoweverThePictureIsDivided) {
  const Rendering built = build();
  FrameRequest wanted = request(built, 65);
  wanted.hits = false;
  const Frame expected = render(Device::cuda, built, wanted);
  for (const ScreenDivision division :
       {ScreenDivision::block, ScreenDivision::cyclic, ScreenDivision::persistent}) {
    const DividedFrame divided = render_divided_cuda(built.scene(), built.grid(), wanted, division, 0);
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
  const Rendering built = build();
  FrameRequest wanted = request(built, 1300); // more than a million rays: several bands
  FrameRequest band = wanted;
  band.window = {0, 100, 1301, 200};
  band.count_last_row = false;
  wanted.tracing.count = band.tracing.count = true;
  const ResidentTracer one = built.tracer(Device::cuda), cpu = built.tracer();
  const std::vector<Ray<double>> rays = random_rays(built.scene(), 2'300'000, 1);
  const RayHits expected_hits = one.hits(rays, {}, HitName::primitive);
  const Frame expected = one.render(wanted);
  for (const std::vector<int>& gpus : several_gpus()) {
    SCOPED_TRACE(testing::Message() << gpus.size() << " GPUs, the last one is " << gpus.back());
    const ResidentTracer several(built.scene(), &built.grid(), Device::cuda, gpus);
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
    const RaysRequest counted{.tracing = {.count = true}};
    const auto counts = [&](const ResidentTracer& tracer) { // of rays in the memory of its first GPU
      return tracer.trace(tracer.upload(rays, Precision::automatic), counted).counts;
    };
    expect_same_counts(counts(one), counts(several));
  }
}

// The rows of bands that share rays are counted once.
TEST_P(CpuAndGpu, CountBandsAsTheWhole) {
  const Rendering built = build();
  FrameRequest wanted = request(built, 90);
  wanted.tracing.count = true;
  for (const Device device : {Device::cpu, Device::cuda}) {
    const ResidentTracer tracer = built.tracer(device);
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
