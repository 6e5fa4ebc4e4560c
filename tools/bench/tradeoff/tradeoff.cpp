#include "tools/bench/tradeoff/tradeoff.h"

#include "libscene/base/error.h"

#include <fmt/format.h>

#include <array>

namespace masu {
namespace {

// The one of `values` whose name is `text`.
template <class Value, std::size_t count>
Value named(const std::string& text, const std::array<Value, count>& values) {
  std::string names;
  for (const Value value : values) {
    if (text == name_of(value)) return value;
    names += (names.empty() ? "" : ", ") + std::string(name_of(value));
  }
  throw Error(ErrorCode::usage, text, "isn't one of " + names);
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

Precision precision_named(const std::string& text) {
  return named(text, std::array{Precision::fast, Precision::robust, Precision::doubled});
}

StopRule stop_named(const std::string& text) {
  return named(text, std::array{StopRule::proven, StopRule::first_cell});
}

GridKind merge_named(const std::string& text) {
  return named(text, std::array{GridKind::uniform, GridKind::x, GridKind::balance, GridKind::irregular,
                                GridKind::hierarchy});
}

Overlap overlap_named(const std::string& text) {
  return named(text, std::array{Overlap::box, Overlap::exact});
}

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
