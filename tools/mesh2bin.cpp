// mesh2bin: converts a mesh to a scene file.
#include "libscene/base/available_memory.h"
#include "libscene/base/printable.h"
#include "libscene/file/output_file.h"
#include "libscene/mesh/import/import.h"
#include "tools/common/child_process.h"
#include "tools/common/progress.h"
#include "tools/report/scene_report.h"

#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <optional>
#include <set>

namespace masu {
namespace {

struct Settings {
  std::string input, objects, size;
  std::optional<int> time_limit; // seconds of processor time; 0: none
  ImportOptions import;
  SceneOutput output;
  bool quiet = false;
  Threads threads;
};

// --- Limits of Assimp ------------------------------------------------------------------------------------

// What Assimp may take to read files of so many bytes: many times what any format needs, so that only a
// damaged file is ended by it, which makes Assimp loop, or which claims more than it holds.
constexpr double seconds_at_least = 20, seconds_per_byte = 5e-6;
constexpr double memory_at_least = 0x1p30, memory_per_byte = 1000;

// Of this process, while Assimp reads the files of a mesh.
class AssimpLimits {
public:
  explicit AssimpLimits(std::optional<int> seconds) : seconds_(seconds) {
    getrlimit(RLIMIT_CPU, &processor_);
    getrlimit(RLIMIT_FSIZE, &file_size_);
    set(RLIMIT_FSIZE, 0x1p20); // of what is said on standard error: nothing else is written
    set(RLIMIT_CORE, 0);       // a fault leaves no file
  }

  // For each file that is read: the limits grow by its size.
  void opened(const std::string& file) {
    if (!files_.insert(file).second) return;
    std::error_code unknown;
    if (const auto size = std::filesystem::file_size(file, unknown); !unknown)
      bytes_ += static_cast<double>(size);
    set(RLIMIT_DATA, std::min(memory_at_least + memory_per_byte * bytes_, available_));
    const double seconds = seconds_ ? *seconds_ : std::ceil(seconds_at_least + seconds_per_byte * bytes_);
    if (seconds > 0) set(RLIMIT_CPU, std::min(seconds, static_cast<double>(processor_.rlim_cur)));
  }
  // When they are read. What is made of them may take the memory that there is, and any time.
  void lift() {
    set(RLIMIT_DATA, available_);
    setrlimit(RLIMIT_CPU, &processor_);
    setrlimit(RLIMIT_FSIZE, &file_size_);
  }

  // All that were opened.
  std::vector<std::string> files() const { return {files_.begin(), files_.end()}; }

private:
  static void set(decltype(RLIMIT_DATA) resource, double value) {
    rlimit limit{};
    if (getrlimit(resource, &limit) != 0) return;
    limit.rlim_cur = std::isfinite(value) && value < static_cast<double>(limit.rlim_max)
                         ? static_cast<rlim_t>(value)
                         : limit.rlim_max;
    setrlimit(resource, &limit);
  }

  std::optional<int> seconds_;
  double available_ = available_memory(), bytes_ = 0;
  rlimit processor_{}, file_size_{}; // before
  std::set<std::string> files_;
};

// The error that a signal stands for, which ended the process that read the mesh.
Error ended_by(int signal, const Settings& settings) {
  const std::string what =
      signal == SIGXCPU
          ? settings.time_limit
                ? fmt::format("reading it takes longer than --time-limit {}", *settings.time_limit)
                : "reading it takes far longer than a file of its size should"
      : signal == SIGKILL ? "reading it was killed, perhaps since there isn't enough memory"
                          : fmt::format("reading it crashed ({})", strsignal(signal));
  const char* const remedy = signal == SIGXCPU   ? "repair it, or give it more with --time-limit"
                             : signal == SIGKILL ? "split it"
                                                 : "convert it to another format, such as PLY or glTF";
  return {ErrorCode::input, settings.input, what + ": " + remedy};
}

// --- The tool --------------------------------------------------------------------------------------------

// One per line: line N + 1 for object N.
void write_names(const std::vector<std::string>& names, const std::string& path) {
  std::string text;
  for (const std::string& name : names)
    text += printable(name) + '\n';
  write_text_file(path, text);
}

void run(Settings& settings) {
  if (!settings.size.empty()) {
    const Camera camera = resized({}, settings.size);
    settings.import.width = camera.width;
    settings.import.height = camera.height;
  }
  if (settings.objects.empty()) settings.output.check();
  check_files({settings.input}, {settings.output.path, settings.objects});
  if (const int signal = continue_in_child(); signal != 0) throw ended_by(signal, settings);
  const auto limit = settings.threads.limit();
  AssimpLimits limits(settings.time_limit);
  limits.opened(settings.input);
  const ImportedScene imported = [&] {
    Progress progress("reading", settings.quiet);
    ImportOptions options = settings.import;
    options.progress = progress.callback();
    options.opened = [&](const std::string& file) { limits.opened(file); };
    options.parsed = [&] { limits.lift(); };
    return read_mesh(settings.input, options);
  }();
  check_files(limits.files(), {settings.output.path, settings.objects});
  print_warnings("mesh2bin", settings.input, imported.notes);
  write_and_report("mesh2bin", settings.input, imported.scene, settings.output);
  if (!settings.objects.empty()) write_names(imported.object_names, settings.objects);
}

// Initializers of Assimp's libraries allocate memory before main() is called.
[[gnu::section(".preinit_array"), gnu::used]] void (*const before_libraries)() = prepare_process;

void add_options(const CommandLine& command, Settings& settings) {
  command.footer("Example:\n  mesh2bin duck.glb -o duck.scene");
  command.add_option("IN", settings.input, "mesh; the format is that of its name, or else of its content")
      .required();
  command.group("Mesh");
  command.add_choice("--up", settings.import.up, {{"y", UpAxis::y}, {"z", UpAxis::z}},
                     "the up axis of the automatic camera; nothing is rotated");
  command.add_flag("--smooth", settings.import.smooth,
                   "interpolate normals: the file's, or where it has none, normals averaged over the faces "
                   "round each vertex");
  command.add_option("--size", settings.size, "width and height of the picture in pixels").type_name("WxH");
  command.add_file(
      "--objects", settings.objects,
      "write the objects' names, one a line in the order of their numbers; - is standard output");
  command
      .add_option("--time-limit", settings.time_limit,
                  "seconds of processor time that reading the mesh may take; 0: any; by default 20, and 5 "
                  "more for each MB")
      .range(0, 100000000);
  settings.output.add_to(command);
  command.add_quiet(settings.quiet, "no progress on standard error");
  settings.threads.add_to(command);
}

} // namespace
} // namespace masu

int main(int argc, char** argv) {
  using namespace masu;
  return run_tool("mesh2bin", "Converts a mesh (OBJ, PLY, STL, glTF, FBX, Collada, ...) to a scene file.",
                  argc, argv, add_options, run);
}
