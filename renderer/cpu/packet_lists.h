// Lists of rays on one thread of a processor with AVX2, by the walk that suits them. Host only.
#pragma once

#include "libgrid/hierarchy/walk/packet_avx2.h"
#include "libgrid/hierarchy/walk/walks_in_use.h"
#include "renderer/cpu/ray_lanes.h"

#include <algorithm>

namespace masu {

// As trace_in_step() (ray_lanes.h), by packets.
template <Query query, class M, class Stored, class Structure, class Found>
[[gnu::noinline]] inline std::size_t trace_packets(const SceneView<Stored>& scene, const Structure& structure,
                                                   const void* rays, const RayFormat& format,
                                                   std::size_t first, std::size_t end, const Found& found) {
  using Real = typename M::Real;
  using Rays = RayLanes<Real>;
  using Walk = PacketWalk<query, M, Stored, Rays, SeenIn<Structure>>;
  Rays packet[Walk::rows];
  while (first + Rays::count <= end) {
    unsigned left[Walk::rows] = {};
    std::size_t next = first;
    for (int e = 0; e < Walk::rows && next + Rays::count <= end; ++e, next += Rays::count) {
      packet[e].load(rays, format, next, scene.clip);
      packet[e].prepare(cast<Real>(scene.clip));
      left[e] = packet[e].meet_bounds;
      each_bit(left[e] ^ Rays::all,
               [&](int missed) { found(next + static_cast<std::size_t>(missed), no_listed_hit<Real>); });
    }
    // One way after the other: those that run as the first that is left does, and see what it sees.
    for (int e = 0; e < Walk::rows; ++e) {
      while (left[e] != 0) {
        const auto i_of = [&](int row, int lane) {
          return first + Rays::count * static_cast<std::size_t>(row) + static_cast<std::size_t>(lane);
        };
        const int one = std::countr_zero(left[e]);
        const Vec3<Real> way = packet[e].inverse.of(static_cast<std::size_t>(one));
        const auto& seen = seen_by(structure, i_of(e, one));
        unsigned alike[Walk::rows];
        take_alike([&](int row) { return packet[row].inverse.all(); }, way, left, alike);
        if constexpr (Walk::is_placed)
          for (int row = e; row < Walk::rows; ++row)
            each_bit(alike[row], [&](int lane) {
              if (seen.sees_as(seen_by(structure, i_of(row, lane)))) return;
              alike[row] ^= 1U << lane;
              left[row] ^= 1U << lane;
            });
        Walk walk(scene, seen, packet, alike, way);
        walk.walk();
        for (int of = 0; of < Walk::rows; ++of) {
          each_bit(alike[of], [&](int lane) {
            const auto i = static_cast<std::size_t>(lane);
            found(i_of(of, lane),
                  ListedHit<Real>{walk.hit(of, i), packet[of].skipped.of[i], packet[of].scale.of[i]});
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
                                           std::size_t first, std::size_t end, const Boxf& bounds) {
  constexpr std::size_t samples = 16, apart = 7;
  if (end - first <= apart) return true;
  const float near = largest_magnitude(bounds.max - bounds.min) * share;
  std::size_t alike = 0;
  for (std::size_t sample = 0; sample < samples; ++sample) {
    const std::size_t i = first + (end - first - apart) * sample / samples;
    const Ray<float> a = listed_ray<float>(rays, format, i, bounds).ray,
                     b = listed_ray<float>(rays, format, i + apart, bounds).ray;
    const float both = dot(a.direction, b.direction);
    alike += largest_magnitude(a.origin - b.origin) <= near && both > 0 &&
             both * both >= 0.9F * dot(a.direction, a.direction) * dot(b.direction, b.direction);
  }
  return alike * 2 > samples;
}

// As packets where rays are coherent, which then take less time, else in step. Shadow rays begin at surfaces,
// and few of them meet the same boxes: of triangles, which in step are tested eight at a time, whichever
// rays', only those are better off as packets that begin at one point.
template <Query query, class M, class Stored, class Structure, class Found>
inline std::size_t trace_list(const SceneView<Stored>& scene, const Structure& structure, const void* rays,
                              const RayFormat& format, std::size_t first, std::size_t end,
                              const Found& found) {
  constexpr bool from_one_point = query == Query::occlusion && tests_triangles_in_lanes<M, Stored>;
  constexpr float share = from_one_point ? 0x1p-12F : 0x1p-5F;
  if (walks_in_use::packets && are_coherent(share, rays, format, first, end, cast<float>(scene.clip)))
    return trace_packets<query, M>(scene, structure, rays, format, first, end, found);
  if constexpr (walks_in_use::in_step)
    return trace_in_step<query, M>(scene, structure, rays, format, first, end, found);
  else
    return trace_in_turn<query, M>(scene, structure, rays, format, first, end, found);
}

} // namespace masu
