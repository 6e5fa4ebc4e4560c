// Pixels that are followed side by side through a hierarchy: of each a ray at a time, and of what these hit
// the shadow rays, as lists (packet.h), which take less time than one ray after another. Each pixel sees what
// radiance() has it see, to the bit. Host only, with AVX2 and FMA.
#pragma once

#include "renderer/cpu/packet_lists.h"
#include "renderer/render_pixel.h"

#include <numeric>
#include <vector>

namespace masu {

// M: a Method by watertight tests.
template <class M, class Stored>
class PixelLists {
public:
  using Real = typename M::Real;

  PixelLists(const SceneView<Stored>& scene, const Lighting<Stored>& lighting,
             const HierarchyView<Real>& hierarchy, const RenderRules& rules)
      : scene_(scene), lighting_(lighting), hierarchy_(hierarchy), rules_(rules) {}

  struct Pixel {
    RayTree<Real> tree;
    NearHit<WatertightRay<Real>> hit{}; // of the tree's ray
    Arrival<Real> at{};                 // where it hits anything
    HitRecord first_hit{};

    explicit Pixel(const Ray<Real>& camera_ray) : tree(camera_ray) {}
  };
  std::vector<Pixel> pixels; // neighbours should be neighbours in the picture

  // Until all light has come back.
  void follow_all() {
    std::vector<std::size_t> going(pixels.size());
    std::iota(going.begin(), going.end(), std::size_t{0});
    NoCounts counts;
    while (!going.empty()) {
      trace_nearest(going);
      trace_shadow_rays(going);
      std::size_t shadow_ray = 0, left = 0;
      const auto occluded = [&](const Ray<Real>&) { return dark_[shadow_ray++] != 0; };
      for (const std::size_t i : going) {
        Pixel& pixel = pixels[i];
        const auto arrive = [&]() -> const Arrival<Real>& { return pixel.at; };
        if (follow(scene_, lighting_, rules_, pixel.hit, pixel.tree, pixel.first_hit, arrive, occluded,
                   counts))
          going[left++] = i;
      }
      going.resize(left);
    }
  }

private:
  void trace_nearest(const std::vector<std::size_t>& going) {
    rays_.clear();
    for (const std::size_t i : going)
      rays_.push_back(unbounded_ray(pixels[i].tree.ray.origin, pixels[i].tree.ray.direction));
    trace<Query::nearest_hit>([&](std::size_t k, const ListedHit<Real>& found) {
      NearHit<WatertightRay<Real>>& hit = pixels[going[k]].hit;
      hit.hit = no_hit<Real>();
      if (found.near.primitive == no_primitive) return;
      ClippedRay<Real> near{};
      clip(rays_[k], cast<Real>(scene_.clip), near);
      prepare(hit.ray, near.ray.origin, near.ray.direction);
      hit.hit = {found.near.t * found.scale, found.near.primitive};
      hit.skipped = near.skipped;
    });
    NoCounts counts;
    for (std::size_t k = 0; k < going.size(); ++k) // no list has those hit anything
      if (!is_valid(rays_[k]))
        pixels[going[k]].hit = nearest_hit_near<M>(scene_, hierarchy_, rays_[k], counts);
  }

  void trace_shadow_rays(const std::vector<std::size_t>& going) {
    rays_.clear();
    if (rules_.depth == 0) return;
    NoCounts counts;
    const auto add = [&](const Ray<Real>& ray) {
      rays_.push_back(ray);
      return true;
    };
    for (const std::size_t i : going) {
      Pixel& pixel = pixels[i];
      if (pixel.hit.hit.primitive == no_primitive) continue;
      const Vec3<Real>& direction = pixel.tree.ray.direction;
      pixel.at = arrival<M>(scene_, rules_, pixel.hit, direction);
      direct_light(scene_, lighting_, pixel.at, direction, add, counts);
    }
    dark_.assign(rays_.size(), 0);
    trace<Query::occlusion>([&](std::size_t k, const ListedHit<Real>& found) {
      dark_[k] = found.near.primitive != no_primitive;
    });
    for (std::size_t k = 0; k < dark_.size(); ++k)
      if (!is_valid(rays_[k])) dark_[k] = is_occluded<M>(scene_, hierarchy_, rays_[k], counts);
  }

  // Calls found(k, hit) for each of rays_, and adds to them what fills up the last lanes.
  template <Query query, class Found>
  void trace(const Found& found) {
    const std::size_t count = rays_.size();
    rays_.resize((count + RayLanes<Real>::count - 1) / RayLanes<Real>::count *
                 RayLanes<Real>::count); // not valid
    trace_list<query, M>(scene_, hierarchy_, rays_.data(), own_format<Real>, 0, rays_.size(),
                         [&](std::size_t k, const ListedHit<Real>& hit) {
                           if (k < count) found(k, hit);
                         });
    rays_.resize(count);
  }

  const SceneView<Stored>& scene_;
  const Lighting<Stored>& lighting_;
  const HierarchyView<Real>& hierarchy_;
  const RenderRules& rules_;
  std::vector<Ray<Real>> rays_;
  std::vector<std::uint8_t> dark_; // of the shadow rays
};

} // namespace masu
