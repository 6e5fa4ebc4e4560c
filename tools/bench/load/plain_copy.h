// Plain copies: of a file's bytes to the memory that tracing reads, the reference for loading; and between
// host memory and a device and back, the reference for lists of rays.
#pragma once

#include <cstddef>
#include <memory>
#include <string>

namespace masu {

// How the bytes are read from the page cache: from a mapping, or by read(2).
enum class CopyFrom { mapping, reading };

// Seconds from opening the file until its last byte is in newly allocated memory, allocation included. Throws
// Error(input).
double copy_seconds_cpu(const std::string& path, CopyFrom from);
// The same, into the memory of the first CUDA device. read(2) uses a small page-locked buffer, which is
// allocated before the time starts. Throws Error(input) and Error(device).
double copy_seconds_cuda(const std::string& path, CopyFrom from);

// Page-locked host memory for CUDA devices. Throws Error(device).
std::shared_ptr<void> host_memory_cuda(std::size_t bytes);

// Seconds of copying `up_bytes` to a CUDA device while `down_bytes` come back, both in as many
// pieces, at the same time: what comes up and what goes down are independent of each other. Memory that isn't
// page-locked goes through small page-locked buffers, filled and emptied by all cores. Throws Error(device).
double round_trip_seconds_cuda(const void* up, std::size_t up_bytes, void* down, std::size_t down_bytes,
                               int pieces, bool page_locked, int gpu = 0);

} // namespace masu
