// Statistics of a bounding volume hierarchy, for people and for scripts.
#pragma once

#include "libgrid/file/grid_file.h"
#include "libgrid/statistics/hierarchy_statistics.h"

#include <nlohmann/json_fwd.hpp>

namespace masu {

enum class ReportFormat { table, json, csv };

// The keys of gridstat --json. `file` holds a hierarchy. histogram: also the number of boxes of references by
// how many they hold, [references, boxes] each, and by depth.
nlohmann::ordered_json hierarchy_report(const GridFile& file, const HierarchyStatistics& statistics,
                                        bool histogram);

// To standard output.
void print_hierarchy_report(const GridFile& file, ReportFormat format, bool histogram);

} // namespace masu
