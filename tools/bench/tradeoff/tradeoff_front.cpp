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
  Accuracy& accuracy = all.accuracy;
  const auto sum = [&](const auto& value_of) {
    return std::accumulate(rows.begin(), rows.end(), 0.0, [&](double so_far, const TradeoffRow* row) {
      return so_far + value_of(row->measured);
    });
  };
  const auto count = static_cast<double>(rows.size());
  for (double Measurement::*const speed : {&Measurement::primary_mrays, &Measurement::random_mrays,
                                           &Measurement::mrays, &Measurement::picture_ms})
    all.*speed = std::exp(sum([&](const Measurement& one) { return std::log(one.*speed); }) / count);
  // The pictures are of one size.
  accuracy.rmse =
      std::sqrt(sum([](const Measurement& one) { return one.accuracy.rmse * one.accuracy.rmse; }) / count);
  for (const TradeoffRow* const row : rows) {
    for (std::uint64_t Measurement::*const size :
         {&Measurement::voxels, &Measurement::grid_bytes, &Measurement::scene_bytes})
      all.*size += row->measured.*size;
    for (std::uint64_t Accuracy::*const hits : {&Accuracy::rays, &Accuracy::missed, &Accuracy::false_hits,
                                                &Accuracy::wrong_primitives, &Accuracy::ties})
      accuracy.*hits += row->measured.accuracy.*hits;
    for (double Accuracy::*const error : {&Accuracy::worst_t, &Accuracy::median_t, &Accuracy::largest})
      accuracy.*error = std::max(accuracy.*error, row->measured.accuracy.*error);
  }
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
