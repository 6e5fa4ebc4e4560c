#include "stability/oracle/embree_scene.h"

#include "libscene/base/error.h"

#include <fmt/format.h>

#if MASU_EMBREE_VERSION == 3
#include <embree3/rtcore.h>
#else
#include <embree4/rtcore.h>
#endif
#include <pmmintrin.h>
#include <xmmintrin.h>

namespace masu {

const bool embree_available = true;

std::string embree_name() {
  return "Embree " RTC_VERSION_STRING;
}

EmbreeScene::EmbreeScene(const SceneView<float>& scene, EmbreeFlags flags)
    : device_(rtcNewDevice(nullptr)), scene_(rtcNewScene(device_)) {
  rtcSetSceneBuildQuality(scene_, flags.high_quality ? RTC_BUILD_QUALITY_HIGH : RTC_BUILD_QUALITY_MEDIUM);
  rtcSetSceneFlags(scene_, flags.robust ? RTC_SCENE_FLAG_ROBUST : RTC_SCENE_FLAG_NONE);
  if (scene.triangle_count > 0) {
    auto* const geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    // A triangle's record is three vertices of 16 bytes.
    constexpr std::size_t vertex_bytes = sizeof(Triangle<float>) / 3;
    const std::size_t vertices = std::size_t{3} * scene.triangle_count;
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, scene.triangles, 0,
                               vertex_bytes, vertices);
    auto* corners = static_cast<std::uint32_t*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                3 * sizeof(std::uint32_t), scene.triangle_count));
    for (std::size_t i = 0; corners != nullptr && i < vertices; ++i)
      corners[i] = static_cast<std::uint32_t>(i);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
  }
  rtcCommitScene(scene_);
  if (const RTCError error = rtcGetDeviceError(device_); error != RTC_ERROR_NONE) {
    const int number = error;
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
    throw Error(ErrorCode::device, embree_name(), fmt::format("can't build the scene: its error {}", number));
  }
}

EmbreeScene::~EmbreeScene() {
  rtcReleaseScene(scene_);
  rtcReleaseDevice(device_);
}

namespace {

// As Embree's manual asks for while rays are traced: denormals count as zero.
class DenormalsAreZero {
public:
  DenormalsAreZero() {
    _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
    _MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_ON);
  }
  ~DenormalsAreZero() { _mm_setcsr(before_); }
  DenormalsAreZero(const DenormalsAreZero&) = delete;
  DenormalsAreZero& operator=(const DenormalsAreZero&) = delete;

private:
  unsigned int before_ = _mm_getcsr();
};

} // namespace

void EmbreeScene::trace(std::span<const Ray<float>> rays, float* t, PrimitiveIndex* primitive) const {
  const DenormalsAreZero mode;
#if MASU_EMBREE_VERSION == 3
  RTCIntersectContext context{};
  rtcInitIntersectContext(&context);
#endif
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const Ray<float>& ray = rays[i];
    RTCRayHit found; // NOLINT(cppcoreguidelines-pro-type-member-init): what Embree reads is set
    found.ray = {ray.origin.x,
                 ray.origin.y,
                 ray.origin.z,
                 ray.t_min,
                 ray.direction.x,
                 ray.direction.y,
                 ray.direction.z,
                 0,
                 ray.t_max,
                 0xffffffffU,
                 0,
                 0};
    found.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    found.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
#if MASU_EMBREE_VERSION == 3
    rtcIntersect1(scene_, &context, &found);
#else
    rtcIntersect1(scene_, &found);
#endif
    const bool hit = found.hit.geomID != RTC_INVALID_GEOMETRY_ID;
    t[i] = hit ? found.ray.tfar : INFINITY;
    primitive[i] = hit ? found.hit.primID : no_primitive;
  }
}

void EmbreeScene::trace_packets(std::span<const Ray<float>> rays, float* t, PrimitiveIndex* primitive) const {
  constexpr std::size_t width = 8;
  const DenormalsAreZero mode;
#if MASU_EMBREE_VERSION == 3
  RTCIntersectContext context{};
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
#else
  RTCIntersectArguments arguments{};
  rtcInitIntersectArguments(&arguments);
  arguments.flags = RTC_RAY_QUERY_FLAG_COHERENT;
#endif
  for (std::size_t first = 0; first < rays.size(); first += width) {
    const std::size_t count = std::min(width, rays.size() - first);
    alignas(32) int valid[width] = {};
    RTCRayHit8 found{};
    for (std::size_t i = 0; i < count; ++i) {
      const Ray<float>& ray = rays[first + i];
      valid[i] = -1;
      found.ray.org_x[i] = ray.origin.x;
      found.ray.org_y[i] = ray.origin.y;
      found.ray.org_z[i] = ray.origin.z;
      found.ray.tnear[i] = ray.t_min;
      found.ray.dir_x[i] = ray.direction.x;
      found.ray.dir_y[i] = ray.direction.y;
      found.ray.dir_z[i] = ray.direction.z;
      found.ray.tfar[i] = ray.t_max;
      found.ray.mask[i] = 0xffffffffU;
      found.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
      found.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
    }
#if MASU_EMBREE_VERSION == 3
    rtcIntersect8(valid, scene_, &context, &found);
#else
    rtcIntersect8(valid, scene_, &found, &arguments);
#endif
    for (std::size_t i = 0; i < count; ++i) {
      const bool hit = found.hit.geomID[i] != RTC_INVALID_GEOMETRY_ID;
      t[first + i] = hit ? found.ray.tfar[i] : INFINITY;
      primitive[first + i] = hit ? found.hit.primID[i] : no_primitive;
    }
  }
}

} // namespace masu
