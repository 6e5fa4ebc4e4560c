// Files of hits, a record for each ray. The end of the name says how they are written: .npy, a NumPy array;
// .csv, a line of text for each after a line of the columns' names, or for rays with rows of hits a line for
// each hit; else the records alone.
#pragma once

#include "renderer/render_pixel.h"
#include "tools/jobs/parted_file.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace masu {

// What is written for a ray, one field after the other: t (float), t64 (double), object, primitive and face
// (int32, -1 for a miss), uv (2 floats), normal (3 floats), front (1 byte), each of them for every hit of a
// row; count (int32), inside, occluded (1 byte).
enum class HitField { t, t64, object, primitive, face, uv, normal, front, count, inside, occluded };
inline constexpr const char* hit_field_names =
    "t, t64, object, primitive, face, uv, normal, front, count, inside, occluded";

// Of a list such as "t,object". Throws Error(usage, --write, …).
std::vector<HitField> hit_fields(const std::string& names);
// The names of what is written by default: t and what is hit.
std::string usual_fields(HitName name);
// `row`: hits per ray; 0 where there is one, without a dimension of its own.
std::size_t bytes_of(HitField field, std::uint32_t row);

// Throws Error(usage, option, …) for a name that promises what isn't written: numbers of 64 bits.
void check_hits_name(const char* option, const std::string& path);

class HitFormat {
public:
  HitFormat(const std::string& path, std::vector<HitField> fields, std::uint32_t row);

  bool is_text() const { return form_ == Form::text; }
  // Of a record: those that were given; where text has a line for each hit, first count, which isn't written.
  const std::vector<HitField>& fields() const { return fields_; }
  std::size_t record_bytes() const { return record_bytes_; }
  // What the file begins with, as long for any number of records.
  std::string head(std::uint64_t records) const;

  // Of so many parts of `records` records. first(part): the index of a part's first record, or for the number
  // of parts that of all records.
  PartedForm parts(std::uint64_t count, std::function<std::uint64_t(std::uint64_t part)> first,
                   std::uint64_t records) const;
  // What a file of so many records is known by, or of how many isn't known.
  KnownBy known_by(std::optional<std::uint64_t> records) const;
  // A part's bytes: its records as they are in the file, of `all` records; `first` is the index of the first.
  // The first part has the head, but for text.
  std::vector<std::uint8_t> part(std::vector<std::uint8_t> records, std::uint64_t first,
                                 std::uint64_t all) const;

private:
  enum class Form { records, npy, text };

  bool has_lines_of_hits() const { return is_text() && row_ > 0; }
  // Of a ray: one, or one for each of its hits.
  void append_lines(std::vector<std::uint8_t>& text, std::uint64_t ray, const std::uint8_t* record) const;

  Form form_;
  std::vector<HitField> fields_;
  std::uint32_t row_;
  std::size_t record_bytes_ = 0, longest_line_ = 0;
};

} // namespace masu
