// gridstat --cells: a grid's cells, or a hierarchy's boxes, for other viewers and programs.
#pragma once

#include "libgrid/statistics/cells.h"

#include <string>

namespace masu {

struct CellExport {
  BoxFilter filter{};
  bool expanded = false;  // PLY: the boxes that rays leave cells through, instead of the cells' own
  bool wireframe = false; // PLY: edges instead of faces
};

// By the path's ending, .csv or .ply; written cell by cell, whole or not at all.
//
// CSV: a line of names, then a line for each cell: cell, min_x … max_z, expanded_min_x … expanded_max_z
// (scene units), references, occupied (0 or 1), voxels. Of a hierarchy: box (8 times its node, and its slot),
// depth, min_x … max_z, references (0 of a box around a node). PLY: binary, little-endian; 8 corners per cell
// with x y z (double), red green blue (dark for many references, light grey for none) and quality
// (references); 6 quads that face outwards, or 12 edges.
//
// Throws Error(usage, path, …) for more cells than a PLY can number, Error(output).
void export_cells(const StructureFile& file, const CellExport& options, const std::string& path);

} // namespace masu
