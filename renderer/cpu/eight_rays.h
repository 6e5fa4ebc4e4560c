// Rays of a list made ready for tracing eight at a time: what scale_direction() (ray_query.h), clip() and
// prepare() (libscene/geometry) do to one, with the same bits. Where most rays are short or miss, that is
// most of their time. And tracing them. Host only, with AVX2 and FMA.
#pragma once

#include "libgrid/hierarchy/eight_walks_avx2.h"
#include "renderer/rays/ray_query.h"

#include <algorithm>

namespace masu {

// What a ray of a list hits. `near` counts t from where the ray enters the scene's bounds, and in lengths of
// the direction as it was scaled.
struct ListedHit {
  Hit<float> near;
  float skipped, scale;
};
inline constexpr ListedHit no_listed_hit{no_hit(), 0, 1};
inline Hit<float> reported(const ListedHit& hit) {
  return reported(hit.near, static_cast<float>(INFINITY), hit.skipped, hit.scale);
}

// Not initialised: it is made for every eight rays.
struct EightRays { // NOLINT(cppcoreguidelines-pro-type-member-init): see above
  static constexpr std::size_t count = 8;

  // These are filled in by load(), the others by prepare(), which makes t_min and t_max a clipped ray's.
  Vectors8 origin, direction;
  Numbers8 t_min, t_max;

  Vectors8 inverse, across1, across2, flushed;
  Numbers8 skipped, scale, inverse_square;
  unsigned meet_bounds = 0; // a bit for each ray that meets the scene's bounds

  // `box`: the scene's padded bounds.
  template <class Stored>
  void load(const void* rays, const RayFormat& format, std::size_t first, const Box<Stored>& box) {
    for (std::size_t i = 0; i < count; ++i) {
      const Ray<float> ray = listed_ray<float>(rays, format, first + i, box).ray;
      origin.set(i, ray.origin);
      direction.set(i, ray.direction);
      t_min.of[i] = ray.t_min;
      t_max.of[i] = ray.t_max;
    }
  }

  void prepare(const Box<float>& box) {
    constexpr float unit = RealTraits<float>::unit_roundoff;
    Vec3<Floats8> o = origin.all(), d = direction.all();
    Floats8 from = t_min.all(), to = t_max.all();

    // scale_direction(): of rays that aren't valid nothing is used.
    const Floats8 sum = o.x + o.y + o.z + d.x + d.y + d.z, size = largest_magnitude(d);
    Mask8 alive = (sum * 0.0F == 0.0F) &
                  (largest_magnitude(o) <= max_ray_origin<float>)&(size <= max_ray_direction) &
                  (Floats8(min_ray_direction) <= size) & (from < to);
    const Floats8 scaled = inverse_power_of_two(size), unscaled = Floats8(1) / scaled;
    d = d * scaled;
    from = max(from * unscaled, 0.0F);
    to = min(to * unscaled, RealTraits<float>::largest);

    // clip(), with departs() and crosses()
    const Vec3<Floats8> low = all_of(box.min), high = all_of(box.max);
    const float largest = largest_magnitude(box);
    constexpr float padding = (2 * margin_roundings - 16) * unit, slack = 8 * unit;
    const Vec3<Floats8> above = o - low, below = high - o;
    const Vec3<Floats8> left{select(Floats8(0) < d.x, below.x, above.x),
                             select(Floats8(0) < d.y, below.y, above.y),
                             select(Floats8(0) < d.z, below.z, above.z)};
    alive = without(alive, smallest(left) < padding * largest);
    const Vec3<Floats8> inverted{finite_inverse(d.x), finite_inverse(d.y), finite_inverse(d.z)};
    Floats8 passed = 0;
    Mask8 clips = alive;
    for (int i = 0; i < most_clips && clips.bits() != 0; ++i) {
      const Vec3<Floats8> t0 = (low - o) * inverted, t1 = (high - o) * inverted;
      const Floats8 near = max(max(0.0F, min(t0.x, t1.x)), max(min(t0.y, t1.y), min(t0.z, t1.z))),
                    leave = min(max(t0.x, t1.x), min(max(t0.y, t1.y), max(t0.z, t1.z)));
      const Floats8 enter = near * (1 - slack);
      const Mask8 crosses = (enter <= leave * (1 + slack)) & (enter <= to);
      alive = without(alive, without(clips, crosses));
      clips = clips & crosses;
      o = select(clips, fma(d, enter, o), o);
      passed = select(clips, passed + enter, passed);
      clips = clips & (Floats8(256 * largest) < enter * largest_magnitude(d));
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
    const Mask8 limited = (Floats8(0) < passed) & ((Floats8(0) < from) | (to < RealTraits<float>::largest));
    each_bit(limited.bits() & meet_bounds, [&](int lane) {
      const auto i = static_cast<std::size_t>(lane);
      t_min.of[i] = clipped_t_min(t_min.of[i], skipped.of[i]);
      t_max.of[i] = clipped_t_max(t_max.of[i], skipped.of[i]);
    });
    if (meet_bounds != 0) prepare_tests(d);
  }

  MASU_ALWAYS_INLINE ClippedRay<float> clipped(std::size_t i) const {
    return {{origin.of(i), t_min.of[i], direction.of(i), t_max.of[i]}, inverse.of(i), skipped.of[i]};
  }
  MASU_ALWAYS_INLINE WatertightRay<float> test_ray(std::size_t i) const {
    return {{origin.of(i), flushed.of(i), inverse_square.of[i]}, across1.of(i), across2.of(i)};
  }

private:
  // prepare(WatertightRay): flush_tiny_components() and prepare_watertight().
  void prepare_tests(const Vec3<Floats8>& along) {
    const Floats8 limit = largest_magnitude(along) * (RealTraits<float>::unit_roundoff / 256), zero = 0;
    const auto flush = [&](Floats8 v) { return select(magnitude(v) < limit, zero, v); };
    const Vec3<Floats8> d{flush(along.x), flush(along.y), flush(along.z)};
    const Vec3<Floats8> m = magnitudes(d);
    const Mask8 no_x = (m.x <= m.y) & (m.x <= m.z), no_y = without(m.y <= m.z, no_x);
    const Vec3<Floats8> across{select(no_x, zero, select(no_y, -d.z, d.y)),
                               select(no_x, d.z, select(no_y, zero, -d.x)),
                               select(no_x, -d.y, select(no_y, d.x, zero))};
    flushed.set(d);
    across1.set(across);
    across2.set(cross(d, across));
    inverse_square.set(fast_divide(Floats8(1), dot(d, d)));
  }
};

// Traces the rays of a list from `first` on, as many times eight as there are before `end`, one after the
// other. Calls found(i, ListedHit) for each, in any order, and returns the first that is left.
template <Query query, class M, class Stored, class Structure, class Found>
inline std::size_t trace_in_turn(const SceneView<Stored>& scene, const Structure& grid, const void* rays,
                                 const RayFormat& format, std::size_t first, std::size_t end,
                                 const Found& found) {
  EightRays eight;
  for (; first + EightRays::count <= end; first += EightRays::count) {
    eight.load(rays, format, first, scene.clip);
    eight.prepare(scene.clip);
    for (std::size_t i = 0; i < EightRays::count; ++i) {
      ListedHit hit = no_listed_hit;
      if ((eight.meet_bounds >> i & 1) != 0) {
        const WatertightRay<float> ray = eight.test_ray(i);
        const float t_min = eight.t_min.of[i], t_max = eight.t_max.of[i];
        hit = {no_hit(), eight.skipped.of[i], eight.scale.of[i]};
        NoCounts counts;
        if constexpr (query == Query::occlusion) {
          AnyHit<M, Stored, NoCounts> visitor{scene, ray, counts, t_min, t_max, t_max};
          visit(grid, eight.clipped(i), scene.primitive_count(), visitor);
          if (visitor.found()) hit.near = {visitor.hit, 0};
        } else {
          NearestHit<M, Stored, NoCounts> visitor{scene, ray, counts, t_min, t_max, {t_max, 0}};
          visit(grid, eight.clipped(i), scene.primitive_count(), visitor);
          if (visitor.hit.t < t_max) hit.near = visitor.hit;
        }
      }
      found(first + i, hit);
    }
  }
  return first;
}

// The same, eight in step.
template <Query query, class M, class Stored, class Found>
[[gnu::noinline]] inline std::size_t
trace_in_step(const SceneView<Stored>& scene, const HierarchyView<float>& grid, const void* rays,
              const RayFormat& format, std::size_t first, std::size_t end, const Found& found) {
  end = first + (end - first) / EightRays::count * EightRays::count;
  // Of eight rays that are made ready those that nobody has taken.
  EightRays eight;
  std::size_t loaded = first; // of the list
  unsigned ready = 0;
  // Calls take(i, k) for the next that meets the scene's bounds: ray i of the list, k of the eight. False at
  // the end.
  const auto take_next = [&](const auto& take) {
    while (ready == 0) {
      if (loaded == end) return false;
      eight.load(rays, format, loaded, scene.clip);
      eight.prepare(scene.clip);
      ready = eight.meet_bounds;
      each_bit(ready ^ 0xff,
               [&](int missed) { found(loaded + static_cast<std::size_t>(missed), no_listed_hit); });
      loaded += EightRays::count;
    }
    const auto k = static_cast<std::size_t>(std::countr_zero(ready));
    ready &= ready - 1;
    take(loaded - EightRays::count + k, k);
    return true;
  };
  struct Listed {
    std::size_t i;
    float skipped, scale;
  };
  constexpr std::size_t none = ~std::size_t{};
  struct Group {
    EightWalks<query, M> walks;
    Listed listed[EightRays::count];

    explicit Group(const HierarchyView<float>& hierarchy) : walks(hierarchy) {
      std::fill_n(listed, EightRays::count, Listed{none, 0, 0});
    }
  };
  Group groups[]{Group(grid), Group(grid), Group(grid)};
  const auto next_ray = [&](Group& group, int lane) {
    Listed& listed = group.listed[lane];
    if (listed.i != none) found(listed.i, ListedHit{group.walks.hit(lane), listed.skipped, listed.scale});
    const bool begun = take_next([&](std::size_t i, std::size_t k) {
      listed = {i, eight.skipped.of[k], eight.scale.of[k]};
      group.walks.begin(lane, eight.test_ray(k), bounded_inverse(eight.clipped(k)), eight.t_min.of[k],
                        eight.t_max.of[k]);
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
