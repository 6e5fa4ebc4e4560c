// The hits of a ray in their order, however many: through a grid, a hierarchy or none, with the same bits.
//
// Passes through the structure each keep the next few hits beyond the last one that is known, as Amstutz,
// Gribble, Günther & Wald, "An Evaluation of Multi-Hit Ray Traversal in a BVH using Existing
// First-Hit/Any-Hit Kernels", JCGT 4(4), 2015, describe it. Hits are ordered by t, then by primitive, then
// the front first. So a primitive that is listed in several cells is found several times, but kept once; and
// a pass that keeps n hits ends as a search for the nearest does (trace.h), once nothing that is still to
// come can come before the n-th.
//
// A pass keeps 16 hits. On the host the passes after the first keep 16 times as many each time, up to 65536
// (2 MiB): so n hits take n log n steps, not n² as on a device.
#pragma once

#include "libgrid/trace/trace.h"
#include "libscene/geometry/each_hit.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace masu {

enum class Faces { both, front, back };

// What counts as a hit: of these faces; not of the excluded primitive, which may be no_primitive; and of
// objects whose masks share a bit with the ray's, as in Embree.
struct HitFilter {
  Faces faces = Faces::both;
  EdgeRule edges = EdgeRule::half_open;
  PrimitiveIndex excluded = no_primitive;
  const std::uint32_t* object_masks = nullptr; // of each of the scene's objects; null: any is hit
  std::uint32_t ray_mask = 0xffffffffU;

  template <class Stored>
  MASU_HD bool admits(const SceneView<Stored>& scene, PrimitiveIndex primitive) const {
    return primitive != excluded &&
           (object_masks == nullptr || (object_masks[surface_of(scene, primitive).object] & ray_mask) != 0);
  }
  MASU_HD bool admits(bool front) const { return faces == Faces::both || front == (faces == Faces::front); }
};

// A hit with the side that is met, in the lowest bit: set for the back. Primitives have 31 bits.
template <class Real>
struct SidedHit {
  Real t;
  std::uint32_t primitive_and_side;

  MASU_HD PrimitiveIndex primitive() const { return primitive_and_side >> 1; }
  MASU_HD bool front() const { return (primitive_and_side & 1) == 0; }
  MASU_HD bool before(const SidedHit& other) const {
    return (t < other.t) | ((t == other.t) & (primitive_and_side < other.primitive_and_side));
  }
};

inline constexpr std::uint32_t hits_per_pass = 16, most_hits_per_pass = 1 << 16;

// The first `capacity` hits after `last`, in order: few, in registers and a device's local memory.
template <class Real>
struct FewHits {
  int capacity = 0; // up to hits_per_pass
  SidedHit<Real> last{};
  SidedHit<Real> hits[hits_per_pass]{};
  int count = 0;

  MASU_HD void keep(const SidedHit<Real>& hit) {
    if (!last.before(hit) || (is_full() && !hit.before(hits[count - 1]))) return;
    int at = count;
    while (at > 0 && hit.before(hits[at - 1]))
      --at;
    if (at > 0 && !hits[at - 1].before(hit)) return; // it is known
    if (!is_full()) ++count;
    for (int i = count - 1; i > at; --i)
      hits[i] = hits[i - 1];
    hits[at] = hit;
  }
  MASU_HD void sort() {}
  MASU_HD bool is_full() const { return count == capacity; }
  MASU_HD Real farthest(Real t_max) const { return is_full() ? hits[count - 1].t : t_max; }
};

// The same, many, on the host. They are sorted whenever they have become twice as many, so that each takes
// the logarithm of their number; in between what is farthest isn't known better.
template <class Real>
struct ManyHits {
  int capacity = 0;
  SidedHit<Real> last{};
  std::vector<SidedHit<Real>> hits{};
  int count = 0; // of those sorted

  void keep(const SidedHit<Real>& hit) {
    if (!last.before(hit) || (is_full() && !hit.before(hits[end_of_room() - 1]))) return;
    hits.push_back(hit);
    if (hits.size() == 2 * end_of_room()) sort();
  }
  void sort() {
    const auto before = [](const SidedHit<Real>& a, const SidedHit<Real>& b) { return a.before(b); };
    std::sort(hits.begin(), hits.end(), before);
    const auto same = [&](const SidedHit<Real>& a, const SidedHit<Real>& b) { return !a.before(b); };
    hits.erase(std::unique(hits.begin(), hits.end(), same), hits.end());
    if (hits.size() > end_of_room()) hits.resize(end_of_room());
    count = static_cast<int>(hits.size());
  }
  bool is_full() const { return count == capacity; }
  Real farthest(Real t_max) const { return is_full() ? hits[end_of_room() - 1].t : t_max; }

private:
  std::size_t end_of_room() const { return static_cast<std::size_t>(capacity); }
};

// Keeps the next hits of a ray.
template <class M, class Stored, class Room>
struct NextHits {
  using Real = typename M::Real;
  static constexpr unsigned kinds = M::kinds;
  const SceneView<Stored>& scene;
  const typename M::TestRay& ray;
  NoWalkCounts& counts;
  Real t_max;
  HitFilter filter;
  Room room;

  MASU_HD void primitive(PrimitiveIndex number) { keep(number, SceneRecord<Stored>{scene, number}); }
  MASU_HD void leaf(const Leaf<Stored>* address) {
    const Leaf<Stored> leaf = fetched(address);
    keep(leaf.primitive(), leaf);
  }
  // Of a triangle whose object is known to be admitted.
  MASU_HD void leaf(const Leaf<Stored>& leaf) {
    if (leaf.primitive() != filter.excluded) keep_admitted(leaf.primitive(), leaf);
  }
  MASU_HD Real farthest() const { return room.farthest(t_max); }
  MASU_HD bool done(Real exit) const { return farthest() <= exit; }
  MASU_HD bool ends() const { return false; }

private:
  template <class From>
  MASU_HD void keep(PrimitiveIndex number, const From& from) {
    if (filter.admits(scene, number)) keep_admitted(number, from);
  }
  template <class From>
  MASU_HD void keep_admitted(PrimitiveIndex number, const From& from) {
    each_hit<M::kinds>(scene, ray, number, from, filter.edges, [&](Real t, bool front) {
      if (t < t_max && filter.admits(front)) room.keep({t, number << 1 | (front ? 0U : 1U)});
    });
  }
};

// Calls act(i, near, front) for hit i, from 0 to below `limit`, at t_min < t < t_max; `near` as
// nearest_hit_near() has it. Returns how many there were.
template <class M, class Stored, class Structure, class Act>
MASU_HD inline std::uint32_t hits_in_order(const SceneView<Stored>& scene, const Structure& structure,
                                           const Ray<typename M::Real>& ray, const HitFilter& filter,
                                           std::uint32_t limit, const Act& act) {
  using Real = typename M::Real;
  ClippedRay<Real> near{};
  if (!clip(ray, cast<Real>(scene.clip), near)) return 0;
  typename M::TestRay test_ray;
  prepare(test_ray, near.ray.origin, near.ray.direction);
  NoWalkCounts counts;
  SidedHit<Real> last{near.ray.t_min, 0xffffffffU}; // every hit comes after it
  std::uint32_t all = 0;
  const auto room_for = [&](std::uint32_t most) { return static_cast<int>(std::min(limit - all, most)); };
  // False where there are no more.
  const auto pass = [&](auto room) {
    NextHits<M, Stored, decltype(room)> next{scene,          test_ray, counts,
                                             near.ray.t_max, filter,   std::move(room)};
    visit(structure, near, scene.primitive_count(), next);
    next.room.sort();
    for (int i = 0; i < next.room.count; ++i) {
      last = next.room.hits[static_cast<std::size_t>(i)];
      act(all++, NearHit<typename M::TestRay>{test_ray, {last.t, last.primitive()}, near.skipped},
          last.front());
    }
    return next.room.is_full();
  };
  bool goes_on = limit > 0;
#ifdef __CUDA_ARCH__
  while (goes_on && all < limit)
    goes_on = pass(FewHits<Real>{room_for(hits_per_pass), last});
#else
  if (goes_on) goes_on = pass(FewHits<Real>{room_for(hits_per_pass), last});
  for (std::uint32_t most = 16 * hits_per_pass; goes_on && all < limit;
       most = std::min(16 * most, most_hits_per_pass))
    goes_on = pass(ManyHits<Real>{room_for(most), last});
#endif
  return all;
}

} // namespace masu
