// What a step to a cell or a node and a test of a primitive cost: the one model by which structures are built
// and chosen.
//
// Costs are relative to each other, not seconds. What is chosen among is compared by counts of rays that were
// traced; what is built is compared by what random lines are expected to meet (Crofton), where a box stands
// for what it holds. The two count differently, so builders have figures of their own, each fitted to the
// rates of what it builds.
#pragma once

#include "libgrid/structure/structure_options.h"

namespace masu {

struct UnitCosts {
  double step, test;
};

// Of counted rays, in steps to a cell of an irregular grid on that processor: rounded numbers by which the
// choice among structures is within a percent of the best for rates of nearest hits, measured on an H100 and
// on a core of its host: tools/bench/scripts/performance.sh measures it, performance_tables.py --fit prints
// those that would be best.
constexpr UnitCosts unit_costs(StructureKind kind, Processor processor) {
  const bool gpu = processor == Processor::gpu;
  switch (kind) {
  case StructureKind::uniform:
    return gpu ? UnitCosts{1, 0.45} : UnitCosts{1.2, 1.2};
  case StructureKind::hierarchy:
    return gpu ? UnitCosts{0.8, 1.5} : UnitCosts{1, 0.5};
  default:
    return gpu ? UnitCosts{1, 0.9} : UnitCosts{1, 3};
  }
}

// Of a random line through the middle of the primitives (division.cpp): in steps from voxel to voxel.
inline constexpr UnitCosts division_costs{1, 2.5};

// Of a box of an irregular grid that is divided (splitter.h): in tests, as its option step_cost has it. The
// step to an empty cell is half of it, since empty cells are joined further (expand_passes.h).
inline constexpr UnitCosts splitting_costs{5, 1};
inline constexpr double empty_step = 0.5;

// Of a binary hierarchy that is collapsed (collapse_passes.h): in visits to a node of eight boxes. Splits
// before that count references alone, which leaves no step to weigh them against.
inline constexpr UnitCosts collapse_unit_costs{1, 0.3};

} // namespace masu
