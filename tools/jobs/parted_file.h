// Files whose parts are made in any order, by several threads.
#pragma once

#include "libscene/file/output_file.h"

#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace masu {

// Appends the next part to a file.
using AppendPart = std::function<void(std::span<const std::uint8_t> part)>;

// How numbered parts make a file. Either the offset of each is known before it is made; or parts follow each
// other, and then `begin` isn't null.
struct PartedForm {
  std::uint64_t count = 0; // parts
  // Of a part in the file. Of parts that follow each other: in OUT.partial (partial_file.h), where each has a
  // slot with room for it.
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

} // namespace masu
