// gridrender's JPEG pictures are close to its PNGs.
#include "tests/decoded_image.h"
#include "tests/decoded_jpeg.h"
#include "tests/tools/run_tool.h"

namespace masu {
namespace {

class JpegPictures : public SmallSceneTest {
protected:
  void expect_close(const std::string& name, const std::string& png, double least) const {
    const DecodedJpeg decoded = decoded_jpeg(read_bytes(file(name)));
    const DecodedPng exact = decoded_png(file(png));
    EXPECT_EQ(decoded.width, static_cast<std::int32_t>(exact.width));
    EXPECT_EQ(decoded.height, static_cast<std::int32_t>(exact.height));
    EXPECT_GT(decibels(decoded.rgb, exact.rgb), least) << name;
  }
};

TEST_F(JpegPictures, AreCloseToPngs) {
  auto random = seed_.engine();
  std::vector<std::string> sizes{"1x1", "160x120", "1333x1570"}; // the last one in two bands
  for (int i = 0; i < 5; ++i)
    sizes.push_back(fmt::format("{}x{}", 1 + random() % 99, 1 + random() % 99));
  for (const std::string& size : sizes) {
    SCOPED_TRACE(size);
    for (const Arguments& more : {Arguments{}, Arguments{"--srgb", "--sampling", "centers"}}) {
      const Arguments common = joined({"--size", size, "--depth", "2"}, more);
      render(joined({"-o", file("a.png")}, common));
      render(joined({"-o", file("a.jpg")}, common));
      render(joined({"-o", file("best"), "--format", "jpg", "--quality", "100"}, common));
      expect_close("a.jpg", "a.png", 28);
      expect_close("best", "a.png", 40);
    }
  }
}

TEST_F(JpegPictures, SayHowTheyAreMadeAgain) {
  render({"-o", file("a.jpeg"), "--quality", "77", "--from", "1,2,3"});
  const std::string comment = jpeg_comment(read_bytes(file("a.jpeg")));
  for (const char* const text :
       {"Software: Masu ", "\nSource: scene ", " --quality 77\n", "\nView: --from 1,2,3 "})
    EXPECT_NE(comment.find(text), std::string::npos) << comment;
}

TEST_F(JpegPictures, AreTheSameBytesInViewsAndOnStandardOutput) {
  render({"-o", file("v{index}.jpg"), "--turntable", "3"});
  render({"-o", file("a.jpg")});
  expect_run("gridrender", on_cpu({"-o", "-", "--format", "jpg", "--threads", "1"}), {.output = file("out")});
  EXPECT_TRUE(read_bytes(file("v0.jpg")) == read_bytes(file("a.jpg")));
  EXPECT_TRUE(read_bytes(file("out")) == read_bytes(file("a.jpg")));
}

TEST_F(JpegPictures, HaveChannelsBesideThem) {
  for (const std::string ending : {".jpg", ".jpeg"}) {
    render({"-o", file("p" + ending), "--channels", "depth"});
    for (const char* const made : {"p.depth.pfm", "p.depth.png"})
      EXPECT_TRUE(std::filesystem::remove(file(made))) << made;
  }
}

} // namespace
} // namespace masu
