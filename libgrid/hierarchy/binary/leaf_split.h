// How a range of leaves of a binary hierarchy is split: by the surface area heuristic over bins (Wald, "On
// Fast Construction of SAH-based Bounding Volume Hierarchies", RT 2007), of few leaves over all their
// centres. Who computes it (top_down_passes.h on a device, top_down_host.cpp) comes to the same.
#pragma once

#include "libgrid/hierarchy/collapse_passes.h"

#include <algorithm>

namespace masu {

MASU_HD inline float twice_the_centre(const BinaryNode& node, int axis) {
  return node.min[axis] + node.max[axis];
}

// What of a range goes left: leaves whose centres lie no farther along an axis. By none of the axes, or where
// that is all or nothing, the first half.
struct LeafSplit {
  float cost = INFINITY;
  std::int32_t axis = -1;
  float place = 0; // twice it

  MASU_HD bool is_left(const BinaryNode& leaf) const { return axis >= 0 && is_left(leaf, axis); }
  // Where its axis is known, as a constant perhaps.
  MASU_HD bool is_left(const BinaryNode& leaf, int along) const {
    return twice_the_centre(leaf, along) <= place;
  }
};
MASU_HD inline bool comes_before(const LeafSplit& a, const LeafSplit& b) {
  if (a.cost != b.cost) return a.cost < b.cost;
  return a.axis != b.axis ? a.axis < b.axis : a.place < b.place;
}

// By the areas of what is on either side, and how many leaves.
template <class Areas, class Counts>
MASU_HD Areas split_cost(Areas left, Counts left_count, Areas right, Counts right_count) {
  return left * left_count + right * right_count;
}

// Between numbered candidates along an axis.
struct AxisSplit {
  float cost = INFINITY;
  std::int32_t axis = -1; // none: everything is in one place
  std::int32_t number = 0;
};

// A range of more leaves at this depth is halved, lest the hierarchy become too deep: what is split off may
// leave one leaf fewer, which must still fit below when halved again and again.
MASU_HD inline std::uint32_t most_leaves_split(std::size_t depth) {
  return 1U << std::clamp(max_hierarchy_depth - 2 - static_cast<int>(depth), 0, 31);
}

// Few are tried one by one: any of them as the last one on the left, sorted along each axis.
inline constexpr std::uint32_t few_leaves = 8;

// Of many leaves so many are looked at: the first ones of their order, which are the largest, and others as
// far apart in it as each other, each for those up to the next.
struct LeafSample {
  static constexpr std::uint32_t most = 4096, most_first = 512;
  std::uint32_t count, first, apart;

  MASU_HD explicit LeafSample(std::uint32_t leaves)
      : count(leaves), first(std::min(leaves, std::uint32_t{most_first})),
        apart((leaves - first) / (most - most_first + 1) + 1) {}
  MASU_HD bool is_all() const { return apart == 1; }
  // act(leaf, how many it stands for), by each of `threads` for its share. A block's are of some side by side
  // each: neighbours are in the same bins, where threads that run together would wait for each other. A few
  // have theirs in memory that they share, and read it side by side.
  template <class Act>
  MASU_HD void for_each(std::uint32_t thread, std::uint32_t threads, const Act& act) const {
    const auto share = [=](std::uint32_t all, const auto& each) {
      constexpr std::uint32_t warp = 32;
      const std::uint32_t own = (all + threads - 1) / threads;
      if (threads <= warp) {
        for (std::uint32_t k = thread; k < all; k += threads)
          each(k);
        return;
      }
      const std::uint32_t end = std::min(all, (thread + 1) * own);
#ifdef __CUDA_ARCH__
#pragma unroll 4 // so many are on their way
#endif
      for (std::uint32_t k = thread * own; k < end; ++k)
        each(k);
    };
    share(first, [&](std::uint32_t i) { act(i, 1U); });
    share((count - first + apart - 1) / apart, [&](std::uint32_t k) {
      const std::uint32_t i = first + k * apart;
      act(i, std::min(apart, count - i));
    });
  }
};

// The bins along an axis that leaves are counted in by twice their centres.
inline constexpr std::int32_t max_bins = 16;
MASU_HD inline std::int32_t bin_count(std::uint32_t leaves) {
  return static_cast<std::int32_t>(std::min(leaves / 4 + 4, std::uint32_t{max_bins}));
}
struct LeafBins {
  std::int32_t count;
  float low, per_unit; // per_unit is 0 where all are in one place, or nearly

  // `centres`: twice those of the sample; `space`: twice where the range's may be. Regular things are best
  // split just where their space is, which a sample misses: so by the space, unless they are small in it.
  MASU_HD LeafBins(const LeafSample& sample, const Boxf& centres, const Boxf& space, int axis)
      : count(bin_count(sample.count)) {
    const bool by_space = !sample.is_all() &&
                          !(4 * (centres.max[axis] - centres.min[axis]) < space.max[axis] - space.min[axis]);
    const Boxf& bounds = by_space ? space : centres;
    const float scale = static_cast<float>(count) * 0.99999F / (bounds.max[axis] - bounds.min[axis]);
    low = bounds.min[axis];
    per_unit = scale < INFINITY ? scale : 0;
  }
  MASU_HD std::int32_t operator()(float centre) const {
    return std::clamp(static_cast<std::int32_t>((centre - low) * per_unit), 0, count - 1);
  }
  // Twice where a bin ends.
  MASU_HD float end(std::int32_t bin) const { return low + static_cast<float>(bin + 1) / per_unit; }
};

// Twice where the leaves of a range's halves may be.
struct SplitSpaces {
  Boxf left, right;

  MASU_HD SplitSpaces(const Boxf& space, const LeafSplit& split) : left(space), right(space) {
    if (split.axis < 0) return;
    left.max.set(split.axis, split.place);
    right.min.set(split.axis, split.place);
  }
};
MASU_HD inline Boxf twice(const Boxf& space) {
  return {space.min + space.min, space.max + space.max};
}

} // namespace masu
