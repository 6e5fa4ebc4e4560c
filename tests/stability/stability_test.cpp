// Robust and double precision fail nowhere, and within the envelopes of docs/accuracy.md most rays are sure.
#include "libscene/float32_precision.h"
#include "stability/oracle/oracle.h"
#include "stability/run.h"
#include "stability/sweeps/picture_sweeps.h"
#include "tests/random_test.h"

namespace masu::stability {
namespace {

using Oracle = RandomTest;
using StoreRule = RandomTest;

class Stability : public RandomTest, public testing::WithParamInterface<Sweep> {};

TEST_P(Stability, RobustAndDoubleFailNowhere) {
  std::uint64_t rays = 0, unsure = 0;
  run(GetParam(), {static_cast<std::size_t>(cases(1500)), seed_.value()}, [&](const Row& row) {
    if (!row.promised) return;
    const Tally& t = row.tally;
    rays += row.within ? t.rays : 0;
    unsure += row.within ? t.unsure : 0;
    EXPECT_EQ(t.failures(), 0U) << row.mode.name << (row.float64 ? ", float64 store" : "") << " at "
                                << row.step << " (" << row.parameter << "): of " << t.rays << " rays "
                                << t.missed << " missed, " << t.false_hit << " false, " << t.wrong
                                << " wrong, " << t.misplaced << " misplaced, " << t.by_grid << " by grid";
  });
  // Otherwise the check above would say little.
  EXPECT_GT(rays, 0U);
  EXPECT_LE(2 * unsure, rays);
}

class PictureStability : public RandomTest, public testing::WithParamInterface<PictureSweep> {};

TEST_P(PictureStability, PicturesAreRightByDefault) {
  double automatic = 0;
  run(GetParam(), seed_.value(), [&](const PictureRow& row) {
    if (!row.local_origin) return;
    if (row.precision == Precision::automatic) automatic = row.pixels_off;
    if (row.precision != Precision::doubled) return;
    // What double is off by is rounded coordinates, which the store's rule allows.
    EXPECT_LE(automatic, row.pixels_off + GetParam().tolerance)
        << row.step << (row.float64 ? ", float64 store" : "");
    EXPECT_LE(row.pixels_off, GetParam().tolerance) << row.step << (row.float64 ? ", float64 store" : "");
  });
}

TEST_F(Oracle, MissesTrianglesThatAreALineThroughTheOrigin) {
  for (int i = 0; i < 1000; ++i) {
    // Far from the origin, rounding to float32 makes such triangles and such rays.
    const auto above = [&](double z) { return Vec3d{8346999, -1e7, z + chance_.whole(0, 4)}; };
    const Triangle<double> line = triangle_of<double>(above(100), above(100), above(100));
    const Vec3d slanted{chance_.uniform(0.5, 1), chance_.uniform(-1, 1), chance_.uniform(-1, 1)};
    EXPECT_EQ(oracle::expect(oracle::line(above(0), slanted), line, 1e-8).result, oracle::Result::miss);
  }
}

template <class Stored>
bool float32_suffices(Trial<Stored> (*make)(Chance&, double, std::size_t), const RandomSeed& seed,
                      const Sweep& sweep, double step) {
  Chance chance = chance_for(seed.value(), sweep.name, std::is_same_v<Stored, double> ? -step : step);
  Trial<Stored> trial = make(chance, step, 1);
  return float32_precision(spans_of(trial.original.value().view(), Lighting<double>{})).suffices();
}

TEST_F(StoreRule, TakesTheStoreInWhichItsSweepsFailNowhere) {
  int steps = 0;
  for (const Sweep& sweep : all_sweeps()) {
    if (!sweep.by_rule) continue;
    for (const double step : sweep.float32_steps)
      EXPECT_TRUE(float32_suffices(sweep.float32, seed_, sweep, step)) << sweep.name << " at " << step;
    for (const double step : sweep.float64_steps)
      EXPECT_FALSE(float32_suffices(sweep.float64, seed_, sweep, step)) << sweep.name << " at " << step;
    steps += static_cast<int>(sweep.float32_steps.size() + sweep.float64_steps.size());
  }
  EXPECT_GT(steps, 0);
}

INSTANTIATE_TEST_SUITE_P(Sweeps, PictureStability, testing::ValuesIn(picture_sweeps()),
                         [](const auto& test) { return std::string(test.param.name); });

INSTANTIATE_TEST_SUITE_P(Sweeps, Stability, testing::ValuesIn(all_sweeps()), [](const auto& test) {
  std::string name = test.param.name;
  std::erase(name, '-');
  return name;
});

} // namespace
} // namespace masu::stability
