#include "tools/bench/tradeoff/tradeoff.h"

#include "libscene/base/error.h"

#include <fmt/format.h>

#include <array>

namespace masu {
namespace {

constexpr auto values_of(Precision) {
  return std::array{Precision::fast, Precision::robust, Precision::doubled};
}
constexpr auto values_of(StopRule) {
  return std::array{StopRule::proven, StopRule::first_cell};
}
constexpr auto values_of(StructureKind) {
  return std::array{StructureKind::uniform, StructureKind::x, StructureKind::balance,
                    StructureKind::irregular, StructureKind::hierarchy};
}
constexpr auto values_of(Overlap) {
  return std::array{Overlap::box, Overlap::exact};
}

} // namespace

const char* name_of(StopRule stop) {
  return stop == StopRule::proven ? "proven" : "first-cell-hit";
}

const char* name_of(StructureKind merge) {
  switch (merge) {
  case StructureKind::automatic:
    return "auto";
  case StructureKind::uniform:
    return "none";
  case StructureKind::x:
    return "x";
  case StructureKind::balance:
    return "balance";
  case StructureKind::irregular:
    return "irregular";
  case StructureKind::hierarchy:
    return "bvh";
  case StructureKind::fastest:
    return "fastest";
  }
  return "";
}

const char* name_of(Overlap overlap) {
  return overlap == Overlap::box ? "box" : "exact";
}

template <class Value>
Value named(const std::string& text) {
  std::string names;
  for (const Value value : values_of(Value{})) {
    if (text == name_of(value)) return value;
    names += (names.empty() ? "" : ", ") + std::string(name_of(value));
  }
  throw Error(ErrorCode::usage, text, "isn't one of " + names);
}
template Precision named(const std::string&);
template StopRule named(const std::string&);
template StructureKind named(const std::string&);
template Overlap named(const std::string&);

std::string method_of(const Configuration& configuration) {
  return name_of(configuration.precision) +
         std::string(configuration.stop == StopRule::proven ? "" : ", first cell hit");
}

std::string grid_of(const Configuration& configuration) {
  if (configuration.merge == StructureKind::hierarchy) return name_of(configuration.merge);
  const char* const merge =
      configuration.merge == StructureKind::uniform ? "uniform" : name_of(configuration.merge);
  const bool divided = configuration.merge != StructureKind::irregular || configuration.division != "auto";
  return fmt::format("{} {}{}", merge, divided ? configuration.division + " " : "",
                     name_of(configuration.overlap));
}

} // namespace masu
