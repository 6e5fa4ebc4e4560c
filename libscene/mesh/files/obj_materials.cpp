#include "libscene/mesh/files/obj_materials.h"

#include "libscene/mesh/files/text_lines.h"

namespace masu {
namespace {

bool is_texture(std::string_view word) {
  return word.starts_with("map_") || word == "bump" || word == "disp" || word == "refl" || word == "norm";
}

// One number or three; false for a spectrum, or CIE's XYZ.
bool read_color(TextLines& lines, Vec3f& color) {
  if (lines.is_at_end() || lines.peek() == "spectral" || lines.peek() == "xyz") return false;
  const auto component = [&] { return static_cast<float>(lines.number("a component of a colour")); };
  color.x = component();
  color.y = lines.is_at_end() ? color.x : component();
  color.z = lines.is_at_end() ? color.x : component();
  return true;
}

} // namespace

Material ObjMaterials::Description::material() const {
  if (metalness || roughness)
    return metallic_material(surface.color, metalness.value_or(0), roughness.value_or(1),
                             1 - clamped(surface.opacity, 0, 1), 1);
  PhongSurface phong = surface;
  if (illumination >= 3 && illumination <= 9)
    phong.mirror = mean({clamped(specular.x, 0, 1), clamped(specular.y, 0, 1), clamped(specular.z, 0, 1)});
  return phong_material(phong);
}

std::uint32_t ObjMaterials::number_of(const std::string& name) {
  const auto [found, is_new] = numbers_.try_emplace(name, static_cast<std::uint32_t>(descriptions_.size()));
  if (is_new) descriptions_.emplace_back();
  return found->second;
}

void ObjMaterials::read(std::string_view text, const std::string& name) {
  TextLines lines(text, name, '#');
  lines.quote_nothing();
  Description* material = nullptr;
  const auto number = [&] { return static_cast<float>(lines.number("a number")); };
  while (lines.next()) {
    const std::string_view word = lines.word();
    if (word == "newmtl") material = &descriptions_[number_of(std::string(lines.rest()))];
    if (material == nullptr) continue;
    if (word == "Kd") {
      read_color(lines, material->surface.color);
    } else if (word == "Ks") {
      read_color(lines, material->specular);
    } else if (word == "Ns") {
      material->surface.shine = number();
    } else if (word == "Ni") {
      material->surface.refraction_index = number();
    } else if (word == "d") {
      if (lines.peek() == "-halo") lines.word();
      material->surface.opacity = number();
    } else if (word == "Tr") {
      material->surface.opacity = 1 - number();
    } else if (word == "illum") {
      material->illumination = lines.whole("a number from 0 to 10");
    } else if (word == "Pm") {
      material->metalness = number();
    } else if (word == "Pr") {
      material->roughness = number();
    } else if (is_texture(word)) {
      material->has_textures = true;
    }
  }
}

std::vector<FileMaterial> ObjMaterials::all(ImportNotes& notes) const {
  std::vector<FileMaterial> materials;
  for (const Description& description : descriptions_) {
    materials.push_back({description.material()});
    if (description.has_textures) ++notes.textured_materials;
  }
  return materials;
}

} // namespace masu
