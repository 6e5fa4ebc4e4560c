// One ray through a bounding volume hierarchy, by the walk that suits it (walks_in_use.h).
#pragma once

#include "libgrid/hierarchy/walk/hierarchy_walk.h"
#include "libgrid/hierarchy/walk/walks_in_use.h"

#ifdef MASU_HOST_AVX2
#include "libgrid/hierarchy/walk/nearest_first_avx2.h"
#endif

namespace masu {

template <class Real, class Visitor>
MASU_HD inline void visit(const HierarchyView<Real>& hierarchy, const ClippedRay<Real>& near, std::uint32_t,
                          Visitor& visitor) {
#ifdef MASU_HOST_AVX2
  if constexpr (walks_in_use::nearest_first && !std::decay_t<decltype(visitor.counts)>::is_counted) {
    NearestFirstWalk<typename BoxArithmetic<Real, Visitor>::type> walk(visitor.ray.origin,
                                                                       bounded_inverse(near));
    while (walk.advance(hierarchy, visitor)) {
    }
    return;
  }
#endif
  walk_hierarchy(hierarchy, near, visitor);
}
template <class Real, class Stored, class Visitor>
MASU_HD inline void visit(const LeafHierarchyView<Real, Stored>& hierarchy, const ClippedRay<Real>& near,
                          std::uint32_t, Visitor& visitor) {
  walk_hierarchy(hierarchy, near, visitor);
}

} // namespace masu
