// Tools whose input is written by another process meanwhile: the right result or one line, never a fault.
#include "tests/run_tool.h"
#include "tools/bench/stability/random_seed.h"
#include "tools/bench/stability/test_scene.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <random>
#include <thread>

namespace masu {
namespace {

// Writes into a file in place, until it is destroyed, at random: its own bytes, noise, or fewer bytes.
class Scribbler {
public:
  Scribbler(std::string path, std::uint64_t seed)
      : path_(std::move(path)), original_(read_bytes(path_)), thread_([this, seed] { scribble(seed); }) {}
  ~Scribbler() {
    stopping_ = true;
    thread_.join();
    write_bytes(path_, original_);
  }
  Scribbler(const Scribbler&) = delete;
  Scribbler& operator=(const Scribbler&) = delete;

private:
  void scribble(std::uint64_t seed) {
    std::mt19937_64 random(seed);
    const int file = open(path_.c_str(), O_WRONLY | O_CLOEXEC);
    ASSERT_GE(file, 0);
    while (!stopping_) {
      Bytes bytes = original_;
      const auto size = static_cast<off_t>(bytes.size());
      switch (random() % 4) {
      case 0:
        EXPECT_EQ(ftruncate(file, static_cast<off_t>(random() % bytes.size())), 0);
        break;
      case 1:
        for (int i = 0; i < 64; ++i)
          bytes[random() % bytes.size()] = static_cast<std::uint8_t>(random());
        [[fallthrough]];
      default: // mostly whole
        EXPECT_EQ(pwrite(file, bytes.data(), bytes.size(), 0), size);
      }
      std::this_thread::sleep_for(std::chrono::microseconds(random() % 3000));
    }
    close(file);
  }

  std::string path_;
  Bytes original_;
  std::atomic<bool> stopping_ = false;
  std::thread thread_;
};

class ChangingFiles : public ToolTest {
protected:
  // Runs the tool often while `path` is scribbled into: either its output is what it is of the original, or
  // there is none and one line says why.
  void expect_right_or_refused(const std::string& path, const std::string& tool, const Arguments& arguments,
                               const std::string& output) const {
    const RandomSeed seed;
    SCOPED_TRACE(seed.trace());
    ASSERT_TRUE(succeeded(run(tool, arguments)));
    const Bytes expected = read_bytes(output);
    const Scribbler scribbler(path, seed.engine()());
    for (int i = 0; i < cases(15); ++i) {
      std::filesystem::remove(output);
      const ToolResult result = run(tool, arguments);
      if (result.code == 0)
        EXPECT_EQ(read_bytes(output), expected);
      else
        EXPECT_TRUE(failed(result, 2, tool, path));
      EXPECT_EQ(std::filesystem::exists(output), result.code == 0);
    }
  }
};

TEST_F(ChangingFiles, SceneOfGridrender) {
  const std::string in = scene("a.scene", spd("a.nff", "balls", 3)), divided = grid("a.grid", in);
  expect_right_or_refused(in, "gridrender",
                          {in, divided, "-o", file("a.pfm"), "--size", "64x64", "--backend", "cpu", "-q"},
                          file("a.pfm"));
}

TEST_F(ChangingFiles, GridOfGridrender) {
  const std::string in = scene("a.scene", spd("a.nff", "balls", 3)), divided = grid("a.grid", in);
  expect_right_or_refused(divided, "gridrender",
                          {in, divided, "-o", file("a.pfm"), "--size", "64x64", "--backend", "cpu", "-q"},
                          file("a.pfm"));
}

TEST_F(ChangingFiles, SceneOfGridbuild) {
  const std::string in = scene("a.scene", spd("a.nff", "balls", 3));
  expect_right_or_refused(in, "gridbuild", {in, "-o", file("a.grid"), "--division", "16", "-q"},
                          file("a.grid"));
}

// A text has no hash: what is read between two writes is a text, too, and may be another scene. But nothing
// faults, and an output is a whole scene.
TEST_F(ChangingFiles, TextOfNff2bin) {
  const std::string text = spd("a.nff", "balls", 3), out = file("a.scene");
  const Scribbler scribbler(text, RandomSeed().engine()());
  for (int i = 0; i < cases(15); ++i) {
    std::filesystem::remove(out);
    const ToolResult result = run("nff2bin", {text, "-o", out});
    EXPECT_TRUE(result.code == 0 || result.code == 2) << result.code << result.err;
    EXPECT_EQ(std::filesystem::exists(out), result.code == 0);
    EXPECT_EQ(run("nff2bin", {out, "--info"}).code, result.code);
  }
}

// --- Inputs that aren't files, or don't end
// -----------------------------------------------------------------

TEST_F(ChangingFiles, PipesWithoutAWriterAndEndlessDevicesAreRefused) {
  const std::string pipe = file("pipe"), in = scene("a.scene", nff("a.nff", small_nff)),
                    divided = grid("a.grid", in);
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const Arguments picture{"-o", file("a.png"), "--backend", "cpu"};
  const auto with = [](Arguments first, const Arguments& more) {
    first.insert(first.end(), more.begin(), more.end());
    return first;
  };
  for (const std::string& input : {pipe, std::string("/dev/zero")}) {
    EXPECT_TRUE(failed(run("nff2bin", {input, "-o", file("b.scene")}), 2, "nff2bin", input));
    EXPECT_TRUE(failed(run("gridbuild", {input, "-o", file("b.grid")}), 2, "gridbuild", input));
    EXPECT_TRUE(failed(run("gridstat", {input}), 2, "gridstat", input));
    EXPECT_TRUE(failed(run("gridrender", with({input, divided}, picture)), 2, "gridrender", input));
    EXPECT_TRUE(failed(run("gridrender", with({in, input}, picture)), 2, "gridrender", input));
    EXPECT_TRUE(failed(run("gridrender", with({in, divided, "--views", input}, {"-o", file("{index}.png")})),
                       2, "gridrender", input));
  }
  EXPECT_TRUE(failed(run("nff2bin", {"-", "-o", file("b.scene")}, {"/dev/zero", {}, {}}), 2, "nff2bin",
                     "stdin", "isn't a text"));
  ASSERT_EQ(mkfifo(file("pipe.csv").c_str(), 0600), 0);
  std::filesystem::create_symlink("/dev/zero", file("zero.csv"));
  for (const std::string& input : {pipe, file("pipe.csv"), std::string("/dev/zero"), file("zero.csv")})
    EXPECT_TRUE(failed(run("gridrender", {in, divided, "--rays", input, "--hits", file("hits")}), 2,
                       "gridrender", input));
  EXPECT_TRUE(
      failed(run("gridrender", {in, divided, "--rays", "-", "--hits", file("hits")}, {"/dev/zero", {}, {}}),
             2, "gridrender", "stdin"));
  EXPECT_TRUE(succeeded(run("gridrender", with({in, divided}, picture))));
  for (const std::string& input : {pipe, std::string("/dev/zero")}) {
    EXPECT_TRUE(failed(run("gridrender", {"--difference", input, file("a.png")}), 2, "gridrender", input));
    EXPECT_TRUE(failed(run("gridrender", {"--difference", file("a.png"), input}), 2, "gridrender", input));
  }
}

} // namespace
} // namespace masu
