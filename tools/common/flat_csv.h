// A report as two lines of CSV.
#pragma once

#include <nlohmann/json.hpp>

#include <string>

namespace masu {

// The names, those of nested keys joined by points, and the values: what a report doesn't have (null) is
// empty, text is quoted where it must be.
std::string csv_of(const nlohmann::ordered_json& report);

} // namespace masu
