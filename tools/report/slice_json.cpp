#include "tools/report/slice_json.h"

#include "libscene/base/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace masu {

std::vector<CutSegment> outline_of(const SceneFile& scene, const SlicePlane& plane, const SliceWindow& window,
                                   double deviation) {
  const double longer = std::max(window.max[0] - window.min[0], window.max[1] - window.min[1]);
  const PlaneCut cut{plane.axis, plane.position, window.min, window.max, deviation * longer, scene.origin()};
  return scene.with_view([&](const auto& view) { return plane_cut_of(view, cut); });
}

SliceCellsJson slice_cells_json(const StructureFile& file, const SlicePlane& plane, const SliceWindow& window,
                                std::size_t most, bool without_empty) {
  const auto number = [](double at) { // 3 rather than 3.0
    const bool is_whole = std::abs(at) < 0x1p53 && at == std::floor(at);
    return is_whole ? nlohmann::ordered_json(std::llround(at)) : nlohmann::ordered_json(at);
  };
  SliceCellsJson json;
  for_each_slice_cell(file, plane, window, [&](const SliceCell& cell) {
    if (cell.references == 0 && without_empty) return;
    json.is_truncated = json.cells.size() == most;
    if (json.is_truncated) return;
    json.cells.push_back({number(cell.first[0]), number(cell.first[1]), number(cell.end[0]),
                          number(cell.end[1]), cell.references, cell.depth, cell.voxels, cell.number});
  });
  return json;
}

nlohmann::ordered_json slice_json(const StructureFile& file, const SlicePlane& plane,
                                  const SliceWindow& window, std::span<const CutSegment> outline,
                                  std::size_t most) {
  const GridLayout finest = finest_layout(file);
  const std::array<int, 2> axes = slice_axes(plane.axis);
  const Boxd& space = finest.space;
  SliceCellsJson json = slice_cells_json(file, plane, window, most);
  if (json.is_truncated)
    throw Error(ErrorCode::usage, "--slice",
                fmt::format("has more than {} cells: give a smaller window", most));
  auto segments = nlohmann::ordered_json::array();
  for (const CutSegment& segment : outline)
    segments.push_back({segment.from[0], segment.from[1], segment.to[0], segment.to[1], segment.primitive});
  return {{"structure", file.is_hierarchy() ? "bvh" : "grid"},
          {"axis", std::string(1, "xyz"[plane.axis])},
          {"axes", {std::string(1, "xyz"[axes[0]]), std::string(1, "xyz"[axes[1]])}},
          {"layer", plane.layer},
          {"position", plane.position},
          {"space",
           {{"min", {space.min[axes[0]], space.min[axes[1]]}},
            {"max", {space.max[axes[0]], space.max[axes[1]]}}}},
          {"voxels", {finest.division[axes[0]], finest.division[axes[1]]}},
          {"nested_log2", static_cast<std::int32_t>(file.table().nested_log2())},
          {"window", {{"min", window.min}, {"max", window.max}}},
          {"cells", std::move(json.cells)},
          {"outline", std::move(segments)}};
}

} // namespace masu
