// The header of a PLY file, on whose errors some versions of Assimp never end; of triangle strips they keep
// the last triangle alone.
#pragma once

#include <string>
#include <string_view>

namespace masu::import {

// Throws Error(input, name, …) for a PLY file whose header has a malformed line of an element or property,
// announces triangle strips, or doesn't end. Files of other formats pass.
void check_ply_header(std::string_view file, const std::string& name);

} // namespace masu::import
