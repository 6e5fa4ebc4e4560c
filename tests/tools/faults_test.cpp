// Whatever system call or allocation of a tool fails: its output is the old one or the new one, there is one
// line and the right exit code, and no other file is left. What a power failure would leave is whole, too.
#include "tests/tools/failing_calls.h"

#include <set>
#include <sstream>

namespace masu {
namespace {

struct Call {
  const char* name; // as tests/faults/faults.cpp has it
  std::set<int> codes;
};
const Call calls[] = {
    {"write", {3}},      {"fsync", {3}},   {"rename", {0, 3}}, {"link", {0, 3}},
    {"open", {0, 2, 3}}, {"read", {0, 2}}, {"mmap", {0, 2}},   {"malloc", {0, 2, 3}},
};

class Faults : public FailingCalls {
protected:
  ToolResult run_failing(const std::string& fault, const std::string& tool,
                         const Arguments& arguments) const {
    return run_with({std::string("LD_PRELOAD=") + MASU_FAULTS, "MASU_FAULT=" + fault,
                     "MASU_FAULT_COUNT=" + counts_.file("count"), "MASU_FAULT_LOG=" + counts_.file("log")},
                    tool, arguments);
  }

  // Each call alone, or so many at random; and for system calls all from one on.
  void expect_survived(std::string_view command, std::string_view written) {
    Arguments arguments = words(command);
    const std::string tool = arguments.front();
    arguments.erase(arguments.begin());
    SCOPED_TRACE(tool);
    ASSERT_EQ(run(tool, arguments).code, 0);
    const Outputs outputs = outputs_of(words(written));
    for (const Call& call : calls) {
      const ToolResult good = run_failing(call.name, tool, arguments);
      EXPECT_EQ(good.code, 0) << good.err;
      const std::uint64_t all = counted();
      for (const std::uint64_t n : some_of(all, cases(20))) {
        for (const char* const more : {"", "+"}) {
          // Without any memory the C library's own dlopen faults, which TBB calls.
          if (*more == '+' && std::string_view(call.name) == "malloc") continue;
          outputs.write_old();
          const std::string fault = std::string(call.name) + ":" + std::to_string(n) + more;
          const ToolResult result = run_failing(fault, tool, arguments);
          SCOPED_TRACE(described(fault, all, result));
          EXPECT_TRUE(call.codes.contains(result.code));
          // The line may be what can't be written.
          const bool is_silent = *more == '+' && std::string_view(call.name) == "write";
          EXPECT_EQ(std::ranges::count(result.err, '\n'), result.code == 0 || is_silent ? 0 : 1);
          expect_old_or_new(outputs, result);
        }
      }
    }
  }
};

TEST_F(Faults, Nffgen) {
  expect_survived("nffgen tetra --size 2 -o ~/out -q", "~/out");
}

TEST_F(Faults, Nff2bin) {
  expect_survived("nff2bin ~/a.nff -o ~/out", "~/out");
}

TEST_F(Faults, Gridbuild) {
  expect_survived("gridbuild ~/a.scene -o ~/out -q", "~/out");
}

TEST_F(Faults, Gridstat) {
  expect_survived("gridstat ~/a.grid --slice z=0 -o ~/out.png", "~/out.png");
}

TEST_F(Faults, GridrenderOfPictures) {
  expect_survived("gridrender ~/a.scene ~/a.grid -o ~/out.png --hits ~/hits -q --backend cpu",
                  "~/out.png ~/hits");
}

TEST_F(Faults, GridrenderOfViews) {
  write_text(file("views"), "{\"name\": \"a\"}\n{\"name\": \"b\", \"angle\": 30}\n");
  expect_survived("gridrender ~/a.scene ~/a.grid --views ~/views -o ~/{name}.pfm -q --backend cpu",
                  "~/a.pfm ~/b.pfm");
}

TEST_F(Faults, GridtraceOfRays) {
  write_records(file("rays"), std::vector<float>{0, 0, 5, 0, 0, -1, 1, 1, 5, 0, 0, -1});
  expect_survived("gridtrace ~/a.scene ~/a.grid ~/rays -o ~/hits -q --backend cpu", "~/hits");
}

// A file may get its name only once everything in it is flushed, and its folder is flushed after that: then
// whatever part of the unflushed writes and names a power failure keeps, the name is of the old file or of
// all of the new one.
TEST_F(Faults, APowerFailureLeavesTheOldOrTheNewFile) {
  const auto expect_ordered = [&](const std::string& tool, const Arguments& arguments) {
    SCOPED_TRACE(tool);
    ASSERT_EQ(run_failing("all", tool, arguments).code, 0);
    std::set<std::string> unflushed; // descriptors
    std::string call, descriptor, flushed;
    std::size_t whole = 0;  // files that have been written and flushed, and have no name yet
    std::size_t linked = 0; // those that have one: a rename may replace it
    std::istringstream log(read_text(counts_.file("log")));
    while (log >> call >> descriptor) {
      if (call == "write" && descriptor != "1" && descriptor != "2") unflushed.insert(descriptor);
      if (call == "fsync") whole += unflushed.erase(flushed = descriptor);
      if (call == "link" || call == "rename") {
        flushed.clear();
        if (call == "rename" && linked > 0) continue;
        ASSERT_GT(whole, 0U) << "a file that isn't flushed gets its name";
        --whole;
        ++linked;
      }
    }
    EXPECT_GE(linked, 1U);
    EXPECT_TRUE(unflushed.empty());
    EXPECT_FALSE(flushed.empty()) << "the folder isn't flushed after the name was given";
  };
  for (int existing = 0; existing < 2; ++existing) { // linked to its name, then renamed
    expect_ordered("nff2bin", {text_, "-o", file("out.scene")});
    expect_ordered("gridbuild", {scene_, "-o", file("out.grid"), "-q"});
    expect_ordered("gridrender", {scene_, grid_, "-o", file("out.png"), "-q", "--backend", "cpu"});
    expect_ordered("gridrender", {scene_, grid_, "-o", file("out.pfm"), "--hits", file("hits.npy"), "-q",
                                  "--backend", "cpu"});
  }
}

} // namespace
} // namespace masu
