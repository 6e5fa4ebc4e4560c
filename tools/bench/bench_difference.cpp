// How two pictures or channels differ, pixel by pixel.
#include "libscene/file/input_file.h"
#include "libscene/file/input_stream.h"
#include "libscene/file/output_file.h"
#include "renderer/image/png_file.h"
#include "tools/bench/command.h"
#include "tools/common/cli.h"
#include "tools/common/json.h"
#include "tools/common/number_list.h"
#include "tools/common/version.h"
#include "tools/draw/value_picture.h"
#include "tools/lists/npy.h"

#include <png.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <memory>

namespace masu {
namespace {

struct Settings {
  std::string a, b, output;
  std::string json; // empty: a line; -: standard output
};

// A picture or channel: row by row from the top, `channels` numbers a pixel.
struct FloatPicture {
  std::size_t width, height, channels; // 1 or 3
  std::vector<float> values;           // of a PNG its bytes / 255
};

constexpr std::uint64_t largest_side = 1 << 20;

struct File {
  const std::string& path;
  std::string bytes;

  [[noreturn]] void fail(const std::string& what) const { throw Error(ErrorCode::input, path, what); }
  void check_size(std::uint64_t width, std::uint64_t height) const {
    if (width < 1 || height < 1 || width > largest_side || height > largest_side)
      fail(fmt::format("has {} x {} pixels: damaged?", width, height));
  }
};

FloatPicture read_png(const File& file) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  const std::unique_ptr<png_image, void (*)(png_image*)> freed(&png, png_image_free);
  const auto check = [&](int done) {
    if (done == 0) file.fail(fmt::format("isn't a PNG that can be read: {}", png.message));
  };
  constexpr std::string_view end("IEND\xae\x42\x60\x82"); // which libpng doesn't miss
  if (!file.bytes.ends_with(end)) file.fail("doesn't end as a PNG does: is it cut off?");
  check(png_image_begin_read_from_memory(&png, file.bytes.data(), file.bytes.size()));
  file.check_size(png.width, png.height);
  png.format = PNG_FORMAT_RGB;
  // Compressed a thousandfold at most: what claims to be larger isn't there.
  if (PNG_IMAGE_SIZE(png) / 1100 > file.bytes.size()) file.fail("is shorter than its size says: damaged?");
  std::vector<std::uint8_t> rgb(PNG_IMAGE_SIZE(png));
  check(png_image_finish_read(&png, nullptr, rgb.data(), 0, nullptr));
  std::vector<float> values(rgb.size());
  std::ranges::transform(rgb, values.begin(),
                         [](std::uint8_t byte) { return static_cast<float>(byte) / 255; });
  return {png.width, png.height, 3, std::move(values)};
}

float float_at(const char* bytes, bool is_big_endian) {
  std::uint32_t bits = 0;
  std::memcpy(&bits, bytes, sizeof(bits));
  if (is_big_endian) bits = bits << 24 | (bits & 0xff00) << 8 | (bits >> 8 & 0xff00) | bits >> 24;
  return std::bit_cast<float>(bits);
}

FloatPicture read_pfm(const File& file) {
  std::size_t at = 0;
  const auto word = [&] {
    const std::size_t begin = file.bytes.find_first_not_of(" \t\r\n", at);
    if (begin == std::string::npos) file.fail("ends in its header");
    at = std::min(file.bytes.find_first_of(" \t\r\n", begin), file.bytes.size());
    return std::string_view(file.bytes).substr(begin, at - begin);
  };
  const auto number = [&]<class Number>(Number) {
    const std::string_view text = word();
    const auto value = read_number<Number>(text);
    if (!value) file.fail(fmt::format("has a header in which '{}' isn't a number", text.substr(0, 20)));
    return *value;
  };
  const std::size_t channels = word() == "PF" ? 3 : 1;
  const auto width = number(std::uint32_t{}), height = number(std::uint32_t{});
  const double scale = number(double{});
  file.check_size(width, height);
  ++at; // one white space
  const std::size_t row = std::size_t{width} * channels;
  if (at > file.bytes.size() || file.bytes.size() - at != row * height * sizeof(float))
    file.fail(fmt::format("hasn't the length of {} x {} pixels", width, height));
  std::vector<float> values(row * height);
  for (std::size_t y = 0; y < height; ++y) // from the bottom up
    for (std::size_t i = 0; i < row; ++i)
      values[(height - 1 - y) * row + i] =
          float_at(file.bytes.data() + at + (y * row + i) * sizeof(float), scale > 0);
  return {width, height, channels, std::move(values)};
}

FloatPicture read_npy(const File& file) {
  std::size_t at = 0;
  const auto array = read_npy_head([&](void* to, std::size_t bytes) {
    if (bytes > file.bytes.size() - at) return false;
    std::memcpy(to, file.bytes.data() + at, bytes);
    at += bytes;
    return true;
  });
  const std::size_t dimensions = array ? array->shape.size() : 0;
  if (!array || (dimensions != 2 && dimensions != 3) || (dimensions == 3 && array->shape[2] != 3))
    file.fail("isn't an array of shape (rows, columns) or (rows, columns, 3)");
  const bool is_float = array->type == "<f4", is_signed = array->type == "<i4";
  if (!is_float && !is_signed && array->type != "<u4")
    file.fail(fmt::format("has numbers of type {}, not <f4, <i4 or <u4", array->type));
  file.check_size(array->shape[1], array->shape[0]);
  const std::size_t channels = dimensions == 3 ? 3 : 1, count = array->shape[0] * array->shape[1] * channels;
  if (file.bytes.size() - at != count * sizeof(float)) file.fail("hasn't the length that its shape says");
  std::vector<float> values(count);
  for (std::size_t i = 0; i < count; ++i) {
    const float bits = float_at(file.bytes.data() + at + i * sizeof(float), false);
    values[i] = is_float    ? bits
                : is_signed ? static_cast<float>(std::bit_cast<std::int32_t>(bits))
                            : static_cast<float>(std::bit_cast<std::uint32_t>(bits));
  }
  return {array->shape[1], array->shape[0], channels, std::move(values)};
}

// A PNG, a PFM or a NumPy array, known by its content. An array has the shape (rows, columns) or (rows,
// columns, 3) and numbers of type <f4, <i4 or <u4. Throws Error(input, path, …) for what isn't such a file,
// or is damaged.
FloatPicture read_picture(const std::string& path) {
  InputStream in(path);
  File file{path, std::string(npy_magic.size(), ' ')};
  file.bytes.resize(in.read(file.bytes.data(), file.bytes.size()));
  const auto begins = [&](std::string_view with) { return file.bytes.starts_with(with); };
  const bool is_png = begins("\x89PNG"), is_npy = begins(npy_magic);
  // Nothing but its beginning is read of what isn't a picture: it may be endless.
  if (!is_png && !is_npy && !begins("PF") && !begins("Pf"))
    file.fail("is neither PNG nor PFM nor a NumPy array");
  file.bytes += read_to_end([&](char* to, std::size_t bytes) { return in.read(to, bytes); }, path);
  return is_png ? read_png(file) : is_npy ? read_npy(file) : read_pfm(file);
}

struct Difference {
  std::size_t width, height;
  double rmse = 0;          // over all numbers of all pixels
  double largest = 0;       // of a number
  std::size_t x = 0, y = 0; // where, from the top left; the first of equals
  std::size_t different_pixels = 0;
  // Pixels in which a number is infinite or NaN in one picture, and not the same in the other; they count as
  // different, and in nothing else.
  std::size_t incomparable_pixels = 0;
  std::vector<double> pixels{}; // each one's largest difference; infinity for incomparable ones
};

// Of pictures of one size: throws Error(input, path, …) for others; `path` is b's.
Difference difference_of(const FloatPicture& a, const FloatPicture& b, const std::string& path) {
  if (a.width != b.width || a.height != b.height || a.channels != b.channels)
    throw Error(
        ErrorCode::input, path,
        fmt::format("has {} x {} pixels of {} channels, the other picture {} x {} of {}: give pictures "
                    "of one size",
                    b.width, b.height, b.channels, a.width, a.height, a.channels));
  Difference result{.width = a.width, .height = a.height};
  result.pixels.resize(a.width * a.height);
  double squares = 0;
  std::size_t compared = 0;
  for (std::size_t i = 0; i < result.pixels.size(); ++i) {
    double largest = 0;
    bool comparable = true;
    for (std::size_t k = i * a.channels; k < (i + 1) * a.channels; ++k) {
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
      result.x = i % a.width;
      result.y = i / a.width;
    }
  }
  if (compared > 0) result.rmse = std::sqrt(squares / static_cast<double>(compared));
  return result;
}

Drawing difference_picture(const Difference& difference) {
  const std::string title =
      fmt::format("difference: the largest of each pixel; rmse {:.4g}, {} of {} pixels differ",
                  difference.rmse, difference.different_pixels, difference.pixels.size());
  return value_picture(
      {static_cast<std::int32_t>(difference.width), static_cast<std::int32_t>(difference.height),
       difference.pixels},
      {title, "absolute difference", "infinite in one picture only", Caption::Values::from_zero});
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
               {"largest_at", difference.largest > 0 ? Json::array({difference.x, difference.y}) : Json()},
               {"different_pixels", difference.different_pixels},
               {"incomparable_pixels", difference.incomparable_pixels}});
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
