// Seconds of loading a scene and its grid, compared with plain copies of the files' bytes to the same memory.
#include "tools/bench/bench.h"
#include "tools/bench/command.h"
#include "tools/bench/load/plain_copy.h"
#include "tools/common/repeated.h"

#include <vector>

namespace masu {
namespace {

using Json = nlohmann::ordered_json;

struct Settings {
  std::string scene, grid;
  Backend backend = Backend::automatic;
  int repeat = 9;
};

// Seconds of each step, for each run. A GPU gets the records from the file and validates them: that counts as
// uploading.
struct Runs {
  std::vector<double> map, validate, upload, load; // load: sum of the three
  std::vector<double> copy_mapped, copy_read;
};

// As gridrender loads; returns the files' bytes.
std::uint64_t load(const Settings& settings, bool cuda, Runs& runs) {
  const Residence residence = cuda ? Residence::file : Residence::mapping;
  const SceneFile scene(settings.scene, residence);
  const StructureFile grid(settings.grid, residence);
  runs.map.push_back(scene.load_seconds().map + grid.load_seconds().map);
  runs.validate.push_back(scene.load_seconds().validate + grid.load_seconds().validate);
  const ResidentTracer tracer(scene, &grid, cuda ? Device::cuda : Device::cpu);
  runs.upload.push_back(cuda ? tracer.upload_seconds() : 0); // the CPU traces what is mapped
  runs.load.push_back(runs.map.back() + runs.validate.back() + runs.upload.back());
  return scene.bytes() + grid.bytes();
}

double copy(const Settings& settings, bool cuda, CopyFrom from) {
  double seconds = 0;
  for (const std::string& path : {settings.scene, settings.grid})
    seconds += cuda ? copy_seconds_cuda(path, from) : copy_seconds_cpu(path, from);
  return seconds;
}

Json measure(const Settings& settings, bool cuda) {
  Runs runs;
  load(settings, cuda, runs); // not counted: brings the files into the page cache
  runs = {};
  std::uint64_t bytes = 0;
  for (int i = 0; i < settings.repeat; ++i) {
    bytes = load(settings, cuda, runs);
    runs.copy_mapped.push_back(copy(settings, cuda, CopyFrom::mapping));
    runs.copy_read.push_back(copy(settings, cuda, CopyFrom::reading));
  }
  const double whole = median(runs.load), mapped = median(runs.copy_mapped), read = median(runs.copy_read);
  return {{"scene", settings.scene},
          {"grid", settings.grid},
          {"bytes", bytes},
          {"backend", cuda ? "cuda" : "cpu"},
          {"repeat", settings.repeat},
          {"median_seconds",
           {{"map", median(runs.map)},
            {"validate", median(runs.validate)},
            {"upload", median(runs.upload)},
            {"load", whole},
            {"copy_mapped", mapped},
            {"copy_read", read}}},
          {"load_over_copy", {{"mapped", whole / mapped}, {"read", whole / read}}}};
}

void print_table(const Output& output) {
  const Json& report = output.json;
  const auto bytes = report["bytes"].get<double>();
  output.print("{}, {} bytes, median of {}, page cache warm\n\n{:<28} {:>10} {:>8}\n",
               report["backend"].get<std::string>(), report["bytes"].get<std::uint64_t>(),
               report["repeat"].get<int>(), "", "ms", "GB/s");
  const auto line = [&](const char* what, const char* name, bool sees_every_byte = true) {
    const double seconds = report["median_seconds"][name].get<double>();
    output.print("{:<28} {:>10.3f} {:>8}\n", what, seconds * 1e3,
                 seconds > 0 && sees_every_byte ? fmt::format("{:.2f}", bytes / seconds * 1e-9) : "-");
  };
  line("map", "map", false);
  const bool cuda = report["backend"] == "cuda";
  line(cuda ? "validate the tables" : "validate", "validate", !cuda);
  line(cuda ? "upload and validate" : "upload", "upload");
  line("load: sum of the three", "load");
  line("plain copy of the mapping", "copy_mapped");
  line("plain copy by read(2)", "copy_read");
  output.print("load / plain copy            {:.2f} (mapping), {:.2f} (read)\n",
               report["load_over_copy"]["mapped"].get<double>(),
               report["load_over_copy"]["read"].get<double>());
}

void bench_load(const Settings& settings, Output& output) {
  const bool cuda = output.on_cuda(settings.backend);
  output.json = measure(settings, cuda);
  print_table(output);
}

void add_options(const CommandLine& command, Settings& settings) {
  add_scene(command, settings.scene);
  add_grid(command, settings.grid);
  add_backend(command, settings.backend);
  add_repeat(command, settings.repeat);
}

} // namespace

void add_load(const CommandLine& command) {
  add_command(
      command, "load",
      "Reading, validating and uploading a scene and its grid, compared with plain copies of their bytes",
      "balls.scene balls.grid", add_options, bench_load);
}

} // namespace masu
