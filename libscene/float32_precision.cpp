#include "libscene/float32_precision.h"

#include "libscene/base/parallel.h"
#include "libscene/geometry/cone.h"
#include "libscene/geometry/margin.h"
#include "libscene/mesh/indexed_mesh.h"
#include "libscene/scene_bounds.h"

#include <xxhash.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <limits>
#include <vector>

namespace masu {
namespace {

constexpr std::size_t grain = 4096;

// Calls act(record, part, index) for every record, in parallel, and joins the parts by `+=`.
template <class Part, class Records, class Act>
Part gathered(const Records& records, const ProgressMonitor* progress, const Act& act) {
  const auto of_range = [&](std::size_t begin, std::size_t end) __attribute__((flatten)) {
    check_progress(progress);
    Part part;
    for (std::size_t i = begin; i != end; ++i)
      act(records[i], part, i);
    return part;
  };
  return parallel_reduce(records.size(), grain, Part{}, of_range,
                         [](Part& all, const Part& part) { return std::move(all += part); });
}

template <class T>
double extent(const Box<T>& box) {
  return largest_magnitude(cast<double>(box.max) - cast<double>(box.min));
}

// --- Rounding -------------------------------------------------------------------------------------------

double rounding_of(double value) {
  return std::abs(value - static_cast<double>(static_cast<float>(value)));
}
double rounding_of(const Vec3d& v) {
  return max(rounding_of(v.x), max(rounding_of(v.y), rounding_of(v.z)));
}
double rounding_of(const SceneTriangle& t) {
  return max(rounding_of(t.a), max(rounding_of(t.b), rounding_of(t.c)));
}
double rounding_of(const Sphere<double>& s) {
  return std::max(rounding_of(s.center), rounding_of(s.radius));
}
double rounding_of(const Cone<double>& c) {
  return std::max(
      {rounding_of(c.base), rounding_of(c.apex), rounding_of(c.base_radius), rounding_of(c.apex_radius)});
}

// How far rounding moves a cone's side at most: its ends, its radii, and its rims by the turn of its axis.
double movement_of(const Cone<double>& cone) {
  const auto stored = cast<float>(cone);
  if (is_empty(bounds(stored))) return std::numeric_limits<double>::infinity(); // no length
  const Cone<double> rounded = widened(stored);
  const Vec3d axis = normalized(cone.apex - cone.base), turned = normalized(rounded.apex - rounded.base);
  const double radius = std::max(std::abs(cone.base_radius), std::abs(cone.apex_radius));
  return std::max(length(rounded.base - cone.base), length(rounded.apex - cone.apex)) +
         std::max(rounding_of(cone.base_radius), rounding_of(cone.apex_radius)) +
         radius * length(turned - axis);
}

// --- Triangles that stand alone -------------------------------------------------------------------------

using Corner = Vec3f;

// As it is stored; -0 becomes 0, to which it is equal.
Corner corner_of(const Vec3d& v) {
  const auto stored = cast<float>(v);
  return {stored.x + 0.0F, stored.y + 0.0F, stored.z + 0.0F};
}

// The corners of small triangles, and which of them are connected by these triangles (union-find).
class SmallSurfaces {
public:
  explicit SmallSurfaces(std::size_t max_corners) : slots_(std::bit_ceil(2 * max_corners), none) {}

  std::size_t corner_count() const { return corners_.size(); }

  // The index of a corner.
  std::uint32_t add(const Corner& corner) {
    std::uint32_t& slot = slots_[slot_of(corner)];
    if (slot == none) {
      slot = static_cast<std::uint32_t>(corners_.size());
      corners_.push_back(corner);
      parents_.push_back(slot);
      box_ = join(box_, corner);
    }
    return slot;
  }

  // The same; `none` where it isn't a corner.
  std::uint32_t find(const Corner& corner) const {
    return contains(box_, corner) ? slots_[slot_of(corner)] : none;
  }

  void connect(std::uint32_t a, std::uint32_t b) { parents_[root(a)] = root(b); }

  // The number of surfaces no larger than `size` without a corner that is marked.
  std::uint64_t count_alone(const std::vector<std::atomic<bool>>& marked, double size) {
    std::vector<Box<float>> boxes(corners_.size(), empty_box<float>());
    std::vector<bool> attached(corners_.size());
    for (std::uint32_t i = 0; i < corners_.size(); ++i) {
      const std::uint32_t surface = root(i);
      boxes[surface] = join(boxes[surface], corners_[i]);
      if (marked[i]) attached[surface] = true;
    }
    std::uint64_t count = 0;
    for (std::uint32_t i = 0; i < corners_.size(); ++i)
      count += parents_[i] == i && !attached[i] && extent(boxes[i]) <= size ? 1 : 0;
    return count;
  }

  static constexpr std::uint32_t none = 0xffffffffU;

private:
  // Where the corner's index is, or `none` for it to be written.
  std::size_t slot_of(const Corner& corner) const {
    std::size_t slot = XXH3_64bits(&corner, sizeof corner) & (slots_.size() - 1);
    while (slots_[slot] != none && !(corners_[slots_[slot]] == corner))
      slot = (slot + 1) & (slots_.size() - 1);
    return slot;
  }

  std::uint32_t root(std::uint32_t i) {
    while (parents_[i] != i) {
      parents_[i] = parents_[parents_[i]];
      i = parents_[i];
    }
    return i;
  }

  std::vector<Corner> corners_;        // each once
  std::vector<std::uint32_t> parents_; // by corner; a surface is the root of its corners
  std::vector<std::uint32_t> slots_;   // a hash table of indices of corners, at most half full
  Box<float> box_ = empty_box<float>();
};

struct Indices {
  std::vector<std::uint32_t> list;
  Indices& operator+=(const Indices& other) {
    list.insert(list.end(), other.list.begin(), other.list.end());
    return *this;
  }
};

template <class Triangles>
std::uint64_t triangles_alone(const Triangles& triangles, const Vec3d& origin, double size,
                              const ProgressMonitor* progress) {
  const auto moved = [&](const auto& t) { return relative_to(origin, widened(t)); };
  const auto is_small = [size](const SceneTriangle& t) { return extent(bounds(t)) <= size; };
  const Indices small =
      gathered<Indices>(triangles, progress, [&](const auto& t, Indices& part, std::size_t i) {
        if (is_small(moved(t))) part.list.push_back(static_cast<std::uint32_t>(i));
      });
  SmallSurfaces surfaces(3 * small.list.size());
  for (const std::uint32_t i : small.list) {
    if (surfaces.corner_count() % grain == 0) check_progress(progress);
    const SceneTriangle t = moved(triangles[i]);
    const std::uint32_t a = surfaces.add(corner_of(t.a));
    surfaces.connect(a, surfaces.add(corner_of(t.b)));
    surfaces.connect(a, surfaces.add(corner_of(t.c)));
  }
  std::vector<std::atomic<bool>> marked(surfaces.corner_count());
  parallel_ranges(triangles.size(), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i != end; ++i) {
      if (i % grain == 0) check_progress(progress);
      const SceneTriangle t = moved(triangles[i]);
      if (is_small(t)) continue;
      for (const auto& v : {t.a, t.b, t.c}) {
        const std::uint32_t shared = surfaces.find(corner_of(v));
        if (shared != SmallSurfaces::none) marked[shared] = true;
      }
    }
  });
  return surfaces.count_alone(marked, size);
}

// --- All of a scene -------------------------------------------------------------------------------------

// What there is among some primitives.
struct Found {
  Boxd box = empty_box<double>();                                       // of triangles with a surface
  double rounding = 0, least = std::numeric_limits<double>::infinity(); // the least triangle's extent
  std::uint64_t small = 0, moved = 0;                                   // spheres and cones
  Found& operator+=(const Found& other) {
    box = join(box, other.box);
    rounding = std::max(rounding, other.rounding);
    least = std::min(least, other.least);
    small += other.small;
    moved += other.moved;
    return *this;
  }
};

Found of_triangles(const auto& triangles, const Vec3d& origin, const ProgressMonitor* progress) {
  return gathered<Found>(triangles, progress, [&](const auto& stored, auto& part, std::size_t) {
    const SceneTriangle t = relative_to(origin, widened(stored));
    const Boxd box = bounds(t);
    if (has_surface(widened(t))) part.box = join(part.box, box);
    part.rounding = std::max(part.rounding, rounding_of(t));
    part.least = std::min(part.least, extent(box));
  });
}
// Those without a surface lie at a corner of one that has one, and belong to it; or all are points.
Found of_triangles(const MeshTriangles& triangles, const Vec3d& origin, const ProgressMonitor*) {
  constexpr double none = std::numeric_limits<double>::infinity();
  if (!(triangles.least_extent() < none)) return {.least = triangles.size() > 0 ? 0 : none};
  // Half, since what is subtracted from its corners may round their distances.
  return {relative_to(origin, triangles.box()), 0, triangles.least_extent() / 2};
}

} // namespace

template <class Stored, class Triangles>
Float32Precision float32_precision(const SceneSpans<Stored, Triangles>& scene,
                                   const ProgressMonitor* progress) {
  Float32Precision result;
  const bool lights_in_range =
      std::all_of(scene.lights.begin(), scene.lights.end(), [&](const Light<Stored>& light) {
        return largest_magnitude(cast<double>(light.position) - scene.origin) <= max_float32_reach;
      });
  const auto moved = [&](const auto& record) { return relative_to(scene.origin, widened(record)); };
  Found found = of_triangles(scene.triangles, scene.origin, progress);
  const auto box_of = [&](const auto& stored) { return bounds(moved(stored)); };
  const Boxd box =
      join(found.box, join(joined_boxes(scene.spheres, box_of), joined_boxes(scene.cones, box_of)));
  result.in_range = lights_in_range;
  if (is_empty(box)) return result;
  const double reach = largest_magnitude(box);
  result.margin = rounding_margin<float>(box);
  result.across = extent(box);
  result.in_range = lights_in_range && reach >= min_float32_reach && reach <= max_float32_reach;
  if (!(reach <= max_float32_reach)) { // casts to float32 may overflow
    result.rounding = std::numeric_limits<double>::infinity();
    return result;
  }
  const double size = 2 * result.margin;
  found +=
      gathered<Found>(scene.spheres, progress, [&](const Sphere<Stored>& stored, Found& part, std::size_t) {
        const Sphere<double> s = moved(stored);
        part.rounding = std::max(part.rounding, rounding_of(s));
        part.small += extent(bounds(s)) <= size ? 1 : 0;
      });
  found += gathered<Found>(scene.cones, progress, [&](const Cone<Stored>& stored, Found& part, std::size_t) {
    const Cone<double> c = moved(stored);
    part.rounding = std::max(part.rounding, rounding_of(c));
    part.small += extent(bounds(c)) <= size ? 1 : 0;
    part.moved += movement_of(c) > result.margin ? 1 : 0;
  });
  result.rounding = found.rounding;
  result.moved_cones = found.moved;
  result.standing_alone = found.small;
  if (found.least <= size)
    result.standing_alone += triangles_alone(scene.triangles, scene.origin, size, progress);
  return result;
}
template Float32Precision float32_precision(const SceneSpans<float>&, const ProgressMonitor*);
template Float32Precision float32_precision(const SceneSpans<double>&, const ProgressMonitor*);
template Float32Precision float32_precision(const SceneSpans<double, const GrowingArray<SceneTriangle>&>&,
                                            const ProgressMonitor*);
template Float32Precision float32_precision(const SceneSpans<double, const MeshTriangles&>&,
                                            const ProgressMonitor*);

} // namespace masu
