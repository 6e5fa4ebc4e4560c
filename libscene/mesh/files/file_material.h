// Materials as files have them, as those of NFF: colour, Kd, Ks, shine, T and index of refraction. All
// numbers become finite and stay in the range of NFF's.
#pragma once

#include "libscene/scene.h"

#include <algorithm>

namespace masu {

// NaN becomes min.
inline float clamped(float value, float min, float max) {
  return value > min ? std::min(value, max) : min;
}
inline float mean(const Vec3f& color) {
  return (color.x + color.y + color.z) / 3;
}

// The colour is the diffuse one, T is 1 - opacity, Kd 1 - T. In NFF's model Ks is both highlight and mirror:
// so `mirror` is that of surfaces which the file says to mirror, else 0.
struct PhongSurface {
  Vec3f color{1, 1, 1};
  float mirror = 0, shine = 0, opacity = 1, refraction_index = 1;
};
Material phong_material(const PhongSurface& surface);

// Of metalness m and roughness r: with the gloss g = 1 - r, Ks = g (0.04 + 0.96 m) and Kd = (1 - T)(1 - m g),
// so that a smooth metal is a mirror and a rough one is matte. The exponent is that of a Phong lobe as wide
// as the microfacets' of alpha = r².
Material metallic_material(const Vec3f& color, float metalness, float roughness, float transmittance,
                           float refraction_index);

} // namespace masu
