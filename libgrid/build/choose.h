// Choosing how to merge for somebody who doesn't care.
#pragma once

#include "libgrid/build/builder.h"

namespace masu {

// Builds a uniform grid of one layout and an irregular one of the other, and returns the one that a ray is
// expected to be through with sooner (map_statistics.h), a step costing rule.step_over_test tests; or the
// smaller one where that makes less than a tenth's difference. What rays will come isn't asked: where most
// of them stop early, both meet less. A scene whose irregular grid would be too large gets the uniform one.
// Throws as the builder does.
template <class Stored>
Grid build_chosen(GridBuilder<Stored>& builder, const GridLayout& uniform, const GridLayout& nested,
                  Overlap overlap, const MergeRule& rule);

} // namespace masu
