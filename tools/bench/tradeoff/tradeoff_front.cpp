#include "tools/bench/tradeoff/tradeoff_front.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <set>

namespace masu {

std::vector<std::size_t> pareto_front(const std::vector<Merit>& merits) {
  std::vector<std::size_t> order(merits.size()), front;
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return merits[a].speed > merits[b].speed ||
           (merits[a].speed == merits[b].speed && merits[a].error < merits[b].error);
  });
  double least = std::numeric_limits<double>::infinity();
  for (const std::size_t i : order) {
    if (!(merits[i].error < least)) continue;
    least = merits[i].error;
    front.push_back(i);
  }
  return front;
}

Merit merit_of_hits(const TradeoffRow& row) {
  const Accuracy& accuracy = row.measured.accuracy;
  const auto rays = static_cast<double>(std::max<std::uint64_t>(accuracy.rays, 1));
  return {row.measured.mrays, static_cast<double>(accuracy.wrong()) / rays};
}

Merit merit_of_picture(const TradeoffRow& row) {
  return {row.measured.picture_ms > 0 ? 1e3 / row.measured.picture_ms : 0, row.measured.accuracy.rmse};
}

std::vector<std::size_t> front_of(const std::vector<TradeoffRow>& rows, Merit (*merit)(const TradeoffRow&)) {
  constexpr Merit worst{0, std::numeric_limits<double>::infinity()};
  std::vector<Merit> merits;
  std::transform(rows.begin(), rows.end(), std::back_inserter(merits), [&](const TradeoffRow& row) {
    return row.configuration.stop == StopRule::proven ? merit(row) : worst;
  });
  return pareto_front(merits);
}

namespace {

// The mean of rows with one configuration, one for each scene.
Measurement together(const std::vector<const TradeoffRow*>& rows) {
  Measurement all;
  double primary = 0, random = 0, both = 0, picture = 0,
         squares = 0; // sums of logarithms, and of squared errors
  for (const TradeoffRow* const row : rows) {
    const Measurement& one = row->measured;
    const Accuracy& accuracy = one.accuracy;
    primary += std::log(one.primary_mrays);
    random += std::log(one.random_mrays);
    both += std::log(one.mrays);
    picture += std::log(one.picture_ms);
    squares += accuracy.rmse * accuracy.rmse;
    all.voxels += one.voxels;
    all.grid_bytes += one.grid_bytes;
    all.scene_bytes += one.scene_bytes;
    all.accuracy.rays += accuracy.rays;
    all.accuracy.missed += accuracy.missed;
    all.accuracy.false_hits += accuracy.false_hits;
    all.accuracy.wrong_primitives += accuracy.wrong_primitives;
    all.accuracy.ties += accuracy.ties;
    all.accuracy.worst_t = std::max(all.accuracy.worst_t, accuracy.worst_t);
    all.accuracy.median_t = std::max(all.accuracy.median_t, accuracy.median_t);
    all.accuracy.largest = std::max(all.accuracy.largest, accuracy.largest);
  }
  const auto count = static_cast<double>(rows.size());
  all.primary_mrays = std::exp(primary / count);
  all.random_mrays = std::exp(random / count);
  all.mrays = std::exp(both / count);
  all.picture_ms = std::exp(picture / count);
  all.accuracy.rmse = std::sqrt(squares / count); // the pictures are of one size
  return all;
}

} // namespace

std::vector<TradeoffRow> over_all_scenes(const std::vector<TradeoffRow>& rows) {
  std::set<std::string> scenes;
  for (const TradeoffRow& row : rows)
    scenes.insert(row.scene);
  std::vector<TradeoffRow> all;
  for (const TradeoffRow& first : rows) {
    if (first.scene != rows.front().scene) continue;
    std::vector<const TradeoffRow*> same;
    for (const TradeoffRow& row : rows) {
      if (row.configuration == first.configuration) same.push_back(&row);
    }
    if (same.size() != scenes.size()) continue;
    all.push_back({"all", "", first.setup, first.configuration, together(same)});
  }
  return all;
}

} // namespace masu
