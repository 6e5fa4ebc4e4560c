// Channels and walks: a picture's own hits and counts, ray by ray, for every grid, arithmetic and store.
#include "renderer/channels.h"
#include "renderer/rays/walk_report.h"
#include "tests/rendering.h"
#include "tests/scene_builder.h"

#include <algorithm>
#include <bit>
#include <map>
#include <numeric>

namespace masu {
namespace {

// Mirrors, glass and matte things of every kind, lights, and a camera among or before them.
Scene random_scene(Chance& chance) {
  const auto material = [&] {
    Material m = chance.uniform(0, 1) < 0.3   ? mirror()
                 : chance.uniform(0, 1) < 0.4 ? glass(1.5F)
                                              : matte(random_color(chance));
    if (chance.uniform(0, 1) < 0.3) m.specular = 0.5F;
    return m;
  };
  const double near = chance.uniform(0, 1) < 0.3 ? 0.5 : 4;
  Scene scene = empty_scene(chance.direction() * near, chance.in_cube(0.3));
  scene.camera.width = chance.whole(5, 13);
  scene.camera.height = chance.whole(4, 10);
  scene.camera.angle = chance.uniform(20, 80);
  for (int i = chance.whole(0, 3); i > 0; --i)
    add_light(scene, chance.in_cube(5));
  for (int i = chance.whole(1, 11); i > 0; --i) {
    const Vec3d at = chance.in_cube(1), b = chance.in_cube(0.5), c = chance.in_cube(0.5);
    add_sphere(scene, at, chance.uniform(0.02, 0.3), material());
    add_triangle(scene, at + b, at + c, at, material());
    add_cone(scene, {at, 0.1, at + b, chance.uniform(0, 1) < 0.5 ? 0.1 : 0.02}, material());
  }
  if (chance.uniform(0, 1) < 0.5) add_wall(scene, {0, 0, -1}, {0, 0, 1}, material(), 3);
  return scene;
}

struct Case {
  Store store;
  Precision precision;
};
constexpr Case all_cases[] = {{Store::float32, Precision::fast},
                              {Store::float32, Precision::robust},
                              {Store::float32, Precision::doubled},
                              {Store::float64, Precision::doubled}};

std::uint64_t tests_of(const Counts& counts) {
  return counts.triangle_tests + counts.sphere_tests + counts.cone_tests;
}
std::uint64_t sum(std::span<const std::uint32_t> values) {
  return std::accumulate(values.begin(), values.end(), std::uint64_t{0});
}
std::size_t size_of(const Channels& channels) {
  return static_cast<std::size_t>(channels.columns) * static_cast<std::size_t>(channels.rows);
}

Channels all_of(const ResidentTracer& tracer, const FrameRequest& frame, bool all_rays = false) {
  ChannelsRequest request;
  request.channels.assign(std::begin(all_channels), std::end(all_channels));
  request.frame = frame;
  request.all_rays = all_rays;
  return trace_channels(tracer, request);
}

// Calls check(tracer, request) for random scenes with every kind of grid, with a hierarchy and with none.
template <class Check>
void for_random_pictures(std::int64_t scenes, const Check& check) {
  const RandomSeed seed;
  SCOPED_TRACE(seed.trace());
  Chance chance(seed);
  for (std::int64_t i = 0; i < cases(scenes); ++i) {
    const Scene scene = random_scene(chance);
    const Case with = all_cases[i % std::ssize(all_cases)];
    for (const StructureKind kind : {StructureKind::uniform, StructureKind::x, StructureKind::balance,
                                     StructureKind::irregular, StructureKind::hierarchy}) {
      StructureOptions options{kind};
      const char* const division = kind == StructureKind::hierarchy   ? "1"
                                   : kind == StructureKind::irregular ? "3x2x4"
                                   : i % 8 == 3                       ? "70x9x130"
                                                                      : "9x7x11";
      const Rendering rendering(scene, with.store, division, options);
      FrameRequest request = rendering.request();
      request.tracing.precision = with.precision;
      request.sampling = i % 2 == 0 ? Sampling::corners : Sampling::centers;
      request.hither = i % 3 == 0;
      if (i % 5 == 4 && kind != StructureKind::hierarchy) request.tracing.stop = StopRule::first_cell;
      SCOPED_TRACE(testing::Message() << "scene " << i << " kind " << static_cast<int>(kind) << " precision "
                                      << name_of(with.precision));
      check(rendering.tracer(), request, chance);
      if (kind == StructureKind::uniform)
        check(ResidentTracer(rendering.scene(), nullptr, Device::cpu), request, chance);
      if (testing::Test::HasFailure()) return;
    }
  }
}

TEST(Channels, DepthObjectAndPrimitiveAreThePicturesHits) {
  std::size_t hits = 0;
  for_random_pictures(40, [&](const ResidentTracer& tracer, FrameRequest request, Chance&) {
    const Channels channels = all_of(tracer, request);
    for (const HitName name : {HitName::object, HitName::primitive}) {
      request.rules.hit_name = name;
      const Frame frame = tracer.render(request);
      ASSERT_EQ(frame.hits.size(), size_of(channels));
      for (std::size_t i = 0; i < frame.hits.size(); ++i) {
        ASSERT_EQ(std::bit_cast<std::uint32_t>(frame.hits[i].t),
                  std::bit_cast<std::uint32_t>(channels.depth[i]));
        ASSERT_EQ(frame.hits[i].name, name == HitName::object ? channels.object[i] : channels.primitive[i]);
        const float square = dot(channels.normal[i], channels.normal[i]);
        ASSERT_NEAR(square, frame.hits[i].name < 0 ? 0 : 1, 1e-5);
        hits += frame.hits[i].name >= 0;
      }
    }
  });
  EXPECT_GT(hits, 100U);
}

// The sums over all rays are what --stats counts.
TEST(Channels, CellsAndTestsSumUpToThePicturesCounts) {
  for_random_pictures(40, [](const ResidentTracer& tracer, const FrameRequest& request, Chance&) {
    const Channels all = all_of(tracer, request, true);
    const Frame frame = tracer.render(request);
    EXPECT_EQ(sum(all.cells), frame.counts.cells_visited);
    EXPECT_EQ(sum(all.tests), tests_of(frame.counts));
    EXPECT_EQ(all.counts.shadow_rays, frame.counts.shadow_rays);
    // Nothing but camera rays: no light, and nothing spawned.
    const Channels own = all_of(tracer, request);
    EXPECT_EQ(sum(own.cells), own.counts.cells_visited);
    EXPECT_EQ(sum(own.tests), tests_of(own.counts));
    EXPECT_EQ(own.counts.camera_rays, frame.counts.camera_rays);
    EXPECT_EQ(own.counts.camera_hits, frame.counts.camera_hits);
    for (std::size_t i = 0; i < own.cells.size(); ++i) {
      ASSERT_LE(own.cells[i], all.cells[i]);
      ASSERT_LE(own.tests[i], all.tests[i]);
      if (frame.hits[i].name < 0) { // nothing is spawned by a miss
        ASSERT_EQ(own.cells[i], all.cells[i]);
        ASSERT_EQ(own.tests[i], all.tests[i]);
      }
    }
  });
}

TEST(Channels, OfAWindowAreAPartOfThePictures) {
  for_random_pictures(12, [](const ResidentTracer& tracer, FrameRequest request, Chance&) {
    for (const bool all_rays : {false, true}) {
      request.window = {};
      const Channels whole = all_of(tracer, request, all_rays);
      request.window = {1, 2, 3, 2};
      const Channels part = all_of(tracer, request, all_rays);
      ASSERT_EQ(part.columns, 3);
      ASSERT_EQ(part.rows, 2);
      for (std::size_t i = 0; i < 6; ++i) {
        const std::size_t k = (i / 3 + 2) * static_cast<std::size_t>(whole.columns) + i % 3 + 1;
        EXPECT_EQ(part.depth[i], whole.depth[k]);
        EXPECT_EQ(part.normal[i], whole.normal[k]);
        EXPECT_EQ(part.object[i], whole.object[k]);
        EXPECT_EQ(part.primitive[i], whole.primitive[k]);
        EXPECT_EQ(part.cells[i], whole.cells[k]);
        EXPECT_EQ(part.tests[i], whole.tests[k]);
      }
    }
  });
}

// Turn by turn: a lane is busy while its ray has cells left.
TEST(Channels, IdleLanesAreThoseOfWarpsThatGoRoundInLockStep) {
  std::size_t partly = 0;
  for_random_pictures(20, [&](const ResidentTracer& tracer, const FrameRequest& request, Chance&) {
    for (const bool all_rays : {false, true}) {
      const Channels channels = all_of(tracer, request, all_rays);
      std::map<std::pair<std::int32_t, std::int32_t>, std::vector<std::size_t>> warps; // rays of each
      for (std::size_t i = 0; i < channels.idle.size(); ++i) {
        const auto ray = static_cast<std::int32_t>(i);
        warps[{ray % channels.columns / 8, ray / channels.columns / 4}].push_back(i);
      }
      std::uint64_t turns = 0, busy = 0;
      for (const auto& [place, rays] : warps) {
        std::uint64_t own_turns = 0, idle = 0;
        for (;; ++own_turns) {
          const auto under_way = static_cast<std::uint64_t>(
              std::ranges::count_if(rays, [&](std::size_t i) { return channels.cells[i] > own_turns; }));
          if (under_way == 0) break;
          idle += 32 - under_way;
          busy += under_way;
        }
        turns += own_turns;
        const double mean = own_turns > 0 ? static_cast<double>(idle) / static_cast<double>(own_turns) : 0;
        for (const std::size_t i : rays)
          EXPECT_NEAR(channels.idle[i], mean, 1e-5);
        partly += mean > 0 && rays.size() == 32;
      }
      EXPECT_EQ(channels.warps.turns, turns);
      EXPECT_EQ(channels.warps.busy_lanes, busy);
    }
  });
  EXPECT_GT(partly, 0U);
}

TEST(Channels, CostsOfAPictureChangeNothingElse) {
  for_random_pictures(8, [](const ResidentTracer& tracer, FrameRequest request, Chance&) {
    request.tracing.count = false;
    const Frame plain = tracer.render(request);
    request.costs = true;
    const Frame with = tracer.render(request);
    EXPECT_EQ(plain.radiance, with.radiance);
    EXPECT_TRUE(same_values(plain.hits, with.hits));
    EXPECT_TRUE(plain.cells.empty());
    EXPECT_EQ(with.cells.size(), with.radiance.size());
  });
}

TEST(Channels, ThoseThatWereNotRequestedAreEmpty) {
  for_random_pictures(4, [](const ResidentTracer& tracer, const FrameRequest& request, Chance&) {
    for (const Channel channel : all_channels) {
      const Channels one = trace_channels(tracer, {{channel}, request});
      const std::size_t sizes[] = {one.depth.size(),     one.normal.size(), one.object.size(),
                                   one.primitive.size(), one.cells.size(),  one.tests.size(),
                                   one.idle.size()};
      for (const Channel other : all_channels)
        EXPECT_EQ(sizes[static_cast<int>(other)], other == channel ? size_of(one) : 0) << name_of(other);
    }
  });
}

// --- Walks ------------------------------------------------------------------------------------------------

void expect_consistent(const WalkNode& node, std::size_t step) {
  EXPECT_EQ(node.index == 0, step == 0);
  EXPECT_EQ(node.depth == 0, step == 0);
  EXPECT_LE(node.depth, static_cast<int>(step));
  EXPECT_GE(std::min({node.met, node.missed, node.beyond}), 0);
  EXPECT_LE(node.met + node.missed + node.beyond, boxes_per_node);
  EXPECT_GE(node.met + node.missed + node.beyond, 1);
}
void expect_consistent(const WalkReport& report) {
  for (std::size_t i = 0; i < report.rays.size(); ++i) {
    const WalkRay& ray = report.rays[i];
    EXPECT_EQ(ray.kind == RayKind::camera, i == 0);
    EXPECT_EQ(ray.parent == -1, i == 0);
    EXPECT_LT(ray.parent, static_cast<std::int32_t>(i));
    if (i > 0) {
      EXPECT_NE(report.rays[static_cast<std::size_t>(ray.parent)].kind, RayKind::shadow);
      EXPECT_NE(report.rays[static_cast<std::size_t>(ray.parent)].primitive, no_primitive);
    }
    EXPECT_EQ(ray.cells, report.form != StructureForm::none ? ray.steps.size() : 0);
    EXPECT_EQ(ray.end == WalkEnd::missed, ray.steps.empty());
    std::uint64_t tests = 0;
    WalkTest last{no_primitive, std::numeric_limits<double>::infinity(), false};
    for (std::size_t k = 0; k < ray.steps.size(); ++k) {
      const WalkStep& step = ray.steps[k];
      tests += step.tests.size();
      const bool is_cell = report.form == StructureForm::uniform || report.form == StructureForm::merged;
      if (is_cell) {
        EXPECT_EQ(step.enter, k > 0 ? ray.steps[k - 1].exit : step.enter);
      }
      if (report.form == StructureForm::hierarchy) expect_consistent(step.node, k);
      if (report.form != StructureForm::none) {
        EXPECT_LE(step.tests.size(), step.references);
        EXPECT_TRUE(ray.kind == RayKind::shadow || step.tests.size() == step.references);
      }
      for (const WalkTest& test : step.tests) {
        if (!test.kept) continue;
        EXPECT_LE(test.t, last.t);
        last = test;
      }
      // The middle of the way through the box lies in it, but for rounding.
      if (report.form == StructureForm::none || !std::isfinite(step.exit) || !(step.enter < step.exit))
        continue;
      const Vec3d at = ray.origin + ray.direction * ((step.enter + step.exit) / 2);
      for (int axis = 0; axis < 3; ++axis) {
        EXPECT_GE(at[axis], step.box.min[axis] - 1e-4);
        EXPECT_LE(at[axis], step.box.max[axis] + 1e-4);
        if (!is_cell) continue;
        EXPECT_LT(step.voxels.first[axis], step.voxels.end[axis]);
        EXPECT_LE(step.voxels.end[axis], report.division[axis]);
      }
    }
    EXPECT_EQ(tests, ray.tests);
    EXPECT_EQ(last.primitive, ray.primitive);
    EXPECT_EQ(static_cast<float>(last.t), ray.t);
  }
}

// A walk from a random pixel, and the pixel's number in the picture.
std::pair<WalkRequest, std::size_t> random_walk(const ResidentTracer& tracer, const FrameRequest& request,
                                                Chance& chance, bool whole) {
  const RayWindow all = all_rays(request.camera, request.sampling);
  const std::int32_t column = chance.whole(0, all.columns - 1), row = chance.whole(0, all.rows - 1);
  WalkRequest walk = camera_walk(tracer, request, column, row);
  walk.all_rays = whole;
  return {walk, static_cast<std::size_t>(row * all.columns + column)};
}

TEST(Walk, OfACameraRayHasTheChannelsHitAndCounts) {
  for_random_pictures(40, [](const ResidentTracer& tracer, const FrameRequest& request, Chance& chance) {
    const Channels channels = all_of(tracer, request);
    for (int k = 0; k < 6; ++k) {
      const auto [walk, i] = random_walk(tracer, request, chance, false);
      const WalkReport report = trace_walk(tracer, walk);
      ASSERT_EQ(report.rays.size(), 1U);
      expect_consistent(report);
      const WalkRay& ray = report.rays.front();
      EXPECT_EQ(std::bit_cast<std::uint32_t>(ray.t), std::bit_cast<std::uint32_t>(channels.depth[i]));
      EXPECT_EQ(static_cast<std::int32_t>(ray.primitive), channels.primitive[i]);
      EXPECT_EQ(static_cast<std::int32_t>(ray.object), channels.object[i]);
      EXPECT_EQ(ray.cells, channels.cells[i]);
      EXPECT_EQ(ray.tests, channels.tests[i]);
    }
  });
}

TEST(Walk, OfAllRaysHasThePixelsColorAndCounts) {
  std::size_t kinds[4] = {};
  for_random_pictures(40, [&](const ResidentTracer& tracer, const FrameRequest& request, Chance& chance) {
    const Channels channels = all_of(tracer, request, true);
    const Frame frame = tracer.render(request);
    for (int k = 0; k < 6; ++k) {
      const auto [walk, i] = random_walk(tracer, request, chance, true);
      const WalkReport report = trace_walk(tracer, walk);
      expect_consistent(report);
      std::uint64_t cells = 0, tests = 0;
      for (const WalkRay& ray : report.rays) {
        cells += ray.cells;
        tests += ray.tests;
        ++kinds[static_cast<int>(ray.kind)];
      }
      EXPECT_EQ(cells, channels.cells[i]);
      EXPECT_EQ(tests, channels.tests[i]);
      EXPECT_EQ(report.radiance, frame.radiance[i]);
      EXPECT_EQ(std::bit_cast<std::uint32_t>(report.rays.front().t),
                std::bit_cast<std::uint32_t>(frame.hits[i].t));
    }
  });
  for (const std::size_t count : kinds)
    EXPECT_GT(count, 3U);
}

TEST(Walk, OfAGivenRayHasTheHitOfAList) {
  for_random_pictures(20, [](const ResidentTracer& tracer, const FrameRequest& request, Chance& chance) {
    for (int k = 0; k < 10; ++k) {
      Ray<double> ray = unbounded_ray(chance.direction() * chance.uniform(0, 5),
                                      chance.direction() * std::exp2(chance.uniform(-30, 30)));
      if (k % 2 == 0) ray.t_max = chance.uniform(0, 3) / length(ray.direction);
      if (k % 3 == 0) ray.t_min = chance.uniform(0, 1) / length(ray.direction);
      RaysRequest rays;
      rays.tracing = request.tracing;
      const RayHits found = tracer.hits(std::vector{ray}, rays, HitName::primitive);
      const WalkReport report = trace_walk(tracer, {request.tracing, ray});
      const WalkRay& walk = report.rays.front();
      EXPECT_EQ(std::bit_cast<std::uint32_t>(walk.t), std::bit_cast<std::uint32_t>(found.hits[0].t));
      EXPECT_EQ(static_cast<std::int32_t>(walk.primitive), found.hits[0].name);
      EXPECT_EQ(walk.cells, found.report.counts.cells_visited);
      EXPECT_EQ(walk.tests, tests_of(found.report.counts));
    }
  });
}

bool same(const WalkStep& a, const WalkStep& b) {
  return a.voxels.first == b.voxels.first && a.enter == b.enter && a.exit == b.exit &&
         std::ranges::equal(a.tests, b.tests, [](const WalkTest& one, const WalkTest& other) {
           return one.primitive == other.primitive && one.t == other.t && one.kept == other.kept;
         });
}

auto results_of(const WalkRay& ray) {
  return std::tuple(ray.kind, ray.parent, ray.cells, ray.tests, ray.t, ray.primitive, ray.end);
}

std::size_t recorded_bytes(const WalkReport& report) {
  std::size_t bytes = report.rays.size() * sizeof(WalkRay);
  for (const WalkRay& ray : report.rays) {
    for (const WalkStep& step : ray.steps)
      bytes += sizeof(WalkStep) + step.tests.size() * sizeof(WalkTest);
  }
  return bytes;
}

TEST(Walk, BeyondItsLimitsIsCountedAndNotRecorded) {
  std::size_t more = 0, cut = 0, ended = 0;
  for_random_pictures(40, [&](const ResidentTracer& tracer, const FrameRequest& request, Chance& chance) {
    WalkRequest walk = random_walk(tracer, request, chance, true).first;
    const WalkReport all = trace_walk(tracer, walk);
    EXPECT_EQ(all.more_rays, 0U);
    EXPECT_FALSE(all.ended_early);
    for (int k = 0; k < 6; ++k) {
      walk.limits = {};
      if (k % 2 == 0) walk.limits.rays = static_cast<std::size_t>(chance.uniform(0, 8));
      if (k % 3 == 0) walk.limits.bytes = static_cast<std::size_t>(chance.uniform(0, 8000));
      if (k == 5) walk.limits = {1, 0, static_cast<std::uint64_t>(chance.uniform(0, 50))};
      const WalkReport part = trace_walk(tracer, walk);
      EXPECT_LE(part.rays.size(), std::max<std::size_t>(walk.limits.rays, 1));
      if (part.form != StructureForm::none) { // the first ray is there always
        EXPECT_LE(recorded_bytes(part) - sizeof(WalkRay), walk.limits.bytes);
      }
      if (part.ended_early) {
        EXPECT_LT(part.rays.size() + part.more_rays, all.rays.size());
      } else {
        EXPECT_EQ(part.rays.size() + part.more_rays, all.rays.size());
        EXPECT_EQ(part.radiance, all.radiance);
      }
      for (std::size_t i = 0; i < part.rays.size(); ++i) {
        const WalkRay &ray = part.rays[i], &whole = all.rays[i];
        EXPECT_EQ(results_of(ray), results_of(whole));
        ASSERT_LE(ray.steps.size(), whole.steps.size());
        EXPECT_TRUE(std::equal(ray.steps.begin(), ray.steps.end(), whole.steps.begin(), same));
        cut += ray.steps.size() < whole.steps.size();
      }
      more += part.more_rays > 0;
      ended += part.ended_early;
    }
  });
  EXPECT_GT(more, 3U);
  EXPECT_GT(cut, 3U);
  EXPECT_GT(ended, 0U);
}

TEST(Walk, EndsWhereItsProgressThrows) {
  struct Stop {};
  // Rays spawn two, in spheres of glass in each other, to depth 32.
  Scene scene = empty_scene({0, -4, 0.3}, {0, 0, 0});
  for (int i = 0; i < 10; ++i)
    add_sphere(scene, {0, 0, 0}, 1 - 0.08 * i, glass(1.5F));
  for (Material& material : scene.materials)
    material.specular = 0.5F;
  const Rendering rendering(scene, Store::float32);
  int calls = 0;
  WalkRequest walk;
  walk.ray = unbounded_ray<double>({0, -4, 0.3}, {0, 1, -0.07});
  walk.all_rays = true;
  walk.rules.depth = largest_depth;
  walk.limits.rays = 100;
  walk.progress = [&] {
    if (++calls == 5) throw Stop();
  };
  EXPECT_THROW(trace_walk(rendering.tracer(), walk), Stop);
  EXPECT_EQ(calls, 5);
}

TEST(Walk, OfAllRaysStartsFromARayAsItReportsIt) {
  for_random_pictures(20, [](const ResidentTracer& tracer, const FrameRequest& request, Chance& chance) {
    WalkRequest walk = random_walk(tracer, request, chance, true).first;
    const WalkReport first = trace_walk(tracer, walk);
    for (const double length : {1.0, std::exp2(chance.uniform(-30, 30))}) {
      walk.ray = unbounded_ray(first.rays[0].origin, first.rays[0].direction * length);
      walk.is_relative = false; // it is reported in the world
      const WalkReport again = trace_walk(tracer, walk);
      EXPECT_NEAR(masu::length(again.rays[0].direction), 1, 1e-6);
      if (length != 1) continue;
      EXPECT_EQ(again.rays[0].direction, first.rays[0].direction);
      EXPECT_EQ(again.rays.size(), first.rays.size());
      EXPECT_EQ(again.radiance, first.radiance);
    }
  });
}

TEST(Walk, RefusesRaysThatAreNotThere) {
  for_random_pictures(1, [](const ResidentTracer& tracer, const FrameRequest& request, Chance&) {
    const RayWindow all = all_rays(request.camera, request.sampling);
    EXPECT_THROW(camera_walk(tracer, request, all.columns, 0), Error);
    EXPECT_THROW(camera_walk(tracer, request, 0, all.rows), Error);
    EXPECT_THROW(camera_walk(tracer, request, -1, 0), Error);
    EXPECT_THROW(trace_walk(tracer, {request.tracing, unbounded_ray<double>({0, 0, 0}, {0, 0, 0})}), Error);
    EXPECT_THROW(trace_walk(tracer, {request.tracing, unbounded_ray<double>({0, NAN, 0}, {1, 0, 0})}), Error);
  });
}

} // namespace
} // namespace masu
