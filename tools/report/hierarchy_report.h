// Statistics of a bounding volume hierarchy, for people and for scripts.
#pragma once

#include "libgrid/file/grid_file.h"

namespace masu {

enum class ReportFormat { table, json, csv };

// To standard output. `file` holds a hierarchy.
void print_hierarchy_report(const GridFile& file, ReportFormat format);

} // namespace masu
