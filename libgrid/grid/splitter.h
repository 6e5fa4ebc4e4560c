// Splitting a box of voxels into cells, top down: a kd-tree whose planes are those between the voxels, and of
// which only the leaves are kept. These are its steps for one box, for a single thread or a group of threads
// that share the box (thread_group.h); split_passes.h does them to many boxes.
#pragma once

#include "libgrid/grid/grid_layout.h"
#include "libgrid/grid/overlap/clipped_bounds.h"
#include "libgrid/structure/structure_options.h"
#include "libgrid/structure/unit_costs.h"
#include "libscene/passes/thread_group.h"
#include "libscene/scene_view.h"

#include <limits>

namespace masu {

// Kind irregular: a box is divided where the expected cost of a ray that meets it becomes least (the surface
//   area heuristic: Goldsmith & Salmon, IEEE CG&A 7(5), 1987; MacDonald & Booth, The Visual Computer 6(3),
//   1990), until no division makes it less than `alpha` times what it is. Costs are splitting_costs
//   (unit_costs.h), unless the options have another step_cost.
// Kind balance: until no cell lists more than `target` primitives, so that both halves list about as many.

static_assert(StructureOptions{}.step_cost == splitting_costs.step && splitting_costs.test == 1);

// The part of a primitive in a box of voxels: the range of those it can meet, both ends included.
struct Fragment {
  PrimitiveIndex primitive;
  std::uint16_t first[3], last[3];
  // 2^31 over the side of a square of the primitive's size, in voxels: a whole number, so that sums don't
  // depend on their order.
  std::uint32_t inverse_breadth;
};
static_assert(sizeof(Fragment) == 20);

struct Plane {
  std::int32_t axis = 0, position = 0; // between the voxels position - 1 and position
  double cost = std::numeric_limits<double>::max();
};
MASU_HD inline bool is_plane(const Plane& plane) {
  return plane.cost != std::numeric_limits<double>::max();
}

// The cheaper one; of equally cheap ones, by axis and position.
MASU_HD inline bool comes_before(const Plane& a, const Plane& b) {
  if (a.cost != b.cost) return a.cost < b.cost;
  return a.axis != b.axis ? a.axis < b.axis : a.position < b.position;
}

inline constexpr int max_planes_log2 = 3;
inline constexpr std::int32_t max_planes = 1 << max_planes_log2;

// The planes looked at in a box are at multiples of 2^spacing along each axis, few of them. How many
// fragments begin between them along x, y and z, and how many end.
using PlaneBins = std::uint32_t[2][3][max_planes + 1];

template <class Stored>
struct Splitter {
  SceneView<Stored> scene;
  GridLayout layout;
  Overlap overlap;
  StructureOptions options;
  Vec3d size;  // of a voxel
  double side; // of a cube as large

  Splitter(const SceneView<Stored>& s, const GridLayout& l, Overlap o, const StructureOptions& r)
      : scene(s), layout(l), overlap(o), options(r), size(voxel_size(l)),
        side(std::cbrt(size.x * size.y * size.z)) {}

  // Of a primitive in a box; false when there is none.
  MASU_HD bool fragment_in(const VoxelBox& root, PrimitiveIndex number, Fragment& fragment) const {
    fragment.primitive = number;
    for (int axis = 0; axis < 3; ++axis) {
      fragment.first[axis] = static_cast<std::uint16_t>(root.first[axis]);
      fragment.last[axis] = static_cast<std::uint16_t>(root.end[axis] - 1);
    }
    bool some = false;
    with_primitive(scene, number, [&](const auto& primitive) {
      const Boxd box = overlap == Overlap::box ? box_for_overlap(primitive) : bounds(primitive);
      fragment.inverse_breadth = 0x80000000U / breadth_in_voxels(breadth(primitive));
      some = has_surface(primitive) && shrink(fragment, grown(box, layout.margin));
    });
    return some;
  }

  // The plane that divides a box, if any is worth it. To be called by all threads, for the first of them;
  // `bins` is theirs to share.
  template <class ThreadGroup>
  MASU_HD Plane best_plane(const ThreadGroup& group, PlaneBins& bins, const VoxelBox& box,
                           const Fragment* fragments, std::uint32_t count) const {
    return options.kind == StructureKind::balance ? middle_plane(group, bins, box, fragments, count)
                                                  : cheapest_plane(group, bins, box, fragments, count);
  }

  // The division that makes the expected cost least.
  template <class ThreadGroup>
  MASU_HD Plane cheapest_plane(const ThreadGroup& group, PlaneBins& bins, const VoxelBox& box,
                               const Fragment* fragments, std::uint32_t count) const {
    Plane best;
    if (count == 0) return best;
    const std::int32_t apart = spacing(group, box, fragments, count);
    const Vec3i spacings{apart, apart, apart};
    count_fragments(group, bins, box, spacings, fragments, count);
    const Vec3d w = cast<double>(box.end - box.first) * size;
    const double area = w.x * w.y + w.y * w.z + w.z * w.x;
    const auto cost_of = [&](std::uint32_t listed) {
      return listed + options.step_cost * (listed > 0 ? 1 : empty_step);
    };
    const double now = cost_of(count) * area;
    for_each_plane(group, bins, box, spacings, count, [&](int axis, int position, auto below, auto above) {
      const double u = w[(axis + 1) % 3], v = w[(axis + 2) % 3];
      const double low = (position - box.first[axis]) * size[axis],
                   high = (box.end[axis] - position) * size[axis];
      const double cost =
          (u * v + low * (u + v)) * cost_of(below) + (u * v + high * (u + v)) * cost_of(above);
      // Where many are listed a division may pay only after the next one; if it leaves one side with fewer,
      // or what lies in the same place would be divided without end.
      const bool may_pay_later = count > few && std::min(below, above) <= count - count / 4;
      const double bound = now * (may_pay_later ? patience : options.alpha);
      if (cost < bound && cost < best.cost) best = {axis, position, cost};
    });
    return group.first_of_all(best);
  }

  // The most even division; of equally even ones the one across the longest side. Each axis has a few planes:
  // where all of them cut all that the box lists, no other leaves less on both sides.
  template <class ThreadGroup>
  MASU_HD Plane middle_plane(const ThreadGroup& group, PlaneBins& bins, const VoxelBox& box,
                             const Fragment* fragments, std::uint32_t count) const {
    Plane best;
    if (count <= options.target) return best;
    Vec3i spacings{};
    for (int axis = 0; axis < 3; ++axis) {
      while (((box.end[axis] - box.first[axis]) >> spacings[axis]) >= max_planes)
        spacings.set(axis, spacings[axis] + 1);
    }
    count_fragments(group, bins, box, spacings, fragments, count);
    for_each_plane(group, bins, box, spacings, count, [&](int axis, int position, auto below, auto above) {
      const double along = (box.end[axis] - box.first[axis]) * size[axis];
      const double cost = std::max(below, above) + 1 / (1 + along);
      if (std::min(below, above) < count && cost < best.cost) best = {axis, position, cost};
    });
    return group.first_of_all(best);
  }

  struct Sided {
    bool below, above;
  };
  // What of a fragment on both sides is below and above the plane; its primitive may be on one side all the
  // same.
  MASU_HD Sided cut(const Fragment& fragment, const Plane& plane, Fragment& low, Fragment& high) const {
    const std::int32_t axis = plane.axis;
    low = high = fragment;
    low.last[axis] = static_cast<std::uint16_t>(plane.position - 1);
    high.first[axis] = static_cast<std::uint16_t>(plane.position);
    Sided in{true, true};
    if (overlap == Overlap::box) return in;
    // Cutting rounds a little more than the margin foresees.
    const double margin = layout.margin * 1.0625, place = plane_at(axis, plane.position);
    with_primitive(scene, fragment.primitive, [&](const auto& primitive) {
      const ClippedBounds sides = sides_of(primitive, axis, place + margin, place - margin);
      in.below = !is_empty(sides.below) && shrink(low, grown(sides.below, margin));
      in.above = !is_empty(sides.above) && shrink(high, grown(sides.above, margin));
    });
    return in;
  }

  // Whether a box that isn't divided further lists the primitive, a fragment of which may be in it.
  MASU_HD bool lists(const VoxelBox& box, PrimitiveIndex number) const {
    if (overlap == Overlap::box) return true;
    const Boxd place{{plane_at(0, box.first.x), plane_at(1, box.first.y), plane_at(2, box.first.z)},
                     {plane_at(0, box.end.x), plane_at(1, box.end.y), plane_at(2, box.end.z)}};
    bool in = false;
    with_primitive(scene, number,
                   [&](const auto& primitive) { in = meets(primitive, place, layout.margin); });
    return in;
  }

private:
  static constexpr std::uint32_t few = 8;
  static constexpr double patience = 1.3;

  // To the voxels that meet the box; false when none is left.
  MASU_HD bool shrink(Fragment& fragment, const Boxd& box) const {
    if (is_empty(box)) return false;
    const VoxelRange range = voxels_met(layout, size, box);
    bool some = true;
    for (int axis = 0; axis < 3; ++axis) {
      fragment.first[axis] = std::max(fragment.first[axis], static_cast<std::uint16_t>(range.first[axis]));
      fragment.last[axis] = std::min(fragment.last[axis], static_cast<std::uint16_t>(range.last[axis]));
      some = some && fragment.first[axis] <= fragment.last[axis];
    }
    return some;
  }

  // From 1 to 65535. 1 where areas or volumes leave what a double holds and their quotient is no number.
  MASU_HD std::uint32_t breadth_in_voxels(double breadth) const {
    const double voxels = breadth / side;
    return voxels > 1 ? static_cast<std::uint32_t>(std::min(voxels, 65535.0)) : 1;
  }

  MASU_HD double plane_at(int axis, std::int32_t plane) const {
    return layout.space.min[axis] + plane * size[axis];
  }

  // Planes of a box are 2^spacing voxels apart: few along its longest side, since the map needs the more
  // words the finer they are for its size, and not much closer than the primitives are large, since cells
  // smaller than what they hold gain little.
  template <class ThreadGroup>
  MASU_HD std::int32_t spacing(const ThreadGroup& group, const VoxelBox& box, const Fragment* fragments,
                               std::uint32_t count) const {
    const Vec3i w = box.end - box.first;
    const std::int32_t longest = std::max(w.x, std::max(w.y, w.z));
    std::uint64_t inverse_breadths = 0;
    for (std::uint32_t i = group.thread_rank(); i < count; i += group.size())
      inverse_breadths += fragments[i].inverse_breadth;
    const double typical = count * 0x1p31 / static_cast<double>(group.sum(inverse_breadths));
    std::int32_t log2 = 0;
    while ((longest >> log2) >= max_planes || (2 << log2) * options.detail <= typical)
      ++log2;
    return log2;
  }

  // Which of the bins along an axis holds the voxel.
  MASU_HD static std::int32_t bin_of(std::int32_t voxel, const VoxelBox& box, const Vec3i& spacings,
                                     int axis) {
    return (voxel >> spacings[axis]) - (box.first[axis] >> spacings[axis]);
  }

  // Leaves in each bin the numbers of all fragments that begin, and of all that end, up to there.
  template <class ThreadGroup>
  MASU_HD static void count_fragments(const ThreadGroup& group, PlaneBins& bins, const VoxelBox& box,
                                      const Vec3i& spacings, const Fragment* fragments, std::uint32_t count) {
    std::uint32_t* const all = &bins[0][0][0];
    for (std::uint32_t i = group.thread_rank(); i < sizeof(PlaneBins) / sizeof(*all); i += group.size())
      all[i] = 0;
    group.sync();
    for (std::uint32_t i = group.thread_rank(); i < count; i += group.size()) {
      for (int axis = 0; axis < 3; ++axis) {
        group.count(bins[0][axis][bin_of(fragments[i].first[axis], box, spacings, axis)]);
        group.count(bins[1][axis][bin_of(fragments[i].last[axis], box, spacings, axis)]);
      }
    }
    group.sync();
    for (std::uint32_t i = group.thread_rank(); i < 6; i += group.size()) {
      const int axis = static_cast<int>(i % 3);
      std::uint32_t* const own = bins[i / 3][axis];
      const std::int32_t last = bin_of(box.end[axis] - 1, box, spacings, axis);
      for (std::int32_t bin = 1; bin < last; ++bin)
        own[bin] += own[bin - 1];
    }
    group.sync();
  }

  // act(axis, position, how many fragments reach below it, how many above) for each plane within the box, in
  // the planes' order along each axis; a lane has some.
  template <class ThreadGroup, class Act>
  MASU_HD static void for_each_plane(const ThreadGroup& group, const PlaneBins& bins, const VoxelBox& box,
                                     const Vec3i& spacings, std::uint32_t count, const Act& act) {
    for (int axis = 0; axis < 3; ++axis) {
      const std::int32_t last = bin_of(box.end[axis] - 1, box, spacings, axis);
      for (auto bin = static_cast<std::int32_t>(group.thread_rank()); bin < last;
           bin += static_cast<std::int32_t>(group.size())) {
        const std::int32_t position = ((box.first[axis] >> spacings[axis]) + bin + 1) << spacings[axis];
        act(axis, position, bins[0][axis][bin], count - bins[1][axis][bin]);
      }
    }
  }
};

} // namespace masu
