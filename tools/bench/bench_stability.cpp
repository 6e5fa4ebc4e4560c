// Where tracing fails: sweeps of one parameter each, compared with an oracle; and the same rays on the GPU.
#include "stability/oracle/backends.h"
#include "stability/oracle/embree_scene.h"
#include "stability/oracle/exact_hit.h"
#include "stability/run.h"
#include "stability/sweeps/picture_sweeps.h"
#include "tools/bench/command.h"

#include <utility>

namespace masu {
namespace {

using namespace stability;

struct Settings {
  std::vector<std::string> sweeps, precisions;
  RunSettings run{};
  Backend backend = Backend::cpu;
  bool pictures = false;
};

bool wanted(const std::vector<std::string>& list, const std::string& name) {
  return list.empty() || contains(list, name);
}

const char* store_of(bool float64) {
  return float64 ? "float64" : "float32";
}

Json to_json(const Row& row) {
  const Tally& t = row.tally;
  return {{"sweep", row.sweep},    {"parameter", row.parameter},
          {"step", row.step},      {"store", store_of(row.float64)},
          {"mode", row.mode.name}, {"within_envelope", row.within},
          {"rays", t.rays},        {"unsure", t.unsure},
          {"missed", t.missed},    {"false", t.false_hit},
          {"wrong", t.wrong},      {"misplaced", t.misplaced},
          {"by_grid", t.by_grid},  {"worst_t_error", t.worst_t}};
}

std::string step_text(double step) {
  std::string text = fmt::format("{}", step);
  return text.size() <= 8 ? text : fmt::format("{:.3g}", step);
}

// Fractions of the rays; - for none.
void print_row(const Output& output, const Row& row) {
  const Tally& t = row.tally;
  const auto share = [&](std::uint64_t number) {
    return number == 0 ? std::string("-")
                       : fmt::format("{:.1g}", static_cast<double>(number) / static_cast<double>(t.rays));
  };
  const std::string mode =
      fmt::format("{}{}", row.mode.name, row.promised && t.failures() > 0 ? " FAILS" : "");
  output.print("{:>8} {:<14} {:>7} {:>6} {:>6} {:>5} {:>5} {:>6} {:>7} {:>7.1e}\n", step_text(row.step), mode,
               t.rays, share(t.unsure), share(t.missed), share(t.false_hit), share(t.wrong),
               share(t.misplaced), share(t.by_grid), t.worst_t);
}

void print_disagreements(const Output& output, const std::vector<Row>& rows) {
  if (rows.empty()) return;
  output.print("\nRays of which robust and embree-robust find different primitives, and which of\n"
               "them is right in exact arithmetic\n{:<21} {:>8} {:>7} {:>9} {:>7} {:>7} {:>7} {:>7}\n",
               "sweep", "step", "rays", "differing", "robust", "embree", "both", "neither");
  for (const Row& row : rows) {
    const Disagreement& d = row.disagreement.value();
    output.print("{:<21} {:>8} {:>7} {:>9} {:>7} {:>7} {:>7} {:>7}\n", row.sweep, step_text(row.step), d.rays,
                 d.differing, d.first, d.second, d.both, d.neither);
  }
}

// Returns the number of steps at which CPU and GPU differ in robust or double.
std::uint64_t compare(const Settings& settings, const std::vector<Sweep>& sweeps, Output& output) {
  std::uint64_t bad = 0;
  output.print("\n{:<22} {:>8} {:<7} {:<14} {:>8} {:>9}\n", "cpu and cuda", "step", "store", "mode", "rays",
               "differing");
  for (const Sweep& sweep : sweeps) {
    compare_backends(sweep, settings.run, [&](const Difference& d) {
      if (!wanted(settings.precisions, d.mode.name)) return;
      bad += d.mode.precision != Precision::fast && d.differing > 0 ? 1 : 0;
      output.json.push_back({{"sweep", d.sweep},
                             {"step", d.step},
                             {"store", store_of(d.float64)},
                             {"mode", d.mode.name},
                             {"backends", "cpu,cuda"},
                             {"rays", d.rays},
                             {"differing", d.differing}});
      output.print("{:<22} {:>8} {:<7} {:<14} {:>8} {:>9}\n", d.sweep, step_text(d.step), store_of(d.float64),
                   d.mode.name, d.rays, d.differing);
    });
  }
  return bad;
}

// Those that are asked for. Throws Error(usage) for one that there isn't.
template <class AnySweep>
std::vector<AnySweep> chosen(std::vector<AnySweep> sweeps, const Settings& settings) {
  std::vector<std::string> names;
  for (const AnySweep& sweep : sweeps)
    names.emplace_back(sweep.name);
  for (const std::string& name : settings.sweeps)
    if (!contains(names, name))
      throw Error(ErrorCode::usage, "--sweep",
                  fmt::format("'{}' isn't one of {}", name, fmt::join(names, ", ")));
  std::erase_if(sweeps, [&](const AnySweep& sweep) { return !wanted(settings.sweeps, sweep.name); });
  return sweeps;
}

void sweep_pictures(const Settings& settings, Output& output) {
  output.device = device_name(false);
  output.print("{:<10} {:>8} {:<7} {:<7} {:<9} {:>12}\n", "sweep", "step", "origin", "store", "precision",
               "pixels off");
  for (const PictureSweep& sweep : chosen(picture_sweeps(), settings)) {
    run(sweep, settings.run.seed, [&](const PictureRow& row) {
      if (!wanted(settings.precisions, name_of(row.precision))) return;
      const char *const origin = row.local_origin ? "local" : "none", *const store = store_of(row.float64);
      output.json.push_back({{"sweep", row.sweep},
                             {"parameter", row.parameter},
                             {"step", row.step},
                             {"origin", origin},
                             {"store", store},
                             {"precision", name_of(row.precision)},
                             {"pixels_off", row.pixels_off}});
      output.print("{:<10} {:>8.3g} {:<7} {:<7} {:<9} {:>12.3g}\n", row.sweep, row.step, origin, store,
                   name_of(row.precision), row.pixels_off);
    });
  }
}

void bench_stability(const Settings& settings, Output& output) {
  if (settings.pictures) return sweep_pictures(settings, output);
  const bool cuda = output.on_cuda(settings.backend);
  const std::vector<Sweep> sweeps = chosen(all_sweeps(), settings);
  RunSettings run_settings = settings.run;
  run_settings.embree = embree_available;
  std::vector<Row> disagreements;
  std::string head; // the last one printed: of a sweep in one store, before its rows
  for (const Sweep& sweep : sweeps) {
    run(sweep, run_settings, [&](const Row& row) {
      if (!wanted(settings.precisions, row.mode.name)) return;
      output.json.push_back(to_json(row));
      const std::string own = row.sweep + store_of(row.float64);
      if (std::exchange(head, own) != own)
        output.print("\n{}, {}:\n{}\n{:>8} {:<14} {:>7} {:>6} {:>6} {:>5} {:>5} {:>6} {:>7} {:>7}\n",
                     row.sweep, store_of(row.float64), row.parameter, "step", "mode", "rays", "unsure",
                     "missed", "false", "wrong", "mispl.", "by grid", "t error");
      print_row(output, row);
      if (!row.disagreement) return;
      disagreements.push_back(row);
      const Disagreement& d = *row.disagreement;
      output.json.push_back({{"sweep", row.sweep},
                             {"step", row.step},
                             {"store", "float32"},
                             {"modes", "robust,embree-robust"},
                             {"rays", d.rays},
                             {"differing", d.differing},
                             {"robust_right", d.first},
                             {"embree_right", d.second},
                             {"both_right", d.both},
                             {"neither_right", d.neither}});
    });
  }
  print_disagreements(output, disagreements);
  if (!embree_available)
    output.print("Without Embree: this program was built without it (libembree-dev)\n");
  else if (!exact_hits_available)
    output.print("Who is right where Embree differs isn't decided: built without GMP (libgmp-dev)\n");
  const std::uint64_t bad = cuda ? compare(settings, sweeps, output) : 0;
  if (bad == 0) return;
  output.print_json();
  throw Error(
      ErrorCode::device, "cuda",
      fmt::format("differs from the CPU at {} steps of robust or double: please report this bug", bad));
}

void add_options(const CommandLine& command, Settings& settings) {
  command.add_option("--sweep", settings.sweeps, "sweeps to run; default: all")
      .type_name("LIST")
      .comma_separated();
  add_count(command, "--count", settings.run.rays, "rays per step, approximately", 30);
  add_seed(command, settings.run.seed, "seed of scenes and rays");
  add_names(command, "--precision", settings.precisions,
            {"auto", "fast", "robust", "double", "first-cell-hit", "embree", "embree-robust"},
            "show only these: fast, robust, double, of pictures auto, first-cell-hit (robust, with "
            "gridrender's --first-cell-hit), and of triangles embree and embree-robust, where this program "
            "was built with Embree");
  add_backend(command, settings.backend);
  command.add_flag("--pictures", settings.pictures,
                   "sweeps of pictures instead, on the CPU: the share of pixels that are off by more than "
                   "1/50 from double on float64 coordinates");
}

} // namespace

void add_stability(const CommandLine& command) {
  add_command(command, "stability",
              "Where each precision fails: missed, false and wrong hits, compared with an oracle, as one "
              "parameter varies",
              "--sweep moved,tip --count 100000", add_options, bench_stability);
}

} // namespace masu
