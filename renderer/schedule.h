// Who traces which part of a picture. It is cut into tiles of 8 × 8 rays; a worker takes one after the other.
#pragma once

#include "libscene/portable.h"

#include <cstdint>

namespace masu {

// hardware     each tile is a worker of its own; the GPU, or the CPU's task scheduler, hands them out (the
//              latter in larger tiles, whose cells stay in cache)
// The others have as many workers as run at once. Whether they should take what lies together or apart is an
// old query of drawing in parallel: neighbouring tiles share cells, but also cost alike.
// block        a worker takes a run of tiles, row by row; all runs are as long
// cyclic       of W workers, worker w takes tiles w, w + W, w + 2W, …
// persistent   a worker takes the first tile that nobody has taken
enum class Schedule { hardware, block, cyclic, persistent };

inline constexpr std::int32_t tile_side = 8;

// Of a picture, row by row.
struct Tiles {
  std::uint32_t columns, count;
};

inline Tiles tiles_of(std::int32_t columns, std::int32_t rows) {
  const auto tiles = [](std::int32_t rays) {
    return static_cast<std::uint32_t>((rays + tile_side - 1) / tile_side);
  };
  return {tiles(columns), tiles(columns) * tiles(rows)};
}

// The tiles first, first + step, … before end.
struct TileRun {
  std::uint32_t first, end, step;
};

// What the worker takes, which for `persistent` only says where tiles end.
MASU_HD inline TileRun run_of(Schedule schedule, std::uint32_t worker, std::uint32_t workers,
                              std::uint32_t tiles) {
  if (schedule != Schedule::block) return {worker, tiles, workers};
  const auto begin = [&](std::uint64_t w) { return static_cast<std::uint32_t>(w * tiles / workers); };
  return {begin(worker), begin(std::uint64_t{worker} + 1), 1};
}

} // namespace masu
