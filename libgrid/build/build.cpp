#include "libgrid/build/build.h"

#include "libgrid/build/passes/host_executor.h"
#include "libgrid/build/passes/uniform_passes.h"
#include "libscene/base/error.h"

namespace masu {

void check_primitives(std::uint64_t count) {
  if (count > max_numbered)
    throw Error(ErrorCode::input, "scene", "holds more than 2^31 primitives: grids can't number so many");
}

double expected_build_bytes(const GridLayout& layout, double references) {
  // Pairs as they are emitted, and sorted; a block's map for each few cells.
  constexpr double pair_bytes = 8 + sizeof(std::uint64_t) + sizeof(PrimitiveIndex);
  const std::int32_t block_log2 = block_log2_for(layout.division);
  const double words = static_cast<double>(voxel_count(blocks_of(layout.division, block_log2)));
  const double block_maps = block_log2 == 0 ? 0 : references / 16 * 512 * 4;
  return 4 * words + block_maps + references * pair_bytes;
}

template <class Stored>
Grid uniform_grid(const SceneView<Stored>& scene, const GridLayout& layout, Overlap overlap) {
  TbbExecutor executor;
  return uniform_grid(executor, scene, layout, overlap);
}
template Grid uniform_grid(const SceneView<float>&, const GridLayout&, Overlap);
template Grid uniform_grid(const SceneView<double>&, const GridLayout&, Overlap);

} // namespace masu
