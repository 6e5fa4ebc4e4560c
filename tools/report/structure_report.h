// Statistics of a grid or a hierarchy: what gridstat prints, and the keys of gridstat --json.
#pragma once

#include "libgrid/file/structure_file.h"

#include <nlohmann/json_fwd.hpp>

namespace masu {

// Looks at all that the file holds. histogram: also the number of occupied cells by their references,
// [references, cells] each; of a hierarchy of boxes of references by how many they hold, and by depth.
nlohmann::ordered_json structure_report(const StructureFile& file, bool histogram);

enum class ReportFormat { table, json, csv };

// Of a grid or a hierarchy, to standard output. CSV has the same columns for every grid. histogram: also the
// number of occupied cells by references, and of merged cells by size; of a hierarchy as above.
void print_structure_report(const StructureFile& file, ReportFormat format, bool histogram);

inline double percent(std::uint64_t part, std::uint64_t whole) {
  return 100.0 * static_cast<double>(part) / static_cast<double>(whole);
}

} // namespace masu
