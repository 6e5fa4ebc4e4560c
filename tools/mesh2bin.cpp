// mesh2bin: converts meshes of any format that Assimp reads to a scene file.
#include "libscene/available_memory.h"
#include "libscene/file/output_file.h"
#include "libscene/mesh/import.h"
#include "tools/printable.h"
#include "tools/progress.h"
#include "tools/scene_report.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <cstring>

namespace masu {
namespace {

struct Settings {
  std::string input, objects, size;
  ImportOptions import;
  SceneOutput output;
  bool quiet = false;
  Threads threads;
};

// Assimp expands what a file shares: few bytes can be any number of nodes. Its allocations beyond the memory
// that is available shall fail, instead of the machine.
void limit_memory() {
  const double available = available_memory();
  if (!std::isfinite(available)) return;
  rlimit limit{};
  if (getrlimit(RLIMIT_DATA, &limit) != 0) return;
  limit.rlim_cur = std::min(limit.rlim_max, static_cast<rlim_t>(available));
  static_cast<void>(setrlimit(RLIMIT_DATA, &limit));
}

// --- Faults of Assimp ------------------------------------------------------------------------------------

// Some damaged files make Assimp's readers fault (nodes nested 100,000 deep overflow its stack, for example).
// Nothing has been written then, and the user gets a line and an exit code as for any other invalid input.
// Static storage for the signal handler, which has a stack of its own.
constinit std::array<char, 1024> fault_line{};
constinit std::array<char, 16384> fault_stack{};
constexpr std::array fault_signals{SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};

// Calls only async-signal-safe functions.
void report_fault(int) {
  static_cast<void>(!write(STDERR_FILENO, fault_line.data(), std::strlen(fault_line.data())));
  _exit(static_cast<int>(ErrorCode::input));
}

// Calls read(), and reports its faults.
template <class Read>
auto guarded(const std::string& name, const Read& read) {
  const auto line = fmt::format_to_n(
      fault_line.data(), fault_line.size() - 2,
      "mesh2bin: {}: Assimp crashed on it: convert it to another format, such as PLY or glTF",
      printable(name));
  *line.out = '\n';
  stack_t stack{};
  stack.ss_sp = fault_stack.data();
  stack.ss_size = fault_stack.size();
  sigaltstack(&stack, nullptr);
  struct sigaction action {};
  action.sa_handler = report_fault;
  action.sa_flags = SA_ONSTACK;
  for (const int signal : fault_signals)
    sigaction(signal, &action, nullptr);
  auto result = read();
  for (const int signal : fault_signals)
    std::signal(signal, SIG_DFL);
  return result;
}

// --- The tool --------------------------------------------------------------------------------------------

void print_notes(const ImportNotes& notes, const std::string& place) {
  const auto line = [&](std::uint64_t number, const char* what) {
    if (number > 0) fmt::print(stderr, "mesh2bin: {}: warning: {} {}\n", printable(place), number, what);
  };
  line(notes.points_and_lines, "point(s) and line(s) left out");
  line(notes.invalid_faces, "face(s) left out: a coordinate isn't finite or is beyond 1e100");
  line(notes.textured_materials, "material(s) have textures, which are ignored: only base colours are used");
  line(notes.omitted_cameras, "camera(s) left out: only the first is used, if it is a perspective camera");
  line(notes.omitted_lights, "light(s) left out: not point, spot, area or directional lights");
}

// One a line, line N + 1 for object N.
void write_names(const std::vector<std::string>& names, const std::string& path) {
  std::string text;
  for (const std::string& name : names)
    text += printable(name) + '\n';
  if (path == "-") return fmt::print("{}", text);
  OutputFile file(path);
  file.write(text.data(), text.size());
  file.commit();
}

void run(const Settings& settings) {
  if (settings.objects.empty()) settings.output.check();
  const auto limit = settings.threads.limit();
  check_files({settings.input}, {settings.output.path, settings.objects});
  limit_memory();
  const ImportedScene imported = guarded(settings.input, [&] {
    Progress progress("reading", settings.quiet);
    ImportOptions options = settings.import;
    options.progress = progress.callback();
    return read_mesh(settings.input, options);
  });
  print_notes(imported.notes, settings.input);
  write_and_report("mesh2bin", settings.input, imported.scene, settings.output);
  if (!settings.objects.empty()) write_names(imported.object_names, settings.objects);
}

} // namespace
} // namespace masu

int main(int argc, char** argv) {
  using namespace masu;
  return run_tool(
      "mesh2bin", "Converts a mesh (OBJ, PLY, STL, glTF, FBX, Collada, ...) to a scene file.", argc, argv,
      [](CLI::App& app, const auto& parse) {
        Settings settings;
        app.add_option("IN", settings.input, "mesh")->required();
        add_choice(app, "--up", settings.import.up, {{"y", UpAxis::y}, {"z", UpAxis::z}},
                   "the up axis of the automatic camera; nothing is rotated");
        app.add_flag("--smooth", settings.import.smooth,
                     "interpolate normals: the file's, or where it has none, normals averaged over "
                     "the faces round each vertex");
        app.add_option("--size", settings.size, "width and height of the picture in pixels")
            ->type_name("WxH");
        app.add_option(
            "--objects", settings.objects,
            "write the objects' names, one a line in the order of their numbers; - is standard output");
        settings.output.add_to(app);
        app.add_flag("-q,--quiet", settings.quiet, "no progress on standard error");
        settings.threads.add_to(app);
        parse();
        if (!settings.size.empty()) {
          const Camera camera = resized({}, settings.size);
          settings.import.width = camera.width;
          settings.import.height = camera.height;
        }
        run(settings);
      });
}
