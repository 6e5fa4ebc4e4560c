// Files of hits, a record for each ray. The end of the name says how they are written: .npy, a NumPy array;
// .csv, a line of text for each after a line of the columns' names; else the records alone.
#pragma once

#include "tools/jobs/partial_file.h"
#include "tools/jobs/placed_file.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace masu {

// A field of a record: numbers of 8 or 32 bits.
struct RecordField {
  const char* name;
  const char* type; // as NumPy has it, such as '<f4', (2,)
  std::size_t bytes;
  const char* columns; // of CSV
};

// Throws Error(usage, option, …) for a name that promises what isn't written: numbers of 64 bits.
void check_hits_name(const char* option, const std::string& path);

class HitFormat {
public:
  HitFormat(const std::string& path, std::vector<RecordField> fields);

  bool is_text() const { return form_ == Form::text; }
  std::size_t record_bytes() const { return record_bytes_; }
  // What the file begins with, as long for any number of records.
  std::string head(std::uint64_t records) const;
  // Records as they are in the file.
  std::vector<std::uint8_t> encoded(std::vector<std::uint8_t> records) const;

  // --- In parts (partial_file.h): pieces of records, in slots where they are text
  // Where a piece is, whose first record that is, in the partial file.
  FileRange range(const std::string& partial, std::uint64_t piece, std::uint64_t first,
                  std::uint64_t all) const;
  FilePart part(std::uint64_t piece, std::uint64_t first, std::vector<std::uint8_t> records,
                std::uint64_t all) const;
  // When all pieces are there, whose first records are these. Throws Error(output).
  void finish(std::span<const std::uint64_t> firsts, std::uint64_t all) const;

private:
  enum class Form { records, npy, text };
  std::uint64_t slot(std::uint64_t piece, std::uint64_t first) const;

  std::string path_;
  Form form_;
  std::vector<RecordField> fields_;
  std::size_t record_bytes_ = 0, longest_line_ = 0;
};

// A file that this process writes alone.
class HitFile {
public:
  // all: how many records there will be, where that is known. Throws Error(output).
  HitFile(const HitFormat& format, const std::string& path, std::optional<std::uint64_t> all);
  // Records from a ray on, in any order, by any thread.
  void write(std::uint64_t first, std::vector<std::uint8_t> records);
  void commit(std::uint64_t all);

private:
  const HitFormat format_;
  const std::uint64_t expected_;
  PlacedFile file_;
};

} // namespace masu
