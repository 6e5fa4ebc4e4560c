// Rays of a list made ready for tracing several at a time, eight in float32 and four in float64: what
// scale_direction() (ray_query.h), clip() and prepare() (libscene/geometry) do to one, with the same bits.
// Where most rays are short or miss, that is most of their time. And tracing them. Host only, with AVX2 and
// FMA.
#pragma once

#include "libgrid/hierarchy/walk/in_step_avx2.h"
#include "renderer/rays/ray_query.h"

#include <algorithm>

namespace masu {

// What a ray of a list hits. `near` counts t from where the ray enters the scene's bounds, and in lengths of
// the direction as it was scaled.
template <class Real>
struct ListedHit {
  Hit<Real> near;
  Real skipped, scale;
};
template <class Real>
inline constexpr ListedHit<Real> no_listed_hit{no_hit<Real>(), 0, 1};
template <class Real>
inline Hit<float> reported(const ListedHit<Real>& hit) {
  return reported(hit.near, static_cast<Real>(INFINITY), hit.skipped, hit.scale);
}

// scale_direction()'s scale for a largest component. Of float64 it is looked for in float32, too.
inline Floats8 direction_scale(Floats8 largest) {
  const __m256i one = _mm256_set1_epi32(1 << 23), most = _mm256_set1_epi32(253 << 23);
  const __m256i power = largest.whole() & _mm256_set1_epi32(0x7f800000);
  const __m256i clamped = _mm256_min_epi32(_mm256_max_epi32(power, one), most);
  return _mm256_castsi256_ps(_mm256_sub_epi32(_mm256_set1_epi32(254 << 23), clamped));
}
inline Doubles4 direction_scale(Doubles4 largest) {
  const Floats8 scale = direction_scale(Floats8(_mm256_castps128_ps256(_mm256_cvtpd_ps(largest.v))));
  return _mm256_cvtps_pd(_mm256_castps256_ps128(scale.v));
}

// Not initialised: it is made anew for so many rays each time.
template <class Real>
struct RayLanes { // NOLINT(cppcoreguidelines-pro-type-member-init): see above
  using Number = Lanes<Real>;
  using Mask = LaneMask<Real>;
  static constexpr std::size_t count = Number::count;
  static constexpr unsigned all = (1U << count) - 1;

  // These are filled in by load(), the others by prepare(), which makes t_min and t_max a clipped ray's.
  Vectors<Real, count> origin, direction;
  Numbers<Real, count> t_min, t_max;

  Vectors<Real, count> inverse, across1, across2, flushed;
  Numbers<Real, count> skipped, scale, inverse_square;
  unsigned meet_bounds = 0; // a bit for each ray that meets the scene's bounds

  // `box`: the scene's padded bounds.
  template <class Stored>
  void load(const void* rays, const RayFormat& format, std::size_t first, const Box<Stored>& box) {
    for (std::size_t i = 0; i < count; ++i) {
      const Ray<Real> ray = listed_ray<Real>(rays, format, first + i, box).ray;
      origin.set(i, ray.origin);
      direction.set(i, ray.direction);
      t_min.of[i] = ray.t_min;
      t_max.of[i] = ray.t_max;
    }
  }

  void prepare(const Box<Real>& box) {
    constexpr Real unit = RealTraits<Real>::unit_roundoff;
    Vec3<Number> o = origin.all(), d = direction.all();
    Number from = t_min.all(), to = t_max.all();

    // scale_direction(): of rays that aren't valid nothing is used.
    const Number sum = o.x + o.y + o.z + d.x + d.y + d.z, size = largest_magnitude(d);
    Mask alive = (sum * Real(0) == Real(0)) &
                 (largest_magnitude(o) <= max_ray_origin<Real>)&(size <= Real(max_ray_direction)) &
                 (Number(min_ray_direction) <= size) & (from < to);
    const Number scaled = direction_scale(size), unscaled = Number(1) / scaled;
    d = d * scaled;
    from = max(from * unscaled, Real(0));
    to = min(to * unscaled, RealTraits<Real>::largest);

    // clip(), with departs() and crosses()
    const Vec3<Number> low = all_of(box.min), high = all_of(box.max);
    const Real largest = largest_magnitude(box);
    constexpr Real padding = (2 * margin_roundings - 16) * unit, slack = 8 * unit;
    const Vec3<Number> above = o - low, below = high - o;
    const Vec3<Number> left{select(Number(0) < d.x, below.x, above.x),
                            select(Number(0) < d.y, below.y, above.y),
                            select(Number(0) < d.z, below.z, above.z)};
    alive = without(alive, smallest(left) < padding * largest);
    const Vec3<Number> inverted{finite_inverse(d.x), finite_inverse(d.y), finite_inverse(d.z)};
    Number passed = 0;
    Mask clips = alive;
    for (int i = 0; i < most_clips && clips.bits() != 0; ++i) {
      const Vec3<Number> t0 = (low - o) * inverted, t1 = (high - o) * inverted;
      const Number near = max(max(Number(0), min(t0.x, t1.x)), max(min(t0.y, t1.y), min(t0.z, t1.z))),
                   leave = min(max(t0.x, t1.x), min(max(t0.y, t1.y), max(t0.z, t1.z)));
      const Number enter = near * (1 - slack);
      const Mask crosses = (enter <= leave * (1 + slack)) & (enter <= to);
      alive = without(alive, without(clips, crosses));
      clips = clips & crosses;
      o = select(clips, fma(d, enter, o), o);
      passed = select(clips, passed + enter, passed);
      clips = clips & (Number(256 * largest) < enter * largest_magnitude(d));
    }
    alive = without(alive, clips) & (passed < to);

    origin.set(o);
    direction.set(d);
    t_min.set(from);
    t_max.set(to);
    inverse.set(inverted);
    skipped.set(passed);
    scale.set(scaled);
    meet_bounds = alive.bits();
    const Mask limited = (Number(0) < passed) & ((Number(0) < from) | (to < RealTraits<Real>::largest));
    each_bit(limited.bits() & meet_bounds, [&](int lane) {
      const auto i = static_cast<std::size_t>(lane);
      t_min.of[i] = clipped_t_min(t_min.of[i], skipped.of[i]);
      t_max.of[i] = clipped_t_max(t_max.of[i], skipped.of[i]);
    });
    if (meet_bounds != 0) prepare_tests(d);
  }

  MASU_ALWAYS_INLINE ClippedRay<Real> clipped(std::size_t i) const {
    return {{origin.of(i), t_min.of[i], direction.of(i), t_max.of[i]}, inverse.of(i), skipped.of[i]};
  }
  MASU_ALWAYS_INLINE WatertightRay<Real> test_ray(std::size_t i) const {
    return {{origin.of(i), flushed.of(i), inverse_square.of[i]}, across1.of(i), across2.of(i)};
  }

private:
  // prepare(WatertightRay): flush_tiny_components() and prepare_watertight().
  void prepare_tests(const Vec3<Number>& along) {
    const Number limit = largest_magnitude(along) * (RealTraits<Real>::unit_roundoff / 256), zero = 0;
    const auto flush = [&](Number v) { return select(magnitude(v) < limit, zero, v); };
    const Vec3<Number> d{flush(along.x), flush(along.y), flush(along.z)};
    const Vec3<Number> m = magnitudes(d);
    const Mask no_x = (m.x <= m.y) & (m.x <= m.z), no_y = without(m.y <= m.z, no_x);
    const Vec3<Number> across{select(no_x, zero, select(no_y, -d.z, d.y)),
                              select(no_x, d.z, select(no_y, zero, -d.x)),
                              select(no_x, -d.y, select(no_y, d.x, zero))};
    flushed.set(d);
    across1.set(across);
    across2.set(cross(d, across));
    inverse_square.set(fast_divide(Number(1), dot(d, d)));
  }
};

// Traces the rays of a list from `first` on, as many times RayLanes::count as there are before `end`, one
// after the other. Calls found(i, ListedHit) for each, in any order, and returns the first that is left.
template <Query query, class M, class Stored, class Structure, class Found>
inline std::size_t trace_in_turn(const SceneView<Stored>& scene, const Structure& structure, const void* rays,
                                 const RayFormat& format, std::size_t first, std::size_t end,
                                 const Found& found) {
  using Real = typename M::Real;
  RayLanes<Real> lanes;
  for (; first + RayLanes<Real>::count <= end; first += RayLanes<Real>::count) {
    lanes.load(rays, format, first, scene.clip);
    lanes.prepare(cast<Real>(scene.clip));
    for (std::size_t i = 0; i < RayLanes<Real>::count; ++i) {
      ListedHit<Real> hit = no_listed_hit<Real>;
      if ((lanes.meet_bounds >> i & 1) != 0) {
        const WatertightRay<Real> ray = lanes.test_ray(i);
        const Real t_min = lanes.t_min.of[i], t_max = lanes.t_max.of[i];
        hit = {no_hit<Real>(), lanes.skipped.of[i], lanes.scale.of[i]};
        NoCounts counts;
        if constexpr (query == Query::occlusion) {
          AnyHit<M, Stored, NoCounts> visitor{scene, ray, counts, t_min, t_max, t_max};
          visit(seen_by(structure, first + i), lanes.clipped(i), scene.primitive_count(), visitor);
          if (visitor.found()) hit.near = {visitor.hit, 0};
        } else {
          NearestHit<M, Stored, NoCounts> visitor{scene, ray, counts, t_min, t_max, {t_max, 0}};
          visit(seen_by(structure, first + i), lanes.clipped(i), scene.primitive_count(), visitor);
          if (visitor.hit.t < t_max) hit.near = visitor.hit;
        }
      }
      found(first + i, hit);
    }
  }
  return first;
}

// The same, eight in step.
template <Query query, class M, class Stored, class Structure, class Found>
[[gnu::noinline]] inline std::size_t trace_in_step(const SceneView<Stored>& scene, const Structure& structure,
                                                   const void* rays, const RayFormat& format,
                                                   std::size_t first, std::size_t end, const Found& found) {
  using Real = typename M::Real;
  using Rays = RayLanes<Real>;
  end = first + (end - first) / Rays::count * Rays::count;
  // Of the rays that are made ready those that nobody has taken.
  Rays lanes;
  std::size_t loaded = first; // of the list
  unsigned ready = 0;
  // Calls take(i, k) for the next that meets the scene's bounds: ray i of the list, k of those made ready.
  // False at the end.
  const auto take_next = [&](const auto& take) {
    while (ready == 0) {
      if (loaded == end) return false;
      lanes.load(rays, format, loaded, scene.clip);
      lanes.prepare(cast<Real>(scene.clip));
      ready = lanes.meet_bounds;
      each_bit(ready ^ Rays::all,
               [&](int missed) { found(loaded + static_cast<std::size_t>(missed), no_listed_hit<Real>); });
      loaded += Rays::count;
    }
    const auto k = static_cast<std::size_t>(std::countr_zero(ready));
    ready &= ready - 1;
    take(loaded - Rays::count + k, k);
    return true;
  };
  struct Listed {
    std::size_t i;
    Real skipped, scale;
  };
  constexpr std::size_t none = ~std::size_t{};
  struct Group {
    EightWalks<query, M, Stored, SeenIn<Structure>> walks;
    Listed listed[8];

    explicit Group(const Structure& structure) : walks(seen_by(structure, 0)) {
      std::fill_n(listed, std::size(listed), Listed{none, 0, 0});
    }
  };
  Group groups[]{Group(structure), Group(structure), Group(structure)};
  const auto next_ray = [&](Group& group, int lane) {
    Listed& listed = group.listed[lane];
    if (listed.i != none)
      found(listed.i, ListedHit<Real>{group.walks.hit(lane), listed.skipped, listed.scale});
    const bool begun = take_next([&](std::size_t i, std::size_t k) {
      listed = {i, lanes.skipped.of[k], lanes.scale.of[k]};
      group.walks.begin(lane, seen_by(structure, i), lanes.test_ray(k), bounded_inverse(lanes.clipped(k)),
                        lanes.t_min.of[k], lanes.t_max.of[k]);
    });
    if (begun) return;
    listed.i = none;
    group.walks.leave_idle(lane);
  };
  for (bool goes_on = true; goes_on;) {
    goes_on = false;
    for (const int g : {0, 2, 1}) { // of each group, a stage of another between any two
      Group &group = groups[g], &next = groups[(g + 1) % 3];
      group.walks.test(scene);
      next.walks.meet_boxes(scene);
      group.walks.resume([&](int lane) { next_ray(group, lane); });
      next.walks.push();
      for (const Listed& listed : group.listed)
        goes_on |= listed.i != none;
    }
  }
  return end;
}

} // namespace masu
