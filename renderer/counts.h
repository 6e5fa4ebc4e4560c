// What a picture took, counted ray by ray; or not counted, at no cost.
#pragma once

#include "libscene/portable.h"

#include <cstdint>

namespace masu {

// Each function is called when the thing happens.
struct Counts {
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

  static constexpr int fields = 13;
  // The fields as an array, for adding up.
  MASU_HD std::uint64_t* begin() { return &camera_rays; }
  MASU_HD const std::uint64_t* begin() const { return &camera_rays; }
};
static_assert(sizeof(Counts) == Counts::fields * sizeof(std::uint64_t));

struct NoCounts {
  MASU_HD void triangle_test() {}
  MASU_HD void sphere_test() {}
  MASU_HD void cone_test() {}
  MASU_HD void cell(bool) {}
  MASU_HD void skipped(std::int32_t) {}
  MASU_HD void camera_ray(bool) {}
  MASU_HD void reflection_ray() {}
  MASU_HD void refraction_ray() {}
  MASU_HD void secondary_ray(bool) {}
  MASU_HD void shadow_ray(bool) {}
};

inline Counts& operator+=(Counts& a, const Counts& b) {
  for (int i = 0; i < Counts::fields; ++i)
    a.begin()[i] += b.begin()[i];
  return a;
}

} // namespace masu
