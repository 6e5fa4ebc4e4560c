// A picture as it is asked for, and as it is traced.
#pragma once

#include "libscene/base/host_array.h"
#include "renderer/camera.h"
#include "renderer/counts.h"
#include "renderer/render_pixel.h"
#include "renderer/tracing_rules.h"

#include <functional>

namespace masu {

struct FrameRequest {
  TracingRules tracing{};
  Camera camera{}; // in the world
  Sampling sampling = Sampling::corners;
  bool hither = false; // camera rays start at the camera's hither distance
  RenderRules rules{5, false, HitName::object};
  bool shaded = true;                     // false: hits and costs of camera rays alone, no radiance
  bool rgb = false;                       // a GPU may report Frame::rgb instead of radiance
  bool hits = false;                      // report the hit of each camera ray
  bool attributes = false;                // and its object and normal; hits are named by primitive
  RayWindow window{};                     // the camera rays to trace; all, where it has no columns
  bool count_last_row = true;             // false: of a band whose last row of rays the next band counts
  std::function<void(double)> progress{}; // gets the share of rays traced, from any thread; on the CPU only
  bool costs = false; // report what each camera ray and all that it spawns took; it is then counted
};

// What was requested of each camera ray, row by row from the top: of the window.
struct Frame {
  std::int32_t columns = 0, rows = 0;
  HostArray<Vec3f> radiance;
  HostArray<std::uint8_t> rgb; // of the picture's pixels, by byte_of(); radiance is then left out
  HostArray<HitRecord> hits;
  HostArray<std::int32_t> objects;       // as RayResults has them
  HostArray<Vec3f> normals;              // likewise
  HostArray<std::uint32_t> cells, tests; // as RayCosts has them
  Counts counts;
  TraceSeconds seconds;
  KernelSize kernel{};
};

// Calls act(a's array, b's array) for each kind of array.
template <class A, class B, class Act>
void for_each_array(A& a, B& b, const Act& act) {
  const auto all = [&](auto... arrays) { (act(a.*arrays, b.*arrays), ...); };
  all(&Frame::radiance, &Frame::rgb, &Frame::hits, &Frame::objects, &Frame::normals, &Frame::cells,
      &Frame::tests);
}

// Throws Error(usage) for one that isn't from 1 to largest_depth.
void check_depth(std::int32_t depth);

// Also for a window that isn't within the picture.
void check_request(const FrameRequest& request);

// The camera rays that are traced.
RayWindow window_of(const FrameRequest& request);

// Of the right size, for a backend that writes every ray's values: what they are before isn't defined. Takes
// the memory of a frame that isn't needed any more.
Frame sized_frame(const FrameRequest& request, Frame memory = {});

} // namespace masu
