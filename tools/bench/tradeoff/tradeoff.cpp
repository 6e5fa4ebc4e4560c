#include "tools/bench/tradeoff/tradeoff.h"

#include "libscene/file/output_file.h"
#include "tools/common/number_list.h"

#include <fmt/format.h>
#include <sys/file.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <numeric>
#include <set>
#include <system_error>
#include <type_traits>

namespace masu {

std::string method_of(const Configuration& configuration) {
  return name_of(configuration.precision) +
         std::string(configuration.stop == StopRule::proven ? "" : ", first cell hit");
}

std::string grid_of(const Configuration& configuration) {
  if (configuration.merge == StructureKind::hierarchy) return name_of(configuration.merge);
  const char* const merge =
      configuration.merge == StructureKind::uniform ? "uniform" : name_of(configuration.merge);
  const bool divided = configuration.merge != StructureKind::irregular || configuration.division != "auto";
  return fmt::format("{} {}{}", merge, divided ? configuration.division + " " : "",
                     name_of(configuration.overlap));
}

std::vector<std::size_t> pareto_front(const std::vector<Merit>& merits) {
  std::vector<std::size_t> order(merits.size()), front;
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {},
                           [&](std::size_t i) { return std::pair(-merits[i].speed, merits[i].error); });
  double least = std::numeric_limits<double>::infinity();
  for (const std::size_t i : order) {
    if (!(merits[i].error < least)) continue;
    least = merits[i].error;
    front.push_back(i);
  }
  return front;
}

Merit merit_of_hits(const TradeoffRow& row) {
  const Accuracy& accuracy = row.measured.accuracy;
  const auto rays = static_cast<double>(std::max<std::uint64_t>(accuracy.rays, 1));
  return {row.measured.mrays, static_cast<double>(accuracy.wrong()) / rays};
}

Merit merit_of_picture(const TradeoffRow& row) {
  return {row.measured.picture_ms > 0 ? 1e3 / row.measured.picture_ms : 0, row.measured.accuracy.rmse};
}

std::vector<std::size_t> front_of(const std::vector<TradeoffRow>& rows, Merit (*merit)(const TradeoffRow&)) {
  constexpr Merit worst{0, std::numeric_limits<double>::infinity()};
  std::vector<Merit> merits;
  for (const TradeoffRow& row : rows)
    merits.push_back(row.configuration.stop == StopRule::proven ? merit(row) : worst);
  return pareto_front(merits);
}

namespace {

// The mean of rows with one configuration, one for each scene.
Measurement together(const std::vector<const TradeoffRow*>& rows) {
  Measurement all;
  Accuracy& accuracy = all.accuracy;
  const auto sum = [&](const auto& value_of) {
    return std::accumulate(rows.begin(), rows.end(), 0.0, [&](double so_far, const TradeoffRow* row) {
      return so_far + value_of(row->measured);
    });
  };
  const auto count = static_cast<double>(rows.size());
  for (double Measurement::*const speed : {&Measurement::primary_mrays, &Measurement::random_mrays,
                                           &Measurement::mrays, &Measurement::picture_ms})
    all.*speed = std::exp(sum([&](const Measurement& one) { return std::log(one.*speed); }) / count);
  // The pictures are of one size.
  accuracy.rmse =
      std::sqrt(sum([](const Measurement& one) { return one.accuracy.rmse * one.accuracy.rmse; }) / count);
  for (const TradeoffRow* const row : rows) {
    for (std::uint64_t Measurement::*const size :
         {&Measurement::voxels, &Measurement::grid_bytes, &Measurement::scene_bytes})
      all.*size += row->measured.*size;
    for (std::uint64_t Accuracy::*const hits : {&Accuracy::rays, &Accuracy::missed, &Accuracy::false_hits,
                                                &Accuracy::wrong_primitives, &Accuracy::ties})
      accuracy.*hits += row->measured.accuracy.*hits;
    for (double Accuracy::*const error : {&Accuracy::worst_t, &Accuracy::median_t, &Accuracy::largest})
      accuracy.*error = std::max(accuracy.*error, row->measured.accuracy.*error);
  }
  return all;
}

} // namespace

std::vector<TradeoffRow> over_all_scenes(const std::vector<TradeoffRow>& rows) {
  std::set<std::string> scenes;
  for (const TradeoffRow& row : rows)
    scenes.insert(row.scene);
  std::vector<TradeoffRow> all;
  for (const TradeoffRow& first : rows) {
    if (first.scene != rows.front().scene) continue;
    std::vector<const TradeoffRow*> same;
    for (const TradeoffRow& row : rows) {
      if (row.configuration == first.configuration) same.push_back(&row);
    }
    if (same.size() != scenes.size()) continue;
    all.push_back({"all", "", first.setup, first.configuration, together(same)});
  }
  return all;
}

// --- The file of measurements -----------------------------------------------------------------------------

namespace {

// Measurements are less precise than six digits. No text contains a comma.
template <class Value>
std::string text_of(const Value& value) {
  if constexpr (std::is_enum_v<Value>)
    return name_of(value);
  else if constexpr (std::is_floating_point_v<Value>)
    return fmt::format("{:.6g}", value);
  else
    return fmt::format("{}", value);
}

// Throws Error(input) where `text` isn't a number, where one belongs.
template <class Value>
void read(const std::string& text, Value& value) {
  if constexpr (std::is_enum_v<Value>) {
    value = named<Value>(text);
  } else if constexpr (std::is_arithmetic_v<Value>) {
    const auto number = read_number<Value>(text);
    if (!number) throw Error(ErrorCode::input, text, "isn't a valid number");
    value = *number;
  } else {
    value = text;
  }
}

// Calls act(name, value) for each column, in the file's order.
template <class Row, class Act>
void for_each_column(Row& row, const Act& act) {
  auto& setup = row.setup;
  auto& configuration = row.configuration;
  auto& measured = row.measured;
  auto& accuracy = measured.accuracy;
  act("scene", row.scene);
  act("scene_hash", row.scene_hash);
  act("backend", setup.backend);
  act("threads", setup.threads);
  act("primary_size", setup.size);
  act("random_rays", setup.random);
  act("compared_of_each", setup.compared);
  act("picture_size", setup.picture);
  act("seed", setup.seed);
  act("repeat", setup.repeat);
  act("precision", configuration.precision);
  act("stop_rule", configuration.stop);
  act("merge", configuration.merge);
  act("division", configuration.division);
  act("overlap", configuration.overlap);
  act("voxels", measured.voxels);
  act("grid_bytes", measured.grid_bytes);
  act("scene_bytes", measured.scene_bytes);
  act("primary_mrays", measured.primary_mrays);
  act("random_mrays", measured.random_mrays);
  act("mrays", measured.mrays);
  act("picture_ms", measured.picture_ms);
  act("rays_compared", accuracy.rays);
  act("missed", accuracy.missed);
  act("false_hits", accuracy.false_hits);
  act("wrong_primitives", accuracy.wrong_primitives);
  act("ties", accuracy.ties);
  act("worst_t_error", accuracy.worst_t);
  act("median_t_error", accuracy.median_t);
  act("picture_rmse", accuracy.rmse);
  act("picture_largest_error", accuracy.largest);
}

// Both without a newline.
std::string header() {
  std::vector<std::string> cells;
  TradeoffRow row{};
  for_each_column(row, [&](const char* name, const auto&) { cells.emplace_back(name); });
  return fmt::format("{}", fmt::join(cells, ","));
}
std::string line_of(const TradeoffRow& row) {
  std::vector<std::string> cells;
  for_each_column(row, [&](const char*, const auto& value) { cells.push_back(text_of(value)); });
  return fmt::format("{}", fmt::join(cells, ","));
}

// `line` is without its newline. Throws Error(input).
TradeoffRow row_of(const std::string& line) {
  TradeoffRow row{};
  const std::vector<std::string> cells = split(line);
  std::size_t next = 0;
  for_each_column(row, [&](const char* name, auto& value) {
    if (next == cells.size()) throw Error(ErrorCode::input, name, "is missing");
    read(cells[next++], value);
  });
  if (next < cells.size()) throw Error(ErrorCode::input, "line", "goes on after its last column");
  return row;
}

std::string content_of(const std::string& path) {
  std::error_code failed;
  if (!std::filesystem::exists(path, failed)) return {};
  std::ifstream file(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(file), {}};
  if (!file.good()) throw Error(ErrorCode::input, path, "can't be read");
  return text;
}

[[noreturn]] void fail(const std::string& path, const char* doing) {
  throw Error(ErrorCode::output, path, fmt::format("{}: {}", doing, std::strerror(errno)));
}

} // namespace

std::vector<TradeoffRow> read_tradeoff_csv(const std::string& path) {
  const std::string text = content_of(path), first_line = header() + "\n";
  if (first_line.starts_with(text)) return {}; // an empty file, or part of the header
  if (!text.starts_with(first_line))
    throw Error(ErrorCode::input, path + ":1",
                "isn't the header of a file by gridbench tradeoff: choose another folder with -o, or "
                "move the file away");
  std::vector<TradeoffRow> rows;
  std::size_t number = 2;
  for (std::size_t at = first_line.size(), end = 0; (end = text.find('\n', at)) != std::string::npos;
       at = end + 1) {
    try {
      rows.push_back(row_of(text.substr(at, end - at)));
    } catch (const Error& error) {
      throw Error(ErrorCode::input, fmt::format("{}:{}", path, number),
                  fmt::format("is damaged: '{}' {}: remove the line, or move the file away", error.place(),
                              error.message()));
    }
    ++number;
  }
  return rows;
}

TradeoffCsv::TradeoffCsv(std::string path)
    : path_(std::move(path)), file_(std::fopen(path_.c_str(), "abe"), std::fclose) {
  if (file_ == nullptr) fail(path_, "can't be opened for writing");
  if (flock(fileno(file_.get()), LOCK_EX | LOCK_NB) != 0)
    throw Error(ErrorCode::output, path_,
                "is being written by another run: wait for it, or choose another folder");
  const std::string text = content_of(path_);
  const std::size_t whole = text.rfind('\n') + 1; // 0: no complete line
  std::error_code failed;
  if (whole < text.size()) std::filesystem::resize_file(path_, whole, failed);
  if (failed) throw Error(ErrorCode::output, path_, "can't be shortened to whole lines: " + failed.message());
  if (whole == 0) write(header() + "\n");
}

void TradeoffCsv::add(const TradeoffRow& row) {
  write(line_of(row) + "\n");
}

void TradeoffCsv::write(const std::string& line) {
  if (std::fwrite(line.data(), 1, line.size(), file_.get()) != line.size() || std::fflush(file_.get()) != 0)
    fail(path_, "can't be written");
}

Json json_of(const TradeoffRow& row) {
  Json json;
  for_each_column(row, [&](const char* name, const auto& value) {
    if constexpr (std::is_enum_v<std::decay_t<decltype(value)>>)
      json[name] = name_of(value);
    else
      json[name] = value;
  });
  return json;
}

void write_charts_csv(const std::string& path, const std::vector<std::vector<TradeoffRow>>& groups) {
  std::string text = header() + ",hits_front,picture_front\n";
  for (const std::vector<TradeoffRow>& rows : groups) {
    const auto hits = front_of(rows, merit_of_hits), picture = front_of(rows, merit_of_picture);
    for (std::size_t i = 0; i < rows.size(); ++i)
      text += fmt::format("{},{},{}\n", line_of(rows[i]), std::count(hits.begin(), hits.end(), i),
                          std::count(picture.begin(), picture.end(), i));
  }
  write_text_file(path, text);
}

} // namespace masu
