// Stretching cells over their neighbours, after Pérard-Gayot, Kalojanov & Slusallek, "GPU Ray Tracing using
// Irregular Grids", CGF 36(2), 2017: a ray that leaves a expanded cell has passed neighbours that would have
// told it nothing new.
#pragma once

#include "libgrid/build/build.h"

namespace masu {

// Stretches the cells of a merged grid, over neighbours that are empty or list nothing but what the cell
// lists itself, one layer of neighbours along each direction a pass; neighbours count as they are after the
// pass before. Doesn't depend on the number of threads.
void stretch(Grid& grid, int passes);

} // namespace masu
