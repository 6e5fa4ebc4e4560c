// A scene's distinct materials.
#pragma once

#include "libscene/scene.h"

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace masu {

struct MaterialHash {
  std::size_t operator()(const Material& m) const;
};
struct MaterialEqual {
  bool operator()(const Material& a, const Material& b) const;
};

// Distinct materials in the order of their first use.
struct MaterialTable {
  std::vector<Material> materials;
  std::unordered_map<Material, std::uint32_t, MaterialHash, MaterialEqual> indices;

  std::uint32_t index_of(const Material& material);
};

} // namespace masu
