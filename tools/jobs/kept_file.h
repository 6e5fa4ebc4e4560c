// --resume: which files that are there are kept. Outputs appear whole, so what is there is finished.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace masu {

// described: pictures whose own texts say that they are what would be made.
enum class Resume { off, described, all };

// What a file that is there must be like to be kept.
struct KnownBy {
  std::string text{};                   // at its beginning, or near it
  std::optional<std::uint64_t> bytes{}; // its size
};

// Whether a regular file that can be read is there and is like that.
bool is_kept(const std::string& path, const KnownBy& known_by);

} // namespace masu
