// What the page of gridview asks for: pictures of a scene through its grids and hierarchies, and what these
// hold.
#pragma once

#include "libgrid/statistics/boxes.h"
#include "renderer/image/jpeg_file.h"
#include "renderer/rays/walk_report.h"
#include "renderer/tracer/tracer.h"
#include "tools/common/json.h"
#include "tools/render/views.h"
#include "tools/view/channel_colors.h"
#include "tools/view/turns.h"
#include "tools/view/viewed_files.h"

#include <array>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace masu {

// Lives where it was made: tracers refer to the files.
struct ViewedGrid : ViewedStructure {
  ResidentTracer tracer;
  std::int32_t greatest_depth; // of its cells or boxes
  Json statistics{};           // null: not made yet

  ViewedGrid(ViewedStructure viewed, const SceneFile& scene, Device device)
      : ViewedStructure(std::move(viewed)), tracer(scene, &file, device),
        greatest_depth(masu::greatest_depth(file)) {}
};

// Voxels an axis of uniform grids that anybody may ask for. Each is built in memory when it is first asked
// for, and kept: so few that all may be.
inline constexpr std::array<std::int32_t, 9> divisions{8, 12, 16, 24, 32, 48, 64, 96, 128};

inline constexpr std::int64_t most_pixels = std::int64_t{1} << 23; // of a picture

using IsGone = std::function<bool()>;

// A plane perpendicular to `axis` (0 to 2), at a share of the grid's space.
struct SharePlane {
  int axis = 2;
  double share = 0.5;
};

struct PictureRequest {
  std::size_t grid = 0;
  FrameRequest frame{}; // its precision is the viewer's
  PictureChannel channel{};
  SharePlane cut{}; // of a channel that is cut: what is on the eye's side of it is left out
  JpegQuality quality{};
};

// Seconds: waiting for its turn, tracing, copying from the device, rows to bytes, and encoding them.
struct PictureSeconds {
  double wait = 0, trace = 0, copy = 0, rows = 0, encode = 0;
};

struct Picture {
  std::string bytes{};     // a JPEG, or of channels that are numbers (has_values()) float32 values, deflated
  std::uint64_t rays = 0;  // from the camera
  std::string precision{}; // that it was traced with, and why
  PictureSeconds seconds;
  WarpTurns warps{}; // of the channel idle
};

Json camera_json(const Camera& camera);

// As a header Server-Timing: stages in milliseconds, `precision`, `rays`, and of idle lanes `turns` and
// `busy_lanes`.
std::string timing_of(const Picture& picture);

// Threads may ask at the same time.
class Viewer {
public:
  // Throws as ResidentTracer does.
  Viewer(ViewedFiles files, Device device, Precision precision);

  const SceneFile& scene() const { return files_.scene; }
  // Those that were given, and behind them those of `divisions`, one of which may be built by the call:
  // Abandoned where is_gone() meanwhile, and Error.
  const ViewedGrid& grid(std::size_t index, const IsGone& is_gone) const { return *viewed(index, is_gone); }
  std::size_t grids() const { return grids_.size(); } // given ones
  Precision precision() const { return precision_; }
  // A hash of the names and contents of the scene and its grids, which requests name by index.
  std::string files() const;

  // Throw Abandoned when is_gone() before they have ended, and Error.
  Picture picture(const PictureRequest& request, const IsGone& is_gone) const;
  // Ray counts of a picture, as gridrender --stats has them.
  Json counts(const PictureRequest& request, const IsGone& is_gone) const;

  // Through a pixel's centre, in the world, and what the picture is traced with.
  struct PickedRay {
    Ray<double> ray;
    Precision precision;
  };
  PickedRay camera_ray(const Camera& camera, std::int32_t column, std::int32_t row) const;
  // As gridtrace --ray --json has it, and in `ended` why each ray's walk ended, in words. Bounded:
  // `more_rays` are counted that aren't among `rays`, `ended_early` says that there are still more. A ray's
  // `steps` are the first of its `cells`. The request's limits and progress are the viewer's.
  Json walk(std::size_t grid, WalkRequest request, const IsGone& is_gone) const;
  // {axis, axes, position, range, voxels, min, step, cells, outline, truncated, without_empty}: cells as
  // slice_cells_json() has them, those of a uniform grid without the empty ones where these are too many;
  // outline as [from u, from v, to u, to v] in scene units. Beyond `most_cells` the slice is truncated.
  Json slice(std::size_t grid, const SharePlane& plane, std::size_t most_cells, const IsGone& is_gone) const;
  // {boxes: [{min, max, depth}, …], count, depth}: those that list references, of any depth or
  // down to one; there a hierarchy's boxes around nodes, too, so that they cover what all do. Where there are
  // more than `most`, of any depth those down to the deepest that fits, or each n-th of `count`.
  Json boxes(std::size_t grid, std::optional<std::int32_t> depth, std::size_t most,
             const IsGone& is_gone) const;

  // The scene, its camera, its grids by name, and the divisions that there are besides.
  Json description() const;
  // gridstat --json --histogram of a grid. Made once.
  Json statistics(std::size_t grid, const IsGone& is_gone) const;

private:
  ViewedGrid* viewed(std::size_t index, const IsGone& is_gone) const;

  ViewedFiles files_; // but for the structures
  std::vector<std::unique_ptr<ViewedGrid>> grids_;
  mutable std::array<std::unique_ptr<ViewedGrid>, divisions.size()> divided_; // null: not built yet
  mutable std::mutex building_;
  Device device_;
  Precision precision_;
  mutable Turns turns_{32};
  mutable Turns walk_turns_{16}; // of their own, for a walk takes one core: pictures don't wait for it
};

} // namespace masu
