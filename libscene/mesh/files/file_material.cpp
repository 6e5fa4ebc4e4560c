#include "libscene/mesh/files/file_material.h"

namespace masu {
namespace {

Vec3f clamped_color(const Vec3f& c) {
  return {clamped(c.x, 0, 1), clamped(c.y, 0, 1), clamped(c.z, 0, 1)};
}

// One that light could have.
float valid_index(float index) {
  return index >= 1 && index <= 10 ? index : 1;
}

constexpr float largest_shine = 1e5F;

} // namespace

Material phong_material(const PhongSurface& surface) {
  Material result{};
  result.color = clamped_color(surface.color);
  result.transmittance = 1 - clamped(surface.opacity, 0, 1);
  result.diffuse = 1 - result.transmittance;
  result.refraction_index = result.transmittance > 0 ? valid_index(surface.refraction_index) : 1;
  result.shine = clamped(surface.shine, 0, largest_shine);
  result.specular = clamped(surface.mirror, 0, 1);
  return result;
}

Material metallic_material(const Vec3f& color, float metalness, float roughness, float transmittance,
                           float refraction_index) {
  metalness = clamped(metalness, 0, 1);
  roughness = clamped(roughness, 0, 1);
  const float gloss = 1 - roughness, alpha = roughness * roughness;
  Material result{};
  result.color = clamped_color(color);
  result.transmittance = clamped(transmittance, 0, 1);
  result.diffuse = (1 - result.transmittance) * (1 - metalness * gloss);
  result.specular = gloss * (0.04F + 0.96F * metalness);
  // Blinn's exponent is 2/alpha² - 2, and Phong's for the same width a quarter of it.
  result.shine = clamped((1 / (alpha * alpha) - 1) / 2, 0, largest_shine);
  result.refraction_index = valid_index(refraction_index);
  return result;
}

} // namespace masu
