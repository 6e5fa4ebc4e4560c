// PNG files: decoded by libpng they hold the pixels given, by any division into runs of bands.
#include "renderer/image/png_file.h"
#include "tests/decoded_image.h"
#include "tests/random_test.h"

#include <pthread.h>
#include <sys/mman.h>
#include <zlib.h>

#include <algorithm>
#include <functional>
#include <numeric>

namespace masu {
namespace {

using Deflate = RandomTest;
using Png = RandomTest;

Bytes decoded(const std::string& path, std::int32_t width, std::int32_t height) {
  const DecodedPng png = decoded_png(path);
  EXPECT_EQ(png.width, static_cast<std::size_t>(width));
  EXPECT_EQ(png.height, static_cast<std::size_t>(height));
  return png.rgb;
}

// Smooth, with noise here and there.
Bytes picture(std::mt19937_64& random, std::int32_t width, std::int32_t height) {
  Bytes rgb;
  for (std::int32_t y = 0; y < height; ++y) {
    const bool noisy = random() % 4 == 0;
    for (std::int32_t x = 0; x < width; ++x) {
      for (int channel = 0; channel < 3; ++channel)
        rgb.push_back(
            static_cast<std::uint8_t>(noisy ? random() : static_cast<unsigned>(x / 3 + y * channel)));
    }
  }
  return rgb;
}

TEST_F(Png, HoldsThePixelsOfAnySize) {
  auto random = seed_.engine();
  const TemporaryFolder folder;
  const std::string path = folder.file("a.png");
  const std::vector<std::pair<std::int32_t, std::int32_t>> sizes{
      {1, 1},     {2, 1},    {1, 7},       {3, 2},      {640, 480},
      {65536, 3}, {5, 9999}, {2048, 2100}, {65536, 70}, {2000, 699}};
  for (const auto& [width, height] : sizes) {
    SCOPED_TRACE(testing::Message() << width << " x " << height);
    const Bytes rgb = picture(random, width, height);
    write_png(rgb, width, height, path);
    EXPECT_TRUE(decoded(path, width, height) == rgb);
  }
}

TEST_F(Png, FileDependsNeitherOnRunsOfBandsNorTheirOrderNorOnThreads) {
  auto random = seed_.engine();
  const TemporaryFolder folder;
  constexpr std::int32_t width = 1500, height = 3000; // several bands
  const Bytes rgb = picture(random, width, height);
  const auto whole = [&](const std::string& name) {
    write_png(rgb, width, height, folder.file(name));
    return read_bytes(folder.file(name));
  };
  const Bytes expected = whole("whole.png");
  EXPECT_TRUE(made_by_threads(1, [&] { return whole("one.png"); }) == expected);
  const auto band = static_cast<std::size_t>(png_band_rows(width));
  ASSERT_GE(height / band, 3U);
  for (const std::size_t longest : {1U, 2U, 4U}) { // bands
    std::vector<std::pair<std::size_t, std::size_t>> runs;
    for (std::size_t row = 0; row < height; row += runs.back().second)
      runs.emplace_back(row, std::min<std::size_t>((1 + random() % longest) * band, height - row));
    std::vector<PngRows> encoded(runs.size());
    std::vector<std::size_t> order(runs.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::shuffle(order.begin(), order.end(), random);
    for (const std::size_t i : order) {
      const auto [row, rows] = runs[i];
      encoded[i] = encoded_rows(std::span(rgb).subspan(row * width * 3, rows * width * 3), width,
                                row + rows == height);
    }
    OutputFile file(folder.file("runs.png"));
    PngWriter writer(file, width, height);
    for (const PngRows& rows : encoded)
      writer.write(rows);
    file.commit();
    EXPECT_TRUE(read_bytes(folder.file("runs.png")) == expected) << "runs of up to " << longest;
  }
}

// Calls it on a stack that lies at a random place, which is free afterwards.
void call_anywhere(std::mt19937_64& random, std::function<void()> call) {
  constexpr std::size_t bytes = std::size_t{1} << 20;
  const std::uintptr_t place = random() % (std::uintptr_t{1} << 46) & ~std::uintptr_t{0xffff};
  void* const stack = mmap(reinterpret_cast<void*>(place), bytes, PROT_READ | PROT_WRITE,
                           MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0); // elsewhere if that is taken
  ASSERT_NE(stack, MAP_FAILED);
  pthread_attr_t attributes;
  pthread_t thread{};
  pthread_attr_init(&attributes);
  pthread_attr_setstack(&attributes, stack, bytes);
  const auto start = [](void* function) -> void* {
    (*static_cast<std::function<void()>*>(function))();
    return nullptr;
  };
  EXPECT_EQ(pthread_create(&thread, &attributes, start, &call), 0);
  EXPECT_EQ(pthread_join(thread, nullptr), 0);
  pthread_attr_destroy(&attributes);
  munmap(stack, bytes);
}

TEST_F(Png, IsTheSameBytesWhereverTheEncodersMemoryLies) {
  auto random = seed_.engine();
  for (std::int64_t i = 0; i < cases(40); ++i) {
    SCOPED_TRACE(i);
    // Mostly small: the smaller, the more a place for what was found already matters.
    const bool is_large = i % 10 == 9;
    const auto width = static_cast<std::int32_t>(is_large ? 200 : 8 + random() % 12);
    Bytes rgb(static_cast<std::size_t>(width) * 3 * (is_large ? 100 : 1));
    for (std::size_t byte = 0; byte < rgb.size(); ++byte)
      rgb[byte] = static_cast<std::uint8_t>((byte < 3 ? 0 : rgb[byte - 3]) + random() % 2);
    Bytes expected;
    for (int place = 0; place < 50; ++place) {
      Bytes chunks;
      call_anywhere(random, [&] { chunks = encoded_rows(rgb, width, true).chunks; });
      if (place == 0) expected = chunks;
      ASSERT_TRUE(chunks == expected) << "at place " << place;
    }
  }
}

TEST_F(Png, TextsAreChunksAndPixelsStayTheSame) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.png");
  const Bytes rgb{1, 2, 3, 4, 5, 6};
  write_png(rgb, 2, 1, path, {{"Software", "Masu"}, {"Source", ""}});
  EXPECT_TRUE(decoded(path, 2, 1) == rgb);
  const std::string text = read_text(path);
  EXPECT_NE(text.find(std::string("tEXtSoftware\0Masu", 17)), std::string::npos);
  EXPECT_NE(text.find(std::string("tEXtSource\0", 11)), std::string::npos);
}

// Also of the last chunk, which is empty and which libpng doesn't read.
TEST_F(Png, ChunksHaveTheirChecksums) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.png");
  write_png(Bytes{1, 2, 3}, 1, 1, path, {{"Software", "Masu"}});
  const Bytes bytes = read_bytes(path);
  const auto number = [&](std::size_t at) {
    return static_cast<std::size_t>(bytes[at]) << 24 | static_cast<std::size_t>(bytes[at + 1]) << 16 |
           static_cast<std::size_t>(bytes[at + 2]) << 8 | bytes[at + 3];
  };
  std::size_t at = 8, chunks = 0;
  for (; at + 12 <= bytes.size(); ++chunks) {
    const std::size_t length = number(at);
    ASSERT_LE(at + 12 + length, bytes.size());
    EXPECT_EQ(number(at + 8 + length), crc32(0, bytes.data() + at + 4, static_cast<uInt>(4 + length)));
    at += 12 + length;
  }
  EXPECT_EQ(at, bytes.size());
  EXPECT_GE(chunks, 4U);
}

// Leaves this where the stacks of later calls will be.
[[gnu::noinline]] void fill_stack(std::uint16_t with) {
  volatile std::uint16_t below[100000];
  for (volatile std::uint16_t& number : below)
    number = with;
}

TEST_F(Deflate, APieceDependsOnNothingThatWasInMemory) {
  auto random = seed_.engine();
  Bytes bytes(200000); // with repetitions near and far
  for (std::size_t i = 0; i < bytes.size(); ++i)
    bytes[i] = i > 4000 && random() % 8 != 0 ? bytes[i - 1 - random() % 4000]
                                             : static_cast<std::uint8_t>(random() % 40);
  fill_stack(0);
  const Bytes expected = deflated(bytes, true);
  for (std::uint16_t number = 1; number < 20; ++number) {
    fill_stack(number);
    EXPECT_TRUE(deflated(bytes, true) == expected) << number;
  }
}

// zlib inflates pieces one after the other as one stream.
TEST_F(Deflate, PiecesAreOneStream) {
  auto random = seed_.engine();
  for (int i = 0; i < 200; ++i) {
    Bytes all, stream;
    const std::size_t pieces = 1 + random() % 6;
    for (std::size_t piece = 0; piece < pieces; ++piece) {
      Bytes bytes(random() % (i % 10 == 0 ? 2000000 : 3000));
      const auto values = static_cast<unsigned>(1 + random() % (random() % 2 == 0 ? 4 : 256));
      std::ranges::generate(bytes, [&] { return static_cast<std::uint8_t>(random() % values); });
      const Bytes made = deflated(bytes, piece + 1 == pieces);
      EXPECT_TRUE(deflated(bytes, piece + 1 == pieces) == made);
      all.insert(all.end(), bytes.begin(), bytes.end());
      stream.insert(stream.end(), made.begin(), made.end());
    }
    Bytes inflated(all.size() + 1);
    z_stream reader{};
    ASSERT_EQ(inflateInit2(&reader, -MAX_WBITS), Z_OK);
    reader.next_in = stream.data();
    reader.avail_in = static_cast<uInt>(stream.size());
    reader.next_out = inflated.data();
    reader.avail_out = static_cast<uInt>(inflated.size());
    EXPECT_EQ(inflate(&reader, Z_FINISH), Z_STREAM_END);
    EXPECT_EQ(reader.avail_in, 0U);
    inflated.resize(reader.total_out);
    inflateEnd(&reader);
    EXPECT_TRUE(inflated == all);
  }
}

} // namespace
} // namespace masu
