// Text in pictures, in a fixed-width bitmap font of our own.
#pragma once

#include "tools/draw/picture.h"

#include <string_view>

namespace masu {

// Of a character at scale 1, in pixels; scales multiply. A glyph takes 5 columns; its 7 upper rows stand on
// the baseline, 2 descend below it.
inline constexpr std::int32_t text_advance = 6, text_height = 7, text_descent = 2;

// Columns from the first character's first to the last one's last.
constexpr std::int32_t text_width(std::string_view text, std::int32_t scale = 1) {
  return text.empty() ? 0 : (static_cast<std::int32_t>(text.size()) * text_advance - 1) * scale;
}

// Whether text runs to the right, or upwards as along a vertical axis (turned left by 90°).
enum class TextDirection { right, up };

// (x, y) is the pixel of the text's upper left corner; with TextDirection::up that of the picture's corner
// where the first character's top left comes to lie: its lower left. ASCII; other bytes become boxes.
// Pixels beyond the picture are left out.
void draw_text(Picture& picture, std::int32_t x, std::int32_t y, std::string_view text, Rgb color = {0, 0, 0},
               std::int32_t scale = 1, TextDirection direction = TextDirection::right);

} // namespace masu
