#include "libscene/mesh/import/assimp_scene.h"

#include "libscene/automatic_camera.h"
#include "libscene/mesh/files/file_material.h"

#include <assimp/GltfMaterial.h>
#include <assimp/commonMetaData.h>
#include <assimp/material.h>
#include <assimp/version.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string_view>

namespace masu::import {
namespace {

// --- Materials -------------------------------------------------------------------------------------------

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
  return phong_material({.color = color(m, AI_MATKEY_COLOR_DIFFUSE).value_or(Vec3f{1, 1, 1}),
                         .mirror = clamped(number(m, AI_MATKEY_REFLECTIVITY).value_or(0), 0, 1) *
                                   mean(color(m, AI_MATKEY_COLOR_REFLECTIVE).value_or(specular)),
                         .shine = number(m, AI_MATKEY_SHININESS).value_or(0),
                         .opacity = opacity(m),
                         .refraction_index = number(m, AI_MATKEY_REFRACTI).value_or(1)});
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

// --- Camera and lights -----------------------------------------------------------------------------------

constexpr double degrees = 180 / std::numbers::pi;
constexpr std::int32_t default_height = 512, max_pixels = 65536;

// From the named node's coordinates to the scene's.
Transform transform_of(const aiScene& file, const aiString& name) {
  const aiNode* node = file.mRootNode->FindNode(name);
  if (node == nullptr) return {};
  Transform transform = import::transform_of(node->mTransformation);
  while ((node = node->mParent) != nullptr)
    transform = import::transform_of(node->mTransformation) * transform;
  return transform;
}

// The vertical angle in degrees of a camera with that aspect ratio (width / height).
double vertical_angle(const aiScene& file, const aiCamera& camera, double aspect) {
  const double horizontal = camera.mHorizontalFOV;
  const unsigned version = 100 * aiGetVersionMajor() + aiGetVersionMinor();
  // glTF gives the vertical angle. Assimp before 5.3 multiplied it by the aspect ratio (1 if not given).
  if (is_format(file, "glTF") && camera.mAspect <= 0) return horizontal * degrees;
  if (is_format(file, "glTF") && version < 503) return horizontal / aspect * degrees;
  return 2 * std::atan(std::tan(horizontal / 2) / aspect) * degrees;
}

std::int32_t pixels(double number) {
  return static_cast<std::int32_t>(std::clamp(std::round(number), 1.0, static_cast<double>(max_pixels)));
}

std::optional<Camera> imported_camera(const aiScene& file, const aiCamera& source,
                                      const ImportOptions& options, const Sphere<double>& whole) {
  if (!(source.mHorizontalFOV > 0 && source.mHorizontalFOV < std::numbers::pi)) return {};
  const Transform transform = transform_of(file, source.mName);
  // A glTF camera is at its node's origin; some versions of Assimp add the node's translation here.
  const Vec3d position = is_format(file, "glTF") ? Vec3d{0, 0, 0} : vector_of(source.mPosition);
  const auto forward = unit(transformed_direction(transform, vector_of(source.mLookAt)));
  const auto up = unit(transformed_direction(transform, vector_of(source.mUp)));
  Camera camera{};
  camera.from = transformed_point(transform, position);
  if (!forward || !up || !is_coordinate(camera.from) || largest_magnitude(cross(*up, *forward)) < 1e-6)
    return {};
  camera.at = camera.from + *forward * whole.radius;
  if (!is_coordinate(camera.at) || camera.at == camera.from) return {};
  camera.up = *up;
  camera.hither = source.mClipPlaneNear >= 0 ? source.mClipPlaneNear : 0.01;
  const bool has_aspect = source.mAspect > 1e-3F && source.mAspect < 1e3F;
  camera.height = options.height > 0 ? options.height : default_height;
  camera.width =
      options.width > 0 ? options.width : pixels(default_height * (has_aspect ? source.mAspect : 1));
  const double aspect = has_aspect ? source.mAspect : static_cast<double>(camera.width) / camera.height;
  camera.angle = vertical_angle(file, source, aspect);
  if (!(camera.angle > 0 && camera.angle < 180)) return {};
  return camera;
}

std::optional<Light<double>> imported_light(const aiScene& file, const aiLight& source,
                                            const Sphere<double>& whole) {
  const Transform transform = transform_of(file, source.mName);
  Light<double> light{};
  const aiColor3D& color = source.mColorDiffuse;
  light.intensity = {color.r, color.g, color.b};
  if (!is_coordinate(light.intensity)) return {};
  switch (source.mType) {
  case aiLightSource_POINT:
  case aiLightSource_SPOT:
  case aiLightSource_AREA:
    light.position = transformed_point(transform, vector_of(source.mPosition));
    break;
  case aiLightSource_DIRECTIONAL: {
    const auto towards = unit(transformed_direction(transform, vector_of(source.mDirection)));
    if (!towards) return {};
    light.position = whole.center - *towards * (100 * whole.radius);
    break;
  }
  default:
    return {};
  }
  if (!is_coordinate(light.position)) return {};
  return light;
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

bool is_format(const aiScene& file, const char* format) {
  aiString name;
  return file.mMetaData != nullptr && file.mMetaData->Get(AI_METADATA_SOURCE_FORMAT, name) &&
         std::string_view(name.C_Str()).find(format) != std::string_view::npos;
}

void import_view(const aiScene& file, const ImportOptions& options, ImportedScene& result) {
  Scene& scene = result.scene;
  const Sphere<double> whole = bounding_sphere(scene);
  if (file.mNumCameras > 0) {
    if (const auto camera = imported_camera(file, *file.mCameras[0], options, whole)) {
      scene.camera = *camera;
      scene.has_camera = true;
    }
  }
  result.notes.omitted_cameras = file.mNumCameras - (scene.has_camera ? 1U : 0U);

  for (unsigned i = 0; i < file.mNumLights; ++i) {
    if (const auto light = imported_light(file, *file.mLights[i], whole))
      scene.lights.push_back(*light);
    else
      ++result.notes.omitted_lights;
  }
  complete_view(whole, options, result);
}

} // namespace masu::import
