// The parser of Eric Haines' Neutral File Format: v b l f c s p pp #, with any white space and line breaks.
#pragma once

#include "libscene/scene.h"

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

namespace masu {

struct NffOptions {
  // The text is parsed in parallel in pieces of about this many bytes; each starts with an entity at the
  // start of a line. The scene doesn't depend on it.
  std::size_t piece_bytes = std::size_t{1} << 20;
  std::function<void(double)> progress{}; // gets the share of the text that is parsed, where it is known
  std::uint64_t max_primitives = masu::max_primitives;
};

// Parses `text`; `name` is its name in errors. Throws Error(input, "name:line:column", …) for an unknown
// entity, a missing or malformed number, NaN or infinity, a coordinate beyond 1e100 (beyond 1e12 it needs
// float64), a polygon of fewer than three vertices or more than the rest of the text can contain, a negative
// Kd, Ks, shine or T, cone radii of opposite signs, a normal of length 0, and a view without direction;
// Error(input, "name", …) for a text without any entity, for more than 2^31-1 objects or as many
// primitives, and for a scene that takes more memory than there is. Numbers are doubles; no coordinate is
// rounded to float.
//
// A `v` may give from, at, up, angle, hither, resolution in any order, or only some of them. The last `v` and
// the last `b` apply. Defaults: b black; f white and diffuse; l one light at the camera; v a view of the
// whole scene along (-1, 2, -1.2), up +z, 45°, hither 0.01, 512×512. Materials that no primitive uses are
// dropped, equal ones merged.
Scene parse_nff(std::string_view text, const std::string& name, const NffOptions& options = {});

// The same from a file; - is standard input, and pipes are read too. The text is parsed while it is read:
// only a few pieces of it are in memory.
Scene read_nff(const std::string& path, const NffOptions& options = {});

} // namespace masu
