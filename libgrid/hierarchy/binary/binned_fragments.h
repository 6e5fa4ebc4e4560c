// Leaves and fragments in bins of their centres or of space, and splits by the surface area heuristic, axes
// and sides of boxes in lanes (leaf_split.h and fragment_split.h say what for). Host only.
#pragma once

#include "libgrid/hierarchy/binary/clipped_lanes.h"

#include <bit>
#include <concepts>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>

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

// The boxes of few nodes, sorted along each axis by keys, key_of(twice their centres); equal ones in their
// order.
template <class Keys>
class SortedFew {
public:
  CountedBox boxes[few_leaves];
  Keys keys[few_leaves];

  template <class KeyOf>
  SortedFew(const BinaryNode* nodes, std::uint32_t count, const KeyOf& key_of) : count_(count) {
    for (std::uint32_t i = 0; i < count; ++i) {
      const LaneBox box = box_of(nodes[i]);
      boxes[i] = CountedBox(box);
      keys[i] = key_of(box.twice_the_centre());
    }
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
      cheapest.add(ordered_keys(i) != ordered_keys(i + 1) ? cost : Lanes4{} + INFINITY,
                   static_cast<std::int32_t>(i));
    }
    return cheapest.along_any_axis();
  }
  auto key(const AxisSplit& split) const { return keys[order_[split.axis][split.number]][split.axis]; }

private:
  CountedLanes lanes(std::uint32_t i) const {
    return {boxes[order_[0][i]], boxes[order_[1][i]], boxes[order_[2][i]]};
  }
  Keys ordered_keys(std::uint32_t i) const {
    return Keys{keys[order_[0][i]][0], keys[order_[1][i]][1], keys[order_[2][i]][2], 0};
  }

  std::uint32_t count_;
  std::uint8_t order_[3][few_leaves]{};
};

inline bool all_axes(WholeLanes4 are) {
  return (are[0] & are[1] & are[2]) != 0;
}
inline bool holds_something(const LaneBox& box) {
  return all_axes(box.low <= box.high);
}
inline LaneBox common(const LaneBox& a, const LaneBox& b) {
  return {larger(a.low, b.low), smaller(a.high, b.high)};
}

// Fragments that are in a node, and places in memory after them. `room`: how many more they may become.
struct FragmentRange {
  BinaryNode* first;
  std::uint32_t count, places, room;

  BinaryNode* begin() const { return first; }
  BinaryNode* end() const { return first + count; }
};

struct Extent {
  LaneBox box, centres;

  void add(const BinaryNode& fragment) {
    const LaneBox own = box_of(fragment);
    const Lanes4 centre = own.twice_the_centre();
    join({own, {centre, centre}});
  }
  void join(const Extent& other) {
    box.join(other.box);
    centres.join(other.centres);
  }
};

// By centre: the fragments whose centres are in a bin, as many begin as end. By space: the parts in it of
// fragments.
using BinsByCentre = AxisBins<most_bins>;
using BinsInSpace = AxisBins<bins_in_space>;

struct Binning {
  FragmentBins along[3];
  BinLanes bins_of;
  Lanes4 low, unit;

  Binning(const LaneBox& box, int bins)
      : along{{box.low[0], box.high[0], bins},
              {box.low[1], box.high[1], bins},
              {box.low[2], box.high[2], bins}},
        bins_of(along), low(box.low), unit{along[0].unit, along[1].unit, along[2].unit} {}
  int count() const { return along[0].count; }
  // That end bins.
  Lanes4 planes(WholeLanes4 bin) const { return low + unit * __builtin_convertvector(bin + 1, Lanes4); }
};

// As std::partition() does, up to 64 of them; but it can't be predicted which one goes where.
template <class IsLeft>
std::uint32_t partitioned(BinaryNode* fragments, std::uint32_t count, const IsLeft& is_left) {
  std::uint64_t lefts = 0; // a bit each
  for (std::uint32_t i = 0; i < count; ++i)
    lefts |= std::uint64_t{is_left(fragments[i])} << i;
  const auto left = static_cast<std::uint32_t>(std::popcount(lefts));
  const std::uint64_t places = left < 64 ? (std::uint64_t{1} << left) - 1 : ~std::uint64_t{0};
  // As many are right of them as are wrong among them.
  for (std::uint64_t to_left = lefts & ~places, to_right = places & ~lefts; to_right != 0;
       to_right &= to_right - 1) {
    const int last = 63 - std::countl_zero(to_left);
    std::swap(fragments[std::countr_zero(to_right)], fragments[last]);
    to_left ^= std::uint64_t{1} << last;
  }
  return left;
}

// Stores a node's choice; returns its costs.
inline CollapseCosts with_choice(HostArray<CollapseChoice>& choices, std::uint32_t number,
                                 const CollapseCosts& costs) {
  choices[number] = costs.choice;
  return costs;
}

struct ObjectSplit {
  AxisSplit at; // numbered by the last bin that goes left
  CountedBox left, right;
};

// Cuts what is left of a fragment across each axis where the bins from `first` to before `last` end, and adds
// to each bin what lies in it.
template <class Primitive>
__attribute__((flatten)) void cut_off_all(const Primitive& primitive, const Binning& binning,
                                          WholeLanes4 first, WholeLanes4 last, double margin,
                                          LaneBox (&rest)[3], BinsInSpace& bins) {
  const ClippedLanes<Primitive> clipped(primitive);
  for (int axis = 0; axis < 3; ++axis)
    for (int bin = first[axis]; bin < last[axis]; ++bin) {
      const LaneSides sides = clipped.sides(axis, binning.along[axis].plane(bin), margin);
      const LaneBox below = common(sides.below, rest[axis]);
      if (holds_something(below)) bins.along[axis][bin].join(CountedBox(below));
      rest[axis] = common(sides.above, rest[axis]);
    }
}

} // namespace masu
