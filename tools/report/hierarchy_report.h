// Statistics of a bounding volume hierarchy, for people and for scripts.
#pragma once

#include "libgrid/file/grid_file.h"

namespace masu {

enum class ReportFormat { table, json, csv };

// To standard output. `file` holds a hierarchy. histogram: also the number of boxes of references by how many
// they hold, [references, boxes] each, and by depth.
void print_hierarchy_report(const GridFile& file, ReportFormat format, bool histogram);

} // namespace masu
