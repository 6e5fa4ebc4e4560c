// Robust and double precision fail nowhere, and within the envelopes of docs/accuracy.md most rays are sure.
#include "tools/bench/stability/backends.h"
#include "tools/bench/stability/run.h"

#include <gtest/gtest.h>

#include <iostream>

namespace masu::stability {
namespace {

class Stability : public testing::TestWithParam<Sweep> {};

TEST_P(Stability, RobustAndDoubleFailNowhere) {
  const RandomSeed seed;
  SCOPED_TRACE(seed.trace());
  std::uint64_t rays = 0, unsure = 0;
  run(GetParam(), {static_cast<std::size_t>(cases(1500)), seed.value()}, [&](const Row& row) {
    if (!row.promised) return;
    const Tally& t = row.tally;
    rays += row.within ? t.rays : 0;
    unsure += row.within ? t.unsure : 0;
    EXPECT_EQ(t.failures(), 0U) << row.way.name << (row.float64 ? ", float64 store" : "") << " at "
                                << row.step << " (" << row.parameter << "): of " << t.rays << " rays "
                                << t.missed << " missed, " << t.false_hit << " false, " << t.wrong
                                << " wrong, " << t.misplaced << " misplaced, " << t.by_grid << " by grid";
  });
  // Otherwise the check above would say little.
  EXPECT_GT(rays, 0U);
  EXPECT_LE(2 * unsure, rays);
}

INSTANTIATE_TEST_SUITE_P(Sweeps, Stability, testing::ValuesIn(all_sweeps()), [](const auto& test) {
  std::string name;
  for (const char c : std::string(test.param.name))
    if (c != '-') name += c;
  return name;
});

} // namespace
} // namespace masu::stability
