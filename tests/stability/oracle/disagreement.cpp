#include "stability/oracle/disagreement.h"

#include "libscene/base/parallel.h"
#include "stability/oracle/exact_hit.h"

#include <tbb/combinable.h>

#include <algorithm>

namespace masu::stability {
namespace {

bool is_among(const std::vector<PrimitiveIndex>& nearest, const Found& found) {
  if (found.primitive == no_primitive) return nearest.empty();
  return std::find(nearest.begin(), nearest.end(), found.primitive) != nearest.end();
}

} // namespace

Disagreement disagreement(std::span<const Triangle<float>> triangles, std::span<const Ray<double>> rays,
                          std::span<const Found> first, std::span<const Found> second) {
  tbb::combinable<Disagreement> parts;
  parallel_for(rays.size(), [&](std::size_t i) {
    if (first[i].primitive == second[i].primitive) return;
    const std::vector<PrimitiveIndex> nearest = exact_nearest(triangles, rays[i]);
    const bool first_right = is_among(nearest, first[i]), second_right = is_among(nearest, second[i]);
    Disagreement& part = parts.local();
    ++part.differing;
    ++(first_right && second_right ? part.both
       : first_right               ? part.first
       : second_right              ? part.second
                                   : part.neither);
  });
  Disagreement total;
  total.rays = rays.size();
  parts.combine_each([&](const Disagreement& part) {
    total.differing += part.differing;
    total.first += part.first;
    total.second += part.second;
    total.both += part.both;
    total.neither += part.neither;
  });
  return total;
}

} // namespace masu::stability
