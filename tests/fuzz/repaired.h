// Files in memory, and containers with corrected hashes, so that fuzzing reaches the checks behind them.
#pragma once

#include "libgrid/file/structure_file.h"
#include "libscene/file/container.h"
#include "libscene/file/output_file.h"
#include "tests/memory_file.h"

#include <fcntl.h>
#include <unistd.h>
#include <xxhash.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <type_traits>
#include <vector>

namespace masu {

// A file for all executions: to make one takes longer than most of them.
class ReusedFile {
public:
  ReusedFile() : file_(open(memory_.path().c_str(), O_WRONLY | O_CLOEXEC)) {}
  ~ReusedFile() { close(file_); }
  ReusedFile(const ReusedFile&) = delete;
  ReusedFile& operator=(const ReusedFile&) = delete;

  // Its path, once it holds these bytes alone.
  std::string with(std::span<const std::uint8_t> bytes) const {
    if (ftruncate(file_, static_cast<off_t>(bytes.size())) != 0 || !write_all_at(file_, 0, bytes))
      std::abort();
    return memory_.path();
  }

private:
  MemoryFile memory_;
  int file_;
};

// Of the scene that a grid is traced with.
struct Geometry {
  Hash hash;
  std::uint64_t primitives;
};

// Of a section, as container.h says.
inline XXH128_hash_t section_hash(const std::uint8_t* data, std::uint64_t size) {
  constexpr std::uint64_t piece_bytes = std::uint64_t{4} << 20;
  std::vector<XXH128_hash_t> pieces;
  for (std::uint64_t begin = 0; begin < size; begin += piece_bytes)
    pieces.push_back(XXH3_128bits(data + begin, std::min(piece_bytes, size - begin)));
  return XXH3_128bits(pieces.data(), pieces.size() * sizeof(XXH128_hash_t));
}

// The input with its prelude and, if it has a valid table, its hashes corrected. Table is fb::Scene or
// fb::Structure. With a `geometry`, a grid is bound to it.
template <class Table>
std::vector<std::uint8_t> repaired(std::span<const std::uint8_t> input, const FileKind& kind,
                                   [[maybe_unused]] const Geometry* geometry = nullptr) {
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

  const auto is_valid = [&] {
    return flatbuffers::Verifier(table, head.table_bytes).VerifyBuffer<Table>(nullptr);
  };
  if constexpr (std::is_same_v<Table, fb::Structure>) {
    if (geometry != nullptr && is_valid()) {
      auto* const root = flatbuffers::GetMutableRoot<Table>(table);
      if (root->geometry_hash() != nullptr) {
        const fb::Hash hash(geometry->hash.low, geometry->hash.high);
        std::memcpy(const_cast<fb::Hash*>(root->geometry_hash()), &hash, sizeof hash);
      }
    }
    // Fields of a hostile table may overlap each other and what says where they are.
    if (geometry != nullptr && is_valid())
      reinterpret_cast<flatbuffers::Table*>(flatbuffers::GetMutableRoot<Table>(table))
          ->template SetField<std::uint64_t>(fb::Structure::VT_PRIMITIVES, geometry->primitives, 0);
  }
  if (is_valid()) {
    const auto* const sections = flatbuffers::GetRoot<Table>(table)->sections();
    const auto list = static_cast<std::size_t>(sections->Data() - table);
    const std::size_t count = sections->size();
    for (std::size_t i = 0; i < count; ++i) {
      fb::Section section; // the list may be misaligned
      std::memcpy(&section, table + list + i * sizeof section, sizeof section);
      const std::uint64_t size = section.record_bytes() * section.count();
      if (section.offset() > head.body_bytes || size > head.body_bytes - section.offset()) continue;
      const XXH128_hash_t hash = section_hash(bytes.data() + head.body_offset + section.offset(), size);
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

// Acts on the file of these bytes, and on that of them repaired.
template <class Table, class Act>
void with_repaired(std::span<const std::uint8_t> bytes, const FileKind& kind, const Act& act) {
  static const ReusedFile memory;
  act(memory.with(bytes));
  const std::vector<std::uint8_t> right = repaired<Table>(bytes, kind);
  if (!std::ranges::equal(bytes, right)) act(memory.with(right));
}

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

// For LLVMFuzzerCustomMutator: what the fuzzer does anywhere in the file, or to four bytes of the body, with
// hashes that are right afterwards most of the time.
template <class Table>
std::size_t mutated(std::uint8_t* data, std::size_t size, std::size_t max_size, unsigned seed,
                    const FileKind& kind) {
  if (seed % 2 == 0 && size > 4096) {
    const std::size_t word = (4096 + seed / 2 % (size - 4096)) / 4 * 4;
    if (word + 4 <= size) static_cast<void>(LLVMFuzzerMutate(data + word, 4, 4));
  } else {
    size = LLVMFuzzerMutate(data, size, max_size);
  }
  if (seed % 16 == 0) return size;
  const std::vector<std::uint8_t> bytes = repaired<Table>({data, size}, kind);
  if (bytes.size() > max_size) return size;
  std::copy(bytes.begin(), bytes.end(), data);
  return bytes.size();
}

} // namespace masu
