// Tools of which calls are made to fail: whatever fails, each output is the old one or the new one, and no
// other file is left.
#pragma once

#include "stability/test_scene.h"
#include "tests/tools/run_tool.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace masu {

class FailingCalls : public SmallSceneTest {
protected:
  // Runs the tool with these variables of its environment, NAME=value, for two minutes at most.
  static ToolResult run_with(Arguments variables, const std::string& tool, const Arguments& arguments) {
    variables.push_back(std::string(MASU_BIN_DIR) + "/" + tool);
    return run("/usr/bin/timeout", joined(joined({"120", "/usr/bin/env"}, variables), arguments));
  }
  std::uint64_t counted() const { return std::stoull(read_text(counts_.file("count"))); }

  // 1 to `all`, or so many of them at random: the first one always, which may come before anything is caught.
  std::vector<std::uint64_t> some_of(std::uint64_t all, std::int64_t most) {
    std::vector<std::uint64_t> some(all);
    std::iota(some.begin(), some.end(), std::uint64_t{1});
    if (all > 0) std::shuffle(some.begin() + 1, some.end(), random_);
    some.resize(std::min<std::size_t>(some.size(), static_cast<std::size_t>(most)));
    return some;
  }

  // What a tool writes when nothing fails.
  struct Outputs {
    std::map<std::string, Bytes> complete;
    std::vector<std::string> listing; // of the folder

    void write_old() const {
      for (const auto& [output, bytes] : complete)
        write_text(output, "old");
    }
  };
  Outputs outputs_of(const std::vector<std::string>& outputs) const {
    Outputs all{{}, folder_.listing()};
    for (const std::string& output : outputs)
      all.complete[output] = read_bytes(output);
    return all;
  }
  void expect_old_or_new(const Outputs& outputs, const ToolResult& result) const {
    EXPECT_EQ(folder_.listing(), outputs.listing);
    for (const auto& [output, complete] : outputs.complete) {
      const Bytes bytes = read_bytes(output);
      EXPECT_TRUE(bytes == complete || (result.code != 0 && bytes == Bytes{'o', 'l', 'd'}))
          << output << " has " << bytes.size() << " bytes, of " << complete.size();
    }
  }
  static std::string described(const std::string& fault, std::uint64_t all, const ToolResult& result) {
    return fault + " of " + std::to_string(all) + ": exit code " + std::to_string(result.code) +
           ", stderr: " + result.err;
  }

  const TemporaryFolder counts_;
  std::mt19937_64 random_ = seed_.engine();
};

} // namespace masu
