#include "tools/lists/hit_file.h"

#include "libscene/base/error.h"
#include "tools/common/number_list.h"
#include "tools/jobs/partial_file.h"
#include "tools/lists/npy.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstring>
#include <iterator>

namespace masu {
namespace {

constexpr std::size_t records_per_task = 1 << 14;

struct FieldFormat {
  const char* name;
  HitField field;
  const char* type; // as NumPy has it; the third character is the kind of its numbers, the fourth their bytes
  std::size_t bytes;
  const char* columns; // of CSV

  char kind() const { return type[2]; }
  std::size_t number_bytes() const { return static_cast<std::size_t>(type[3] - '0'); }
};
constexpr FieldFormat field_formats[] = {
    {"t", HitField::t, "'<f4'", 4, "t"},
    {"object", HitField::object, "'<i4'", 4, "object"},
    {"primitive", HitField::primitive, "'<i4'", 4, "primitive"},
    {"face", HitField::face, "'<i4'", 4, "face"},
    {"uv", HitField::uv, "'<f4', (2,)", 8, "u,v"},
    {"normal", HitField::normal, "'<f4', (3,)", 12, "nx,ny,nz"},
    {"occluded", HitField::occluded, "'|u1'", 1, "occluded"},
};

const FieldFormat& format_of(HitField field) {
  return *std::ranges::find(field_formats, field, &FieldFormat::field);
}

template <class Number>
void append_number(std::vector<std::uint8_t>& text, const std::uint8_t* bytes) {
  Number number;
  std::memcpy(&number, bytes, sizeof number);
  fmt::format_to(std::back_inserter(text), "{},", number); // the shortest that reads back the same
}

// A line; the last comma becomes its end.
void append_line(std::vector<std::uint8_t>& text, const std::vector<HitField>& fields,
                 const std::uint8_t* record) {
  for (const HitField field : fields) {
    const FieldFormat& format = format_of(field);
    for (const std::uint8_t* const end = record + format.bytes; record != end;
         record += format.number_bytes()) {
      if (format.kind() == 'f')
        append_number<float>(text, record);
      else if (format.kind() == 'i')
        append_number<std::int32_t>(text, record);
      else
        append_number<std::uint8_t>(text, record);
    }
  }
  text.back() = '\n';
}

} // namespace

std::vector<HitField> hit_fields(const std::string& names) {
  std::vector<HitField> fields;
  for (const std::string& name : split(names)) {
    const auto* const found = std::ranges::find(field_formats, name, &FieldFormat::name);
    if (found == std::end(field_formats))
      throw Error(ErrorCode::usage, "--write",
                  fmt::format("'{}' isn't one of t, object, primitive, face, uv, normal, occluded", name));
    if (std::ranges::count(fields, found->field) > 0)
      throw Error(ErrorCode::usage, "--write", fmt::format("has {} twice", name));
    fields.push_back(found->field);
  }
  return fields;
}

std::string usual_fields(HitName name) {
  return name == HitName::primitive ? "t,primitive" : name == HitName::face ? "t,face" : "t,object";
}

std::size_t bytes_of(HitField field) {
  return format_of(field).bytes;
}

void check_hits_name(const char* option, const std::string& path) {
  if (path.ends_with(".f64"))
    throw Error(ErrorCode::usage, option,
                "has no numbers of 64 bits: let the name end in .npy or .csv, or give it no ending");
}

HitFormat::HitFormat(const std::string& path, std::vector<HitField> fields)
    : form_(path.ends_with(".npy")   ? Form::npy
            : path.ends_with(".csv") ? Form::text
                                     : Form::records),
      fields_(std::move(fields)) {
  for (const HitField field : fields_) {
    const FieldFormat& format = format_of(field);
    record_bytes_ += format.bytes;
    // No number with what follows it is longer.
    longest_line_ += format.bytes / format.number_bytes() * (format.kind() == 'f' ? 32 : 16);
  }
}

std::string HitFormat::head(std::uint64_t records) const {
  std::string text;
  if (form_ == Form::records) return text;
  for (const HitField field : fields_)
    text += is_text() ? fmt::format("{},", format_of(field).columns)
                      : fmt::format("('{}', {}), ", format_of(field).name, format_of(field).type);
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

std::vector<std::uint8_t> HitFormat::part(std::vector<std::uint8_t> records, bool is_first,
                                          std::uint64_t all) const {
  if (!is_text()) {
    const std::string begin = is_first ? head(all) : std::string();
    records.insert(records.begin(), begin.begin(), begin.end());
    return records;
  }
  const std::size_t count = records.size() / record_bytes_;
  std::vector<std::vector<std::uint8_t>> texts((count + records_per_task - 1) / records_per_task);
  tbb::parallel_for(std::size_t{0}, texts.size(), [&](std::size_t task) {
    const std::size_t end = std::min(count, (task + 1) * records_per_task);
    for (std::size_t i = task * records_per_task; i < end; ++i)
      append_line(texts[task], fields_, records.data() + i * record_bytes_);
  });
  std::vector<std::uint8_t> all_texts;
  for (const auto& text : texts)
    all_texts.insert(all_texts.end(), text.begin(), text.end());
  return all_texts;
}

} // namespace masu
