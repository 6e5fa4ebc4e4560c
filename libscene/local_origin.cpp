#include "libscene/local_origin.h"

#include "libscene/base/error.h"
#include "libscene/geometry/cone.h"
#include "libscene/mesh/indexed_mesh.h"
#include "libscene/scene_bounds.h"

#include <cmath>

namespace masu {
namespace {

// Of a record's points, without radii: exact.
struct PointBox {
  Boxd operator()(const auto& box_or_triangle) const { return bounds(box_or_triangle); }
  Boxd operator()(const Sphere<double>& s) const { return {s.center, s.center}; }
  Boxd operator()(const Cone<double>& c) const { return join(Boxd{c.base, c.base}, c.apex); }
};

// Of a box relative to a corner.
Vec3d automatic_origin(const Vec3d& corner, const Boxd& box) {
  const Vec3d half = (box.max - box.min) * 0.5;
  const double reach = largest_magnitude(half);
  // A scene of one point stays where it is: at zero no store could hold it.
  if (is_empty(box) || !std::isfinite(reach) || reach < 1e-90) return {0, 0, 0};
  const Vec3d center = box.min + half;
  const auto diagonal = [](const Vec3d& v) { return std::hypot(v.x, v.y, v.z); };
  if (!(diagonal(corner + center) > diagonal(half))) return {0, 0, 0};
  const double step = std::ldexp(1.0, std::ilogb(reach) - 8);
  const auto rounded = [&](double value) { return std::floor(value / step) * step; };
  return corner + Vec3d{rounded(center.x), rounded(center.y), rounded(center.z)};
}

} // namespace

template <class Triangles>
Vec3d automatic_origin(const SceneOf<Triangles>& scene) {
  const Vec3d corner = joined_boxes(scene, PointBox{}).min;
  return automatic_origin(corner, joined_boxes(scene, [&](const auto& record) {
                            return bounds(relative_to(corner, record)); // of its kind
                          }));
}
Vec3d automatic_origin(const Boxd& box) {
  return is_empty(box) ? Vec3d{0, 0, 0} : automatic_origin(box.min, relative_to(box.min, box));
}

template <class Triangles>
Vec3d origin_for(const SceneOf<Triangles>& scene, const std::optional<Vec3d>& wanted, const char* place) {
  if (!wanted) return automatic_origin(scene);
  if (!(largest_magnitude(*wanted) <= max_origin) || !is_finite(*wanted))
    throw Error(ErrorCode::usage, place, "isn't a finite point within 1e100 of zero");
  return relative_to({0, 0, 0}, *wanted);
}

template Vec3d automatic_origin(const Scene&);
template Vec3d origin_for(const Scene&, const std::optional<Vec3d>&, const char*);
template Vec3d origin_for(const ArrayScene&, const std::optional<Vec3d>&, const char*);

} // namespace masu
