// Looks for a CUDA device.
#pragma once

#include <cstddef>
#include <string>

namespace masu {

// Whether the program was built with CUDA and there is a device; if not, sets `why`.
bool cuda_available(std::string& why);

bool built_with_cuda();

// Devices that there are; 0 without CUDA.
int cuda_device_count();

// The device in whose memory a pointer's target lies (managed memory counts), or host_memory.
inline constexpr int host_memory = -1;
int device_of(const void* pointer);

// Waits for what is queued on a device's stream, a cudaStream_t. Throws Error(device).
void wait_for_stream(void* stream, int device);

// Once what was queued on the device's legacy stream is done. Throws Error(device).
void copy_to_host(void* to, const void* from, std::size_t bytes, int device);

// Of the device in use, where there is one: "NVIDIA H100".
std::string cuda_device_name();

} // namespace masu
