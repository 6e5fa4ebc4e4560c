// A grid, a hierarchy or none, known when it is traced: for what is compared with, not for speed. One kernel
// of each kind serves all of them, and both rules by which a search ends.
#pragma once

#include "libgrid/trace/trace.h"

namespace masu {

enum class Structure { none, uniform, merged, hierarchy };

template <class Real>
struct AnyStructure {
  Structure structure = Structure::none;
  StopRule stop = StopRule::proven; // with a grid of cells; anything else is proven
  GridView<Real> uniform{};
  MergedGridView<Real> merged{};
  HierarchyView<Real> hierarchy{};
};

template <class Real>
AnyStructure<Real> any_structure(const GridView<Real>& view) {
  return {Structure::uniform, StopRule::proven, view, {}, {}};
}
template <class Real>
AnyStructure<Real> any_structure(const MergedGridView<Real>& view) {
  return {Structure::merged, StopRule::proven, {}, view, {}};
}
template <class Real>
AnyStructure<Real> any_structure(const HierarchyView<Real>& view) {
  return {Structure::hierarchy, StopRule::proven, {}, {}, view};
}

template <class View>
inline constexpr bool is_any_structure = false;
template <class Real>
inline constexpr bool is_any_structure<AnyStructure<Real>> = true;

template <class Real>
MASU_HD inline StopRule stop_rule(const AnyStructure<Real>& any) {
  return any.structure == Structure::hierarchy ? StopRule::proven : any.stop;
}

template <class Real, class Visitor>
MASU_HD inline void visit(const AnyStructure<Real>& any, const ClippedRay<Real>& near,
                          std::uint32_t primitives, Visitor& visitor) {
  switch (any.structure) {
  case Structure::none:
    return visit(NoGrid{}, near, primitives, visitor);
  case Structure::uniform:
    return visit(any.uniform, near, primitives, visitor);
  case Structure::merged:
    return visit(any.merged, near, primitives, visitor);
  case Structure::hierarchy:
    return visit(any.hierarchy, near, primitives, visitor);
  }
}

} // namespace masu
