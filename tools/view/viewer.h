// gridview's page, and what it asks for: pictures of a scene through its grids and hierarchies, and what
// these hold.
#pragma once

#include "libgrid/statistics/cells.h"
#include "renderer/channels.h"
#include "renderer/image/jpeg_file.h"
#include "renderer/rays/walk_report.h"
#include "renderer/tracer/tracer.h"
#include "tools/common/json.h"
#include "tools/render/views.h"
#include "tools/view/turns.h"

#include <array>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace masu {

// Command lines, as words, that write the file that is in memory; none where it is a file already.
using Commands = std::vector<std::vector<std::string>>;

struct ViewedStructure {
  std::string path; // of a file in memory the one that its commands write
  StructureFile file;
  Commands made_by{};
};

struct ViewedFiles {
  std::string path;
  SceneFile scene;
  std::vector<ViewedStructure> structures{};
  Commands made_by{};
};

// What is shown: files, or what is made in memory of a standard scene, a mesh or NFF text. A scene file and
// its grids. Without grids `scene` may be NFF text or a mesh, too, and gets an irregular grid and a
// hierarchy; `demo`, a scene of the SPD instead of it, also a uniform grid and one merged by balance. Says
// what was made. Throws as what reads and builds them does, Error(usage) for another demo, and Error(input)
// for a mesh of a format that Assimp alone reads.
ViewedFiles viewed_files(const std::string& scene, const std::vector<std::string>& grids,
                         const std::string& demo, bool quiet);

// Lives where it was made: tracers refer to the files.
struct ViewedGrid : ViewedStructure {
  ResidentTracer tracer;
  std::int32_t greatest_depth; // of its cells or boxes
  mutable Json statistics{};   // null: not made yet

  ViewedGrid(ViewedStructure viewed, const SceneFile& scene, Device device)
      : ViewedStructure(std::move(viewed)), tracer(scene, &file, device),
        greatest_depth(masu::greatest_depth(file)) {}
};

// Voxels an axis of uniform grids that anybody may ask for. Each is built in memory when it is first asked
// for, and kept: so few that all may be.
inline constexpr std::array<std::int32_t, 9> divisions{8, 12, 16, 24, 32, 48, 64, 96, 128};

inline constexpr std::int64_t most_pixels = std::int64_t{1} << 23; // of a picture

using IsGone = std::function<bool()>;

// What a picture shows: the shaded picture, or a channel, numbers as they are, which the page colours,
// normals, and names by colours that neighbours seldom share; of cells and tests the camera ray's alone, or
// the sum over all rays of a pixel. Or what lies behind a plane.
struct PictureChannel {
  std::optional<Channel> channel{}; // none: shaded, or cut
  bool all_rays = false;
  bool is_cut = false;

  bool is_shaded() const { return !channel && !is_cut; }
};

// With names as the page calls them: shaded, depth, …, "all cells", cut.
std::vector<std::pair<std::string, PictureChannel>> picture_channels();

// Whether the picture is another one for each grid: cells, tests, idle.
bool depends_on_grid(const PictureChannel& channel);

// Of channels that are numbers: depth, and those that depend on the grid.
bool has_values(const PictureChannel& channel);

// Of those, rows from the top: a depth is infinite where nothing is hit.
std::vector<float> channel_values(const Channels& channels, Channel channel);

// By the cosine between the line of sight and the surface, as if the light were at the eye; what missed is
// white.
std::vector<std::uint8_t> lit_bytes(std::span<const Vec3f> normals, std::span<const Ray<double>> rays);

// Of the others, 8 bits a channel, rows from the top; what missed is white.
std::vector<std::uint8_t> channel_bytes(const Channels& channels, Channel channel);

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

struct Picture {
  std::string bytes{};     // a JPEG, or of channels that are numbers (has_values()) float32 values, deflated
  std::uint64_t rays = 0;  // from the camera
  std::string precision{}; // that it was traced with, and why
  struct { // waiting for its turn, tracing, copying from the device, rows to bytes, and encoding them
    double wait = 0, trace = 0, copy = 0, rows = 0, encode = 0;
  } seconds;
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
  const ViewedGrid& grid(std::size_t index, const IsGone& is_gone) const;
  std::size_t grids() const { return grids_.size(); } // given ones
  Precision precision() const { return precision_; }
  // A hash of the names and contents of the scene and its grids, which requests name by index.
  std::string files() const;

  // Throw Abandoned when is_gone() before they have ended, and Error.
  Picture picture(const PictureRequest& request, const IsGone& is_gone) const;
  // Ray counts of a picture, as gridrender --stats has them.
  Json counts(const PictureRequest& request, const IsGone& is_gone) const;

  // Through a pixel's centre, in the world, and what the picture is traced with.
  std::pair<Ray<double>, Precision> camera_ray(const Camera& camera, std::int32_t column,
                                               std::int32_t row) const;
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
  ViewedFiles files_; // but for the structures
  std::vector<std::unique_ptr<ViewedGrid>> grids_;
  mutable std::array<std::unique_ptr<ViewedGrid>, divisions.size()> divided_; // null: not built yet
  mutable std::mutex building_;
  Device device_;
  Precision precision_;
  mutable Turns turns_{32};
  mutable Turns walk_turns_{16}; // of their own, for a walk takes one core: pictures don't wait for it
};

struct HttpReply;
struct HttpRequest;

// What the page's addresses answer. Status 404 for any other path; 409 where the parameter `files`, which any
// may have, isn't Viewer::files(), for another gridview has the port by now. Throws Error(usage) for
// parameters that are missing, unknown or out of range.
HttpReply answer(const Viewer& viewer, const HttpRequest& request);

struct ExportSettings {
  std::string path;                       // .html
  int views = 12;                         // around the point that the scene's camera looks at
  std::int32_t width = 640, height = 480; // pixels
  std::vector<SharePlane> slices{};       // at least one
  std::vector<Ray<double>> rays{};        // in slices: walked besides those from point to point
  std::string opens_with{};               // the fragment of the address that is shown first
  int most_boxes = 1000;                  // of each depth
};

// The page as one file that needs no server: pictures of an orbit, channels, slices, statistics. progress
// gets the share that is done. Throws Error(output), Error(usage) for a ray in none of the slices, and what
// Viewer's functions throw.
void export_page(const Viewer& viewer, const ExportSettings& settings,
                 const std::function<void(double)>& progress);

} // namespace masu
