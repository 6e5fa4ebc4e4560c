// Statistics of a grid or a hierarchy: what gridstat prints, and the keys of gridstat --json.
#pragma once

#include "libgrid/file/grid_file.h"
#include "libgrid/statistics/hierarchy_statistics.h"
#include "libgrid/statistics/map_statistics.h"
#include "libgrid/statistics/statistics.h"

#include <nlohmann/json_fwd.hpp>

namespace masu {

// Of a grid: of its cells and references, and of the voxel map.
struct Statistics {
  GridStatistics cells;
  MapStatistics map;
  Vec3i division{}; // in the smallest voxels

  // Looks at all that the grid holds.
  explicit Statistics(const GridFile& file);

  // Coefficient of variation of the references of occupied cells: 0 when all list the same number.
  double evenness() const { return cells.mean > 0 ? cells.stddev / cells.mean : 0; }
};

// Of a grid. histogram: also the number of occupied cells by their references, [references, cells] each.
nlohmann::ordered_json grid_report(const GridFile& file, const Statistics& statistics, bool histogram);

// Of a hierarchy. histogram: also the number of boxes of references by how many they hold, [references,
// boxes] each, and by depth.
nlohmann::ordered_json hierarchy_report(const GridFile& file, const HierarchyStatistics& statistics,
                                        bool histogram);

enum class ReportFormat { table, json, csv };

// Of a grid or a hierarchy, to standard output. CSV has the same columns for every grid. histogram: also the
// number of occupied cells by references, and of merged cells by size; of a hierarchy as above.
void print_grid_report(const GridFile& file, ReportFormat format, bool histogram);

inline double percent(std::uint64_t part, std::uint64_t whole) {
  return 100.0 * static_cast<double>(part) / static_cast<double>(whole);
}

} // namespace masu
