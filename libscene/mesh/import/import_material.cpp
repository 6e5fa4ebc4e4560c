#include "libscene/mesh/import/import_material.h"

#include <assimp/GltfMaterial.h>
#include <assimp/ObjMaterial.h>
#include <assimp/material.h>

#include <algorithm>
#include <optional>
#include <string_view>

namespace masu::import {
namespace {

// NaN becomes min.
float clamped(float value, float min, float max) {
  return value > min ? std::min(value, max) : min;
}

// A material's property as Assimp's key macros name it: key, type, index.
std::optional<float> number(const aiMaterial& m, const char* key, unsigned type, unsigned index) {
  ai_real value = 0;
  if (m.Get(key, type, index, value) != AI_SUCCESS) return {};
  return value;
}
std::optional<Vec3f> color(const aiMaterial& m, const char* key, unsigned type, unsigned index) {
  aiColor3D c;
  if (m.Get(key, type, index, c) != AI_SUCCESS) return {};
  return Vec3f{clamped(c.r, 0, 1), clamped(c.g, 0, 1), clamped(c.b, 0, 1)};
}

float mean(const Vec3f& color) {
  return (color.x + color.y + color.z) / 3;
}

// The index behind a transmitting surface: `otherwise` where there is none that light could have.
float refraction_index(const aiMaterial& m, float otherwise) {
  const float index = number(m, AI_MATKEY_REFRACTI).value_or(otherwise);
  return index >= 1 && index <= 10 ? index : otherwise;
}

float opacity(const aiMaterial& m) {
  return clamped(number(m, AI_MATKEY_OPACITY).value_or(1), 0, 1);
}

Material phong(const aiMaterial& m) {
  Material result{};
  result.color = color(m, AI_MATKEY_COLOR_DIFFUSE).value_or(Vec3f{1, 1, 1});
  result.transmittance = 1 - opacity(m);
  result.diffuse = 1 - result.transmittance;
  result.refraction_index = result.transmittance > 0 ? refraction_index(m, 1) : 1;
  result.shine = clamped(number(m, AI_MATKEY_SHININESS).value_or(0), 0, 1e5F);
  const Vec3f specular = color(m, AI_MATKEY_COLOR_SPECULAR).value_or(Vec3f{0, 0, 0});
  int model = 0;
  if (m.Get(AI_MATKEY_OBJ_ILLUM, model) == AI_SUCCESS)
    result.specular = model >= 3 && model <= 9 ? mean(specular) : 0;
  else
    result.specular = clamped(number(m, AI_MATKEY_REFLECTIVITY).value_or(0), 0, 1) *
                      mean(color(m, AI_MATKEY_COLOR_REFLECTIVE).value_or(specular));
  return result;
}

float transmittance(const aiMaterial& m, float metalness) {
  aiString mode;
  if (const auto transmission = number(m, AI_MATKEY_TRANSMISSION_FACTOR); transmission && *transmission > 0)
    return clamped(*transmission, 0, 1) * (1 - metalness);
  if (m.Get(AI_MATKEY_GLTF_ALPHAMODE, mode) == AI_SUCCESS && std::string_view(mode.C_Str()) != "BLEND")
    return 0;
  return 1 - opacity(m);
}

Material metallic(const aiMaterial& m, float metalness, float roughness) {
  const float gloss = 1 - roughness;
  const float alpha = roughness * roughness;
  Material result{};
  result.color =
      color(m, AI_MATKEY_BASE_COLOR).value_or(color(m, AI_MATKEY_COLOR_DIFFUSE).value_or(Vec3f{1, 1, 1}));
  result.transmittance = transmittance(m, metalness);
  result.diffuse = (1 - result.transmittance) * (1 - metalness * gloss);
  result.specular = gloss * (0.04F + 0.96F * metalness);
  // Blinn's exponent is 2/alpha² - 2, and Phong's for the same width a quarter of it.
  result.shine = clamped((1 / (alpha * alpha) - 1) / 2, 0, 1e5F);
  const bool refracts = number(m, AI_MATKEY_TRANSMISSION_FACTOR).value_or(0) > 0;
  result.refraction_index = refracts ? refraction_index(m, 1.5F) : 1;
  return result;
}

bool has_textures(const aiMaterial& m) {
  for (int type = aiTextureType_DIFFUSE; type <= AI_TEXTURE_TYPE_MAX; ++type)
    if (m.GetTextureCount(static_cast<aiTextureType>(type)) > 0) return true;
  return false;
}

} // namespace

ImportedMaterial imported_material(const aiMaterial& m) {
  const auto metalness = number(m, AI_MATKEY_METALLIC_FACTOR),
             roughness = number(m, AI_MATKEY_ROUGHNESS_FACTOR);
  const bool is_metallic = metalness || roughness;
  return {is_metallic
              ? metallic(m, clamped(metalness.value_or(0), 0, 1), clamped(roughness.value_or(1), 0, 1))
              : phong(m),
          has_textures(m), is_metallic};
}

} // namespace masu::import
