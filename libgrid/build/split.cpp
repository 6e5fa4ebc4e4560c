#include "libgrid/build/splitter.h"

#include <tbb/parallel_invoke.h>

namespace masu {
namespace {

constexpr std::size_t fragments_a_task = 8192;

template <class Stored>
std::vector<Fragment> fragments_in(const Splitter<Stored>& splitter, const VoxelBox& root,
                                   std::span<const PrimitiveIndex> primitives) {
  std::vector<Fragment> fragments;
  fragments.reserve(primitives.size());
  for (const PrimitiveIndex i : primitives) {
    Fragment fragment{};
    if (splitter.fragment_in(root, i, fragment)) fragments.push_back(fragment);
  }
  return fragments;
}

// Leaves those from `begin` on that are above the plane, and behind them puts those below; returns where
// these begin. Both keep their order.
template <class Stored>
std::size_t split(const Splitter<Stored>& splitter, const Plane& plane, std::vector<Fragment>& fragments,
                  std::size_t begin) {
  const std::size_t end = fragments.size();
  std::size_t above = begin;
  for (std::size_t i = begin; i != end; ++i) {
    const Fragment fragment = fragments[i];
    const auto sides = splitter.sides_of_fragment(fragment, plane);
    if (!sides.above) {
      fragments.push_back(fragment);
    } else if (!sides.below) {
      fragments[above++] = fragment;
    } else {
      Fragment low{}, high{};
      const auto in = splitter.cut(fragment, plane, low, high);
      if (in.below) fragments.push_back(low);
      if (in.above) fragments[above++] = high;
    }
  }
  fragments.erase(fragments.begin() + static_cast<std::ptrdiff_t>(above),
                  fragments.begin() + static_cast<std::ptrdiff_t>(end));
  return above;
}

template <class Stored>
void add_leaf(const Splitter<Stored>& splitter, const VoxelBox& box, std::span<const Fragment> fragments,
              Partition& result) {
  Leaf leaf{box, static_cast<std::uint32_t>(result.references.size()), 0};
  for (const Fragment& fragment : fragments) {
    if (splitter.lists(box, fragment.primitive)) result.references.push_back(fragment.primitive);
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

// What fragments[begin] and those after it are of; they are gone afterwards.
template <class Stored>
void divide(const Splitter<Stored>& splitter, const VoxelBox& box, std::vector<Fragment>& fragments,
            std::size_t begin, Partition& result) {
  const std::span<const Fragment> own(fragments.data() + begin, fragments.data() + fragments.size());
  const auto count = static_cast<std::uint32_t>(own.size());
  PlaneBins bins;
  const Plane plane = splitter.options.kind == GridKind::irregular
                          ? splitter.cheapest_plane(SingleThread{}, bins, box, own.data(), count)
                          : splitter.middle_plane(SingleThread{}, bins, box, own.data(), count);
  if (!is_plane(plane)) {
    add_leaf(splitter, box, own, result);
    fragments.resize(begin);
    return;
  }
  VoxelBox below = box, above = box;
  below.end.set(plane.axis, plane.at);
  above.first.set(plane.axis, plane.at);
  const bool large = own.size() >= fragments_a_task;
  const std::size_t begin_below = split(splitter, plane, fragments, begin);
  if (large) {
    std::vector<Fragment> fragments_below(fragments.begin() + static_cast<std::ptrdiff_t>(begin_below),
                                          fragments.end());
    fragments.resize(begin_below);
    Partition above_result;
    tbb::parallel_invoke([&] { divide(splitter, below, fragments_below, 0, result); },
                         [&] { divide(splitter, above, fragments, begin, above_result); });
    append(above_result, result);
  } else {
    divide(splitter, below, fragments, begin_below, result);
    divide(splitter, above, fragments, begin, result);
  }
}

} // namespace

template <class Stored>
Partition partition(const SceneView<Stored>& scene, const GridLayout& layout, Overlap overlap,
                    const GridOptions& options, const VoxelBox& root,
                    std::span<const PrimitiveIndex> primitives) {
  const Splitter<Stored> splitter(scene, layout, overlap, options);
  Partition result;
  std::vector<Fragment> fragments = fragments_in(splitter, root, primitives);
  divide(splitter, root, fragments, 0, result);
  return result;
}
template Partition partition(const SceneView<float>&, const GridLayout&, Overlap, const GridOptions&,
                             const VoxelBox&, std::span<const PrimitiveIndex>);
template Partition partition(const SceneView<double>&, const GridLayout&, Overlap, const GridOptions&,
                             const VoxelBox&, std::span<const PrimitiveIndex>);

} // namespace masu
