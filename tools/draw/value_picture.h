// Pictures of values, with what is needed to read them: a title, a colour bar, the scale and its range.
#pragma once

#include "libscene/geometry/vector.h"
#include "tools/draw/drawing.h"

#include <cstdint>
#include <span>
#include <string>

namespace masu {

// Row by row from the top.
template <class T>
struct ValueMap {
  std::int32_t width, height;
  std::span<const T> values;
};

struct Caption {
  std::string title;
  std::string unit;      // of the values
  std::string without{}; // what an infinite value means: it is white
  enum class Values { positive, from_zero, counts } values = Values::positive;
  double high = 0; // of the scale of counts, so that pictures can be compared; 0: of the picture's own values
};

// Values as lightness and colour. The scale is linear; or logarithmic, for positive values that span more
// than a factor of 3, and for counts beyond 50 of which half would lie in the lowest tenth of a linear one. A
// few values that are far larger than 99.9 % of them don't stretch the scale. With a given upper end it is
// logarithmic where that is beyond 50.
Drawing value_picture(const ValueMap<double>& map, const Caption& caption);

// Names as colours, neighbouring names as different ones; white for -1.
Drawing name_picture(const ValueMap<std::int32_t>& map, const Caption& caption);

// Unit vectors n as the colours (n + 1) / 2; white for zero.
Drawing normal_picture(const ValueMap<Vec3f>& map, const Caption& caption);

} // namespace masu
