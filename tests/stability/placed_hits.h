// Hits of placed meshes, beside their vertices written out; behind a header, for the library's names and
// those of its parts are the same.
#pragma once

#include <array>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace masu::stability {

struct PlacedHits {
  struct Hits {
    std::vector<double> t;
    std::vector<std::uint32_t> primitive; // of the file
  };
  std::vector<std::array<double, 6>> rays; // origins, relative to the file's, and directions
  Hits robust, double_precision;           // robust: not of a store in float64
};

std::size_t placed_kind_count(); // near, tiny, far, stretched, mirrored, … (tests/api/placed_scene.h)

// Of so many rays through a random scene, whose vertices are written to a scene file.
PlacedHits placed_hits(std::size_t kind, std::mt19937_64& engine, std::size_t rays, const std::string& file);

} // namespace masu::stability
