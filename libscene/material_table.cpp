#include "libscene/material_table.h"

#include <bit>

namespace masu {

std::size_t MaterialHash::operator()(const Material& m) const {
  std::size_t hash = 0;
  for (const float part :
       {m.color.x, m.color.y, m.color.z, m.diffuse, m.specular, m.shine, m.transmittance, m.refraction_index})
    hash = (hash ^ std::bit_cast<std::uint32_t>(part)) * 0x9e3779b97f4a7c15ULL + (hash >> 32);
  return hash;
}

bool MaterialEqual::operator()(const Material& a, const Material& b) const {
  return a.color == b.color && a.diffuse == b.diffuse && a.specular == b.specular && a.shine == b.shine &&
         a.transmittance == b.transmittance && a.refraction_index == b.refraction_index;
}

std::uint32_t MaterialTable::index_of(const Material& material) {
  const auto [found, is_new] = indices.try_emplace(material, static_cast<std::uint32_t>(materials.size()));
  if (is_new) materials.push_back(material);
  return found->second;
}

} // namespace masu
