// A list's rays and what is found for them: how they are stored, checked and scaled, and how results are
// written. One definition for both backends.
#pragma once

#include "libgrid/trace/trace.h"
#include "libscene/base/fetch.h"
#include "libscene/geometry/surface.h"
#include "renderer/counts.h"

#include <limits>

namespace masu {

// --- Rays as callers store them ----------------------------------------------------------------------------

// Numbers of 32 or 64 bits, 8 per ray: origin, t_min, direction, t_max (Ray<float>, Ray<double>); or 6:
// origin and direction, with t_min = 0 and no t_max; or of places 3. Origins are in the world, or relative to
// the scene's local origin (local_origin.h). `origin` is what is subtracted from them, in float64: a tracer
// fills it in.
struct RayFormat {
  int numbers = 8;
  bool is_float64 = false;
  bool is_relative = false;
  Vec3d origin{0, 0, 0};

  MASU_HD std::size_t bytes_per_ray() const {
    return static_cast<std::size_t>(numbers) * (is_float64 ? sizeof(double) : sizeof(float));
  }
};

template <class Real>
inline constexpr RayFormat own_format{8, sizeof(Real) == sizeof(double)};

template <class Number>
MASU_HD inline Ray<Number> loaded_numbers(const Number* n, int numbers) {
  if (numbers == 6) return {{n[0], n[1], n[2]}, 0, {n[3], n[4], n[5]}, static_cast<Number>(INFINITY)};
  return {{n[0], n[1], n[2]}, n[3], {n[4], n[5], n[6]}, n[7]};
}

// In the arithmetic's numbers. Limits are rounded outwards: a t that float32 holds is between them if it is
// between those given.
template <class Real>
MASU_HD inline Ray<Real> rounded(const Ray<double>& ray) {
  if constexpr (sizeof(Real) == sizeof(double))
    return ray;
  else
    return {cast<Real>(ray.origin), rounded_down(ray.t_min), cast<Real>(ray.direction),
            rounded_up(ray.t_max)};
}

// A float32 limit in float64: halfway to the next number on the inside, for a t that rounds to the limit
// isn't between the limits.
template <class Number>
MASU_HD inline double limit_in_float64(Number t, Number inside) {
  if constexpr (sizeof(Number) == sizeof(double))
    return t;
  else
    return t > 0 ? (static_cast<double>(t) + static_cast<double>(inside)) / 2 : static_cast<double>(t);
}

// Ray i of a list, relative to the scene's origin.
MASU_HD inline Ray<double> in_float64(const void* rays, const RayFormat& format, std::size_t i) {
  const std::size_t first = i * static_cast<std::size_t>(format.numbers);
  const auto converted = [&](const auto& ray) {
    return Ray<double>{cast<double>(ray.origin) - format.origin,
                       limit_in_float64(ray.t_min, next_above(ray.t_min)), cast<double>(ray.direction),
                       limit_in_float64(ray.t_max, next_below(ray.t_max))};
  };
  return format.is_float64
             ? converted(loaded_numbers(static_cast<const double*>(rays) + first, format.numbers))
             : converted(loaded_numbers(static_cast<const float*>(rays) + first, format.numbers));
}
// Whether rays of a list may lose digits.
template <class Real>
MASU_HD inline bool may_be_rounded(const RayFormat& format) {
  return sizeof(Real) < sizeof(double) && (format.is_float64 || !(format.origin == Vec3d{0, 0, 0}));
}

template <class Real>
MASU_HD inline Ray<Real> loaded(const void* rays, const RayFormat& format, std::size_t i) {
  if constexpr (sizeof(Real) == sizeof(float)) { // mostly they are as they are traced
    if (!may_be_rounded<Real>(format))
      return loaded_numbers(static_cast<const float*>(rays) + i * static_cast<std::size_t>(format.numbers),
                            format.numbers);
  }
  return rounded<Real>(in_float64(rays, format, i));
}

// --- Rays made ready ---------------------------------------------------------------------------------------

// Beyond these something might overflow or underflow on the way.
template <class Real>
inline constexpr Real max_ray_origin = sizeof(Real) == sizeof(float) ? Real(1e15F) : Real(1e105);
inline constexpr float max_ray_direction = 1e15F, min_ray_direction = 1e-15F;

// Whether origin and direction are finite and neither is beyond what arithmetic allows. A ray that isn't
// valid hits nothing.
template <class Real>
MASU_HD inline bool is_valid(const Ray<Real>& ray) {
  const Vec3<Real>&o = ray.origin, &d = ray.direction;
  // min() and max() may pass over a NaN; a sum keeps it, and is finite for numbers in range.
  const Real sum = o.x + o.y + o.z + d.x + d.y + d.z;
  const Real size = largest_magnitude(d);
  return sum * 0 == 0 && largest_magnitude(o) <= max_ray_origin<Real> && size <= Real(max_ray_direction) &&
         size >= Real(min_ray_direction);
}

// Scales the direction by a power of two, so that its largest component is between 1 and 2 and nothing
// overflows on the way: exact. Returns what t is to be multiplied by afterwards. A ray that isn't valid, or
// whose t_min or t_max is NaN, becomes one that hits nothing; a negative t_min counts as 0.
template <class Real>
MASU_HD inline Real scale_direction(Ray<Real>& ray) {
  if (!is_valid(ray) || !(ray.t_min < ray.t_max)) {
    ray = {{0, 0, 0}, 0, {1, 0, 0}, -1};
    return 1;
  }
  const Real scale = inverse_power_of_two(static_cast<float>(largest_magnitude(ray.direction)));
  const Real inverse = 1 / scale; // exact
  ray.direction = ray.direction * scale;
  ray.t_min = fast_max(ray.t_min * inverse, Real(0));
  ray.t_max = fast_min(ray.t_max * inverse, RealTraits<Real>::largest);
  return scale;
}

// Scales and clips a ray to the scene; false where it misses the bounds. The clipped ray's t_min is written
// to `t_min` alone, which needn't be in a register.
template <class Real, class Stored>
MASU_HD inline bool scale_and_clip(const SceneView<Stored>& scene, Ray<Real> ray, ClippedRay<Real>& near,
                                   Real& scale, Real& t_min) {
  scale = scale_direction(ray);
  t_min = ray.t_min;
  if (!clip_but_t_min(ray, cast<Real>(scene.clip), near)) return false;
  if (t_min > 0) t_min = clipped_t_min(t_min, near.skipped);
  return true;
}

// --- Rays from far away ------------------------------------------------------------------------------------

// Float32 hasn't the digits of a ray from far away: rounding its origin and its direction moves it aside by
// u times the distance. So a ray that would lose digits first goes on in float64, until it is near. `skipped`
// is t up to there, which is added to that of its hits. With M the largest coordinate of the scene's bounds,
// rays that start within ±4 M of the scene's origin are near: rounding moves them aside by less than 16 u M,
// which the error bound (margin.h) has room for. Rays whose numbers float32 holds stay as they are, however
// they are stored.
template <class Real>
struct ListedRay {
  Ray<Real> ray;
  double skipped = 0;
};

// Ray i of a list as it is traced. `box`: the scene's padded bounds.
template <class Real, class Stored>
MASU_HD inline ListedRay<Real> listed_ray(const void* rays, const RayFormat& format, std::size_t i,
                                          const Box<Stored>& box) {
  if (!may_be_rounded<Real>(format)) return {loaded<Real>(rays, format, i)};
  const Ray<double> given = in_float64(rays, format, i);
  const Ray<Real> ray = rounded<Real>(given);
  const auto largest = static_cast<double>(largest_magnitude(box));
  if (!(largest_magnitude(given.origin) > 4 * largest) ||
      (cast<double>(ray.origin) == given.origin && cast<double>(ray.direction) == given.direction) ||
      !is_valid(ray))
    return {ray};
  constexpr double unit = RealTraits<double>::unit_roundoff;
  const Vec3d d = given.direction;
  Vec3d o = given.origin;
  double skipped = 0;
  // Along the axis that it is farthest away on, to 2 M, or a little less far. From where a rounding of that
  // is longer than the scene, it takes more than once. What goes away from the scene hits nothing.
  for (int moves = 0; moves < most_clips; ++moves) {
    const Vec3d size{std::abs(o.x), std::abs(o.y), std::abs(o.z)};
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    if (!(size[axis] > 4 * largest && o[axis] * d[axis] < 0)) break;
    // Of few digits: then its sums with t are mostly exact.
    const double t = rounded_down((size[axis] - 2 * largest) / std::abs(d[axis]) * (1 - 8 * unit));
    o = fma(d, t, o);
    skipped += t;
  }
  // Limits are drawn together by four roundings: t + skipped, rounded, is then between those given.
  return {
      rounded<Real>({o, given.t_min * (1 + 4 * unit) - skipped, d, given.t_max * (1 - 4 * unit) - skipped}),
      skipped};
}

// --- Results -----------------------------------------------------------------------------------------------

// Where results go: an array of one element per ray each, in the rays' order, or null for what isn't wanted.
// nearest_hit writes t (in lengths of the direction; infinity for a miss) and primitive (its index in the
// scene file; no_primitive for a miss); besides, its object (index in the NFF text), face (intersect.h),
// barycentric coordinates (u, v) on a triangle, so that the point is (1 - u - v) a + u b + v c, and the
// geometric normal, of unit length, on the primitive's front; the shading normal, interpolated where its
// corners have normals; and the point of the primitive that is hit, in the list's coordinates; no_primitive
// and zeros for a miss, and of the point NaN; zeros for u and v on other kinds. occlusion writes 1 or 0.
// `costs` is written where rays are counted (TracingRules::count). t64: t with all digits that the arithmetic
// has; front: 1 where the front is met.
//
// all_hits writes a row of HitRules::limit elements per ray, the hits in their order and then misses; count:
// how many hits there are, at most `limit` of them. count_hits writes count, of all, and inside: 1 where one
// more of them is of a back than of a front, 0 where as many are, and else 2: the surfaces aren't closed, or
// their fronts not outside, or one lies in another.
struct RayResults {
  float* t = nullptr;
  double* t64 = nullptr;
  std::uint32_t* primitive = nullptr;
  std::uint32_t* object = nullptr;
  std::uint32_t* face = nullptr;
  float (*uv)[2] = nullptr;
  float (*normal)[3] = nullptr;
  std::uint8_t* front = nullptr;
  double (*position)[3] = nullptr;
  float (*shading)[3] = nullptr;
  std::uint32_t* count = nullptr;
  std::uint8_t* inside = nullptr;
  std::uint8_t* occluded = nullptr;
  RayCosts costs{};

  MASU_HD bool has_attributes() const {
    return object != nullptr || face != nullptr || uv != nullptr || normal != nullptr ||
           position != nullptr || shading != nullptr;
  }
};

// Calls act(array) for each of a list's results; the first arrays_of_hits have an element per hit, the others
// one per ray.
inline constexpr std::size_t arrays_of_hits = 10;
template <class Results, class Act>
void for_each_array(Results& results, const Act& act) {
  const auto all = [&](auto&... arrays) { (act(arrays), ...); };
  auto& [t, t64, primitive, object, face, uv, normal, front, position, shading, count, inside, occluded,
         costs] = results;
  all(t, t64, primitive, object, face, uv, normal, front, position, shading, count, inside, occluded,
      costs.cells, costs.tests);
}

// What is reported of a ray that was scaled and clipped: `nearest` is at t_max where nothing was hit.
template <class Real>
MASU_HD inline Hit<float> reported(const Hit<Real>& nearest, Real t_max, Real skipped, Real scale) {
  if (!(nearest.t < t_max)) return no_hit();
  return {static_cast<float>((nearest.t + skipped) * scale), nearest.primitive};
}

// Has so many elements count from a list's ray and in its coordinates: adds what listed_ray() skipped to
// their t, and the origin that was subtracted to their positions.
MASU_HD inline void to_list(double skipped, const Vec3d& origin, const RayResults& results, std::size_t first,
                            std::uint32_t count) {
  if (results.position != nullptr)
    for (std::size_t i = first; i < first + count; ++i)
      for (int axis = 0; axis < 3; ++axis)
        if (double& at = results.position[i][axis]; at == at) at += origin[axis]; // the bits of NaN stay
  if (skipped == 0) return;
  for (std::size_t i = first; i < first + count; ++i) {
    if (results.t != nullptr) results.t[i] = static_cast<float>(static_cast<double>(results.t[i]) + skipped);
    if (results.t64 != nullptr) results.t64[i] += skipped;
  }
}

template <Query query>
MASU_HD inline void write_hit(const RayResults& results, std::size_t i, const Hit<float>& hit) {
  if constexpr (query == Query::occlusion) {
    results.occluded[i] = hit.primitive != no_primitive;
    return;
  }
  if (results.t != nullptr) results.t[i] = hit.t;
  if (results.primitive != nullptr) results.primitive[i] = hit.primitive;
}

// What a ray of a list hits: for occlusion, some primitive or none.
template <Query query, class M, class Stored, class Structure, class Counts>
MASU_HD inline Hit<float> trace_listed(const SceneView<Stored>& scene, const Structure& structure,
                                       Ray<typename M::Real> ray, Counts& counts) {
  using Real = typename M::Real;
  const Real scale = scale_direction(ray);
  if constexpr (query == Query::occlusion) {
    const bool occluded = is_occluded<M>(scene, structure, ray, counts);
    counts.shadow_ray(occluded);
    return {0, occluded ? 0 : no_primitive};
  }
  const Hit<Real> hit = nearest_hit<M>(scene, structure, ray, counts);
  counts.camera_ray(hit.primitive != no_primitive);
  if (hit.primitive == no_primitive) return no_hit();
  return {static_cast<float>(hit.t * scale), hit.primitive};
}

// Of a hit, besides t and the primitive; by default of a miss.
struct HitAttributes {
  std::uint32_t object = no_primitive, face = no_primitive;
  float u = 0, v = 0;
  Vec3f normal{0, 0, 0}, shading{0, 0, 0};
  Vec3d position{not_a_number, not_a_number, not_a_number};

  static constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
};
MASU_HD inline void write_attributes(const HitAttributes& hit, const RayResults& results, std::size_t i) {
  if (results.object != nullptr) results.object[i] = hit.object;
  if (results.face != nullptr) results.face[i] = hit.face;
  if (results.uv != nullptr) {
    results.uv[i][0] = hit.u;
    results.uv[i][1] = hit.v;
  }
  for (int axis = 0; axis < 3; ++axis) {
    if (results.normal != nullptr) results.normal[i][axis] = hit.normal[axis];
    if (results.position != nullptr) results.position[i][axis] = hit.position[axis];
    if (results.shading != nullptr) results.shading[i][axis] = hit.shading[axis];
  }
}

// Of the point of a triangle with these weights of b and c.
template <class Stored>
MASU_HD inline void set_on_triangle(HitAttributes& found, const SceneView<Stored>& scene,
                                    const Triangle<Stored>& triangle, const Vec3d& normal, double u,
                                    double v) {
  const EdgeFunctions<double> weights{1 - u - v, u, v};
  found.normal = cast<float>(normal);
  found.u = static_cast<float>(u);
  found.v = static_cast<float>(v);
  found.shading = cast<float>(shading_normal(scene, triangle, weights, normal));
  found.position =
      interpolate(weights, cast<double>(triangle.a), cast<double>(triangle.b), cast<double>(triangle.c));
}

// What depends on how a scene's primitives are held (placed_rays.h): a list's structure as ray i sees it, how
// a hit is named, and its record.
template <class Structure>
MASU_HD inline const Structure& seen_by(const Structure& structure, std::size_t) {
  return structure;
}
template <class Structure>
using SeenIn = std::remove_cvref_t<decltype(seen_by(std::declval<Structure>(), 0))>;
template <class Stored, class Structure>
MASU_HD inline void set_name(const SceneView<Stored>& scene, const Structure&, PrimitiveIndex primitive,
                             HitAttributes& found) {
  found.object = surface_of(scene, primitive).object;
  found.face = face_of(scene, primitive);
}
template <class Stored, class Structure>
MASU_HD inline Leaf<Stored> leaf_of(const SceneView<Stored>& scene, const Structure&,
                                    PrimitiveIndex primitive) {
  return leaf_of(scene, primitive);
}

// Writes the attributes of a hit as element i; of a miss where `near` has no primitive.
template <class TestRay, class Stored, class Structure>
MASU_HD inline void write_attributes(const SceneView<Stored>& scene, const Structure& structure,
                                     const NearHit<TestRay>& near, const RayResults& results, std::size_t i) {
  HitAttributes found;
  const PrimitiveIndex primitive = near.hit.primitive;
  if (primitive != no_primitive) {
    set_name(scene, structure, primitive, found);
    if (primitive < scene.triangle_count) {
      const Triangle<Stored> triangle = leaf_of(scene, structure, primitive).record;
      const TriangleHit hit = triangle_hit(near.ray, near.hit.t, triangle);
      set_on_triangle(found, scene, triangle, hit.normal, hit.u, hit.v);
    } else {
      const auto point = surface_at<with_spheres | with_cones>(scene, near);
      found.normal = found.shading = cast<float>(point.normal);
      found.position = cast<double>(point.position);
    }
  }
  write_attributes(found, results, i);
}

// Of ray i's hit, whose t counts from its own origin.
template <class Real, class Stored, class Structure>
MASU_HD inline void write_attributes(const SceneView<Stored>& scene, const Structure& structure,
                                     Ray<Real> ray, const Hit<float>& hit, const RayResults& results,
                                     std::size_t i) {
  if (hit.primitive == no_primitive) return write_attributes(HitAttributes{}, results, i);
  const Real scale = scale_direction(ray);
  const Hit<Real> scaled{static_cast<Real>(hit.t) / scale, hit.primitive};
  const auto record = [&] { return leaf_of(scene, structure, hit.primitive); };
  write_attributes(scene, structure, hit_again(scene, ray, scaled, record), results, i);
}

} // namespace masu
