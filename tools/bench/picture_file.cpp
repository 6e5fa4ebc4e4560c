#include "tools/bench/picture_file.h"

#include "libscene/base/error.h"
#include "libscene/file/input_file.h"
#include "libscene/file/input_stream.h"
#include "tools/common/number_list.h"
#include "tools/lists/npy.h"

#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <string_view>

namespace masu {
namespace {

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

// Of a size that was checked, with zeros.
FloatPicture picture_of(std::uint64_t width, std::uint64_t height, std::uint64_t channels) {
  return {static_cast<std::int32_t>(width), static_cast<std::int32_t>(height),
          static_cast<std::int32_t>(channels), std::vector<float>(width * height * channels)};
}

constexpr std::string_view png_begins = "\x89PNG", pfm_begins = "PF", pfm_of_one_begins = "Pf";

// Nothing but its beginning is read of what isn't a picture: it may be endless.
File read(const std::string& path) {
  InputStream in(path);
  File file{path, std::string(npy_magic.size(), ' ')};
  file.bytes.resize(in.read(file.bytes.data(), file.bytes.size()));
  const auto begins = [&](std::string_view with) { return file.bytes.starts_with(with); };
  if (!begins(png_begins) && !begins(pfm_begins) && !begins(pfm_of_one_begins) && !begins(npy_magic))
    file.fail("is neither PNG nor PFM nor a NumPy array");
  file.bytes += read_to_end([&](char* to, std::size_t bytes) { return in.read(to, bytes); }, path);
  return file;
}

FloatPicture read_png(const File& file) {
  struct Image : png_image {
    Image() : png_image{} { version = PNG_IMAGE_VERSION; }
    ~Image() { png_image_free(this); }
    Image(const Image&) = delete;
    Image& operator=(const Image&) = delete;
  } png;
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
  FloatPicture picture = picture_of(png.width, png.height, 3);
  std::ranges::transform(rgb, picture.values.begin(),
                         [](std::uint8_t byte) { return static_cast<float>(byte) / 255; });
  return picture;
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
  FloatPicture picture = picture_of(width, height, channels);
  for (std::size_t y = 0; y < height; ++y) // from the bottom up
    for (std::size_t i = 0; i < row; ++i)
      picture.values[(height - 1 - y) * row + i] =
          float_at(file.bytes.data() + at + (y * row + i) * sizeof(float), scale > 0);
  return picture;
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
  FloatPicture picture = picture_of(array->shape[1], array->shape[0], channels);
  for (std::size_t i = 0; i < count; ++i) {
    const float bits = float_at(file.bytes.data() + at + i * sizeof(float), false);
    picture.values[i] = is_float    ? bits
                        : is_signed ? static_cast<float>(std::bit_cast<std::int32_t>(bits))
                                    : static_cast<float>(std::bit_cast<std::uint32_t>(bits));
  }
  return picture;
}

} // namespace

FloatPicture read_picture(const std::string& path) {
  const File file = read(path);
  if (file.bytes.starts_with(png_begins)) return read_png(file);
  return file.bytes.starts_with(npy_magic) ? read_npy(file) : read_pfm(file);
}

} // namespace masu
