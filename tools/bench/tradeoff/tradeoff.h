// What `gridbench tradeoff` measures, one row for each scene, setup and configuration; Pareto fronts, the
// rows that no other row is better than; and the file of measurements.
#pragma once

#include "libgrid/structure/chosen_structure.h"
#include "libscene/base/error.h"
#include "renderer/tracer/tracer.h"
#include "tools/common/json.h"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace masu {

// What all rows of a chart have in common: rows of different setups can't be compared.
struct TradeoffSetup {
  std::string backend;        // cpu, cuda
  std::uint64_t threads = 0;  // of the CPU; 0 for cuda
  std::string size;           // of the primary rays, WxH
  std::uint64_t random = 0;   // random rays
  std::uint64_t compared = 0; // rays of each of the two sets that are compared with brute force (upper limit)
  std::string picture;        // its size, WxH
  std::uint64_t seed = 0;     // of the random rays
  std::uint64_t repeat = 0;   // timed runs; their median counts, on a CPU of processor time
  friend bool operator==(const TradeoffSetup&, const TradeoffSetup&) = default;
};

// A precision, a stop rule and a grid's build options. `merge` isn't `automatic`, which is one of the others.
struct Configuration {
  Precision precision;
  StopRule stop;
  StructureKind merge;
  std::string division; // as gridbuild takes it
  Overlap overlap;
  friend bool operator==(const Configuration&, const Configuration&) = default;
};

// Compared with brute force in double.
struct Accuracy {
  std::uint64_t rays = 0;             // compared
  std::uint64_t missed = 0;           // no hit found where there is one
  std::uint64_t false_hits = 0;       // a hit found where there is none
  std::uint64_t wrong_primitives = 0; // a hit of another primitive, at another t
  std::uint64_t ties = 0;           // another primitive at the same t to within float32's rounding: not wrong
  double worst_t = 0, median_t = 0; // relative errors of t of correct hits, which are float32: errors below
                                    // 2^-24 read 0
  double rmse = 0, largest = 0;     // of the picture's channels (linear)

  std::uint64_t wrong() const { return missed + false_hits + wrong_primitives; }
};

struct Measurement {
  std::uint64_t voxels = 0; // of the division
  std::uint64_t grid_bytes = 0, scene_bytes = 0;
  double primary_mrays = 0, random_mrays = 0, mrays = 0; // million closest hits a second; mrays: of both sets
  double picture_ms = 0;
  Accuracy accuracy;
};

struct TradeoffRow {
  std::string scene, scene_hash;
  TradeoffSetup setup;
  Configuration configuration;
  Measurement measured;
};

// The names used in the table and the file.
template <class Value>
using Names = std::vector<std::pair<const char*, Value>>;
inline Names<Precision> names_of(Precision) {
  return {{"fast", Precision::fast}, {"robust", Precision::robust}, {"double", Precision::doubled}};
}
inline Names<StopRule> names_of(StopRule) {
  return {{"proven", StopRule::proven}, {"first-cell-hit", StopRule::first_cell}};
}
inline Names<StructureKind> names_of(StructureKind) {
  return {{"none", StructureKind::uniform},
          {"x", StructureKind::x},
          {"balance", StructureKind::balance},
          {"irregular", StructureKind::irregular},
          {"bvh", StructureKind::hierarchy}};
}
inline Names<Overlap> names_of(Overlap) {
  return {{"box", Overlap::box}, {"exact", Overlap::exact}};
}
template <class Value>
const char* name_of(Value value) {
  const Names<Value> names = names_of(value);
  return std::ranges::find(names, value, &Names<Value>::value_type::second)->first;
}
// The Precision, StopRule, StructureKind or Overlap of that name. Throws Error(usage, text, …).
template <class Value>
Value named(const std::string& text) {
  std::string names;
  for (const auto& [name, value] : names_of(Value{})) {
    if (text == name) return value;
    names += (names.empty() ? "" : ", ") + std::string(name);
  }
  throw Error(ErrorCode::usage, text, "isn't one of " + names);
}

// The rays and the picture that every configuration of a scene traces, and the reference results.
struct TradeoffTask {
  // Traces the reference by brute force in double, which is slow. Both outlive it.
  TradeoffTask(const SceneFile& scene_, const TradeoffSetup& setup_);

  const SceneFile& scene;
  const TradeoffSetup& setup;
  std::vector<Ray<double>> primary, random;
  Camera picture;
  struct Reference {
    std::vector<Ray<double>> rays; // evenly spaced in both sets
    std::vector<HitRecord> hits;   // by primitive
    HostArray<Vec3f> radiance;
  } reference;
};

// Measures one configuration: its speed, and the errors of its hits and picture compared with brute force in
// double. The grid is of the task's scene. Throws Error(device).
Measurement measure(const TradeoffTask& task, const StructureFile& grid, const Configuration& configuration);

// Precision and stop rule: a series of the charts.
std::string method_of(const Configuration& configuration);
// Merge mode, division and overlap test.
std::string grid_of(const Configuration& configuration);

// How good a row is: more speed is better, less error is better.
struct Merit {
  double speed, error;
};

// Indices of those that none dominates (is at least as good in both, and better in one), in order of falling
// speed, and so of falling error. Of equals, the first.
std::vector<std::size_t> pareto_front(const std::vector<Merit>& merits);

// Closest hits: millions of rays a second, and the fraction of wrong hits.
Merit merit_of_hits(const TradeoffRow& row);
// Pictures: pictures a second, and the RMSE.
Merit merit_of_picture(const TradeoffRow& row);

// The front of rows by one of these. Rows that stop at the first cell hit are never on it: where their hits
// are right, that is by chance.
std::vector<std::size_t> front_of(const std::vector<TradeoffRow>& rows, Merit (*merit)(const TradeoffRow&));

// The mean over scenes, which are distinguished by name: one row, of a scene named `all`, for each
// configuration that was measured on every scene. Speeds and times are geometric means; counts of hits and
// bytes are sums; errors of t are maxima; the RMSE is that of all pictures together.
std::vector<TradeoffRow> over_all_scenes(const std::vector<TradeoffRow>& rows);

// The file of measurements has a line a row, so that a run that was stopped is continued by the next one.
//
// All rows in the file; none where there is no file. An incomplete last line, left by a run that was stopped,
// is ignored. Throws Error(input, path:line, …) for a file of another kind, and for a damaged line.
std::vector<TradeoffRow> read_tradeoff_csv(const std::string& path);

// Appends rows to a file that read_tradeoff_csv accepts, or creates one. The whole row is in the file when
// add() returns. An incomplete last line is removed. The file is locked: only one run at a time may write it.
class TradeoffCsv {
public:
  // Throws Error(output, path, …).
  explicit TradeoffCsv(std::string path);
  void add(const TradeoffRow& row);

private:
  void write(const std::string& line);

  std::string path_;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
};

// A row with the file's names.
Json json_of(const TradeoffRow& row);

// The rows that the charts show, a group for each chart, with two more columns: hits_front and picture_front
// are 1 for rows on the group's Pareto fronts (merit_of_hits, merit_of_picture), else 0. Throws Error(output,
// path, …).
void write_charts_csv(const std::string& path, const std::vector<std::vector<TradeoffRow>>& groups);

} // namespace masu
