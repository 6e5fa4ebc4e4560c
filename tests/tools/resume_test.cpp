// --resume, gridrender-mpi and gridtrace-mpi: whoever shares a run, and however often it is killed, its files
// are those of one undisturbed process; and files that are there are kept.
#include "renderer/image/jpeg_file.h"
#include "stability/test_scene.h"
#include "tests/tools/run_tool.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <sys/stat.h>
#include <sys/wait.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>
#include <thread>

namespace masu {
namespace {

// A run's outputs, by their names in a folder.
struct Job {
  Arguments arguments;
  std::vector<std::string> outputs;
  std::string tool = "gridrender";
};

class SharedRuns : public SmallSceneTest {
protected:
  // Views of one band, in files named `prefix`.
  Job views(const std::string& prefix) const {
    const std::string name = file(prefix + "{index}");
    Job job{on_cpu({"--turntable", "24", "--size", "90x70", "-o", name + ".png", "--hits", name + ".hits"}),
            {}};
    for (int i = 0; i < 24; ++i)
      for (const char* const ending : {"png", "hits"})
        job.outputs.push_back(fmt::format("{}{:02}.{}", prefix, i, ending));
    return job;
  }
  // A view of two bands: the first one has 1048 rows, of a JPEG 1568.
  Job large(const std::string& prefix, const std::string& ending, const std::string& sampling,
            const std::string& size = "1333x1100") const {
    return {on_cpu({"--size", size, "--sampling", sampling, "--depth", "1", "-o", file(prefix + "." + ending),
                    "--hits", file(prefix + ".hits")}),
            {prefix + "." + ending, prefix + ".hits"}};
  }
  // More such views than two ranks.
  Job turned(const std::string& prefix) const {
    return {on_cpu(words("--turntable 3 --size 1333x1100 --sampling centers --depth 1 -o ~/" + prefix +
                         "{index}.png")),
            {prefix + "0.png", prefix + "1.png", prefix + "2.png"}};
  }
  // A chunk and a part of one.
  Job list(const std::string& prefix, const std::string& ending) const {
    if (!std::filesystem::exists(file("rays")))
      write_records(file("rays"), random_rays((std::size_t{1} << 20) + 5000, 1));
    return {on_cpu({file("rays"), "-o", file(prefix + ending), "--write", "t,object,normal"}),
            {prefix + ending},
            "gridtrace"};
  }
  // A chunk and a part of one, as text, of lines of different lengths and blank ones.
  Job csv_list(const std::string& prefix) const {
    const Job job{on_cpu({file("rays.csv"), "-o", file(prefix + ".csv")}), {prefix + ".csv"}, "gridtrace"};
    if (std::filesystem::exists(file("rays.csv"))) return job;
    std::string text = "ox,oy,oz,dx,dy,dz\n\n";
    for (std::size_t i = 0; i < (std::size_t{1} << 20) + 1000; ++i)
      text += fmt::format("{},{},3,0.125,{},-1\n{}", static_cast<double>(i % 1000) / 250 - 2,
                          static_cast<double>(i % 773) / 200 - 2, static_cast<double>(i % 7) / 64,
                          i % 100'000 == 0 ? "\n" : "");
    write_text(file("rays.csv"), text);
    return job;
  }
  std::vector<Job> all(const std::string& prefix) const {
    std::vector<Job> jobs{
        views(prefix + "v"),   large(prefix + "1", "png", "corners"), large(prefix + "2", "pfm", "corners"),
        turned(prefix + "3"),  list(prefix + "4", ".hits"),           list(prefix + "5", ".npy"),
        csv_list(prefix + "6")};
    if (has_libjpeg()) jobs.push_back(large(prefix + "7", "jpg", "corners", "1333x1700"));
    return jobs;
  }

  void expect_made(const Job& job, const Arguments& more = {}) const {
    expect_run(job.tool, joined(job.arguments, more));
  }
  // The same files as of another job, and nothing else beside them.
  void expect_same(const Job& job, const Job& expected) const {
    EXPECT_FALSE(job.outputs.empty());
    for (std::size_t i = 0; i < job.outputs.size(); ++i)
      EXPECT_TRUE(read_bytes(file(job.outputs[i])) == read_bytes(file(expected.outputs[i])))
          << job.outputs[i];
    EXPECT_EQ(temporary_files(), 0);
  }
  std::ptrdiff_t temporary_files() const {
    return std::ranges::count_if(folder_.listing(),
                                 [](const std::string& name) { return name.starts_with(".masu-"); });
  }
  void remove(const Job& job) const {
    for (const std::string& name : job.outputs)
      std::filesystem::remove(file(name));
  }

  // Of a file that is made anew, and of one that is written to, it is another one.
  std::string state_of(const std::string& name) const {
    struct stat status {};
    if (stat(file(name).c_str(), &status) != 0) return "none";
    return fmt::format("{} {}.{}", status.st_ino, status.st_mtim.tv_sec, status.st_mtim.tv_nsec);
  }
  std::vector<std::string> states_of(const Job& job) const {
    std::vector<std::string> states;
    for (const std::string& name : job.outputs)
      states.push_back(state_of(name));
    return states;
  }

  // Kills runs of each job in turn, so many in all, at random moments: each file is then as a run by one
  // process makes it, or isn't there. What is there is kept when the job is resumed. `starting`: seconds
  // before a run begins its work.
  template <class Start, class Kill>
  void kill_and_resume(int runs, std::mt19937_64& random, double starting, const Start& begin,
                       const Kill& kill_it, std::ptrdiff_t most_temporary_files) const;
};

// A process's state, as proc(5) has it, and its parent; '-' of one that is gone.
std::pair<char, pid_t> state_and_parent(const std::string& process) {
  std::ifstream status("/proc/" + process + "/stat");
  std::string text;
  std::getline(status, text);
  const std::size_t after = text.rfind(')'); // of the program's name
  std::pair<char, pid_t> found{'-', 0};
  if (after != std::string::npos)
    std::sscanf(text.c_str() + after + 1, " %c %d", &found.first, &found.second);
  return found;
}
// The processes that a process has started.
std::vector<pid_t> children_of(pid_t parent) {
  std::vector<pid_t> found;
  for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
    const std::string name = entry.path().filename().string();
    if (name.find_first_not_of("0123456789") != std::string::npos) continue;
    if (state_and_parent(name).second == parent) found.push_back(std::stoi(name));
  }
  return found;
}
// Until then its files are locked, also once it was killed.
void wait_for_end(pid_t process) {
  for (int i = 0; i < 1000; ++i) {
    const char state = state_and_parent(std::to_string(process)).first;
    if (state == '-' || state == 'Z' || state == 'X') return;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
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
  const std::vector<pid_t> children = children_of(process);
  for (const pid_t child : children)
    kill(child, SIGKILL);
  kill(process, SIGKILL);
  waitpid(process, &status, 0);
  std::ranges::for_each(children, wait_for_end);
  return status;
}

template <class Start, class Kill>
void SharedRuns::kill_and_resume(int runs, std::mt19937_64& random, double starting, const Start& begin,
                                 const Kill& kill_it, std::ptrdiff_t most_temporary_files) const {
  std::uniform_real_distribution<double> moment(0, 1);
  const std::vector<Job> expected = all("a"), resumed = all("b");
  std::vector<double> all_seconds;
  for (const Job& job : expected)
    all_seconds.push_back(time_of(job.tool, job.arguments).count());
  int killed = 0, hung = 0, kept = 0;
  for (std::size_t i = 0; killed < cases(runs); i = (i + 1) % resumed.size(), ++killed) {
    const Job& job = resumed[i];
    const double seconds = starting + all_seconds[i];
    remove(job);
    const pid_t process = begin(job);
    std::this_thread::sleep_for(std::chrono::duration<double>(seconds * moment(random)));
    int status = 0;
    if (waitpid(process, &status, WNOHANG) == 0) {
      kill_it(process);
      status_of(process, hung);
    }
    const std::vector<std::string> states = states_of(job);
    for (std::size_t k = 0; k < states.size(); ++k) {
      if (states[k] == "none") continue;
      EXPECT_TRUE(read_bytes(file(job.outputs[k])) == read_bytes(file(expected[i].outputs[k])))
          << job.outputs[k];
      ++kept;
    }
    EXPECT_LE(temporary_files(), most_temporary_files);
    EXPECT_EQ(status_of(begin(job), hung), 0);
    expect_same(job, expected[i]);
    for (std::size_t k = 0; k < states.size(); ++k)
      EXPECT_TRUE(states[k] == "none" || state_of(job.outputs[k]) == states[k]) << job.outputs[k];
  }
  RecordProperty("hung", hung);
  fmt::print("killed {} times, {} as a whole; then {} files were there\n", killed, hung, kept);
}

TEST_F(SharedRuns, KilledAtAnyMomentARunLeavesWholeFilesAlone) {
  auto random = seed_.engine();
  kill_and_resume(
      8, random, 0,
      [](const Job& job) {
        return start(job.tool, joined(job.arguments, {"--resume", "-q"}));
      },
      [](pid_t process) { kill(process, SIGKILL); }, 0);
}

// --- Files that are there ----------------------------------------------------------------------------------

TEST_F(SharedRuns, FilesThatAreThereStayAndMissingOnesAreMade) {
  const Job expected = views("a"), resumed = views("b");
  expect_made(expected);
  expect_made(resumed);
  for (const char* const name : {"b03.png", "b07.hits", "b11.png", "b11.hits"})
    std::filesystem::remove(file(name));
  const auto kept = states_of(resumed);
  const Arguments arguments = joined(resumed.arguments, {"--resume", "--stats", file("b.json")});
  const ToolResult result = run("gridrender", arguments);
  EXPECT_TRUE(succeeded(result));
  EXPECT_NE(result.err.find("gridrender: --resume: 44 of 48 files are there and are kept\n"),
            std::string::npos)
      << result.err;
  expect_same(resumed, expected);
  const auto states = states_of(resumed);
  for (std::size_t i = 0; i < states.size(); ++i)
    EXPECT_TRUE(kept[i] == "none" || states[i] == kept[i]) << resumed.outputs[i];
  // Others aren't traced again.
  auto report = json_in("b.json");
  EXPECT_EQ(report["kept"], 44);
  EXPECT_EQ(report["views"], 3);
  EXPECT_EQ(report["eye_rays"], 3 * 91 * 71);
  // Nor is anything when all are there, and the report stays.
  const std::string json = state_of("b.json");
  const ToolResult again = run("gridrender", arguments);
  EXPECT_EQ(again.err, "gridrender: --resume: 48 of 48 files are there and are kept\n");
  EXPECT_EQ(run("gridrender", joined(arguments, {"-q"})).err, "");
  EXPECT_EQ(states_of(resumed), states);
  EXPECT_EQ(state_of("b.json"), json);
  // One that isn't there is written.
  expect_made(resumed, {"--resume", "--stats", file("new.json")});
  EXPECT_EQ(states_of(resumed), states);
  report = json_in("new.json");
  EXPECT_EQ(report["kept"], 48);
  EXPECT_EQ(report["views"], 0);
}

TEST_F(SharedRuns, EveryKindOfFileIsKept) {
  for (const Job& job : all("a")) {
    SCOPED_TRACE(job.outputs.front());
    expect_made(job);
    const auto states = states_of(job);
    expect_made(job, {"--resume"});
    EXPECT_EQ(states_of(job), states);
  }
}

// A picture whose texts name another scene, view or options, and hits beside it.
TEST_F(SharedRuns, PicturesOfSomethingElseAreMadeAgain) {
  const std::string other = scene("other.scene", nff("other.nff", other_nff));
  const std::string other_grid = grid("other.grid", other);
  for (const std::string ending : {"png", "jpg"}) {
    if (ending == "jpg" && !has_libjpeg()) continue;
    const auto job = [&](const std::string& name, const Arguments& more = {}) {
      return Job{
          on_cpu(joined({"--size", "40x30", "-o", file(name + "." + ending), "--hits", file(name + ".hits")},
                        more)),
          {name + "." + ending, name + ".hits"}};
    };
    const Job expected = job("a"), resumed = job("b");
    expect_made(expected);
    Job of_other = resumed;
    std::ranges::replace(of_other.arguments, scene_, other);
    std::ranges::replace(of_other.arguments, grid_, other_grid);
    for (const Job& before : {of_other, job("b", {"--srgb"}), job("b", {"--from", "3,-4,2.5"}),
                              job("b", {"--sampling", "centers"}), job("b", {"--crop", "0,0,40,30"})}) {
      expect_made(before);
      expect_made(resumed, {"--resume"});
      expect_same(resumed, expected);
    }
  }
}

// Of files without texts: those of another size; all of them if the report says so.
TEST_F(SharedRuns, ValuesOfAnotherSizeOrRunAreMadeAgain) {
  write_records(file("few"), std::vector<float>(60, 1));
  write_records(file("more"), std::vector<float>(120, 1));
  const auto picture = [&](const std::string& name, const std::string& size, const Arguments& more = {}) {
    return Job{
        on_cpu(joined({"--size", size, "-o", file(name + ".pfm"), "--hits", file(name + ".npy")}, more)),
        {name + ".pfm", name + ".npy"}};
  };
  const auto hits = [&](const std::string& name, const std::string& rays, const Arguments& more = {}) {
    return Job{on_cpu(joined({file(rays), "-o", file(name + ".hits")}, more)), {name + ".hits"}, "gridtrace"};
  };
  const Arguments report{"--times", file("b.json")};
  struct Case {
    Job expected, before, resumed;
  };
  for (const auto& [expected, before, resumed] :
       {Case{picture("a", "40x30"), picture("b", "30x40"), picture("b", "40x30")},
        Case{hits("a", "few"), hits("b", "more"), hits("b", "few")},
        Case{hits("a", "few", {"--faces", "back"}), hits("b", "few", report),
             hits("b", "few", joined({"--faces", "back"}, report))},
        Case{picture("a", "40x30", {"--depth", "1"}), picture("b", "40x30", report),
             picture("b", "40x30", joined({"--depth", "1"}, report))}}) {
    SCOPED_TRACE(resumed.outputs.front());
    std::filesystem::remove(file("b.json"));
    expect_made(expected);
    expect_made(before);
    expect_made(resumed, {"--resume"});
    expect_same(resumed, expected);
    const auto states = states_of(resumed); // the report is of them now
    expect_made(resumed, {"--resume"});
    EXPECT_EQ(states_of(resumed), states);
  }
}

// What --resume doesn't know is left alone.
TEST_F(SharedRuns, WhatIsNoFileIsntReplaced) {
  std::filesystem::create_directory(file("b.png"));
  write_records(file("few"), std::vector<float>(60, 1));
  ASSERT_EQ(mkfifo(file("fifo").c_str(), 0600), 0);
  expect_refused(1, R"(
gridrender ~/a.scene ~/a.grid --backend cpu --resume -o ~/b.png        > @: isn't a regular file
gridtrace ~/a.scene ~/a.grid ~/few --backend cpu --resume -o ~/fifo    > @: isn't a regular file
)");
}

#ifdef MASU_MPIRUN

class MpiRuns : public SharedRuns {
protected:
  void SetUp() override {
    for (const char* const name : {"OMPI_ALLOW_RUN_AS_ROOT", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM"})
      setenv(name, "1", 1);
    // Ranks of one machine need no network, of whose interfaces Open MPI 5 may warn, and which libfabric
    // takes a second to look for.
    setenv("OMPI_MCA_btl", "^tcp,ofi", 1);
  }
  static Arguments by(int ranks, const std::string& tool, const Arguments& arguments) {
    return joined(
        {"--oversubscribe", "-n", std::to_string(ranks), std::string(MASU_BIN_DIR) + "/" + tool + "-mpi"},
        arguments);
  }
  static Arguments by(int ranks, const Job& job, const Arguments& more = {}) {
    return by(ranks, job.tool, joined(job.arguments, more));
  }
};

TEST_F(MpiRuns, AnyNumberOfRanksWritesTheSameBytes) {
  for (std::size_t i = 0; i < all("x").size(); ++i) {
    const Job expected = all("a")[i], shared = all("b")[i];
    expect_made(expected, {"--stats", file("a.json")});
    const int ranks = 1 + static_cast<int>(i % 3);
    EXPECT_TRUE(succeeded(run(MASU_MPIRUN, by(ranks, shared, {"--stats", file("b.json")})))) << ranks;
    expect_same(shared, expected);
    const auto a = json_in("a.json"), b = json_in("b.json");
    for (const char* const key : {"eye_rays", "eye_hits", "shadow_rays", "cells_visited"})
      EXPECT_EQ(a[key], b[key]) << key;
  }
}

// Open MPI takes ranks for those of another machine where its remote shell started them, whatever that is.
TEST_F(MpiRuns, RanksOfSeveralMachinesWriteTheSameBytes) {
  setenv("OMPI_MCA_btl", "^ofi", 1);
  const std::string shell = file("shell");
  // Daemons on what is one machine after all would race for the folder of their session: each has its own.
  write_text(shell, "#!/bin/sh\nwhile [ \"${1#-}\" != \"$1\" ]; do shift; done\n"
                    "export OMPI_MCA_orte_tmpdir_base=" +
                        file("sessions") +
                        "-$1\nmkdir -p \"$OMPI_MCA_orte_tmpdir_base\"\nshift\nexec sh -c \"$*\"\n");
  std::filesystem::permissions(shell, std::filesystem::perms::owner_all);
  const auto on_two_machines = [&](const char* hosts, const Arguments& arguments) {
    return run(MASU_MPIRUN, joined({"--mca", "plm_rsh_agent", shell, "--host", hosts}, arguments));
  };
  for (const auto& [expected, shared] :
       {std::pair{turned("a"), turned("b")}, {list("a", ".npy"), list("b", ".npy")}}) {
    expect_made(expected);
    // Its daemons, who share a machine after all, may warn of each other.
    const ToolResult result = on_two_machines("machine1:2,machine2:1", by(3, shared));
    EXPECT_EQ(result.code, 0) << result.err;
    expect_same(shared, expected);
  }
  const ToolResult refused = on_two_machines(
      "machine1:1,machine2:1", by(2, "gridrender", words("~/a.scene ~/missing -o ~/a.png --backend cpu")));
  EXPECT_EQ(refused.code, 2) << refused.err;
}

// One rank, or all and mpirun. What rank 0 had made for all is left where it was killed itself, and removed
// by the next run that makes the file.
TEST_F(MpiRuns, KilledRanksLeaveWholeFilesAlone) {
  setenv("OMPI_MCA_btl", "^tcp", 1); // ranks start slowly, and more of them are killed while they do
  auto random = seed_.engine();
  kill_and_resume(
      6, random, time_of(MASU_MPIRUN, by(2, "gridrender", {"--version"})).count(),
      [&](const Job& job) {
        const int ranks = 1 + static_cast<int>(random() % 3);
        return start(MASU_MPIRUN, by(ranks, job, {"--resume", "-q"}));
      },
      [&](pid_t process) {
        kill(process, SIGSTOP); // it starts no more ranks
        const std::vector<pid_t> ranks = children_of(process);
        if (ranks.empty() || random() % 2 == 0) {
          for (const pid_t rank : ranks)
            kill(rank, SIGKILL);
          kill(process, SIGKILL);
          for (const pid_t rank : ranks)
            wait_for_end(rank);
        } else {
          kill(ranks[random() % ranks.size()], SIGKILL);
          kill(process, SIGCONT);
        }
      },
      2 * 3);
}

TEST_F(MpiRuns, FilesThatAreThereStay) {
  for (const auto& [expected, resumed] :
       {std::pair{views("a"), views("b")}, std::pair{list("a", ".hits"), list("b", ".hits")}}) {
    expect_made(expected);
    expect_run(MASU_MPIRUN, by(3, resumed));
    const auto states = states_of(resumed);
    expect_run(MASU_MPIRUN, by(3, resumed, {"--resume"}));
    EXPECT_EQ(states_of(resumed), states);
    std::filesystem::remove(file(resumed.outputs.front()));
    expect_run(MASU_MPIRUN, by(2, resumed, {"--resume"}));
    expect_same(resumed, expected);
  }
}

TEST_F(MpiRuns, AFailedOrTerminatedRunLeavesNoOutputs) {
  const Job job = large("b", "pfm", "centers");
  const auto before = folder_.listing();
  // Whichever band a rank writes, it lies beyond 8 MB in one of the files; memory that ranks share must not.
  const std::string command = "ulimit -f 16000; exec \"$0\" \"$@\"";
  const ToolResult result =
      run(MASU_MPIRUN, joined({"--mca", "btl_sm_segment_size", "1048576", "--oversubscribe", "-n", "2",
                               "/bin/sh", "-c", command, std::string(MASU_BIN_DIR) + "/gridrender-mpi"},
                              job.arguments));
  EXPECT_EQ(result.code, 3) << result.err;
  EXPECT_EQ(folder_.listing(), before);
  // mpirun takes a second to end its ranks, at last by SIGKILL: then their temporary files may be left for
  // the next run that makes the same files.
  int hung = 0;
  const pid_t process = start(MASU_MPIRUN, by(2, large("b", "pfm", "centers", "4000x4000")));
  for (int i = 0; i < 2000 && temporary_files() < 2; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  EXPECT_EQ(temporary_files(), 2);
  kill(process, SIGTERM);
  EXPECT_NE(status_of(process, hung), 0);
  for (const std::string& name : job.outputs)
    EXPECT_FALSE(std::filesystem::exists(file(name))) << name;
  EXPECT_TRUE(succeeded(run(MASU_MPIRUN, by(2, job))));
  remove(job);
  EXPECT_EQ(folder_.listing(), before);
}

// mpirun adds lines of its own; Open MPI 5 also spaces before those of its ranks.
TEST_F(MpiRuns, AnErrorIsOneLineAndItsExitCode) {
  // Among what mpirun says, before or after it: Open MPI 5 ends that with a zero byte.
  const auto lines_of_tool = [](std::string text) {
    std::ranges::replace(text, '\0', '\n');
    std::istringstream lines(text);
    std::vector<std::string> found;
    for (std::string line; std::getline(lines >> std::ws, line);)
      if (line.starts_with("gridrender: ")) found.push_back(line);
    return found;
  };
  const auto refused = [&](int code, const std::string& command, const std::string& place) {
    const ToolResult result = run(MASU_MPIRUN, by(3, "gridrender", words(command)));
    EXPECT_EQ(result.code, code) << result.err;
    const auto lines = lines_of_tool(result.err);
    ASSERT_EQ(lines.size(), 1U) << result.err;
    EXPECT_TRUE(lines[0].starts_with("gridrender: " + place)) << lines[0];
  };
  refused(1, "~/a.scene --no-such-option", "--no-such-option");
  refused(2, "~/a.scene ~/missing -o ~/a.png --backend cpu", file("missing"));
  refused(3, "~/a.scene ~/a.grid -o ~/missing/a.png --backend cpu", file("missing/a.png"));
  refused(1, "~/a.scene ~/a.grid -o - --backend cpu", "-");
}

// Without what MPI starts its processes by, and by mpirun once.
TEST_F(MpiRuns, HelpAndVersionNeedNoMpi) {
  const Surroundings without{"/dev/null", {}, "PATH=/missing"};
  for (const std::string tool : {"gridrender", "gridtrace"}) {
    for (const char* const option : {"--version", "--help"}) {
      const ToolResult alone = run(tool + "-mpi", {option}, without);
      EXPECT_TRUE(succeeded(alone)) << option;
      EXPECT_EQ(alone.out, run(tool, {option}).out);
      EXPECT_EQ(run(MASU_MPIRUN, by(3, tool, {option})).out, alone.out);
    }
    EXPECT_TRUE(failed(run(tool + "-mpi", {"--no-such-option"}, without), 1, tool, "--no-such-option"));
  }
}

// A ray's way is one rank's work.
TEST_F(MpiRuns, AWayIsPrintedOnce) {
  const Arguments walk{scene_, grid_, "--pixel", "8,6"};
  EXPECT_EQ(run(MASU_MPIRUN, by(3, "gridtrace", walk)).out, run("gridtrace", walk).out);
}

#else

TEST(MpiRuns, AreTested) {
  GTEST_SKIP() << "built without MPI: gridrender-mpi and gridtrace-mpi aren't there";
}

#endif

} // namespace
} // namespace masu
