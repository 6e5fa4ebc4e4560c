// A grid, a hierarchy or none, known when it is traced: for what is compared with, not for speed. One kernel
// of each kind serves all of them, and both rules by which a search ends.
#pragma once

#include "libgrid/structure/structure_records.h"
#include "libgrid/trace/trace.h"

namespace masu {

enum class StructureForm { none, uniform, merged, hierarchy };

// Hierarchy: HierarchyView, or on a GPU LeafHierarchyView.
template <class Real, class Hierarchy = HierarchyView<Real>>
struct AnyStructure {
  StructureForm form = StructureForm::none;
  StopRule stop = StopRule::proven; // with a grid of cells; anything else is proven
  GridView<Real> uniform{};
  MergedGridView<Real> merged{};
  Hierarchy hierarchy{};
};

inline StructureForm form_of(const StructureRecords& structure) {
  return structure.is_hierarchy ? StructureForm::hierarchy
         : structure.is_merged  ? StructureForm::merged
                                : StructureForm::uniform;
}
template <class Real>
AnyStructure<Real> any_structure(const StructureRecords& structure) {
  AnyStructure<Real> any{form_of(structure)};
  if (any.form == StructureForm::uniform) any.uniform = view_of<Real>(structure);
  if (any.form == StructureForm::merged) any.merged = merged_view_of<Real>(structure);
  if (any.form == StructureForm::hierarchy) any.hierarchy = hierarchy_view_of<Real>(structure);
  return any;
}

template <class View>
inline constexpr bool is_any_structure = false;
template <class Real, class Hierarchy>
inline constexpr bool is_any_structure<AnyStructure<Real, Hierarchy>> = true;

template <class Real, class Hierarchy>
MASU_HD inline StopRule stop_rule(const AnyStructure<Real, Hierarchy>& any) {
  return any.form == StructureForm::hierarchy ? StopRule::proven : any.stop;
}

template <class Real, class Hierarchy, class Visitor>
MASU_HD inline void visit(const AnyStructure<Real, Hierarchy>& any, const ClippedRay<Real>& near,
                          std::uint32_t primitives, Visitor& visitor) {
  switch (any.form) {
  case StructureForm::none:
    return visit(NoStructure{}, near, primitives, visitor);
  case StructureForm::uniform:
    return visit(any.uniform, near, primitives, visitor);
  case StructureForm::merged:
    return visit(any.merged, near, primitives, visitor);
  case StructureForm::hierarchy:
    return visit(any.hierarchy, near, primitives, visitor);
  }
}

} // namespace masu
