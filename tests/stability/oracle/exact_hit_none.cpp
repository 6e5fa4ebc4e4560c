// Where this program was built without GMP.
#include "libscene/base/error.h"
#include "stability/oracle/exact_hit.h"

namespace masu::stability {

const bool exact_hits_available = false;

std::vector<PrimitiveIndex> exact_nearest(std::span<const Triangle<float>>, const Ray<double>&) {
  throw Error(ErrorCode::usage, "exact hits", "this program was built without GMP: install libgmp-dev");
}

} // namespace masu::stability
