#include "tools/lists/hit_file.h"

#include "libscene/base/error.h"
#include "tools/lists/npy.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstring>

namespace masu {
namespace {

constexpr std::size_t records_a_task = 1 << 14;

char kind_of(const RecordField& field) {
  return field.type[2]; // '<f4'
}
std::size_t number_bytes(const RecordField& field) {
  return static_cast<std::size_t>(field.type[3] - '0');
}

// At least as many characters as a number of a field has, with what follows it.
std::size_t longest_number(const RecordField& field) {
  return kind_of(field) == 'f' ? 32 : 16;
}

template <class Number>
void append_number(std::vector<std::uint8_t>& text, const std::uint8_t* bytes) {
  Number number;
  std::memcpy(&number, bytes, sizeof number);
  char written[32];
  char* const end = fmt::format_to(written, "{}", number); // the shortest that reads back the same
  text.insert(text.end(), &written[0], end);
}

// A line; the last comma becomes its end.
void append_line(std::vector<std::uint8_t>& text, const std::vector<RecordField>& fields,
                 const std::uint8_t* record) {
  for (const RecordField& field : fields) {
    for (const std::uint8_t* const end = record + field.bytes; record != end; record += number_bytes(field)) {
      if (kind_of(field) == 'f')
        append_number<float>(text, record);
      else if (kind_of(field) == 'i')
        append_number<std::int32_t>(text, record);
      else
        append_number<std::uint8_t>(text, record);
      text.push_back(',');
    }
  }
  text.back() = '\n';
}

} // namespace

void check_hits_name(const char* option, const std::string& path) {
  if (path.ends_with(".f64"))
    throw Error(ErrorCode::usage, option,
                "has no numbers of 64 bits: let the name end in .npy or .csv, or give it no ending");
}

HitFormat::HitFormat(const std::string& path, std::vector<RecordField> fields)
    : path_(path), form_(path.ends_with(".npy")   ? Form::npy
                         : path.ends_with(".csv") ? Form::text
                                                  : Form::records),
      fields_(std::move(fields)) {
  for (const RecordField& field : fields_) {
    record_bytes_ += field.bytes;
    longest_line_ += field.bytes / number_bytes(field) * longest_number(field);
  }
}

std::string HitFormat::head(std::uint64_t records) const {
  std::string text;
  if (form_ == Form::text) {
    for (const RecordField& field : fields_) {
      text += field.columns;
      text += &field == &fields_.back() ? '\n' : ',';
    }
    return text;
  }
  if (form_ == Form::records) return {};
  for (const RecordField& field : fields_)
    text += fmt::format("('{}', {}), ", field.name, field.type);
  return npy_header("[" + text + "]", records);
}

std::vector<std::uint8_t> HitFormat::encoded(std::vector<std::uint8_t> records) const {
  if (!is_text()) return records;
  const std::size_t count = records.size() / record_bytes_;
  std::vector<std::vector<std::uint8_t>> texts((count + records_a_task - 1) / records_a_task);
  tbb::parallel_for(std::size_t{0}, texts.size(), [&](std::size_t task) {
    const std::size_t end = std::min(count, (task + 1) * records_a_task);
    for (std::size_t i = task * records_a_task; i < end; ++i)
      append_line(texts[task], fields_, records.data() + i * record_bytes_);
  });
  std::vector<std::uint8_t> all;
  for (const auto& text : texts)
    all.insert(all.end(), text.begin(), text.end());
  return all;
}

// --- In parts ----------------------------------------------------------------------------------------------

// Room for every line before it.
std::uint64_t HitFormat::slot(std::uint64_t piece, std::uint64_t first) const {
  return piece * slot_head + first * longest_line_;
}

FileRange HitFormat::range(const std::string& partial, std::uint64_t piece, std::uint64_t first,
                           std::uint64_t all) const {
  if (is_text()) return {partial, slot(piece, first)};
  const std::uint64_t head_bytes = head(all).size();
  // The first one begins with the head.
  return {partial, first > 0 ? head_bytes + first * record_bytes_ : 0, head_bytes + all * record_bytes_};
}

FilePart HitFormat::part(std::uint64_t piece, std::uint64_t first, std::vector<std::uint8_t> records,
                         std::uint64_t all) const {
  const std::uint64_t offset = *range({}, piece, first, all).offset;
  if (is_text()) return in_slot({offset, encoded(std::move(records))});
  const std::string begin = first > 0 ? std::string() : head(all);
  records.insert(records.begin(), begin.begin(), begin.end());
  return {offset, std::move(records)};
}

void HitFormat::finish(std::span<const std::uint64_t> firsts, std::uint64_t all) const {
  const std::string partial = partial_name(path_), begin = head(all);
  if (!is_text()) {
    if (firsts.empty()) write_part(partial, {0, {begin.begin(), begin.end()}});
    return finish_partial(path_, begin.size() + all * record_bytes_);
  }
  OutputFile file(path_);
  file.write(begin.data(), begin.size());
  for (std::size_t i = 0; i < firsts.size(); ++i)
    file.write(
        read_slot(partial, slot(i, firsts[i]), slot(i + 1, i + 1 < firsts.size() ? firsts[i + 1] : all)));
  file.commit();
}

// --- By one process ----------------------------------------------------------------------------------------

HitFile::HitFile(const HitFormat& format, const std::string& path, std::optional<std::uint64_t> all)
    : format_(format), expected_(all.value_or(0)), file_(path, format.head(expected_), format.is_text()) {
  if (!all && path.ends_with(".npy") && !file_.has_places())
    throw Error(
        ErrorCode::output, path,
        "is a pipe, where a NumPy array can't begin before the number of rays is known: write .csv, or "
        "records without an ending");
}

void HitFile::write(std::uint64_t first, std::vector<std::uint8_t> records) {
  const std::uint64_t begin = format_.head(0).size(), offset = begin + first * format_.record_bytes(),
                      end = offset + records.size();
  file_.write(offset, end, format_.encoded(std::move(records)));
}

void HitFile::commit(std::uint64_t all) {
  if (all == expected_ || format_.head(all) == format_.head(expected_)) return file_.commit();
  file_.commit(format_.head(all));
}

} // namespace masu
