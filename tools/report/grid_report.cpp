#include "tools/report/grid_report.h"

#include "libgrid/statistics/cells.h"
#include "tools/common/provenance.h"
#include "tools/common/vector_json.h"

#include <nlohmann/json.hpp>

namespace masu {
namespace {

using Json = nlohmann::ordered_json;

// What only merged grids have; null for uniform ones, so that every report has the same keys.
Json merged_report(const GridFile& file, const Statistics& statistics) {
  if (!file.is_merged())
    return {{"merge_rule", nullptr},
            {"nested_log2", nullptr},
            {"cells_by_size", nullptr},
            {"expanded_cells", nullptr},
            {"mean_expansion", nullptr}};
  const MapStatistics& map = statistics.map;
  Json sizes = Json::array();
  for (std::size_t log2 = 0; log2 < map.cells_by_size.size(); ++log2) {
    if (map.cells_by_size[log2] > 0) sizes.push_back({std::uint64_t{1} << log2, map.cells_by_size[log2]});
  }
  return {{"merge_rule", file.table().merge_rule()->str()},
          {"nested_log2", file.table().nested_log2()},
          {"cells_by_size", sizes},
          {"expanded_cells", map.expanded_cells},
          {"mean_expansion", map.mean_expansion}};
}

} // namespace

Statistics::Statistics(const GridFile& file) {
  if (file.is_merged()) {
    const auto view = file.merged_view<double>();
    cells = grid_statistics(view, file.cells());
    map = map_statistics(view, file.cells());
    division = view.division;
  } else {
    const auto view = file.view<double>();
    cells = grid_statistics(view, file.references());
    map = map_statistics(view, file.references());
    division = view.division;
  }
}

Json grid_report(const GridFile& file, const Statistics& statistics, bool histogram) {
  const GridStatistics& s = statistics.cells;
  const MapStatistics& map = statistics.map;
  const fb::Grid& table = file.table();
  const fb::Division& n = *table.division();
  const Boxd space = finest_layout(file).space;
  const Vec3i& smallest = statistics.division;
  const auto bytes = [](const auto& records) { return records.size_bytes(); };
  Json json{
      {"space", {{"min", vector_json(space.min)}, {"max", vector_json(space.max)}}},
      {"division", {n.x(), n.y(), n.z()}},
      {"smallest_division", {smallest.x, smallest.y, smallest.z}},
      {"voxels", map.voxels},
      {"occupied_voxels", map.occupied_voxels},
      {"empty_voxels", map.voxels - map.occupied_voxels},
      {"occupancy_percent", percent(map.occupied_voxels, map.voxels)},
      {"cells", s.cells},
      {"occupied_cells", s.occupied_cells},
      {"empty_cells", s.cells - s.occupied_cells},
      {"references", s.references},
      {"references_per_occupied_cell",
       {{"mean", s.mean},
        {"stddev", s.stddev},
        {"evenness", statistics.evenness()},
        {"median", s.median},
        {"p99", s.p99},
        {"min", s.min},
        {"max", s.max}}},
      {"map", {{"words_by_level", map.words}, {"mean_loads", map.loads}}},
      {"expected_per_ray",
       {{"cells", map.ray.cells}, {"tests", map.ray.tests}, {"voxels_skipped", map.ray.voxels_skipped}}},
      {"bytes",
       {{"file", file.bytes()},
        {"voxel_map", bytes(file.voxel_map())},
        {"cells", bytes(file.cells())},
        {"references", bytes(file.references())}}},
      {"merge", fb::EnumNameMerge(table.merge())},
      {"overlap", fb::EnumNameOverlap(table.overlap())},
      {"space_rule", fb::EnumNameSpace(table.space_rule())},
      {"division_rule", table.division_rule()->str()},
      {"geometry_hash", to_hex({table.geometry_hash()->low(), table.geometry_hash()->high()})},
      {"build_seconds", nullptr},
  };
  if (table.build_seconds() >= 0) json["build_seconds"] = table.build_seconds();
  json.update(merged_report(file, statistics));
  json.update(program_version());
  if (histogram) {
    for (std::size_t references = 0; references < s.histogram.size(); ++references) {
      if (s.histogram[references] > 0) json["histogram"].push_back({references, s.histogram[references]});
    }
  }
  return json;
}

} // namespace masu
