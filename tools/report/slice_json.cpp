#include "tools/report/slice_json.h"

#include <cmath>
#include <string>
#include <utility>

namespace masu {

nlohmann::ordered_json slice_cell_json(const SliceCell& cell) {
  const auto number = [](double at) { // 3 rather than 3.0
    const bool is_whole = std::abs(at) < 0x1p53 && at == std::floor(at);
    return is_whole ? nlohmann::ordered_json(std::llround(at)) : nlohmann::ordered_json(at);
  };
  return {number(cell.first[0]), number(cell.first[1]),
          number(cell.end[0]),   number(cell.end[1]),
          cell.references,       cell.depth,
          cell.voxels,           cell.number};
}

nlohmann::ordered_json slice_json(const Slice& slice, const SliceWindow& window,
                                  std::span<const SectionSegment> outline) {
  const std::array<int, 2> axes = slice_axes(slice.plane.axis);
  const Boxd& space = slice.finest.space;
  auto cells = nlohmann::ordered_json::array(), segments = nlohmann::ordered_json::array();
  for (const SliceCell& cell : slice.cells)
    cells.push_back(slice_cell_json(cell));
  for (const SectionSegment& segment : outline)
    segments.push_back({segment.from[0], segment.from[1], segment.to[0], segment.to[1], segment.primitive});
  return {{"structure", slice.is_hierarchy ? "bvh" : "grid"},
          {"axis", std::string(1, "xyz"[slice.plane.axis])},
          {"axes", {std::string(1, "xyz"[axes[0]]), std::string(1, "xyz"[axes[1]])}},
          {"layer", slice.plane.layer},
          {"position", slice.plane.position},
          {"space",
           {{"min", {space.min[axes[0]], space.min[axes[1]]}},
            {"max", {space.max[axes[0]], space.max[axes[1]]}}}},
          {"voxels", {slice.finest.division[axes[0]], slice.finest.division[axes[1]]}},
          {"nested_log2", slice.nested_log2},
          {"window", {{"min", window.min}, {"max", window.max}}},
          {"cells", std::move(cells)},
          {"outline", std::move(segments)}};
}

} // namespace masu
