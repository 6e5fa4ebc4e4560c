// How a GPU's warps lie over a picture, and how many of their lanes idle.
//
// The kernel of pictures (renderer/cuda/rendering.h) gives each lane of a warp a camera ray of a tile of 8
// x 4. A turn of its loop is a cell or node of each lane's ray, and a warp makes as many turns as its longest
// ray needs: until then lanes whose rays have ended idle, and those of tiles that reach beyond the picture.
// So, of the rays of a warp,
//   idle lanes, mean over its turns = 32 - (sum of the rays' cells) / (most cells of a ray).
// Lanes that wait within a turn, while others test longer lists, aren't counted.
#pragma once

#include "libscene/base/portable.h"

#include <cstdint>

namespace masu {

// A block of threads traces a tile of 8 x 8 rays, a warp a half of it: neighbours visit the same cells.
inline constexpr int tile_side = 8;
inline constexpr int warp_rows = lanes_per_warp / tile_side;

// Of many warps: their turns, and the lanes that are under way in each turn, summed.
struct WarpTurns {
  std::uint64_t turns = 0, busy_lanes = 0;

  double mean_busy() const {
    return turns > 0 ? static_cast<double>(busy_lanes) / static_cast<double>(turns) : 0;
  }
  WarpTurns& operator+=(const WarpTurns& other) {
    turns += other.turns;
    busy_lanes += other.busy_lanes;
    return *this;
  }
};

} // namespace masu
