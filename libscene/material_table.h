// A scene's distinct materials.
#pragma once

#include "libscene/scene.h"

#include <xxhash.h>

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace masu {

struct MaterialHash {
  std::size_t operator()(const Material& material) const { return XXH3_64bits(&material, sizeof material); }
};

// Distinct materials in the order of their first use.
struct MaterialTable {
  std::vector<Material> materials;
  std::unordered_map<Material, std::uint32_t, MaterialHash> indices;

  std::uint32_t index_of(const Material& material) {
    const auto [found, is_new] = indices.try_emplace(material, static_cast<std::uint32_t>(materials.size()));
    if (is_new) materials.push_back(material);
    return found->second;
  }
};

} // namespace masu
