// Lists of rays on the CPU, through any structure.
#pragma once

#include "renderer/cpu/on_cpu.h"
#include "renderer/rays/closest_points.h"
#ifdef MASU_HOST_AVX2
#include "renderer/cpu/packet_lists.h"
#endif

#include <algorithm>

namespace masu {

// How many tests a ray takes where each primitive is tried.
template <class Stored, class Structure>
std::uint64_t tests_each(const SceneView<Stored>& scene, const Structure&) {
  return std::is_same_v<Structure, NoStructure> ? scene.primitive_count() : 0;
}

// Whether it is placed meshes, whose rays see each its own.
template <class Structure>
inline constexpr bool is_placed = !std::is_same_v<SeenIn<Structure>, Structure>;

// Lists through placed meshes may be short, as a robot's sensor's are, and are shared by cores nevertheless.
template <class Structure>
std::size_t rays_per_task(std::size_t count) {
  constexpr std::size_t least = 512, most = 4096;
  return is_placed<Structure> ? std::clamp(count / 64, least, most) : most;
}

// Traces as many rays from `first` on as can be several at a time; returns the first one left.
template <Query query, class M, class Stored, class Structure, class C>
std::size_t
trace_in_lanes([[maybe_unused]] const SceneView<Stored>& scene, [[maybe_unused]] const Structure& structure,
               [[maybe_unused]] const RayList& rays, [[maybe_unused]] const RayResults& results,
               [[maybe_unused]] ListProgress& progress, std::size_t first, [[maybe_unused]] std::size_t end) {
#ifdef MASU_HOST_AVX2
  using Real = typename M::Real;
  if constexpr (std::is_same_v<typename M::TestRay, WatertightRay<Real>> && !C::is_counted &&
                (!is_any_structure<Structure> || std::is_same_v<Stored, double>)) {
    const auto found = [&](std::size_t i, const ListedHit<Real>& listed) __attribute__((always_inline)) {
      progress.done(i);
      const Hit<float> hit = reported(listed);
      write_hit<query>(results, i, hit);
      if (query != Query::nearest_hit || (hit.primitive == no_primitive && !results.has_attributes())) return;
      const bool is_named =
          results.has_attributes() || (is_placed<Structure> && results.primitive != nullptr);
      if (!is_named && !may_be_rounded<Real>(rays.format)) return;
      const ListedRay<Real> ray = listed_ray<Real>(rays.rays, rays.format, i, scene.clip);
      write_named(scene, seen_by(structure, i), ray.ray, hit, results, i);
      to_list(ray.skipped, rays.format.origin, results, i, 1);
    };
    const auto by_list = [&]<class Tests>(Tests, const auto& hierarchy) {
      return trace_list<query, Tests>(scene, hierarchy, rays.rays, rays.format, first, end, found);
    };
    if constexpr (is_any_structure<Structure>) { // no code is compiled for its structure and kinds alone
      if (structure.form != StructureForm::hierarchy) return first;
      return scene.primitive_count() == scene.triangle_count
                 ? by_list(Method<typename M::TestRay, with_triangles>{}, structure.hierarchy)
                 : by_list(M{}, structure.hierarchy);
    } else if constexpr (is_placed<Structure>) {
      if constexpr (tests_triangles_in_lanes<M, Stored>)
        if (!structure.placed.is_brute_force) return by_list(M{}, structure);
    } else if constexpr (std::is_same_v<Structure, HierarchyView<Real>>)
      return by_list(M{}, structure);
    else
      return trace_in_turn<query, M>(scene, structure, rays.rays, rays.format, first, end, found);
  }
#endif
  return first;
}

template <Query query, class M, class Stored, class Structure, class C>
void trace(const SceneView<Stored>& scene, const Structure& structure, const RayList& rays,
           const RayResults& results, const std::function<void(double)>& report_progress, QueryReport& report,
           const C&) {
  using Real = typename M::Real;
  ListProgress progress(report_progress, rays.count, 256, tests_each(scene, structure));
  const auto trace_some = [&](std::size_t begin, std::size_t end) {
    Counts counts;
    for (std::size_t i = trace_in_lanes<query, M, Stored, Structure, C>(scene, structure, rays, results,
                                                                        progress, begin, end);
         i != end; ++i) {
      progress.done(i);
      const ListedRay<Real> ray = listed_ray<Real>(rays.rays, rays.format, i, scene.clip);
      const auto& seen = seen_by(structure, i);
      C ray_counts;
      const Hit<float> hit = trace_listed<query, M>(scene, seen, ray.ray, ray_counts);
      write_hit<query>(results, i, hit);
      write_costs(results.costs, i, ray_counts);
      add(counts, ray_counts);
      if (query != Query::nearest_hit) continue;
      write_named(scene, seen, ray.ray, hit, results, i);
      to_list(ray.skipped, rays.format.origin, results, i, 1);
    }
    return counts;
  };
  report.counts = parallel_reduce(rays.count, rays_per_task<Structure>(rays.count), Counts{}, trace_some,
                                  [](Counts a, const Counts& b) { return a += b; });
}

// Hits in order, through what takes so many tests each.
template <class M, class Stored, class Structure>
void list_hits(const SceneView<Stored>& scene, const Structure& structure, std::uint64_t tests,
               const RayList& rays, const RayResults& results, const RaysRequest& request) {
  const HitRules rules = hit_rules(request);
  for_each_in_list(rays, request, tests, [&](std::size_t i) {
    const auto ray = listed_ray<typename M::Real>(rays.rays, rays.format, i, scene.clip);
    write_hits<M>(scene, seen_by(structure, i), ray.ray, rays.filters, rules, results, i);
    to_list(ray.skipped, rays.format.origin, results, i * rules.row(), rules.row());
  });
}

template <class Stored, class Structure>
void find_closest(const SceneView<Stored>& scene, const Structure& structure, const RayList& places,
                  const RayResults& results, const RaysRequest& request) {
  for_each_in_list(places, request, tests_each(scene, structure), [&](std::size_t i) {
    write_closest(scene, seen_by(structure, i), places.rays, places.format, places.filters, results, i);
  });
}

} // namespace masu
