// What is given for a scene file and isn't one.
#pragma once

#include <string>

namespace masu {

// Throws Error(input, path, …) for an NFF text or a mesh, by the name's end: with the command that makes a
// scene file of it. Says nothing of other files, nor of those that can't be read or begin as scene files do.
void check_scene_input(const std::string& path);

} // namespace masu
