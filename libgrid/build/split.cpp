#include "libgrid/build/splitter.h"

#include <tbb/parallel_invoke.h>

namespace masu {
namespace {

constexpr std::size_t parts_a_task = 8192;

template <class Stored>
std::vector<Fragment> parts_in(const Splitter<Stored>& splitter, const VoxelBox& root,
                               std::span<const PrimitiveIndex> primitives) {
  std::vector<Fragment> parts;
  parts.reserve(primitives.size());
  for (const PrimitiveIndex i : primitives) {
    Fragment part{};
    if (splitter.part_in(root, i, part)) parts.push_back(part);
  }
  return parts;
}

// Leaves those from `begin` on that are above the plane, and behind them puts those below; returns where
// these begin. Both keep their order.
template <class Stored>
std::size_t split(const Splitter<Stored>& splitter, const Plane& plane, std::vector<Fragment>& parts,
                  std::size_t begin) {
  const std::size_t end = parts.size();
  std::size_t above = begin;
  for (std::size_t i = begin; i != end; ++i) {
    const Fragment part = parts[i];
    const auto sides = splitter.sides_of_part(part, plane);
    if (!sides.above) {
      parts.push_back(part);
    } else if (!sides.below) {
      parts[above++] = part;
    } else {
      Fragment low{}, high{};
      const auto in = splitter.cut(part, plane, low, high);
      if (in.below) parts.push_back(low);
      if (in.above) parts[above++] = high;
    }
  }
  parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(above),
              parts.begin() + static_cast<std::ptrdiff_t>(end));
  return above;
}

template <class Stored>
void add_leaf(const Splitter<Stored>& splitter, const VoxelBox& box, std::span<const Fragment> parts,
              Partition& result) {
  Leaf leaf{box, static_cast<std::uint32_t>(result.references.size()), 0};
  for (const Fragment& part : parts) {
    if (splitter.lists(box, part.primitive)) result.references.push_back(part.primitive);
  }
  leaf.count = static_cast<std::uint32_t>(result.references.size()) - leaf.begin;
  result.leaves.push_back(leaf);
}

void append(const Partition& more, Partition& result) {
  const auto offset = static_cast<std::uint32_t>(result.references.size());
  for (Leaf leaf : more.leaves) {
    leaf.begin += offset;
    result.leaves.push_back(leaf);
  }
  result.references.insert(result.references.end(), more.references.begin(), more.references.end());
}

// What parts[begin] and those after it are of; they are gone afterwards.
template <class Stored>
void divide(const Splitter<Stored>& splitter, const VoxelBox& box, std::vector<Fragment>& parts,
            std::size_t begin, Partition& result) {
  const std::span<const Fragment> own(parts.data() + begin, parts.data() + parts.size());
  const auto count = static_cast<std::uint32_t>(own.size());
  PlaneBins bins;
  const Plane plane = splitter.rule.by_cost
                          ? splitter.cheapest_plane(SingleThread{}, bins, box, own.data(), count)
                          : splitter.middle_plane(SingleThread{}, bins, box, own.data(), count);
  if (!is_plane(plane)) {
    add_leaf(splitter, box, own, result);
    parts.resize(begin);
    return;
  }
  VoxelBox below = box, above = box;
  below.end.set(plane.axis, plane.at);
  above.first.set(plane.axis, plane.at);
  const bool large = own.size() >= parts_a_task;
  const std::size_t begin_below = split(splitter, plane, parts, begin);
  if (large) {
    std::vector<Fragment> parts_below(parts.begin() + static_cast<std::ptrdiff_t>(begin_below), parts.end());
    parts.resize(begin_below);
    Partition above_result;
    tbb::parallel_invoke([&] { divide(splitter, below, parts_below, 0, result); },
                         [&] { divide(splitter, above, parts, begin, above_result); });
    append(above_result, result);
  } else {
    divide(splitter, below, parts, begin_below, result);
    divide(splitter, above, parts, begin, result);
  }
}

} // namespace

template <class Stored>
Partition partition(const SceneView<Stored>& scene, const GridLayout& layout, Overlap overlap,
                    const PartitionRule& rule, const VoxelBox& root,
                    std::span<const PrimitiveIndex> primitives) {
  const Splitter<Stored> splitter(scene, layout, overlap, rule);
  Partition result;
  std::vector<Fragment> parts = parts_in(splitter, root, primitives);
  divide(splitter, root, parts, 0, result);
  return result;
}
template Partition partition(const SceneView<float>&, const GridLayout&, Overlap, const PartitionRule&,
                             const VoxelBox&, std::span<const PrimitiveIndex>);
template Partition partition(const SceneView<double>&, const GridLayout&, Overlap, const PartitionRule&,
                             const VoxelBox&, std::span<const PrimitiveIndex>);

} // namespace masu
