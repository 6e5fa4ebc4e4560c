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
constexpr auto values_of(GridKind) {
  return std::array{GridKind::uniform, GridKind::x, GridKind::balance, GridKind::irregular,
                    GridKind::hierarchy};
}
constexpr auto values_of(Overlap) {
  return std::array{Overlap::box, Overlap::exact};
}

} // namespace

const char* name_of(StopRule stop) {
  return stop == StopRule::proven ? "proven" : "first-cell-hit";
}

const char* name_of(GridKind merge) {
  switch (merge) {
  case GridKind::automatic:
    return "auto";
  case GridKind::uniform:
    return "none";
  case GridKind::x:
    return "x";
  case GridKind::balance:
    return "balance";
  case GridKind::irregular:
    return "irregular";
  case GridKind::hierarchy:
    return "bvh";
  case GridKind::fastest:
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
template GridKind named(const std::string&);
template Overlap named(const std::string&);

std::string method_of(const Configuration& configuration) {
  return name_of(configuration.precision) +
         std::string(configuration.stop == StopRule::proven ? "" : ", first cell hit");
}

std::string grid_of(const Configuration& configuration) {
  if (configuration.merge == GridKind::hierarchy) return name_of(configuration.merge);
  const char* const merge =
      configuration.merge == GridKind::uniform ? "uniform" : name_of(configuration.merge);
  const bool divided = configuration.merge != GridKind::irregular || configuration.division != "auto";
  return fmt::format("{} {}{}", merge, divided ? configuration.division + " " : "",
                     name_of(configuration.overlap));
}

} // namespace masu
