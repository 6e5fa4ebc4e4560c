#include "tools/lists/hit_fields.h"

#include "libscene/base/error.h"

#include <fmt/format.h>

#include <algorithm>

namespace masu {
namespace {

struct FieldFormat {
  const char* name;
  HitField field;
  const char* type; // as NumPy has it
  std::size_t bytes;
  const char* columns = nullptr; // of CSV, where it has several
};
constexpr FieldFormat field_formats[] = {
    {"t", HitField::t, "'<f4'", 4},
    {"object", HitField::object, "'<i4'", 4},
    {"primitive", HitField::primitive, "'<i4'", 4},
    {"face", HitField::face, "'<i4'", 4},
    {"uv", HitField::uv, "'<f4', (2,)", 8, "u,v"},
    {"normal", HitField::normal, "'<f4', (3,)", 12, "nx,ny,nz"},
    {"occluded", HitField::occluded, "'|u1'", 1},
};

const FieldFormat& format_of(HitField field) {
  return *std::ranges::find(field_formats, field, &FieldFormat::field);
}

} // namespace

std::vector<RecordField> record_fields(const std::vector<HitField>& fields) {
  std::vector<RecordField> of_record;
  for (const HitField field : fields) {
    const FieldFormat& format = format_of(field);
    of_record.push_back(
        {format.name, format.type, format.bytes, format.columns != nullptr ? format.columns : format.name});
  }
  return of_record;
}

std::vector<HitField> hit_fields(const std::string& names) {
  std::vector<HitField> fields;
  for (std::size_t begin = 0; begin <= names.size();) {
    const std::size_t end = std::min(names.find(',', begin), names.size());
    const std::string name = names.substr(begin, end - begin);
    const auto* const found =
        std::ranges::find_if(field_formats, [&](const auto& f) { return name == f.name; });
    if (found == std::end(field_formats))
      throw Error(ErrorCode::usage, "--write",
                  fmt::format("'{}' isn't one of t, object, primitive, face, uv, normal, occluded", name));
    if (std::ranges::count(fields, found->field) > 0)
      throw Error(ErrorCode::usage, "--write", fmt::format("has {} twice", name));
    fields.push_back(found->field);
    begin = end + 1;
  }
  return fields;
}

std::string usual_fields(HitName name) {
  return name == HitName::primitive ? "t,primitive" : name == HitName::face ? "t,face" : "t,object";
}

} // namespace masu
