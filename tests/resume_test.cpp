// gridrender --resume and gridrender-mpi: whoever shares a run, and however often it is killed, its files are
// those of one undisturbed process.
#include "tests/run_tool.h"
#include "tools/bench/stability/random_seed.h"
#include "tools/bench/stability/test_scene.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <sys/wait.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <random>
#include <thread>

namespace masu {
namespace {

using Files = std::map<std::string, Bytes>; // by name

// A run's outputs, by their names in a folder.
struct Job {
  Arguments arguments;
  std::vector<std::string> outputs;
};

Arguments joined(Arguments first, const Arguments& more) {
  first.insert(first.end(), more.begin(), more.end());
  return first;
}

class SharedRuns : public ToolTest {
protected:
  // Views of one band, in files named `prefix`.
  Job views(const std::string& prefix) const {
    Job job{{scene_, grid_, "--backend", "cpu", "--turntable", "24", "--size", "90x70", "-o",
             file(prefix + "{index}.png"), "--hits", file(prefix + "{index}.hits")},
            {}};
    for (int i = 0; i < 24; ++i) {
      job.outputs.push_back(fmt::format("{}{:02}.png", prefix, i));
      job.outputs.push_back(fmt::format("{}{:02}.hits", prefix, i));
    }
    return job;
  }
  // A view of several bands: these have 1048 rows each.
  Job large(const std::string& prefix, const std::string& ending, const std::string& sampling) const {
    return {{scene_, grid_, "--backend", "cpu", "--size", "1333x3000", "--sampling", sampling, "--depth", "1",
             "-o", file(prefix + "." + ending), "--hits", file(prefix + ".hits")},
            {prefix + "." + ending, prefix + ".hits"}};
  }
  // Two chunks and a part of one.
  Job list(const std::string& prefix, const std::string& ending) const {
    if (!std::filesystem::exists(file("rays"))) {
      std::mt19937 random(1);
      std::uniform_real_distribution<float> coordinate(-1, 1);
      std::vector<float> rays(6 * ((std::size_t{2} << 20) + 5000));
      for (float& number : rays)
        number = coordinate(random);
      std::ofstream(file("rays"), std::ios::binary)
          .write(reinterpret_cast<const char*>(rays.data()),
                 static_cast<std::streamsize>(rays.size() * sizeof(float)));
    }
    return {{scene_, grid_, "--backend", "cpu", "--rays", file("rays"), "--hits", file(prefix + ending),
             "--write", "t,object,normal"},
            {prefix + ending}};
  }
  std::vector<Job> all(const std::string& prefix) const {
    return {views(prefix + "v"),
            large(prefix + "1", "png", "corners"),
            large(prefix + "2", "pfm", "corners"),
            large(prefix + "3", "png", "centers"),
            list(prefix + "4", ".hits"),
            list(prefix + "5", ".npy")};
  }

  void expect_same(const Job& job, const Job& expected) const {
    for (std::size_t i = 0; i < job.outputs.size(); ++i)
      EXPECT_TRUE(read_bytes(file(job.outputs[i])) == read_bytes(file(expected.outputs[i])))
          << job.outputs[i];
  }
  void expect_nothing_left(const Job& job) const {
    for (const std::string& name : folder_.listing())
      EXPECT_TRUE(name.find(".partial") == std::string::npos && name.find(".journal") == std::string::npos &&
                  !name.starts_with(".masu-"))
          << name << " was left behind";
    EXPECT_FALSE(job.outputs.empty());
  }
  void remove(const Job& job) const {
    for (const std::string& name : job.outputs)
      std::filesystem::remove(file(name));
  }

  const std::string scene_ = scene("a.scene", nff("a.nff", small_nff)), grid_ = grid("a.grid", scene_);
};

// The processes that a process has started.
std::vector<pid_t> children_of(pid_t parent) {
  std::vector<pid_t> found;
  for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
    const std::string name = entry.path().filename().string();
    if (name.find_first_not_of("0123456789") != std::string::npos) continue;
    std::ifstream status(entry.path() / "stat");
    std::string text;
    std::getline(status, text);
    const std::size_t after = text.rfind(')'); // of the program's name
    if (after == std::string::npos) continue;
    char state = 0;
    int its_parent = 0;
    if (std::sscanf(text.c_str() + after + 1, " %c %d", &state, &its_parent) == 2 && its_parent == parent)
      found.push_back(std::stoi(name));
  }
  return found;
}

// Waits for a process's end. Open MPI's mpirun (4.1), of which a rank is killed while ranks start, may wait
// for a lock of its own forever, whatever the program: so it is killed after a while, and counted.
int status_of(pid_t process, int& hung) {
  int status = 0;
  for (int i = 0; i < 1000; ++i) {
    if (waitpid(process, &status, WNOHANG) == process) return status;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  ++hung;
  for (const pid_t child : children_of(process))
    kill(child, SIGKILL);
  kill(process, SIGKILL);
  waitpid(process, &status, 0);
  return status;
}

struct Killed {
  int runs = 0, hung = 0; // hung: of these, those that didn't end by themselves then

  Killed& operator+=(const Killed& other) {
    runs += other.runs;
    hung += other.hung;
    return *this;
  }
};

// Kills a run at a random moment of its length, again and again until one ends by itself.
template <class Start, class Kill>
Killed run_until_whole(std::mt19937_64& random, double seconds, const Start& begin, const Kill& kill_it) {
  std::uniform_real_distribution<double> moment(0, 1);
  for (Killed killed;; ++killed.runs) {
    const pid_t process = begin();
    // Every other try lives longer, so that this ends.
    std::this_thread::sleep_for(
        std::chrono::duration<double>(seconds * moment(random) * (1 + killed.runs / 4)));
    int status = 0;
    if (waitpid(process, &status, WNOHANG) == 0) {
      kill_it(process);
      status = status_of(process, killed.hung);
    }
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return killed;
  }
}

void record(const Killed& killed) {
  testing::Test::RecordProperty("killed", killed.runs);
  testing::Test::RecordProperty("hung", killed.hung);
  fmt::print("killed {} times, of which {} had to be killed as a whole\n", killed.runs, killed.hung);
}

double seconds_of(const std::string& tool, const Arguments& arguments) {
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_TRUE(succeeded(run(tool, arguments)));
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

TEST_F(SharedRuns, AResumedRunIsTheSameAsAnUndisturbedOne) {
  for (std::size_t i = 0; i < all("x").size(); ++i) {
    const Job expected = all("a")[i], resumed = all("b")[i];
    EXPECT_TRUE(succeeded(run("gridrender", expected.arguments)));
    EXPECT_TRUE(succeeded(run("gridrender", joined(resumed.arguments, {"--resume"}))));
    expect_same(resumed, expected);
    expect_nothing_left(resumed);
  }
}

TEST_F(SharedRuns, KilledAtAnyMomentARunIsResumedToTheSameBytes) {
  const RandomSeed seed;
  SCOPED_TRACE(seed.trace());
  auto random = seed.engine();
  const std::size_t kinds = all("x").size();
  std::vector<double> seconds(kinds);
  for (std::size_t i = 0; i < kinds; ++i)
    seconds[i] = seconds_of("gridrender", all("a")[i].arguments);
  Killed killed;
  for (int round = 0; killed.runs < cases(10); ++round) {
    const std::size_t i = static_cast<std::size_t>(round) % kinds;
    const Job expected = all("a")[i], resumed = all("b")[i];
    remove(resumed);
    killed += run_until_whole(
        random, seconds[i],
        [&] {
          return start("gridrender", joined(resumed.arguments, {"--resume", "-q"}));
        },
        [](pid_t process) { kill(process, SIGKILL); });
    expect_same(resumed, expected);
    expect_nothing_left(resumed);
  }
  record(killed);
}

// What is finished isn't done again: a finished view that is changed under its journal's hash is made again,
// an unchanged one stays the same file.
TEST_F(SharedRuns, FinishedViewsStayAndDamagedOnesAreMadeAgain) {
  const Job expected = views("a"), resumed = views("b");
  EXPECT_TRUE(succeeded(run("gridrender", expected.arguments)));
  const double seconds = seconds_of("gridrender", resumed.arguments);
  remove(resumed);
  const Arguments arguments = joined(resumed.arguments, {"--resume", "--stats", file("b.json")});
  std::vector<std::string> kept;
  for (double length = seconds / 2; kept.size() < 4; length *= 1.5) { // until some views were finished
    remove(resumed);
    const pid_t process = start("gridrender", arguments);
    std::this_thread::sleep_for(std::chrono::duration<double>(length));
    kill(process, SIGKILL);
    int status = 0;
    waitpid(process, &status, 0);
    kept.clear();
    if (WIFEXITED(status)) {
      length = seconds / 4;
      continue;
    }
    std::ifstream journal(file("b00.png.journal.0"));
    std::string line;
    std::getline(journal, line);
    while (std::getline(journal, line)) {
      const auto json = nlohmann::json::parse(line, nullptr, false);
      if (json.is_object()) kept.push_back(json["files"][0]["name"].get<std::string>());
    }
  }
  const auto inode = [](const std::string& path) {
    struct stat status {};
    EXPECT_EQ(stat(path.c_str(), &status), 0) << path;
    return status.st_ino;
  };
  const auto unchanged = inode(kept.at(0));
  write_text(kept.at(1), "torn");
  EXPECT_TRUE(succeeded(run("gridrender", arguments)));
  EXPECT_EQ(inode(kept.at(0)), unchanged);
  expect_same(resumed, expected);
  // Counts are those of all views.
  EXPECT_TRUE(succeeded(run("gridrender", joined(expected.arguments, {"--stats", file("a.json")}))));
  const auto a = nlohmann::json::parse(read_text(file("a.json"))),
             b = nlohmann::json::parse(read_text(file("b.json")));
  for (const char* const key : {"eye_rays", "eye_hits", "shadow_rays", "cells_visited", "intersection_tests"})
    EXPECT_EQ(a[key], b[key]) << key;
}

TEST_F(SharedRuns, AJournalOfOtherOptionsIsIgnored) {
  const Job expected = large("a", "png", "corners"), resumed = large("b", "png", "corners");
  EXPECT_TRUE(succeeded(run("gridrender", expected.arguments)));
  const double seconds = seconds_of("gridrender", resumed.arguments);
  const pid_t process = start("gridrender", joined(resumed.arguments, {"--srgb", "--resume"}));
  std::this_thread::sleep_for(std::chrono::duration<double>(seconds * 0.8));
  kill(process, SIGKILL);
  int status = 0;
  waitpid(process, &status, 0);
  EXPECT_TRUE(succeeded(run("gridrender", joined(resumed.arguments, {"--resume"}))));
  expect_same(resumed, expected);
  expect_nothing_left(resumed);
}

TEST_F(SharedRuns, WhatCannotBeResumedIsRefused) {
  const auto refused = [&](const Arguments& more, const std::string& place) {
    return failed(run("gridrender", joined({scene_, grid_, "--backend", "cpu", "--resume"}, more)), 1,
                  "gridrender", place);
  };
  EXPECT_TRUE(refused({"--stats", file("s")}, "--resume"));
  EXPECT_TRUE(refused({"-o", "-"}, "-"));
  EXPECT_TRUE(refused({"-o", "/dev/null", "--format", "png"}, "/dev/null"));
  EXPECT_TRUE(refused({"--rays", "-", "--hits", file("h")}, "--rays"));
}

#ifdef MASU_MPIRUN

class MpiRuns : public SharedRuns {
protected:
  void SetUp() override {
    for (const char* const name : {"OMPI_ALLOW_RUN_AS_ROOT", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM"})
      setenv(name, "1", 1);
    // Ranks of one machine need no network, of whose interfaces Open MPI 5 may warn.
    setenv("OMPI_MCA_btl", "^tcp", 1);
  }
  static Arguments by(int ranks, const Arguments& arguments) {
    return joined(
        {"--oversubscribe", "-n", std::to_string(ranks), std::string(MASU_BIN_DIR) + "/gridrender-mpi"},
        arguments);
  }
};

TEST_F(MpiRuns, AnyNumberOfRanksWritesTheSameBytes) {
  for (std::size_t i = 0; i < all("x").size(); ++i) {
    const Job expected = all("a")[i], shared = all("b")[i];
    EXPECT_TRUE(succeeded(run("gridrender", joined(expected.arguments, {"--stats", file("a.json")}))));
    for (const int ranks : {1, 2, 4}) {
      remove(shared);
      EXPECT_TRUE(
          succeeded(run(MASU_MPIRUN, by(ranks, joined(shared.arguments, {"--stats", file("b.json")})))))
          << ranks;
      expect_same(shared, expected);
      expect_nothing_left(shared);
      const auto a = nlohmann::json::parse(read_text(file("a.json"))),
                 b = nlohmann::json::parse(read_text(file("b.json")));
      for (const char* const key : {"eye_rays", "eye_hits", "shadow_rays", "cells_visited"})
        EXPECT_EQ(a[key], b[key]) << key;
    }
  }
}

// Open MPI takes ranks for those of another machine where its remote shell started them, whatever that is.
TEST_F(MpiRuns, RanksOfSeveralMachinesWriteTheSameBytes) {
  unsetenv("OMPI_MCA_btl");
  const std::string shell = file("shell");
  // Daemons on what is one machine after all would race for the folder of their session: each has its own.
  write_text(shell, "#!/bin/sh\nwhile [ \"${1#-}\" != \"$1\" ]; do shift; done\n"
                    "export OMPI_MCA_orte_tmpdir_base=" +
                        file("sessions") +
                        "-$1\nmkdir -p \"$OMPI_MCA_orte_tmpdir_base\"\nshift\nexec sh -c \"$*\"\n");
  std::filesystem::permissions(shell, std::filesystem::perms::owner_all);
  for (std::size_t i = 0; i < all("x").size(); ++i) {
    const Job expected = all("a")[i], shared = all("b")[i];
    EXPECT_TRUE(succeeded(run("gridrender", expected.arguments)));
    // Its daemons, who share a machine after all, may warn of each other.
    const ToolResult result =
        run(MASU_MPIRUN, joined({"--mca", "plm_rsh_agent", shell, "--host", "machine1:2,machine2:1"},
                                by(3, shared.arguments)));
    EXPECT_EQ(result.code, 0) << result.err;
    expect_same(shared, expected);
    expect_nothing_left(shared);
  }
  const auto refused =
      run(MASU_MPIRUN, joined({"--mca", "plm_rsh_agent", shell, "--host", "machine1:1,machine2:1"},
                              by(2, {scene_, file("missing"), "-o", file("a.png"), "--backend", "cpu"})));
  EXPECT_EQ(refused.code, 2) << refused.err;
}

// One rank, or all and mpirun.
TEST_F(MpiRuns, KilledRanksAreResumedToTheSameBytes) {
  const RandomSeed seed;
  SCOPED_TRACE(seed.trace());
  auto random = seed.engine();
  const std::size_t kinds = all("x").size();
  std::vector<double> seconds(kinds);
  for (std::size_t i = 0; i < kinds; ++i) {
    EXPECT_TRUE(succeeded(run("gridrender", all("a")[i].arguments)));
    seconds[i] = seconds_of(MASU_MPIRUN, by(2, all("b")[i].arguments));
  }
  Killed killed;
  for (int round = 0; killed.runs < cases(6); ++round) {
    const std::size_t i = static_cast<std::size_t>(round) % kinds;
    const Job expected = all("a")[i], resumed = all("b")[i];
    remove(resumed);
    killed += run_until_whole(
        random, seconds[i],
        [&] {
          const int ranks = 1 + static_cast<int>(random() % 3);
          return start(MASU_MPIRUN, by(ranks, joined(resumed.arguments, {"--resume", "-q"})));
        },
        [&](pid_t process) {
          const std::vector<pid_t> ranks = children_of(process);
          if (ranks.empty() || random() % 2 == 0) {
            kill(process, SIGKILL);
            for (const pid_t rank : ranks)
              kill(rank, SIGKILL);
          } else {
            kill(ranks[random() % ranks.size()], SIGKILL);
          }
        });
    expect_same(resumed, expected);
    expect_nothing_left(resumed);
  }
  record(killed);
}

// mpirun adds lines of its own; Open MPI 5 also spaces before those of its ranks.
TEST_F(MpiRuns, AnErrorIsOneLineAndItsExitCode) {
  const auto lines_of_tool = [](const std::string& text) {
    std::istringstream lines(text);
    std::vector<std::string> found;
    for (std::string line; std::getline(lines >> std::ws, line);)
      if (line.starts_with("gridrender: ")) found.push_back(line);
    return found;
  };
  const auto refused = [&](int code, const Arguments& arguments, const std::string& place) {
    const ToolResult result = run(MASU_MPIRUN, by(3, arguments));
    EXPECT_EQ(result.code, code) << result.err;
    const auto lines = lines_of_tool(result.err);
    ASSERT_EQ(lines.size(), 1U) << result.err;
    EXPECT_TRUE(lines[0].starts_with("gridrender: " + place)) << lines[0];
  };
  refused(1, {scene_, "--no-such-option"}, "command line");
  refused(2, {scene_, file("missing"), "-o", file("a.png"), "--backend", "cpu"}, file("missing"));
  refused(3, {scene_, grid_, "-o", file("missing/a.png"), "--backend", "cpu"}, file("missing/a.png"));
  refused(1, {scene_, grid_, "-o", "-", "--backend", "cpu"}, "-");
}

#else

TEST(MpiRuns, AreTested) {
  GTEST_SKIP() << "built without MPI: gridrender-mpi isn't there";
}

#endif

} // namespace
} // namespace masu
