// Copying a file's bytes to where they would be traced, and nothing else: what loading is compared with.
#pragma once

#include <string>

namespace masu {

// How the bytes come out of the page cache: from a mapping, or by read(2).
enum class CopyFrom { mapping, reading };

// Seconds from opening the file to its last byte being in fresh memory, whose allocation counts too. Throw
// Error(input); the second also Error(device).
double copy_seconds_cpu(const std::string& path, CopyFrom from);
// Into the first CUDA device's memory. What is read goes through a small page-locked buffer, made before the
// time starts.
double copy_seconds_cuda(const std::string& path, CopyFrom from);

} // namespace masu
