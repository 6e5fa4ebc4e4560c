// A tool that a signal terminates at any moment leaves each output unchanged or complete, and no other files.
#include "stability/test_scene.h"
#include "tests/tools/run_tool.h"

#include <sys/wait.h>

#include <algorithm>
#include <csignal>
#include <map>
#include <random>
#include <thread>

namespace masu {
namespace {

using Files = std::map<std::string, Bytes>; // by name

class InterruptedTool : public ToolTest {
protected:
  Files files() const {
    Files all;
    for (const std::string& name : folder_.listing())
      all[name] = read_bytes(file(name));
    return all;
  }

  // Runs the tool once to its end, and then several times until a random moment, when the signal is sent.
  // Outputs that changed must satisfy is_whole(name, bytes).
  template <class IsWhole>
  void interrupt(int signal, const std::string& tool, const Arguments& arguments,
                 const IsWhole& is_whole) const {
    auto random = seed_.engine();
    const auto whole_run = time_of(tool, arguments);
    std::uniform_real_distribution<double> moment(0, 1.1);
    int interrupted = 0;
    for (int i = 0; i < cases(6); ++i) {
      const Files before = files();
      const pid_t process = start(tool, arguments);
      ASSERT_GT(process, 0);
      std::this_thread::sleep_for(whole_run * moment(random));
      kill(process, signal);
      int status = 0;
      ASSERT_EQ(waitpid(process, &status, 0), process);
      interrupted += WIFSIGNALED(status) ? 1 : 0;
      if (WIFSIGNALED(status))
        EXPECT_EQ(WTERMSIG(status), signal);
      else
        EXPECT_EQ(WEXITSTATUS(status), 0);
      Files after = files();
      // Killed between linking and renaming: the next run removes the temporary file.
      if (signal == SIGKILL && remove_temporary(after)) {
        time_of(tool, arguments);
        Files cleaned = files();
        EXPECT_FALSE(remove_temporary(cleaned));
      }
      for (const auto& [name, bytes] : after) {
        if (!before.contains(name)) {
          ADD_FAILURE() << name << " was left behind";
        } else if (bytes != before.at(name)) {
          EXPECT_TRUE(is_whole(name, bytes)) << name;
        }
      }
      EXPECT_EQ(after.size(), before.size());
    }
    RecordProperty("interrupted", interrupted);
  }

  static bool remove_temporary(Files& files) {
    return std::erase_if(files, [](const auto& file) { return file.first.starts_with(".masu-"); }) > 0;
  }

  // For tools whose outputs are deterministic.
  void expect_same_or_new(const std::string& tool, std::string_view options, std::string_view outputs) const {
    const Arguments arguments = words(options);
    for (const int signal : {SIGKILL, SIGTERM, SIGINT}) {
      time_of(tool, arguments);
      const Files expected = files();
      for (const std::string& output : words(outputs))
        write_text(output, "old");
      interrupt(signal, tool, arguments,
                [&](const std::string& name, const Bytes& bytes) { return bytes == expected.at(name); });
    }
  }
};

TEST_F(InterruptedTool, Nff2binLeavesTheOldOrTheNewScene) {
  spd("a.nff", "balls", 3);
  expect_same_or_new("nff2bin", "~/a.nff -o ~/a.scene --tessellate 12", "~/a.scene");
}

TEST_F(InterruptedTool, GridbuildLeavesTheOldOrTheNewGrid) {
  scene("a.scene", spd("a.nff", "balls", 2), {"--tessellate", "12"});
  expect_same_or_new("gridbuild", "~/a.scene -o ~/a.grid", "~/a.grid");
}

TEST_F(InterruptedTool, GridrenderLeavesOldOrNewFiles) {
  grid("a.grid", scene("a.scene", spd("a.nff", "balls", 3)));
  expect_same_or_new("gridrender",
                     "~/a.scene ~/a.grid -o ~/a.pfm --hits ~/a.hits --size 256x256 --backend cpu",
                     "~/a.pfm ~/a.hits");
}

TEST_F(InterruptedTool, GridrenderLeavesOldOrNewViews) {
  grid("a.grid", scene("a.scene", spd("a.nff", "balls", 1)));
  // Small ones, so that most of the time goes to files: several threads write them.
  expect_same_or_new("gridrender",
                     "~/a.scene ~/a.grid --turntable 60 --size 4x4 --backend cpu -o ~/{index}.pfm "
                     "--hits ~/{index}.hits",
                     "");
}

// tradeoff.csv grows row by row; charts and charts.csv are written by every run.
TEST_F(InterruptedTool, TradeoffKeepsItsRowsAndChartsAreComplete) {
  scene("a.scene", nff("a.nff", small_nff));
  const Arguments arguments =
      words("tradeoff ~/a.scene -o ~ --size 24x18 --random 100 --compared 100 --picture 8x8 --repeat 1 "
            "--merges none --divisions 3 --curve 2,3 --backend cpu");
  const std::string table = file("tradeoff.csv");
  const auto ends_with = [](const Bytes& bytes, std::string_view end) {
    return std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()).ends_with(end);
  };
  for (const int signal : {SIGKILL, SIGTERM, SIGINT}) {
    time_of("gridbench", arguments);
    const std::string all_rows = read_text(table);
    write_text(table, all_rows.substr(0, all_rows.find('\n') + 1));
    interrupt(signal, "gridbench", arguments, [&](const std::string& name, const Bytes& bytes) {
      if (name == "tradeoff.csv") return true;
      return name.ends_with(".csv")   ? ends_with(bytes, "\n")
             : name.ends_with(".svg") ? ends_with(bytes, "</svg>\n\n") || ends_with(bytes, "</svg>\n")
                                      : ends_with(bytes, "IEND\xae\x42\x60\x82");
    });
    EXPECT_EQ(run("gridbench", arguments).code, 0); // continues from the rows in the file
    EXPECT_EQ(std::ranges::count(read_text(table), '\n'), std::ranges::count(all_rows, '\n'));
  }
}

} // namespace
} // namespace masu
