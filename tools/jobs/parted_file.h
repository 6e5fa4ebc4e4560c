// Files whose parts are made in any order, by several threads or by several ranks; and which of those that
// are there are kept.
#pragma once

#include "libscene/file/output_file.h"
#include "tools/jobs/ranks.h"

#include <unistd.h>

#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace masu {

// Appends the next part to a file.
using AppendPart = std::function<void(std::span<const std::uint8_t> part)>;

// A slot, which has a part whose size isn't known before it is made, begins with that size.
inline constexpr std::uint64_t slot_head = sizeof(std::uint64_t);

// How numbered parts make a file. Either the offset of each is known before it is made; or parts follow each
// other, and then `begin` isn't null.
struct PartedForm {
  std::uint64_t count = 0; // parts
  // Of a part in the file. Of parts that follow each other: in a SharedFile until it is committed, where each
  // has a slot with room for it.
  std::function<std::uint64_t(std::uint64_t part)> offset{};
  std::uint64_t bytes = 0; // of the file, where offsets are known
  std::function<AppendPart(OutputFile& file)> begin{};
};

// A file that this process writes alone. A part is written when it comes; where parts follow each other, or
// the output is a pipe, when all before it have come.
class PartedFile {
public:
  // Throws Error(output).
  PartedFile(const std::string& path, PartedForm form) : file_(path), form_(std::move(form)) {
    append_ =
        form_.begin ? form_.begin(file_) : [this](std::span<const std::uint8_t> part) { file_.write(part); };
  }

  bool has_places() const { return file_.has_places(); }

  void write(std::uint64_t part, std::vector<std::uint8_t> bytes) {
    const std::uint64_t offset = form_.offset(part);
    if (!form_.begin && has_places()) return file_.write_at(offset, bytes);
    const auto [position, end] =
        form_.begin ? std::pair(part, part + 1) : std::pair(offset, offset + bytes.size());
    const std::lock_guard lock(mutex_);
    waiting_.emplace(position, std::pair(end, std::move(bytes)));
    for (auto first = waiting_.begin(); first != waiting_.end() && first->first == next_;
         first = waiting_.erase(first)) {
      next_ = first->second.first;
      append_(first->second.second);
    }
  }

  void commit() { file_.commit(); }
  // The same with other bytes at the beginning.
  void commit(std::string_view head) {
    file_.rewind();
    file_.write(head.data(), head.size());
    file_.commit();
  }

private:
  OutputFile file_;
  const PartedForm form_;
  AppendPart append_;
  std::mutex mutex_; // of what follows
  std::uint64_t next_ = 0;
  std::map<std::uint64_t, std::pair<std::uint64_t, std::vector<std::uint8_t>>>
      waiting_; // by position: end, bytes
};

// A file that ranks write together: until it is committed all of them write into a temporary one beside it,
// which rank 0 has made (UntilCommit::named).
class SharedFile {
public:
  // Collective (ranks.h). Throws Error(output).
  SharedFile(const std::string& path, PartedForm form, Ranks& ranks);
  ~SharedFile() {
    if (file_ >= 0) ::close(file_);
  }
  SharedFile(const SharedFile&) = delete;
  SharedFile& operator=(const SharedFile&) = delete;

  // By any thread. Throws Error(output).
  void write(std::uint64_t part, std::vector<std::uint8_t> bytes) const;
  // Collective, when this rank writes no more: what it wrote is there for others. Throws Error(output): some
  // file systems say only now that something wasn't written.
  void close() {
    if (::close(std::exchange(file_, -1)) != 0) fail("can't be written");
  }
  // By rank 0, when all ranks have closed it. Throws Error(output).
  void commit();

private:
  [[noreturn]] void fail(const char* doing) const;

  const std::string path_;
  const PartedForm form_;
  std::optional<OutputFile> made_; // rank 0's
  std::string temporary_;          // its name until it is committed
  int file_ = -1;                  // descriptor of the temporary file
};

// Throws Error(usage) for what several ranks and --resume can't write: anything but a regular file.
void check_is_file(const std::string& path);

// --- What --resume keeps: outputs appear whole, so what is there is finished -----------------------------

// described: pictures whose own texts say that they are what would be made.
enum class Resume { off, described, all };

// What a file that is there must be like to be kept.
struct KnownBy {
  std::string text{};                   // at its beginning, or near it
  std::optional<std::uint64_t> bytes{}; // its size
};

// Whether a regular file that can be read is there and is like that.
bool is_kept(const std::string& path, const KnownBy& known_by);

} // namespace masu
