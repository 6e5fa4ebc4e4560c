// gridstat: what a grid holds, in numbers and as a picture; and the founding study's occupancy table of a
// scene.
#include "libgrid/grid_file.h"
#include "libgrid/statistics.h"
#include "libscene/output_file.h"
#include "libscene/scene_file.h"
#include "renderer/png_file.h"
#include "tools/cli.h"

#include <nlohmann/json.hpp>

#include <vector>

namespace masu {
namespace {

using Json = nlohmann::ordered_json;

struct Settings {
  std::string grid, slice, picture, study;
  std::vector<std::int32_t> divisions{2, 4, 8, 16, 32};
  SpaceRule space = SpaceRule::cube;
  bool json = false, csv = false, histogram = false;
};

Json vector_json(const fb::Vec3& v) {
  return {v.x(), v.y(), v.z()};
}

double percent(std::uint64_t part, std::uint64_t whole) {
  return 100.0 * static_cast<double>(part) / static_cast<double>(whole);
}

Json report(const GridFile& file, const GridStatistics& s, bool histogram) {
  const fb::Grid& table = file.table();
  const fb::Division& n = *table.division();
  const auto bytes = [](const auto& records) { return records.size_bytes(); };
  Json json{
      {"space", {{"min", vector_json(table.space()->min())}, {"max", vector_json(table.space()->max())}}},
      {"division", {n.x(), n.y(), n.z()}},
      {"voxels", s.voxels},
      {"occupied_voxels", s.occupied_voxels},
      {"empty_voxels", s.voxels - s.occupied_voxels},
      {"occupancy_percent", percent(s.occupied_voxels, s.voxels)},
      {"cells", s.cells},
      {"occupied_cells", s.occupied_cells},
      {"empty_cells", s.cells - s.occupied_cells},
      {"references", s.references},
      {"references_per_occupied_cell",
       {{"mean", s.mean},
        {"stddev", s.stddev},
        {"median", s.median},
        {"p99", s.p99},
        {"min", s.min},
        {"max", s.max}}},
      {"bytes",
       {{"file", file.bytes()},
        {"voxel_map", bytes(file.voxel_map())},
        {"cells", bytes(file.cells())},
        {"references", bytes(file.references())}}},
      {"merge", fb::EnumNameMerge(table.merge())},
      {"overlap", fb::EnumNameOverlap(table.overlap())},
      {"space_rule", fb::EnumNameSpace(table.space_rule())},
      {"division_rule", table.division_rule()->str()},
      {"scene_hash", to_hex({table.scene_hash()->low(), table.scene_hash()->high()})},
      {"build_seconds", nullptr},
  };
  if (table.build_seconds() >= 0) json["build_seconds"] = table.build_seconds();
  if (histogram) {
    for (std::size_t references = 0; references < s.histogram.size(); ++references) {
      if (s.histogram[references] > 0) json["histogram"].push_back({references, s.histogram[references]});
    }
  }
  return json;
}

// Nested keys joined by points, one header line and one line of values.
void print_csv(const Json& json) {
  std::string head, values;
  const Json flat = json.flatten();
  for (const auto& [path, value] : flat.items()) {
    std::string name = path.substr(1);
    std::replace(name.begin(), name.end(), '/', '.');
    head += (head.empty() ? "" : ",") + name;
    values += (values.empty() ? "" : ",") + (value.is_string() ? value.get<std::string>() : value.dump());
  }
  fmt::print("{}\n{}\n", head, values);
}

void print_table(const GridFile& file, const GridStatistics& s, const Json& json) {
  const fb::Grid& table = file.table();
  const fb::Vec3 &low = table.space()->min(), &high = table.space()->max();
  const fb::Division& n = *table.division();
  const auto line = [](const char* name, const std::string& value) {
    fmt::print("{:<28} {}\n", name, value);
  };
  line("space", fmt::format("({:g}, {:g}, {:g}) to ({:g}, {:g}, {:g}), {}", low.x(), low.y(), low.z(),
                            high.x(), high.y(), high.z(), fb::EnumNameSpace(table.space_rule())));
  line("division", fmt::format("{} x {} x {} ({})", n.x(), n.y(), n.z(), table.division_rule()->str()));
  line("voxels", fmt::format("{}", s.voxels));
  line("  occupied", fmt::format("{} ({:.3g} %)", s.occupied_voxels, percent(s.occupied_voxels, s.voxels)));
  line("  empty", fmt::format("{}", s.voxels - s.occupied_voxels));
  line("cells", fmt::format("{}, {} occupied", s.cells, s.occupied_cells));
  line("references", fmt::format("{}", s.references));
  line("  per occupied cell",
       fmt::format("mean {:.2f}, stddev {:.2f}, median {:g}, 99 % {}, least {}, most {}", s.mean, s.stddev,
                   s.median, s.p99, s.min, s.max));
  const Json& bytes = json["bytes"];
  line("bytes", fmt::format("{} (voxel map {}, cells {}, references {})", bytes["file"].dump(),
                            bytes["voxel_map"].dump(), bytes["cells"].dump(), bytes["references"].dump()));
  line("merge, overlap",
       fmt::format("{}, {}", fb::EnumNameMerge(table.merge()), fb::EnumNameOverlap(table.overlap())));
  line("scene", json["scene_hash"].get<std::string>());
}

void print_histogram(const GridStatistics& s) {
  std::uint64_t most = 1;
  for (const std::uint64_t cells : s.histogram)
    most = std::max(most, cells);
  fmt::print("\nreferences      cells\n");
  for (std::size_t references = 0; references < s.histogram.size(); ++references) {
    if (s.histogram[references] == 0) continue;
    const auto bar = static_cast<std::size_t>(50 * static_cast<double>(s.histogram[references]) /
                                              static_cast<double>(most));
    fmt::print("{:10} {:10} {}\n", references, s.histogram[references], std::string(bar, '#'));
  }
}

struct Slice {
  int axis;
  std::int32_t at;
};

Slice slice_of(const std::string& text, const Vec3i& division) {
  int at = 0, end = 0;
  char axis = 0;
  if (std::sscanf(text.c_str(), "%c=%d%n", &axis, &at, &end) != 2 ||
      static_cast<std::size_t>(end) != text.size() || axis < 'x' || axis > 'z') {
    throw Error(ErrorCode::usage, "--slice", fmt::format("'{}' isn't AXIS=K with axis x, y or z", text));
  }
  const int number = axis - 'x';
  if (at < 0 || at >= division[number]) {
    throw Error(
        ErrorCode::usage, "--slice",
        fmt::format("'{}' lies outside: the division has {} voxels along {}", text, division[number], axis));
  }
  return {number, at};
}

// White is empty; from light yellow over red to black the references double at each step.
std::array<std::uint8_t, 3> color_of(std::uint32_t references) {
  if (references == 0) return {255, 255, 255};
  const double step = std::min(1.0, std::log2(static_cast<double>(references)) / 8);
  const auto channel = [](double value) {
    return static_cast<std::uint8_t>(255 * std::clamp(value, 0.0, 1.0));
  };
  return {channel(1.9 - 1.9 * step), channel(0.85 - 1.6 * step), channel(0.45 - 1.6 * step)};
}

// A layer of voxels as a picture: the second of the other two axes points up. Small grids are drawn with
// squares, and of a large one each pixel shows the fullest of its voxels.
void draw_slice(const GridFile& file, const Slice& slice, const std::string& path) {
  constexpr std::int32_t wanted = 768, most = 4096;
  const GridView<double> grid = file.view<double>();
  const int u = slice.axis == 0 ? 1 : 0, v = slice.axis == 2 ? 1 : 2;
  const std::int32_t columns = grid.division[u], rows = grid.division[v], longest = std::max(columns, rows);
  const std::int32_t square = std::max(1, wanted / longest), share = (longest + most - 1) / most;
  const std::int32_t width = (columns + share - 1) / share * square,
                     height = (rows + share - 1) / share * square;
  std::vector<std::uint8_t> rgb;
  rgb.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3);
  for (std::int32_t row = height - 1; row >= 0; --row) {
    for (std::int32_t column = 0; column < width; ++column) {
      std::uint32_t fullest = 0;
      const std::int32_t first_u = column / square * share, first_v = row / square * share;
      for (std::int32_t j = first_v; j < std::min(first_v + share, rows); ++j) {
        for (std::int32_t i = first_u; i < std::min(first_u + share, columns); ++i) {
          Vec3i voxel{};
          voxel.set(slice.axis, slice.at);
          voxel.set(u, i);
          voxel.set(v, j);
          fullest = std::max(fullest, references_in(grid, voxel));
        }
      }
      const auto color = color_of(fullest);
      rgb.insert(rgb.end(), color.begin(), color.end());
    }
  }
  write_png(rgb, width, height, path);
}

void inspect(const Settings& settings) {
  const GridFile file(settings.grid);
  if (!settings.slice.empty()) {
    if (settings.picture.empty())
      throw Error(ErrorCode::usage, "--slice", "needs -o PNG, the picture to write");
    return draw_slice(file, slice_of(settings.slice, file.lattice().division), settings.picture);
  }
  const GridStatistics statistics = file.is_merged()
                                        ? grid_statistics(file.merged_view<double>(), file.cells())
                                        : grid_statistics(file.view<double>(), file.references());
  const Json json = report(file, statistics, settings.histogram);
  if (settings.json) {
    fmt::print("{}\n", json.dump(2));
  } else if (settings.csv) {
    print_csv(json);
  } else {
    print_table(file, statistics, json);
    if (settings.histogram) print_histogram(statistics);
  }
}

// The study divides the objects' own space, without any margin.
template <class Stored>
void study(const Settings& settings, const SceneFile& file) {
  const SceneView<Stored> scene = file.view<Stored>();
  Boxd space = file.bounds();
  if (is_empty(space))
    throw Error(ErrorCode::input, settings.study, "holds no object: there is nothing to divide");
  if (settings.space == SpaceRule::cube) {
    const double half = largest_magnitude(space);
    space = {{-half, -half, -half}, {half, half, half}};
  }
  Json rows = Json::array();
  for (const std::int32_t n : settings.divisions) {
    if (n < 1 || n > 1024) throw Error(ErrorCode::usage, "--divisions", "each must be between 1 and 1024");
    const Lattice lattice{space, {n, n, n}, 0};
    const std::uint64_t voxels = voxel_count(lattice.division);
    const auto occupied = [&](std::uint64_t count) {
      return Json{{"occupied", count}, {"percent", percent(count, voxels)}};
    };
    rows.push_back({{"division", n},
                    {"voxels", voxels},
                    {"half_open_box", occupied(occupied_half_open(scene, lattice))},
                    {"box", occupied(occupied_voxels(scene, lattice, Overlap::box))},
                    {"exact", occupied(occupied_voxels(scene, lattice, Overlap::exact))}});
  }
  if (settings.json) return fmt::print("{}\n", rows.dump(2));
  fmt::print(
      "{} primitives in a {} space: voxels that hold one, by test\n\n{:>8} {:>11} {:>21} {:>21} {:>21}\n",
      scene.primitive_count(), settings.space == SpaceRule::cube ? "cubic" : "tight", "division", "voxels",
      "box, half-open voxels", "box", "exact");
  for (const Json& row : rows) {
    fmt::print("{:>6}^3 {:>11}", row["division"].get<int>(), row["voxels"].get<std::uint64_t>());
    for (const char* const test : {"half_open_box", "box", "exact"}) {
      fmt::print(" {:>11} {:>7.2f} %", row[test]["occupied"].get<std::uint64_t>(),
                 row[test]["percent"].get<double>());
    }
    fmt::print("\n");
  }
}

} // namespace
} // namespace masu

int main(int argc, char** argv) {
  using namespace masu;
  return run_tool("gridstat", "Shows what a grid holds.", argc, argv, [](CLI::App& app, const auto& parse) {
    Settings settings;
    auto* const grid = app.add_option("GRID", settings.grid, "grid file, from gridbuild");
    app.add_flag("--json", settings.json, "as JSON");
    app.add_flag("--csv", settings.csv, "as a line of names and a line of values")->excludes("--json");
    app.add_flag("--histogram", settings.histogram, "with the number of cells for each number of references");
    app.add_option("--slice", settings.slice, "draw a layer of voxels: AXIS=K, such as z=12");
    app.add_option("-o,--output", settings.picture, "the slice's PNG");
    auto* const study_option =
        app.add_option("--study", settings.study,
                       "instead: a scene's occupied voxels by division, both overlap tests")
            ->excludes(grid);
    app.add_option("--divisions", settings.divisions, "the study's divisions, N voxels an axis")
        ->delimiter(',')
        ->capture_default_str()
        ->needs(study_option);
    add_choice(app, "--space", settings.space, {{"tight", SpaceRule::tight}, {"cube", SpaceRule::cube}},
               "the study's space: tight, or cube (about the origin)")
        ->needs(study_option);
    parse();
    if (!settings.study.empty()) {
      const SceneFile scene(settings.study);
      return scene.is_float64() ? study<double>(settings, scene) : study<float>(settings, scene);
    }
    if (settings.grid.empty()) throw Error(ErrorCode::usage, "GRID", "is missing: name the grid file");
    inspect(settings);
  });
}
