// mesh2bin: converts a mesh to a scene file.
#include "libscene/base/available_memory.h"
#include "libscene/base/printable.h"
#include "libscene/file/output_file.h"
#include "libscene/file/temporary_name.h"
#include "libscene/mesh/import/import.h"
#include "tools/common/progress.h"
#include "tools/report/scene_report.h"

#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
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

// --- A child process for what may fault, loop or take all memory, as libraries do with damaged files -----

bool is_ignored(int signal) {
  struct sigaction action {};
  return sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

// How the child ended, as waitpid() has it. `awaited`: signals that are blocked, so that sigwaitinfo() gets
// them.
int status_of(pid_t child, const sigset_t& awaited) {
  for (;;) {
    const int signal = sigwaitinfo(&awaited, nullptr);
    int status = 0;
    if (signal == SIGCHLD && waitpid(child, &status, WNOHANG) == child) return status;
    if (signal > 0 && signal != SIGCHLD) kill(child, signal);
  }
}

// Lines for standard error, held back in memory; -1 where a person reads along, there is no memory, or a
// limit of files, which it counts as, leaves no room for them.
int open_lines() {
  constexpr rlim_t enough = 1 << 20;
  rlimit limit{};
  const bool has_room = getrlimit(RLIMIT_FSIZE, &limit) != 0 || limit.rlim_cur >= enough;
  return isatty(STDERR_FILENO) != 0 || !has_room ? -1 : memfd_create("lines", MFD_CLOEXEC);
}
void print_lines(int lines) {
  std::array<char, 4096> part{};
  const off_t size = lseek(lines, 0, SEEK_END);
  for (off_t at = 0; at < size;) {
    const ssize_t got =
        pread(lines, part.data(), std::min(part.size(), static_cast<std::size_t>(size - at)), at);
    if (got <= 0 || write(STDERR_FILENO, part.data(), static_cast<std::size_t>(got)) != got) return;
    at += got;
  }
}

// Goes on in a child process, and returns 0 there. The parent waits for the child, and passes on to it the
// signals that end programs. Where a fault or a limit ended the child, the parent gets that signal; otherwise
// it ends as the child did. A parent that is killed takes the child with it.
//
// What the child prints on standard error, if that isn't a terminal, is printed when it has ended, and not at
// all where a fault or a limit ended it: libraries say more than a line about their faults.
//
// To be called before there are threads, and with nothing left in the buffers of standard output. Throws
// Error(input, process, …) where there can't be another process.
int continue_in_child() {
  const int lines = open_lines();
  sigset_t awaited, before;
  sigemptyset(&awaited);
  sigaddset(&awaited, SIGCHLD);
  for (const int signal : ending_signals)
    if (!is_ignored(signal)) sigaddset(&awaited, signal);
  std::signal(SIGCHLD, SIG_DFL); // ignored, it would leave no status
  pthread_sigmask(SIG_BLOCK, &awaited, &before);
  const pid_t parent = getpid(), child = fork();
  if (child <= 0) {
    const int reason = errno;
    if (child == 0) {
      if (lines >= 0) dup2(lines, STDERR_FILENO);
      prctl(PR_SET_PDEATHSIG, SIGTERM);
      if (getppid() != parent) std::raise(SIGTERM); // killed before that
    }
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
    if (child == 0) return 0;
    throw Error(ErrorCode::input, "process",
                std::string("can't be started: ") + std::strerror(reason) + ": end others, or free memory");
  }
  const int status = status_of(child, awaited);
  if (WIFEXITED(status)) {
    print_lines(lines);
    _exit(WEXITSTATUS(status));
  }
  const int signal = WTERMSIG(status);
  const bool was_passed_on = std::ranges::count(ending_signals, signal) > 0;
  if (was_passed_on) std::signal(signal, SIG_DFL);
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  if (was_passed_on) std::raise(signal);
  return signal;
}

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
    options.progress = std::ref(progress);
    options.opened = [&](const std::string& file) { limits.opened(file); };
    options.parsed = [&] { limits.lift(); };
    return read_mesh(settings.input, options);
  }();
  check_files(limits.files(), {settings.output.path, settings.objects});
  print_warnings("mesh2bin", settings.input, imported.notes);
  write_and_report("mesh2bin", settings.input, imported.scene, settings.output);
  if (settings.objects.empty()) return;
  std::string names; // line N + 1 for object N
  for (const std::string& name : imported.object_names)
    names += printable(name) + '\n';
  write_text_file(settings.objects, names);
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
  command.add_option("--size", settings.size, "width and height of the picture in pixels", "WxH");
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
