#include "renderer/picture_warps.h"

#include <algorithm>

namespace masu {

IdleLanes idle_lanes(const HostArray<std::uint32_t>& cells, std::int32_t columns, std::int32_t rows) {
  IdleLanes lanes{HostArray<float>(cells.size()), {}};
  const auto for_each_ray = [&](std::int32_t first_column, std::int32_t first_row, const auto& act) {
    for (std::int32_t row = first_row; row < std::min(first_row + warp_rows, rows); ++row)
      for (std::int32_t column = first_column; column < std::min(first_column + tile_side, columns); ++column)
        act(static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
            static_cast<std::size_t>(column));
  };
  for (std::int32_t row = 0; row < rows; row += warp_rows) {
    for (std::int32_t column = 0; column < columns; column += tile_side) {
      WarpTurns warp;
      for_each_ray(column, row, [&](std::size_t ray) {
        warp.turns = std::max<std::uint64_t>(warp.turns, cells[ray]);
        warp.busy_lanes += cells[ray];
      });
      const float idle = warp.turns > 0 ? static_cast<float>(lanes_per_warp - warp.mean_busy()) : 0;
      for_each_ray(column, row, [&](std::size_t ray) { lanes.idle[ray] = idle; });
      lanes.all += warp;
    }
  }
  return lanes;
}

} // namespace masu
