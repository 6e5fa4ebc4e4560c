// A file appears whole or not at all.
#include "libscene/file/output_file.h"

#include "tests/memory_file.h"
#include "tests/refused.h"
#include "tests/temporary_folder.h"

#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <functional>
#include <thread>

namespace masu {
namespace {

void put(OutputFile& file, std::string_view text) {
  file.write(text.data(), text.size());
}

void write_whole(const std::string& path, std::string_view text,
                 UntilCommit until_commit = UntilCommit::unnamed) {
  OutputFile file(path, until_commit);
  put(file, text);
  file.commit();
}

// Whether `act` throws Error(output, path).
testing::AssertionResult fails_as_output(const std::string& path, const std::function<void()>& act) {
  return is_refused_with(ErrorCode::output, path, act);
}

// Runs act in a child process, which it must end by that signal.
void expect_ended_by(int signal, const std::function<void()>& act) {
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    act();
    _exit(0);
  }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == signal) << status;
}

class OutputFiles : public testing::Test {
protected:
  const TemporaryFolder folder_;
  const std::string path_ = folder_.file("a");
};

TEST_F(OutputFiles, CommitLeavesOneFile) {
  for (const std::string text : {"something much longer than the new text", "new", ""}) {
    write_whole(path_, text);
    EXPECT_EQ(read_text(path_), text);
    EXPECT_EQ(folder_.listing(), std::vector<std::string>{"a"});
  }
}

TEST(OutputFile, WithoutCommitAllIsAsBefore) {
  const std::string text(1'000'000, 'x');
  for (const bool exists : {false, true}) {
    for (const bool is_killed : {false, true}) {
      const TemporaryFolder folder;
      const std::string path = folder.file("a");
      if (exists) write_text(path, "old");
      const auto before = folder.listing();
      const auto write = [&] {
        OutputFile file(path);
        put(file, text);
        EXPECT_EQ(folder.listing(), before);
        if (is_killed) std::raise(SIGKILL);
      };
      is_killed ? expect_ended_by(SIGKILL, write) : write();
      EXPECT_EQ(folder.listing(), before);
      if (exists) {
        EXPECT_EQ(read_text(path), "old");
      }
    }
  }
}

TEST_F(OutputFiles, OpenReadersKeepTheOldFile) {
  write_text(path_, "old");
  std::ifstream reader(path_, std::ios::binary);
  write_whole(path_, "new");
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(reader), {}), "old");
}

TEST_F(OutputFiles, ImpossiblePathIsAnOutputError) {
  const std::string nowhere = folder_.file("no/such/folder/a"), directory = folder_.path().string(),
                    below_a_file = folder_.file("file/a"), too_long = folder_.file(std::string(5000, 'a'));
  write_text(folder_.file("file"), "");
  for (const std::string& path : {nowhere, directory, below_a_file, too_long})
    EXPECT_TRUE(fails_as_output(path, [&] { write_whole(path, "text"); })) << path;
  EXPECT_TRUE(fails_as_output("output", [] { const OutputFile file(""); }));
  EXPECT_EQ(folder_.listing(), std::vector<std::string>{"file"});
}

// In a child process without root's privileges.
int code_without_privileges(const std::string& path) {
  const pid_t child = fork();
  if (child == 0) {
    if (getuid() == 0 && setuid(65534) != 0) _exit(99);
    try {
      write_whole(path, "new");
      _exit(0);
    } catch (const Error& error) {
      _exit(static_cast<int>(error.code()));
    }
  }
  int status = 0;
  if (child < 0 || waitpid(child, &status, 0) != child || !WIFEXITED(status)) return -1;
  return WEXITSTATUS(status);
}

TEST_F(OutputFiles, MissingPermissionIsAnOutputError) {
  namespace fs = std::filesystem;
  fs::permissions(folder_.path(), fs::perms(0755)); // the child process must be able to enter it
  fs::create_directory(folder_.file("closed"));
  fs::permissions(folder_.file("closed"), fs::perms(0555));
  EXPECT_EQ(code_without_privileges(folder_.file("closed/a")), 3);
  fs::create_directory(folder_.file("open"));
  fs::permissions(folder_.file("open"), fs::perms(0777));
  EXPECT_EQ(code_without_privileges(folder_.file("open/a")), 0);
  write_text(folder_.file("open/protected"), "old");
  fs::permissions(folder_.file("open/protected"), fs::perms(0444));
  EXPECT_EQ(code_without_privileges(folder_.file("open/protected")), 3);
  EXPECT_EQ(read_text(folder_.file("open/protected")), "old");
}

TEST(OutputFile, DevicesAreWrittenDirectly) {
  EXPECT_NO_THROW(write_whole("/dev/null", "gone"));
  struct stat status {};
  ASSERT_EQ(stat("/dev/null", &status), 0);
  EXPECT_TRUE(S_ISCHR(status.st_mode));
}

TEST(OutputFile, FullDeviceIsAnOutputError) {
  EXPECT_TRUE(fails_as_output("/dev/full", [] { write_whole("/dev/full", "some text"); }));
  EXPECT_TRUE(fails_as_output("/dev/full", [] { write_whole("/dev/full", std::string(1 << 20, 'x')); }));
}

TEST_F(OutputFiles, PipesAreWrittenDirectly) {
  const std::string path = folder_.file("pipe");
  ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
  std::string got;
  std::thread reader([&] { got = read_text(path); });
  write_whole(path, "through the pipe");
  reader.join();
  EXPECT_EQ(got, "through the pipe");
  EXPECT_TRUE(std::filesystem::is_fifo(path));
}

TEST_F(OutputFiles, LinksAreFollowedToAFileThatIsThereOrNot) {
  std::filesystem::create_directory(folder_.file("elsewhere"));
  std::filesystem::create_symlink("elsewhere/target", folder_.file("inner"));
  std::filesystem::create_symlink(folder_.file("inner"), folder_.file("outer"));
  for (const char* const text : {"old", "new"}) {
    write_whole(folder_.file("outer"), text);
    EXPECT_TRUE(std::filesystem::is_symlink(folder_.file("outer")));
    EXPECT_TRUE(std::filesystem::is_symlink(folder_.file("inner")));
    EXPECT_EQ(read_text(folder_.file("elsewhere/target")), text);
  }
}

TEST_F(OutputFiles, CycleOfLinksIsAnOutputError) {
  std::filesystem::create_symlink("b", path_);
  std::filesystem::create_symlink("a", folder_.file("b"));
  EXPECT_TRUE(fails_as_output(path_, [&] { write_whole(path_, "new"); }));
}

TEST_F(OutputFiles, LongestNamesCanBeWritten) {
  for (const std::size_t length : {252U, 255U}) {
    for (const UntilCommit until_commit : {UntilCommit::unnamed, UntilCommit::named}) {
      const std::string path = folder_.file(std::string(length, 'a'));
      write_whole(path, "old", until_commit);
      write_whole(path, "new", until_commit);
      EXPECT_EQ(read_text(path), "new");
      std::filesystem::remove(path);
    }
  }
  EXPECT_TRUE(fails_as_output(folder_.file(std::string(256, 'a')),
                              [&] { const OutputFile file(folder_.file(std::string(256, 'a'))); }));
  EXPECT_TRUE(folder_.listing().empty());
}

TEST_F(OutputFiles, ReplacingKeepsPermissions) {
  for (const UntilCommit until_commit : {UntilCommit::unnamed, UntilCommit::named}) {
    for (const unsigned mode : {0600U, 0755U, 0666U, 0640U}) {
      write_text(path_, "old");
      std::filesystem::permissions(path_, std::filesystem::perms(mode));
      write_whole(path_, "new", until_commit);
      EXPECT_EQ(std::filesystem::status(path_).permissions(), std::filesystem::perms(mode));
    }
  }
}

TEST(OutputFile, ConcurrentWritersOfOneFileAreIndependent) {
  const TemporaryFolder folder;
  for (const UntilCommit until_commit : {UntilCommit::unnamed, UntilCommit::named}) {
    OutputFile first(folder.file("a"), until_commit), second(folder.file("a"), until_commit);
    put(first, "first");
    put(second, "second");
    first.commit();
    EXPECT_EQ(read_text(folder.file("a")), "first");
    second.commit();
    EXPECT_EQ(read_text(folder.file("a")), "second");
    EXPECT_EQ(folder.listing(), std::vector<std::string>{"a"});
  }
}

// Temporary names are predictable: anyone with write permission for the folder can create them first.
std::string first_temporary_name(const TemporaryFolder& folder, const std::string& name) {
  const OutputFile file(folder.file(name), UntilCommit::named);
  for (const std::string& there : folder.listing()) {
    if (there.starts_with(".masu-")) return folder.file(there);
  }
  return {};
}

TEST(OutputFile, PlantedLinkIsNotFollowed) {
  const TemporaryFolder folder;
  const std::string planted = first_temporary_name(folder, "a");
  ASSERT_FALSE(planted.empty());
  write_text(folder.file("victim"), "precious");
  std::filesystem::create_symlink("victim", planted);
  for (const UntilCommit until_commit : {UntilCommit::unnamed, UntilCommit::named}) {
    write_text(folder.file("a"), "old");
    write_whole(folder.file("a"), "new", until_commit);
    EXPECT_EQ(read_text(folder.file("a")), "new");
    EXPECT_EQ(read_text(folder.file("victim")), "precious");
    EXPECT_TRUE(std::filesystem::is_symlink(planted));
  }
}

TEST_F(OutputFiles, SignalsRemoveTemporaryNames) {
  write_text(path_, "old");
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    expect_ended_by(signal, [&] {
      remove_temporary_names_on_signals();
      OutputFile replacing(path_, UntilCommit::named), creating(folder_.file("b"), UntilCommit::named);
      put(replacing, std::string(100000, 'x'));
      std::raise(signal);
    });
    EXPECT_EQ(folder_.listing(), std::vector<std::string>{"a"});
    EXPECT_EQ(read_text(path_), "old");
  }
}

TEST_F(OutputFiles, NextWriterRemovesTheStaleFileOfAKilledProcess) {
  for (const UntilCommit until_commit : {UntilCommit::unnamed, UntilCommit::named}) {
    expect_ended_by(SIGKILL, [&] {
      OutputFile file(path_, UntilCommit::named);
      put(file, std::string(100000, 'x'));
      std::raise(SIGKILL);
    });
    EXPECT_FALSE(std::filesystem::exists(path_));
    write_text(path_, "old");
    EXPECT_EQ(folder_.listing().size(), 2U); // with the stale one
    write_whole(path_, "new", until_commit);
    EXPECT_EQ(read_text(path_), "new");
    EXPECT_EQ(folder_.listing(), std::vector<std::string>{"a"});
    std::filesystem::remove(path_);
  }
}

TEST_F(OutputFiles, TemporaryFileOfARunningProcessIsKept) {
  OutputFile other(path_, UntilCommit::named);
  put(other, "other");
  expect_ended_by(SIGKILL, [&] { // in another process, since locks belong to processes
    write_whole(path_, "mine", UntilCommit::named);
    std::raise(SIGKILL);
  });
  EXPECT_EQ(read_text(path_), "mine");
  other.commit();
  EXPECT_EQ(read_text(path_), "other");
}

TEST(OutputFile, UnnamedFilesAreWrittenDirectly) {
  const MemoryFile file;
  write_whole(file.path(), "something long");
  write_whole(file.path(), "new");
  EXPECT_EQ(read_text(file.path()), "new");
}

TEST_F(OutputFiles, NewFilesHaveDefaultPermissions) {
  const mode_t mask = umask(0027);
  write_whole(path_, "new");
  umask(mask);
  EXPECT_EQ(std::filesystem::status(path_).permissions(), std::filesystem::perms(0640));
}

TEST(SameFile, IsRecognisedByAnyNameAndSpelling) {
  const TemporaryFolder folder;
  namespace fs = std::filesystem;
  fs::create_directory(folder.file("in"));
  write_text(folder.file("a"), "");
  write_text(folder.file("b"), "");
  fs::create_symlink("a", folder.file("link"));
  fs::create_hard_link(folder.file("a"), folder.file("hard"));
  fs::create_symlink("new", folder.file("dangling"));
  fs::create_directory_symlink("in", folder.file("also_in"));
  for (const char* const name : {"a", "link", "hard", "./a", "in/../a", "also_in/../a"})
    EXPECT_TRUE(is_same_file(folder.file("a"), folder.file(name))) << name;
  for (const char* const name : {"new", "dangling", "in/../new"})
    EXPECT_TRUE(is_same_file(folder.file("new"), folder.file(name))) << name;
  EXPECT_TRUE(is_same_file(folder.file("in/x"), folder.file("also_in/x")));
  for (const char* const name : {"b", "new", "dangling", "in", "in/a", "none/a"})
    EXPECT_FALSE(is_same_file(folder.file("a"), folder.file(name))) << name;
  EXPECT_FALSE(is_same_file(folder.file("in/new"), folder.file("new")));
  EXPECT_FALSE(is_same_file("/dev/null", "/dev/null"));
}

} // namespace
} // namespace masu
