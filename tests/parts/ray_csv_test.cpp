// Lists of rays as text: whatever the columns' order and the pieces in which it is read, the same rays; and
// errors with line and column.
#include "tools/lists/ray_csv.h"

#include "tests/random_test.h"
#include "tests/refused.h"

#include <fmt/format.h>

namespace masu {
namespace {

using RayCsvs = RandomTest;

struct Rays {
  int numbers = 0;
  std::vector<double> rays;

  bool operator==(const Rays&) const = default;
};

// Of pieces of so many bytes, so many rays at a time.
Rays read(std::string_view text, std::size_t piece = 1'000'000, std::size_t count = 1'000'000) {
  RayCsv csv("a.csv");
  Rays read;
  std::string known;
  std::size_t next = 0;
  const auto more = [&] {
    known += text.substr(next, piece);
    next = std::min(next + piece, text.size());
    return next == text.size();
  };
  bool is_all = more();
  for (std::size_t taken = 0; (taken = csv.read_names(known, is_all)) == 0; is_all = more()) {
  }
  // The names' line is taken by the call that read it.
  RayCsv again("a.csv");
  known.erase(0, again.read_names(known, is_all));
  for (;;) {
    known.erase(0, again.read_rays(known, is_all, count, read.rays));
    if (is_all && known.empty()) break;
    if (!is_all) is_all = more();
  }
  read.numbers = again.numbers();
  return read;
}

constexpr double infinity = std::numeric_limits<double>::infinity();

TEST_F(RayCsvs, ColumnsAreKnownByTheirNames) {
  const Rays six{6, {1, 2, 3, 4, 5, 6}}, eight{8, {1, 2, 3, 0.5, 4, 5, 6, 7}};
  EXPECT_EQ(read("ox,oy,oz,dx,dy,dz\n1,2,3,4,5,6\n"), six);
  EXPECT_EQ(read("dz,dy,dx,oz,oy,ox\n6,5,4,3,2,1"), six);
  EXPECT_EQ(read("ox,oy,oz,tmin,dx,dy,dz,tmax\n1,2,3,0.5,4,5,6,7\n"), eight);
  EXPECT_EQ(read("tmax,tmin,ox,oy,oz,dx,dy,dz\n7,.5,1,2,3,4,5,6\n"), eight);
  EXPECT_EQ(read("ox,oy,oz,dx,dy,dz,tmax\n1,2,3,4,5,6,7\n"), (Rays{8, {1, 2, 3, 0, 4, 5, 6, 7}}));
  EXPECT_EQ(read("ox,oy,oz,tmin,dx,dy,dz\n1,2,3,7,4,5,6\n"), (Rays{8, {1, 2, 3, 7, 4, 5, 6, infinity}}));
  EXPECT_EQ(read("ox,oy,oz,dx,dy,dz\n"), (Rays{6, {}}));
}

// As spreadsheets, NumPy's savetxt() and Windows write it.
TEST_F(RayCsvs, BlanksLineEndsAndMarksMakeNoDifference) {
  const Rays expected{6, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}};
  for (const char* const text :
       {"ox,oy,oz,dx,dy,dz\r\n1,2,3,4,5,6\r\n7,8,9,10,11,12\r\n",
        "# ox,oy,oz,dx,dy,dz\n1,2,3,4,5,6\n7,8,9,10,11,12",
        "\xef\xbb\xbfox,oy,oz,dx,dy,dz\n1,2,3,4,5,6\n7,8,9,10,11,12\n",
        "\n\n ox , oy,\toz,dx,dy,dz\n\n1, 2 ,3,4,5,6 \n \n\n7,8,9,10,11,12\n\n",
        "#ox,oy,oz,dx,dy,dz\n1.000000000000000000e+00,2e0,3.,4,5,0.6e1\n7,8,9,1e1,11,12\n"})
    EXPECT_EQ(read(text), expected) << text;
}

TEST_F(RayCsvs, NumbersAreTheNearest) {
  EXPECT_EQ(read("ox,oy,oz,dx,dy,dz\n0.1,-1e-320,1e-400,inf,-infinity,1.7976931348623157e308\n").rays,
            (std::vector<double>{0.1, -1e-320, 0, infinity, -infinity, std::numeric_limits<double>::max()}));
  EXPECT_TRUE(std::isnan(read("ox,oy,oz,dx,dy,dz\n1,2,3,4,5,nan\n").rays[5]));
}

TEST_F(RayCsvs, PiecesMakeNoDifference) {
  auto random = seed_.engine();
  std::string text = "ox,oy,oz,tmin,dx,dy,dz\n";
  for (int i = 0; i < 200; ++i) {
    for (int number = 0; number < 7; ++number)
      text += fmt::format("{}{}", number > 0 ? "," : "", static_cast<double>(random() % 100'000) / 1e3);
    text += random() % 8 == 0 ? "\r\n\n" : "\n";
  }
  const Rays whole = read(text);
  EXPECT_EQ(whole.rays.size(), 1600U);
  for (int i = 0; i < 100; ++i)
    EXPECT_EQ(read(text, 1 + random() % 300, 1 + random() % 50), whole);
  RayCsv csv("a.csv");
  std::uint64_t rays = 0;
  const std::size_t names = csv.read_names(text, true);
  EXPECT_EQ(csv.skip_rays(std::string_view(text).substr(names), true, 1000, rays), text.size() - names);
  EXPECT_EQ(rays, 200U);
}

TEST_F(RayCsvs, ErrorsNameLineAndColumn) {
  const auto refused = [](const std::string& text, const std::string& place, const std::string& says) {
    return is_refused([&](const std::string&) { read(text); }, place, says);
  };
  const std::string names = "ox,oy,oz,dx,dy,dz\n";
  EXPECT_TRUE(refused("", "a.csv", "has no line of columns' names"));
  EXPECT_TRUE(refused("\n \n", "a.csv", "has no line of columns' names"));
  EXPECT_TRUE(refused("1,2,3,4,5,6\n", "a.csv:1:1", "'1' isn't one of the columns"));
  EXPECT_TRUE(refused("\nox,oy,oz,dx,dy,w\n", "a.csv:2:16", "'w' isn't one of the columns"));
  EXPECT_TRUE(refused("ox,oy,oz,dx,dy,ox,dz\n", "a.csv:1:16", "has ox twice"));
  EXPECT_TRUE(refused("ox,oy,oz,dx,dy\n", "a.csv:1:1", "has no column dz"));
  EXPECT_TRUE(refused("ox oy oz dx dy dz\n", "a.csv:1:1", "isn't one of the columns"));
  EXPECT_TRUE(refused(names + "1,2,3,4,5,6\n\n1,2,x,4,5,6\n", "a.csv:4:5", "'x' isn't a number"));
  EXPECT_TRUE(refused(names + "1,2, 3 4,5,6\n", "a.csv:2:6", "'3 4' isn't a number"));
  EXPECT_TRUE(refused(names + "1,2,,4,5,6\n", "a.csv:2:5", "'' isn't a number"));
  EXPECT_TRUE(refused(names + "1,2,0x3,4,5,6\n", "a.csv:2:5", "'0x3' isn't a number"));
  EXPECT_TRUE(refused(names + "1,2,3,4,5\n", "a.csv:2:10", "must have 6 numbers"));
  EXPECT_TRUE(refused(names + "1,2,3,4,5,6,7\n", "a.csv:2:12", "must have 6 numbers"));
  EXPECT_TRUE(refused(names + "1,2,3,4,5,6,\n", "a.csv:2:12", "must have 6 numbers"));
  EXPECT_TRUE(refused(names + "1,1e999,3,4,5,6\n", "a.csv:2:3", "'1e999' is too large"));
  EXPECT_TRUE(refused(names + "1," + std::string(100, 'y'), "a.csv:2:3", "'yyyyyyyyyyyyyyyyyyyyyyyy...'"));
}

// Which never end: of a device, or of a program that doesn't write what it should.
TEST_F(RayCsvs, EndlessLinesAreRefused) {
  RayCsv csv("a.csv");
  const std::string line(100'000, '1');
  EXPECT_TRUE(
      is_refused([&](const std::string&) { csv.read_names(line, false); }, "a.csv:1", "is longer than"));
  csv.read_names("ox,oy,oz,dx,dy,dz\n", false);
  std::vector<double> rays;
  EXPECT_TRUE(is_refused([&](const std::string&) { csv.read_rays(line, false, 1, rays); }, "a.csv:2",
                         "is longer than"));
}

} // namespace
} // namespace masu
