// gridstat's slices and exported cells, end to end.
#include "libgrid/statistics/cells.h"
#include "tests/decoded_image.h"
#include "tests/tools/run_tool.h"
#include "tools/common/color_map.h"
#include "tools/common/json.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace masu {
namespace {

const std::vector<std::string> merges{"none", "x", "balance", "irregular"};

// The texts of the titles and descriptions of an SVG, as a parser of XML reads them; none where it refuses
// it.
struct SvgTexts {
  std::vector<std::string> titles, descriptions;
};
SvgTexts svg_texts(const std::string& path) {
  const ToolResult parsed = run(
      "/usr/bin/env", {"python3", "-c",
                       "import json, sys, xml.etree.ElementTree as tree\n"
                       "root = tree.parse(sys.argv[1]).getroot()\n"
                       "print(json.dumps([[one.text for one in root.iter('{http://www.w3.org/2000/svg}' + "
                       "name)] for name in ('title', 'desc')]))",
                       path});
  EXPECT_EQ(parsed.code, 0) << "python3 is needed: " << parsed.err;
  const Json texts = Json::parse(parsed.out, nullptr, false);
  return texts.is_discarded() ? SvgTexts{} : SvgTexts{texts[0], texts[1]};
}

class SliceTool : public ToolTest {
protected:
  Json json_slice(const std::string& grid, const Arguments& more) {
    expect_run("gridstat", joined({grid, "-o", file("slice.json")}, more));
    return json_in("slice.json");
  }

  std::vector<std::vector<double>> csv_cells(const std::string& grid, const Arguments& more = {}) {
    expect_run("gridstat", joined({grid, "--cells", file("cells.csv")}, more));
    return read_csv<double>(file("cells.csv")).rows;
  }

  const std::string scene_ = scene("a.scene", spd("a.nff", "balls", 2));
};

TEST_F(SliceTool, AnSvgIsWellFormedXmlWhateverItsTitle) {
  const std::string path = grid("a.grid", scene_, "6", {"--merge", "irregular"});
  const std::vector<std::string> titles{"balls",
                                        "<&\"'>",
                                        "]]>",
                                        "a\nb\x01\x7f",
                                        "caf\xc3\xa9 \xe5\x8d\x87",
                                        "\xff\xc0\x80\xed\xa0\x80\xef\xbf\xbf\xf5\x80\x80\x80\xc3"};
  for (const std::string& title : titles) {
    for (const char* const color : {"references", "volume", "depth"}) {
      expect_run("gridstat", {path, "--slice", "z=50%", "--outline", scene_, "--lines", "--title", title,
                              "--color", color, "-o", file("s.svg")});
      EXPECT_EQ(svg_texts(file("s.svg")).titles.size(), 1U) << title;
      EXPECT_NE(read_text(file("s.svg")).find("\n<svg xmlns=\"http://www.w3.org/2000/svg\""),
                std::string::npos);
    }
  }
  EXPECT_NE(read_text(file("s.svg")).find("\\xff\\xc0"), std::string::npos); // bytes that aren't UTF-8
}

// Labels are outlines of letters in an SVG: what they say is in its title and description, too.
TEST_F(SliceTool, APictureNamesAxesPlaneAndLegend) {
  const std::string path = grid("a.grid", scene_, "6");
  for (const auto& [axis, right, up] : {std::array{"x", "y", "z"}, {"y", "x", "z"}, {"z", "x", "y"}}) {
    expect_run("gridstat", {path, "--slice", std::string(axis) + "=2", "-o", file("s.svg")});
    const SvgTexts texts = svg_texts(file("s.svg"));
    ASSERT_EQ(texts.titles.size(), 1U);
    ASSERT_EQ(texts.descriptions.size(), 1U);
    const std::string title = texts.titles[0], description = texts.descriptions[0];
    EXPECT_TRUE(title.starts_with("a.grid, " + std::string(axis) + " = ")) << title;
    EXPECT_TRUE(title.ends_with("(layer 2 of 6)")) << title;
    for (const char* const part : {"uniform grid, 6 x 6 x 6 voxels", "Colour: references, ", "white: empty"})
      EXPECT_NE(description.find(part), std::string::npos) << description;
    EXPECT_NE(description.find("Right: " + std::string(right) + " (scene units)"), std::string::npos);
    EXPECT_NE(description.find("Up: " + std::string(up) + " (scene units)"), std::string::npos);
    EXPECT_NE(description.find("gridstat " + path), std::string::npos) << description;
  }
}

TEST_F(SliceTool, SlicesOfDifferentGridsHaveTheScaleThatIsAskedFor) {
  for (const char* const division : {"3", "9"}) {
    grid("a.grid", scene_, division);
    for (const auto& [color, scale] :
         {std::array{"references", "references, 1 to 500"}, {"depth", "depth of nesting, 0 to 500"}}) {
      expect_runs(std::string("gridstat ~/a.grid --slice z=1 --color-high 500 -o ~/s.svg --color ") + color);
      const std::string svg = read_text(file("s.svg"));
      EXPECT_NE(svg.find(std::string("Colour: ") + scale), std::string::npos) << svg.substr(0, 1000);
    }
  }
}

TEST_F(SliceTool, WithoutFontsAPictureHasNoText) {
  const std::string path = grid("a.grid", scene_, "6");
  write_text(file("fonts.conf"), "<?xml version=\"1.0\"?><fontconfig></fontconfig>");
  const Surroundings surroundings{.environment = "FONTCONFIG_FILE=" + file("fonts.conf")};
  for (const std::string name : {"s.svg", "s.png"}) {
    const ToolResult result = run("gridstat", {path, "--slice", "z=2", "-o", file(name)}, surroundings);
    EXPECT_EQ(result.code, 0);
    EXPECT_EQ(std::ranges::count(result.err, '\n'), 1) << result.err;
    EXPECT_NE(result.err.find("no font was found"), std::string::npos) << result.err;
  }
  EXPECT_EQ(read_text(file("s.svg")).find("<use "), std::string::npos);
  EXPECT_GT(decoded_png(file("s.png")).width, 640U);
}

// A pixel shows the darkest of its cells: the picture, read back, is the JSON's cells in the colours of the
// map.
TEST_F(SliceTool, PixelsOfAPngAreTheCellsInTheirColors) {
  for (const std::string& merge : {std::string("none"), std::string("irregular")}) {
    const std::string path = grid("a.grid", scene_, "16", {"--merge", merge});
    const Json slice = json_slice(path, {"--slice", "z@0.05"});
    expect_run("gridstat", {path, "--slice", "z@0.05", "--size", "640", "-o", file("s.png")});
    const DecodedPng png = decoded_png(file("s.png"));
    const auto at = [&](std::size_t x, std::size_t y) {
      const std::size_t i = 3 * (y * png.width + x);
      return Rgb{png.rgb[i], png.rgb[i + 1], png.rgb[i + 2]};
    };
    // The plot: within the largest frame of black pixels.
    const auto is_black = [&](std::size_t x, std::size_t y) { return at(x, y) == Rgb{0, 0, 0}; };
    std::size_t left = 0, top = 0;
    for (std::size_t y = 0; y < png.height && top == 0; ++y) {
      std::size_t run_length = 0;
      for (std::size_t x = 0; x < png.width; ++x) {
        run_length = is_black(x, y) ? run_length + 1 : 0;
        if (run_length == 640) {
          left = x - 639;
          top = y;
        }
      }
    }
    ASSERT_GT(top, 0U);
    while (is_black(left + 320, top))
      ++top;
    while (is_black(left, top))
      ++left;
    double high = 0, low = 1e9;
    for (const Json& cell : slice["cells"]) {
      if (cell[4] == 0) continue;
      high = std::max(high, cell[4].get<double>());
      low = std::min(low, cell[4].get<double>());
    }
    ASSERT_GT(high, low);
    const ColorMap map = ColorMap::of_lists();
    const auto voxels = slice["voxels"];
    const double width = 640,
                 height = std::round(
                     640 * (slice["space"]["max"][1].get<double>() - slice["space"]["min"][1].get<double>()) /
                     (slice["space"]["max"][0].get<double>() - slice["space"]["min"][0].get<double>()));
    std::size_t compared = 0;
    for (const Json& cell : slice["cells"]) {
      const double x0 = cell[0].get<double>() / voxels[0].get<double>() * width,
                   x1 = cell[2].get<double>() / voxels[0].get<double>() * width;
      const double y0 = cell[1].get<double>() / voxels[1].get<double>() * height,
                   y1 = cell[3].get<double>() / voxels[1].get<double>() * height;
      if (x1 - x0 < 3 || y1 - y0 < 3) continue;
      const double references = cell[4].get<double>();
      const double share =
          high > 16 ? std::log(references / low) / std::log(high / low) : (references - low) / (high - low);
      const Rgb expected = references == 0 ? Rgb{255, 255, 255} : map(1 - share);
      const Rgb got = at(left + static_cast<std::size_t>((x0 + x1) / 2),
                         top + static_cast<std::size_t>(height - (y0 + y1) / 2));
      for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(got[i], expected[i], 1) << cell; // of the map's steps, the next at most
      ++compared;
    }
    EXPECT_GT(compared, 40U);
  }
}

TEST_F(SliceTool, PngAndSvgHaveTheSameSizeAndGrowWithIt) {
  grid("a.grid", scene_, "8x8x4");
  std::size_t last = 0;
  for (const char* const size : {"64", "200", "640", "1000"}) {
    expect_runs(std::string("gridstat ~/a.grid --slice z=1 -o ~/s[.png|.svg] --size ") + size);
    const DecodedPng png = decoded_png(file("s.png"));
    EXPECT_GT(png.width, last);
    last = png.width;
    const std::string sizes = fmt::format("width=\"{}\" height=\"{}\"", png.width, png.height);
    EXPECT_NE(read_text(file("s.svg")).find(sizes), std::string::npos);
  }
}

// tests/grid/slice_test.cpp has which cells they are.
TEST_F(SliceTool, JsonHasTheOutlineAndTheWindowAskedFor) {
  const std::string path = grid("a.grid", scene_, "16");
  EXPECT_GE(json_slice(path, {"--slice", "z@0", "--outline", scene_})["outline"].size(), 100U);
  const Json all = json_slice(path, {"--slice", "z@0"});
  EXPECT_TRUE(all["outline"].empty());
  const Json some = json_slice(path, {"--slice", "z@0", "--window", "-0.5,-0.5,0.5,1000"});
  EXPECT_LT(some["cells"].size(), all["cells"].size());
  EXPECT_GT(some["cells"].size(), 0U);
  EXPECT_EQ(some["window"]["max"][1], all["window"]["max"][1]); // cut to the space
  EXPECT_EQ(some["window"]["min"][0], -0.5);
}

TEST_F(SliceTool, ExportedCellsAreThoseOfTheGrid) {
  using Rows = std::vector<std::vector<double>>;
  for (const std::string& merge : merges) {
    const StructureFile divided(grid("a.grid", scene_, "5", {"--merge", merge}));
    const GridLayout finest = finest_layout(divided);
    Rows all;
    for_each_cell(divided, {whole_of(finest.division)}, [&](const GridCell& cell) {
      std::vector<double>& row = all.emplace_back(1, static_cast<double>(cell.number));
      for (const VoxelBox& voxels : {cell.box, cell.expanded}) {
        const Boxd box = box_in_scene(finest, voxels);
        row.insert(row.end(), {box.min.x, box.min.y, box.min.z, box.max.x, box.max.y, box.max.z});
      }
      row.insert(row.end(), {static_cast<double>(cell.references), cell.references > 0 ? 1.0 : 0.0,
                             static_cast<double>(cell.voxels)});
    });
    EXPECT_EQ(csv_cells(divided.path()), all);
    EXPECT_EQ(read_csv<double>(file("cells.csv")).names,
              "cell,min_x,min_y,min_z,max_x,max_y,max_z,expanded_min_x,expanded_min_y,expanded_min_z,"
              "expanded_max_x,expanded_max_y,expanded_max_z,references,occupied,voxels");
    Rows occupied = all, inside = all;
    std::erase_if(occupied, [](const auto& row) { return row[14] == 0; });
    EXPECT_EQ(csv_cells(divided.path(), {"--occupied"}), occupied);
    std::erase_if(inside, [](const auto& row) {
      return row[1] >= 0.25 || row[4] <= 0 || row[2] >= 0.25 || row[5] <= 0 || row[3] >= 0.25 || row[6] <= 0;
    });
    EXPECT_EQ(csv_cells(divided.path(), {"--within", "0,0,0,0.25,0.25,0.25"}), inside);
    EXPECT_TRUE(csv_cells(divided.path(), {"--within", "100,100,100,101,101,101"}).empty());
  }
}

// As a viewer reads it: corners, then faces or edges that name them.
TEST_F(SliceTool, APlyHasTheBoxOfEachCell) {
  for (const std::string& merge : merges) {
    const auto csv = csv_cells(grid("a.grid", scene_, "4", {"--merge", merge}));
    for (const bool expanded : {false, true}) {
      for (const bool wireframe : {false, true}) {
        expect_runs(std::string("gridstat ~/a.grid --cells ~/cells.ply") + (expanded ? " --expanded" : "") +
                    (wireframe ? " --wireframe" : ""));
        const std::string ply = read_text(file("cells.ply"));
        const std::string end = "end_header\n";
        const std::size_t body = ply.find(end) + end.size(), corners = 8 * csv.size();
        const std::string head = ply.substr(0, body);
        EXPECT_TRUE(head.starts_with("ply\nformat binary_little_endian 1.0\n"));
        EXPECT_NE(head.find("element vertex " + std::to_string(corners) + "\n"), std::string::npos);
        constexpr std::size_t corner_bytes = 3 * 8 + 3 + 4, face_bytes = 1 + 4 * 4, edge_bytes = 2 * 4;
        ASSERT_EQ(ply.size() - body,
                  corners * corner_bytes + csv.size() * (wireframe ? 12 * edge_bytes : 6 * face_bytes));
        std::vector<std::array<double, 3>> at(corners);
        for (std::size_t i = 0; i < corners; ++i) {
          std::memcpy(at[i].data(), ply.data() + body + i * corner_bytes, 3 * 8);
          float quality = 0;
          std::memcpy(&quality, ply.data() + body + i * corner_bytes + 3 * 8 + 3, 4);
          EXPECT_EQ(quality, csv[i / 8][13]);
        }
        const std::size_t box = expanded ? 7 : 1;
        double volume = 0;
        for (std::size_t i = 0; i < csv.size(); ++i) {
          const auto& row = csv[i];
          for (std::size_t axis = 0; axis < 3; ++axis) {
            EXPECT_EQ(at[8 * i][axis], row[box + axis]);
            EXPECT_EQ(at[8 * i + 7][axis], row[box + 3 + axis]);
          }
          volume += (row[box + 3] - row[box]) * (row[box + 4] - row[box + 1]) * (row[box + 5] - row[box + 2]);
        }
        const char* shape = ply.data() + body + corners * corner_bytes;
        const auto index = [&] {
          std::uint32_t number = 0;
          std::memcpy(&number, shape, 4);
          shape += 4;
          return number;
        };
        if (wireframe) { // each edge along one axis
          for (std::size_t i = 0; i < 12 * csv.size(); ++i) {
            const std::uint32_t a = index(), b = index();
            EXPECT_EQ(a / 8, b / 8);
            EXPECT_TRUE((a ^ b) == 1 || (a ^ b) == 2 || (a ^ b) == 4);
          }
        } else { // the divergence theorem: faces that close and point outwards enclose the boxes' volume
          double enclosed = 0;
          for (std::size_t i = 0; i < 6 * csv.size(); ++i) {
            ASSERT_EQ(*shape++, 4);
            std::array<std::uint32_t, 4> face{};
            for (std::uint32_t& corner : face)
              corner = index();
            for (std::size_t k = 1; k + 1 < 4; ++k) {
              const auto &a = at[face[0]], &b = at[face[k]], &c = at[face[k + 1]];
              enclosed += (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                           a[2] * (b[0] * c[1] - b[1] * c[0])) /
                          6;
            }
          }
          EXPECT_NEAR(enclosed, volume, 1e-6 * volume);
        }
      }
    }
  }
}

} // namespace
} // namespace masu
