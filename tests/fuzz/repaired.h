// Files in memory, and containers with corrected hashes, so that fuzzing reaches the checks behind them.
#pragma once

#include "libscene/file/container.h"
#include "libscene/file/memory_file.h"
#include "libscene/file/output_file.h"

#include <xxhash.h>

#include <cstring>
#include <vector>

namespace masu {

inline void fill(const MemoryFile& file, std::span<const std::uint8_t> bytes) {
  OutputFile output(file.path());
  output.write(bytes);
  output.commit();
}

// The input with its prelude and, if it has a valid table, its hashes corrected. Table is fb::Scene or
// fb::Grid; sections must be smaller than 4 MiB, and so are hashed as one piece.
template <class Table>
std::vector<std::uint8_t> repaired(std::span<const std::uint8_t> input, const FileKind& kind) {
  std::vector<std::uint8_t> bytes(input.begin(), input.end());
  Prelude head{};
  if (bytes.size() <= sizeof head) return bytes;
  std::memcpy(&head, bytes.data(), sizeof head);
  head.magic = kind.magic;
  head.version = kind.version;
  head.reserved = 0;
  head.reserved2 = 0;
  head.table_bytes = std::min<std::uint64_t>(head.table_bytes, bytes.size() - sizeof head - 1);
  head.body_offset = (sizeof head + head.table_bytes + 4095) / 4096 * 4096;
  if (bytes.size() < head.body_offset) bytes.resize(head.body_offset);
  head.body_bytes = bytes.size() - head.body_offset;
  std::uint8_t* const table = bytes.data() + sizeof head;
  std::memset(table + head.table_bytes, 0, head.body_offset - sizeof head - head.table_bytes);

  flatbuffers::Verifier verifier(table, head.table_bytes);
  if (verifier.VerifyBuffer<Table>(nullptr)) {
    const auto* const sections = flatbuffers::GetRoot<Table>(table)->sections();
    const auto list = static_cast<std::size_t>(sections->Data() - table);
    for (std::size_t i = 0; i < sections->size(); ++i) {
      fb::Section section; // the list may be misaligned
      std::memcpy(&section, table + list + i * sizeof section, sizeof section);
      const std::uint64_t size = section.record_bytes() * section.count();
      if (section.offset() > head.body_bytes || size > head.body_bytes - section.offset()) continue;
      const XXH128_hash_t piece = XXH3_128bits(bytes.data() + head.body_offset + section.offset(), size);
      const XXH128_hash_t hash = XXH3_128bits(&piece, sizeof piece);
      section = {section.kind(),
                 section.record_bytes(),
                 section.count(),
                 section.offset(),
                 {hash.low64, hash.high64}};
      std::memcpy(table + list + i * sizeof section, &section, sizeof section);
    }
  }
  head.hash = {};
  std::memcpy(bytes.data(), &head, sizeof head);
  const XXH128_hash_t hash = XXH3_128bits(bytes.data(), sizeof head + head.table_bytes);
  head.hash = {hash.low64, hash.high64};
  std::memcpy(bytes.data(), &head, sizeof head);
  return bytes;
}

} // namespace masu
