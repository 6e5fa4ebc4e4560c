// Pages that Cairo draws.
#include "tests/decoded_image.h"
#include "tools/draw/drawing.h"

#include "libscene/base/error.h"

#include <array>
#include <random>
#include <set>

namespace masu {
namespace {

struct Pixels {
  std::int32_t width = 0, height = 0;
  Bytes rgb;

  Rgb at(std::int32_t x, std::int32_t y) const {
    const auto i = 3 * static_cast<std::size_t>(y * width + x);
    return {rgb[i], rgb[i + 1], rgb[i + 2]};
  }
};

class DrawingTest : public testing::Test {
protected:
  std::string file(const std::string& name) const { return folder_.file(name); }

  Pixels drawn(const Drawing& drawing) const {
    write_png(drawing, file("page.png"), {});
    const DecodedPng png = decoded_png(file("page.png"));
    const Pixels pixels{static_cast<std::int32_t>(png.width), static_cast<std::int32_t>(png.height), png.rgb};
    EXPECT_EQ(pixels.width, drawing.width);
    EXPECT_EQ(pixels.height, drawing.height);
    return pixels;
  }
  std::string svg(const Drawing& drawing, const std::string& title = "",
                  const std::string& description = "") const {
    write_svg(drawing, file("page.svg"), title, description);
    return read_text(file("page.svg"));
  }

  const TemporaryFolder folder_;
};

// What isn't white.
struct Ink {
  std::int32_t left, top, right, bottom;
};
Ink ink_of(const Pixels& pixels) {
  Ink ink{pixels.width, pixels.height, 0, 0};
  for (std::int32_t y = 0; y < pixels.height; ++y) {
    for (std::int32_t x = 0; x < pixels.width; ++x) {
      if (pixels.at(x, y) == white) continue;
      ink = {std::min(ink.left, x), std::min(ink.top, y), std::max(ink.right, x + 1),
             std::max(ink.bottom, y + 1)};
    }
  }
  return ink;
}

TEST_F(DrawingTest, PixelsHaveExactlyTheirColors) {
  std::mt19937 random(7);
  // The second page is wider than Cairo's images can be, so that it is drawn in parts.
  for (const auto& [columns, rows, side] :
       {std::array{13, 7, 1}, {33000, 3, 1}, {5, 9, 3}, {1, 2, 479}, {90, 3, 100}}) {
    std::vector<Rgb> colors(static_cast<std::size_t>(columns * rows));
    for (Rgb& color : colors)
      for (std::uint8_t& channel : color)
        channel = static_cast<std::uint8_t>(random() % 255);
    constexpr std::int32_t left = 4, top = 2;
    const Pixels page =
        drawn({columns * side + 9, rows * side + 5,
               [&, n = columns, s = side](cairo_t* cairo) { draw_pixels(cairo, left, top, s, n, colors); }});
    std::size_t wrong = 0;
    for (std::int32_t y = 0; y < page.height; ++y) {
      for (std::int32_t x = 0; x < page.width; ++x) {
        const bool is_inside = x >= left && y >= top && x < left + columns * side && y < top + rows * side;
        const std::int32_t i = (y - top) / side * columns + (x - left) / side;
        wrong += page.at(x, y) != (is_inside ? colors[static_cast<std::size_t>(i)] : white);
      }
    }
    EXPECT_EQ(wrong, 0U) << columns << ' ' << rows << ' ' << side;
  }
}

TEST_F(DrawingTest, APageOfPartsIsDrawnAsAWhole) {
  const auto draw = [](cairo_t* cairo) {
    for (const double x : {8185.5, 16380.0, 16384.0})
      draw_text(cairo, x, 20, "across a border", 18);
  };
  const Pixels page = drawn({17000, 30, draw});
  for (const double x : {8185.5, 16380.0, 16384.0}) {
    const auto left = static_cast<std::int32_t>(x) / 100 * 100;
    const Pixels part = drawn({400, 30, [&](cairo_t* cairo) {
                                 cairo_translate(cairo, -left, 0);
                                 draw(cairo);
                               }});
    // Cairo 1.18 places glyphs at quarters of a pixel, and rounds by the distance from the page's left side.
    // So some of the ink of ten columns, but no more than a shifted stem has, may be in the next ten.
    constexpr int columns = 10, of_a_stem = 3200;
    for (std::int32_t first = 0; first < 400; first += columns) {
      int difference = 0;
      for (std::int32_t v = 0; v < 30; ++v)
        for (std::int32_t u = first; u < first + columns; ++u)
          difference += part.at(u, v)[0] - page.at(left + u, v)[0];
      ASSERT_LE(std::abs(difference), of_a_stem) << left << ' ' << first;
    }
  }
}

TEST_F(DrawingTest, TextStaysWithinItsWidthAndHeight) {
  const std::string text = "gQ@|~_j, 09";
  for (const double size : {10.0, 37.0}) {
    const double width = text_width(text, size);
    for (const auto& [anchor, left] :
         {std::pair(TextAnchor::start, 300.0), std::pair(TextAnchor::middle, 300 - width / 2),
          std::pair(TextAnchor::end, 300 - width)}) {
      const Ink right = ink_of(
          drawn({600, 600, [&, a = anchor](cairo_t* cairo) { draw_text(cairo, 300, 300, text, size, a); }}));
      EXPECT_GE(right.left, left - 2);
      EXPECT_LE(right.right, left + width + 2);
      EXPECT_GT(right.right - right.left, 0.9 * width - 2);
      EXPECT_GE(right.top, 300 - size);
      EXPECT_LE(right.bottom, 300 + 0.3 * size);
      // Turned left by 90°.
      const Ink up = ink_of(drawn({600, 600, [&, a = anchor](cairo_t* cairo) {
                                     draw_text(cairo, 300, 300, text, size, a, TextDirection::up);
                                   }}));
      EXPECT_NEAR(up.left, right.top, 1);
      EXPECT_NEAR(up.right, right.bottom, 1);
      EXPECT_NEAR(600 - up.bottom, right.left, 1);
      EXPECT_NEAR(600 - up.top, right.right, 1);
    }
  }
}

TEST_F(DrawingTest, EachCharacterHasItsOwnGlyph) {
  std::set<std::string> seen;
  for (int code = ' '; code <= '~'; ++code) {
    const std::string text(1, static_cast<char>(code));
    const Pixels page = drawn({40, 40, [&](cairo_t* cairo) { draw_text(cairo, 5, 30, text, 24); }});
    EXPECT_TRUE(seen.insert({page.rgb.begin(), page.rgb.end()}).second) << code;
  }
}

TEST_F(DrawingTest, BlocksOfTextHaveAllWordsAndTheirWidth) {
  const std::string text = "one two three four five six seven eight nine ten";
  for (const double width : {1000.0, 200.0, 60.0, 10.0}) {
    const TextBlock block = text_block(text, 20, width);
    std::string all;
    for (const std::string& line : block.lines) {
      all += (all.empty() ? "" : " ") + line;
      EXPECT_LE(text_width(line, block.size), width * 1.01 + 0.5);
    }
    EXPECT_EQ(all, text);
    EXPECT_LE(block.size, 20);
    if (width > 100) {
      EXPECT_EQ(block.size, 20);
    }
  }
  EXPECT_TRUE(text_block("", 20, 100).lines.empty());
}

TEST_F(DrawingTest, AnSvgHasATitleADescriptionAndAGlyphForEachLetter) {
  const auto glyphs = [&](const std::string& text) {
    const std::string page =
        svg({300, 100, [&](cairo_t* cairo) { draw_text(cairo, 10, 50, text, 20); }}, "a < b", text);
    EXPECT_NE(page.find("<title>a &lt; b</title>\n<desc>" + text + "</desc>"), std::string::npos);
    std::size_t count = 0;
    for (std::size_t at = page.find("<use "); at != std::string::npos; at = page.find("<use ", at + 1))
      ++count;
    return count;
  };
  EXPECT_EQ(glyphs(""), 0U);
  EXPECT_EQ(glyphs("abc"), 3U);
  EXPECT_EQ(glyphs("abcabc12345"), 11U);
}

TEST_F(DrawingTest, TextOfAnyBytesIsDrawn) {
  for (const std::string text :
       {"\xff\xc0\x80", "\xed\xa0\x80", "\xef\xbf\xbf", "\x01\n\x7f", "\xf0\x9f\x98\x80"}) {
    const auto draw = [&](cairo_t* cairo) { draw_text(cairo, 10, 50, text, 20); };
    const Ink ink = ink_of(drawn({300, 100, draw}));
    EXPECT_LT(ink.left, ink.right);
    EXPECT_NO_THROW(svg({300, 100, draw}, text, text));
  }
}

TEST_F(DrawingTest, WhatCannotBeDrawnOrWrittenIsAnError) {
  const Drawing page{10, 10, [](cairo_t*) {}};
  const Drawing broken{10, 10, [](cairo_t* cairo) { cairo_restore(cairo); }}; // nothing was saved
  for (const std::string& path : {file("none/page"), file("page")}) {
    const bool is_writable = path == file("page");
    EXPECT_THROW(write_png(is_writable ? broken : page, path, {}), Error);
    EXPECT_THROW(write_svg(is_writable ? broken : page, path, "", ""), Error);
    EXPECT_FALSE(std::filesystem::exists(path));
  }
}

} // namespace
} // namespace masu
