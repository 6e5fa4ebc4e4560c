// Splits by the surface area heuristic along three axes at once, which are lanes. Host only.
#pragma once

#include "libgrid/hierarchy/binary/lane_box.h"
#include "libgrid/hierarchy/binary/leaf_split.h"

#include <cstdint>
#include <cstring>
#include <type_traits>

namespace masu {

// A node in registers: its box, and in the last lanes the rest. Each half is copied alone, as both at once go
// by way of the stack.
inline LaneBox box_of(const BinaryNode& node) {
  const auto* const halves = reinterpret_cast<const Lanes4*>(&node);
  LaneBox record;
  std::memcpy(&record.low, halves, sizeof record.low);
  std::memcpy(&record.high, halves + 1, sizeof record.high);
  return record;
}
inline void put(const LaneBox& record, BinaryNode& to) {
  auto* const halves = reinterpret_cast<Lanes4*>(&to);
  std::memcpy(halves, &record.low, sizeof record.low);
  std::memcpy(halves + 1, &record.high, sizeof record.high);
}

inline Boxf boxf(const LaneBox& box) {
  return {{box.low[0], box.low[1], box.low[2]}, {box.high[0], box.high[1], box.high[2]}};
}

// Calls act(a constant) for an axis; not for none.
template <class Act>
void with_axis(std::int32_t axis, const Act& act) {
  if (axis == 0) act(std::integral_constant<int, 0>{});
  if (axis == 1) act(std::integral_constant<int, 1>{});
  if (axis == 2) act(std::integral_constant<int, 2>{});
}

// The bins of three axes.
class BinLanes {
public:
  template <class Bins>
  explicit BinLanes(const Bins (&along)[3])
      : low_{along[0].low, along[1].low, along[2].low,
             1}, // far from numbers so small that arithmetic is slow
        per_unit_{along[0].per_unit, along[1].per_unit, along[2].per_unit, 0}, last_(along[0].count - 1) {}
  WholeLanes4 operator()(Lanes4 place) const {
    WholeLanes4 in = __builtin_convertvector((place - low_) * per_unit_, WholeLanes4);
    in = in < 0 ? WholeLanes4{} : in;
    return in > last_ ? WholeLanes4{} + last_ : in;
  }

private:
  Lanes4 low_, per_unit_;
  std::int32_t last_;
};

// The cheapest candidate, of equal ones the first along the first axis.
class CheapestSplit {
public:
  void add(Lanes4 cost, std::int32_t number) {
    const WholeLanes4 is_cheaper = cost < cost_;
    cost_ = is_cheaper ? cost : cost_;
    number_ = is_cheaper ? WholeLanes4{} + number : number_;
  }
  AxisSplit along_any_axis() const {
    AxisSplit best;
    for (int axis = 0; axis < 3; ++axis)
      if (cost_[axis] < best.cost) best = {cost_[axis], axis, number_[axis]};
    return best;
  }

private:
  Lanes4 cost_ = {INFINITY, INFINITY, INFINITY, INFINITY};
  WholeLanes4 number_{};
};

// The bins of three axes: of boxes joined, and of how many things begin and end there.
template <std::int32_t most>
struct AxisBins {
  CountedBox along[3][most];
  std::int32_t count;

  explicit AxisBins(std::int32_t bins) : count(bins) {}
  // Of an axis the bin that is in its lane.
  CountedBox& at(WholeLanes4 bins, int axis) { return along[axis][static_cast<std::uint32_t>(bins[axis])]; }
  void join(const AxisBins& other) {
    for (int axis = 0; axis < 3; ++axis)
      for (std::int32_t i = 0; i < count; ++i)
        along[axis][i].join(other.along[axis][i]);
  }
  CountedLanes lanes(std::int32_t bin) const { return {along[0][bin], along[1][bin], along[2][bin]}; }
};

// Numbered by the last bin that goes left. A side of nothing has an area of INFINITY, which times 0 isn't
// less than any.
template <std::int32_t most>
AxisSplit cheapest_split(const AxisBins<most>& bins) {
  Lanes4 right_costs[most];
  CountedLanes right, left;
  for (std::int32_t i = bins.count - 1; i > 0; --i) {
    right.join(bins.lanes(i));
    right_costs[i] = right.areas() * __builtin_convertvector(right.end(), Lanes4);
  }
  CheapestSplit cheapest;
  for (std::int32_t i = 0; i + 1 < bins.count; ++i) {
    left.join(bins.lanes(i));
    cheapest.add(left.areas() * __builtin_convertvector(left.begin(), Lanes4) + right_costs[i + 1], i);
  }
  return cheapest.along_any_axis();
}

// Few boxes sorted along each axis by keys, equal ones in their order.
template <class Keys>
class SortedFew {
public:
  SortedFew(const CountedBox* boxes, const Keys* keys, std::uint32_t count)
      : boxes_(boxes), keys_(keys), count_(count) {
    WholeLanes4 ranks[few_leaves]{};
    for (std::uint32_t i = 0; i < count; ++i) {
      for (std::uint32_t k = 0; k < i; ++k) {
        const WholeLanes4 is_after = keys[k] <= keys[i]; // -1 where i comes after k
        ranks[i] -= is_after;
        ranks[k] += is_after + 1;
      }
    }
    for (std::uint32_t i = 0; i < count; ++i)
      for (int axis = 0; axis < 3; ++axis)
        order_[axis][ranks[i][axis]] = static_cast<std::uint8_t>(i);
  }

  // Between boxes of other keys; numbered by the last one that goes left.
  AxisSplit cheapest_split() const {
    Lanes4 right_areas[few_leaves];
    CountedLanes right, left;
    for (std::uint32_t i = count_ - 1; i > 0; --i) {
      right.join(lanes(i));
      right_areas[i] = right.areas();
    }
    CheapestSplit cheapest;
    for (std::uint32_t i = 0; i + 1 < count_; ++i) {
      left.join(lanes(i));
      const auto left_count = static_cast<float>(i + 1), right_count = static_cast<float>(count_ - i - 1);
      const Lanes4 cost =
          split_cost(left.areas(), Lanes4{} + left_count, right_areas[i + 1], Lanes4{} + right_count);
      cheapest.add(keys(i) != keys(i + 1) ? cost : Lanes4{} + INFINITY, static_cast<std::int32_t>(i));
    }
    return cheapest.along_any_axis();
  }
  auto key(const AxisSplit& split) const { return keys_[order_[split.axis][split.number]][split.axis]; }

private:
  CountedLanes lanes(std::uint32_t i) const {
    return {boxes_[order_[0][i]], boxes_[order_[1][i]], boxes_[order_[2][i]]};
  }
  Keys keys(std::uint32_t i) const {
    return Keys{keys_[order_[0][i]][0], keys_[order_[1][i]][1], keys_[order_[2][i]][2], 0};
  }

  const CountedBox* boxes_;
  const Keys* keys_;
  std::uint32_t count_;
  std::uint8_t order_[3][few_leaves]{};
};

} // namespace masu
