// The container of scene and grid files, after Arrow's IPC format: a prelude, a small FlatBuffers table, and
// raw little-endian arrays that are used in place.
//
//   byte 0        prelude, 64 bytes (struct Prelude)
//        64       table, FlatBuffers, table_bytes long
//        …        zeros up to body_offset, a multiple of 4096
//   body_offset   sections, each at a multiple of 256 from the body's start, zeros between them
//   the end       body_offset + body_bytes: the file ends here, nothing follows
//
// The content hash covers the prelude (with a hash field of zeros) and the table; the table contains each
// section's hash; all bytes between must be zero: so any changed byte is detected. A section's hash is the
// hash of the hashes of its 4 MiB pieces, which are computed in parallel.
#pragma once

#include "libscene/base/progress_monitor.h"
#include "libscene/base/stopwatch.h"
#include "libscene/file/file_mapping.h"
#include "libscene/file/input_file.h"
#include "libscene/geometry/box.h"
#include "schemas/section_generated.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace masu {

// A 128-bit hash: of a file's content, of a section, of a scene's geometry.
struct Hash {
  std::uint64_t low = 0, high = 0;
  friend bool operator==(const Hash&, const Hash&) = default;
};
std::string to_hex(const Hash& hash);
// XXH3-128.
Hash hash_of(std::span<const std::uint8_t> bytes);

struct FileKind {
  std::array<char, 8> magic;
  std::uint32_t version; // raised by one whenever old readers would misread new files
  const char* name;      // for messages: "scene", "grid"
  const char* remake;    // for messages: what to do about a file of another version
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

// An array to write; or what makes its records when they are hashed, and again when they are written, so that
// no more than some of them are in memory: convert(first, how many, to), which any thread may call.
struct SectionData {
  std::uint32_t kind = 0;
  std::uint32_t record_bytes = 0;
  std::uint64_t count = 0;
  const void* data = nullptr;
  std::function<void(std::uint64_t, std::uint64_t, void*)> convert{};
  bool is_later = false; // in memory: made when it is first needed
};

template <class T>
SectionData section_data(std::uint32_t kind, std::span<const T> records) {
  return {kind, sizeof(T), records.size(), records.data(), {}};
}

// Each record is converted(of one in `records`), which the section keeps.
template <class Records, class Converted>
SectionData converted_section_data(std::uint32_t kind, const std::shared_ptr<const Records>& records,
                                   const Converted& converted) {
  using To = std::decay_t<decltype(converted((*records)[0]))>;
  return {kind, sizeof(To), records->size(), nullptr,
          [records, converted](std::uint64_t first, std::uint64_t count, void* to) {
            for (std::uint64_t i = 0; i != count; ++i)
              static_cast<To*>(to)[i] = converted((*records)[first + i]);
          }};
}

// Each section's offset and hash, as listed in the table. Empty sections are left out.
std::vector<fb::Section> lay_out(std::span<const SectionData> sections);

// Writes the file whole or not at all (output_file.h). `layout` is lay_out(sections), `table` a finished
// FlatBuffer that lists it. Throws Error(output).
void write_container(const std::string& path, const FileKind& kind, std::span<const std::uint8_t> table,
                     std::span<const SectionData> sections, std::span<const fb::Section> layout);

// The bytes of a container that is made in memory. One section may be made later: its bytes aren't written,
// and its hash is zero in the table.
struct ContainerMemory {
  HostBytes head; // prelude and table, up to the body's offset
  HostBytes body;
  std::optional<SectionData> later{}; // `data`: where its bytes go
};
// `table` makes the finished FlatBuffer that lists the sections. What the progress throws ends it.
ContainerMemory
make_container(const FileKind& kind, std::span<const SectionData> sections,
               const std::function<std::vector<std::uint8_t>(const std::vector<fb::Section>&)>& table,
               const ProgressMonitor* progress = nullptr);

// Throws Error(input, path, "<what>: make the file again").
[[noreturn]] void throw_damaged(const std::string& path, const std::string& what);

// Where a file's sections are once it is open.
//
//   memory   copied into memory of this process, and checked: nothing follows the file any more
//   mapping  in a mapping of the file (file_mapping.h), and checked there
//   file     still in the file, for a GPU: what is uploaded is checked, by what uploads it
enum class Residence { memory, mapping, file };

// Seconds to open a file: opening it, reading and checking its prelude and table; reading its sections and
// the other checks.
struct LoadSeconds {
  double map = 0, validate = 0;
};

// Vectors and boxes as tables have them.
inline Vec3d vector_of(const fb::Vec3& v) {
  return {v.x(), v.y(), v.z()};
}
inline fb::Vec3 table_vector(const Vec3d& v) {
  return {v.x, v.y, v.z};
}
inline Boxd box_of(const fb::Box& box) {
  return {vector_of(box.min()), vector_of(box.max())};
}
inline fb::Box table_box(const Boxd& box) {
  return {table_vector(box.min), table_vector(box.max)};
}
inline Hash hash_of(const fb::Hash& hash) {
  return {hash.low(), hash.high()};
}

// Reads a section that is still in its file for a copy elsewhere, and hashes what it reads.
class SectionReader {
public:
  static constexpr std::uint64_t piece_bytes = std::uint64_t{4} << 20; // that a section's hash is made of

  SectionReader(const InputFile& file, std::uint64_t offset, const fb::Section& section);

  std::uint64_t bytes() const { return bytes_; }
  std::uint64_t pieces() const { return hashes_.size(); }
  // Reads piece i part by part: part(offset in the section, bytes, fill) has fill(to) write them where it
  // wants them. For several threads at the same time. Throws Error(input, path, …).
  using Fill = std::function<void(std::span<std::uint8_t>)>;
  using Part = std::function<void(std::uint64_t, std::size_t, const Fill&)>;
  void read_piece(std::uint64_t i, std::size_t part_bytes, const Part& part);
  // When all are read. Throws Error(input, path, …) where the file was written meanwhile, or isn't what its
  // hash says.
  void check() const;

private:
  const InputFile* file_;
  std::uint64_t offset_, bytes_;
  Hash expected_;
  std::vector<Hash> hashes_; // of the pieces
};

// A container whose prelude and table's hash have been checked: what scene and grid files are made of.
class ContainerFile {
public:
  // Reads the prelude and the table. Throws Error(input, path, …).
  ContainerFile(const std::string& path, const FileKind& kind, Residence residence);
  // Of bytes that were made in this process: neither hashes nor records need to be checked. `name` is for
  // messages.
  ContainerFile(ContainerMemory memory, const char* name);

  const Hash& hash() const {
    make_whole();
    return prelude().hash;
  }
  const std::string& path() const { return path_; }
  std::uint64_t bytes() const { return prelude().body_offset + prelude().body_bytes; }
  Residence residence() const { return residence_; }
  const LoadSeconds& load_seconds() const { return seconds_; }
  // Throws Error(input, path, …) where the sections are mapped and the file was written since it was opened.
  void check_unchanged() const {
    if (residence_ == Residence::mapping) file_->check_unchanged();
  }
  // Makes what was left for later. For threads at the same time.
  void make_whole() const {
    if (later_ != nullptr && !later_->is_made.load(std::memory_order_acquire)) make_later();
  }
  // Writes a file of the same bytes, whole or not at all, where the sections are in memory or mapped. Throws
  // Error(output).
  void write(const std::string& path) const;

protected:
  std::span<const std::uint8_t> table_bytes() const {
    return std::span(head_).subspan(sizeof(Prelude), prelude().table_bytes);
  }
  // Throws Error(input, path, "<what>: make the file again") unless it is good.
  void check(bool good, const char* what) const {
    if (!good) throw_damaged(path_, what);
  }
  // Of the section that is made later, if there is one: where the table has its hash.
  void set_place_of_later(const fb::Section& section) {
    if (later_ != nullptr && later_->section.kind == section.kind())
      later_->hash = const_cast<fb::Hash*>(&section.hash());
  }
  // Whether its records are in memory, and anybody could have written them.
  bool has_records_to_check() const { return file_.has_value() && residence_ != Residence::file; }
  // Checks the sections' order, bounds and alignment and what is between them; then, unless they stay in the
  // file, brings them where they are wanted and checks their hashes (in parallel, while they are read).
  // Throws Error(input).
  void read_sections(std::span<const fb::Section> sections);
  // When all is checked.
  void set_validated() { seconds_.validate = watch_.seconds() - seconds_.map; }

  // The section of this kind; null where there is none. Throws Error(input) when its record size is another.
  const fb::Section* section_of(std::span<const fb::Section> sections, std::uint32_t kind,
                                std::size_t record_bytes) const;
  // A section's bytes; none where they stay in the file.
  std::span<const std::uint8_t> bytes_of(const fb::Section& section) const {
    return body_.empty() ? body_ : body_.subspan(section.offset(), section.count() * section.record_bytes());
  }
  // For a copy of a section that stays in the file.
  SectionReader reader_of(const fb::Section& section) const {
    return {*file_, prelude().body_offset, section};
  }

private:
  // Of a section that is made when it is first needed.
  struct Later {
    std::atomic<bool> is_made = false;
    std::mutex mutex; // of what follows
    SectionData section;
    fb::Hash* hash = nullptr; // in the table
  };

  const Prelude& prelude() const { return *reinterpret_cast<const Prelude*>(head_.data()); }
  void make_later() const;
  // Has a section where it is wanted; returns its hash.
  Hash read_section(const fb::Section& section);

  Stopwatch watch_; // since it was opened
  LoadSeconds seconds_;
  std::string path_;
  std::optional<InputFile> file_; // none where it was made in memory
  Residence residence_;
  HostBytes head_;                     // prelude and table
  HostBytes memory_;                   // one of these has the sections,
  FileMapping mapping_;                // or none
  std::span<const std::uint8_t> body_; // of either
  std::unique_ptr<Later> later_;       // null: all is there
};

// A container with a verified table, whose sections are of the kinds of an enumeration.
template <class Table, class Kind>
class TableFile : public ContainerFile {
public:
  const Table& table() const { return *table_; }
  // Of records that stay in the file, which there must be.
  template <class T>
  SectionReader reader(Kind kind) const {
    return reader_of(*section<T>(kind));
  }

protected:
  explicit TableFile(ContainerFile container) : ContainerFile(std::move(container)) {
    const auto bytes = table_bytes();
    flatbuffers::Verifier verifier(bytes.data(), bytes.size());
    check(verifier.VerifyBuffer<Table>(nullptr), "its table is damaged");
    table_ = flatbuffers::GetRoot<Table>(bytes.data());
    // The list of sections can still be misaligned for its 8-byte numbers.
    check(reinterpret_cast<std::uintptr_t>(sections().data()) % alignof(fb::Section) == 0,
          "its table is damaged");
    for (const fb::Section& section : sections())
      set_place_of_later(section);
  }

  std::span<const fb::Section> sections() const {
    const auto* const list = table_->sections();
    return {reinterpret_cast<const fb::Section*>(list->Data()), list->size()};
  }
  // How many records of a kind there are; and the records, none where they stay in the file. Throw
  // Error(input) when a record's size isn't T's.
  template <class T>
  std::uint64_t count(Kind kind) const {
    const fb::Section* const found = section<T>(kind);
    return found != nullptr ? found->count() : 0;
  }
  template <class T>
  std::span<const T> records(Kind kind) const {
    const fb::Section* const found = section<T>(kind);
    if (found == nullptr || bytes_of(*found).empty()) return {};
    return {reinterpret_cast<const T*>(bytes_of(*found).data()), found->count()};
  }

  const Table* table_;

private:
  template <class T>
  const fb::Section* section(Kind kind) const {
    return section_of(sections(), static_cast<std::uint32_t>(kind), sizeof(T));
  }
};

} // namespace masu
