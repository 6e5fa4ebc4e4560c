#include "libscene/mesh/import/import_material.h"

#include "libscene/mesh/files/file_material.h"

#include <assimp/GltfMaterial.h>
#include <assimp/material.h>

#include <algorithm>
#include <optional>
#include <string_view>

namespace masu::import {
namespace {

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

float opacity(const aiMaterial& m) {
  return clamped(number(m, AI_MATKEY_OPACITY).value_or(1), 0, 1);
}

Material phong(const aiMaterial& m) {
  const Vec3f specular = color(m, AI_MATKEY_COLOR_SPECULAR).value_or(Vec3f{0, 0, 0});
  PhongSurface surface;
  surface.color = color(m, AI_MATKEY_COLOR_DIFFUSE).value_or(Vec3f{1, 1, 1});
  surface.mirror = clamped(number(m, AI_MATKEY_REFLECTIVITY).value_or(0), 0, 1) *
                   mean(color(m, AI_MATKEY_COLOR_REFLECTIVE).value_or(specular));
  surface.shine = number(m, AI_MATKEY_SHININESS).value_or(0);
  surface.opacity = opacity(m);
  surface.refraction_index = number(m, AI_MATKEY_REFRACTI).value_or(1);
  return phong_material(surface);
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
  const bool refracts = number(m, AI_MATKEY_TRANSMISSION_FACTOR).value_or(0) > 0;
  const float index = number(m, AI_MATKEY_REFRACTI).value_or(1.5F);
  return metallic_material(
      color(m, AI_MATKEY_BASE_COLOR).value_or(color(m, AI_MATKEY_COLOR_DIFFUSE).value_or(Vec3f{1, 1, 1})),
      metalness, roughness, transmittance(m, metalness),
      !refracts                   ? 1
      : index >= 1 && index <= 10 ? index
                                  : 1.5F);
}

} // namespace

bool has_textures(const aiMaterial& m) {
  for (int type = aiTextureType_DIFFUSE; type <= AI_TEXTURE_TYPE_MAX; ++type)
    if (m.GetTextureCount(static_cast<aiTextureType>(type)) > 0) return true;
  return false;
}

FileMaterial imported_material(const aiMaterial& m) {
  const auto metalness = number(m, AI_MATKEY_METALLIC_FACTOR),
             roughness = number(m, AI_MATKEY_ROUGHNESS_FACTOR);
  const bool is_metallic = metalness || roughness;
  return {is_metallic ? metallic(m, clamped(metalness.value_or(0), 0, 1), roughness.value_or(1)) : phong(m),
          is_metallic};
}

} // namespace masu::import
