// Memory limits, read from files made up for the purpose.
#include "libscene/base/available_memory.h"

#include "tests/temporary_folder.h"

#include <limits>

namespace masu {
namespace {

class AvailableMemory : public testing::Test {
protected:
  void write(const std::string& path, const std::string& text) {
    const std::filesystem::path file = folder_.path() / path;
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file) << text;
  }
  double available() const { return available_memory(folder_.path().string()); }
  void SetUp() override { write("proc/meminfo", "MemTotal: 9000 kB\nMemAvailable:    8000 kB\n"); }

  TemporaryFolder folder_;
};

TEST_F(AvailableMemory, IsTheMachinesWithoutControlGroups) {
  EXPECT_EQ(available(), 8000.0 * 1024);
}

TEST_F(AvailableMemory, IsUnlimitedWhereNothingIsKnown) {
  EXPECT_EQ(available_memory(folder_.file("none")), std::numeric_limits<double>::infinity());
}

TEST_F(AvailableMemory, IsWhatTheTightestGroupOfThePathLeaves) {
  write("proc/self/cgroup", "0::/jobs/one\n");
  write("sys/fs/cgroup/jobs/one/memory.max", "max\n");
  write("sys/fs/cgroup/jobs/one/memory.current", "5000\n");
  EXPECT_EQ(available(), 8000.0 * 1024);
  write("sys/fs/cgroup/jobs/memory.max", "1000000\n");
  write("sys/fs/cgroup/jobs/memory.current", "400000\n");
  EXPECT_EQ(available(), 600000);
  write("sys/fs/cgroup/jobs/one/memory.max", "7000\n");
  EXPECT_EQ(available(), 2000);
  write("sys/fs/cgroup/jobs/one/memory.current", "9000\n");
  EXPECT_EQ(available(), 0);
}

TEST_F(AvailableMemory, CountsTheFileCacheAsAvailable) {
  write("proc/self/cgroup", "0::/\n");
  write("sys/fs/cgroup/memory.max", "10000\n");
  write("sys/fs/cgroup/memory.current", "9000\n");
  write("sys/fs/cgroup/memory.stat", "anon 3000\nfile 6000\ninactive_file 4000\nactive_file 1500\n");
  EXPECT_EQ(available(), 6500);
}

TEST_F(AvailableMemory, KnowsGroupsOfVersion1AndPathsFromOutsideAContainer) {
  write("proc/self/cgroup", "5:cpu,cpuacct:/docker/c\n4:hugetlb,memory:/docker/c\n0::/docker/c\n");
  write("sys/fs/cgroup/memory/memory.limit_in_bytes", "9000\n");
  write("sys/fs/cgroup/memory/memory.usage_in_bytes", "4000\n");
  write("sys/fs/cgroup/memory/memory.stat", "inactive_file 0\ntotal_inactive_file 1000\n");
  EXPECT_EQ(available(), 6000);
}

} // namespace
} // namespace masu
