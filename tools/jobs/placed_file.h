// Files whose parts are made in any order.
#pragma once

#include "libscene/file/output_file.h"
#include "tools/jobs/in_order.h"

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
// the output has no places, as a pipe, when all before it have come.
class PlacedFile {
public:
  // in_order: where a part belongs is known only when all before it have come. Throws Error(output).
  explicit PlacedFile(const std::string& path, std::string_view head = {}, bool in_order = false)
      : file_(path), is_in_order_(in_order), in_order_(head.size()) {
    file_.write(head.data(), head.size());
  }

  // Whether a part is written when it comes.
  bool has_places() const { return file_.has_places() && !is_in_order_; }
  void write(FilePart part) {
    const std::uint64_t end = part.end(); // before its bytes are moved away
    write(part.offset, end, std::move(part.bytes));
  }
  // Where parts come in order, offset and end need only order them.
  void write(std::uint64_t offset, std::uint64_t end, std::vector<std::uint8_t> bytes) {
    if (has_places()) return file_.write_at(offset, bytes);
    in_order_.add(offset, end, std::move(bytes), [&](const auto& part) { file_.write(part); });
  }
  void commit() { file_.commit(); }
  // The same with another head of the same size.
  void commit(std::string_view head) {
    file_.rewind();
    file_.write(head.data(), head.size());
    file_.commit();
  }

private:
  OutputFile file_;
  bool is_in_order_;
  InOrder<std::vector<std::uint8_t>> in_order_;
};

} // namespace masu
