// Looks for a CUDA device.
#pragma once

#include <string>

namespace masu {

// Whether the program was built with CUDA and there is a device; if not, sets `why`.
bool cuda_available(std::string& why);

} // namespace masu
