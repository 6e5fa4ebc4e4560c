// gridbench's subcommands, and what they have in common.
#pragma once

#include "tools/common/backend.h"
#include "tools/common/json.h"
#include "tools/common/print.h"

#include <algorithm>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace masu {

// Each adds itself with its options to the command line, and a callback that runs it.
void add_frame(const CommandLine& command);
void add_rays(const CommandLine& command);
void add_tradeoff(const CommandLine& command);
void add_stability(const CommandLine& command);
void add_oracle(const CommandLine& command);
void add_crossings(const CommandLine& command);
void add_difference(const CommandLine& command);

// What a subcommand has to say: a table, line by line as it is measured, or JSON, when all is.
struct Output {
  bool as_json = false;
  Json json = Json::array(); // rows
  std::string device{};      // that was measured
  std::string why_no_gpu{};  // backend.h

  // Whether CUDA is what is measured, as use_cuda() says.
  bool on_cuda(Backend backend) {
    const bool cuda = use_cuda(backend);
    why_no_gpu = masu::why_no_gpu(backend);
    device = device_name(cuda);
    return cuda;
  }
  // Of the table.
  template <class... Values>
  void print(fmt::format_string<Values...> format, Values&&... values) const {
    if (as_json) return;
    fmt::print(format, std::forward<Values>(values)...);
    flush_standard_output();
  }
  void print_json() const {
    if (!as_json) return;
    Json rows = json, origin = provenance();
    origin["device"] = device;
    for (auto& row : rows)
      row.update(origin);
    fmt::print("{}\n", json_text(rows));
    flush_standard_output(); // what can't be written is the one line of error, before any note
  }
};

// Adds a subcommand: add_options(command, settings), --json and --threads. Where it is given, run(settings,
// output) runs with so many threads.
template <class Settings>
void add_command(const CommandLine& gridbench, const char* name, const char* description, const char* example,
                 void (*add_options)(const CommandLine&, Settings&), void (*run)(const Settings&, Output&)) {
  struct Given {
    Settings settings;
    Output output;
    Threads threads;
  };
  const auto given = std::make_shared<Given>(); // owned by the callback
  const CommandLine command = gridbench.add_subcommand(name, description);
  command.footer(fmt::format("Example:\n  gridbench {} {}", name, example));
  add_options(command, given->settings);
  command.add_flag("--json", given->output.as_json, "print JSON");
  given->threads.add_to(command);
  command.calls([given, run] {
    const auto limit = given->threads.limit();
    run(given->settings, given->output);
    given->output.print_json();
    if (const std::string& why = given->output.why_no_gpu; !why.empty()) print_note("gridbench: {}\n", why);
  });
}

inline void add_scene(const CommandLine& command, std::string& scene) {
  command.add_option("SCENE", scene, "scene file, from nff2bin or mesh2bin").required();
}
inline void add_grid(const CommandLine& command, std::string& grid) {
  command.add_option("GRID", grid, "grid file, from gridbuild").required();
}
inline void add_grids(const CommandLine& command, std::vector<std::string>& grids) {
  command.add_option("GRID", grids, "grid files, from gridbuild").required();
}
inline void add_seed(const CommandLine& command, std::uint64_t& seed, const char* what = "seed of the rays") {
  command.add_option("--seed", seed, what).shows_default();
}
template <class Number>
void add_count(const CommandLine& command, const char* option, Number& count, const char* what,
               int log2_most) {
  command.add_number(option, count, Number{1}, Number{1} << log2_most, what);
}
inline void add_repeat(const CommandLine& command, int& repeat) {
  command.add_number("--repeat", repeat, 1, 1000, "timed runs, of which the median counts");
}
inline void add_warm_up(const CommandLine& command, int& warm_up) {
  command.add_number("--warm-up", warm_up, 0, 1000, "untimed runs before the timed ones");
}
inline void add_picture_size(const CommandLine& command, std::string& size, const char* what) {
  command.add_option("--size", size, what).type_name("WxH").shows_default();
}
inline void add_general(const CommandLine& command, TracingRules& rules) {
  command.add_flag("--general", rules.general,
                   "use the kernel for all kinds of primitives, not the one for those in the scene");
}
inline bool contains(const std::vector<std::string>& names, std::string_view name) {
  return std::ranges::find(names, name) != names.end();
}
// A list of some of these names.
inline Option add_names(const CommandLine& command, const char* option, std::vector<std::string>& names,
                        const std::set<std::string>& among, const char* what) {
  return command.add_option(option, names, what).type_name("LIST").comma_separated().among(among);
}

} // namespace masu
