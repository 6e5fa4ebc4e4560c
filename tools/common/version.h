// Which program this is.
#pragma once

#include <string>

namespace masu {

extern const char* const version;
extern const char* const commit; // of the source, as configured; empty where it came without git

// "Masu 0.1.0 (commit 0123456789ab)"
std::string program_name();

} // namespace masu
