// gridstat: statistics of a grid or a hierarchy, pictures of its slices, its cells as boxes, and the occupied
// voxels of a scene.
#include "libgrid/statistics/statistics.h"
#include "libscene/file/output_file.h"
#include "libscene/file/scene_file.h"
#include "tools/common/cli.h"
#include "tools/common/json.h"
#include "tools/common/number_list.h"
#include "tools/common/print.h"
#include "tools/draw/slice_picture.h"
#include "tools/report/cell_export.h"
#include "tools/report/slice_json.h"
#include "tools/report/structure_report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <vector>

namespace masu {
namespace {

struct Settings {
  std::string grid, slice, window, outline, picture, cells, occupancy;
  std::vector<double> within;
  std::optional<std::int32_t> depth;
  SliceStyle style;
  CellExport cell_export;
  std::vector<std::int32_t> divisions{2, 4, 8, 16, 32};
  SpaceRule space = SpaceRule::cube;
  bool json = false, csv = false, histogram = false;
};

// Reads AXIS=K (a layer of the smallest voxels), AXIS=P% (of the space), AXIS@X (scene units), such as z=12,
// z=50%, z@0.75. Throws Error(usage, "--slice", …).
SlicePlane parse_slice(const std::string& text, const GridLayout& finest) {
  constexpr const char* place = "--slice";
  const auto fail = [&]() -> SlicePlane {
    throw Error(ErrorCode::usage, place,
                fmt::format("'{}' isn't AXIS=K, AXIS=P% or AXIS@X with axis x, y or z", text));
  };
  if (text.size() < 3 || text[0] < 'x' || text[0] > 'z' || (text[1] != '=' && text[1] != '@')) return fail();
  const int axis = text[0] - 'x';
  const bool is_share = text[1] == '=' && text.back() == '%';
  const std::string_view number = std::string_view(text).substr(2, text.size() - (is_share ? 3 : 2));
  if (text[1] == '=' && !is_share) {
    const auto layer = read_number<std::int64_t>(number);
    return layer ? plane_of_layer(finest, axis, *layer, place) : fail();
  }
  const double value = read_number<double>(number).value_or(NAN);
  if (!std::isfinite(value)) return fail();
  if (text[1] == '@') return plane_at(finest, axis, value, place);
  if (!(value >= 0 && value <= 100))
    throw Error(ErrorCode::usage, place, fmt::format("'{}' lies outside: give 0% to 100%", text));
  return plane_at_share(finest, axis, value / 100, place);
}

// Reads LEFT,BOTTOM,RIGHT,TOP in scene units, along the picture's axes, and cuts it to the space; empty: the
// whole layer. Throws Error(usage, "--window", …).
SliceWindow parse_window(const std::string& text, const GridLayout& finest, int axis) {
  const SliceWindow whole = window_of(finest, axis);
  if (text.empty()) return whole;
  const auto fail = [&](const std::string& why) {
    throw Error(ErrorCode::usage, "--window", fmt::format("'{}' {}", text, why));
  };
  std::array<double, 4> numbers{};
  if (!read_numbers(text, ',', numbers) ||
      !std::ranges::all_of(numbers, [](double number) { return std::isfinite(number); }))
    fail("isn't LEFT,BOTTOM,RIGHT,TOP in scene units");
  SliceWindow window{};
  const std::array<int, 2> axes = slice_axes(axis);
  for (std::size_t i = 0; i < 2; ++i) {
    window.min[i] = std::max(numbers[i], whole.min[i]);
    window.max[i] = std::min(numbers[i + 2], whole.max[i]);
    if (!(window.min[i] < window.max[i]))
      fail(fmt::format("has nothing of the grid's space: along {} that is from {} to {}", "xyz"[axes[i]],
                       whole.min[i], whole.max[i]));
  }
  // A plot needs coordinates that differ.
  for (std::size_t i = 0; i < 2; ++i) {
    if (window.max[i] - window.min[i] < 1e-12 * std::max(std::abs(window.min[i]), std::abs(window.max[i])))
      fail("is too small");
  }
  return window;
}

void draw_slice(const StructureFile& file, const Settings& settings) {
  if (settings.picture.empty())
    throw Error(ErrorCode::usage, "--slice", "needs -o FILE, a PNG, SVG or JSON to write");
  const GridLayout finest = finest_layout(file);
  const SlicePlane plane = parse_slice(settings.slice, finest);
  SliceWindow window = parse_window(settings.window, finest, plane.axis);
  window.depth = settings.depth;
  std::vector<CutSegment> outline;
  if (!settings.outline.empty()) {
    const SceneFile scene(settings.outline);
    file.check_geometry(scene.geometry_hash(), scene.primitive_count());
    outline = outline_of(scene, plane, window, 0.1 / settings.style.size); // a tenth of a pixel
  }
  write_slice(file, plane, window, outline, settings.style, settings.picture);
}

void write_cells(const StructureFile& file, const Settings& settings) {
  CellExport options = settings.cell_export;
  if (options.expanded && file.is_hierarchy())
    throw Error(ErrorCode::usage, "--expanded", "needs a grid of cells: a hierarchy has none");
  if (!settings.within.empty()) {
    const auto& w = settings.within;
    const Boxd box{{w[0], w[1], w[2]}, {w[3], w[4], w[5]}};
    const bool is_finite = std::ranges::all_of(w, [](double value) { return std::isfinite(value); });
    if (!is_finite || is_empty(box))
      throw Error(ErrorCode::usage, "--within", "isn't a box: give the least x, y, z, then the greatest");
    options.filter.within = box;
  }
  export_cells(file, options, settings.cells);
}

// Counted as in the 2012 thesis: within the objects' bounds, without a margin.
template <class Stored>
void print_occupancy(const Settings& settings, const SceneView<Stored>& scene, Boxd space) {
  if (is_empty(space))
    throw Error(ErrorCode::input, settings.occupancy, "holds no object: there is nothing to divide");
  if (settings.space == SpaceRule::cube) {
    const double half = largest_magnitude(space);
    space = {{-half, -half, -half}, {half, half, half}};
  }
  Json rows = Json::array();
  for (const std::int32_t n : settings.divisions) {
    if (n < 1 || n > 1024) throw Error(ErrorCode::usage, "--divisions", "each must be between 1 and 1024");
    const GridLayout layout{space, {n, n, n}, 0};
    const std::uint64_t voxels = voxel_count(layout.division);
    const auto occupied = [&](std::uint64_t count) {
      return Json{{"occupied", count}, {"percent", percent(count, voxels)}};
    };
    rows.push_back({{"division", n},
                    {"voxels", voxels},
                    {"half_open_box", occupied(occupied_half_open(scene, layout))},
                    {"box", occupied(occupied_voxels(scene, layout, Overlap::box))},
                    {"exact", occupied(occupied_voxels(scene, layout, Overlap::exact))}});
    rows.back().update(program_version());
  }
  if (settings.json) return fmt::print("{}\n", json_text(rows));
  fmt::print(
      "{} primitives in a {} space: occupied voxels, by overlap test\n\n{:>8} {:>13} {:>18} {:>18} {:>18}\n",
      grouped(scene.primitive_count()), settings.space == SpaceRule::cube ? "cubic" : "tight", "division",
      "voxels", "half-open box", "box", "exact");
  for (const Json& row : rows) {
    fmt::print("{:>6}^3 {:>13}", row["division"].get<int>(), grouped(row["voxels"].get<std::uint64_t>()));
    for (const char* const test : {"half_open_box", "box", "exact"}) {
      fmt::print(" {:>9} {:>6.2f} %", grouped(row[test]["occupied"].get<std::uint64_t>()),
                 row[test]["percent"].get<double>());
    }
    fmt::print("\n");
  }
}

void add_options(const CommandLine& command, Settings& settings) {
  const Option grid = command.add_option("GRID", settings.grid, "grid file, from gridbuild");
  command.footer("Example:\n  gridstat balls.grid --slice z=50% -o slice.png");
  command.group("Statistics");
  const Option json = command.add_flag("--json", settings.json, "print JSON");
  const Option csv = command.add_flag(
      "--csv", settings.csv, "print CSV: a header and one line, the same columns for every grid of cells");
  const Option histogram =
      command.add_flag("--histogram", settings.histogram,
                       "also print the number of cells by references, and of merged cells by size");

  command.group("Slices");
  const Option slice = command.add_option("--slice", settings.slice,
                                          "draw the cells or boxes that a plane cuts: AXIS=K, a layer of the "
                                          "smallest voxels; AXIS=P%, of the space; AXIS@X, in scene units",
                                          "PLANE");
  command.add_file("-o,--output", settings.picture, "of --slice: FILE.png, FILE.svg or FILE.json");
  command.add_option("--window", settings.window, "of --slice: what to show, in scene units; default: all",
                     "LEFT,BOTTOM,RIGHT,TOP");
  command.add_option("--outline", settings.outline,
                     "of --slice: the grid's scene file, whose cut through the plane is drawn", "SCENE");
  SliceStyle& style = settings.style;
  command.add_choice(
      "--color", style.color,
      {{"references", SliceColor::references}, {"volume", SliceColor::volume}, {"depth", SliceColor::depth}},
      "of --slice: what a cell's colour shows: its references, its volume in voxels of the division (of "
      "grids alone), or its depth");
  command
      .add_option("--depth", settings.depth,
                  "of --slice: only boxes of nodes of this depth, the root's is 0; of a grid, cells down to "
                  "which a voxel is halved so often")
      .range(0, max_hierarchy_depth);
  command
      .add_option("--color-high", style.high,
                  "of --slice: the references or the depth that the darkest colour stands for, so that "
                  "slices can be compared; default: the most that is shown")
      .range(1, 1 << 30);
  command.add_flag("--lines", style.lines, "of --slice: draw the cells' sides");
  command.add_option("--title", style.title, "of --slice: instead of the grid's name and the plane");
  command.add_number("--size", style.size, least_slice_size, most_slice_size,
                     "of --slice: pixels of the longer side");

  command.group("Cells");
  const Option cells = command.add_file(
      "--cells", settings.cells, "write all cells as boxes: FILE.csv, or FILE.ply for viewers of meshes");
  CellExport& cell_export = settings.cell_export;
  command.add_flag("--occupied", cell_export.filter.occupied_only, "of --cells: only those with references");
  command
      .add_option("--within", settings.within,
                  "of --cells: only those that share space with the box between two corners, in scene units",
                  "X,Y,Z,X,Y,Z")
      .comma_separated()
      .values(6, 6);
  command.add_flag("--expanded", cell_export.expanded,
                   "of --cells FILE.ply: the boxes that rays leave cells through, which may overlap");
  command.add_flag("--wireframe", cell_export.wireframe, "of --cells FILE.ply: edges instead of faces");

  command.group("Occupancy of a scene");
  const Option occupancy = command.add_option(
      "--occupancy", settings.occupancy,
      "instead of GRID: a scene file, whose occupied voxels are counted by division and overlap test",
      "SCENE");
  command.add_option("--divisions", settings.divisions, "of --occupancy: voxels per axis", "LIST")
      .comma_separated()
      .shows_default();
  command.add_choice("--space", settings.space, {{"tight", SpaceRule::tight}, {"cube", SpaceRule::cube}},
                     "of --occupancy: the objects' bounds (tight), or the smallest cube centred on the "
                     "origin that holds them (cube)");
  // Options of a group need what comes first in it, which goes with none of other groups.
  command.group_needs("Slices", slice);
  command.group_needs("Cells", cells);
  command.group_needs("Occupancy of a scene", occupancy);
  csv.excludes({json, histogram});
  slice.excludes({json, csv, histogram});
  cells.excludes({slice, json, csv, histogram});
  occupancy.excludes({grid, slice, cells, csv, histogram});
}

void run(const Settings& settings) {
  const auto ends_with_one_of = [](const std::string& name, std::initializer_list<const char*> endings) {
    return name.empty() ||
           std::ranges::any_of(endings, [&](const char* ending) { return name.ends_with(ending); });
  };
  if (!ends_with_one_of(settings.picture, {".png", ".svg", ".json"}))
    throw Error(ErrorCode::usage, settings.picture,
                "a slice is a PNG, SVG or JSON: name it .png, .svg or .json");
  if (!ends_with_one_of(settings.cells, {".csv", ".ply"}))
    throw Error(ErrorCode::usage, settings.cells, "cells are written as CSV or PLY: name it .csv or .ply");
  if (settings.cells.ends_with(".csv") && (settings.cell_export.expanded || settings.cell_export.wireframe))
    throw Error(ErrorCode::usage, settings.cell_export.expanded ? "--expanded" : "--wireframe",
                "is for PLY: a CSV has both boxes of each cell");
  check_files({settings.grid, settings.outline, settings.occupancy}, {settings.picture, settings.cells});
  if (!settings.occupancy.empty()) {
    const SceneFile scene(settings.occupancy);
    return scene.with_view([&](const auto& view) { print_occupancy(settings, view, scene.bounds()); });
  }
  if (settings.grid.empty()) throw Error(ErrorCode::usage, "GRID", "is missing: name the grid file");
  const StructureFile file(settings.grid);
  if (!settings.slice.empty()) return draw_slice(file, settings);
  if (!settings.cells.empty()) return write_cells(file, settings);
  print_structure_report(file,
                         settings.json  ? ReportFormat::json
                         : settings.csv ? ReportFormat::csv
                                        : ReportFormat::table,
                         settings.histogram);
}

} // namespace
} // namespace masu

int main(int argc, char** argv) {
  using namespace masu;
  return run_tool("gridstat",
                  "Prints statistics of a grid or a hierarchy, draws slices of it, or exports its cells.",
                  argc, argv, add_options, run);
}
