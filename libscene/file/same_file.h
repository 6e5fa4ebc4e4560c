// Whether two paths lead to one file.
#pragma once

#include <string>

namespace masu {

// By links and other spellings too; also where there is no file yet, but writing to both would make one.
// Devices and pipes aren't files here: they may be named twice. Throws Error(output) for circles of links.
bool is_same_file(const std::string& a, const std::string& b);

} // namespace masu
