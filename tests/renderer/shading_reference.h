// A reference implementation of the shading formula, in double:
//   I = Ia Kd C + Σ visible Il (Kd C (N·L) + Ks max(0, R·V)^n)
#pragma once

#include "libscene/scene.h"

#include <algorithm>
#include <cmath>

namespace masu {

// `outwards` and `to_viewer` are unit vectors; all lights are visible.
inline Vec3d direct_light_of(const Scene& scene, const Material& material, const Vec3d& point,
                             const Vec3d& outwards, const Vec3d& to_viewer) {
  const Vec3d normal = dot(outwards, to_viewer) >= 0 ? outwards : -outwards;
  const Vec3d diffuse = cast<double>(material.color) * static_cast<double>(material.diffuse);
  Vec3d sum = diffuse * static_cast<double>(scene.ambient);
  for (const Light<double>& light : scene.lights) {
    const Vec3d l = normalized(light.position - point);
    const double cosine = dot(normal, l);
    if (cosine <= 0) continue;
    const Vec3d r = normal * (2 * cosine) - l;
    const double highlight = static_cast<double>(material.specular) *
                             std::pow(std::max(0.0, dot(r, to_viewer)), static_cast<double>(material.shine));
    sum = sum + light.intensity * (diffuse * cosine + Vec3d{highlight, highlight, highlight});
  }
  return sum;
}

} // namespace masu
