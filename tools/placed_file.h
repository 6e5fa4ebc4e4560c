// Files whose parts are made in any order.
#pragma once

#include "libscene/file/output_file.h"
#include "tools/in_order.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace masu {

// Bytes and their offset in a file.
struct FilePart {
  std::uint64_t offset = 0;
  std::vector<std::uint8_t> bytes;

  std::uint64_t end() const { return offset + bytes.size(); }
};

// Begins with `head`, which parts follow without gaps. Each is written when it comes, by any thread; where
// the output has no places, as a pipe, when all before it have come. Throws Error(output).
class PlacedFile {
public:
  explicit PlacedFile(const std::string& path, std::string_view head = {})
      : file_(path), in_order_(head.size()) {
    file_.write(head.data(), head.size());
  }

  void write(FilePart part) {
    if (file_.has_places()) return file_.write_at(part.offset, part.bytes);
    const std::uint64_t offset = part.offset, end = part.end();
    in_order_.add(offset, end, std::move(part.bytes), [&](const auto& bytes) { file_.write(bytes); });
  }
  void commit() { file_.commit(); }
  // The same with another head of the same size; that of an output without places is written already.
  void commit(std::string_view head) {
    if (!head.empty()) {
      file_.rewind();
      file_.write(head.data(), head.size());
    }
    file_.commit();
  }

private:
  OutputFile file_;
  InOrder<std::vector<std::uint8_t>> in_order_;
};

} // namespace masu
