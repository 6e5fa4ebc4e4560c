#include "libscene/file/container.h"

#include "libscene/base/error.h"
#include "libscene/base/parallel.h"
#include "libscene/file/output_file.h"

#include <fmt/format.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/task_arena.h>
#include <xxhash.h>

#include <bit>
#include <cstring>
#include <new>

static_assert(std::endian::native == std::endian::little,
              "the files' little-endian arrays are used in place");

namespace masu {
namespace {

constexpr std::uint64_t body_alignment = 4096;
constexpr std::uint64_t section_alignment = 256;
constexpr std::uint64_t piece_bytes = SectionReader::piece_bytes;

std::uint64_t rounded_up(std::uint64_t value, std::uint64_t to) {
  return (value + to - 1) / to * to;
}

constexpr const char* damaged_section = "its contents are damaged (a section's hash is wrong)";

Hash hash_of_hashes(const std::vector<Hash>& hashes) {
  return hash_of({reinterpret_cast<const std::uint8_t*>(hashes.data()), hashes.size() * sizeof(Hash)});
}

// The hash of `bytes` bytes. Pieces of them are hashed in parallel, each as piece(its offset, its size) has
// it; the result doesn't depend on the number of threads.
template <class Piece>
Hash hash_of_pieces(std::uint64_t bytes, const Piece& piece) {
  const std::uint64_t pieces = (bytes + piece_bytes - 1) / piece_bytes;
  std::vector<Hash> hashes(pieces);
  parallel_for(pieces, [&](std::uint64_t i) {
    const std::uint64_t begin = i * piece_bytes;
    hashes[i] = hash_of(piece(begin, std::min(piece_bytes, bytes - begin)));
  });
  return hash_of_hashes(hashes);
}

// Some of a section's bytes; converted into the buffer, where that has to be.
std::span<const std::uint8_t> bytes_of(const SectionData& section, std::uint64_t begin, std::uint64_t bytes,
                                       std::vector<std::uint8_t>& buffer) {
  if (!section.convert) return {static_cast<const std::uint8_t*>(section.data) + begin, bytes};
  const std::uint64_t each = section.record_bytes, first = begin / each,
                      end = rounded_up(begin + bytes, each) / each;
  buffer.resize((end - first) * each);
  section.convert(first, end - first, buffer.data());
  return std::span(buffer).subspan(begin - first * each, bytes);
}

Hash hash_of_section(const SectionData& section) {
  tbb::enumerable_thread_specific<std::vector<std::uint8_t>> buffers;
  return hash_of_pieces(section.record_bytes * section.count, [&](std::uint64_t begin, std::uint64_t bytes) {
    return bytes_of(section, begin, bytes, buffers.local());
  });
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

// A few pieces at a time, converted in parallel.
void write_section(OutputFile& file, const SectionData& section) {
  const std::uint64_t all = section.record_bytes * section.count;
  if (!section.convert) return file.write(section.data, all);
  std::array<std::vector<std::uint8_t>, 4> buffers;
  std::array<std::span<const std::uint8_t>, 4> pieces;
  for (std::uint64_t begin = 0; begin < all; begin += pieces.size() * piece_bytes) {
    parallel_for(pieces.size(), [&](std::size_t i) {
      const std::uint64_t from = std::min(begin + i * piece_bytes, all);
      pieces[i] = bytes_of(section, from, std::min(piece_bytes, all - from), buffers[i]);
    });
    for (const auto piece : pieces)
      file.write(piece);
  }
}

// With its hash.
Prelude prelude_of(const FileKind& kind, std::span<const std::uint8_t> table, std::uint64_t body_bytes) {
  Prelude prelude{};
  prelude.magic = kind.magic;
  prelude.version = kind.version;
  prelude.table_bytes = table.size();
  prelude.body_offset = rounded_up(sizeof prelude + table.size(), body_alignment);
  prelude.body_bytes = body_bytes;
  prelude.hash = content_hash(prelude, table);
  return prelude;
}

std::uint64_t size_of_body(std::span<const fb::Section> layout) {
  return layout.empty() ? 0 : layout.back().offset() + section_size(layout.back());
}

// Calls act(section, its offset in the body) for each that isn't empty. Returns where the last one ends.
template <class Act>
std::uint64_t for_each_placed(std::span<const SectionData> sections, const Act& act) {
  std::uint64_t end = 0;
  for (const SectionData& section : sections) {
    if (section.count == 0) continue;
    const std::uint64_t offset = rounded_up(end, section_alignment);
    act(section, offset);
    end = offset + section.record_bytes * section.count;
  }
  return end;
}

// In memory.
void make_section(const SectionData& section, std::uint8_t* to, const ProgressMonitor* progress) {
  constexpr std::uint64_t grain = std::uint64_t{1} << 14;
  parallel_ranges(section.count, grain, [&](std::size_t begin, std::size_t end) {
    check_progress(progress);
    const std::uint64_t each = section.record_bytes, first = begin, count = end - begin;
    if (section.convert)
      section.convert(first, count, to + first * each);
    else
      std::memcpy(to + first * each, static_cast<const std::uint8_t*>(section.data) + first * each,
                  count * each);
  });
}

// Zeros between sections: bodies are written as they are.
void clear_gaps(std::span<const fb::Section> layout, HostBytes& body) {
  std::uint64_t end = 0;
  for (const fb::Section& section : layout) {
    std::fill(body.data() + end, body.data() + section.offset(), std::uint8_t{0});
    end = section.offset() + section_size(section);
  }
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
  for_each_placed(sections, [&](const SectionData& section, std::uint64_t offset) {
    const Hash hash = section.is_later ? Hash{} : hash_of_section(section);
    layout.emplace_back(section.kind, section.record_bytes, section.count, offset,
                        fb::Hash(hash.low, hash.high));
  });
  return layout;
}

void write_container(const std::string& path, const FileKind& kind, std::span<const std::uint8_t> table,
                     std::span<const SectionData> sections, std::span<const fb::Section> layout) {
  const Prelude prelude = prelude_of(kind, table, size_of_body(layout));
  OutputFile file(path);
  file.write(&prelude, sizeof prelude);
  file.write(table);
  write_zeros(file, prelude.body_offset - sizeof prelude - table.size());
  std::uint64_t written = 0;
  for_each_placed(sections, [&](const SectionData& section, std::uint64_t offset) {
    write_zeros(file, offset - written);
    write_section(file, section);
    written = offset + section.record_bytes * section.count;
  });
  file.commit();
}

ContainerMemory
make_container(const FileKind& kind, std::span<const SectionData> sections,
               const std::function<std::vector<std::uint8_t>(const std::vector<fb::Section>&)>& table,
               const ProgressMonitor* progress) {
  const std::uint64_t end = for_each_placed(sections, [](const SectionData&, std::uint64_t) {});
  ContainerMemory memory{{}, HostBytes(end)};
  std::vector<SectionData> made; // in the body
  for_each_placed(sections, [&](const SectionData& section, std::uint64_t offset) {
    std::uint8_t* const to = memory.body.data() + offset;
    made.push_back({section.kind, section.record_bytes, section.count, to, {}, section.is_later});
    if (section.is_later)
      memory.later = {section.kind, section.record_bytes, section.count, to, section.convert};
    else
      make_section(section, to, progress);
  });
  const std::vector<fb::Section> layout = lay_out(made);
  clear_gaps(layout, memory.body);
  const std::vector<std::uint8_t> table_bytes = table(layout);
  const Prelude prelude = prelude_of(kind, table_bytes, end);
  memory.head.assign(prelude.body_offset, 0);
  std::memcpy(memory.head.data(), &prelude, sizeof prelude);
  std::ranges::copy(table_bytes, memory.head.begin() + sizeof prelude);
  return memory;
}

void throw_damaged(const std::string& path, const std::string& what) {
  throw Error(ErrorCode::input, path, what + ": make the file again");
}

ContainerFile::ContainerFile(const std::string& path, const FileKind& kind, Residence residence)
    : path_(path), file_(path), residence_(residence) {
  const std::uint64_t size = file_->size();
  Prelude head;
  const std::span head_bytes(reinterpret_cast<std::uint8_t*>(&head),
                             std::min(size, std::uint64_t{sizeof head}));
  file_->read(0, head_bytes);
  if (size < kind.magic.size() || head.magic != kind.magic)
    throw Error(ErrorCode::input, path, fmt::format("isn't a {0} file: name a {0} file", kind.name));
  if (size < sizeof head) throw_damaged(path, fmt::format("the {} file is truncated", kind.name));
  if (head.version != kind.version) {
    throw Error(ErrorCode::input, path,
                fmt::format("is version {} of the {} format, this program reads version {}: {}", head.version,
                            kind.name, kind.version, kind.remake));
  }
  const bool fits = head.reserved == 0 && head.reserved2 == 0 && head.table_bytes < size - sizeof head &&
                    head.body_offset == rounded_up(sizeof head + head.table_bytes, body_alignment) &&
                    head.body_offset <= size && head.body_bytes == size - head.body_offset;
  if (!fits)
    throw_damaged(path,
                  fmt::format("the {} file is truncated, too long, or its prelude is damaged", kind.name));
  head_ = file_->memory(head.body_offset);
  std::copy(head_bytes.begin(), head_bytes.end(), head_.begin());
  const auto rest = std::span(head_).subspan(sizeof head);
  file_->read(sizeof head, rest);
  if (content_hash(head, table_bytes()) != head.hash || !all_zero(rest.subspan(head.table_bytes))) {
    file_->check_unchanged();
    throw_damaged(path, fmt::format("the {} file's table is damaged (its hash is wrong)", kind.name));
  }
  seconds_.map = watch_.seconds();
}

ContainerFile::ContainerFile(ContainerMemory memory, const char* name)
    : path_(name), residence_(Residence::memory), head_(std::move(memory.head)),
      memory_(std::move(memory.body)), body_(memory_) {
  if (!memory.later) return;
  later_ = std::make_unique<Later>();
  later_->section = *std::move(memory.later);
}

void ContainerFile::make_later() const {
  // Isolated, or a thread that waits for others' part might take a task that comes here, too.
  tbb::this_task_arena::isolate([&] {
    const std::lock_guard lock(later_->mutex);
    if (later_->is_made.load(std::memory_order_relaxed)) return;
    const SectionData& section = later_->section;
    make_section(section, static_cast<std::uint8_t*>(const_cast<void*>(section.data)), nullptr);
    const Hash hash = hash_of_section({section.kind, section.record_bytes, section.count, section.data});
    *later_->hash = fb::Hash(hash.low, hash.high);
    Prelude& head = *reinterpret_cast<Prelude*>(const_cast<std::uint8_t*>(head_.data()));
    head.hash = content_hash(head, table_bytes());
    later_->section = {}; // and what it is made from: after all that may fail
    later_->is_made.store(true, std::memory_order_release);
  });
}

void ContainerFile::write(const std::string& path) const {
  make_whole();
  OutputFile file(path);
  file.write(head_);
  file.write(body_);
  file.commit();
}

SectionReader::SectionReader(const InputFile& file, std::uint64_t offset, const fb::Section& section)
    : file_(&file), offset_(offset + section.offset()), bytes_(section_size(section)),
      expected_(hash_of(section.hash())), hashes_((bytes_ + piece_bytes - 1) / piece_bytes) {}

void SectionReader::read_piece(std::uint64_t i, std::size_t part_bytes, const Part& part) {
  const std::unique_ptr<XXH3_state_t, decltype(&XXH3_freeState)> state(XXH3_createState(), &XXH3_freeState);
  if (state == nullptr || XXH3_128bits_reset(state.get()) != XXH_OK) throw std::bad_alloc();
  const std::uint64_t end = std::min((i + 1) * piece_bytes, bytes_);
  for (std::uint64_t offset = i * piece_bytes; offset < end; offset += part_bytes) {
    part(offset, std::min<std::uint64_t>(part_bytes, end - offset), [&](std::span<std::uint8_t> to) {
      file_->read(offset_ + offset, to);
      XXH3_128bits_update(state.get(), to.data(), to.size());
    });
  }
  const XXH128_hash_t hash = XXH3_128bits_digest(state.get());
  hashes_[i] = {hash.low64, hash.high64};
}

void SectionReader::check() const {
  if (hash_of_hashes(hashes_) == expected_) return;
  file_->check_unchanged();
  throw_damaged(file_->path(), damaged_section);
}

Hash ContainerFile::read_section(const fb::Section& section) {
  if (residence_ == Residence::mapping)
    return hash_of_pieces(section_size(section), [&](std::uint64_t begin, std::uint64_t bytes) {
      return body_.subspan(section.offset() + begin, bytes);
    });
  const std::uint64_t offset = prelude().body_offset + section.offset();
  const auto to = std::span(memory_).subspan(section.offset(), section_size(section));
  return hash_of_pieces(to.size(), [&](std::uint64_t begin, std::uint64_t bytes) {
    const auto piece = to.subspan(begin, bytes);
    file_->read(offset + begin, piece);
    return piece;
  });
}

void ContainerFile::read_sections(std::span<const fb::Section> sections) {
  if (!file_) return; // they are there
  const std::uint64_t body_bytes = prelude().body_bytes;
  std::array<std::uint8_t, section_alignment> gap{};
  std::uint64_t end = 0;
  for (std::size_t i = 0; i < sections.size(); ++i) {
    const fb::Section& section = sections[i];
    check(i == 0 || section.kind() > sections[i - 1].kind(), "its sections are out of order");
    check(section.count() > 0 && section.record_bytes() > 0 &&
              section.offset() == rounded_up(end, section_alignment) && section.offset() <= body_bytes &&
              section.count() <= (body_bytes - section.offset()) / section.record_bytes(),
          "a section's size, offset or alignment is wrong");
    const std::span between(gap.data(), section.offset() - end);
    file_->read(prelude().body_offset + end, between);
    check(all_zero(between), "there are bytes between its sections");
    end = section.offset() + section_size(section);
  }
  check(end == body_bytes, "there are bytes after its last section");
  if (residence_ == Residence::file) return;
  if (residence_ == Residence::mapping) {
    mapping_ = FileMapping(*file_);
    body_ = mapping_.bytes().subspan(prelude().body_offset);
  } else {
    memory_ = file_->memory(body_bytes);
    clear_gaps(sections, memory_);
    body_ = memory_;
  }
  std::vector<Hash> hashes;
  for (const fb::Section& section : sections)
    hashes.push_back(read_section(section));
  file_->check_unchanged();
  for (std::size_t i = 0; i < sections.size(); ++i)
    check(hashes[i] == hash_of(sections[i].hash()), damaged_section);
}

const fb::Section* ContainerFile::section_of(std::span<const fb::Section> sections, std::uint32_t kind,
                                             std::size_t record_bytes) const {
  for (const fb::Section& section : sections) {
    if (section.kind() != kind) continue;
    check(section.record_bytes() == record_bytes, "a section's records have the wrong size");
    return &section;
  }
  return nullptr;
}

} // namespace masu
