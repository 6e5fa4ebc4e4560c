// A file appears whole or not at all.
#include "libscene/output_file.h"

#include "libscene/error.h"
#include "tests/temporary_folder.h"

#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstring>
#include <functional>
#include <thread>

namespace masu {
namespace {

void put(OutputFile& file, std::string_view text) {
  file.write(text.data(), text.size());
}

void write_whole(const std::string& path, std::string_view text) {
  OutputFile file(path);
  put(file, text);
  file.commit();
}

// Whether `act` throws Error(output) that names `path`.
testing::AssertionResult fails_as_output(const std::string& path, const std::function<void()>& act) {
  try {
    act();
  } catch (const Error& error) {
    if (error.code() == ErrorCode::output && error.place() == path && !error.message().empty())
      return testing::AssertionSuccess();
    return testing::AssertionFailure() << "another error: " << error.what();
  }
  return testing::AssertionFailure() << "nothing was thrown";
}

TEST(OutputFile, CommittedIsAllThatIsThere) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a");
  write_whole(path, "new");
  EXPECT_EQ(read_text(path), "new");
  EXPECT_EQ(folder.listing(), std::vector<std::string>{"a"});
}

TEST(OutputFile, CommittedReplacesTheOldOne) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a");
  write_text(path, "something much longer than the new text");
  write_whole(path, "new");
  EXPECT_EQ(read_text(path), "new");
  EXPECT_EQ(folder.listing(), std::vector<std::string>{"a"});
}

TEST(OutputFile, EmptyIsAFileToo) {
  const TemporaryFolder folder;
  write_whole(folder.file("a"), "");
  EXPECT_EQ(read_text(folder.file("a")), "");
}

TEST(OutputFile, WithoutCommitNothingIsLeft) {
  const TemporaryFolder folder;
  {
    OutputFile file(folder.file("a"));
    put(file, "half");
  }
  EXPECT_TRUE(folder.listing().empty());
}

TEST(OutputFile, WithoutCommitTheOldFileStays) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a");
  write_text(path, "old");
  {
    OutputFile file(path);
    put(file, std::string(100000, 'x'));
    EXPECT_EQ(read_text(path), "old");
  }
  EXPECT_EQ(read_text(path), "old");
  EXPECT_EQ(folder.listing(), std::vector<std::string>{"a"});
}

TEST(OutputFile, ReadersOfTheOldFileKeepIt) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a");
  write_text(path, "old");
  std::ifstream reader(path, std::ios::binary);
  write_whole(path, "new");
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(reader), {}), "old");
}

TEST(OutputFile, KilledHalfWayTheOldFileStays) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a");
  write_text(path, "old");
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    OutputFile file(path);
    put(file, std::string(1000000, 'x'));
    std::raise(SIGKILL);
    _exit(0);
  }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL);
  EXPECT_EQ(read_text(path), "old");
}

TEST(OutputFile, KilledHalfWayNoNewFileAppears) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a");
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    OutputFile file(path);
    put(file, std::string(1000000, 'x'));
    std::raise(SIGKILL);
    _exit(0);
  }
  ASSERT_EQ(waitpid(child, nullptr, 0), child);
  EXPECT_FALSE(std::filesystem::exists(path));
  EXPECT_NO_THROW(write_whole(path, "new")); // what the killed one left is in nobody's way
  EXPECT_EQ(read_text(path), "new");
}

TEST(OutputFile, WhereNoFileCanBeIsAnOutputError) {
  const TemporaryFolder folder;
  const std::string nowhere = folder.file("no/such/folder/a"), directory = folder.path().string(),
                    below_a_file = folder.file("file/a"), too_long = folder.file(std::string(5000, 'a'));
  write_text(folder.file("file"), "");
  for (const std::string& path : {nowhere, directory, below_a_file, too_long})
    EXPECT_TRUE(fails_as_output(path, [&] { write_whole(path, "text"); })) << path;
  EXPECT_TRUE(fails_as_output("output", [] { const OutputFile file(""); }));
  EXPECT_EQ(folder.listing(), std::vector<std::string>{"file"});
}

// In a process of its own, which may not do what root may.
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

TEST(OutputFile, WithoutPermissionIsAnOutputError) {
  const TemporaryFolder folder;
  namespace fs = std::filesystem;
  fs::permissions(folder.path(), fs::perms(0755)); // others must reach what is inside
  fs::create_directory(folder.file("closed"));
  fs::permissions(folder.file("closed"), fs::perms(0555));
  EXPECT_EQ(code_without_privileges(folder.file("closed/a")), 3);
  fs::create_directory(folder.file("open"));
  fs::permissions(folder.file("open"), fs::perms(0777));
  EXPECT_EQ(code_without_privileges(folder.file("open/a")), 0);
  write_text(folder.file("open/protected"), "old");
  fs::permissions(folder.file("open/protected"), fs::perms(0444));
  EXPECT_EQ(code_without_privileges(folder.file("open/protected")), 3);
  EXPECT_EQ(read_text(folder.file("open/protected")), "old");
}

TEST(OutputFile, DevicesAreWrittenDirectly) {
  EXPECT_NO_THROW(write_whole("/dev/null", "gone"));
  struct stat status {};
  ASSERT_EQ(stat("/dev/null", &status), 0);
  EXPECT_TRUE(S_ISCHR(status.st_mode));
}

TEST(OutputFile, AFullDeviceIsAnOutputError) {
  EXPECT_TRUE(fails_as_output("/dev/full", [] { write_whole("/dev/full", "some text"); }));
  EXPECT_TRUE(fails_as_output("/dev/full", [] { write_whole("/dev/full", std::string(1 << 20, 'x')); }));
}

TEST(OutputFile, PipesAreWrittenDirectly) {
  const TemporaryFolder folder;
  const std::string path = folder.file("pipe");
  ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
  std::string got;
  std::thread reader([&] { got = read_text(path); });
  write_whole(path, "through the pipe");
  reader.join();
  EXPECT_EQ(got, "through the pipe");
  EXPECT_TRUE(std::filesystem::is_fifo(path));
}

TEST(OutputFile, ASymbolicLinkStaysAndItsTargetIsReplaced) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.file("elsewhere"));
  write_text(folder.file("elsewhere/target"), "old");
  std::filesystem::create_symlink(folder.file("elsewhere/target"), folder.file("link"));
  write_whole(folder.file("link"), "new");
  EXPECT_TRUE(std::filesystem::is_symlink(folder.file("link")));
  EXPECT_EQ(read_text(folder.file("elsewhere/target")), "new");
}

TEST(OutputFile, NewFilesHaveTheUsualPermissions) {
  const TemporaryFolder folder;
  const mode_t mask = umask(0027);
  write_whole(folder.file("a"), "new");
  umask(mask);
  EXPECT_EQ(std::filesystem::status(folder.file("a")).permissions(), std::filesystem::perms(0640));
}

} // namespace
} // namespace masu
