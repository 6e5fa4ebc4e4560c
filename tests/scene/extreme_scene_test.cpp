// Any scene file that is written can be opened: extreme numbers are refused in the text, or finite in the
// file.
#include "libscene/file/scene_file.h"
#include "libscene/nff/nff.h"
#include "tests/memory_file.h"
#include "tests/random_test.h"

#include <fmt/format.h>

namespace masu {
namespace {

using ExtremeScene = RandomTest;

// Numbers that are often near a limit of some type.
std::string number(Chance& chance) {
  static const std::vector<std::string> extremes{
      "0",      "-0",    "1",       "5e-324",  "1e-310", "2.3e-308", "1e-300", "1e-160",
      "1e-100", "1e-46", "1.4e-45", "1.2e-38", "1e-20",  "1e-12",    "1e-10",  "0.5",
      "1e10",   "1e12",  "1e13",    "1e19",    "1e20",   "3.4e38",   "3.5e38", "1e39",
      "1e90",   "1e99",  "1e100",   "1.1e100", "1e154",  "1e200",    "1e307",  "1.7e308"};
  const std::string text =
      chance.one_in(3) ? extremes[chance.index(extremes.size())] : std::to_string(chance.uniform(-10, 10));
  return chance.one_in(4) && text[0] != '-' ? fmt::format("-{}", text) : text;
}

std::string numbers(Chance& chance, int count) {
  std::string text;
  for (int i = 0; i < count; ++i)
    text += fmt::format(" {}", number(chance));
  return text;
}

// At most one entity of each kind, with one or two extreme numbers.
std::string extreme_text(Chance& chance) {
  const auto usual_but = [&](const std::string& usual) {
    return fmt::format(" {}", chance.one_in(3) ? number(chance) : usual);
  };
  std::string text;
  if (chance.one_in(2))
    text += "v from" + numbers(chance, 3) + " at" + numbers(chance, 3) + " up" + numbers(chance, 3) +
            " angle" + usual_but("45") + " hither" + usual_but("0.1") + " resolution 8 8\n";
  if (chance.one_in(2)) text += "l" + numbers(chance, chance.one_in(2) ? 3 : 6) + "\n";
  if (chance.one_in(2)) text += "b" + numbers(chance, 3) + "\n";
  if (chance.one_in(2)) {
    text += "f";
    for (int i = 0; i < 8; ++i)
      text += usual_but("0.5");
    text += "\n";
  }
  if (chance.one_in(2)) text += "s" + numbers(chance, 4) + "\n";
  if (chance.one_in(2))
    text += "c" + numbers(chance, 3) + usual_but("1") + numbers(chance, 3) + usual_but("2") + "\n";
  if (chance.one_in(2)) text += "p 3" + numbers(chance, 9) + "\n";
  text += "pp 3";
  for (const char* const corner : {" 0 0 0", " 1 0 0", " 0 1 0"})
    text += corner + numbers(chance, 3);
  return text + "\n";
}

void expect_openable(const Scene& scene, Store store, const std::string& text) {
  const MemoryFile file;
  try {
    write_scene(scene, store, file.path());
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::input) << error.what();
    return;
  }
  EXPECT_NO_THROW(SceneFile(file.path())) << text;
}

TEST_F(ExtremeScene, WrittenFilesCanBeOpened) {
  int written = 0;
  for (std::int64_t i = 0; i < cases(20000); ++i) {
    const std::string text = extreme_text(chance_);
    try {
      const Scene scene = parse_nff(text, "t");
      ++written;
      for (const Store store : {Store::automatic, Store::float32, Store::float64})
        expect_openable(scene, store, text);
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::input) << error.what();
    }
  }
  EXPECT_GT(written, 0);
}

TEST_F(ExtremeScene, DenormalNormalsKeepTheirDirection) {
  for (const char* const tiny : {"5e-324", "1e-310", "1e-300", "1e-13"}) {
    const std::string normal = std::string(" 0 0 ") + tiny;
    const Scene scene = parse_nff("pp 3 0 0 0" + normal + " 1 0 0" + normal + " 0 1 0" + normal, "t");
    ASSERT_EQ(scene.normals.size(), 1U);
    EXPECT_TRUE(scene.normals[0].a == (Vec3d{0, 0, 1})) << tiny;
  }
}

} // namespace
} // namespace masu
