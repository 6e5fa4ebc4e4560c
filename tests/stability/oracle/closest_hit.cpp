#include "tests/stability/oracle/closest_hit.h"

#include <algorithm>
#include <map>

namespace masu::oracle {
namespace {

// Relative; far above the rounding errors of double in the bounding sphere test.
constexpr double generous = 1e-9;

using Key = std::array<double, 9>;
Key key_of(const Triangle<double>& t) {
  return {t.a.x, t.a.y, t.a.z, t.b.x, t.b.y, t.b.z, t.c.x, t.c.y, t.c.z};
}
Key key_of(const Sphere<double>& s) {
  return {s.center.x, s.center.y, s.center.z, s.radius};
}
Key key_of(const Cone<double>& c) {
  return {c.base.x, c.base.y, c.base.z, c.base_radius, c.apex.x, c.apex.y, c.apex.z, c.apex_radius};
}

template <class Primitive>
void add_first_alike(const std::vector<Primitive>& primitives, std::vector<PrimitiveIndex>& first_alike) {
  std::map<Key, PrimitiveIndex> seen;
  for (const Primitive& primitive : primitives) {
    const auto number = static_cast<PrimitiveIndex>(first_alike.size());
    first_alike.push_back(seen.try_emplace(key_of(primitive), number).first->second);
  }
}

} // namespace

template <class Stored>
SceneOracle::SceneOracle(const SceneView<Stored>& scene) {
  for (std::uint32_t i = 0; i < scene.triangle_count; ++i) {
    const Triangle<double> t = widened(scene.triangles[i]);
    triangles_.push_back(t);
    const Vec3d middle = (t.a + t.b + t.c) * (1.0 / 3);
    add_bounding_sphere(middle, std::max({length(t.a - middle), length(t.b - middle), length(t.c - middle)}));
  }
  for (std::uint32_t i = 0; i < scene.sphere_count; ++i) {
    const Sphere<double> s = widened(scene.spheres[i]);
    spheres_.push_back(s);
    add_bounding_sphere(s.center, std::abs(s.radius));
  }
  for (std::uint32_t i = 0; i < scene.cone_count; ++i) {
    const Cone<double> c = widened(scene.cones[i]);
    cones_.push_back(c);
    const double widest = std::max(std::abs(c.base_radius), std::abs(c.apex_radius));
    add_bounding_sphere((c.base + c.apex) * 0.5, length(c.apex - c.base) / 2 + widest);
  }
  add_first_alike(triangles_, first_alike_);
  add_first_alike(spheres_, first_alike_);
  add_first_alike(cones_, first_alike_);
}
template SceneOracle::SceneOracle(const SceneView<float>&);
template SceneOracle::SceneOracle(const SceneView<double>&);

void SceneOracle::add_bounding_sphere(const Vec3d& center, double radius) {
  x_.push_back(center.x);
  y_.push_back(center.y);
  z_.push_back(center.z);
  radius_.push_back(radius * (1 + generous) + largest_magnitude(center) * 1e-14);
}

Expected SceneOracle::expect_one(const Line& line, PrimitiveIndex primitive, Wide slack) const {
  if (primitive < triangles_.size()) return expect(line, triangles_[primitive], slack);
  const std::size_t sphere = primitive - triangles_.size();
  if (sphere < spheres_.size()) return expect(line, spheres_[sphere], slack);
  return expect(line, cones_[sphere - spheres_.size()], slack);
}

Wide SceneOracle::exact_t(const Ray<double>& ray, PrimitiveIndex primitive) const {
  const Expected expected = expect_one(line(ray.origin, ray.direction), primitive, 0);
  return expected.result == Result::hit ? expected.low : Wide(-1);
}

std::vector<SceneOracle::Near> SceneOracle::near(const Ray<double>& ray, double slack) const {
  const double size = largest_magnitude(ray.direction), distance_of_t = length(ray.direction * (1 / size));
  const Vec3d unit = ray.direction * (1 / size) * (1 / distance_of_t);
  const Vec3d& o = ray.origin;
  std::vector<Near> found;
  for (std::size_t i = 0; i < x_.size(); ++i) {
    const double x = x_[i] - o.x, y = y_[i] - o.y, z = z_[i] - o.z;
    const double along = x * unit.x + y * unit.y + z * unit.z;
    const double off_x = x - along * unit.x, off_y = y - along * unit.y, off_z = z - along * unit.z;
    const double off = off_x * off_x + off_y * off_y + off_z * off_z;
    const double reach = (radius_[i] + 2 * slack + generous * std::abs(along)) * (1 + generous);
    if (!(off <= reach * reach)) continue;
    const double half = reach + generous * std::abs(along);
    if (along + half < 0) continue;
    const double to_t = 1 / distance_of_t / size;
    found.push_back({static_cast<PrimitiveIndex>(i), (along - half) * to_t, (along + half) * to_t});
  }
  return found;
}

ClosestHit SceneOracle::closest(const Ray<double>& ray, double slack) const {
  std::vector<Near> all = near(ray, slack);
  std::sort(all.begin(), all.end(), [](const Near& a, const Near& b) { return a.enter < b.enter; });
  const Line along = line(ray.origin, ray.direction);
  ClosestHit result;
  Wide sure_by = RealTraits<double>::largest; // the smallest t at which a hit is sure
  for (const Near& near : all) {
    if (near.enter > sure_by) break;
    const Expected expected = expect_one(along, near.primitive, slack);
    if (expected.result == Result::miss) continue;
    if (expected.result == Result::unsure) {
      result.candidates.push_back({near.primitive, false, near.enter, near.leave});
    } else {
      result.candidates.push_back({near.primitive, true, expected.low, expected.high});
      sure_by = min(sure_by, expected.high);
      result.may_miss = false;
    }
  }
  std::erase_if(result.candidates, [&](const Candidate& c) { return c.low > sure_by; });
  for (const Candidate& candidate : result.candidates)
    result.sure = result.sure && candidate.sure;
  return result;
}

} // namespace masu::oracle
