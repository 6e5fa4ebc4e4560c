// The parser of Eric Haines' Neutral File Format: v b l f c s p pp #, any white space and line breaks.
#pragma once

#include "libscene/scene.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace masu {

struct NffOptions {
  int threads = 0; // 0: every core
  // Text is cut into pieces of about this many bytes, where an entity starts a line. The scene doesn't depend
  // on it.
  std::size_t piece_bytes = std::size_t{1} << 20;
};

// Parses `text`; `name` is what errors call it. Throws Error(input, "name:line:column", …) for an unknown
// entity, a missing or malformed number, NaN or infinity, a coordinate past 1e100 (past 1e12 needs float64),
// fewer than three vertices or more than the text can hold, a negative Kd, Ks, shine or T, cone radii of
// opposite signs, a normal without length, and a view without direction; Error(input, "name", …) for a text
// without any entity, and for more than 2^31-1 objects or 2^32-2 primitives. Numbers are doubles; no
// coordinate is rounded to float here.
//
// A `v` may hold from, at, up, angle, hither, resolution in any order, or lack some. The last `v` and the
// last `b` count. What is missing gets defaults: b black; f white diffuse; l one light at the eye; v a view
// of everything along
// (-1, 2, -1.2), up +z, 45°, hither 0.01, 512×512. Only materials that a primitive uses are kept, each once.
Scene parse_nff(std::string_view text, const std::string& name, const NffOptions& options = {});

// Maps the file and parses it.
Scene read_nff(const std::string& path, const NffOptions& options = {});

} // namespace masu
