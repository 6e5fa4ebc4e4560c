#include "tools/jobs/task_list.h"

#include "libscene/base/error.h"
#include "libscene/file/container.h"
#include "libscene/file/output_file.h"
#include "tools/common/printable.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <limits>
#include <set>
#include <sstream>

namespace masu {
namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

std::string hash_of_text(const std::string& text) {
  return to_hex(hash_of({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}));
}

// --- Lines of a journal -----------------------------------------------------------------------------------

constexpr std::string_view journal_begins = R"({"masu_journal":1,"run":")";
constexpr const char* journal_infix = ".journal.";

// As a journal has it, so that it doesn't depend on the working folder, nor on its bytes being UTF-8.
std::string absolute_name(const std::string& path) {
  std::error_code unknown;
  const fs::path absolute = fs::weakly_canonical(fs::absolute(path, unknown), unknown);
  return printable(unknown ? path : absolute.string());
}

std::string first_line(const std::string& run, const std::set<std::string>& partial_files) {
  Json names = Json::array();
  for (const std::string& path : partial_files)
    names.push_back(absolute_name(path));
  return fmt::format("{}{}\",\"partial\":{}}}\n", journal_begins, run, names.dump());
}

struct Finished {
  std::uint64_t task = 0;
  TaskTotals totals;
  std::vector<FileRange> written;
};

// A line's hash, which it ends with, is of the run's hash and the line without it.
constexpr std::string_view before_hash = R"(,"hash":")", after_hash = R"("})";
constexpr std::size_t hash_characters = 32;
constexpr std::size_t line_end = before_hash.size() + hash_characters + after_hash.size();

std::string line_of(const Finished& finished, const std::string& run) {
  Json totals = Json::array(), files = Json::array();
  for_each_total(finished.totals, finished.totals,
                 [&](std::uint64_t total, std::uint64_t) { totals.push_back(total); });
  for (const FileRange& range : finished.written) {
    Json file{{"name", printable(range.path)}};
    if (range.offset) file["offset"] = *range.offset;
    file["bytes"] = range.bytes;
    file["hash"] = range.hash;
    files.push_back(std::move(file));
  }
  std::string line = Json{{"task", finished.task}, {"totals", totals}, {"files", files}}.dump();
  line.pop_back(); // }
  return fmt::format("{}{}{}{}\n", line, before_hash, hash_of_text(run + line + "}"), after_hash);
}

// Nothing for a line that isn't as it was written, or whose task writes something else.
std::optional<Finished> parsed(const std::string& line, const std::string& run, const TaskListOf& tasks) {
  if (line.size() < line_end) return {};
  const std::string content = line.substr(0, line.size() - line_end) + "}";
  if (line.substr(line.size() - line_end) !=
      fmt::format("{}{}{}", before_hash, hash_of_text(run + content), after_hash))
    return {};
  try {
    const Json json = Json::parse(content);
    Finished finished;
    json.at("task").get_to(finished.task);
    if (finished.task >= tasks.count) return {};
    std::size_t i = 0;
    const Json& totals = json.at("totals");
    for_each_total(finished.totals, finished.totals,
                   [&](std::uint64_t& total, std::uint64_t) { totals.at(i++).get_to(total); });
    finished.written = tasks.writes(finished.task);
    const Json& files = json.at("files");
    if (files.size() != finished.written.size()) return {};
    for (std::size_t k = 0; k < files.size(); ++k) {
      FileRange& range = finished.written[k];
      if (files[k].at("name") != printable(range.path)) return {};
      if (files[k].contains("offset") != range.offset.has_value()) return {};
      if (range.offset && files[k]["offset"] != *range.offset) return {};
      files[k].at("bytes").get_to(range.bytes);
      files[k].at("hash").get_to(range.hash);
    }
    return finished;
  } catch (const Json::exception&) {
    return {};
  }
}

// --- Files of earlier runs ---------------------------------------------------------------------------------

bool is_there(const std::string& path) {
  struct stat status {};
  return lstat(path.c_str(), &status) == 0;
}

std::string read_some(const InputFile& file, std::uint64_t bytes) {
  std::string text(std::min(file.size(), bytes), ' ');
  file.read(0, {reinterpret_cast<std::uint8_t*>(text.data()), text.size()});
  return text;
}

bool is_journal(const std::string& path) {
  try {
    return read_some(InputFile(path), journal_begins.size()) == journal_begins;
  } catch (const Error&) { // a folder, a pipe
    return false;
  }
}

// All journals of an output, of whatever run and number of ranks.
std::vector<std::string> journals_of(const std::string& output) {
  std::vector<std::string> found;
  const std::string prefix = output + journal_infix, begin = fs::path(prefix).filename().string();
  const fs::path folder = fs::path(prefix).parent_path();
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder.empty() ? "." : folder, ignored)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with(begin) || name.size() == begin.size() ||
        name.find_first_not_of("0123456789", begin.size()) != std::string::npos)
      continue;
    const std::string path = prefix + name.substr(begin.size());
    if (is_journal(path)) found.push_back(path);
  }
  return found;
}

std::set<std::string> partial_files(const TaskListOf& tasks) {
  std::set<std::string> found;
  for (std::uint64_t task = 0; task < tasks.count; ++task) {
    for (const FileRange& range : tasks.writes(task))
      if (range.offset) found.insert(range.path);
  }
  return found;
}

// Throws Error(output) where something else has the name of a journal of this run, or of a partial file.
void check_names(const std::string& output, int ranks, const std::vector<std::string>& journals,
                 const std::set<std::string>& partial, const std::set<std::string>& known) {
  const auto fail = [](const std::string& path) {
    throw Error(ErrorCode::output, path,
                "is in the way, and no run like this one has left it: move it away, or name another output");
  };
  for (int rank = 0; rank < ranks; ++rank) {
    const std::string name = journal_name(output, rank);
    if (is_there(name) && std::ranges::count(journals, name) == 0) fail(name);
  }
  for (const std::string& path : partial)
    if (is_there(path) && !known.contains(absolute_name(path))) fail(path);
}

// The partial files that journals name.
std::set<std::string> named_partial_files(const std::vector<std::string>& journals) {
  std::set<std::string> names;
  for (const std::string& text : journals) {
    const Json line = Json::parse(text.substr(0, text.find('\n')), nullptr, false);
    if (!line.is_object() || !line.contains("partial") || !line["partial"].is_array()) continue;
    for (const Json& name : line["partial"])
      if (name.is_string()) names.insert(name.get<std::string>());
  }
  return names;
}

// The lines of those journals that are of a run, without lines cut off.
std::string lines_of_run(const std::vector<std::string>& journals, const std::string& run) {
  std::string all;
  for (const std::string& text : journals) {
    const std::size_t first = text.find('\n') + 1;
    if (first > 0 && text.substr(journal_begins.size()).starts_with(run + '"'))
      all += text.substr(first, text.rfind('\n') + 1 - first);
  }
  return all;
}

// A partial file that isn't there any more was renamed, and its tasks are done by what it has become. Where
// one of them isn't, there is nothing that it could be written into: all are done again.
void forget_tasks_of_renamed_files(const TaskListOf& tasks, std::string& done) {
  for (bool changed = true; changed;) {
    changed = false;
    std::set<std::string> torn;
    for (std::uint64_t task = 0; task < tasks.count; ++task) {
      if (done[task] != 0) continue;
      for (const FileRange& range : tasks.writes(task))
        if (range.becomes > 0) torn.insert(range.path);
    }
    std::erase_if(torn, is_there);
    for (std::uint64_t task = 0; task < tasks.count && !torn.empty(); ++task) {
      const auto is_torn = [&](const FileRange& range) { return torn.contains(range.path); };
      if (done[task] == 0 || std::ranges::none_of(tasks.writes(task), is_torn)) continue;
      done[task] = 0;
      changed = true;
    }
  }
}

} // namespace

std::string journal_name(const std::string& output, int rank) {
  return output + journal_infix + std::to_string(rank);
}

std::vector<std::string> files_beside(const std::vector<std::string>& outputs, const Sharing& sharing) {
  std::vector<std::string> files;
  for (const std::string& output : outputs) {
    if (output.empty() || !sharing.in_parts()) continue;
    if (files.empty()) files.push_back(journal_name(output, sharing.ranks.rank()));
    files.push_back(partial_name(output));
  }
  return files;
}

TaskList::TaskList(const Sharing& sharing, const TaskListOf& tasks)
    : sharing_(sharing), count_(tasks.count), left_(tasks.count) {
  if (sharing.in_parts() && !tasks.output.empty()) take_over(tasks);
}

// Makes this run's journals, of what interrupted runs left.
void TaskList::take_over(const TaskListOf& tasks) {
  Ranks& ranks = sharing_.ranks;
  const std::set<std::string> partial = partial_files(tasks);
  if (!sharing_.resume && partial.empty()) return;
  output_ = tasks.output;
  run_ = hash_of_text(tasks.description);
  std::vector<std::string> before, texts; // rank 0's
  if (ranks.rank() == 0) {
    before = journals_of(output_);
    for (const std::string& name : before)
      texts.push_back(read_some(InputFile(name), std::numeric_limits<std::uint64_t>::max()));
    check_names(output_, ranks.count(), before, partial, named_partial_files(texts));
  }
  const std::string first = first_line(run_, partial), own = journal_name(output_, ranks.rank());
  const std::string lines = sharing_.resume ? taken_over(tasks, lines_of_run(texts, run_)) : "";
  if (ranks.rank() == 0) {
    write_text_file(own, first + lines);
    for (const std::string& name : before)
      if (name != own) fs::remove(name);
    ranks.add_finished(count_ - left_);
  }
  ranks.wait_for_all();
  if (!sharing_.resume) return;
  if (ranks.rank() > 0) write_text_file(own, first);
  journal_ = open(own.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
  if (journal_ < 0)
    throw Error(ErrorCode::output, own, std::string("can't be opened: ") + std::strerror(errno));
}

// The tasks that lines say are finished, and are: rank 0 has the lines, ranks share the verification. Returns
// those that hold.
std::string TaskList::taken_over(const TaskListOf& tasks, std::string lines) {
  Ranks& ranks = sharing_.ranks;
  ranks.broadcast(lines);
  std::vector<Finished> finished;
  std::vector<std::string> texts; // their lines
  std::istringstream in(lines);
  in.exceptions(std::ios::badbit); // else what memory doesn't suffice for would be taken for the end
  for (std::string line; std::getline(in, line);) {
    auto known = parsed(line, run_, tasks);
    if (!known) continue;
    finished.push_back(std::move(*known));
    texts.push_back(line + '\n');
  }
  std::vector<std::uint64_t> whole(finished.size());
  for (std::size_t i = static_cast<std::size_t>(ranks.rank()); i < finished.size();
       i += static_cast<std::size_t>(ranks.count()))
    whole[i] = std::ranges::all_of(finished[i].written, is_whole) ? 1 : 0;
  ranks.sum(whole);
  std::string done(count_, 0); // of each task 1 or 0
  for (std::size_t i = 0; i < finished.size(); ++i)
    if (whole[i] != 0) done[finished[i].task] = 1;
  if (ranks.rank() == 0) forget_tasks_of_renamed_files(tasks, done);
  ranks.broadcast(done);
  for (std::uint64_t task = 0; task < count_; ++task)
    if (done[task] == 0) to_do_.push_back(task);
  left_ = to_do_.size();
  std::string kept;
  for (std::size_t i = 0; i < finished.size(); ++i) {
    char& takes_line = done[finished[i].task]; // one line for each task
    if (whole[i] == 0 || takes_line == 0) continue;
    takes_line = 0;
    if (ranks.rank() == 0) totals_ += finished[i].totals;
    kept += texts[i];
  }
  return kept;
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
    const std::string line = line_of({task, totals, written}, run_);
    const std::lock_guard lock(mutex_);
    // In one call: a line is whole, or cut off by the process's end.
    if (write(journal_, line.data(), line.size()) != static_cast<ssize_t>(line.size()))
      throw Error(ErrorCode::output, journal_name(output_, sharing_.ranks.rank()),
                  std::string("can't be written: ") + std::strerror(errno));
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
  if (output_.empty()) return;
  for (const std::string& name : journals_of(output_))
    fs::remove(name);
}

} // namespace masu
