#include "tools/common/flat_csv.h"

#include "tools/common/printable.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace masu {
namespace {

std::string quoted_where_needed(const std::string& text) {
  std::string line = printable(text);
  if (line.find_first_of(",\"") == std::string::npos) return line;
  std::string quoted = "\"";
  for (const char c : line)
    quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

} // namespace

std::string csv_of(const nlohmann::ordered_json& report) {
  std::vector<std::string> names, values;
  const auto flat = report.flatten();
  for (const auto& [path, value] : flat.items()) {
    std::string name = path.substr(1);
    std::replace(name.begin(), name.end(), '/', '.');
    names.push_back(name);
    values.push_back(value.is_null()     ? std::string()
                     : value.is_string() ? quoted_where_needed(value.get<std::string>())
                                         : value.dump());
  }
  return fmt::format("{}\n{}\n", fmt::join(names, ","), fmt::join(values, ","));
}

} // namespace masu
