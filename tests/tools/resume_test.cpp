// --resume, gridrender-mpi and gridtrace-mpi: whoever shares a run, and however often it is killed, its files
// are those of one undisturbed process.
#include "libscene/file/container.h"
#include "renderer/image/jpeg_file.h"
#include "tests/stability/test_scene.h"
#include "tests/tools/run_tool.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>
#include <sys/stat.h>
#include <sys/wait.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <random>
#include <span>
#include <sstream>
#include <thread>

namespace masu {
namespace {

using Files = std::map<std::string, Bytes>; // by name

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
    Job job{on_cpu({"--turntable", "24", "--size", "90x70", "-o", file(prefix + "{index}.png"), "--hits",
                    file(prefix + "{index}.hits")}),
            {}};
    for (int i = 0; i < 24; ++i) {
      job.outputs.push_back(fmt::format("{}{:02}.png", prefix, i));
      job.outputs.push_back(fmt::format("{}{:02}.hits", prefix, i));
    }
    return job;
  }
  // A view of several bands: these have 1048 rows each.
  Job large(const std::string& prefix, const std::string& ending, const std::string& sampling) const {
    return {on_cpu({"--size", "1333x2100", "--sampling", sampling, "--depth", "1", "-o",
                    file(prefix + "." + ending), "--hits", file(prefix + ".hits")}),
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
      write_records(file("rays"), rays);
    }
    return {on_cpu({file("rays"), "-o", file(prefix + ending), "--write", "t,object,normal"}),
            {prefix + ending},
            "gridtrace"};
  }
  // A chunk and a part of one, as text, of lines of different lengths and blank ones.
  void write_csv_rays() const {
    if (std::filesystem::exists(file("rays.csv"))) return;
    std::string text = "ox,oy,oz,dx,dy,dz\n\n";
    for (std::size_t i = 0; i < (std::size_t{1} << 20) + 1000; ++i)
      text += fmt::format("{},{},3,0.125,{},-1\n{}", static_cast<double>(i % 1000) / 250 - 2,
                          static_cast<double>(i % 773) / 200 - 2, static_cast<double>(i % 7) / 64,
                          i % 100'000 == 0 ? "\n" : "");
    write_text(file("rays.csv"), text);
  }
  Job csv_list(const std::string& prefix) const {
    write_csv_rays();
    return {on_cpu({file("rays.csv"), "-o", file(prefix + ".csv")}), {prefix + ".csv"}, "gridtrace"};
  }
  std::vector<Job> all(const std::string& prefix) const {
    std::vector<Job> jobs{views(prefix + "v"),
                          large(prefix + "1", "png", "corners"),
                          large(prefix + "2", "pfm", "corners"),
                          large(prefix + "3", "png", "centers"),
                          list(prefix + "4", ".hits"),
                          list(prefix + "5", ".npy"),
                          csv_list(prefix + "6")};
    if (has_libjpeg()) jobs.push_back(large(prefix + "7", "jpg", "corners")); // of two bands
    return jobs;
  }

  void expect_made(const Job& job, const Arguments& more = {}) const {
    expect_run(job.tool, joined(job.arguments, more));
  }
  // The same files as of another job, and no others.
  void expect_same(const Job& job, const Job& expected) const {
    EXPECT_FALSE(job.outputs.empty());
    for (std::size_t i = 0; i < job.outputs.size(); ++i)
      EXPECT_TRUE(read_bytes(file(job.outputs[i])) == read_bytes(file(expected.outputs[i])))
          << job.outputs[i];
    for (const std::string& name : folder_.listing())
      EXPECT_TRUE(name.find(".partial") == std::string::npos && name.find(".journal") == std::string::npos &&
                  !name.starts_with(".masu-"))
          << name << " was left behind";
  }
  void remove(const Job& job) const {
    for (const std::string& name : job.outputs)
      std::filesystem::remove(file(name));
  }

  template <class SecondsOf, class Start, class Kill>
  void resume_killed(int runs, std::mt19937_64& random, const SecondsOf& seconds_of_job, const Start& begin,
                     const Kill& kill_it) const;

  // Of a run in the tests' folder, which ends in the middle: it can't write its files beyond so many bytes.
  ToolResult run_up_to(std::uint64_t bytes, const Job& job) const {
    const std::string command =
        fmt::format("cd '{}' && ulimit -f {} && exec \"$0\" \"$@\"", folder_.path().string(), bytes / 512);
    return run("/bin/sh", joined({"-c", command, std::string(MASU_BIN_DIR) + "/" + job.tool},
                                 joined(job.arguments, {"--resume", "-q", "--threads", "1"})));
  }
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

// Kills runs of each job in turn, so many in all; what they leave is resumed to the files of all("a").
template <class SecondsOf, class Start, class Kill>
void SharedRuns::resume_killed(int runs, std::mt19937_64& random, const SecondsOf& seconds_of_job,
                               const Start& begin, const Kill& kill_it) const {
  std::vector<double> seconds;
  for (const Job& job : all("b"))
    seconds.push_back(seconds_of_job(job));
  Killed killed;
  for (std::size_t round = 0; killed.runs < cases(runs); ++round) {
    const std::size_t i = round % seconds.size();
    const Job expected = all("a")[i], resumed = all("b")[i];
    remove(resumed);
    killed += run_until_whole(
        random, seconds[i], [&] { return begin(resumed); }, kill_it);
    expect_same(resumed, expected);
  }
  RecordProperty("killed", killed.runs);
  RecordProperty("hung", killed.hung);
  fmt::print("killed {} times, of which {} had to be killed as a whole\n", killed.runs, killed.hung);
}

TEST_F(SharedRuns, KilledAtAnyMomentARunIsResumedToTheSameBytes) {
  auto random = seed_.engine();
  for (const Job& job : all("a"))
    expect_made(job);
  resume_killed(
      10, random, [&](const Job& job) { return time_of(job.tool, job.arguments).count(); },
      [](const Job& job) {
        return start(job.tool, joined(job.arguments, {"--resume", "-q"}));
      },
      [](pid_t process) { kill(process, SIGKILL); });
}

// What is finished isn't done again: a finished view that is changed under its journal's hash is made again,
// an unchanged one stays the same file.
TEST_F(SharedRuns, FinishedViewsStayAndDamagedOnesAreMadeAgain) {
  const Job expected = views("a"), resumed = views("b");
  expect_made(expected);
  const double seconds = time_of(resumed.tool, resumed.arguments).count();
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
  expect_run("gridrender", arguments);
  EXPECT_EQ(inode(kept.at(0)), unchanged);
  expect_same(resumed, expected);
  // Counts are those of all views.
  expect_made(expected, {"--stats", file("a.json")});
  const auto a = json_in("a.json"), b = json_in("b.json");
  for (const char* const key : {"eye_rays", "eye_hits", "shadow_rays", "cells_visited", "intersection_tests"})
    EXPECT_EQ(a[key], b[key]) << key;
}

// --- Journals that aren't what was written -----------------------------------------------------------------

using Json = nlohmann::ordered_json;

// A journal's run and lines.
struct Journal {
  std::string run, first;
  std::vector<std::string> lines;

  explicit Journal(const std::string& path) {
    std::istringstream text(read_text(path));
    std::getline(text, first);
    run = Json::parse(first)["run"];
    for (std::string line; std::getline(text, line);)
      lines.push_back(line);
  }
  void write(const std::string& path) const {
    write_text(path, fmt::format("{}\n{}\n", first, fmt::join(lines, "\n")));
  }
  // Changes a line and, as whoever knows how would, its hash.
  template <class Change>
  void change(std::size_t i, const Change& change) {
    Json json = Json::parse(lines.at(i));
    json.erase("hash");
    change(json);
    const std::string content = run + json.dump();
    json["hash"] = to_hex(hash_of({reinterpret_cast<const std::uint8_t*>(content.data()), content.size()}));
    lines[i] = json.dump();
  }
};

// What a run that ended in the middle has left: to be made again and again.
class Interrupted {
public:
  Interrupted(const TemporaryFolder& folder, const std::vector<std::string>& before) {
    for (const std::string& name : folder.listing())
      if (std::ranges::count(before, name) == 0) files_[folder.file(name)] = read_bytes(folder.file(name));
  }
  void restore() const {
    for (const auto& [path, bytes] : files_)
      write_bytes(path, bytes);
  }

private:
  Files files_;
};

TEST_F(SharedRuns, WhateverAJournalSaysTheFilesAreTheSame) {
  auto random = seed_.engine();
  ASSERT_EQ(mkfifo(file("fifo").c_str(), 0600), 0);
  struct Case {
    Job expected, resumed;
    std::uint64_t bytes; // of two tasks of three
    std::vector<std::string> partial;
  };
  const Case kinds[] = {{large("a1", "png", "corners"),
                         large("b1", "png", "corners"),
                         22'370'000,
                         {"b1.png.partial", "b1.hits.partial"}},
                        {list("a2", ".npy"), list("b2", ".npy"), 42'000'000, {"b2.npy.partial"}}};
  for (const auto& [expected, resumed, bytes, partial] : kinds) {
    expect_made(expected);
    const auto before = folder_.listing();
    ASSERT_EQ(run_up_to(bytes, resumed).code, 3);
    const Interrupted interrupted(folder_, before);
    const std::string journal = file(resumed.outputs.front() + ".journal.0");
    const auto expect_survived = [&](const std::string& what, const auto& damage) {
      SCOPED_TRACE(what + ", " + resumed.outputs.front());
      remove(resumed);
      interrupted.restore();
      Journal changed(journal);
      ASSERT_EQ(changed.lines.size(), 2U);
      damage(changed);
      changed.write(journal);
      expect_made(resumed, {"--resume", "-q"});
      expect_same(resumed, expected);
    };
    const auto with_file = [&](const auto& change) {
      return [&](Journal& of) { of.change(1, [&](Json& line) { change(line["files"][0]); }); };
    };
    const auto last = std::numeric_limits<std::uint64_t>::max();
    expect_survived("nothing", [](Journal&) {});
    expect_survived("another task", [](Journal& of) { of.change(1, [](Json& line) { line["task"] = 2; }); });
    expect_survived("no files", [&](Journal& of) {
      of.change(1, [](Json& line) { line["files"] = Json::array(); });
      for (const std::string& name : partial)
        std::filesystem::remove(file(name));
    });
    expect_survived("a byte", [&](Journal& of) {
      std::string& line = of.lines[random() % 2];
      char& changed = line[random() % line.size()];
      changed = static_cast<char>(changed ^ static_cast<char>(1 + random() % 255));
    });
    expect_survived("an offset", with_file([&](Json& of) { of["offset"] = last - 100; }));
    expect_survived("a size", with_file([&](Json& of) { of["bytes"] = last / 4; }));
    expect_survived("offset and size", with_file([&](Json& of) {
                      of["offset"] = last - (std::uint64_t{1} << 62);
                      of["bytes"] = (std::uint64_t{1} << 62) + 5000;
                    }));
    expect_survived("a pipe", with_file([&](Json& of) { of["name"] = file("fifo"); }));
    expect_survived("a damaged part", [&](Journal&) {
      Bytes damaged = read_bytes(file(partial.front()));
      damaged.at(damaged.size() / 20) ^= 1;
      write_bytes(file(partial.front()), damaged);
    });
  }
}

TEST_F(SharedRuns, AJournalOfOtherOptionsIsIgnored) {
  const Job expected = large("a", "png", "corners"), resumed = large("b", "png", "corners");
  Job other = resumed;
  other.arguments.emplace_back("--srgb");
  expect_made(expected);
  ASSERT_EQ(run_up_to(21'000'000, other).code, 3);
  ASSERT_EQ(Journal(file("b.png.journal.0")).lines.size(), 1U);
  expect_made(resumed, {"--resume"});
  expect_same(resumed, expected);
}

// In the working folder.
TEST_F(SharedRuns, OutputsNamedWithoutAFolderAreResumedToo) {
  constexpr std::uint64_t everything = std::uint64_t{1} << 40;
  const std::pair<Job, Job> jobs[] = {{large("a", "png", "corners"), large("b", "png", "corners")},
                                      {list("a", ".npy"), list("b", ".npy")}};
  for (auto [expected, resumed] : jobs) {
    SCOPED_TRACE(resumed.outputs.front());
    for (const std::string& name : resumed.outputs)
      std::ranges::replace(resumed.arguments, file(name), name);
    expect_made(expected);
    ASSERT_EQ(run_up_to(21'000'000, resumed).code, 3);
    EXPECT_TRUE(succeeded(run_up_to(everything, resumed)));
    expect_same(resumed, expected);
  }
}

// What is finished isn't done again: the second run only adds to the journal of the first.
TEST_F(SharedRuns, FinishedBandsAndChunksStay) {
  const std::pair<Job, std::uint64_t> jobs[] = {
      {large("b1", "png", "corners"), 21'000'000},
      {list("b2", ".hits"), 21'000'000},
      {list("b3", ".npy"), 21'000'000},
      {list("b4", ".csv"), 150'000'000}}; // slots of text are larger
  for (const auto& [job, bytes] : jobs) {
    SCOPED_TRACE(job.outputs.front());
    const std::string path = file(job.outputs.front() + ".journal.0");
    ASSERT_EQ(run_up_to(bytes, job).code, 3);
    const Journal first(path);
    EXPECT_EQ(first.lines.size(), 1U);
    ASSERT_EQ(run_up_to(bytes, job).code, 3);
    EXPECT_EQ(Journal(path).lines, first.lines);
  }
}

// A partial file that was renamed, before the journal was removed: where it was damaged since, all of it is
// made again.
TEST_F(SharedRuns, AFileThatWasFinishedIsWholeOrMadeAgain) {
  const Job expected = list("a", ".hits"), resumed = list("b", ".hits");
  expect_made(expected);
  const Bytes whole = read_bytes(file("a.hits"));
  ASSERT_EQ(run_up_to(21'000'000, resumed).code, 3); // the first of three chunks
  const std::string path = file("b.hits.journal.0");
  Journal journal(path);
  ASSERT_EQ(journal.lines.size(), 1U);
  const std::size_t chunk_bytes = std::size_t{20} << 20;
  journal.lines.resize(3, journal.lines[0]);
  for (std::size_t i = 0; i < 3; ++i)
    journal.change(i, [&](Json& line) {
      const auto part = std::span(whole)
                            .subspan(i * chunk_bytes)
                            .first(std::min(chunk_bytes, whole.size() - i * chunk_bytes));
      line["task"] = i;
      line["files"][0]["offset"] = i * chunk_bytes;
      line["files"][0]["bytes"] = part.size();
      line["files"][0]["hash"] = to_hex(hash_of(part));
    });
  std::filesystem::remove(file("b.hits.partial"));
  for (const std::string damage : {"", "a byte", "longer", "shorter"}) {
    SCOPED_TRACE(damage);
    Bytes bytes = whole;
    if (damage == "a byte") bytes[chunk_bytes + 5] ^= 1;
    if (damage == "longer") bytes.push_back(0);
    if (damage == "shorter") bytes.pop_back();
    write_bytes(file("b.hits"), bytes);
    journal.write(path);
    expect_made(resumed, {"--resume", "-q"});
    expect_same(resumed, expected);
  }
}

TEST_F(SharedRuns, FilesOfOthersAreNeitherReplacedNorRemoved) {
  const Job picture = large("b", "png", "corners"), chunks = list("c", ".hits");
  const auto stays = [&](const std::string& name, const Job& job) {
    SCOPED_TRACE(name);
    write_text(file(name), "mine");
    const auto before = folder_.listing();
    EXPECT_TRUE(fails(3, job.tool, joined(job.arguments, {"--resume"}), file(name), "is in the way"));
    EXPECT_EQ(folder_.listing(), before);
    EXPECT_EQ(read_text(file(name)), "mine");
    std::filesystem::remove(file(name));
  };
  stays("b.png.journal.0", picture);
  stays("b.png.partial", picture);
  stays("b.hits.partial", picture);
  stays("c.hits.journal.0", chunks);
  stays("c.hits.partial", chunks);
  ASSERT_EQ(mkfifo(file("c.hits.journal.0").c_str(), 0600), 0);
  EXPECT_TRUE(fails(3, chunks.tool, joined(chunks.arguments, {"--resume"}), file("c.hits.journal.0"),
                    "is in the way"));
  EXPECT_TRUE(std::filesystem::remove(file("c.hits.journal.0")));
  // Of another rank, which this run hasn't.
  write_text(file("c.hits.journal.7"), "mine");
  expect_made(chunks, {"--resume"});
  EXPECT_EQ(read_text(file("c.hits.journal.7")), "mine");
}

TEST_F(SharedRuns, InputsAreNoPartialFilesNorJournals) {
  static_cast<void>(list("x", ".hits")); // writes the rays
  const auto is_spared = [&](const std::string& input, const std::string& name, Arguments arguments,
                             const std::string& tool = "gridrender") {
    SCOPED_TRACE(name);
    std::filesystem::copy_file(input, file(name));
    std::ranges::replace(arguments, input, file(name));
    arguments.insert(arguments.end(), {"--backend", "cpu", "--resume"});
    EXPECT_TRUE(fails(1, tool, arguments, file(name), "is the input"));
    EXPECT_TRUE(read_bytes(file(name)) == read_bytes(input));
    std::filesystem::remove(file(name));
  };
  write_text(file("views"), "{\"name\": \"a\"}\n{\"name\": \"b\"}\n");
  for (const std::string& input : {scene_, grid_}) {
    is_spared(input, "b.png.partial", {scene_, grid_, "-o", file("b.png")});
    is_spared(input, "b.png.journal.0", {scene_, grid_, "-o", file("b.png")});
    is_spared(input, "b.hits.partial", {scene_, grid_, file("rays"), "-o", file("b.hits")}, "gridtrace");
  }
  is_spared(file("rays"), "b.hits.partial", {scene_, grid_, file("rays"), "-o", file("b.hits")}, "gridtrace");
  is_spared(file("rays"), "b.hits.journal.0", {scene_, grid_, file("rays"), "-o", file("b.hits")},
            "gridtrace");
  is_spared(file("views"), "b.png.partial",
            {scene_, grid_, "--views", file("views"), "-o", file("{name}.png")});
  is_spared(file("views"), "a.png.journal.0",
            {scene_, grid_, "--views", file("views"), "-o", file("{name}.png")});
  // Nor outputs of one run each other's.
  const Arguments twice{scene_,        grid_,    "--backend",          "cpu", "--resume", "-o",
                        file("b.png"), "--hits", file("b.png.partial")};
  EXPECT_TRUE(fails(1, "gridrender", twice, file("b.png.partial"), "twice"));
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
    for (const int ranks : {1, 3}) {
      remove(shared);
      EXPECT_TRUE(succeeded(run(MASU_MPIRUN, by(ranks, shared, {"--stats", file("b.json")})))) << ranks;
      expect_same(shared, expected);
      const auto a = json_in("a.json"), b = json_in("b.json");
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
    expect_made(expected);
    // Its daemons, who share a machine after all, may warn of each other.
    const ToolResult result =
        run(MASU_MPIRUN,
            joined({"--mca", "plm_rsh_agent", shell, "--host", "machine1:2,machine2:1"}, by(3, shared)));
    EXPECT_EQ(result.code, 0) << result.err;
    expect_same(shared, expected);
  }
  const auto refused =
      run(MASU_MPIRUN,
          joined({"--mca", "plm_rsh_agent", shell, "--host", "machine1:1,machine2:1"},
                 by(2, "gridrender", {scene_, file("missing"), "-o", file("a.png"), "--backend", "cpu"})));
  EXPECT_EQ(refused.code, 2) << refused.err;
}

// One rank, or all and mpirun.
TEST_F(MpiRuns, KilledRanksAreResumedToTheSameBytes) {
  auto random = seed_.engine();
  for (const Job& job : all("a"))
    expect_made(job);
  resume_killed(
      6, random, [&](const Job& job) { return time_of(MASU_MPIRUN, by(2, job)).count(); },
      [&](const Job& job) {
        const int ranks = 1 + static_cast<int>(random() % 3);
        return start(MASU_MPIRUN, by(ranks, job, {"--resume", "-q"}));
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
    const ToolResult result = run(MASU_MPIRUN, by(3, "gridrender", arguments));
    EXPECT_EQ(result.code, code) << result.err;
    const auto lines = lines_of_tool(result.err);
    ASSERT_EQ(lines.size(), 1U) << result.err;
    EXPECT_TRUE(lines[0].starts_with("gridrender: " + place)) << lines[0];
    // Before what mpirun says: Open MPI 5 ends that with a zero byte.
    EXPECT_LT(result.err.find(lines[0]), result.err.find("MPI_ABORT"));
  };
  refused(1, {scene_, "--no-such-option"}, "--no-such-option");
  refused(2, {scene_, file("missing"), "-o", file("a.png"), "--backend", "cpu"}, file("missing"));
  refused(3, {scene_, grid_, "-o", file("missing/a.png"), "--backend", "cpu"}, file("missing/a.png"));
  refused(1, {scene_, grid_, "-o", "-", "--backend", "cpu"}, "-");
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
