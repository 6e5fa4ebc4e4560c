// Files that several processes, or several runs, make in parts: OUT.partial beside OUT, until it is whole.
#pragma once

#include "tools/jobs/parted_file.h"

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

// Of a file that is there. Throws Error(output).
FileRange whole_file(const std::string& path);
// Whether the file has that range with that hash. Of OUT.partial that isn't there any more, OUT itself.
bool is_whole(const FileRange& range);

// A slot begins with its part's size.
inline constexpr std::uint64_t slot_head = sizeof(std::uint64_t);

// Where a part of a file will be in its OUT.partial, without bytes and hash yet.
FileRange range_of(const std::string& path, const PartedForm& form, std::uint64_t part);
// Creates OUT.partial where it isn't there, and writes a part; processes may do so at the same time. Throws
// Error(output).
FileRange write_part(const std::string& path, const PartedForm& form, std::uint64_t part,
                     std::vector<std::uint8_t> bytes);
// Makes the file when all parts are there. OUT.partial is renamed, with the permissions of a file that it
// replaces, and one that was renamed already is left; parts that follow each other are copied, and
// OUT.partial stays. Throws Error(output).
void finish_parts(const std::string& path, const PartedForm& form);

} // namespace masu
