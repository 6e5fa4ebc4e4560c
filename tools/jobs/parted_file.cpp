#include "tools/jobs/parted_file.h"

#include "libscene/base/error.h"
#include "libscene/file/input_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace masu {
namespace {

// The part in a slot that ends before `end`.
std::vector<std::uint8_t> read_slot(const InputFile& file, std::uint64_t offset, std::uint64_t end) {
  std::uint64_t bytes = 0;
  file.read(offset, {reinterpret_cast<std::uint8_t*>(&bytes), slot_head});
  if (bytes > end - offset - slot_head)
    throw Error(ErrorCode::output, file.path(), "was changed while it was written: run again");
  std::vector<std::uint8_t> part(bytes);
  file.read(offset + slot_head, part);
  return part;
}

} // namespace

SharedFile::SharedFile(const std::string& path, PartedForm form, Ranks& ranks)
    : path_(path), form_(std::move(form)) {
  if (ranks.rank() == 0) temporary_ = made_.emplace(path, UntilCommit::named).temporary_path();
  ranks.broadcast(temporary_);
  file_ = open(temporary_.c_str(), O_WRONLY | O_CLOEXEC);
  if (file_ < 0) fail("can't be opened by all ranks");
}

void SharedFile::write(std::uint64_t part, std::vector<std::uint8_t> bytes) const {
  if (form_.begin) {
    const std::uint64_t size = bytes.size();
    const auto* const first = reinterpret_cast<const std::uint8_t*>(&size);
    bytes.insert(bytes.begin(), first, first + slot_head);
  }
  if (!write_all_at(file_, form_.offset(part), bytes)) fail("can't be written");
}

void SharedFile::commit() {
  if (!form_.begin) return made_->commit();
  PartedFile whole(path_, form_);
  const InputFile slots(temporary_);
  for (std::uint64_t part = 0; part < form_.count; ++part)
    whole.write(part, read_slot(slots, form_.offset(part), form_.offset(part + 1)));
  whole.commit();
  made_.reset();
}

void SharedFile::fail(const char* doing) const {
  throw Error(ErrorCode::output, path_, std::string(doing) + ": " + std::strerror(errno));
}

void check_is_file(const std::string& path) {
  struct stat status {};
  if (is_standard_output(path) || (stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode)))
    throw Error(ErrorCode::usage, path,
                "isn't a regular file, which several ranks and --resume need: name a file");
}

bool is_kept(const std::string& path, const KnownBy& known_by) {
  constexpr std::uint64_t before = 4096; // of a JPEG's comment: its tables
  try {
    const InputFile file(path);
    if (known_by.bytes && file.size() != *known_by.bytes) return false;
    std::string begin(std::min(file.size(), known_by.text.size() + before), ' ');
    file.read(0, {reinterpret_cast<std::uint8_t*>(begin.data()), begin.size()});
    return begin.find(known_by.text) != std::string::npos;
  } catch (const Error&) { // none, a folder, a pipe
    return false;
  }
}

} // namespace masu
