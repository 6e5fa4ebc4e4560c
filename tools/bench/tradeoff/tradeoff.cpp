#include "tools/bench/tradeoff/tradeoff.h"

#include "libscene/base/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace masu {
namespace {

template <class Value>
using Names = std::vector<std::pair<const char*, Value>>;
template <class Value>
const Names<Value> names_of{};
template <>
const Names<Precision> names_of<Precision>{
    {"fast", Precision::fast}, {"robust", Precision::robust}, {"double", Precision::doubled}};
template <>
const Names<StopRule> names_of<StopRule>{{"proven", StopRule::proven},
                                         {"first-cell-hit", StopRule::first_cell}};
template <>
const Names<StructureKind> names_of<StructureKind>{{"none", StructureKind::uniform},
                                                   {"x", StructureKind::x},
                                                   {"balance", StructureKind::balance},
                                                   {"irregular", StructureKind::irregular},
                                                   {"bvh", StructureKind::hierarchy}};
template <>
const Names<Overlap> names_of<Overlap>{{"box", Overlap::box}, {"exact", Overlap::exact}};

} // namespace

template <class Value>
const char* name_of(Value value) {
  return std::ranges::find(names_of<Value>, value, &Names<Value>::value_type::second)->first;
}
template const char* name_of(StopRule);
template const char* name_of(StructureKind);
template const char* name_of(Overlap);

template <class Value>
Value named(const std::string& text) {
  std::string names;
  for (const auto& [name, value] : names_of<Value>) {
    if (text == name) return value;
    names += (names.empty() ? "" : ", ") + std::string(name);
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
