// Placed meshes answer as the scene of their vertices written out, to the bit, through any structure.
#include "tests/api/found.h"
#include "tests/api/placed_scene.h"
#include "tests/api/random_arrays.h"

namespace {

using namespace masu;

using Placed = RandomArrays;

PlacedFound found_written_out(const PlacedScenes& scenes, const std::vector<masu_ray64>& rays) {
  return found_by(Tracer(scenes.written_out()), rays, {}, {}, nullptr, scenes.center());
}

const auto ray_count = static_cast<std::size_t>(cases(400)), few_rays = std::min(ray_count, std::size_t{400}),
           place_count = few_rays / 5;

TEST_F(Placed, FindTheSameAsWrittenOut) {
  for (const PlacedKind& kind : placed_kinds()) {
    PlacedScenes scenes(engine_, kind);
    const auto places = scenes.places(place_count);
    for (const auto precision :
         {MASU_PRECISION_AUTO, MASU_PRECISION_AUTO, MASU_PRECISION_DOUBLE, MASU_PRECISION_DOUBLE}) {
      const auto rays = scenes.rays(ray_count);
      SCOPED_TRACE(testing::Message()
                   << "kind " << &kind - placed_kinds().data() << ", extent " << kind.extent << ", stretch "
                   << kind.stretch << ", precision " << precision);
      QueryOptions options;
      options.precision = precision;
      const PlacedFound expected =
          found_by(Tracer(scenes.written_out()), rays, places, options, nullptr, scenes.center());
      const Scene scene = scenes.placed();
      expect_same(found_by(Tracer(scene), rays, places, options, &scenes), expected);
      if (precision != MASU_PRECISION_AUTO || kind.placements >= 100) continue;
      const std::vector<masu_ray64> few(rays.begin(), rays.begin() + static_cast<std::ptrdiff_t>(few_rays));
      expect_same(found_by(brute_force(scene), few, places, options, &scenes),
                  found_by(Tracer(scene), few, places, options, &scenes));
    }
  }
}

TEST_F(Placed, MovedOnesAreThoseOfANewScene) {
  for (const PlacedKind& kind : placed_kinds()) {
    PlacedScenes scenes(engine_, kind);
    Tracer tracer(scenes.placed());
    scenes.move();
    tracer.place(std::span<const Matrix>(scenes.transforms));
    const auto rays = scenes.rays(ray_count);
    expect_same(found_by(tracer, rays, {}, {}, &scenes), found_written_out(scenes, rays));
    auto some = scenes.transforms;
    scenes.move();
    const std::vector<std::uint32_t> indices{3, 0};
    const std::vector<Matrix> moved{scenes.transforms[3], scenes.transforms[0]};
    tracer.place(std::span<const Matrix>(moved), indices);
    some[3] = moved[0];
    some[0] = moved[1];
    scenes.transforms = some;
    expect_same(found_by(tracer, rays, {}, {}, &scenes), found_written_out(scenes, rays));
  }
}

// Each ray of a list its own, of neighbours some the same.
TEST_F(Placed, RaysOfAListSeeTheirOwnWorldsByTheirOwnMasks) {
  PlacedKind kind;
  kind.worlds = 3;
  kind.extent = 3;
  kind.placements = 40;
  PlacedScenes scenes(engine_, kind);
  const Tracer tracer(scenes.placed()), brute = brute_force(scenes.placed());
  for (const std::size_t run : {1, 1, 7, 7, 50, 50}) {
    const auto rays = scenes.rays(ray_count);
    std::vector<std::uint32_t> worlds = scenes.numbers(rays.size(), 4),
                               masks = scenes.numbers(rays.size(), 8);
    for (std::size_t i = 0; i < rays.size(); ++i) {
      worlds[i] = worlds[i - i % run];
      masks[i] = masks[i - i % run];
    }
    const auto object_masks = scenes.numbers(scenes.object_count(), 8);
    QueryOptions options;
    const auto expect_same_found = [&] {
      expect_same(found_by(tracer, rays, {}, options, &scenes), found_by(brute, rays, {}, options, &scenes));
    };
    options.worlds = worlds.data();
    expect_same_found();
    options.ray_masks = masks.data();
    expect_same_found();
    options.object_masks = object_masks;
    expect_same_found();
  }
}

// Of a ray those that share a bit, of its world; by the written-out scene's masks.
TEST_F(Placed, MasksWorldsAndExclusionsAreThoseOfObjects) {
  PlacedKind kind;
  kind.worlds = 3;
  kind.extent = 3;
  kind.are_quadrics_beside = true;
  kind.placements = 40;
  PlacedScenes scenes(engine_, kind);
  const Tracer tracer(scenes.placed()), written(scenes.written_out()), brute = brute_force(scenes.placed());
  const auto rays = scenes.rays(ray_count);
  const auto places = scenes.places(ray_count);
  for (std::uint32_t world = 0; world < 4; ++world) {
    for (const bool with_masks : {false, true}) {
      for (const bool with_own : {false, true}) {
        SCOPED_TRACE(testing::Message() << world << with_masks << with_own);
        const std::uint32_t mask = with_own ? 5 : ~0U;
        std::vector<std::uint32_t> masks = scenes.numbers(scenes.object_count(), 8),
                                   written_masks(masks.size());
        for (std::uint32_t i = 0; i < masks.size(); ++i)
          written_masks[i] = scenes.sees(world, i) && (scenes.mask_of(i) & mask) != 0 &&
                             (!with_masks || (masks[i] & mask) != 0);
        const std::vector<std::uint32_t> worlds(rays.size(), world), ray_masks(rays.size(), mask);
        QueryOptions options, written_options;
        options.worlds = worlds.data();
        if (with_masks) options.object_masks = masks;
        if (with_own) options.ray_masks = ray_masks.data();
        written_options.object_masks = written_masks;
        const PlacedFound expected =
            found_by(written, rays, places, written_options, nullptr, scenes.center());
        expect_same(found_by(tracer, rays, places, options, &scenes), expected);
        expect_same(found_by(brute, rays, places, options, &scenes), expected);
        auto primitives = scenes.numbers(rays.size(), scenes.triangles()), objects = expected.object;
        for (std::size_t i = 0; i < rays.size(); ++i)
          if (objects[i] != MASU_NONE)
            primitives[i] = expected.primitive[i] - scenes.written_number(objects[i], 0);
        std::vector<std::uint32_t> excluded(rays.size());
        for (std::size_t i = 0; i < rays.size(); ++i)
          excluded[i] = scenes.written_number(objects[i], primitives[i]);
        options.exclude = primitives.data();
        options.exclude_objects = objects.data();
        written_options.exclude = excluded.data();
        expect_same(found_by(tracer, rays, places, options, &scenes),
                    found_by(written, rays, places, written_options, nullptr, scenes.center()));
      }
    }
  }
}

TEST_F(Placed, WhatCantBePlacedIsAnErrorAndNothingMoves) {
  PlacedScenes scenes(engine_, {});
  const Scene scene = scenes.placed();
  Tracer tracer(scene);
  const auto rays = scenes.rays(200);
  const PlacedFound before = found_by(tracer, rays, {}, {}, &scenes);
  const double nan = std::nan(""), endless = INFINITY;
  const Matrix identity{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
  const auto expect_refused = [&](const Matrix& moved, const char* says) {
    scenes.transforms[5] = moved;
    const std::string error = refused([&] { tracer.place(std::span<const Matrix>(scenes.transforms)); });
    EXPECT_NE(error.find(says), std::string::npos) << error;
  };
  for (const double wrong : {nan, endless, -endless, 1e300, 1e20}) {
    for (std::size_t i = 0; i < 12; ++i) {
      Matrix moved = identity;
      moved[i] = wrong;
      expect_refused(moved, "placements: ");
    }
  }
  for (const Matrix& moved : {Matrix{}, Matrix{1, 2, 3, 0, 2, 4, 6, 0, 0, 0, 1, 0},
                              Matrix{1, 0, 0, 0, 0, 1, 0, 0}, Matrix{1e-14, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}})
    expect_refused(moved, "number 5 can't be inverted");
  refused([&] { scenes.placed(); });
  scenes.transforms.pop_back();
  refused([&] { tracer.place(std::span<const Matrix>(scenes.transforms)); });
  const std::vector<std::uint32_t> far{20};
  refused([&] { tracer.place(std::span<const Matrix>(&identity, 1), far); });
  refused([&] { tracer.place(sized<masu_transforms>()); });
  expect_same(found_by(tracer, rays, {}, {}, &scenes), before);

  refused([&] { scene.write("/nonexistent"); });
  refused([&] { Grid grid(scene); });
  refused([&] { tracer.grid(); });
  refused([&] { tracer.update(std::vector<float>(9)); });
  refused([&] { static_cast<void>(scene.primitive(0)); });
  QueryOptions options;
  const std::vector<std::uint32_t> numbers(rays.size());
  options.exclude = numbers.data();
  refused([&] { tracer.nearest(rays, options); });
  options = {};
  options.precision = MASU_PRECISION_FAST;
  refused([&] { tracer.nearest(rays, options); });
  Tracer written(scenes.written_out());
  options = {};
  options.worlds = numbers.data();
  refused([&] { written.nearest(rays, options); });
  refused([&] { written.place(std::span<const Matrix>(&identity, 1)); });
}

} // namespace
