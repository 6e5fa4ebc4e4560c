#include "tools/lists/hit_file.h"

#include "libscene/base/error.h"
#include "libscene/base/parallel.h"
#include "tools/common/number_list.h"
#include "tools/lists/npy.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <iterator>
#include <span>

namespace masu {
namespace {

constexpr std::size_t records_per_task = 1 << 14;

template <class Number>
void append_number(std::vector<std::uint8_t>& text, const std::uint8_t* bytes) {
  Number number;
  std::memcpy(&number, bytes, sizeof number);
  fmt::format_to(std::back_inserter(text), "{},", number); // the shortest that reads back the same
}

struct NumberFormat {
  const char* type; // as NumPy has it
  std::size_t bytes;
  void (*append)(std::vector<std::uint8_t>& text, const std::uint8_t* bytes);
  std::size_t longest; // in text, with what follows it, or more
};
constexpr NumberFormat float32{"<f4", 4, append_number<float>, 32},
    float64{"<f8", 8, append_number<double>, 32}, int32{"<i4", 4, append_number<std::int32_t>, 16},
    byte{"|u1", 1, append_number<std::uint8_t>, 16};

struct FieldFormat {
  const char* name;
  HitField field;
  const NumberFormat& number;
  std::size_t numbers;
  const char* columns[3]; // of CSV
  bool is_of_ray = false; // not of each hit

  // Of a ray with a row of so many hits, or for 0 with one.
  std::size_t all_numbers(std::uint32_t row) const { return row == 0 || is_of_ray ? numbers : numbers * row; }

  std::string numpy_type(std::uint32_t row) const {
    std::string shape = row == 0 || is_of_ray ? "" : fmt::format("{},", row);
    if (numbers > 1) shape += fmt::format("{},", numbers);
    return shape.empty() ? fmt::format("'{}'", number.type) : fmt::format("'{}', ({})", number.type, shape);
  }
  std::string csv_columns() const {
    std::string names;
    for (std::size_t i = 0; i < numbers; ++i)
      names += fmt::format("{},", columns[i]);
    return names;
  }
};
constexpr FieldFormat field_formats[] = {
    {"t", HitField::t, float32, 1, {"t"}},
    {"t64", HitField::t64, float64, 1, {"t64"}},
    {"object", HitField::object, int32, 1, {"object"}},
    {"primitive", HitField::primitive, int32, 1, {"primitive"}},
    {"face", HitField::face, int32, 1, {"face"}},
    {"uv", HitField::uv, float32, 2, {"u", "v"}},
    {"normal", HitField::normal, float32, 3, {"nx", "ny", "nz"}},
    {"front", HitField::front, byte, 1, {"front"}},
    {"count", HitField::count, int32, 1, {"count"}, true},
    {"inside", HitField::inside, byte, 1, {"inside"}, true},
    {"occluded", HitField::occluded, byte, 1, {"occluded"}, true},
};

const FieldFormat& format_of(HitField field) {
  return *std::ranges::find(field_formats, field, &FieldFormat::field);
}

} // namespace

std::vector<HitField> hit_fields(const std::string& names) {
  std::vector<HitField> fields;
  for (const std::string& name : split(names)) {
    const auto* const found = std::ranges::find(field_formats, name, &FieldFormat::name);
    if (found == std::end(field_formats))
      throw Error(ErrorCode::usage, "--write", fmt::format("'{}' isn't one of {}", name, hit_field_names));
    if (std::ranges::count(fields, found->field) > 0)
      throw Error(ErrorCode::usage, "--write", fmt::format("has {} twice", name));
    fields.push_back(found->field);
  }
  return fields;
}

std::string usual_fields(HitName name) {
  return name == HitName::primitive ? "t,primitive" : name == HitName::face ? "t,face" : "t,object";
}

std::size_t bytes_of(HitField field, std::uint32_t row) {
  return format_of(field).all_numbers(row) * format_of(field).number.bytes;
}

void check_hits_name(const char* option, const std::string& path) {
  if (path.ends_with(".f64"))
    throw Error(ErrorCode::usage, option,
                "would be numbers of 64 bits alone: let the name end in .npy or .csv, or give it no ending");
}

HitFormat::HitFormat(const std::string& path, std::vector<HitField> fields, std::uint32_t row)
    : form_(path.ends_with(".npy")   ? Form::npy
            : path.ends_with(".csv") ? Form::text
                                     : Form::records),
      fields_(std::move(fields)), row_(row) {
  if (has_lines_of_hits()) {
    fields_.insert(fields_.begin(), HitField::count);
    longest_line_ = std::size_t{row} * 32; // of ray and hit
  }
  for (const HitField field : fields_) {
    const FieldFormat& format = format_of(field);
    record_bytes_ += bytes_of(field, row);
    longest_line_ += format.all_numbers(row) * format.number.longest;
  }
}

std::string HitFormat::head(std::uint64_t records) const {
  std::string text;
  if (form_ == Form::records) return text;
  if (has_lines_of_hits()) text = "ray,hit,";
  for (const HitField field : fields_) {
    if (has_lines_of_hits() && field == HitField::count) continue;
    text += is_text() ? format_of(field).csv_columns()
                      : fmt::format("('{}', {}), ", format_of(field).name, format_of(field).numpy_type(row_));
  }
  // Blanks stand where a larger number would have digits.
  if (!is_text()) return npy_header("[" + text + "]", fmt::format("{:<20},", records));
  text.back() = '\n';
  return text;
}

PartedForm HitFormat::parts(std::uint64_t count, std::function<std::uint64_t(std::uint64_t part)> first,
                            std::uint64_t records) const {
  const std::string begin = head(records);
  if (is_text())
    return {count,
            [first, longest = longest_line_](std::uint64_t part) {
              return part * slot_head + first(part) * longest;
            },
            0,
            [begin](OutputFile& file) {
              file.write(begin.data(), begin.size());
              return [&file](std::span<const std::uint8_t> part) { file.write(part); };
            }};
  const std::uint64_t head_bytes = begin.size();
  return {count,
          [first, head_bytes, each = record_bytes_](std::uint64_t part) {
            return part > 0 ? head_bytes + first(part) * each : 0;
          },
          head_bytes + records * record_bytes_};
}

KnownBy HitFormat::known_by(std::optional<std::uint64_t> records) const {
  if (is_text() || !records) return {is_text() ? head(0) : ""};
  const std::string begin = head(*records);
  return {begin, begin.size() + *records * record_bytes_};
}

void HitFormat::append_lines(std::vector<std::uint8_t>& text, std::uint64_t ray,
                             const std::uint8_t* record) const {
  const bool of_hits = has_lines_of_hits();
  std::uint32_t lines = 1;
  if (of_hits) std::memcpy(&lines, record, sizeof lines);
  for (std::uint32_t hit = 0; hit < lines; ++hit) {
    if (of_hits) fmt::format_to(std::back_inserter(text), "{},{},", ray, hit);
    const std::uint8_t* array = record + (of_hits ? sizeof lines : 0);
    for (const HitField field : std::span(fields_).subspan(of_hits ? 1 : 0)) {
      const FieldFormat& format = format_of(field);
      const std::size_t bytes = format.number.bytes;
      for (std::size_t n = hit * format.numbers; n != (hit + 1) * format.numbers; ++n)
        format.number.append(text, array + n * bytes);
      array += bytes_of(field, row_);
    }
    text.back() = '\n'; // instead of the last comma
  }
}

std::vector<std::uint8_t> HitFormat::part(std::vector<std::uint8_t> records, std::uint64_t first,
                                          std::uint64_t all) const {
  if (!is_text()) {
    const std::string begin = first == 0 ? head(all) : std::string();
    records.insert(records.begin(), begin.begin(), begin.end());
    return records;
  }
  const std::size_t count = records.size() / record_bytes_;
  std::vector<std::vector<std::uint8_t>> texts((count + records_per_task - 1) / records_per_task);
  parallel_for(texts.size(), [&](std::size_t task) {
    const std::size_t end = std::min(count, (task + 1) * records_per_task);
    for (std::size_t i = task * records_per_task; i < end; ++i)
      append_lines(texts[task], first + i, records.data() + i * record_bytes_);
  });
  std::vector<std::uint8_t> all_texts;
  for (const auto& text : texts)
    all_texts.insert(all_texts.end(), text.begin(), text.end());
  return all_texts;
}

} // namespace masu
