// What a glTF file can't be read without.
#pragma once

#include <string>
#include <string_view>

namespace masu::import {

// Throws Error(input, name, …) for a glTF 2.0 file, as text or binary, that requires an extension which isn't
// understood, as the specification (3.12) demands; Assimp reads on, and gets another shape. Files of other
// formats pass, and invalid ones.
void check_gltf_extensions(std::string_view file, const std::string& name);

} // namespace masu::import
