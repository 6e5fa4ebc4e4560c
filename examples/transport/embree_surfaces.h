// The same surfaces in Embree: its coordinates are floats, and a ray starts an epsilon off what it leaves.
#pragma once

#include "game.h"

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <cstring>
#include <limits>

class EmbreeSurfaces {
public:
  explicit EmbreeSurfaces(const transport::Geometry& geometry) {
    rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
    for (const auto& surface : geometry.surfaces) {
      const RTCGeometry mesh = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
      fill(mesh, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, geometry.vertices);
      fill(mesh, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, surface.indices);
      rtcCommitGeometry(mesh);
      rtcAttachGeometry(scene_, mesh); // its number is the surface's
      rtcReleaseGeometry(mesh);
    }
    rtcCommitScene(scene_);
  }
  EmbreeSurfaces(const EmbreeSurfaces&) = delete;
  EmbreeSurfaces& operator=(const EmbreeSurfaces&) = delete;
  ~EmbreeSurfaces() {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
  }

  void operator()(const std::vector<transport::Particle>& particles, std::vector<transport::Met>& met) const {
    for (std::size_t i = 0; i < particles.size(); ++i) {
      const auto& p = particles[i];
      RTCRayHit query{};
      RTCRay& ray = query.ray;
      ray.org_x = static_cast<float>(p.at[0]);
      ray.org_y = static_cast<float>(p.at[1]);
      ray.org_z = static_cast<float>(p.at[2]);
      ray.dir_x = static_cast<float>(p.along[0]);
      ray.dir_y = static_cast<float>(p.along[1]);
      ray.dir_z = static_cast<float>(p.along[2]);
      ray.tnear = p.crossed == transport::none ? 0 : epsilon;
      ray.tfar = std::numeric_limits<float>::infinity();
      ray.mask = ~0U;
      query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
#if RTC_VERSION_MAJOR >= 4
      rtcIntersect1(scene_, &query);
#else
      RTCIntersectContext context;
      rtcInitIntersectContext(&context);
      rtcIntersect1(scene_, &context, &query);
#endif
      const RTCHit& hit = query.hit;
      const float towards = hit.Ng_x * ray.dir_x + hit.Ng_y * ray.dir_y + hit.Ng_z * ray.dir_z;
      met[i] = {static_cast<double>(ray.tfar), hit.primID, hit.geomID, towards < 0};
    }
  }

private:
  static constexpr float epsilon = 1e-5F; // some float32 roundings of the torus' size

  template <class Number>
  static void fill(RTCGeometry mesh, RTCBufferType type, RTCFormat format,
                   const std::vector<Number>& numbers) {
    void* const to = rtcSetNewGeometryBuffer(mesh, type, 0, format, 3 * sizeof(Number), numbers.size() / 3);
    std::memcpy(to, numbers.data(), numbers.size() * sizeof(Number));
  }

  RTCDevice device_ = rtcNewDevice(nullptr);
  RTCScene scene_ = rtcNewScene(device_);
};
