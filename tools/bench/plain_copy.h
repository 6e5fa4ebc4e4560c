// Plain copies of a file's bytes to the memory that tracing reads: the reference for loading.
#pragma once

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

} // namespace masu
