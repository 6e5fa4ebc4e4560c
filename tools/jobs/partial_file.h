// Files that several processes, or several runs, make in parts: OUT.partial beside OUT, until it is whole.
#pragma once

#include "tools/jobs/placed_file.h"

#include <optional>
#include <string>
#include <vector>

namespace masu {

// The name beside a file to be, links followed. Throws Error(usage) where that is anything but a regular
// file.
std::string partial_name(const std::string& path);

// A range of a file, and its hash. Without an offset: the whole file.
struct FileRange {
  std::string path;
  std::optional<std::uint64_t> offset{};
  std::uint64_t becomes = 0; // of OUT.partial that is renamed to OUT: OUT's bytes then
  std::uint64_t bytes = 0;
  std::string hash{};
};

// Creates the file where it isn't there, and writes a part; processes may do so at the same time. Throws
// Error(output).
FileRange write_part(const std::string& path, const FilePart& part);
// Of a file that is there. Throws Error(output).
FileRange whole_file(const std::string& path);
// Whether the file has that range with that hash. Of OUT.partial that isn't there any more, OUT itself.
bool is_whole(const FileRange& range);

// Gives a partial file of so many bytes its name, with the permissions of a file that it replaces. One that
// has it already is left. Throws Error(output).
void finish_partial(const std::string& path, std::uint64_t bytes);

// Parts whose sizes aren't known before they are made have slots, each with more room than they need, and
// from there are copied one after the other. A slot begins with the part's size.
inline constexpr std::uint64_t slot_head = sizeof(std::uint64_t);
FilePart in_slot(FilePart part);
// The part in a slot that ends before `end`. Throws Error(output).
std::vector<std::uint8_t> read_slot(const std::string& path, std::uint64_t offset, std::uint64_t end);

} // namespace masu
