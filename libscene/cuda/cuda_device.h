// Whether there is a CUDA device.
#pragma once

#include <string>

namespace masu {

// Whether this program was built for CUDA and there is a device to run on; if not, `why`.
bool cuda_available(std::string& why);

} // namespace masu
