// What a picture took, counted ray by ray; or not counted, at no cost.
#pragma once

#include "libgrid/grid/grid_walk.h"

#include <cstddef>
#include <cstdint>

namespace masu {

// Each function is called when the thing happens.
struct Counts {
  static constexpr bool is_counted = true;
  std::uint64_t camera_rays = 0, camera_hits = 0;
  std::uint64_t reflection_rays = 0, refraction_rays = 0, secondary_hits = 0;
  std::uint64_t shadow_rays = 0, shadow_hits = 0;
  std::uint64_t triangle_tests = 0, sphere_tests = 0, cone_tests = 0;
  std::uint64_t cells_visited = 0, empty_cells_visited = 0, voxels_skipped = 0;

  MASU_HD void triangle_test() { ++triangle_tests; }
  MASU_HD void sphere_test() { ++sphere_tests; }
  MASU_HD void cone_test() { ++cone_tests; }
  MASU_HD void cell(bool empty) {
    ++cells_visited;
    empty_cells_visited += empty;
  }
  // Voxels on the way to the next cell that needed no visit.
  MASU_HD void skipped(std::int32_t voxels) { voxels_skipped += static_cast<std::uint64_t>(voxels); }
  MASU_HD void camera_ray(bool hit) {
    ++camera_rays;
    camera_hits += hit;
  }
  MASU_HD void reflection_ray() { ++reflection_rays; }
  MASU_HD void refraction_ray() { ++refraction_rays; }
  MASU_HD void secondary_ray(bool hit) { secondary_hits += hit; }
  MASU_HD void shadow_ray(bool hit) {
    ++shadow_rays;
    shadow_hits += hit;
  }
};

// Calls act(a's count, b's) for each count.
template <class A, class B, class Act>
MASU_HD inline void for_each_count(A& a, B& b, const Act& act) {
  const auto all = [&](auto... counts) { (act(a.*counts, b.*counts), ...); };
  all(&Counts::camera_rays, &Counts::camera_hits, &Counts::reflection_rays, &Counts::refraction_rays,
      &Counts::secondary_hits, &Counts::shadow_rays, &Counts::shadow_hits, &Counts::triangle_tests,
      &Counts::sphere_tests, &Counts::cone_tests, &Counts::cells_visited, &Counts::empty_cells_visited,
      &Counts::voxels_skipped);
}

// Where the cells visited and the primitive tests of each ray go, or of each camera ray and all that it
// spawns: an array of one element per ray each, or null for what isn't wanted. Counts beyond 32 bits are 2^32
// - 1.
struct RayCosts {
  std::uint32_t* cells = nullptr;
  std::uint32_t* tests = nullptr;

  MASU_HD bool wanted() const { return cells != nullptr || tests != nullptr; }
};

// `counts`: of ray i alone.
MASU_HD inline void write_costs(const RayCosts& costs, std::size_t i, const Counts& counts) {
  constexpr std::uint64_t largest = 0xffffffffU;
  const auto clamped = [](std::uint64_t n) { return static_cast<std::uint32_t>(n < largest ? n : largest); };
  if (costs.cells != nullptr) costs.cells[i] = clamped(counts.cells_visited);
  if (costs.tests != nullptr)
    costs.tests[i] = clamped(counts.triangle_tests + counts.sphere_tests + counts.cone_tests);
}

struct NoCounts : NoWalkCounts {
  MASU_HD void camera_ray(bool) {}
  MASU_HD void reflection_ray() {}
  MASU_HD void refraction_ray() {}
  MASU_HD void secondary_ray(bool) {}
  MASU_HD void shadow_ray(bool) {}
};

MASU_HD inline void write_costs(const RayCosts&, std::size_t, const NoCounts&) {}

inline Counts& operator+=(Counts& a, const Counts& b) {
  for_each_count(a, b, [](std::uint64_t& sum, std::uint64_t count) { sum += count; });
  return a;
}

} // namespace masu
