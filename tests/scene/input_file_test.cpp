// Files that change while they are read or used, and inputs that aren't files.
#include "libscene/file/input_file.h"

#include "libgrid/file/structure_file.h"
#include "libscene/file/input_stream.h"
#include "libscene/file/scene_file.h"
#include "renderer/tracer/tracer.h"
#include "tests/random_test.h"
#include "tests/refused.h"
#include "tests/temporary_folder.h"
#include "tests/tiny_scene.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace masu {
namespace {

class InputFiles : public RandomTest {
protected:
  std::string file(const char* name) const { return folder_.file(name); }
  std::string written(const char* name, std::string_view text) const {
    write_text(file(name), text);
    return file(name);
  }
  // Into the pipe, a little at a time.
  std::thread written_thrice(const std::string& text) const {
    return std::thread([path = file("pipe"), text] {
      const int pipe = open(path.c_str(), O_WRONLY | O_CLOEXEC);
      for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(write(pipe, text.data(), text.size()), static_cast<ssize_t>(text.size()));
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
      }
      close(pipe);
    });
  }
  TemporaryFolder folder_;
};

Bytes noise(std::mt19937_64& random, std::size_t size) {
  Bytes bytes(size);
  for (std::uint8_t& byte : bytes)
    byte = static_cast<std::uint8_t>(random());
  return bytes;
}

TEST_F(InputFiles, AreReadWhole) {
  auto random = seed_.engine();
  for (const std::size_t size :
       {0UL, 1UL, 4095UL, (2UL << 20) - 1, 2UL << 20, (9UL << 20) + random() % 1000}) {
    const Bytes bytes = noise(random, size);
    write_bytes(file("a"), bytes);
    EXPECT_TRUE(std::ranges::equal(InputFile(file("a")).contents(), bytes));
  }
}

TEST_F(InputFiles, ThatShrinkOrChangeWhileTheyAreReadAreRefused) {
  const std::string path = written("a", "0123456789");
  {
    const InputFile shrinking(path);
    std::filesystem::resize_file(path, 5);
    Bytes bytes(10);
    EXPECT_TRUE(is_refused([&](const std::string&) { shrinking.read(0, bytes); }, path, "truncated"));
    EXPECT_TRUE(is_refused([&](const std::string&) { shrinking.check_unchanged(); }, path, "changed"));
  }
  const InputFile changing(path);
  changing.check_unchanged();
  const timespec times[2]{{1, 0}, {1, 0}}; // as if it had been written: the clock may tick slowly
  ASSERT_EQ(utimensat(AT_FDCWD, path.c_str(), times, 0), 0);
  EXPECT_TRUE(is_refused([&](const std::string&) { changing.check_unchanged(); }, path, "changed"));
}

TEST_F(InputFiles, ThatAreNoRegularFilesAreRefusedAtOnce) {
  ASSERT_EQ(mkfifo(file("pipe").c_str(), 0600), 0);
  for (const std::string& path : {file("pipe"), std::string("/dev/zero"), std::string("/dev/null")}) {
    EXPECT_TRUE(is_refused([](const std::string& p) { InputFile{p}; }, path, "isn't a regular file"));
    EXPECT_TRUE(is_refused([](const std::string& p) { SceneFile{p}; }, path, "isn't a regular file"));
    EXPECT_TRUE(is_refused([](const std::string& p) { StructureFile{p}; }, path, "isn't a regular file"));
  }
}

// A sparse file takes no space.
TEST_F(InputFiles, ThatNeedMoreMemoryThanThereIsAreRefused) {
  const std::string path = written("a", "");
  std::filesystem::resize_file(path, std::uintmax_t{1} << 42);
  EXPECT_TRUE(is_refused([](const std::string& p) { InputFile(p).contents(); }, path, "of memory"));
}

TEST_F(InputFiles, TextsAreReadFromPipes) {
  ASSERT_EQ(mkfifo(file("pipe").c_str(), 0600), 0);
  std::thread writer = written_thrice("line\n");
  EXPECT_EQ(read_text_input(file("pipe")), "line\nline\nline\n");
  writer.join();
}

TEST_F(InputFiles, EndlessTextsAreRefused) {
  EXPECT_TRUE(is_refused([](const std::string& p) { read_text_input(p); }, "/dev/zero", "isn't a text"));
  ASSERT_EQ(mkfifo(file("pipe").c_str(), 0600), 0);
  EXPECT_TRUE(is_refused([](const std::string& p) { read_text_input(p); }, file("pipe"), "nobody writes"));
}

// Another thread has failed, and nobody writes to the pipe, or who does has stopped.
TEST_F(InputFiles, AStreamThatIsCancelledWaitsNoLonger) {
  ASSERT_EQ(mkfifo(file("pipe").c_str(), 0600), 0);
  for (const bool has_writer : {false, true}) {
    InputStream stream(file("pipe"));
    const int writer = has_writer ? open(file("pipe").c_str(), O_WRONLY | O_CLOEXEC) : -1;
    EXPECT_TRUE(!has_writer || write(writer, "abc", 3) == 3);
    std::thread canceller([&] { stream.cancel(); });
    char bytes[10] = {};
    EXPECT_LE(stream.read(bytes, sizeof bytes), 3U);
    EXPECT_EQ(stream.read(bytes, sizeof bytes), 0U);
    canceller.join();
    if (writer >= 0) close(writer);
  }
}

TEST_F(InputFiles, StreamsOfPipesEndWithTheirWriters) {
  ASSERT_EQ(mkfifo(file("pipe").c_str(), 0600), 0);
  std::thread writer = written_thrice(std::string("a\0b", 3));
  InputStream stream(file("pipe"));
  std::string bytes(100, ' ');
  bytes.resize(stream.read(bytes.data(), bytes.size()));
  EXPECT_EQ(bytes, std::string("a\0ba\0ba\0b", 9));
  writer.join();
  const auto read = [&](const std::string& path) { InputStream(path).read(bytes.data(), 1); };
  EXPECT_TRUE(is_refused(read, file("pipe"), "nobody writes"));
}

// In a mapping this would be SIGBUS, or an index that was valid when it was checked.
TEST_F(InputFiles, ScenesAndGridsInUseDontFollowTheirFiles) {
  auto random = seed_.engine();
  const Scene tiny = tiny_scene();
  for (const Structure& grid : {tiny_grid(), tiny_grid_of_blocks(), tiny_merged_grid()}) {
    write_structure(grid, tiny_grid_provenance(write_scene(tiny, Store::float32, file("scene"))),
                    file("grid"));
    const SceneFile scene(file("scene"));
    const StructureFile opened(file("grid"));
    const ResidentTracer tracer(scene, &opened, Device::cpu);
    FrameRequest request;
    request.camera = tiny.camera;
    const Frame before = tracer.render(request);
    for (const char* name : {"scene", "grid"}) {
      write_bytes(file(name), noise(random, std::filesystem::file_size(file(name)))); // in place
    }
    EXPECT_TRUE(std::ranges::equal(tracer.render(request).radiance, before.radiance));
    for (const char* name : {"scene", "grid"})
      std::filesystem::resize_file(file(name), 0);
    EXPECT_TRUE(std::ranges::equal(tracer.render(request).radiance, before.radiance));
  }
}

} // namespace
} // namespace masu
