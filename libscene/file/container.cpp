#include "libscene/file/container.h"

#include "libscene/error.h"
#include "libscene/file/output_file.h"

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>
#include <xxhash.h>

#include <algorithm>
#include <bit>
#include <cstring>

static_assert(std::endian::native == std::endian::little,
              "the files' little-endian arrays are used in place");

namespace masu {
namespace {

constexpr std::uint64_t body_alignment = 4096;
constexpr std::uint64_t section_alignment = 256;
constexpr std::uint64_t piece_bytes = std::uint64_t{4} << 20;

std::uint64_t rounded_up(std::uint64_t value, std::uint64_t to) {
  return (value + to - 1) / to * to;
}

// Pieces are hashed in parallel; the result doesn't depend on the number of threads.
Hash hash_of_pieces(const std::uint8_t* data, std::uint64_t bytes) {
  const std::uint64_t pieces = (bytes + piece_bytes - 1) / piece_bytes;
  std::vector<Hash> hashes(pieces);
  tbb::parallel_for(std::uint64_t{0}, pieces, [&](std::uint64_t piece) {
    const std::uint64_t begin = piece * piece_bytes;
    hashes[piece] = hash_of({data + begin, std::min(piece_bytes, bytes - begin)});
  });
  return hash_of({reinterpret_cast<const std::uint8_t*>(hashes.data()), hashes.size() * sizeof(Hash)});
}

// With a hash field of zeros.
Hash content_hash(Prelude prelude, std::span<const std::uint8_t> table) {
  prelude.hash = {};
  std::vector<std::uint8_t> bytes(sizeof prelude + table.size());
  std::memcpy(bytes.data(), &prelude, sizeof prelude);
  std::copy(table.begin(), table.end(), bytes.begin() + sizeof prelude);
  return hash_of(bytes);
}

std::uint64_t section_size(const fb::Section& section) {
  return section.record_bytes() * section.count();
}

bool all_zero(std::span<const std::uint8_t> bytes) {
  return std::all_of(bytes.begin(), bytes.end(), [](std::uint8_t byte) { return byte == 0; });
}

void write_zeros(OutputFile& file, std::uint64_t count) {
  const std::array<std::uint8_t, body_alignment> zeros{};
  file.write({zeros.data(), count});
}

} // namespace

Hash hash_of(std::span<const std::uint8_t> bytes) {
  const XXH128_hash_t hash = XXH3_128bits(bytes.data(), bytes.size());
  return {hash.low64, hash.high64};
}

std::string to_hex(const Hash& hash) {
  return fmt::format("{:016x}{:016x}", hash.high, hash.low);
}

std::vector<fb::Section> lay_out(std::span<const SectionData> sections) {
  std::vector<fb::Section> layout;
  std::uint64_t offset = 0;
  for (const SectionData& section : sections) {
    if (section.count == 0) continue;
    offset = rounded_up(offset, section_alignment);
    const std::uint64_t bytes = section.record_bytes * section.count;
    const Hash hash = hash_of_pieces(static_cast<const std::uint8_t*>(section.data), bytes);
    layout.emplace_back(section.kind, section.record_bytes, section.count, offset,
                        fb::Hash(hash.low, hash.high));
    offset += bytes;
  }
  return layout;
}

Hash write_container(const std::string& path, const FileKind& kind, std::span<const std::uint8_t> table,
                     std::span<const SectionData> sections, std::span<const fb::Section> layout) {
  Prelude prelude{};
  prelude.magic = kind.magic;
  prelude.version = kind.version;
  prelude.table_bytes = table.size();
  prelude.body_offset = rounded_up(sizeof prelude + table.size(), body_alignment);
  prelude.body_bytes = layout.empty() ? 0 : layout.back().offset() + section_size(layout.back());
  prelude.hash = content_hash(prelude, table);

  OutputFile file(path);
  file.write(&prelude, sizeof prelude);
  file.write(table);
  write_zeros(file, prelude.body_offset - sizeof prelude - table.size());
  std::uint64_t written = 0;
  auto entry = layout.begin();
  for (const SectionData& section : sections) {
    if (section.count == 0) continue;
    write_zeros(file, entry->offset() - written);
    file.write(section.data, section_size(*entry));
    written = entry->offset() + section_size(*entry);
    ++entry;
  }
  file.commit();
  return prelude.hash;
}

void throw_damaged(const std::string& path, const std::string& what) {
  throw Error(ErrorCode::input, path, what + ": make the file again");
}

ContainerFile::ContainerFile(const std::string& path, const FileKind& kind) : file_(path) {
  const auto bytes = file_.bytes();
  if (bytes.size() < kind.magic.size() ||
      std::memcmp(bytes.data(), kind.magic.data(), kind.magic.size()) != 0) {
    throw Error(ErrorCode::input, path, fmt::format("isn't a {0} file: name a {0} file", kind.name));
  }
  if (bytes.size() < sizeof(Prelude)) throw_damaged(path, fmt::format("the {} file is truncated", kind.name));
  const Prelude& head = prelude();
  if (head.version != kind.version) {
    throw Error(ErrorCode::input, path,
                fmt::format("is version {} of the {} format, this program reads version {}: {}", head.version,
                            kind.name, kind.version, kind.remake));
  }
  const std::uint64_t size = bytes.size();
  const bool fits = head.reserved == 0 && head.reserved2 == 0 && head.table_bytes < size - sizeof(Prelude) &&
                    head.body_offset == rounded_up(sizeof(Prelude) + head.table_bytes, body_alignment) &&
                    head.body_offset <= size && head.body_bytes == size - head.body_offset;
  if (!fits)
    throw_damaged(path,
                  fmt::format("the {} file is truncated, too long, or its prelude is damaged", kind.name));
  if (content_hash(head, table()) != head.hash ||
      !all_zero(bytes.subspan(sizeof(Prelude) + head.table_bytes,
                              head.body_offset - sizeof(Prelude) - head.table_bytes))) {
    throw_damaged(path, fmt::format("the {} file's table is damaged (its hash is wrong)", kind.name));
  }
}

void ContainerFile::check_sections(std::span<const fb::Section> sections) const {
  const auto check = [&](bool good, const char* what) {
    if (!good) throw_damaged(path(), what);
  };
  const auto body = file_.bytes().subspan(prelude().body_offset);
  std::uint64_t end = 0;
  for (std::size_t i = 0; i < sections.size(); ++i) {
    const fb::Section& section = sections[i];
    check(i == 0 || section.kind() > sections[i - 1].kind(), "its sections are out of order");
    check(section.count() > 0 && section.record_bytes() > 0 &&
              section.offset() == rounded_up(end, section_alignment) && section.offset() <= body.size() &&
              section.count() <= (body.size() - section.offset()) / section.record_bytes(),
          "a section's size, offset or alignment is wrong");
    check(all_zero(body.subspan(end, section.offset() - end)), "there are bytes between its sections");
    end = section.offset() + section_size(section);
  }
  check(end == body.size(), "there are bytes after its last section");
  for (const fb::Section& section : sections) {
    const Hash hash = hash_of_pieces(body.data() + section.offset(), section_size(section));
    check(hash == Hash{section.hash().low(), section.hash().high()},
          "its contents are damaged (a section's hash is wrong)");
  }
}

std::span<const std::uint8_t> ContainerFile::section_bytes(std::span<const fb::Section> sections,
                                                           std::uint32_t kind,
                                                           std::size_t record_bytes) const {
  for (const fb::Section& section : sections) {
    if (section.kind() != kind) continue;
    if (section.record_bytes() != record_bytes)
      throw_damaged(path(), "a section's records have the wrong size");
    return file_.bytes().subspan(prelude().body_offset + section.offset(), section_size(section));
  }
  return {};
}

} // namespace masu
