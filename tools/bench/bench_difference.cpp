// How two pictures or channels differ, pixel by pixel.
#include "libscene/file/output_file.h"
#include "renderer/image/png_file.h"
#include "tools/bench/bench.h"
#include "tools/bench/picture_file.h"
#include "tools/common/cli.h"
#include "tools/common/json.h"
#include "tools/common/version.h"
#include "tools/draw/value_picture.h"

#include <cmath>
#include <limits>
#include <memory>

namespace masu {
namespace {

struct Settings {
  std::string a, b, output;
  std::string json; // empty: a line; -: standard output
};

struct Difference {
  std::int32_t width = 0, height = 0;
  double rmse = 0;           // over all numbers of all pixels
  double largest = 0;        // of a number
  std::int32_t x = 0, y = 0; // where, from the top left; the first of equals
  std::size_t different_pixels = 0;
  // Pixels in which a number is infinite or NaN in one picture, and not the same in the other; they count as
  // different, and in nothing else.
  std::size_t incomparable_pixels = 0;
  std::vector<double> pixels; // each one's largest difference; infinity for incomparable ones
};

// Of pictures of one size: throws Error(input, path, …) for others; `path` is b's.
Difference difference_of(const FloatPicture& a, const FloatPicture& b, const std::string& path) {
  if (a.width != b.width || a.height != b.height || a.channels != b.channels)
    throw Error(
        ErrorCode::input, path,
        fmt::format("has {} x {} pixels of {} channels, the other picture {} x {} of {}: give pictures "
                    "of one size",
                    b.width, b.height, b.channels, a.width, a.height, a.channels));
  Difference result;
  result.width = a.width;
  result.height = a.height;
  const auto channels = static_cast<std::size_t>(a.channels);
  const std::size_t pixels = a.values.size() / channels;
  result.pixels.resize(pixels);
  double squares = 0;
  std::size_t compared = 0;
  for (std::size_t i = 0; i < pixels; ++i) {
    double largest = 0;
    bool comparable = true;
    for (std::size_t k = i * channels; k < (i + 1) * channels; ++k) {
      const double one = static_cast<double>(a.values[k]), other = static_cast<double>(b.values[k]);
      const bool same = one == other || (std::isnan(one) && std::isnan(other)); // infinities too
      if (!same && !(std::isfinite(one) && std::isfinite(other))) {
        comparable = false;
        continue;
      }
      const double difference = same ? 0 : std::abs(one - other);
      largest = std::fmax(largest, difference);
      squares += difference * difference;
      ++compared;
    }
    result.pixels[i] = comparable ? largest : std::numeric_limits<double>::infinity();
    result.different_pixels += largest > 0 || !comparable;
    result.incomparable_pixels += !comparable;
    if (largest > result.largest) {
      result.largest = largest;
      result.x = static_cast<std::int32_t>(i % static_cast<std::size_t>(a.width));
      result.y = static_cast<std::int32_t>(i / static_cast<std::size_t>(a.width));
    }
  }
  if (compared > 0) result.rmse = std::sqrt(squares / static_cast<double>(compared));
  return result;
}

Drawing difference_picture(const Difference& difference) {
  Caption caption;
  caption.title = fmt::format("difference: the largest of each pixel; rmse {:.4g}, {} of {} pixels differ",
                              difference.rmse, difference.different_pixels, difference.pixels.size());
  caption.unit = "absolute difference";
  caption.without = "infinite in one picture only";
  caption.values = Caption::Values::from_zero;
  return value_picture({difference.width, difference.height, difference.pixels}, caption);
}

std::string line_of(const Difference& difference) {
  std::string text =
      fmt::format("RMSE {:.6g}, largest difference {:.6g}", difference.rmse, difference.largest);
  if (difference.largest > 0) text += fmt::format(" at pixel {},{}", difference.x, difference.y);
  text += fmt::format("; {} of {} pixels differ", difference.different_pixels, difference.pixels.size());
  if (difference.incomparable_pixels > 0)
    text += fmt::format(", {} of them by a number that is infinite or NaN in one only",
                        difference.incomparable_pixels);
  return text + "\n";
}

std::string json_of(const Difference& difference) {
  Json json = provenance();
  json.update({{"width", difference.width},
               {"height", difference.height},
               {"rmse", difference.rmse},
               {"largest", difference.largest},
               {"largest_at", Json::array({difference.x, difference.y})},
               {"different_pixels", difference.different_pixels},
               {"incomparable_pixels", difference.incomparable_pixels}});
  if (!(difference.largest > 0)) json["largest_at"] = nullptr;
  return json_text(json) + "\n";
}

void print_difference(const Settings& settings) {
  if (is_standard_output(settings.output) && (settings.json.empty() || is_standard_output(settings.json)))
    throw Error(ErrorCode::usage, "-o", "is standard output, where the difference is printed: name a file");
  check_files({settings.a, settings.b}, {settings.output, settings.json});
  if (!settings.output.empty() && !is_standard_output(settings.output) && !settings.output.ends_with(".png"))
    throw Error(ErrorCode::usage, settings.output, "must end in .png: differences are drawn as PNG");
  const FloatPicture a = read_picture(settings.a), b = read_picture(settings.b);
  const Difference difference = difference_of(a, b, settings.b);
  if (!settings.output.empty())
    write_png(difference_picture(difference), settings.output, {{"Software", program_name()}});
  if (settings.json.empty())
    write_text_file("-", line_of(difference));
  else
    write_text_file(settings.json, json_of(difference));
}

} // namespace

void add_difference(const CommandLine& gridbench) {
  const auto owned = std::make_shared<Settings>(); // by the callback
  Settings& settings = *owned;
  const CommandLine command = gridbench.add_subcommand("difference", "How two pictures or channels differ");
  command.footer("Example:\n  gridbench difference balls.png centers.png -o difference.png");
  command.add_option("A", settings.a, "picture or channel: PNG, PFM, .npy").required();
  command.add_option("B", settings.b, "another one of the same size").required();
  command.add_file("-o,--output", settings.output, "draw the differences: FILE.png");
  command.add_json(settings.json);
  command.calls([owned] { print_difference(*owned); });
}

} // namespace masu
