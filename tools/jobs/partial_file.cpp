#include "tools/jobs/partial_file.h"

#include "libscene/base/error.h"
#include "libscene/file/container.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <xxhash.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <memory>
#include <new>
#include <utility>

namespace masu {
namespace {

constexpr std::string_view suffix = ".partial";

[[noreturn]] void fail(const std::string& path, const char* doing) {
  throw Error(ErrorCode::output, path, std::string(doing) + ": " + std::strerror(errno));
}

// Of a regular file: opening another one, such as a pipe, could wait for ever. -1, and errno, where it can't
// be opened.
class Descriptor {
public:
  Descriptor(const std::string& path, int flags)
      : file_(open(path.c_str(), flags | O_CLOEXEC | O_NONBLOCK, 0666)) {
    struct stat status {};
    if (file_ < 0 || (fstat(file_, &status) == 0 && S_ISREG(status.st_mode))) return;
    close(std::exchange(file_, -1));
    errno = EINVAL;
  }
  ~Descriptor() {
    if (file_ >= 0) close(file_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  operator int() const { return file_; }
  // Some file systems say only now that something wasn't written.
  bool closed() { return close(std::exchange(file_, -1)) == 0; }

private:
  int file_;
};

bool read_all_at(int file, std::uint64_t offset, std::span<std::uint8_t> bytes) {
  while (!bytes.empty()) {
    const ssize_t got = pread(file, bytes.data(), bytes.size(), static_cast<off_t>(offset));
    if (got < 0 && errno == EINTR) continue;
    if (got == 0) errno = ENODATA;
    if (got <= 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(got));
    offset += static_cast<std::uint64_t>(got);
  }
  return true;
}

std::uint64_t size_of(int file) {
  struct stat status {};
  return fstat(file, &status) == 0 ? static_cast<std::uint64_t>(status.st_size) : 0;
}

// XXH3-128, in hexadecimal. Empty where they aren't there.
std::string hash_at(int file, std::uint64_t offset, std::uint64_t bytes) {
  constexpr std::uint64_t piece_bytes = std::uint64_t{1} << 20; // files may be larger than memory
  const std::uint64_t size = size_of(file);
  if (size < offset || size - offset < bytes) return {};
  const std::unique_ptr<XXH3_state_t, decltype(&XXH3_freeState)> state(XXH3_createState(), XXH3_freeState);
  if (!state || XXH3_128bits_reset(state.get()) != XXH_OK) throw std::bad_alloc();
  std::vector<std::uint8_t> piece(std::min(bytes, piece_bytes));
  for (std::uint64_t done = 0; done < bytes; done += piece.size()) {
    piece.resize(std::min(bytes - done, piece_bytes));
    if (!read_all_at(file, offset + done, piece)) return {};
    XXH3_128bits_update(state.get(), piece.data(), piece.size());
  }
  const XXH128_hash_t hash = XXH3_128bits_digest(state.get());
  return to_hex(Hash{hash.low64, hash.high64});
}

// The part in a slot that ends before `end`.
std::vector<std::uint8_t> read_slot(const std::string& path, std::uint64_t offset, std::uint64_t end) {
  const Descriptor file(path, O_RDONLY);
  std::uint64_t bytes = 0;
  if (file < 0 || !read_all_at(file, offset, {reinterpret_cast<std::uint8_t*>(&bytes), slot_head}))
    fail(path, "can't be read");
  if (bytes > end - offset - slot_head)
    throw Error(ErrorCode::output, path, "was changed while it was written: run again");
  std::vector<std::uint8_t> part(bytes);
  if (!read_all_at(file, offset + slot_head, part)) fail(path, "can't be read");
  return part;
}

// Gives a partial file of so many bytes its name.
void rename_partial(const std::string& path, std::uint64_t bytes) {
  const std::string target = followed(path), partial = target + std::string(suffix);
  struct stat replaced {};
  const bool replaces = stat(target.c_str(), &replaced) == 0;
  Descriptor file(partial, O_WRONLY | (bytes == 0 ? O_CREAT : 0));
  if (file < 0) {
    if (errno == ENOENT && replaces && static_cast<std::uint64_t>(replaced.st_size) == bytes) return;
    fail(partial, "can't be opened");
  }
  if (ftruncate(file, static_cast<off_t>(bytes)) != 0) fail(partial, "can't be given its size");
  if (replaces) static_cast<void>(fchmod(file, replaced.st_mode & 0777U));
  if (fsync(file) != 0 || !file.closed()) fail(partial, "can't be flushed");
  if (rename(partial.c_str(), target.c_str()) != 0) fail(path, "can't be given its name");
  const std::string folder = std::filesystem::path(target).parent_path().string();
  const int in = open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (in >= 0) static_cast<void>(fsync(in) + close(in));
}

} // namespace

std::string partial_name(const std::string& path) {
  struct stat status {};
  if (is_standard_output(path) || (stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode)))
    throw Error(ErrorCode::usage, path,
                "isn't a regular file, which several ranks and --resume need: name a file");
  return followed(path) + std::string(suffix);
}

FileRange whole_file(const std::string& path) {
  const Descriptor file(path, O_RDONLY);
  if (file < 0) fail(path, "can't be read again");
  const std::uint64_t bytes = size_of(file);
  return {path, {}, 0, bytes, hash_at(file, 0, bytes)};
}

bool is_whole(const FileRange& range) {
  if (range.hash.empty()) return false;
  const Descriptor file(range.path, O_RDONLY);
  if (file < 0) {
    if (errno != ENOENT || range.becomes == 0) return false;
    const Descriptor renamed(range.path.substr(0, range.path.size() - suffix.size()), O_RDONLY);
    return renamed >= 0 && size_of(renamed) == range.becomes &&
           hash_at(renamed, *range.offset, range.bytes) == range.hash;
  }
  if (!range.offset && size_of(file) != range.bytes) return false;
  return hash_at(file, range.offset.value_or(0), range.bytes) == range.hash;
}

FileRange range_of(const std::string& path, const PartedForm& form, std::uint64_t part) {
  return {partial_name(path), form.offset(part), form.bytes};
}

FileRange write_part(const std::string& path, const PartedForm& form, std::uint64_t part,
                     std::vector<std::uint8_t> bytes) {
  FileRange range = range_of(path, form, part);
  if (form.begin) {
    const std::uint64_t size = bytes.size();
    const auto* const first = reinterpret_cast<const std::uint8_t*>(&size);
    bytes.insert(bytes.begin(), first, first + slot_head);
  }
  Descriptor file(range.path, O_WRONLY | O_CREAT);
  if (file < 0) fail(range.path, "can't be created");
  if (!write_all_at(file, *range.offset, bytes) || !file.closed()) fail(range.path, "can't be written");
  range.bytes = bytes.size();
  range.hash = to_hex(hash_of(bytes));
  return range;
}

void finish_parts(const std::string& path, const PartedForm& form) {
  if (!form.begin) return rename_partial(path, form.bytes);
  OutputFile file(path);
  const AppendPart append = form.begin(file);
  const std::string partial = partial_name(path);
  for (std::uint64_t part = 0; part < form.count; ++part)
    append(read_slot(partial, form.offset(part), form.offset(part + 1)));
  file.commit();
}

} // namespace masu
