// A picture's rays divided among workers in other ways than the renderer's own: what the 2012 thesis
// compared. The picture is cut into tiles of 8 x 8 rays; a worker (a GPU's block of threads, or a thread of
// the CPU) renders one after the other.
#pragma once

#include "libscene/base/portable.h"
#include "renderer/tracer/tracer.h"

#include <cstdint>

namespace masu {

// block        a worker renders a run of tiles, row by row; all runs are as long
// cyclic       of W workers, worker w renders tiles w, w + W, w + 2W, …
// persistent   a worker renders the first tile that no worker has fetched
enum class ScreenDivision { block, cyclic, persistent };

inline constexpr std::int32_t division_tile_side = 8;

// Of a picture, row by row.
struct Tiles {
  std::uint32_t columns, count;
};

inline Tiles tiles_of(std::int32_t columns, std::int32_t rows) {
  const auto tiles = [](std::int32_t rays) {
    return static_cast<std::uint32_t>((rays + division_tile_side - 1) / division_tile_side);
  };
  return {tiles(columns), tiles(columns) * tiles(rows)};
}

// The tiles first, first + step, … before end.
struct TileRun {
  std::uint32_t first, end, step;
};

// A worker's tiles; for `persistent` only `end` counts.
MASU_HD inline TileRun run_of(ScreenDivision division, std::uint32_t worker, std::uint32_t workers,
                              std::uint32_t tiles) {
  if (division != ScreenDivision::block) return {worker, tiles, workers};
  const auto begin = [&](std::uint64_t w) { return static_cast<std::uint32_t>(w * tiles / workers); };
  return {begin(worker), begin(std::uint64_t{worker} + 1), 1};
}

// Renders a float32 scene as ResidentTracer::render does, by `robust` arithmetic through the code for every
// kind of primitive: the picture alone, without hits, counts and costs. workers_each: workers a
// multiprocessor or thread; 0: as many as run at once. Throws Error(device).
struct DividedFrame {
  Frame frame;
  std::uint32_t workers = 0;
};
inline Frame picture_frame(FrameRequest request) {
  request.hits = request.costs = false;
  return sized_frame(request);
}
DividedFrame render_divided_cpu(const SceneFile& scene, const StructureFile& grid,
                                const FrameRequest& request, ScreenDivision division, int workers_each);
DividedFrame render_divided_cuda(const SceneFile& scene, const StructureFile& grid,
                                 const FrameRequest& request, ScreenDivision division, int workers_each);

} // namespace masu
