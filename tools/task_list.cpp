#include "tools/task_list.h"

#include "libscene/error.h"
#include "libscene/file/container.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

namespace masu {
namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

// --- Lines of a journal -----------------------------------------------------------------------------------

struct Finished {
  std::uint64_t task = 0;
  TaskTotals totals;
  std::vector<FileRange> written;
};

std::string line_of(const Finished& finished) {
  Json counts = Json::array(), files = Json::array();
  for_each_count(finished.totals.counts, finished.totals.counts,
                 [&](std::uint64_t count, std::uint64_t) { counts.push_back(count); });
  for (const FileRange& range : finished.written) {
    Json file{{"name", range.path}};
    if (range.offset) file["offset"] = *range.offset;
    file["bytes"] = range.bytes;
    file["hash"] = range.hash;
    files.push_back(std::move(file));
  }
  return Json{{"task", finished.task},
              {"rays", finished.totals.rays},
              {"invalid", finished.totals.invalid},
              {"counts", counts},
              {"files", files}}
             .dump() +
         "\n";
}

// Nothing for a line that isn't whole.
std::optional<Finished> parsed(const std::string& line) {
  try {
    const Json json = Json::parse(line);
    Finished finished;
    json.at("task").get_to(finished.task);
    json.at("rays").get_to(finished.totals.rays);
    json.at("invalid").get_to(finished.totals.invalid);
    std::size_t i = 0;
    const Json& counts = json.at("counts");
    for_each_count(finished.totals.counts, finished.totals.counts,
                   [&](std::uint64_t& count, std::uint64_t) { counts.at(i++).get_to(count); });
    for (const Json& file : json.at("files")) {
      FileRange& range = finished.written.emplace_back();
      file.at("name").get_to(range.path);
      if (file.contains("offset")) range.offset = file["offset"].get<std::uint64_t>();
      file.at("bytes").get_to(range.bytes);
      file.at("hash").get_to(range.hash);
    }
    return finished;
  } catch (const Json::exception&) {
    return {};
  }
}

std::string first_line(const std::string& hash) {
  return Json{{"run", hash}}.dump() + "\n";
}

// All journals of an output, whatever their number.
std::vector<std::string> journals(const std::string& prefix) {
  std::vector<std::string> found;
  const fs::path path(prefix);
  std::error_code ignored;
  for (const auto& entry :
       fs::directory_iterator(path.has_parent_path() ? path.parent_path() : ".", ignored)) {
    const std::string name = entry.path().filename().string(), begin = path.filename().string();
    if (name.starts_with(begin) && name.size() > begin.size() &&
        name.find_first_not_of("0123456789", begin.size()) == std::string::npos)
      found.push_back((path.parent_path() / name).string());
  }
  return found;
}

// The lines of those journals that are of a run.
std::string lines_of_run(const std::vector<std::string>& names, const std::string& hash) {
  std::string all;
  for (const std::string& name : names) {
    std::ifstream file(name, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    const std::string first = first_line(hash);
    if (!text.starts_with(first)) continue;
    all += text.substr(first.size(), text.rfind('\n') + 1 - first.size()); // without a line cut off
  }
  return all;
}

void write_all(int file, const std::string& text, const std::string& name) {
  // In one call: a line is whole, or cut off by the process's end.
  if (write(file, text.data(), text.size()) != static_cast<ssize_t>(text.size()))
    throw Error(ErrorCode::output, name, std::string("can't be written: ") + std::strerror(errno));
}

} // namespace

TaskList::TaskList(const Sharing& sharing, const TaskListOf& tasks) : sharing_(sharing), count_(tasks.count) {
  left_ = count_;
  if (sharing.resume) take_over(tasks);
}

// What an interrupted run finished: rank 0 reads its journals, ranks share the verification.
void TaskList::take_over(const TaskListOf& tasks) {
  Ranks& ranks = sharing_.ranks;
  const std::string hash = to_hex(
      hash_of({reinterpret_cast<const std::uint8_t*>(tasks.description.data()), tasks.description.size()}));
  const std::string prefix = tasks.output + ".journal.";
  journal_name_ = prefix + std::to_string(ranks.rank());
  const std::vector<std::string> before = ranks.rank() == 0 ? journals(prefix) : std::vector<std::string>();
  std::string text = lines_of_run(before, hash);
  ranks.broadcast(text);
  std::vector<Finished> finished;
  std::istringstream lines(text);
  lines.exceptions(std::ios::badbit); // else what memory doesn't suffice for would be taken for the end
  for (std::string line; std::getline(lines, line);) {
    if (auto known = parsed(line); known && known->task < count_) finished.push_back(std::move(*known));
  }
  std::vector<std::uint64_t> whole(finished.size());
  for (std::size_t i = static_cast<std::size_t>(ranks.rank()); i < finished.size();
       i += static_cast<std::size_t>(ranks.count()))
    whole[i] = std::ranges::all_of(finished[i].written, is_whole) ? 1 : 0;
  ranks.sum(whole);
  std::vector<bool> done(count_);
  std::string kept = first_line(hash);
  for (std::size_t i = 0; i < finished.size(); ++i) {
    if (whole[i] == 0 || done[finished[i].task]) continue;
    done[finished[i].task] = true;
    if (ranks.rank() == 0) totals_ += finished[i].totals;
    kept += line_of(finished[i]);
  }
  for (std::uint64_t task = 0; task < count_; ++task) {
    if (!done[task]) to_do_.push_back(task);
  }
  left_ = to_do_.size();
  if (ranks.rank() == 0) {
    OutputFile merged(journal_name_);
    merged.write(kept.data(), kept.size());
    merged.commit();
    for (const std::string& name : before) {
      if (name != journal_name_) fs::remove(name);
    }
    ranks.add_finished(count_ - left_);
  }
  ranks.wait_for_all();
  journal_ = open(journal_name_.c_str(), O_WRONLY | O_APPEND | O_CREAT | O_CLOEXEC, 0666);
  if (journal_ < 0)
    throw Error(ErrorCode::output, journal_name_, std::string("can't be created: ") + std::strerror(errno));
  if (ranks.rank() > 0) write_all(journal_, first_line(hash), journal_name_);
}

TaskList::~TaskList() {
  if (journal_ >= 0) close(journal_);
}

std::optional<std::uint64_t> TaskList::next() {
  const std::uint64_t next = sharing_.ranks.next();
  if (next >= left_) return {};
  return to_do_.empty() ? next : to_do_[next];
}

double TaskList::finish(std::uint64_t task, const std::vector<FileRange>& written, const TaskTotals& totals) {
  if (journal_ >= 0) {
    const std::string line = line_of({task, totals, written});
    const std::lock_guard lock(mutex_);
    write_all(journal_, line, journal_name_);
  }
  const std::uint64_t finished = sharing_.ranks.add_finished(1);
  const std::lock_guard lock(mutex_);
  totals_ += totals;
  return static_cast<double>(finished) / static_cast<double>(count_);
}

double TaskList::share() {
  return static_cast<double>(sharing_.ranks.add_finished(0)) /
         static_cast<double>(std::max<std::uint64_t>(count_, 1));
}

void TaskList::remove_journals() const {
  if (journal_ < 0) return;
  for (const std::string& name : journals(journal_name_.substr(0, journal_name_.rfind('.') + 1)))
    fs::remove(name);
}

} // namespace masu
