// A scene's triangles in Embree: to compare with.
#pragma once

#include "libscene/geometry/ray.h"
#include "libscene/scene_view.h"

#include <span>
#include <string>

struct RTCDeviceTy;
struct RTCSceneTy;

namespace masu {

// Whether this program was built with Embree. Without it EmbreeScene's constructor throws Error(usage).
extern const bool embree_available;
std::string embree_name(); // with its version

struct EmbreeFlags {
  bool robust;       // RTC_SCENE_FLAG_ROBUST: watertight; else RTC_SCENE_FLAG_NONE
  bool high_quality; // RTC_BUILD_QUALITY_HIGH: most speed of single rays; else the default
};

class EmbreeScene {
public:
  // The scene's triangles are used where they are.
  EmbreeScene(const SceneView<float>& scene, EmbreeFlags flags);
  ~EmbreeScene();
  EmbreeScene(const EmbreeScene&) = delete;
  EmbreeScene& operator=(const EmbreeScene&) = delete;

  // The closest hits by rtcIntersect1, on this thread: infinity and no_primitive for a miss.
  void trace(std::span<const Ray<float>> rays, float* t, PrimitiveIndex* primitive) const;
  // The same by rtcIntersect8, which is told that rays side by side are alike.
  void trace_packets(std::span<const Ray<float>> rays, float* t, PrimitiveIndex* primitive) const;

private:
  RTCDeviceTy* device_ = nullptr;
  RTCSceneTy* scene_ = nullptr;
};

} // namespace masu
