#include "stability/oracle/closest_hit.h"

#include <algorithm>
#include <map>

namespace masu::oracle {
namespace {

// Relative; far above the rounding errors of double in the bounding sphere test.
constexpr double generous = 1e-9;

constexpr std::size_t block_size = 32;

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
  add_blocks();
}
template SceneOracle::SceneOracle(const SceneView<float>&);
template SceneOracle::SceneOracle(const SceneView<double>&);

void SceneOracle::add_bounding_sphere(const Vec3d& center, double radius) {
  spheres_around_.x.push_back(center.x);
  spheres_around_.y.push_back(center.y);
  spheres_around_.z.push_back(center.z);
  spheres_around_.radius.push_back(radius * (1 + generous) + largest_magnitude(center) * 1e-14);
}

// Spheres near each other share a block: their centres are sorted by Morton code.
void SceneOracle::add_blocks() {
  const auto& [x, y, z, radius] = spheres_around_;
  const auto center = [&](std::size_t i) { return Vec3d{x[i], y[i], z[i]}; };
  Boxd bounds = empty_box<double>();
  for (std::size_t i = 0; i < x.size(); ++i)
    bounds = join(bounds, center(i));
  const double per_unit =
      1023 / largest_magnitude(bounds.max - bounds.min); // anything but finite: all are at 0
  const auto code = [&](std::size_t i) {
    std::uint32_t bits = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double at = (center(i)[axis] - bounds.min[axis]) * per_unit;
      const std::uint32_t step = at > 0 && at < 1024 ? static_cast<std::uint32_t>(at) : 0;
      for (int bit = 0; bit < 10; ++bit)
        bits |= (step >> bit & 1) << (3 * bit + axis);
    }
    return bits;
  };
  std::vector<std::uint32_t> codes;
  for (std::size_t i = 0; i < x.size(); ++i) {
    codes.push_back(code(i));
    in_blocks_.push_back(static_cast<PrimitiveIndex>(i));
  }
  std::ranges::stable_sort(in_blocks_, {}, [&](PrimitiveIndex i) { return codes[i]; });
  for (std::size_t first = 0; first < x.size(); first += block_size) {
    const auto block = block_of(first / block_size);
    Vec3d middle{0, 0, 0};
    for (const PrimitiveIndex i : block)
      middle = middle + center(i) * (1 / static_cast<double>(block.size()));
    double reach = 0;
    for (const PrimitiveIndex i : block)
      reach = std::max(reach, length(center(i) - middle) + radius[i]);
    blocks_.x.push_back(middle.x);
    blocks_.y.push_back(middle.y);
    blocks_.z.push_back(middle.z);
    blocks_.radius.push_back(reach * (1 + generous) + largest_magnitude(middle) * 1e-14);
  }
}

std::span<const PrimitiveIndex> SceneOracle::block_of(std::size_t block) const {
  const std::size_t first = block * block_size;
  return std::span(in_blocks_).subspan(first, std::min(block_size, in_blocks_.size() - first));
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
  // Calls act(along, reach): where the ray passes sphere i, and how far from there it may be inside it.
  const auto if_met = [&](const BoundingSpheres& spheres, std::size_t i, const auto& act) {
    const double x = spheres.x[i] - o.x, y = spheres.y[i] - o.y, z = spheres.z[i] - o.z;
    const double along = x * unit.x + y * unit.y + z * unit.z;
    const double off_x = x - along * unit.x, off_y = y - along * unit.y, off_z = z - along * unit.z;
    const double off = off_x * off_x + off_y * off_y + off_z * off_z;
    const double reach = (spheres.radius[i] + 2 * slack + generous * std::abs(along)) * (1 + generous);
    if (off <= reach * reach && along + reach + generous * std::abs(along) >= 0) act(along, reach);
  };
  const double to_t = 1 / distance_of_t / size;
  std::vector<Near> found;
  for (std::size_t block = 0; block < blocks_.x.size(); ++block) {
    if_met(blocks_, block, [&](double, double) {
      for (const PrimitiveIndex i : block_of(block)) {
        if_met(spheres_around_, i, [&](double along, double reach) {
          const double half = reach + generous * std::abs(along);
          found.push_back({i, (along - half) * to_t, (along + half) * to_t});
        });
      }
    });
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
