// A temporary folder for a test, removed with its contents at the end; reading and writing of whole files.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace masu {

using Bytes = std::vector<std::uint8_t>;

class TemporaryFolder {
public:
  TemporaryFolder() {
    std::string name = (parent() / "masu-test-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder can be made");
    path_ = name;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::string file(std::string_view name) const { return (path_ / name).string(); }

  // The names of its entries, sorted.
  std::vector<std::string> listing() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(path_))
      names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
  }

private:
  // /dev/shm if it has room and TMPDIR isn't set: flushing many small files to a disk would take most of the
  // tests' time.
  static std::filesystem::path parent() {
    std::error_code failed;
    const std::filesystem::path memory = "/dev/shm";
    const bool has_room = std::filesystem::space(memory, failed).available >= std::uintmax_t{1} << 30;
    if (std::getenv("TMPDIR") == nullptr && !failed && has_room && access(memory.c_str(), W_OK) == 0)
      return memory;
    return std::filesystem::temp_directory_path();
  }

  std::filesystem::path path_;
};

inline Bytes read_bytes(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  EXPECT_TRUE(file.good()) << path << " can't be read";
  return {std::istreambuf_iterator<char>(file), {}};
}
inline std::string read_text(const std::string& path) {
  const Bytes bytes = read_bytes(path);
  return {bytes.begin(), bytes.end()};
}

inline void write_bytes(const std::string& path, std::span<const std::uint8_t> bytes) {
  std::ofstream file(path, std::ios::binary);
  file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  ASSERT_TRUE(file.good()) << path << " can't be written";
}
inline void write_text(const std::string& path, std::string_view text) {
  write_bytes(path, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

// Records, such as rays' numbers and hits, as they are in memory.
template <class Record>
std::vector<Record> read_records(const std::string& path) {
  const Bytes bytes = read_bytes(path);
  EXPECT_EQ(bytes.size() % sizeof(Record), 0U) << path;
  std::vector<Record> records(bytes.size() / sizeof(Record));
  if (!records.empty()) std::memcpy(records.data(), bytes.data(), records.size() * sizeof(Record));
  return records;
}
template <class Record>
void write_records(const std::string& path, const std::vector<Record>& records) {
  write_bytes(path, {reinterpret_cast<const std::uint8_t*>(records.data()), records.size() * sizeof(Record)});
}

} // namespace masu
