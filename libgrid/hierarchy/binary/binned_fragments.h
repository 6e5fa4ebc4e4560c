// Fragments of a hierarchy of high quality in bins of their centres or of space, axes and sides of boxes in
// lanes (fragment_split.h says what for). Host only.
#pragma once

#include "libgrid/hierarchy/binary/clipped_lanes.h"
#include "libgrid/hierarchy/binary/split_lanes.h"

#include <bit>
#include <cstdint>
#include <utility>

namespace masu {

inline bool all_axes(WholeLanes4 are) {
  return (are[0] & are[1] & are[2]) != 0;
}
inline bool holds_something(const LaneBox& box) {
  return all_axes(box.low <= box.high);
}
inline LaneBox common(const LaneBox& a, const LaneBox& b) {
  return {larger(a.low, b.low), smaller(a.high, b.high)};
}

inline bool same(const LaneBox& a, const LaneBox& b) {
  return all_axes((a.low == b.low) & (a.high == b.high));
}

// Fragments are counted 1 where they are whole triangles, else 0.
inline bool is_whole_triangle(const BinaryNode& fragment) {
  return fragment.count != 0;
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
    box.join(own);
    centres.join({centre, centre});
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

struct ObjectSplit {
  AxisSplit at; // numbered by the last bin that goes left
  CountedBox left, right;
};

// Cuts what is left of a fragment across an axis where a bin ends, and adds to the bin what lies in it.
inline void cut_off(const LaneSides& primitive, LaneBox& rest, CountedBox& bin) {
  const LaneBox below = common(primitive.below, rest);
  if (holds_something(below)) bin.join(CountedBox(below));
  rest = common(primitive.above, rest);
}

// The same for each of the bins from `first` to before `last`, across each axis.
template <class Primitive>
__attribute__((flatten)) void cut_off_all(const Primitive& primitive, const Binning& binning,
                                          WholeLanes4 first, WholeLanes4 last, double margin,
                                          LaneBox (&rest)[3], BinsInSpace& bins) {
  const ClippedLanes<Primitive> clipped(primitive);
  for (int axis = 0; axis < 3; ++axis)
    for (int bin = first[axis]; bin < last[axis]; ++bin)
      cut_off(clipped.sides(axis, binning.along[axis].plane(bin), margin), rest[axis], bins.along[axis][bin]);
}

} // namespace masu
