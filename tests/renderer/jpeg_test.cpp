// JPEG files: decoded by libjpeg they are close to the pixels given, and of bands each is as it is alone.
#include "renderer/image/jpeg_file.h"

#include "libscene/base/error.h"
#include "tests/decoded_jpeg.h"
#include "tests/random_test.h"

namespace masu {
namespace {

class Jpeg : public RandomTest {
protected:
  // Smooth, with noise in some rows.
  Bytes picture(std::int32_t width, std::int32_t height) {
    Bytes rgb;
    for (std::int32_t y = 0; y < height; ++y) {
      const int noise = chance_.one_in(16) ? 100 : 1;
      for (std::int32_t x = 0; x < width; ++x)
        for (int channel = 0; channel < 3; ++channel)
          rgb.push_back(static_cast<std::uint8_t>(100 + 50 * std::sin(0.01 * x + 0.02 * y * channel) +
                                                  static_cast<double>(random_() % 256) * noise / 256));
    }
    return rgb;
  }

  Bytes written(std::int32_t width, std::int32_t height, const std::vector<Bytes>& bands,
                const PictureTexts& texts = {}) const {
    OutputFile file(folder_.file("a.jpg"));
    JpegWriter writer(file, width, height, texts);
    for (const Bytes& band : bands)
      writer.write(band);
    file.commit();
    return read_bytes(folder_.file("a.jpg"));
  }

  const TemporaryFolder folder_;
  std::mt19937_64 random_ = seed_.engine();
};

TEST_F(Jpeg, IsCloseToThePixelsOfAnySize) {
  std::vector<std::pair<std::int32_t, std::int32_t>> sizes{
      {1, 1}, {1, 2}, {8, 8}, {640, 480}, {largest_jpeg_side, 2}, {3, largest_jpeg_side}};
  for (std::int64_t i = 0; i < cases(40); ++i)
    sizes.emplace_back(chance_.whole(1, 70), chance_.whole(1, 70));
  for (const auto& [width, height] : sizes) {
    SCOPED_TRACE(testing::Message() << width << " x " << height);
    const Bytes rgb = picture(width, height);
    for (const auto& [quality, least] : {std::pair{20, 17.5}, {90, 27.0}, {100, 39.0}}) {
      const DecodedJpeg decoded = decoded_jpeg(written(width, height, {jpeg(rgb, width, height, {quality})}));
      EXPECT_EQ(decoded.width, width);
      EXPECT_EQ(decoded.height, height);
      EXPECT_GT(decibels(decoded.rgb, rgb), least) << "quality " << quality;
    }
  }
}

// The widest has more bands than there are numbers of restart markers.
TEST_F(Jpeg, BandsAreDecodedAsEachAlone) {
  for (const auto& [width, bands] : {std::pair{1333, 3}, {4099, 2}, {30'011, 3}, {largest_jpeg_side, 10}}) {
    SCOPED_TRACE(width);
    const std::int32_t rows = jpeg_band_rows(width), last = chance_.whole(1, rows);
    EXPECT_EQ(rows % 8, 0);
    Bytes pixels;
    std::vector<Bytes> encoded;
    for (int i = 0; i < bands; ++i) {
      const std::int32_t height = i + 1 < bands ? rows : last;
      const auto row_bytes = 3 * static_cast<std::size_t>(width);
      const Bytes tile = picture(width, 8);
      Bytes rgb(row_bytes * static_cast<std::size_t>(height));
      for (std::size_t at = 0; at < rgb.size(); at += row_bytes)
        std::copy_n(tile.begin() + static_cast<std::ptrdiff_t>(at % tile.size()), row_bytes,
                    rgb.begin() + static_cast<std::ptrdiff_t>(at));
      encoded.push_back(jpeg(rgb, width, height, {90}));
      const DecodedJpeg alone = decoded_jpeg(encoded.back());
      pixels.insert(pixels.end(), alone.rgb.begin(), alone.rgb.end());
    }
    const DecodedJpeg whole = decoded_jpeg(written(width, rows * (bands - 1) + last, encoded));
    EXPECT_EQ(whole.height, rows * (bands - 1) + last);
    EXPECT_TRUE(whole.rgb == pixels);
  }
}

TEST_F(Jpeg, TextsAreAComment) {
  const Bytes band = jpeg(picture(9, 5), 9, 5, {90});
  EXPECT_EQ(jpeg_comment(written(9, 5, {band})), "");
  EXPECT_EQ(jpeg_comment(written(9, 5, {band}, {{"Software", "Masu"}, {"View", "--from 1,2,3"}})),
            "Software: Masu\nView: --from 1,2,3");
  const Bytes longest = written(9, 5, {band}, {{"View", std::string(100'000, 'x')}});
  EXPECT_EQ(jpeg_comment(longest), "View: " + std::string(65'533 - 6, 'x'));
  EXPECT_TRUE(decoded_jpeg(longest).rgb == decoded_jpeg(band).rgb);
}

TEST_F(Jpeg, BandsThatWereChangedAreRefused) {
  const std::int32_t width = 30'011, rows = jpeg_band_rows(width);
  const Bytes rgb = picture(width, rows), first = jpeg(rgb, width, rows, {90});
  EXPECT_THROW(written(width, 2 * rows, {first, jpeg(rgb, width, rows, {91})}), Error);
  const Bytes small = jpeg(picture(9, 5), 9, 5, {90});
  for (std::size_t bytes = 0; bytes < small.size(); ++bytes)
    EXPECT_THROW(written(9, 5, {Bytes(small.begin(), small.begin() + static_cast<std::ptrdiff_t>(bytes))}),
                 Error)
        << bytes;
  for (std::int64_t i = 0; i < cases(3000); ++i) {
    Bytes changed = small;
    for (int bytes = chance_.whole(1, 3); bytes > 0; --bytes)
      changed[chance_.index(changed.size())] = static_cast<std::uint8_t>(random_());
    try {
      written(9, 5, {changed});
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::output);
    }
  }
}

} // namespace
} // namespace masu
