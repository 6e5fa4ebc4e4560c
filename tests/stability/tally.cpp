#include "stability/tally.h"
#include "libscene/base/parallel.h"

#include <tbb/combinable.h>

#include <algorithm>
#include <limits>

namespace masu::stability {
namespace {

// Relative error of a correct hit's t; 0 where the exact t is unsure.
double t_error(double t, oracle::Wide exact) {
  if (!(exact > 0)) return 0;
  if (!std::isfinite(t)) return std::numeric_limits<double>::infinity();
  return static_cast<double>(oracle::magnitude(t - exact) / exact);
}

// Roundings of t itself, which matter for distant origins, in units of its roundoff.
constexpr double roundings_of_t = 4;

void judge(const oracle::SceneOracle& oracle, const Ray<double>& ray, const oracle::ClosestHit& expected,
           double u, const Found& found, Tally& tally) {
  ++tally.rays;
  tally.unsure += expected.sure ? 0 : 1;
  tally.by_grid += found.same ? 0 : 1;
  if (found.primitive == no_primitive) {
    tally.missed += expected.may_miss ? 0 : 1;
    return;
  }
  const oracle::Candidate* const candidate = expected.find(found.primitive);
  if (candidate == nullptr) {
    ++(expected.candidates.empty() ? tally.false_hit : tally.wrong);
    return;
  }
  if (oracle.first_alike(found.primitive) != found.primitive) {
    ++tally.wrong;
    return;
  }
  const oracle::Wide rounding = roundings_of_t * u * oracle::magnitude(found.t);
  const bool placed = found.t >= candidate->low - rounding && found.t <= candidate->high + rounding;
  tally.misplaced += placed ? 0 : 1;
  if (expected.sure)
    tally.worst_t = std::max(tally.worst_t, t_error(found.t, oracle.exact_t(ray, found.primitive)));
}

constexpr std::size_t rays_a_task = 64;

} // namespace

Tally& operator+=(Tally& total, const Tally& part) {
  total.rays += part.rays;
  total.unsure += part.unsure;
  total.missed += part.missed;
  total.false_hit += part.false_hit;
  total.wrong += part.wrong;
  total.misplaced += part.misplaced;
  total.by_grid += part.by_grid;
  total.worst_t = std::max(total.worst_t, part.worst_t);
  return total;
}

std::vector<Tally> judged(const oracle::SceneOracle& oracle, std::span<const Ray<double>> rays, double slack,
                          double u, std::span<const std::vector<Found>> methods) {
  tbb::combinable<std::vector<Tally>> parts([&] { return std::vector<Tally>(methods.size()); });
  parallel_ranges(rays.size(), rays_a_task, [&](std::size_t begin, std::size_t end) {
    std::vector<Tally>& tallies = parts.local();
    for (std::size_t i = begin; i != end; ++i) {
      const oracle::ClosestHit expected = oracle.closest(rays[i], slack);
      for (std::size_t m = 0; m < methods.size(); ++m)
        judge(oracle, rays[i], expected, u, methods[m][i], tallies[m]);
    }
  });
  std::vector<Tally> total(methods.size());
  parts.combine_each([&](const std::vector<Tally>& part) {
    for (std::size_t m = 0; m < total.size(); ++m)
      total[m] += part[m];
  });
  return total;
}

Tally judged_enclosed(std::span<const Found> found) {
  Tally tally;
  tally.rays = found.size();
  for (const Found& one : found) {
    tally.missed += one.primitive == no_primitive ? 1 : 0;
    tally.by_grid += one.same ? 0 : 1;
  }
  return tally;
}

} // namespace masu::stability
