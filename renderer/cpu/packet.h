// Rays of a list that are alike, as camera rays are, traced as packets on one thread of a processor with
// AVX2: a node is visited once for all rays of a packet. Boxes that no ray between the bounds of their
// origins and inverse directions meets are passed over, eight at a time (after Boulos, Wald & Shirley,
// "Geometric and Arithmetic Culling Methods for Entire Ray Packets", 2006). What is left is tested against
// eight rays at a time: a node's box until some meet it (after Overbeck, Ramamoorthi & Mark, "Large Ray
// Packets for Real-Time Whitted Ray Tracing", 2008), that of references against all, and each primitive
// against the eights that meet its box.
//
// The hits are those of HierarchyWalk, to the bit; what is visited on the way isn't the same. Host only.
#pragma once

#include "renderer/cpu/eight_rays.h"

#include <algorithm>

namespace masu {

// All bits of the lanes whose bit is set.
MASU_ALWAYS_INLINE Mask8 lanes_of(unsigned bits) {
  const __m256i each = _mm256_setr_epi32(1, 2, 4, 8, 16, 32, 64, 128),
                set = _mm256_and_si256(_mm256_set1_epi32(static_cast<int>(bits)), each);
  return {_mm256_castsi256_ps(_mm256_cmpeq_epi32(set, each))};
}

// Rays of a packet that run the same way along each axis, on their way through a hierarchy. M: a Method in
// float32 arithmetic.
template <Query query, class M, class Stored>
class PacketWalk {
public:
  static constexpr int eights = 4; // a tile of 8 by 4 pixels

  // `lanes`: of each eight a bit for each ray that takes part, of which there is one at least. Their
  // directions' signs are the same.
  MASU_ALWAYS_INLINE PacketWalk( // NOLINT(cppcoreguidelines-pro-type-member-init)
      const SceneView<Stored>& scene, const HierarchyView<float>& hierarchy, const EightRays (&rays)[eights],
      const unsigned (&lanes)[eights])
      : scene_(scene), hierarchy_(hierarchy), rays_(rays) {
    constexpr auto infinite = static_cast<float>(INFINITY);
    for (int e = 0; e < eights; ++e) {
      if (lanes[e] == 0) continue;
      taking_part_ |= 1U << e;
      t_[e] = select(lanes_of(lanes[e]), rays[e].t_max.all(), -1.0F); // the others meet no box
      primitive_[e] = _mm256_setzero_si256();                         // wins no tie at t_max
    }
    for (int axis = 0; axis < 3; ++axis) {
      Floats8 first = infinite, last = -infinite, least = infinite, most = -infinite;
      for_each_eight(taking_part_, [&](int e) {
        const Mask8 own = lanes_of(lanes[e]);
        const Floats8 origin = rays[e].origin.all()[axis],
                      inverse = min(max(rays[e].inverse.all()[axis], -0x1p64F), 0x1p64F);
        inverse_[e].set(axis, inverse);
        first = min(first, select(own, origin, infinite));
        last = max(last, select(own, origin, -infinite));
        least = min(least, select(own, inverse, infinite));
        most = max(most, select(own, inverse, -infinite));
      });
      constexpr unsigned low = offsetof(HierarchyNode, low), high = offsetof(HierarchyNode, high);
      const bool down = least_lane(least) < 0;
      near_[axis] = (down ? high : low) + 8 * static_cast<unsigned>(axis);
      far_[axis] = (down ? low : high) + 8 * static_cast<unsigned>(axis);
      entering_.set(axis, down ? least_lane(first) : largest_lane(last),
                    down ? largest_lane(most) : least_lane(least));
      leaving_.set(axis, down ? largest_lane(last) : least_lane(first),
                   down ? least_lane(least) : largest_lane(most));
    }
    update_farthest();
  }

  MASU_ALWAYS_INLINE void walk() {
    Ahead ahead[max_nodes_ahead + boxes_per_node];
    int height = 0;
    for (Ahead next{0, 0, taking_part_};;) {
      height = visit(next, ahead, height);
      do {
        if (height == 0) return;
        next = ahead[--height];
      } while (!(next.enter <= farthest_));
    }
  }

  // Where each ray of the eights has its nearest hit; -1 of occlusion where there is one.
  Floats8 t(int e) const { return t_[e]; }
  __m256i primitive(int e) const { return primitive_[e]; }

private:
  // A node to visit, and where the first ray enters it: before that, or there.
  struct Ahead {
    float enter;
    std::uint32_t node;
    unsigned eights; // a bit for each whose rays may meet it
  };

  // Along each axis.
  struct Bound {
    float origin[3], inverse[3];
    void set(int axis, float from, float speed) {
      origin[axis] = from;
      inverse[axis] = speed;
    }
  };

  template <class Act>
  MASU_ALWAYS_INLINE static void for_each_eight(unsigned bits, const Act& act) {
    for (int e = 0; e < eights; ++e)
      if ((bits >> e & 1) != 0) act(e);
  }

  MASU_ALWAYS_INLINE void update_farthest() {
    Floats8 all = -1.0F;
    for_each_eight(taking_part_, [&](int e) { all = max(all, t_[e]); });
    farthest_ = largest_lane(all);
  }

  // A node's planes along each axis as numbers of their units, in the order in which the rays meet them; the
  // boxes that may be met, a bit each, and where the first ray enters them.
  struct Boxes { // NOLINT(cppcoreguidelines-pro-type-member-init)
    Numbers8 near[3], far[3], enter;
    float unit[3];
    unsigned met;
  };

  // As boxes_met() (hierarchy_walk_avx2.h) has it, for the bounds of all rays.
  MASU_ALWAYS_INLINE void between_bounds(const HierarchyNode& node, Boxes& boxes) const {
    const char* const bytes = reinterpret_cast<const char*>(&node);
    Floats8 enter = 0, leave = farthest_;
    for (int axis = 0; axis < 3; ++axis) {
      const float unit = float_of((node.exponents >> (8 * axis) & 0xff) << 23);
      const auto met_at = [&](unsigned planes, const Bound& bound, Numbers8& numbers) {
        numbers.set(_mm256_cvtepi32_ps(eight_bytes(bytes + planes)));
        return masu::fma(numbers.all(), unit * bound.inverse[axis],
                         (node.origin[axis] - bound.origin[axis]) * bound.inverse[axis]);
      };
      enter = max(met_at(near_[axis], entering_, boxes.near[axis]), enter);
      leave = min(met_at(far_[axis], leaving_, boxes.far[axis]), leave);
      boxes.unit[axis] = unit;
    }
    const __m256i empty = _mm256_cmpeq_epi32(eight_bytes(node.slots), _mm256_setzero_si256());
    boxes.met = without(enter <= leave, {_mm256_castsi256_ps(empty)}).bits();
    boxes.enter.set(enter);
  }

  // A function of a slot: which of the eight rays meet its box.
  MASU_ALWAYS_INLINE auto meeting(const HierarchyNode& node, const Boxes& boxes, int e) const {
    const auto all = [](const float(&v)[3]) { return Vec3<Floats8>{v[0], v[1], v[2]}; };
    const Vec3<Floats8> inverse = inverse_[e], scale = inverse * all(boxes.unit),
                        start = (all(node.origin) - rays_[e].origin.all()) * inverse;
    return [&boxes, scale, start, farthest = t_[e] ](int slot) __attribute__((always_inline)) {
      const auto at = [&](const Numbers8(&planes)[3], int axis) {
        return masu::fma(Floats8(planes[axis].of[slot]), scale[axis], start[axis]);
      };
      const Floats8 enters = max(max(at(boxes.near, 0), at(boxes.near, 1)), max(at(boxes.near, 2), 0.0F)),
                    leaves = min(min(at(boxes.far, 0), at(boxes.far, 1)), min(at(boxes.far, 2), farthest));
      return (enters <= leaves).bits();
    };
  }

  // Tests what the rays meet of a node's references, and puts its nodes that they meet ahead, the nearest
  // last. Returns how many there are then.
  MASU_ALWAYS_INLINE int visit(const Ahead& own, Ahead* ahead, int height) {
    const HierarchyNode& node = hierarchy_.nodes[own.node];
    Boxes boxes; // NOLINT(cppcoreguidelines-pro-type-member-init)
    between_bounds(node, boxes);
    const unsigned siblings = node_slots(node), with_references = boxes.met & ~siblings;

    // Of nodes the eights from the first on that meets them, of references the lanes that meet their box.
    unsigned undecided = boxes.met & siblings, to_visit = 0, met_by[boxes_per_node];
    std::uint8_t lanes[boxes_per_node][eights] = {};
    for (int e = 0; e < eights && (undecided | with_references) != 0; ++e) {
      if ((own.eights >> e & 1) == 0) continue;
      const auto meets = meeting(node, boxes, e);
      each_bit(undecided, [&](int slot) {
        if (meets(slot) == 0) return;
        undecided &= ~(1U << slot);
        to_visit |= 1U << slot;
        met_by[slot] = own.eights >> e << e;
      });
      each_bit(with_references, [&](int slot) { lanes[slot][e] = static_cast<std::uint8_t>(meets(slot)); });
    }

    const auto each_reference = [&](const auto& act) {
      each_bit(with_references, [&](int slot) {
        const std::uint32_t held = slot_byte(node.slots, slot),
                            first = node.first_reference + references_begin(held);
        for (std::uint32_t i = 0; i < references_in(held); ++i)
          act(hierarchy_.references[first + i], lanes[slot]);
      });
    };
    if constexpr (tests_eight_triangles<M, Stored>)
      each_reference([&](PrimitiveIndex primitive, const auto&) { prefetch(scene_.triangles + primitive); });
    if (to_visit != 0) {
      // There is room, but while a mapped file changes: then results are thrown away.
      if (height > max_nodes_ahead) [[unlikely]]
        height = 0;
      const int begin = height;
      each_bit(to_visit, [&](int slot) {
        const auto before = static_cast<std::uint32_t>(std::popcount(siblings & ((1U << slot) - 1)));
        const Ahead child{boxes.enter.of[slot], node.first_node + before, met_by[slot]};
        int at = height++;
        for (; at != begin && ahead[at - 1].enter < child.enter; --at)
          ahead[at] = ahead[at - 1];
        ahead[at] = child;
      });
      prefetch(hierarchy_.nodes + ahead[height - 1].node);
    }
    each_reference([&](PrimitiveIndex primitive, const auto& of) {
      for (int e = 0; e < eights; ++e)
        if (of[e] != 0) test(e, of[e], primitive);
    });
    if (with_references != 0) update_farthest();
    return height;
  }

  MASU_ALWAYS_INLINE void test(int e, unsigned lanes, PrimitiveIndex primitive) {
    const EightRays& own = rays_[e];
    if constexpr (tests_eight_triangles<M, Stored>) {
      const WatertightRay<Floats8> ray{{own.origin.all(), own.flushed.all(), own.inverse_square.all()},
                                       own.across1.all(),
                                       own.across2.all()};
      const Triangle<float>& triangle = scene_.triangles[primitive];
      const auto corner = [&](const auto& c) { return Vec3<Floats8>{c.x, c.y, c.z} - ray.origin; };
      Floats8 t = 0;
      const Mask8 hits = intersect(ray, corner(triangle.a), corner(triangle.b), corner(triangle.c), t);
      keep(e, hits, t, primitive);
    } else {
      NoTestCounts counts;
      Numbers8 t;
      t.set(0);
      unsigned hits = 0;
      each_bit(lanes, [&](int lane) {
        const WatertightRay<float> ray = own.test_ray(static_cast<std::size_t>(lane));
        if (intersect<M::kinds>(scene_, ray, primitive, t.of[lane], counts)) hits |= 1U << lane;
      });
      keep(e, lanes_of(hits), t.all(), primitive);
    }
  }

  MASU_ALWAYS_INLINE void keep(int e, Mask8 hits, Floats8 t, PrimitiveIndex primitive) {
    if constexpr (query == Query::occlusion) {
      t_[e] = select(hits & (t < t_[e]), -1.0F, t_[e]);
    } else {
      const __m256i number = _mm256_set1_epi32(static_cast<int>(primitive));
      const Mask8 lower{_mm256_castsi256_ps(_mm256_cmpgt_epi32(primitive_[e], number))},
          nearer = hits & ((t < t_[e]) | ((t == t_[e]) & lower));
      t_[e] = select(nearer, t, t_[e]);
      primitive_[e] = _mm256_blendv_epi8(primitive_[e], number, _mm256_castps_si256(nearer.v));
    }
  }

  const SceneView<Stored>& scene_;
  const HierarchyView<float> hierarchy_;
  const EightRays (&rays_)[eights];
  Floats8 t_[eights];
  __m256i primitive_[eights];
  Vec3<Floats8> inverse_[eights];
  unsigned taking_part_ = 0; // a bit for each eight
  // Where in a node the planes begin that the rays meet first and last along each axis, in bytes.
  unsigned near_[3], far_[3];
  // No ray enters a box before one of the first, and none leaves it after one of the second.
  Bound entering_, leaving_;
  float farthest_; // of the nearest hits
};

// Traces the rays of a list from `first` on, as many times eight as there are before `end`. Calls found(i,
// ListedHit) for each, in any order, and returns the first that is left.
template <Query query, class M, class Stored, class Found>
[[gnu::noinline]] inline std::size_t
trace_packets(const SceneView<Stored>& scene, const HierarchyView<float>& grid, const void* rays,
              const RayFormat& format, std::size_t first, std::size_t end, const Found& found) {
  using Walk = PacketWalk<query, M, Stored>;
  EightRays packet[Walk::eights];
  while (first + EightRays::count <= end) {
    unsigned left[Walk::eights] = {};
    std::size_t next = first;
    for (int e = 0; e < Walk::eights && next + EightRays::count <= end; ++e, next += EightRays::count) {
      packet[e].load(rays, format, next);
      packet[e].prepare(scene.clip);
      left[e] = packet[e].meet_bounds;
      each_bit(left[e] ^ 0xff,
               [&](int missed) { found(next + static_cast<std::size_t>(missed), no_listed_hit); });
    }
    // One way after the other: those that run as the first that is left does.
    for (int e = 0; e < Walk::eights; ++e) {
      while (left[e] != 0) {
        const Vec3<float> way = packet[e].inverse.of(static_cast<std::size_t>(std::countr_zero(left[e])));
        unsigned alike[Walk::eights];
        for (int other = 0; other < Walk::eights; ++other) {
          alike[other] = 0;
          if (left[other] == 0) continue;
          alike[other] = left[other] & ~(smallest(packet[other].inverse.all() * all_of(way)) < 0.0F).bits();
          left[other] ^= alike[other];
        }
        Walk walk(scene, grid, packet, alike);
        walk.walk();
        for (int of = 0; of < Walk::eights; ++of) {
          if (alike[of] == 0) continue;
          const EightRays& own = packet[of];
          Numbers8 t;
          t.set(walk.t(of));
          PrimitiveIndex primitives[EightRays::count];
          store_eight(primitives, walk.primitive(of));
          each_bit(alike[of], [&](int lane) {
            const auto i = static_cast<std::size_t>(lane);
            const bool hits = query == Query::occlusion ? t.of[i] < 0 : t.of[i] < own.t_max.of[i];
            found(first + EightRays::count * static_cast<std::size_t>(of) + i,
                  ListedHit{
                      {t.of[i], hits ? primitives[i] : no_primitive}, own.skipped.of[i], own.scale.of[i]});
          });
        }
      }
    }
    first = next;
  }
  return first;
}

// Whether neighbours among a list's rays begin close to each other, no farther apart than that share of the
// bounds, and go the same way, as camera rays do.
[[gnu::noinline]] inline bool are_coherent(float share, const void* rays, const RayFormat& format,
                                           std::size_t first, std::size_t end, const Box<float>& bounds) {
  constexpr std::size_t samples = 16, apart = EightRays::count - 1;
  if (end - first <= apart) return true;
  const float near = largest_magnitude(bounds.max - bounds.min) * share;
  std::size_t alike = 0;
  for (std::size_t sample = 0; sample < samples; ++sample) {
    const std::size_t i = first + (end - first - apart) * sample / samples;
    const Ray<float> a = loaded<float>(rays, format, i), b = loaded<float>(rays, format, i + apart);
    const float both = dot(a.direction, b.direction);
    alike += largest_magnitude(a.origin - b.origin) <= near && both > 0 &&
             both * both >= 0.9F * dot(a.direction, a.direction) * dot(b.direction, b.direction);
  }
  return alike * 2 > samples;
}

// As packets where rays are coherent, which then take less time, else in step. Shadow rays begin at surfaces,
// and few of them meet the same boxes: of triangles, which in step are tested eight at a time, whichever
// rays', only those are better off as packets that begin at one point.
template <Query query, class M, class Stored, class Found>
inline std::size_t trace_list(const SceneView<Stored>& scene, const HierarchyView<float>& grid,
                              const void* rays, const RayFormat& format, std::size_t first, std::size_t end,
                              const Found& found) {
  constexpr bool from_one_point = query == Query::occlusion && tests_eight_triangles<M, Stored>;
  constexpr float share = from_one_point ? 0x1p-12F : 0x1p-5F;
  return are_coherent(share, rays, format, first, end, scene.clip)
             ? trace_packets<query, M>(scene, grid, rays, format, first, end, found)
             : trace_in_step<query, M>(scene, grid, rays, format, first, end, found);
}

} // namespace masu
