#include "libgrid/partition.h"

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <array>
#include <limits>

namespace masu {
namespace {

// What of a primitive lies in a box of voxels: the range of those it can meet, both ends included.
struct Part {
  PrimitiveIndex primitive;
  std::array<std::uint16_t, 3> first, last;
  std::uint16_t breadth; // of all of the primitive: the side of a square of its size, in voxels
};
static_assert(sizeof(Part) == 20);

struct Plane {
  int axis = 0;
  std::int32_t at = 0; // between the voxels at - 1 and at
  double cost = std::numeric_limits<double>::max();
};

// The parts of a primitive on either side of a plane: bounds of what is at most `low` along the axis, and of
// what is at least `high`.
struct Sides {
  Boxd below, above;
};

Sides sides_of(const Triangle<double>& triangle, int axis, double low, double high) {
  const std::array corners{triangle.a, triangle.b, triangle.c};
  Sides sides{empty_box<double>(), empty_box<double>()};
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3d &p = corners[i], &q = corners[(i + 1) % 3];
    if (p[axis] <= low) sides.below = join(sides.below, p);
    if (p[axis] >= high) sides.above = join(sides.above, p);
    const auto meeting = [&](double plane) {
      Vec3d at = p + (q - p) * ((plane - p[axis]) / (q[axis] - p[axis]));
      at.set(axis, plane);
      return at;
    };
    if ((p[axis] < low) != (q[axis] < low) && p[axis] != low && q[axis] != low)
      sides.below = join(sides.below, meeting(low));
    if ((p[axis] < high) != (q[axis] < high) && p[axis] != high && q[axis] != high)
      sides.above = join(sides.above, meeting(high));
  }
  return sides;
}

Sides sides_of(const Sphere<double>& sphere, int axis, double low, double high) {
  const Boxd whole = bounds(sphere);
  Sides sides{whole, whole};
  const auto cut = [&](Boxd& box, double plane, bool below) {
    const double off = plane - sphere.center[axis], radius = std::abs(sphere.radius);
    if (below ? off < -radius : off > radius) {
      box = empty_box<double>();
      return;
    }
    // The plane's circle is the widest place of what is cut off short of the middle.
    if (below ? off < 0 : off > 0) {
      const double across = std::sqrt(std::max(0.0, radius * radius - off * off));
      box = grown(Boxd{sphere.center, sphere.center}, across);
      box.min.set(axis, whole.min[axis]);
      box.max.set(axis, whole.max[axis]);
    }
    (below ? box.max : box.min).set(axis, std::clamp(plane, whole.min[axis], whole.max[axis]));
  };
  cut(sides.below, low, true);
  cut(sides.above, high, false);
  return sides;
}

Sides sides_of(const Cone<double>& cone, int axis, double low, double high) {
  Sides sides{bounds(cone), bounds(cone)};
  if (sides.below.min[axis] > low) sides.below = empty_box<double>();
  if (sides.above.max[axis] < high) sides.above = empty_box<double>();
  sides.below.max.set(axis, std::min(sides.below.max[axis], low));
  sides.above.min.set(axis, std::max(sides.above.min[axis], high));
  return sides;
}

// The side of a square as large as what is seen of the primitive from where it is seen best.
double breadth(const Triangle<double>& triangle) {
  return std::sqrt(length(cross(triangle.b - triangle.a, triangle.c - triangle.a)) / 2);
}
double breadth(const Sphere<double>& sphere) {
  return 2 * std::abs(sphere.radius);
}
double breadth(const Cone<double>& cone) {
  return std::sqrt(length(cone.apex - cone.base) * (std::abs(cone.base_radius) + std::abs(cone.apex_radius)));
}

template <class Stored>
class Partitioner {
public:
  Partitioner(const SceneView<Stored>& scene, const Lattice& lattice, Overlap overlap,
              const PartitionRule& rule)
      : scene_(scene), lattice_(lattice), size_(voxel_size(lattice)),
        side_(std::cbrt(size_.x * size_.y * size_.z)), overlap_(overlap), rule_(rule) {}

  std::vector<Part> parts_in(const VoxelBox& root, std::span<const PrimitiveIndex> primitives) const {
    std::vector<Part> parts;
    parts.reserve(primitives.size());
    for (const PrimitiveIndex i : primitives) {
      with_primitive(scene_, i, [&](const auto& primitive) {
        const Boxd box = overlap_ == Overlap::box ? box_for_overlap(primitive) : bounds(primitive);
        Part part{i, {}, {}, 0};
        for (std::size_t axis = 0; axis < 3; ++axis) {
          part.first[axis] = static_cast<std::uint16_t>(root.first[static_cast<int>(axis)]);
          part.last[axis] = static_cast<std::uint16_t>(root.end[static_cast<int>(axis)] - 1);
        }
        part.breadth = static_cast<std::uint16_t>(std::clamp(breadth(primitive) / side_, 1.0, 65535.0));
        if (shrink(part, grown(box, lattice_.margin))) parts.push_back(part);
      });
    }
    return parts;
  }

  // What parts[begin] and those after it are of; they are gone afterwards.
  void divide(const VoxelBox& box, std::vector<Part>& parts, std::size_t begin, Partition& result) const {
    const std::span<const Part> own(parts.data() + begin, parts.data() + parts.size());
    const Plane plane = rule_.by_cost ? cheapest_plane(box, own) : middle_plane(box, own);
    if (plane.cost == std::numeric_limits<double>::max()) {
      add_leaf(box, own, result);
      parts.resize(begin);
      return;
    }
    VoxelBox below = box, above = box;
    below.end.set(plane.axis, plane.at);
    above.first.set(plane.axis, plane.at);
    const bool large = own.size() >= parts_a_task;
    const std::size_t begin_below = split(plane, parts, begin);
    if (large) {
      std::vector<Part> parts_below(parts.begin() + static_cast<std::ptrdiff_t>(begin_below), parts.end());
      parts.resize(begin_below);
      Partition above_result;
      tbb::parallel_invoke([&] { divide(below, parts_below, 0, result); },
                           [&] { divide(above, parts, begin, above_result); });
      append(above_result, result);
    } else {
      divide(below, parts, begin_below, result);
      divide(above, parts, begin, result);
    }
  }

private:
  static constexpr std::size_t parts_a_task = 8192;
  static constexpr int most_planes_log2 = 3;
  static constexpr std::size_t few = 8;
  static constexpr double patience = 1.3;

  // To the voxels that meet the box; false when none is left.
  bool shrink(Part& part, const Boxd& box) const {
    if (is_empty(box)) return false;
    const VoxelRange range = voxels_met(lattice_, size_, box);
    bool some = true;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const int a = static_cast<int>(axis);
      part.first[axis] = std::max(part.first[axis], static_cast<std::uint16_t>(range.first[a]));
      part.last[axis] = std::min(part.last[axis], static_cast<std::uint16_t>(range.last[a]));
      some = some && part.first[axis] <= part.last[axis];
    }
    return some;
  }

  double plane_at(int axis, std::int32_t plane) const {
    return lattice_.space.min[axis] + plane * size_[axis];
  }

  // Leaves those from `begin` on that are above the plane, and behind them puts those below; returns where
  // these begin. Both keep their order.
  std::size_t split(const Plane& plane, std::vector<Part>& parts, std::size_t begin) const {
    const auto axis = static_cast<std::size_t>(plane.axis);
    const auto at = static_cast<std::uint16_t>(plane.at);
    // Cutting rounds a little more than the margin foresees.
    const double margin = lattice_.margin * 1.0625, place = plane_at(plane.axis, plane.at);
    const std::size_t end = parts.size();
    std::size_t above = begin;
    for (std::size_t i = begin; i != end; ++i) {
      const Part part = parts[i];
      if (part.last[axis] < at) {
        parts.push_back(part);
        continue;
      }
      if (part.first[axis] >= at) {
        parts[above++] = part;
        continue;
      }
      Part low = part, high = part;
      low.last[axis] = static_cast<std::uint16_t>(at - 1);
      high.first[axis] = at;
      bool is_below = true, is_above = true;
      if (overlap_ == Overlap::exact) {
        with_primitive(scene_, part.primitive, [&](const auto& primitive) {
          const Sides sides = sides_of(primitive, plane.axis, place + margin, place - margin);
          is_below = !is_empty(sides.below) && shrink(low, grown(sides.below, margin));
          is_above = !is_empty(sides.above) && shrink(high, grown(sides.above, margin));
        });
      }
      if (is_below) parts.push_back(low);
      if (is_above) parts[above++] = high;
    }
    parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(above),
                parts.begin() + static_cast<std::ptrdiff_t>(end));
    return above;
  }

  // Planes of a box are 2^spacing voxels apart: few along its longest side, since the map needs the more
  // words the finer they are for its size, and not much closer than the primitives are large, since cells
  // smaller than what they hold gain little.
  int spacing(const VoxelBox& box, std::span<const Part> parts) const {
    const Vec3i w = box.end - box.first;
    const std::int32_t longest = std::max({w.x, w.y, w.z});
    double inverse_breadths = 0;
    for (const Part& part : parts)
      inverse_breadths += 1.0 / part.breadth;
    const double typical = static_cast<double>(parts.size()) / inverse_breadths;
    int log2 = 0;
    while ((longest >> log2) >= (1 << most_planes_log2) || (2 << log2) * rule_.detail <= typical)
      ++log2;
    return log2;
  }

  // Along one axis of a box, what begins and ends between planes.
  struct Bins {
    std::int32_t first = 0, count = 0;
    std::array<std::uint32_t, (1 << most_planes_log2) + 1> begins{}, ends{};
  };

  // act(plane, parts below it, parts above it) for each plane of the spacing within the box.
  template <class Act>
  static void for_each_plane(const VoxelBox& box, std::span<const Part> parts, int axis, int spacing,
                             const Act& act) {
    Bins bins;
    bins.first = box.first[axis] >> spacing;
    bins.count = ((box.end[axis] - 1) >> spacing) - bins.first + 1;
    if (bins.count < 2) return;
    const auto a = static_cast<std::size_t>(axis);
    for (const Part& part : parts) {
      ++bins.begins[static_cast<std::size_t>((part.first[a] >> spacing) - bins.first)];
      ++bins.ends[static_cast<std::size_t>((part.last[a] >> spacing) - bins.first)];
    }
    std::uint32_t below = 0, above = static_cast<std::uint32_t>(parts.size());
    for (std::int32_t i = 1; i < bins.count; ++i) {
      below += bins.begins[static_cast<std::size_t>(i - 1)];
      above -= bins.ends[static_cast<std::size_t>(i - 1)];
      act((bins.first + i) << spacing, below, above);
    }
  }

  Plane cheapest_plane(const VoxelBox& box, std::span<const Part> parts) const {
    Plane best;
    if (parts.empty()) return best;
    const Vec3d w = cast<double>(box.end - box.first) * size_;
    const double area = w.x * w.y + w.y * w.z + w.z * w.x;
    const auto cost_of = [&](std::uint32_t count) {
      return count + rule_.step_over_test * (count > 0 ? 1 : 0.5);
    };
    const auto count = static_cast<std::uint32_t>(parts.size());
    const double now = cost_of(count) * area;
    const int apart = spacing(box, parts);
    for (int axis = 0; axis < 3; ++axis) {
      const double u = w[(axis + 1) % 3], v = w[(axis + 2) % 3];
      for_each_plane(box, parts, axis, apart, [&](std::int32_t at, std::uint32_t below, std::uint32_t above) {
        const double low = (at - box.first[axis]) * size_[axis], high = (box.end[axis] - at) * size_[axis];
        const double cost =
            (u * v + low * (u + v)) * cost_of(below) + (u * v + high * (u + v)) * cost_of(above);
        // Where many are listed a division may pay only after the next one; if it leaves one side with fewer,
        // or what lies in the same place would be divided without end.
        const bool may_pay_later = count > few && std::min(below, above) <= count - count / 4;
        const double bound = now * (may_pay_later ? patience : rule_.alpha);
        if (cost < bound && cost < best.cost) best = {axis, at, cost};
      });
    }
    return best;
  }

  // The most even division; of equally even ones the one across the longest side. Each axis has a few planes:
  // where all of them cut all that the box lists, no other leaves less on both sides.
  Plane middle_plane(const VoxelBox& box, std::span<const Part> parts) const {
    Plane best;
    if (parts.size() <= rule_.target) return best;
    for (int axis = 0; axis < 3; ++axis) {
      int apart = 0;
      while (((box.end[axis] - box.first[axis]) >> apart) >= (1 << most_planes_log2))
        ++apart;
      const double side = (box.end[axis] - box.first[axis]) * size_[axis];
      for_each_plane(box, parts, axis, apart, [&](std::int32_t at, std::uint32_t below, std::uint32_t above) {
        const double cost = std::max(below, above) + 1 / (1 + side);
        if (std::min(below, above) < parts.size() && cost < best.cost) best = {axis, at, cost};
      });
    }
    return best;
  }

  void add_leaf(const VoxelBox& box, std::span<const Part> parts, Partition& result) const {
    Leaf leaf{box, static_cast<std::uint32_t>(result.references.size()), 0};
    const Boxd place{{plane_at(0, box.first.x), plane_at(1, box.first.y), plane_at(2, box.first.z)},
                     {plane_at(0, box.end.x), plane_at(1, box.end.y), plane_at(2, box.end.z)}};
    for (const Part& part : parts) {
      bool in = true;
      if (overlap_ == Overlap::exact) {
        with_primitive(scene_, part.primitive,
                       [&](const auto& primitive) { in = meets(primitive, place, lattice_.margin); });
      }
      if (in) result.references.push_back(part.primitive);
    }
    leaf.count = static_cast<std::uint32_t>(result.references.size()) - leaf.begin;
    result.leaves.push_back(leaf);
  }

  static void append(const Partition& more, Partition& result) {
    const auto offset = static_cast<std::uint32_t>(result.references.size());
    for (Leaf leaf : more.leaves) {
      leaf.begin += offset;
      result.leaves.push_back(leaf);
    }
    result.references.insert(result.references.end(), more.references.begin(), more.references.end());
  }

  const SceneView<Stored>& scene_;
  const Lattice& lattice_;
  Vec3d size_;  // of a voxel
  double side_; // of a cube as large
  Overlap overlap_;
  const PartitionRule& rule_;
};

} // namespace

template <class Stored>
Partition partition(const SceneView<Stored>& scene, const Lattice& lattice, Overlap overlap,
                    const PartitionRule& rule, const VoxelBox& root,
                    std::span<const PrimitiveIndex> primitives) {
  const Partitioner<Stored> partitioner(scene, lattice, overlap, rule);
  Partition result;
  std::vector<Part> parts = partitioner.parts_in(root, primitives);
  partitioner.divide(root, parts, 0, result);
  return result;
}
template Partition partition(const SceneView<float>&, const Lattice&, Overlap, const PartitionRule&,
                             const VoxelBox&, std::span<const PrimitiveIndex>);
template Partition partition(const SceneView<double>&, const Lattice&, Overlap, const PartitionRule&,
                             const VoxelBox&, std::span<const PrimitiveIndex>);

} // namespace masu
