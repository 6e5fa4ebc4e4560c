// Tools whose input is written by another process meanwhile: the right result or one line, never a fault.
#include "libscene/cuda/cuda_device.h"
#include "stability/test_scene.h"
#include "tests/tools/run_tool.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <fstream>
#include <future>
#include <random>
#include <thread>
#include <tuple>

namespace masu {
namespace {

enum class Change { truncate, noise, replace };

// Changes a file: cuts it short, overwrites parts of it in place, or puts a copy in its place by renaming.
void change(const std::string& path, const Bytes& original, Change how, std::mt19937_64& random) {
  if (how == Change::replace) {
    write_bytes(path + ".new", original);
    std::filesystem::rename(path + ".new", path);
    return;
  }
  const int file = open(path.c_str(), O_WRONLY | O_CLOEXEC);
  ASSERT_GE(file, 0);
  if (how == Change::truncate) {
    EXPECT_EQ(ftruncate(file, static_cast<off_t>(random() % original.size())), 0);
  } else {
    Bytes noise(1 + random() % 4096);
    for (int piece = 0; piece < 16; ++piece) {
      for (std::uint8_t& byte : noise)
        byte = static_cast<std::uint8_t>(random());
      const std::size_t at = random() % original.size(), bytes = std::min(noise.size(), original.size() - at);
      EXPECT_EQ(pwrite(file, noise.data(), bytes, static_cast<off_t>(at)), static_cast<ssize_t>(bytes));
    }
  }
  close(file);
}

// Writes into a file, until it is destroyed, at random: its own bytes, noise, or fewer bytes.
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
    while (!stopping_) {
      const auto how = random() % 4;
      how < 2 ? change(path_, original_, static_cast<Change>(how), random) : write_bytes(path_, original_);
      std::this_thread::sleep_for(std::chrono::microseconds(random() % 3000));
    }
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
    ASSERT_TRUE(succeeded(run(tool, arguments)));
    const Bytes expected = read_bytes(output);
    const Scribbler scribbler(path, seed_.engine()());
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

TEST_F(ChangingFiles, SceneOfGridbuild) {
  const std::string in = scene("a.scene", spd("a.nff", "balls", 3));
  expect_right_or_refused(in, "gridbuild", {in, "-o", file("a.grid"), "--division", "16", "-q"},
                          file("a.grid"));
}

// A text has no hash: what is read between two writes is a text, too, and may be another scene. But nothing
// faults, and an output is a whole scene.
TEST_F(ChangingFiles, TextOfNff2bin) {
  const std::string text = spd("a.nff", "balls", 3), out = file("a.scene");
  const Scribbler scribbler(text, seed_.engine()());
  for (int i = 0; i < cases(15); ++i) {
    std::filesystem::remove(out);
    const ToolResult result = run("nff2bin", {text, "-o", out});
    EXPECT_TRUE(result.code == 0 || result.code == 2) << result.code << result.err;
    EXPECT_EQ(std::filesystem::exists(out), result.code == 0);
    EXPECT_EQ(run("nff2bin", {out, "--info"}).code, result.code);
  }
}

// --- Files that are in use --------------------------------------------------------------------------------

class FilesInUse : public ToolTest,
                   public testing::WithParamInterface<std::tuple<const char*, const char*>> {};

// A walk through indices that have changed may fault, or not end; a picture of them must not be written.
TEST_P(FilesInUse, ChangedAtAnyMomentGiveTheRightPictureOrALine) {
  const auto& [backend, merge] = GetParam();
  if (std::string_view(backend) == "cuda" && cuda_device_count() == 0)
    GTEST_SKIP() << "no GPU: nothing was traced on one";
  const std::string in = scene("a.scene", spd("a.nff", "balls", 3)),
                    divided = grid("a.grid", in, "auto",
                                   {std::string_view(merge) == "bvh" ? "--structure" : "--merge", merge}),
                    out = file("a.pfm");
  const Arguments arguments{in, divided, "-o", out, "--size", "400x400", "--backend", backend, "-q"};
  const auto whole_run = time_of("gridrender", arguments);
  const Bytes expected = read_bytes(out), scene_bytes = read_bytes(in), grid_bytes = read_bytes(divided);
  std::mt19937_64 random = seed_.engine();
  std::uniform_real_distribution<double> moment(0, 1.1);
  int refused = 0;
  for (int i = 0; i < cases(18); ++i) {
    write_bytes(in, scene_bytes);
    write_bytes(divided, grid_bytes);
    std::filesystem::remove(out);
    const auto how = static_cast<Change>(i % 3);
    const bool is_scene = random() % 2 == 0;
    const std::uint64_t own_seed = random();
    const auto wait = whole_run * moment(random);
    std::thread changing([&] {
      std::mt19937_64 own(own_seed);
      std::this_thread::sleep_for(wait);
      change(is_scene ? in : divided, is_scene ? scene_bytes : grid_bytes, how, own);
    });
    const ToolResult result = run("gridrender", arguments);
    changing.join();
    EXPECT_TRUE(how != Change::replace || result.code == 0) << result.err;
    if (result.code == 0) {
      EXPECT_EQ(read_bytes(out), expected);
    } else {
      EXPECT_TRUE(failed(result, 2, "gridrender", is_scene ? in : divided)) << result.err;
      ++refused;
    }
    EXPECT_EQ(std::filesystem::exists(out), result.code == 0);
    EXPECT_EQ(folder_.listing().size(), result.code == 0 ? 4U : 3U);
  }
  RecordProperty("refused", refused);
}

INSTANTIATE_TEST_SUITE_P(All, FilesInUse,
                         testing::Combine(testing::Values("cpu", "cuda"),
                                          testing::Values("none", "irregular", "bvh")),
                         [](const auto& test) {
                           return std::string(std::get<0>(test.param)) + "_" + std::get<1>(test.param);
                         });

TEST_F(ChangingFiles, AreMappedWhileACpuTracesThem) {
  const std::string in = scene("a.scene", spd("a.nff", "balls", 3)), divided = grid("a.grid", in);
  const pid_t process =
      start("gridrender", {in, divided, "-o", file("a.pfm"), "--size", "8000x8000", "--backend", "cpu"});
  ASSERT_GT(process, 0);
  const std::string maps = "/proc/" + std::to_string(process) + "/maps";
  bool both = false;
  for (int tries = 0; tries < 1000 && !both; ++tries) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    std::ifstream stream(maps);
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    both = text.find(in) != std::string::npos && text.find(divided) != std::string::npos;
    const std::size_t line = text.rfind('\n', text.find(in));
    EXPECT_TRUE(!both || text.substr(line, 60).find("r--s") != std::string::npos) << text;
  }
  EXPECT_TRUE(both);
  kill(process, SIGTERM);
  EXPECT_EQ(waitpid(process, nullptr, 0), process);
}

// --- Inputs that aren't files, or don't end ----------------------------------------------------------------

TEST_F(ChangingFiles, PipesWithoutAWriterAndEndlessDevicesAreRefused) {
  const std::string pipe = file("pipe"), in = scene("a.scene", nff("a.nff", small_nff)),
                    divided = grid("a.grid", in);
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  ASSERT_EQ(mkfifo(file("pipe.csv").c_str(), 0600), 0);
  const std::string zero = "/dev/zero";
  std::filesystem::create_symlink(zero, file("zero.csv"));
  const Arguments picture{"-o", file("a.png"), "--backend", "cpu"};
  ASSERT_TRUE(succeeded(run("gridrender", {in, divided, "-o", file("b.png"), "--backend", "cpu"})));
  // At the same time, since a text is waited for.
  std::vector<std::future<void>> refusals;
  const auto refused = [&](const std::string& input, const std::string& tool, const Arguments& arguments) {
    refusals.push_back(std::async(
        std::launch::async, [=] { EXPECT_TRUE(failed(run(tool, arguments), 2, tool, input)) << input; }));
  };
  for (const std::string& input : {pipe, zero}) {
    refused(input, "nff2bin", {input, "-o", file("b.scene")});
    refused(input, "gridbuild", {input, "-o", file("b.grid")});
    refused(input, "gridstat", {input});
    refused(input, "gridrender", joined({input, divided}, picture));
    refused(input, "gridrender", joined({in, input}, picture));
    refused(input, "gridrender", {in, divided, "--views", input, "-o", file("{index}.png")});
    refused(input, "gridbench", {"difference", input, file("b.png")});
    refused(input, "gridbench", {"difference", file("b.png"), input});
  }
  for (const std::string& input : {pipe, file("pipe.csv"), zero, file("zero.csv")})
    refused(input, "gridtrace", {in, divided, input, "-o", file("hits")});
  refusals.clear(); // waits for them
  expect_refused(2, R"(
nff2bin - -o ~/b.scene                          > stdin: isn't a text
gridtrace ~/a.scene ~/a.grid - -o ~/hits        > stdin
)",
                 {.input = zero});
}

} // namespace
} // namespace masu
