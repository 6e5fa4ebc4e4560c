#include "libgrid/hierarchy/binary/binary_hierarchy.h"

#include "libgrid/hierarchy/binary/binned_fragments.h"
#include "libgrid/hierarchy/binary/parallel_partition.h"
#include "libgrid/hierarchy/hierarchy_builder.h"
#include "libscene/base/parallel.h"

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <atomic>
#include <utility>

namespace masu {

namespace {

// Numbers of binary nodes, pair by pair, for threads that split at the same time. From 1 on: 0 is the root's.
// Threads take blocks of them: were each pair taken from one counter, threads would wait for it, and for what
// others write side by side.
class NodeNumbers {
public:
  // For so many nodes.
  explicit NodeNumbers(std::size_t nodes) : nodes_(nodes), block_(nodes > (1 << 16) ? 256 : 2) {}

  // No number is as large, whatever threads leave of their blocks.
  std::size_t end() const { return nodes_ + (block_ > 2 ? most_with_blocks * block_ : 0); }

  // A thread's own.
  struct OfThread {
    std::uint32_t block, next = 0, end = 0;
  };
  OfThread& of_thread() { return of_threads_.local(); }

  // The left one's, which the right one's follows.
  std::uint32_t pair(OfThread& own) {
    if (own.next == own.end) {
      own.next = used_.fetch_add(own.block);
      own.end = own.next + own.block;
    }
    return std::exchange(own.next, own.next + 2);
  }

private:
  static constexpr std::uint32_t most_with_blocks = 256; // threads; others take pairs

  std::size_t nodes_;
  std::uint32_t block_;
  std::atomic<std::uint32_t> used_ = 1, threads_ = 0;
  tbb::enumerable_thread_specific<OfThread> of_threads_{
      [this] { return OfThread{threads_++ < most_with_blocks ? block_ : 2}; }};
};

template <class Scene>
class BinaryBuilder {
public:
  BinaryBuilder(const Scene& scene, double margin, Leaves leaves, ProgressMonitor* progress)
      : scene_(scene), margin_(margin), progress_(progress),
        count_(static_cast<std::uint32_t>(leaves.size())), fragments_(std::move(leaves)),
        room_(static_cast<std::uint32_t>(spare_fragments * static_cast<double>(count_))),
        numbers_(2 * (std::size_t{count_} + room_)), nodes_(numbers_.end()), choices_(nodes_.size()) {
    parallel_ranges(count_, 4096, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i != end; ++i) {
        BinaryNode& fragment = fragments_[i];
        fragment.count = 0; // 1 of a whole triangle
        with_primitive(scene_, fragment.index, [&]<class Primitive>(const Primitive& primitive) {
          if constexpr (std::is_same_v<Primitive, Triangle<double>>) {
            const LaneBox own = box_of(fragment), whole = lanes_around(bounds(primitive), margin_);
            fragment.count = all_axes((own.low == whole.low) & (own.high == whole.high));
          }
        });
      }
    });
  }

  HostHierarchy build() {
    if (count_ == 0) return {};
    const FragmentRange all{fragments_.data(), count_, 0, room_};
    const LaneBox root = extent_of(all).box;
    root_area_ = half_area(boxf(root));
    const Lanes4 reach = larger(-root.low, root.high);
    slack_ = static_cast<float>(4 * margin_) + 0x1p-20F * std::max({reach[0], reach[1], reach[2]});
    split(0, all, 0, numbers_.of_thread());
    return {std::move(nodes_), std::move(choices_)};
  }

private:
  static constexpr std::uint32_t fragments_per_task = 1 << 14, fragments_per_check = 1 << 12,
                                 few_in_turns = 128;
  static constexpr WholeLanes4 one = {1, 1, 1, 1};

  // Of Sum(of …), to which add(sum, fragment) adds each; in parallel for many. It is made in its place: sums
  // are large for small ranges. Two take turns where fragments are not few: those in a row are often in one
  // bin, and each waits for what the one before has written.
  template <class Sum, class Add, class... Of>
  Sum summed(const FragmentRange& range, const Add& add, Of... of) const {
    Sum sum(of...);
    const auto added = [&](const BinaryNode* begin, const BinaryNode* end, Sum& to) {
      if (end - begin >= fragments_per_check) check_progress(progress_);
      if (end - begin > few_in_turns) {
        Sum odd(of...);
        for (; end - begin > 1; begin += 2) {
          add(to, begin[0]);
          add(odd, begin[1]);
        }
        to.join(odd);
      }
      for (; begin != end; ++begin)
        add(to, *begin);
    };
    if (range.count <= fragments_per_task) {
      added(range.begin(), range.end(), sum);
    } else {
      sum = parallel_reduce(
          range.count, fragments_per_task, sum,
          [&](std::uint64_t begin, std::uint64_t end) {
            Sum part(of...);
            added(range.begin() + begin, range.begin() + end, part);
            return part;
          },
          [](Sum a, const Sum& b) {
            a.join(b);
            return a;
          });
    }
    return sum;
  }

  Extent extent_of(const FragmentRange& range) const {
    return summed<Extent>(range, [](Extent& extent, const BinaryNode& fragment) { extent.add(fragment); });
  }

  // The cheapest split by centres.
  ObjectSplit object_split_of_few(const FragmentRange& range, const Binning& binning) const {
    const SortedFew<WholeLanes4> sorted(range.first, range.count, binning.bins_of);
    const AxisSplit cheapest = sorted.cheapest_split();
    if (cheapest.axis < 0) return {};
    ObjectSplit split{{cheapest.cost, cheapest.axis, sorted.key(cheapest)}, {}, {}};
    for (std::uint32_t i = 0; i < range.count; ++i)
      (sorted.keys[i][split.at.axis] <= split.at.number ? split.left : split.right).join(sorted.boxes[i]);
    return split;
  }
  ObjectSplit object_split_of_many(const FragmentRange& range, const Binning& binning) const {
    const auto add = [&](BinsByCentre& sum, const BinaryNode& fragment) {
      const LaneBox box = box_of(fragment);
      const WholeLanes4 in = binning.bins_of(box.twice_the_centre());
      const CountedBox counted(box, one, one);
      for (int axis = 0; axis < 3; ++axis)
        sum.at(in, axis).join(counted);
    };
    const auto bins = summed<BinsByCentre>(range, add, binning.count());
    const AxisSplit cheapest = cheapest_split(bins);
    if (cheapest.axis < 0) return {};
    ObjectSplit split{cheapest, {}, {}};
    for (int i = 0; i < bins.count; ++i)
      (i <= cheapest.number ? split.left : split.right).join(bins.along[cheapest.axis][i]);
    return split;
  }

  // What spatial splits cost at least, without cutting anything. All parts of a whole triangle together are
  // as large as its box: so whichever of its sides holds all of them is as large as that. And where one
  // crosses a plane, both sides reach as far.
  struct SpatialBounds {
    // By the last of the bins that a fragment is in, and by the first one. As many begin as there are, and
    // end as cross a plane for certain.
    BinsInSpace left, right;

    explicit SpatialBounds(int count) : left(count), right(count) {}
    void join(const SpatialBounds& other) {
      left.join(other.left);
      right.join(other.right);
    }
  };

  // Along which axes (-1) there may be a split by planes that costs less than this.
  WholeLanes4 axes_worth_splitting(const FragmentRange& range, const Binning& binning, float cost) const {
    const auto add = [&](SpatialBounds& sum, const BinaryNode& fragment) {
      const LaneBox box = box_of(fragment);
      const WholeLanes4 first = binning.bins_of(box.low), last = binning.bins_of(box.high);
      // Whether it certainly has something on either side of each plane.
      const WholeLanes4 crosses =
          (box.low + slack_ < binning.planes(first)) & (binning.planes(last - 1) < box.high - slack_);
      const bool is_whole = fragment.count != 0;
      for (int axis = 0; axis < 3; ++axis) {
        const bool counts = is_whole || first[axis] == last[axis];
        const CountedBox counted(counts ? box : LaneBox(), one,
                                 counts ? WholeLanes4{} - crosses[axis] : WholeLanes4{});
        sum.left.at(last, axis).join(counted);
        sum.right.at(first, axis).join(counted);
      }
    };
    const auto bounds = summed<SpatialBounds>(range, add, binning.count());
    CountedLanes right[bins_in_space], left; // right: of all from a bin on
    for (int bin = binning.count(); bin-- > 0;) {
      right[bin] = bounds.right.lanes(bin);
      if (bin + 1 < binning.count()) right[bin].join(right[bin + 1]);
    }
    const WholeLanes4 all = WholeLanes4{} + static_cast<std::int32_t>(range.count);
    WholeLanes4 is_cheaper{};
    for (int bin = 0; bin + 1 < binning.count(); ++bin) {
      left.join(bounds.left.lanes(bin));
      CountedLanes up_to_plane = left, from_plane = right[bin + 1];
      const WholeLanes4 left_count = all - from_plane.begin(), right_count = all - left.begin(),
                        crossing = right[0].end() - from_plane.end() - left.end();
      const Lanes4 plane = binning.planes(WholeLanes4{} + bin);
      for (int axis = 0; axis < 3; ++axis) {
        if (crossing[axis] == 0) continue;
        up_to_plane.planes[axis][axis + 4] = std::min(up_to_plane.planes[axis][axis + 4], -plane[axis]);
        from_plane.planes[axis][axis] = std::min(from_plane.planes[axis][axis], plane[axis]);
      }
      const Lanes4 least = split_cost(up_to_plane.areas_or_0(), __builtin_convertvector(left_count, Lanes4),
                                      from_plane.areas_or_0(), __builtin_convertvector(right_count, Lanes4));
      is_cheaper |= (least < cost) & (left_count > 0) & (right_count > 0);
    }
    return is_cheaper;
  }

  // What lies in each of the bins from `first` to `last` along each axis where these are several.
  [[gnu::noinline]] void add_parts(const BinaryNode& fragment, const Binning& binning, WholeLanes4 first,
                                   WholeLanes4 last, BinsInSpace& bins) const {
    const LaneBox box = box_of(fragment);
    LaneBox rest[3] = {box, box, box};
    with_primitive(scene_, fragment.index, [&](const auto& primitive) {
      cut_off_all(primitive, binning, first, last, margin_, rest, bins);
    });
    for (int axis = 0; axis < 3; ++axis)
      if (first[axis] != last[axis] && holds_something(rest[axis]))
        bins.at(last, axis).join(CountedBox(rest[axis]));
  }

  // The cheapest split by planes, at which fragments are divided, if it may cost less than this.
  AxisSplit spatial_split(const FragmentRange& range, const Binning& binning, float cost) const {
    const WholeLanes4 axes = axes_worth_splitting(range, binning, cost);
    if (axes[0] == 0 && axes[1] == 0 && axes[2] == 0) return {};
    const auto add = [&](BinsInSpace& sum, const BinaryNode& fragment) {
      const LaneBox box = box_of(fragment);
      const WholeLanes4 first = binning.bins_of(box.low) & axes, last = binning.bins_of(box.high) & axes;
      bool is_in_one = true;
      for (int axis = 0; axis < 3; ++axis) {
        if (axes[axis] == 0) continue;
        if (first[axis] == last[axis]) {
          sum.at(first, axis).join(CountedBox(box, one, one));
        } else {
          sum.at(first, axis).join(CountedBox({}, one));
          sum.at(last, axis).join(CountedBox({}, WholeLanes4{}, one));
          is_in_one = false;
        }
      }
      if (!is_in_one) add_parts(fragment, binning, first, last, sum);
    };
    const auto bins = summed<BinsInSpace>(range, add, binning.count());
    return cheapest_split(bins);
  }

  RangeSplit split_of(const FragmentRange& range, const Extent& extent, int depth) const {
    if (range.count >= fewest_halved(depth)) return {};
    const Binning by_centre(extent.centres, bins_by_centre(range.count));
    const ObjectSplit objects = range.count <= few_leaves ? object_split_of_few(range, by_centre)
                                                          : object_split_of_many(range, by_centre);
    const AxisSplit& at = objects.at;
    if (at.axis < 0) return {};
    if (range.room > 0 &&
        is_worth_splitting(boxf(common(objects.left.box(), objects.right.box())), root_area_)) {
      const Binning by_space(extent.box, bins_in_space);
      const AxisSplit space = spatial_split(range, by_space, at.cost);
      if (space.cost < at.cost) return {SplitKind::by_space, space, by_space.along[space.axis]};
    }
    return {SplitKind::by_centre, at, by_centre.along[at.axis]};
  }

  struct Halves {
    FragmentRange left, right;
  };

  // The first of them go left. Both get room and places in proportion.
  static Halves with_room(const FragmentRange& range, std::uint32_t left_count) {
    const std::uint32_t room = room_of_left(range.room, left_count, range.count),
                        places = room_of_left(range.places, left_count, range.count);
    BinaryNode* const right = range.first + left_count;
    if (places > 0) std::move_backward(right, range.end(), range.end() + places);
    return {{range.first, left_count, places, room},
            {right + places, range.count - left_count, range.places - places, range.room - room}};
  }

  // Divides what crosses the plane, as long as there is room. `moved`: memory for a range that has no more
  // places, with some for fragments that are added below.
  void divide(FragmentRange& range, const RangeSplit& split, HostArray<BinaryNode>& moved) {
    const auto divided = divided_by(range.count, progress_, [&](std::uint32_t fragment, Sides& parts) {
      return split.divides(scene_, margin_, range.first[fragment], parts);
    });
    const auto added = static_cast<std::uint32_t>(std::min<std::size_t>(divided.size(), range.room));
    if (added > range.places) {
      const std::uint32_t count = range.count + std::max(added, 16U);
      moved.resize(std::size_t{count} + count / 4);
      std::copy(range.begin(), range.end(), moved.begin());
      range.first = moved.data();
      range.places = static_cast<std::uint32_t>(moved.size()) - range.count;
    }
    for (std::uint32_t i = 0; i != added; ++i) {
      const auto& [fragment, parts] = divided[i];
      put_parts(parts, 0, range.first[fragment], range.first[range.count++]);
    }
    range.places -= added;
    range.room -= added;
  }

  // In the order of partitioned_place() (spatial_split_passes.h), too.
  Halves halves_of(FragmentRange range, const RangeSplit& split, HostArray<BinaryNode>& moved) {
    if (split.kind == SplitKind::by_space && range.room > 0) divide(range, split, moved);
    std::uint32_t left = 0;
    with_axis(split.at.axis, [&](auto axis) {
      const auto is_left = [&](const BinaryNode& fragment) { return split.is_left(fragment, axis); };
      left =
          range.count <= 64 ? partitioned(range.first, range.count, is_left)
          : range.count <= fragments_per_task
              ? static_cast<std::uint32_t>(std::partition(range.begin(), range.end(), is_left) - range.first)
              : partitioned_by_all_cores(range.first, range.count, is_left, progress_);
    });
    // Parts within the margin of an older plane may all come to lie on one side.
    return with_room(range, left == 0 || left == range.count ? range.count / 2 : left);
  }

  CollapseCosts split(std::uint32_t number, const FragmentRange& range, int depth,
                      NodeNumbers::OfThread& own) {
    BinaryNode& node = nodes_[number];
    if (range.count == 1) {
      node = *range.first;
      node.count = 1;
      return with_choice(choices_, number, collapse_costs_of_leaf(node));
    }
    const Extent extent = extent_of(range);
    const Boxf box = boxf(extent.box);
    HostArray<BinaryNode> moved;
    const Halves halves = halves_of(range, split_of(range, extent, depth), moved);
    const std::uint32_t left = numbers_.pair(own);
    CollapseCosts left_costs{}, right_costs{};
    const auto split_left = [&](NodeNumbers::OfThread& of_thread) {
      left_costs = split(left, halves.left, depth + 1, of_thread);
    };
    const auto split_right = [&](NodeNumbers::OfThread& of_thread) {
      right_costs = split(left + 1, halves.right, depth + 1, of_thread);
    };
    if (range.count > 1024) {
      parallel_invoke([&] { split_left(numbers_.of_thread()); }, [&] { split_right(numbers_.of_thread()); });
      give_back(range.first, std::size_t{range.count} + range.places);
    } else {
      split_left(own);
      split_right(own);
      if (range.count > 512 && progress_ != nullptr)
        (*progress_)(
            std::min(0.8, 0.8 * static_cast<double>(done_ += range.count) / scene_.primitive_count()));
    }
    node = node_of(box, left, nodes_[left], nodes_[left + 1]);
    return with_choice(choices_, number, collapse_costs(node, left_costs, right_costs));
  }

  const Scene& scene_;
  double margin_;
  ProgressMonitor* progress_;
  std::uint32_t count_; // of leaves
  HostArray<BinaryNode> fragments_;
  std::uint32_t room_;
  NodeNumbers numbers_;
  HostArray<BinaryNode> nodes_;
  HostArray<CollapseChoice> choices_;
  float root_area_ = 0;
  // More than what a triangle's box is larger than the triangle, and rounded by.
  float slack_ = 0;
  std::atomic<std::uint64_t> done_ = 0;
};

} // namespace

template <class Scene>
HostHierarchy binary_hierarchy(const Scene& scene, double margin, Leaves leaves, ProgressMonitor* progress) {
  // At the end of which the leaves are gone.
  return BinaryBuilder<Scene>(scene, margin, std::move(leaves), progress).build();
}
template HostHierarchy binary_hierarchy(const SceneView<float>&, double, Leaves, ProgressMonitor*);
template HostHierarchy binary_hierarchy(const SceneView<double>&, double, Leaves, ProgressMonitor*);
template HostHierarchy binary_hierarchy(const MeshesView<float, float>&, double, Leaves, ProgressMonitor*);
template HostHierarchy binary_hierarchy(const MeshesView<float, double>&, double, Leaves, ProgressMonitor*);
template HostHierarchy binary_hierarchy(const MeshesView<double, float>&, double, Leaves, ProgressMonitor*);
template HostHierarchy binary_hierarchy(const MeshesView<double, double>&, double, Leaves, ProgressMonitor*);

} // namespace masu
