#include "tools/report/structure_report.h"

#include "libgrid/statistics/cells.h"
#include "libgrid/statistics/statistics.h"
#include "tools/common/json.h"
#include "tools/common/print.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <numeric>

namespace masu {
namespace {

// Of a grid: of its cells and references, and of the voxel map.
struct Statistics {
  GridStatistics cells;
  MapStatistics map;
  Vec3i division{}; // in the smallest voxels

  explicit Statistics(const StructureFile& file) {
    const auto look_at = [&](const auto& view, std::uint64_t count, const auto& records) {
      cells = grid_statistics(count, file.references());
      map = map_statistics(view, records);
      division = view.division;
    };
    file.is_merged()
        ? look_at(merged_view_of<double>(file.records()), file.cells().size(), file.cells())
        : look_at(view_of<double>(file.records()), voxel_count(file.layout().division), file.references());
  }

  // Coefficient of variation of the references of occupied cells: 0 when all list the same number.
  double evenness() const { return cells.mean > 0 ? cells.stddev / cells.mean : 0; }
};

// A histogram: [i, counts[i]] for each count that isn't 0; or [2^i, counts[i]].
Json histogram_of(const std::vector<std::uint64_t>& counts, bool by_powers = false) {
  Json pairs = Json::array();
  for (std::size_t i = 0; i < counts.size(); ++i)
    if (counts[i] > 0) pairs.push_back({by_powers ? std::uint64_t{1} << i : i, counts[i]});
  return pairs;
}

Json seconds_json(const fb::Structure& table) {
  return table.build_seconds() >= 0 ? Json(table.build_seconds()) : Json();
}

std::string geometry_hash(const fb::Structure& table) {
  return to_hex({table.geometry_hash()->low(), table.geometry_hash()->high()});
}

// --- CSV --------------------------------------------------------------------------------------------------

std::string quoted_where_needed(const std::string& text) {
  std::string line = printable(text);
  if (line.find_first_of(",\"") == std::string::npos) return line;
  std::string quoted = "\"";
  for (const char c : line)
    quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

// A line of the names, those of nested keys joined by points, and one of the values: what a report doesn't
// have (null) is empty, text is quoted where it must be.
void print_csv(const Json& report) {
  std::vector<std::string> names, values;
  const Json flat = report.flatten();
  for (const auto& [path, value] : flat.items()) {
    names.push_back(path.substr(1));
    std::ranges::replace(names.back(), '/', '.');
    values.push_back(value.is_null()     ? std::string()
                     : value.is_string() ? quoted_where_needed(value.get<std::string>())
                                         : value.dump());
  }
  fmt::print("{}\n{}\n", fmt::join(names, ","), fmt::join(values, ","));
}

// --- Tables -----------------------------------------------------------------------------------------------

constexpr Rows print_row{22};

std::string joined(const std::vector<std::uint64_t>& numbers) {
  std::string text;
  for (const std::uint64_t number : numbers)
    text += (text.empty() ? "" : " + ") + grouped(number);
  return text;
}

void print_table(const StructureFile& file, const Statistics& statistics) {
  const GridStatistics& s = statistics.cells;
  const MapStatistics& map = statistics.map;
  const fb::Structure& table = file.table();
  const fb::Vec3 &low = table.space()->min(), &high = table.space()->max();
  print_row("space", "{}, from ({:g}, {:g}, {:g})", fb::EnumNameSpace(table.space_rule()), low.x(), low.y(),
            low.z());
  print_row("", "to ({:g}, {:g}, {:g})", high.x(), high.y(), high.z());
  print_row("division", "{} ({})", by_by(file.layout().division), printable(table.division_rule()->str()));
  if (table.nested_log2() > 0)
    print_row("  smallest voxels", "{}, 2^{} times finer", by_by(statistics.division), table.nested_log2());
  print_row("voxels", "{}", grouped(map.voxels));
  print_row("  occupied", "{} ({:.3g} %)", grouped(map.occupied_voxels),
            percent(map.occupied_voxels, map.voxels));
  print_row("  empty", "{}", grouped(map.voxels - map.occupied_voxels));
  print_row("cells", "{} ({} occupied)", grouped(s.cells), grouped(s.occupied_cells));
  if (file.is_merged())
    print_row("  expanded", "{} (to {:.3g} times their volume, geometric mean)", grouped(map.expanded_cells),
              map.mean_expansion);
  print_row("references", "{}", grouped(s.references));
  print_row("  per occupied cell", "mean {:.2f}, stddev {:.2f} ({:.2f} of the mean),", s.mean, s.stddev,
            statistics.evenness());
  print_row("", "median {:g}, 99 % {}, least {}, most {}", s.median, s.p99, s.min, grouped(s.max));
  print_row("map words by level", "{}", joined(map.words));
  print_row("  loads per point", "{:.2f}", map.loads);
  print_row("expected per ray", "{:.2f} cells, {:.2f} tests, {:.2f} voxels skipped", map.ray.cells,
            map.ray.tests, map.ray.voxels_skipped);
  print_row("bytes", "{}", grouped(file.bytes()));
  print_row("  voxel map", "{}", grouped(file.voxel_map().size_bytes()));
  if (file.is_merged()) print_row("  cells", "{}", grouped(file.cells().size_bytes()));
  print_row("  references", "{}", grouped(file.references().size_bytes()));
  print_row("merge", "{}",
            file.is_merged() ? printable(table.merge_rule()->str()) : fb::EnumNameMerge(table.merge()));
  print_row("overlap test", "{}", fb::EnumNameOverlap(table.overlap()));
  print_row("geometry", "{}", geometry_hash(table));
}

void print_table(const StructureFile& file, const HierarchyStatistics& s) {
  print_row("nodes", "{}, {} deep", grouped(s.nodes), s.depth);
  print_row("  boxes of nodes", "{}", grouped(s.node_boxes));
  print_row("  boxes of references", "{}", grouped(s.reference_boxes));
  print_row("  boxes per node", "{:.2f} of 8", s.boxes_per_node);
  print_row("references", "{} to {} primitives", grouped(s.references), grouped(file.table().primitives()));
  print_row("expected per ray", "{:.2f} nodes, {:.2f} tests", s.nodes_per_ray, s.tests_per_ray);
  print_row("bytes", "{}", grouped(file.bytes()));
  print_row("  nodes", "{}", grouped(file.nodes().size_bytes()));
  print_row("  references", "{}", grouped(file.references().size_bytes()));
  print_row("structure", "bvh, quality {}", fb::EnumNameQuality(file.table().quality()));
  print_row("geometry", "{}", geometry_hash(file.table()));
}

// A line with a bar of characters for each pair of a histogram.
void print_bars(const char* head, const char* counted, const Json& histogram) {
  std::uint64_t most = 1;
  for (const Json& pair : histogram)
    most = std::max(most, pair[1].get<std::uint64_t>());
  fmt::print("\n{:>17} {:>13}\n", head, counted);
  for (const Json& pair : histogram) {
    const auto count = pair[1].get<std::uint64_t>();
    const double bar = 48 * static_cast<double>(count) / static_cast<double>(most);
    fmt::print("{:>17} {:>13} {}\n", grouped(pair[0].get<std::uint64_t>()), grouped(count),
               std::string(static_cast<std::size_t>(bar), '#'));
  }
}

// --- JSON -------------------------------------------------------------------------------------------------

Json report_of(const StructureFile& file, const Statistics& statistics, bool histogram) {
  const GridStatistics& s = statistics.cells;
  const MapStatistics& map = statistics.map;
  const fb::Structure& table = file.table();
  const fb::Division& n = *table.division();
  Json json{
      {"space", finest_layout(file).space},
      {"division", {n.x(), n.y(), n.z()}},
      {"smallest_division", statistics.division},
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
        {"voxel_map", file.voxel_map().size_bytes()},
        {"cells", file.cells().size_bytes()},
        {"references", file.references().size_bytes()}}},
      {"merge", fb::EnumNameMerge(table.merge())},
      {"overlap", fb::EnumNameOverlap(table.overlap())},
      {"space_rule", fb::EnumNameSpace(table.space_rule())},
      {"division_rule", table.division_rule()->str()},
      {"geometry_hash", geometry_hash(table)},
      {"build_seconds", seconds_json(table)},
      // What only merged grids have; null for uniform ones, so that every report has the same keys.
      {"merge_rule", nullptr},
      {"nested_log2", nullptr},
      {"cells_by_size", nullptr},
      {"expanded_cells", nullptr},
      {"mean_expansion", nullptr},
  };
  if (file.is_merged())
    json.update({{"merge_rule", table.merge_rule()->str()},
                 {"nested_log2", table.nested_log2()},
                 {"cells_by_size", histogram_of(map.cells_by_size, true)},
                 {"expanded_cells", map.expanded_cells},
                 {"mean_expansion", map.mean_expansion}});
  json.update(program_version());
  if (histogram && s.occupied_cells > 0) json["histogram"] = histogram_of(s.histogram);
  return json;
}

Json report_of(const StructureFile& file, const HierarchyStatistics& s, bool histogram) {
  const fb::Structure& table = file.table();
  Json json{{"structure", "bvh"},
            {"space", finest_layout(file).space},
            {"primitives", table.primitives()},
            {"nodes", s.nodes},
            {"boxes_a_node", s.boxes_per_node},
            {"node_boxes", s.node_boxes},
            {"reference_boxes", s.reference_boxes},
            {"references", s.references},
            {"depth", s.depth},
            {"expected_per_ray", {{"nodes", s.nodes_per_ray}, {"tests", s.tests_per_ray}}},
            {"bytes",
             {{"file", file.bytes()},
              {"nodes", file.nodes().size_bytes()},
              {"references", file.references().size_bytes()}}},
            {"quality", fb::EnumNameQuality(table.quality())},
            {"geometry_hash", geometry_hash(table)},
            {"build_seconds", seconds_json(table)}};
  if (histogram) json["histogram"] = histogram_of(s.boxes_by_references);
  if (histogram) json["histogram_by_depth"] = histogram_of(s.boxes_by_depth);
  json.update(program_version());
  return json;
}

} // namespace

Json structure_report(const StructureFile& file, bool histogram) {
  return file.is_hierarchy() ? report_of(file, hierarchy_statistics(file.nodes()), histogram)
                             : report_of(file, Statistics(file), histogram);
}

void print_structure_report(const StructureFile& file, ReportFormat format, bool histogram) {
  Json json;
  const auto report = [&](const auto& statistics) {
    json = report_of(file, statistics, histogram);
    if (format == ReportFormat::table) print_table(file, statistics);
  };
  file.is_hierarchy() ? report(hierarchy_statistics(file.nodes())) : report(Statistics(file));
  if (format == ReportFormat::csv && !file.is_hierarchy()) {
    // The map's words are added up; cells_by_size has no fixed length.
    const auto words = json["map"]["words_by_level"].get<std::vector<std::uint64_t>>();
    json["map"].erase("words_by_level");
    json["map"]["words"] = std::accumulate(words.begin(), words.end(), std::uint64_t{0});
    json.erase("cells_by_size");
  }
  if (format == ReportFormat::json) return fmt::print("{}\n", json_text(json));
  if (format == ReportFormat::csv) return print_csv(json);
  if (!histogram) return;
  const char* const counted = file.is_hierarchy() ? "boxes" : "cells";
  print_bars("references", counted, json.value("histogram", Json()));
  if (file.is_hierarchy()) print_bars("depth", counted, json["histogram_by_depth"]);
  if (file.is_merged()) print_bars("voxels from", counted, json["cells_by_size"]);
}

} // namespace masu
