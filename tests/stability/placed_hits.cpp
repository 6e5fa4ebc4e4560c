#include "stability/placed_hits.h"

#include "tests/api/placed_scene.h"

namespace masu::stability {
namespace {

PlacedHits::Hits hits_by(const Tracer& tracer, const PlacedScenes& scenes,
                         const std::vector<masu_ray64>& rays, masu_precision precision) {
  const std::size_t n = rays.size();
  PlacedHits::Hits found;
  std::vector<float> t(n);
  found.primitive.resize(n);
  std::vector<std::uint32_t> object(n);
  auto hits = sized<masu_hits>();
  if (precision == MASU_PRECISION_DOUBLE) {
    found.t.resize(n);
    hits.t64 = found.t.data();
  } else {
    hits.t = t.data();
  }
  hits.primitive = found.primitive.data();
  hits.object = object.data();
  QueryOptions options;
  options.precision = precision;
  tracer.nearest(rays.data(), n, hits, options);
  if (found.t.empty()) found.t.assign(t.begin(), t.end());
  for (std::size_t i = 0; i < n; ++i)
    found.primitive[i] = scenes.written_number(object[i], found.primitive[i]);
  return found;
}

} // namespace

std::size_t placed_kind_count() {
  return placed_kinds().size();
}

PlacedHits placed_hits(std::size_t kind, std::mt19937_64& engine, std::size_t rays, const std::string& file) {
  const PlacedKind of = placed_kinds().at(kind);
  PlacedScenes scenes(engine, of);
  scenes.written_out().write(file);
  auto list = scenes.rays(rays);
  PlacedHits found;
  for (masu_ray64& ray : list) {
    ray.tmin = 0;
    ray.tmax = INFINITY;
    std::array<double, 6>& relative = found.rays.emplace_back();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      relative[axis] = ray.origin[axis] - scenes.center();
      relative[3 + axis] = ray.direction[axis];
    }
  }
  const Tracer tracer(scenes.placed());
  if (of.store != MASU_STORE_FLOAT64) found.robust = hits_by(tracer, scenes, list, MASU_PRECISION_ROBUST);
  found.double_precision = hits_by(tracer, scenes, list, MASU_PRECISION_DOUBLE);
  return found;
}

} // namespace masu::stability
