// Looks for a CUDA device.
#pragma once

#include <string>

namespace masu {

// Whether the program was built with CUDA and there is a device; if not, sets `why`.
bool cuda_available(std::string& why);

bool built_with_cuda();

// Of the device in use, where there is one: "NVIDIA H100".
std::string cuda_device_name();

} // namespace masu
