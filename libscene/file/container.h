// The container of scene and grid files, after Arrow's IPC format: a prelude, a small FlatBuffers table, and
// raw little-endian arrays that are used where they lie.
//
//   byte 0        prelude, 64 bytes (struct Prelude)
//        64       table, FlatBuffers, table_bytes long
//        …        zeros up to body_offset, a multiple of 4096
//   body_offset   sections, each at a multiple of 256 from the body's start, zeros between them
//   the end       body_offset + body_bytes: the file ends here, nothing follows
//
// The content hash covers the prelude (hash field as zeros) and the table; the table holds each section's
// hash; what lies between must be zero: so no byte can change unseen. A section's hash is the hash of its 4
// MiB pieces' hashes, so that cores can share the work.
#pragma once

#include "libscene/file/mapped_file.h"
#include "schemas/section_generated.h"

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace masu {

// A file's 128-bit content hash: what a grid remembers its scene by.
struct Hash {
  std::uint64_t low = 0, high = 0;
  friend bool operator==(const Hash&, const Hash&) = default;
};
std::string to_hex(const Hash& hash);

struct FileKind {
  std::array<char, 8> magic;
  std::uint32_t version; // raised by one whenever old readers would misread new files
  const char* name;      // for messages: "scene", "grid"
};

struct Prelude {
  std::array<char, 8> magic{};
  std::uint32_t version = 0;
  std::uint32_t reserved = 0; // zero
  std::uint64_t table_bytes = 0;
  std::uint64_t body_offset = 0;
  std::uint64_t body_bytes = 0;
  Hash hash;
  std::uint64_t reserved2 = 0; // zero
};
static_assert(sizeof(Prelude) == 64);

// An array to be written.
struct SectionData {
  std::uint32_t kind;
  std::uint32_t record_bytes;
  std::uint64_t count;
  const void* data;
};

template <class T>
SectionData section_data(std::uint32_t kind, std::span<const T> records) {
  return {kind, sizeof(T), records.size(), records.data()};
}

// Where each section goes, and its hash: what the table has to list. Empty sections are left out.
std::vector<fb::Section> lay_out(std::span<const SectionData> sections);

// Writes the file under a temporary name beside `path`, flushes it and renames it, so that a reader sees the
// whole file or the old one. `layout` is lay_out(sections), and `table` a finished FlatBuffer that lists it.
// Returns the content hash. Throws Error(output).
Hash write_container(const std::string& path, const FileKind& kind, std::span<const std::uint8_t> table,
                     std::span<const SectionData> sections, std::span<const fb::Section> layout);

// A verified table can still place its list where no 8-byte number may lie.
inline bool is_aligned(std::span<const fb::Section> sections) {
  return reinterpret_cast<std::uintptr_t>(sections.data()) % alignof(fb::Section) == 0;
}

// What is checked when a file is opened: all of it; or its table, so that its sections can be told apart and
// copied, while check_records() is still to be called before anything in them is followed.
enum class Checks { all, table };

// What opening a file took: mapping it and checking its head; checking all the rest.
struct LoadSeconds {
  double map = 0, validate = 0;
};

// A mapped container whose prelude has been checked. The table is only bytes yet: verify it, then
// check_sections.
class ContainerFile {
public:
  // Throws Error(input, path, …).
  ContainerFile(const std::string& path, const FileKind& kind);

  std::span<const std::uint8_t> table() const {
    return file_.bytes().subspan(sizeof(Prelude), prelude().table_bytes);
  }
  const Hash& hash() const { return prelude().hash; }
  const std::string& path() const { return file_.path(); }
  std::uint64_t bytes() const { return file_.bytes().size(); }

  // Checks order, bounds, alignment, the zeros between, and every hash (in parallel). Throws Error(input).
  void check_sections(std::span<const fb::Section> sections) const;

  // The records of the section of this kind, where they lie; empty when there is none.
  // Throws Error(input) when its record size isn't T's. After check_sections.
  template <class T>
  std::span<const T> records(std::span<const fb::Section> sections, std::uint32_t kind) const {
    const auto bytes = section_bytes(sections, kind, sizeof(T));
    return {reinterpret_cast<const T*>(bytes.data()), bytes.size() / sizeof(T)};
  }

private:
  const Prelude& prelude() const { return *reinterpret_cast<const Prelude*>(file_.bytes().data()); }
  std::span<const std::uint8_t> section_bytes(std::span<const fb::Section> sections, std::uint32_t kind,
                                              std::size_t record_bytes) const;

  MappedFile file_;
};

} // namespace masu
