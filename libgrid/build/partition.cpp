#include "libgrid/build/partitioner.h"

#include <tbb/parallel_invoke.h>

namespace masu {
namespace {

constexpr std::size_t parts_a_task = 8192;

template <class Stored>
std::vector<Part> parts_in(const Partitioner<Stored>& partitioner, const VoxelBox& root,
                           std::span<const PrimitiveIndex> primitives) {
  std::vector<Part> parts;
  parts.reserve(primitives.size());
  for (const PrimitiveIndex i : primitives) {
    Part part{};
    if (partitioner.part_in(root, i, part)) parts.push_back(part);
  }
  return parts;
}

// Leaves those from `begin` on that are above the plane, and behind them puts those below; returns where
// these begin. Both keep their order.
template <class Stored>
std::size_t split(const Partitioner<Stored>& partitioner, const Plane& plane, std::vector<Part>& parts,
                  std::size_t begin) {
  const std::size_t end = parts.size();
  std::size_t above = begin;
  for (std::size_t i = begin; i != end; ++i) {
    const Part part = parts[i];
    const auto sides = partitioner.sides_of_part(part, plane);
    if (!sides.above) {
      parts.push_back(part);
    } else if (!sides.below) {
      parts[above++] = part;
    } else {
      Part low{}, high{};
      const auto in = partitioner.cut(part, plane, low, high);
      if (in.below) parts.push_back(low);
      if (in.above) parts[above++] = high;
    }
  }
  parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(above),
              parts.begin() + static_cast<std::ptrdiff_t>(end));
  return above;
}

template <class Stored>
void add_leaf(const Partitioner<Stored>& partitioner, const VoxelBox& box, std::span<const Part> parts,
              Partition& result) {
  Leaf leaf{box, static_cast<std::uint32_t>(result.references.size()), 0};
  for (const Part& part : parts) {
    if (partitioner.lists(box, part.primitive)) result.references.push_back(part.primitive);
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
void divide(const Partitioner<Stored>& partitioner, const VoxelBox& box, std::vector<Part>& parts,
            std::size_t begin, Partition& result) {
  const std::span<const Part> own(parts.data() + begin, parts.data() + parts.size());
  const auto count = static_cast<std::uint32_t>(own.size());
  PlaneBins bins;
  const Plane plane = partitioner.rule.by_cost
                          ? partitioner.cheapest_plane(OneLane{}, bins, box, own.data(), count)
                          : partitioner.middle_plane(OneLane{}, bins, box, own.data(), count);
  if (!is_plane(plane)) {
    add_leaf(partitioner, box, own, result);
    parts.resize(begin);
    return;
  }
  VoxelBox below = box, above = box;
  below.end.set(plane.axis, plane.at);
  above.first.set(plane.axis, plane.at);
  const bool large = own.size() >= parts_a_task;
  const std::size_t begin_below = split(partitioner, plane, parts, begin);
  if (large) {
    std::vector<Part> parts_below(parts.begin() + static_cast<std::ptrdiff_t>(begin_below), parts.end());
    parts.resize(begin_below);
    Partition above_result;
    tbb::parallel_invoke([&] { divide(partitioner, below, parts_below, 0, result); },
                         [&] { divide(partitioner, above, parts, begin, above_result); });
    append(above_result, result);
  } else {
    divide(partitioner, below, parts, begin_below, result);
    divide(partitioner, above, parts, begin, result);
  }
}

} // namespace

template <class Stored>
Partition partition(const SceneView<Stored>& scene, const Lattice& lattice, Overlap overlap,
                    const PartitionRule& rule, const VoxelBox& root,
                    std::span<const PrimitiveIndex> primitives) {
  const Partitioner<Stored> partitioner(scene, lattice, overlap, rule);
  Partition result;
  std::vector<Part> parts = parts_in(partitioner, root, primitives);
  divide(partitioner, root, parts, 0, result);
  return result;
}
template Partition partition(const SceneView<float>&, const Lattice&, Overlap, const PartitionRule&,
                             const VoxelBox&, std::span<const PrimitiveIndex>);
template Partition partition(const SceneView<double>&, const Lattice&, Overlap, const PartitionRule&,
                             const VoxelBox&, std::span<const PrimitiveIndex>);

} // namespace masu
