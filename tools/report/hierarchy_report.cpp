#include "tools/report/hierarchy_report.h"

#include "libgrid/statistics/cells.h"
#include "tools/common/flat_csv.h"
#include "tools/common/printable.h"
#include "tools/common/provenance.h"
#include "tools/common/vector_json.h"
#include "tools/report/bars.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <string>

namespace masu {
namespace {

using Json = nlohmann::ordered_json;

void print_table(const GridFile& file, const HierarchyStatistics& s, const Json& json) {
  const auto line = [](const char* name, const std::string& value) {
    fmt::print("{:<28} {}\n", name, value);
  };
  line("nodes", fmt::format("{}, {} deep", s.nodes, s.depth));
  line("  boxes of nodes", fmt::format("{}", s.node_boxes));
  line("  boxes of references", fmt::format("{}", s.reference_boxes));
  line("  boxes a node", fmt::format("{:.2f} of 8", s.boxes_per_node));
  line("references", fmt::format("{} to {} primitives", s.references, file.table().primitives()));
  line("expected per ray", fmt::format("{:.2f} nodes, {:.2f} tests", s.nodes_per_ray, s.tests_per_ray));
  line("bytes", fmt::format("{} (nodes {}, references {})", file.bytes(), file.nodes().size_bytes(),
                            file.references().size_bytes()));
  line("structure", "bvh");
  line("geometry", json["geometry_hash"].get<std::string>());
}

} // namespace

Json hierarchy_report(const GridFile& file, const HierarchyStatistics& s, bool histogram) {
  const fb::Grid& table = file.table();
  const Boxd space = finest_layout(file).space;
  Json json{{"structure", "bvh"},
            {"space", {{"min", vector_json(space.min)}, {"max", vector_json(space.max)}}},
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
            {"geometry_hash", to_hex({table.geometry_hash()->low(), table.geometry_hash()->high()})},
            {"build_seconds", nullptr}};
  if (table.build_seconds() >= 0) json["build_seconds"] = table.build_seconds();
  const auto pairs = [](const std::vector<std::uint64_t>& counts) {
    Json list = Json::array();
    for (std::size_t i = 0; i < counts.size(); ++i)
      if (counts[i] > 0) list.push_back({i, counts[i]});
    return list;
  };
  if (histogram) json["histogram"] = pairs(s.boxes_by_references);
  if (histogram) json["histogram_by_depth"] = pairs(s.boxes_by_depth);
  json.update(program_version());
  return json;
}

void print_hierarchy_report(const GridFile& file, ReportFormat format, bool histogram) {
  const HierarchyStatistics statistics = hierarchy_statistics(file.nodes());
  const Json json = hierarchy_report(file, statistics, histogram);
  switch (format) {
  case ReportFormat::table:
    print_table(file, statistics, json);
    if (!histogram) return;
    print_bars("references", "boxes", statistics.boxes_by_references,
               [](std::size_t references) { return references; });
    return print_bars("depth", "boxes", statistics.boxes_by_depth, [](std::size_t depth) { return depth; });
  case ReportFormat::json:
    return fmt::print("{}\n", json_text(json));
  case ReportFormat::csv:
    return fmt::print("{}", csv_of(json));
  }
}

} // namespace masu
